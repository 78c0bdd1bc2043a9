// Draws every plot of the page with Observable Plot. The data come from plot_data.cpp:
//
//   x, y    {label, log, domain: [from, to], round: may the ends move to round numbers?}
//   equal   is a unit as long in x as in y?
//   series  [{name, colour, symbol, line, dots, dashed, points}], a point being
//           {x, y, low, high, error, colour, label, side}; x and y are null where there is nothing
//           to show, low is missing where a bar leaves a logarithmic axis; the label stands to
//           side x 45 deg, clockwise from the right (plot_frame.h)
//   style   colours and lengths, those of plot_svg.h
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

  function axisOptions(axis, tickSpacing, style) {
    return {
      label: axis.label, labelArrow: "none", fill: style.text, fontSize: style.tickFont, tickSize: 0, tickSpacing,
      tickFormat: (axis.log ? logarithmicTick : linearTick)(axis.domain),
    };
  }

  // The labels of a series' points: a mark of Plot has one direction, so there is one for each side.
  function labelMarks(series, isInside, style) {
    const labelled = series.points.filter((p) => p.label && isInside(p));
    return Array.from(d3.group(labelled, (p) => p.side), ([side, points]) => {
      const [right, down] = [Math.cos(side * Math.PI / 4), Math.sin(side * Math.PI / 4)];
      const side3 = (value, names) => names[Math.abs(value) < 0.1 ? 1 : value < 0 ? 0 : 2];
      return Plot.text(points, {
        x: "x", y: "y", text: "label", dx: style.labelDistance * right, dy: style.labelDistance * down,
        textAnchor: side3(right, ["end", "middle", "start"]),
        lineAnchor: side3(down, ["bottom", "middle", "top"]),
        fill: style.pointLabel, stroke: style.paper, strokeWidth: 3, fontSize: style.labelFont,
      });
    });
  }

  function lineMarks(series, y, style) {
    const points = series.points;
    const marks = [];
    const bars = points.filter((p) => hasPlace(p) && "high" in p);
    if (bars.length) {
      marks.push(Plot.ruleX(bars, {
        x: "x", y1: (p) => p.low ?? y.domain[0], y2: "high",
        stroke: series.colour, strokeWidth: style.barWidth, strokeOpacity: style.barOpacity, clip: true,
      }));
    }
    if (series.line) {
      marks.push(Plot.line(points, {
        x: "x", y: "y", clip: true, stroke: series.colour, strokeWidth: style.lineWidth, strokeLinejoin: "round",
        strokeDasharray: series.dashed ? style.dashes : undefined,
      }));
    }
    return marks;
  }

  function dotMarks(series, isInside, style) {
    if (!series.dots) return [];
    const points = series.points.filter(isInside);
    const own = points.some((p) => p.colour);
    return [Plot.dot(points, {
      x: "x", y: "y", r: own ? style.ownDotRadius : style.dotRadius, symbol: series.symbol,
      fill: own ? (p) => p.colour ?? style.paper : series.colour,
      stroke: own ? style.ownDotEdge : style.paper, strokeWidth: own ? 1 : 0.8,
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
    const style = data.style;
    const narrow = width < 480;
    const grid = {stroke: style.grid, strokeOpacity: style.gridOpacity, strokeWidth: 0.8};
    const zero = {stroke: style.zero, strokeWidth: 1};
    const [wideX, wideY, wideEqual] = style.tickSpacing;
    const tickSpacing = data.equal || narrow ? {x: wideEqual, y: data.equal ? wideEqual : wideY} : {x: wideX, y: wideY};
    const height = data.equal
      ? width * (data.y.domain[1] - data.y.domain[0]) / (data.x.domain[1] - data.x.domain[0])
      : Math.round(Math.max(280, width * 0.56));
    const isInside = (p) => hasPlace(p) && onAxis(data.x, p.x) && onAxis(data.y, p.y);
    const empty = !data.series.some((series) => series.points.some(hasPlace));
    return Plot.plot({
      width,
      height: data.equal ? undefined : height,  // else it follows from aspectRatio
      aspectRatio: data.equal ? 1 : undefined,
      marginTop: style.margins[0], marginRight: style.margins[1],
      marginBottom: style.margins[2], marginLeft: style.margins[3],
      style: {fontFamily: "inherit", fontSize: `${style.tickFont}px`, color: style.text, background: style.paper},
      x: scale(data.x),
      y: scale(data.y),
      color: {type: "identity"},
      marks: [
        Plot.gridX({...grid, tickSpacing: tickSpacing.x}),
        Plot.gridY({...grid, tickSpacing: tickSpacing.y}),
        data.equal ? [Plot.ruleX([0], zero), Plot.ruleY([0], zero)] : Plot.frame({stroke: style.frame}),
        Plot.axisX({...axisOptions(data.x, tickSpacing.x, style), labelAnchor: "center", labelOffset: 40}),
        Plot.axisY({...axisOptions(data.y, tickSpacing.y, style), labelAnchor: "top"}),
        ...data.series.flatMap((series) => lineMarks(series, data.y, style)),
        ...data.series.flatMap((series) => labelMarks(series, isInside, style)),
        ...data.series.flatMap((series) => dotMarks(series, isInside, style)),
        empty ? Plot.text(["No point can be shown"], {frameAnchor: "middle", fontSize: 14, fill: style.faintText})
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
