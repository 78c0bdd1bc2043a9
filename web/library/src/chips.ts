/** Pictures and chips of records, on a grey that is the same in both themes. */

import type { Lab } from "../../common/colour";
import { chip } from "../../common/colour";
import type { Paint } from "./data";
import { folder } from "./data";
import { angleName, h, number } from "../../common/dom";
import { labAt } from "./query";
import { byLamp, mainAngles, ramp } from "../../common/geometry";

export function lampName(lamp: number): string {
    return `Lamp at ${String(lamp)}°`;
}

const PICTURES: Record<string, string> = {
    "ball.png": "Ball",
    "panel.png": "Panel",
    "macro.png": "Macro",
};

/** Rendered pictures where there are any, else a ramp of the readings; each says which it is. */
export function pictures(paint: Paint, names: readonly string[]): HTMLElement {
    const figures = paint.thumbnails.map((file) => {
        const label = PICTURES[file] ?? file;
        const image = h("img", {
            src: `${folder(paint.id)}/${file}`,
            alt: `${label} of ${paint.name}, rendered`,
        });
        return h("figure", {}, image, h("figcaption", {}, `${label}, rendered`));
    });
    if (figures.length === 0) {
        const angles = mainAngles(names);
        const [first, last] = [angles[0], angles[angles.length - 1]];
        const style = `background:${ramp(angles, (i) => labAt(paint, i))}`;
        const range =
            first === undefined || last === undefined
                ? "no angle in the lamp's plane was read"
                : `aspecular angles ${number(first.aspecular, 0)}° (left) to ${number(last.aspecular, 0)}° (right)`;
        figures.push(
            h(
                "figure",
                { class: "wide" },
                h("div", {
                    class: "ramp",
                    role: "img",
                    "aria-label": `Ramp of readings, ${range}`,
                    style,
                }),
                h("figcaption", {}, `No picture was rendered. Ramp of the readings: ${range}`),
            ),
        );
    }
    return h("div", { class: "pictures" }, ...figures);
}

export interface Group {
    readonly title: string;
    /** In the list of geometries. */
    readonly places: readonly number[];
    /** Aspecular angles where the title names the lamp, else whole names. */
    readonly labels: readonly string[];
}

/** Angles by lamp, and those out of the plane together at the end. */
export function groups(names: readonly string[]): Group[] {
    const result = [...byLamp(names)].map(([lamp, angles]) => ({
        title: lampName(lamp),
        places: angles.map((angle) => angle.index),
        labels: angles.map((angle) => `${number(angle.aspecular, 1).replace(/\.0$/, "")}°`),
    }));
    const seen = new Set(result.flatMap((group) => group.places));
    const others = names.map((_, i) => i).filter((i) => !seen.has(i));
    if (others.length > 0) {
        const labels = others.map((i) => angleName(names[i] as string));
        result.push({ title: "Other directions", places: others, labels });
    }
    return result;
}

/** What a display cannot show of a colour. */
export function caveat(lab: Lab): string {
    const { tooBright, outOfGamut } = chip(lab);
    if (tooBright) return "brighter than white, dimmed";
    return outOfGamut ? "outside sRGB, clipped" : "";
}

export function labLine(lab: Lab): string {
    return lab.map((x) => number(x, 0)).join(" ");
}

function cell(label: string, lines: readonly string[], faces: readonly Lab[]): HTMLElement {
    const marked = faces.some((lab) => caveat(lab) !== "");
    const why = [...new Set(faces.map(caveat))].filter(Boolean).join("; ");
    return h(
        "div",
        { class: label.length > 8 ? "chip wide" : "chip" },
        h(
            "div",
            { class: "faces" },
            ...faces.map((lab) => h("i", { style: `background:${chip(lab).css}` })),
        ),
        h("b", {}, label, marked ? h("abbr", { title: why, "aria-label": why }, "*") : null),
        ...lines.map((line) => h("span", {}, line)),
    );
}

/** Chips of one record, or pairs of two that touch, with a line under each. */
export function chips(
    names: readonly string[],
    faces: (place: number) => readonly Lab[],
    lines: (place: number) => readonly string[],
): HTMLElement {
    const all = names.map((_, i) => faces(i)).flat();
    const notes = [...new Set(all.map(caveat))].filter(Boolean);
    return h(
        "div",
        { class: groups(names).length > 1 ? "chip-groups several" : "chip-groups" },
        ...groups(names).map((group) =>
            h(
                "section",
                {},
                h("h3", {}, group.title),
                h(
                    "div",
                    { class: "chip-row" },
                    ...group.places.map((i, k) =>
                        cell(group.labels[k] as string, lines(i), faces(i)),
                    ),
                ),
            ),
        ),
        notes.length === 0 ? null : h("p", { class: "note" }, `* ${notes.join("; ")}`),
    );
}
