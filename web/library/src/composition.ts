/** A recipe for reading: the coats from the top down, each with what is in it. */

import type { Table, Value } from "./data";
import { h, number } from "../../common/dom";

/** Units by which names of keys end, as recipes write them; longer ones first. */
const UNITS: readonly (readonly [string, string])[] = [
    ["_per_mm", "mm⁻¹"],
    ["_per_um", "µm⁻¹"],
    ["_um", "µm"],
    ["_nm", "nm"],
    ["_mm", "mm"],
    ["_deg", "°"],
];

interface Key {
    readonly label: string;
    readonly unit: string;
}

function named(key: string): Key {
    const unit = UNITS.find(([ending]) => key.endsWith(ending));
    const stem = unit === undefined ? key : key.slice(0, -unit[0].length);
    return { label: stem.replace(/_/g, " "), unit: unit === undefined ? "" : unit[1] };
}

function isTable(value: Value | undefined): value is Table {
    return typeof value === "object" && !Array.isArray(value);
}

function isTables(value: Value): value is readonly Table[] {
    return (
        Array.isArray(value) && value.length > 0 && value.every((item) => isTable(item as Value))
    );
}

/** Up to six significant digits, as people write them. */
function digits(value: number): string {
    return String(Number(value.toPrecision(6))).replace("-", "\u2212");
}

const SHOWN = 6;

function plain(value: Value): string {
    if (typeof value === "number") return digits(value);
    if (typeof value === "boolean") return value ? "yes" : "no";
    if (typeof value === "string") return value;
    if (isTable(value)) {
        const pairs = rows(value).map(([key, text]) => {
            if (key === "material" || key === "distribution") return text;
            return key === "thickness" ? text : `${key} ${text}`;
        });
        return pairs.join(", ");
    }
    const list = value;
    if (list.length > SHOWN && list.every((item) => typeof item === "number")) {
        const [first, last] = [list[0] as number, list[list.length - 1] as number];
        return `${String(list.length)} values from ${digits(first)} to ${digits(last)}`;
    }
    return list.map(plain).join("; ");
}

/** Keys and values as text; a spread stands behind the number that it is the spread of. */
function rows(table: Table): [string, string][] {
    const result: [string, string][] = [];
    for (const [key, value] of Object.entries(table)) {
        const { label, unit } = named(key);
        const stem = label.replace(/ ?spread$/, "");
        // The spread of "thickness_nm" is "spread_nm", that of "diameter_um" "diameter_spread_um".
        const owner = stem === "" ? "thickness" : stem;
        const ending = key.slice(key.lastIndexOf("_"));
        if (stem !== label && typeof table[owner.replace(/ /g, "_") + ending] === "number")
            continue;
        const spread =
            table[key.replace(ending, `_spread${ending}`)] ??
            (label === "thickness" ? table[`spread${ending}`] : undefined);
        let text = plain(value);
        if (typeof spread === "number" && typeof value === "number") text += ` ± ${digits(spread)}`;
        result.push([label, unit === "" || typeof value !== "number" ? text : `${text} ${unit}`]);
    }
    return result;
}

function list(table: Table, without: readonly string[]): HTMLElement {
    const own = Object.fromEntries(Object.entries(table).filter(([key]) => !without.includes(key)));
    const parts = rows(own).flatMap(([key, text]) => [h("dt", {}, key), h("dd", {}, text)]);
    return h("dl", {}, ...parts);
}

/** One film on another, the outermost first, as a flake is met from above. */
function films(flake: Table): HTMLElement | null {
    const core = flake.core;
    if (!isTable(core)) return null;
    const coats = flake.coats;
    const above = Array.isArray(coats) ? [...(coats as readonly Table[])].reverse() : [];
    return h(
        "ol",
        { class: "films", "aria-label": "Films from the outside inwards" },
        ...above.map((coat) => h("li", {}, plain(coat))),
        h("li", { class: "core" }, plain(core), h("span", {}, " core")),
    );
}

/** A species of flake, a pigment or another table inside a layer. */
function content(kind: string, table: Table): HTMLElement {
    const name = table.name ?? table.from;
    const title = typeof name === "string" && name !== "" ? name : kind;
    const share = table.volume_fraction;
    const head = h("h4", {}, title);
    if (title !== kind) head.append(h("span", {}, kind));
    if (typeof share === "number") head.append(h("b", {}, `${number(100 * share, 2)} vol %`));
    const film = films(table);
    const shown = film === null ? ["name"] : ["name", "core", "coats"];
    return h("section", { class: "content" }, head, film, list(table, shown));
}

function coat(title: string, table: Table): HTMLElement {
    const parts: HTMLElement[] = [];
    const shown: string[] = ["name", "thickness_um"];
    for (const [key, value] of Object.entries(table)) {
        if (!isTables(value)) continue;
        shown.push(key);
        const kind = key === "flakes" ? "flakes" : key.replace(/_/g, " ");
        parts.push(...value.map((item) => content(kind, item)));
    }
    const thickness = table.thickness_um;
    const name = table.name;
    const head = h("h3", {}, typeof name === "string" && name !== "" ? `${title}: ${name}` : title);
    if (typeof thickness === "number") head.append(h("b", {}, `${digits(thickness)} µm`));
    const element = h("li", { class: "coat" }, head, list(table, shown), ...parts);
    // Thick coats are drawn thicker, but not so thick that nothing else is seen.
    const size = typeof thickness === "number" ? Math.max(0, Math.log2(1 + thickness)) : 0;
    element.style.setProperty("--thick", `${(4 + 2.5 * size).toFixed(1)}px`);
    return element;
}

/** Tables that are no part of the paint. */
const ASIDE = ["fit", "uncertainty"];

export function composition(recipe: Table): HTMLElement {
    const coats: HTMLElement[] = [];
    const shown: string[] = ["name", ...ASIDE];
    const table = (key: string): Table | null => {
        const value = recipe[key];
        if (!isTable(value)) return null;
        shown.push(key);
        return value;
    };
    const clearcoat = table("clearcoat");
    if (clearcoat !== null) coats.push(coat("Clearcoat", clearcoat));
    const layers = recipe.layer;
    if (layers !== undefined && isTables(layers)) {
        shown.push("layer");
        layers.forEach((layer, i) => {
            coats.push(coat(layers.length === 1 ? "Layer" : `Layer ${String(i + 1)}`, layer));
        });
    }
    const microfacet = table("microfacet");
    if (microfacet !== null) coats.push(coat("Microfacets", microfacet));
    const substrate = table("substrate");
    if (substrate !== null) coats.push(coat("Substrate", substrate));
    return h(
        "div",
        { class: "composition" },
        list(recipe, shown),
        h("ol", { class: "coats" }, ...coats),
    );
}
