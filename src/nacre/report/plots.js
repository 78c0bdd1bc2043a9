// Draws every plot of the page with Observable Plot. The data come from plot_data.cpp:
//
//   x, y    {label, log, domain: [from, to], round: may the ends move to round numbers?}
//   equal   is a unit as long in x as in y?
//   series  [{name, colour, symbol, line, dots, dashed, points}], a point being
//           {x, y, low, high, error, colour, label}; x and y are null where there is nothing to
//           show, low is missing where a bar leaves a logarithmic axis
"use strict";
(() => {
  const superscript = (n) => String(n).replace(/[-0-9]/g, (c) => "⁻⁰¹²³⁴⁵⁶⁷⁸⁹"["-0123456789".indexOf(c)]);
  const plain = d3.format(",~g");
  const precise = d3.format(".4~g");

  // As in 2·10⁻⁶.
  function scientific(value) {
    if (value === 0) return "0";
    const [digits, exponent] = d3.format(".3~e")(value).split("e");
    const mantissa = digits === "1" ? "" : digits === "−1" ? "−" : digits + "·";
    return mantissa + "10" + superscript(Number(exponent));
  }

  // Ticks of a linear axis: undefined leaves them to Plot.
  function linearTick(domain) {
    const largest = Math.max(Math.abs(domain[0]), Math.abs(domain[1]));
    return largest >= 1e6 || largest < 2e-3 ? scientific : undefined;
  }

  // The more decades a logarithmic axis spans, the fewer of its ticks have labels; d3 leaves out
  // more of them where they would be too close.
  function logarithmicTick(domain) {
    const decades = Math.log10(domain[1] / domain[0]);
    const labelled = decades <= 3 ? [1, 2, 5] : [1];
    return (value) => {
      const exponent = Math.floor(Math.log10(value) + 1e-9);
      const digit = Math.round(value / 10 ** exponent * 10) / 10;
      if (decades > 1 && !labelled.includes(digit)) return "";
      return exponent >= -3 && exponent <= 4 ? plain(value) : scientific(value);
    };
  }

  function scale(axis) {
    return {
      type: axis.log ? "log" : "linear",
      domain: axis.domain,
      nice: axis.round,
    };
  }

  const hasPlace = (p) => p.x !== null;
  const onAxis = (axis, value) => axis.round || (value >= axis.domain[0] && value <= axis.domain[1]);

  function axisOptions(axis, tickSpacing) {
    return {
      label: axis.label, labelArrow: "none", fill: "#1f1f1f", fontSize: 13, tickSize: 0, tickSpacing,
      tickFormat: (axis.log ? logarithmicTick : linearTick)(axis.domain),
    };
  }

  // The labels of a series' points stand on the outer side of its curve, in one of eight directions
  // (a mark of Plot has one direction). toPixels turns a point into about where it is drawn.
  function labelMarks(series, isInside, toPixels) {
    const points = series.points.filter(hasPlace);
    if (!points.some((p) => p.label)) return [];
    const pixels = points.map(toPixels);
    const at = (i) => pixels[Math.min(Math.max(i, 0), pixels.length - 1)];
    const normals = pixels.map((_, i) => {
      const [x, y] = [at(i + 1)[0] - at(i - 1)[0], at(i + 1)[1] - at(i - 1)[1]];
      const length = Math.hypot(x, y);
      return length > 0 ? [y / length, -x / length] : [0.7, -0.7];
    });
    const bend = d3.sum(pixels.slice(1, -1), ([x, y], i) =>  // pixels[i + 1] is the point
      (pixels[i][0] + pixels[i + 2][0] - 2 * x) * normals[i + 1][0] +
      (pixels[i][1] + pixels[i + 2][1] - 2 * y) * normals[i + 1][1]);
    const upwards = d3.sum(normals, ([x, y]) => x - y);
    const side = Math.abs(bend) > 1 ? -Math.sign(bend) : upwards < 0 ? -1 : 1;
    const octant = (i) => (Math.round(Math.atan2(side * normals[i][1], side * normals[i][0]) / (Math.PI / 4)) + 8) % 8;
    return Array.from(d3.group(points.keys(), octant), ([direction, indices]) => {
      const [right, down] = [Math.cos(direction * Math.PI / 4), Math.sin(direction * Math.PI / 4)];
      const side3 = (value, names) => names[Math.abs(value) < 0.1 ? 1 : value < 0 ? 0 : 2];
      return Plot.text(indices.map((i) => points[i]).filter((p) => p.label && isInside(p)), {
        x: "x", y: "y", text: "label", dx: 10 * right, dy: 10 * down,
        textAnchor: side3(right, ["end", "middle", "start"]),
        lineAnchor: side3(down, ["bottom", "middle", "top"]),
        fill: "#333333", stroke: "#ffffff", strokeWidth: 3, fontSize: 12,
      });
    });
  }

  function lineMarks(series, y) {
    const points = series.points;
    const marks = [];
    const bars = points.filter((p) => hasPlace(p) && "high" in p);
    if (bars.length) {
      marks.push(Plot.ruleX(bars, {
        x: "x", y1: (p) => p.low ?? y.domain[0], y2: "high",
        stroke: series.colour, strokeWidth: 1.2, strokeOpacity: 0.8, clip: true,
      }));
    }
    if (series.line) {
      marks.push(Plot.line(points, {
        x: "x", y: "y", clip: true, stroke: series.colour, strokeWidth: 2, strokeLinejoin: "round",
        strokeDasharray: series.dashed ? "6 4" : undefined,
      }));
    }
    return marks;
  }

  function dotMarks(series, isInside) {
    if (!series.dots) return [];
    const points = series.points.filter(isInside);
    const own = points.some((p) => p.colour);
    return [Plot.dot(points, {
      x: "x", y: "y", r: own ? 7 : 4, symbol: series.symbol,
      fill: own ? (p) => p.colour ?? "#ffffff" : series.colour,
      stroke: own ? "#333333" : "#ffffff", strokeWidth: own ? 1 : 0.8,
    })];
  }

  // What the pointer shows.
  function tip(data, isInside) {
    const all = data.series.flatMap((series) =>
      series.points.filter(isInside).map((p) => ({...p, series: series.name})));
    const line = (axis, value) => `${axis.label}: ${precise(value)}`;
    return Plot.tip(all, Plot.pointer({
      x: "x", y: "y",
      title: (p) => [[p.series, p.label].filter(Boolean).join(", "), line(data.x, p.x),
                     line(data.y, p.y) + (p.error === undefined ? "" : ` ± ${precise(p.error)}`)].filter(Boolean).join("\n"),
    }));
  }

  function draw(data, width) {
    const narrow = width < 480;
    const grid = {stroke: "#000000", strokeOpacity: 0.1, strokeWidth: 0.8};
    const zero = {stroke: "#777777", strokeWidth: 1};
    const tickSpacing = data.equal ? {x: 60, y: 60} : {x: narrow ? 60 : 80, y: 50};
    const height = data.equal
      ? width * (data.y.domain[1] - data.y.domain[0]) / (data.x.domain[1] - data.x.domain[0])
      : Math.round(Math.max(280, width * 0.56));
    const onScreen = (axis, length) => (axis.log ? d3.scaleLog() : d3.scaleLinear()).domain(axis.domain).range(length);
    const [screenX, screenY] = [onScreen(data.x, [0, width]), onScreen(data.y, [height, 0])];
    const toPixels = (p) => [screenX(p.x), screenY(p.y)];
    const isInside = (p) => hasPlace(p) && onAxis(data.x, p.x) && onAxis(data.y, p.y);
    const empty = !data.series.some((series) => series.points.some(hasPlace));
    return Plot.plot({
      width,
      height: data.equal ? undefined : height,  // else it follows from aspectRatio
      aspectRatio: data.equal ? 1 : undefined,
      marginTop: 32, marginRight: 28, marginBottom: 48, marginLeft: 62,
      style: {fontFamily: "inherit", fontSize: "13px", color: "#1f1f1f", background: "#ffffff"},
      x: scale(data.x),
      y: scale(data.y),
      color: {type: "identity"},
      marks: [
        Plot.gridX({...grid, tickSpacing: tickSpacing.x}),
        Plot.gridY({...grid, tickSpacing: tickSpacing.y}),
        data.equal ? [Plot.ruleX([0], zero), Plot.ruleY([0], zero)] : Plot.frame({stroke: "#bbbbbb"}),
        Plot.axisX({...axisOptions(data.x, tickSpacing.x), labelAnchor: "center", labelOffset: 40}),
        Plot.axisY({...axisOptions(data.y, tickSpacing.y), labelAnchor: "top"}),
        ...data.series.flatMap((series) => lineMarks(series, data.y)),
        ...data.series.flatMap((series) => labelMarks(series, isInside, toPixels)),
        ...data.series.flatMap((series) => dotMarks(series, isInside)),
        empty ? Plot.text(["No point can be shown"], {frameAnchor: "middle", fontSize: 14, fill: "#5c5c5c"})
              : tip(data, isInside),
      ],
    });
  }

  for (const figure of document.querySelectorAll("figure.plot")) {
    const canvas = figure.querySelector(".canvas");
    const data = JSON.parse(figure.querySelector('script[type="application/json"]').textContent);
    let drawn = 0;
    const fit = () => {
      const width = Math.round(canvas.clientWidth);
      if (width === 0 || width === drawn) return;  // hidden, or nothing has changed
      drawn = width;
      canvas.replaceChildren(draw(data, width));
    };
    fit();
    new ResizeObserver(fit).observe(canvas);
  }
})();
