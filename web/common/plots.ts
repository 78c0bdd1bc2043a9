/** Curves as SVG, with the colours of the readings on neutral ground. */

import { svg } from "./dom";

export interface Curve {
    readonly x: readonly number[];
    readonly y: readonly number[];
    /** Of the reading. A casing of ink keeps it visible on any ground. */
    readonly colour: string;
    readonly label: string;
    readonly dashed?: boolean;
    /** A dot at each point, of this colour. */
    readonly pointColours?: readonly string[];
}

export interface Axes {
    readonly width: number;
    readonly height: number;
    readonly xLabel: string;
    readonly yLabel: string;
    readonly describedAs: string;
    readonly x?: readonly [number, number];
    readonly y?: readonly [number, number];
    /** One unit is as long on both axes. */
    readonly square?: boolean;
    /** Labels at the end of each curve. */
    readonly named?: boolean;
}

/** Steps of 1, 2 or 5 times a power of ten, about so many. */
export function ticks(from: number, to: number, about: number): number[] {
    const raw = (to - from) / about;
    const power = 10 ** Math.floor(Math.log10(raw));
    const step = ([1, 2, 5, 10].find((m) => m * power >= raw * 0.999) ?? 10) * power;
    const places: number[] = [];
    for (let i = Math.ceil(from / step - 1e-9); i * step <= to + 1e-9 * step; ++i) {
        places.push(Number((i * step).toPrecision(12)));
    }
    return places;
}

function extent(values: readonly number[]): [number, number] {
    let [low, high] = [Infinity, -Infinity];
    for (const value of values) {
        low = Math.min(low, value);
        high = Math.max(high, value);
    }
    return low <= high ? [low, high] : [0, 1];
}

/** Places for labels at their curves' heights, moved apart by at least a gap, within limits. */
export function apart(
    heights: readonly number[],
    gap: number,
    low: number,
    high: number,
): number[] {
    const order = heights.map((height, i) => ({ height, i })).sort((a, b) => a.height - b.height);
    const places = new Array<number>(heights.length).fill(0);
    let last = -Infinity;
    for (const { height, i } of order) {
        last = Math.max(height, last + gap, low);
        places[i] = last;
    }
    let next = high + gap;
    for (const { i } of order.reverse()) {
        next = Math.min(places[i] as number, next - gap);
        places[i] = next;
    }
    return places;
}

export function plot(curves: readonly Curve[], axes: Axes): SVGSVGElement {
    const { width, height } = axes;
    const named = axes.named ?? false;
    const longest = Math.max(...curves.map((curve) => curve.label.length));
    const margin = { left: 46, right: named ? 14 + 6.6 * longest : 12, top: 10, bottom: 38 };
    const inner = { w: width - margin.left - margin.right, h: height - margin.top - margin.bottom };

    let [x0, x1] = axes.x ?? extent(curves.flatMap((curve) => [...curve.x]));
    let [y0, y1] = axes.y ?? extent(curves.flatMap((curve) => [...curve.y]));
    if (x1 <= x0) [x0, x1] = [x0 - 1, x0 + 1];
    if (y1 <= y0) y1 = y0 + 1;
    if (axes.square ?? false) {
        const unit = Math.max((x1 - x0) / inner.w, (y1 - y0) / inner.h) * 1.12;
        const [cx, cy] = [(x0 + x1) / 2, (y0 + y1) / 2];
        [x0, x1] = [cx - (unit * inner.w) / 2, cx + (unit * inner.w) / 2];
        [y0, y1] = [cy - (unit * inner.h) / 2, cy + (unit * inner.h) / 2];
    }
    const px = (x: number) => margin.left + ((x - x0) / (x1 - x0)) * inner.w;
    const py = (y: number) => margin.top + (1 - (y - y0) / (y1 - y0)) * inner.h;
    const at = (value: number) => value.toFixed(1);
    const text = (value: number) => String(value).replace("-", "\u2212");

    const picture = svg("svg", {
        viewBox: `0 0 ${String(width)} ${String(height)}`,
        class: "plot",
        role: "img",
        "aria-label": axes.describedAs,
    });
    const [bottom, right] = [margin.top + inner.h, margin.left + inner.w];
    for (const x of ticks(x0, x1, inner.w / 70)) {
        const line = x === 0 && (axes.square ?? false) ? "axis" : "grid";
        picture.append(
            svg("path", { class: line, d: `M${at(px(x))} ${String(margin.top)}V${at(bottom)}` }),
            svg("text", { x: at(px(x)), y: at(bottom + 15), "text-anchor": "middle" }, text(x)),
        );
    }
    for (const y of ticks(y0, y1, inner.h / 40)) {
        const line = y === 0 ? "axis" : "grid";
        picture.append(
            svg("path", { class: line, d: `M${String(margin.left)} ${at(py(y))}H${at(right)}` }),
            svg("text", { x: margin.left - 6, y: at(py(y) + 3.5), "text-anchor": "end" }, text(y)),
        );
    }
    picture.append(
        svg(
            "text",
            {
                class: "label",
                x: at(margin.left + inner.w / 2),
                y: height - 4,
                "text-anchor": "middle",
            },
            axes.xLabel,
        ),
        svg(
            "text",
            {
                class: "label",
                transform: `translate(11 ${at(margin.top + inner.h / 2)}) rotate(-90)`,
                "text-anchor": "middle",
            },
            axes.yLabel,
        ),
    );

    const ends: { y: number; label: string; x: number }[] = [];
    for (const curve of curves) {
        const points = curve.x.map((x, i) => ({ x: px(x), y: py(curve.y[i] as number) }));
        const path = points
            .map(({ x, y }, i) => `${i === 0 ? "M" : "L"}${at(x)} ${at(y)}`)
            .join("");
        const dots = (curve.pointColours ?? []).map((fill, i) => {
            const { x, y } = points[i] as { x: number; y: number };
            return svg("circle", { cx: at(x), cy: at(y), r: 4.5, style: `fill:${fill}` });
        });
        const group = svg("g", { class: (curve.dashed ?? false) ? "curve dashed" : "curve" });
        group.dataset.label = curve.label;
        group.append(
            svg("title", {}, curve.label),
            svg("path", { class: "casing", d: path }),
            svg("path", { class: "line", d: path, style: `stroke:${curve.colour}` }),
            ...dots,
        );
        picture.append(group);
        const end = points[points.length - 1];
        if (end !== undefined) ends.push({ ...end, label: curve.label });
    }
    if (named) {
        const places = apart(
            ends.map((end) => end.y + 3.5),
            11.5,
            margin.top + 4,
            bottom + 3,
        );
        ends.forEach((end, i) => {
            const y = places[i] as number;
            picture.append(
                svg("path", {
                    class: "leader",
                    d: `M${at(right + 1)} ${at(end.y)}L${at(right + 8)} ${at(y - 3.5)}`,
                }),
                svg("text", { x: right + 10, y: at(y), "text-anchor": "start" }, end.label),
            );
        });
    }
    return picture;
}
