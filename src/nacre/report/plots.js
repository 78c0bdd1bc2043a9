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

  // On an axis of several decades only the powers of ten have labels.
  function logarithmicTick(domain) {
    const decades = Math.log10(domain[1] / domain[0]);
    return (value) => {
      const exponent = Math.round(Math.log10(value));
      const digit = Math.round(value / 10 ** exponent * 10) / 10;
      if (digit !== 1) return decades < 1.5 ? plain(value) : "";
      return exponent >= -3 && exponent <= 4 ? plain(value) : "10" + superscript(exponent);
    };
  }

  function scale(axis) {
    return {
      type: axis.log ? "log" : "linear",
      domain: axis.domain,
      nice: axis.round,
      tickFormat: axis.log ? logarithmicTick(axis.domain) : undefined,
      labelArrow: "none",
      label: axis.label,
    };
  }

  function seriesMarks(series, y) {
    const points = series.points;
    const place = {x: "x", y: "y", clip: true};
    const marks = [];
    const bars = points.filter((p) => p.x !== null && "high" in p);
    if (bars.length) {
      marks.push(Plot.ruleX(bars, {
        x: "x", y1: (p) => p.low ?? y.domain[0], y2: "high",
        stroke: series.colour, strokeWidth: 1.2, strokeOpacity: 0.8, clip: true,
      }));
    }
    if (series.line) {
      marks.push(Plot.line(points, {
        ...place, stroke: series.colour, strokeWidth: 2, strokeLinejoin: "round",
        strokeDasharray: series.dashed ? "6 4" : undefined,
      }));
    }
    if (series.dots) {
      const own = points.some((p) => p.colour);
      marks.push(Plot.dot(points, {
        ...place, clip: false, filter: (p) => p.x !== null, r: own ? 6 : 4, symbol: series.symbol,
        fill: own ? (p) => p.colour ?? "#ffffff" : series.colour,
        stroke: own ? "#333333" : "#ffffff", strokeWidth: own ? 1 : 0.8,
      }));
    }
    if (points.some((p) => p.label)) {
      marks.push(Plot.text(points.filter((p) => p.x !== null && p.label), {
        ...place, clip: false, text: "label", dx: 9, dy: -9, textAnchor: "start", fill: "#333333",
        stroke: "#ffffff", strokeWidth: 3, fontSize: 12,
      }));
    }
    return marks;
  }

  // What the pointer shows.
  function tip(data) {
    const all = data.series.flatMap((series) =>
      series.points.filter((p) => p.x !== null).map((p) => ({...p, series: series.name})));
    const line = (axis, value) => `${axis.label}: ${precise(value)}`;
    return Plot.tip(all, Plot.pointer({
      x: "x", y: "y",
      title: (p) => [p.series + (p.label ? `, ${p.label}` : ""), line(data.x, p.x),
                     line(data.y, p.y) + (p.error === undefined ? "" : ` ± ${precise(p.error)}`)].join("\n"),
    }));
  }

  function draw(data, width) {
    const narrow = width < 480;
    const axis = {fontSize: 13, fill: "#1f1f1f", stroke: null};
    const grid = {stroke: "#000000", strokeOpacity: 0.1, strokeWidth: 0.8};
    const zero = {stroke: "#777777", strokeWidth: 1};
    const tickSpacing = {x: narrow ? 60 : 80, y: 50};
    return Plot.plot({
      width,
      height: data.equal ? undefined : Math.round(Math.max(280, width * 0.56)),
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
        Plot.axisX({...axis, tickSpacing: tickSpacing.x, tickSize: 0, labelAnchor: "center", labelOffset: 40}),
        Plot.axisY({...axis, tickSpacing: tickSpacing.y, tickSize: 0, labelAnchor: "top"}),
        ...data.series.flatMap((series) => seriesMarks(series, data.y)),
        tip(data),
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
