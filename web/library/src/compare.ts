/** Two records side by side: B as a sample against A as the standard. */

import type { Lab } from "../../common/colour";
import { chroma, deltaE2000, deltaHue } from "../../common/colour";
import { chips, pictures } from "./chips";
import type { Details, Library, Paint } from "./data";
import { angleName, h, number } from "../../common/dom";
import { plot } from "../../common/plots";
import { lightName, ordered, spectrum } from "./record";

export interface Side {
    readonly paint: Paint;
    readonly details: Details;
}

interface Pair {
    readonly name: string;
    readonly i: number;
    readonly a: Lab;
    readonly b: Lab;
    readonly dE: number;
}

/** By geometry, in the library's order. */
function pairs(names: readonly string[], A: Details, B: Details): Pair[] {
    return names.map((name, i): Pair => {
        const [a, b] = [A.Lab[i] as Lab, B.Lab[i] as Lab];
        return { name, i, a, b, dE: deltaE2000(a, b) };
    });
}

function table(angles: readonly Pair[], most: number): HTMLElement {
    const head = ["Geometry", "L* A", "a* A", "b* A", "L* B", "a* B", "b* B"];
    const differences = ["ΔL*", "Δa*", "Δb*", "ΔC*", "ΔH*", "ΔE2000"];
    const rows = angles.map(({ name, a, b, dE }) => {
        const change = [b[0] - a[0], b[1] - a[1], b[2] - a[2]];
        const all = [...a, ...b, ...change, chroma(b) - chroma(a), deltaHue(a, b)];
        const bar = h("i", {
            class: "bar",
            style: `width:${((60 * dE) / (most || 1)).toFixed(1)}px`,
        });
        return h(
            "tr",
            {},
            h("th", { scope: "row" }, angleName(name)),
            ...all.map((x, i) =>
                h("td", { class: i === 3 || i === 6 ? "group" : null }, number(x, 2)),
            ),
            h("td", { class: "strong" }, number(dE, 2)),
            h("td", { class: "bars", "aria-hidden": true }, bar),
        );
    });
    const column = (name: string, i: number) =>
        h("th", { scope: "col", class: i === 4 || i === 7 ? "group" : null }, name);
    return h(
        "div",
        { class: "scroll", tabindex: 0, role: "region", "aria-label": "Differences by angle" },
        h(
            "table",
            { class: "figures differences" },
            h("thead", {}, h("tr", {}, ...[...head, ...differences].map(column), h("td"))),
            h("tbody", {}, ...rows),
        ),
    );
}

function curves(library: Library, A: Details, B: Details): HTMLElement {
    const figures = ordered(library.geometries).map((i) => {
        const name = library.geometries[i] as string;
        const both = [
            spectrum(library, A, i, { label: "A" }),
            spectrum(library, B, i, { label: "B", dashed: true }),
        ];
        const most = Math.max(...both.flatMap((curve) => [...curve.y]));
        return h(
            "figure",
            {},
            h("figcaption", {}, angleName(name)),
            plot(both, {
                width: 300,
                height: 210,
                xLabel: "nm",
                yLabel: "R",
                y: [0, 1.04 * most],
                describedAs: `Reflectance factor at ${angleName(name)}: A full, B dashed`,
            }),
        );
    });
    return h("div", { class: "small-plots" }, ...figures);
}

function parameters(A: Details, B: Details): HTMLElement {
    const keys = [...new Set([...Object.keys(A.parameters), ...Object.keys(B.parameters)])].sort();
    const unlike = keys.filter((key) => A.parameters[key] !== B.parameters[key]);
    const text = (value: number | undefined) =>
        value === undefined ? "–" : String(Number(value.toPrecision(6))).replace("-", "\u2212");
    if (unlike.length === 0) return h("p", {}, "All numbers of the two recipes are the same.");
    return h(
        "div",
        { class: "scroll", tabindex: 0, role: "region", "aria-label": "Numbers that differ" },
        h(
            "table",
            { class: "figures parameters" },
            h(
                "thead",
                {},
                h("tr", {}, ...["Key", "A", "B"].map((name) => h("th", { scope: "col" }, name))),
            ),
            h(
                "tbody",
                {},
                ...unlike.map((key) =>
                    h(
                        "tr",
                        {},
                        h("th", { scope: "row" }, h("code", {}, key)),
                        h("td", {}, text(A.parameters[key])),
                        h("td", {}, text(B.parameters[key])),
                    ),
                ),
            ),
        ),
    );
}

function figure(name: string, a: number | null, b: number | null, decimals: number): HTMLElement {
    const difference = a === null || b === null ? null : b - a;
    return h(
        "div",
        {},
        h("dt", {}, name),
        h("dd", {}, `${number(a, decimals)} / ${number(b, decimals)}`),
        h("dd", { class: "note" }, `Δ ${number(difference, decimals)}`),
    );
}

export function comparePage(library: Library, A: Side, B: Side): HTMLElement {
    const names = library.geometries;
    const angles = pairs(names, A.details, B.details);
    const dE = angles.map((angle) => angle.dE);
    const most = Math.max(...dE);
    const mean = dE.reduce((sum, x) => sum + x, 0) / dE.length;
    const worst = names[dE.indexOf(most)] ?? "";
    const title = ({ paint }: Side, letter: string, role: string) =>
        h(
            "div",
            {},
            h("span", { class: "letter" }, letter),
            h("a", { href: `#/record/${paint.id}` }, paint.name),
            h("span", { class: "note" }, role),
        );
    const angle = (place: number) => angles[place] as Pair;
    return h(
        "article",
        { class: "record compare" },
        h(
            "header",
            {},
            h(
                "div",
                {},
                h("h1", { tabindex: -1 }, "Comparison"),
                h(
                    "p",
                    {},
                    "Differences are B less A; Delta E 2000 with all parametric factors 1. ",
                    lightName(library),
                ),
            ),
            h(
                "a",
                { class: "button", href: `#/compare/${B.paint.id}/${A.paint.id}` },
                "Swap A and B",
            ),
        ),
        h("div", { class: "sides" }, title(A, "A", "standard"), title(B, "B", "sample")),
        h(
            "section",
            { class: "stage", "aria-label": "Pictures and chips" },
            h("div", { class: "sides" }, pictures(A.paint, names), pictures(B.paint, names)),
            h("p", { class: "note" }, "Chips: A above, B below; under each Delta E 2000."),
            chips(
                names,
                (place) => [angle(place).a, angle(place).b],
                (place) => [`ΔE ${number(angle(place).dE, 2)}`],
            ),
        ),
        h(
            "dl",
            { class: "key-figures" },
            h("div", {}, h("dt", {}, "Mean ΔE2000"), h("dd", {}, number(mean, 2))),
            h(
                "div",
                {},
                h("dt", {}, "Largest ΔE2000"),
                h("dd", {}, number(most, 2)),
                h("dd", { class: "note" }, `at ${angleName(worst)}`),
            ),
            figure("Flop index A / B", A.details.flop_index, B.details.flop_index, 2),
            figure("Colour travel A / B", A.details.colour_travel, B.details.colour_travel, 1),
        ),
        h(
            "section",
            {},
            h("h2", {}, "By angle"),
            table(
                ordered(names).map((i) => angle(i)),
                most,
            ),
        ),
        library.wavelengths_nm.length > 0
            ? h(
                  "section",
                  {},
                  h("h2", {}, "Spectra"),
                  h("p", { class: "note" }, "A full, B dashed, each in the colour of its reading."),
                  curves(library, A.details, B.details),
              )
            : null,
        h(
            "section",
            {},
            h("h2", {}, "Numbers of the recipes that differ"),
            parameters(A.details, B.details),
        ),
    );
}
