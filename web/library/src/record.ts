/** The page of one record. */

import type { Lab } from "../../common/colour";
import { chip, chroma, hue } from "../../common/colour";
import { chips, groups, labLine, lampName, pictures } from "./chips";
import { composition } from "./composition";
import type { Details, Library, Paint } from "./data";
import { folder } from "./data";
import { angleName, h, number } from "../../common/dom";
import { byLamp } from "../../common/geometry";
import type { Curve } from "../../common/plots";
import { plot } from "../../common/plots";

/** Angles by lamp, as rows and curves go. */
export function ordered(names: readonly string[]): number[] {
    return groups(names).flatMap((group) => group.places);
}

export function lightName(library: Library): string {
    return `${library.illuminant}, ${library.observer}° observer`;
}

function readings(names: readonly string[], details: Details): HTMLElement {
    const head = ["Geometry", "L*", "a*", "b*", "C*", "h"];
    const body = ordered(names).map((i) => {
        const lab = details.Lab[i] as Lab;
        const swatch = h("i", { class: "dot", style: `background:${chip(lab).css}` });
        return h(
            "tr",
            {},
            h("th", { scope: "row" }, swatch, angleName(names[i] as string)),
            ...[...lab, chroma(lab), hue(lab)].map((x) => h("td", {}, number(x, 2))),
        );
    });
    return h(
        "table",
        { class: "figures" },
        h("thead", {}, h("tr", {}, ...head.map((name) => h("th", { scope: "col" }, name)))),
        h("tbody", {}, ...body),
    );
}

export function spectrum(
    library: Library,
    details: Details,
    i: number,
    more: Partial<Curve> = {},
): Curve {
    return {
        x: library.wavelengths_nm,
        y: details.R[i] ?? [],
        colour: chip(details.Lab[i] as Lab).css,
        label: angleName(library.geometries[i] as string),
        ...more,
    };
}

function spectra(library: Library, details: Details): HTMLElement | null {
    if (library.wavelengths_nm.length === 0) return null;
    const curves = ordered(library.geometries).map((i) => spectrum(library, details, i));
    const most = Math.max(...curves.flatMap((curve) => [...curve.y]));
    const figure = h(
        "figure",
        {},
        plot(curves, {
            width: 620,
            height: 330,
            xLabel: "Wavelength, nm",
            yLabel: "Reflectance factor",
            y: [0, 1.04 * most],
            named: true,
            describedAs: "Reflectance factor over wavelength, a curve an angle",
        }),
    );
    return h("div", {}, h("h2", {}, "Spectra"), figure);
}

/** L* over the aspecular angle, and the way of the colour through a* and b*. */
function flop(names: readonly string[], details: Details): HTMLElement[] {
    const lamps = [...byLamp(names)];
    const curves = (x: (lab: Lab, degrees: number) => number, y: (lab: Lab) => number) =>
        lamps.map(([lamp, angles], i): Curve => {
            const labs = angles.map((angle) => details.Lab[angle.index] as Lab);
            return {
                x: labs.map((lab, i) => x(lab, angles[i]?.aspecular ?? 0)),
                y: labs.map(y),
                colour: "var(--line)",
                label: lampName(lamp),
                dashed: i > 0,
                pointColours: labs.map((lab) => chip(lab).css),
            };
        });
    const lightness = curves(
        (_, degrees) => degrees,
        (lab) => lab[0],
    );
    const degrees = lightness.flatMap((curve) => curve.x);
    const [first, last] = [Math.min(...degrees), Math.max(...degrees)];
    const top = Math.max(100, ...lightness.flatMap((curve) => [...curve.y]));
    return [
        h(
            "figure",
            {},
            plot(lightness, {
                width: 460,
                height: 330,
                xLabel: "Aspecular angle, °",
                yLabel: "L*",
                named: true,
                x: [first - 5, last + 5],
                y: [0, 1.04 * top],
                describedAs: "Lightness over the aspecular angle, a curve a lamp",
            }),
        ),
        h(
            "figure",
            {},
            plot(
                curves(
                    (lab) => lab[1],
                    (lab) => lab[2],
                ),
                {
                    width: 460,
                    height: 330,
                    xLabel: "a*",
                    yLabel: "b*",
                    square: true,
                    describedAs: "The way of the colour through a* and b*, a curve a lamp",
                },
            ),
        ),
    ];
}

function bytes(size: number): string {
    if (size < 1000) return `${String(size)} B`;
    return size < 1e6 ? `${number(size / 1e3, 1)} kB` : `${number(size / 1e6, 1)} MB`;
}

const FILES: readonly (readonly [RegExp, string])[] = [
    [/^recipe\.toml$/, "Recipe"],
    [/^readings.*\.csv$/, "Readings, L*a*b* and spectra"],
    [/^record\.json$/, "Everything about this record"],
    [/\.bsdf$/, "Measured-BRDF file (RGL)"],
    [/^solved\.h5$/, "Solved paint, HDF5"],
    [/\.exr$/, "Picture, linear"],
    [/\.png$/, "Picture"],
];

function downloads(paint: Paint, details: Details): HTMLElement {
    const rank = (name: string) => FILES.findIndex(([pattern]) => pattern.test(name)) >>> 0;
    const files = [...details.files].sort((a, b) => rank(a.name) - rank(b.name));
    return h(
        "ul",
        { class: "downloads" },
        ...files.map(({ name, bytes: size }) =>
            h(
                "li",
                {},
                h("a", { href: `${folder(paint.id)}/${name}`, download: name }, name),
                h("span", {}, FILES.find(([pattern]) => pattern.test(name))?.[1] ?? ""),
                h("span", {}, bytes(size)),
            ),
        ),
    );
}

function keyFigures(details: Details): HTMLElement {
    const figures = [
        h("div", {}, h("dt", {}, "Flop index"), h("dd", {}, number(details.flop_index, 2))),
        h("div", {}, h("dt", {}, "Colour travel"), h("dd", {}, number(details.colour_travel, 1))),
    ];
    for (const lamp of details.sparkle ?? []) {
        const spots = `${number(lamp.spots_per_cm2, 0)} spots per cm², intensity ${number(lamp.intensity, 1)}`;
        figures.push(
            h(
                "div",
                {},
                h("dt", {}, `Sparkle, lamp at ${String(lamp.lamp_deg)}°`),
                h("dd", {}, `${number(lamp.sparkle, 1)} `, error(lamp.sparkle_se)),
                h("dd", { class: "note" }, spots),
            ),
        );
    }
    if (details.graininess !== null) {
        const value = number(details.graininess, 1);
        figures.push(h("div", {}, h("dt", {}, "Graininess"), h("dd", {}, value)));
    }
    return h("dl", { class: "key-figures" }, ...figures);
}

/** The standard deviation of a figure's error. */
function error(value: number | null): HTMLElement | null {
    return value === null ? null : h("small", {}, `± ${number(value, 1)}`);
}

function warnings(details: Details): HTMLElement | null {
    if (details.warnings.length === 0) return null;
    const items = details.warnings.map((text) => h("li", {}, text));
    return h("section", { class: "warnings" }, h("h2", {}, "Warnings"), h("ul", {}, ...items));
}

function swept(details: Details): HTMLElement | null {
    const entries = Object.entries(details.swept);
    if (entries.length === 0) return null;
    return h(
        "div",
        { class: "swept" },
        h("h3", {}, "Swept keys"),
        h(
            "dl",
            {},
            ...entries.flatMap(([key, value]) => [
                h("dt", {}, h("code", {}, key)),
                h(
                    "dd",
                    {},
                    typeof value === "number" ? String(Number(value.toPrecision(8))) : value,
                ),
            ]),
        ),
    );
}

export function recordPage(
    library: Library,
    paint: Paint,
    details: Details,
    pick: HTMLElement,
): HTMLElement {
    const labs = details.Lab;
    const names = library.geometries;
    const about = [
        library.constructions[paint.construction],
        library.sweeps.length > 1 ? `sweep ${library.sweeps[paint.sweep] ?? ""}` : null,
    ].filter(Boolean);
    return h(
        "article",
        { class: "record" },
        h(
            "header",
            {},
            h("div", {}, h("h1", { tabindex: -1 }, paint.name), h("p", {}, about.join(" · "))),
            pick,
        ),
        h(
            "section",
            { class: "stage", "aria-label": "Pictures and chips" },
            pictures(paint, names),
            chips(
                names,
                (i) => [labs[i] as Lab],
                (i) => [labLine(labs[i] as Lab)],
            ),
        ),
        keyFigures(details),
        warnings(details),
        h(
            "section",
            { class: "two" },
            h(
                "div",
                {},
                h("h2", {}, "Readings"),
                readings(names, details),
                h("p", { class: "note" }, lightName(library)),
            ),
            spectra(library, details),
        ),
        h(
            "section",
            {},
            h("h2", {}, "Flop"),
            h("div", { class: "plots" }, ...flop(names, details)),
        ),
        h(
            "section",
            { class: "two" },
            h("div", {}, h("h2", {}, "Composition"), composition(details.recipe)),
            h(
                "div",
                {},
                h("h2", {}, "Files"),
                downloads(paint, details),
                swept(details),
                h(
                    "details",
                    {},
                    h("summary", {}, "recipe.toml as it is written"),
                    h("pre", { tabindex: 0 }, details.recipe_text),
                ),
                h(
                    "dl",
                    { class: "origin" },
                    h("dt", {}, "Record"),
                    h("dd", {}, h("code", {}, paint.id)),
                    h("dt", {}, "Computed by"),
                    h("dd", {}, `Nacre ${details.version}`),
                    ...(details.seconds === null
                        ? []
                        : [
                              h("dt", {}, "Time taken"),
                              h("dd", {}, `${number(details.seconds, 2)} s`),
                          ]),
                ),
            ),
        ),
    );
}
