/** What the server says of a recipe's keys and of what ships (docs/studio-api.md), and what a form makes of it. */

import type { Path, Table, Value } from "./tree";
import { genericPath, get, isList, isTable } from "./tree";

export type Rgb = readonly [number, number, number];

export interface KeyInfo {
    readonly key: string;
    readonly kind:
        "number" | "spectrum" | "material" | "text" | "choice" | "flag" | "table" | "list";
    readonly unit: string;
    readonly doc: string;
    readonly required: boolean;
    /** Of numbers and spectra; null is unlimited. */
    readonly min?: number | null;
    readonly max?: number | null;
    readonly min_excluded?: boolean;
    readonly max_excluded?: boolean;
    /** 0 is allowed besides, and means this. */
    readonly zero?: string;
    readonly default?: Value | null;
    /** Of paints that are made: what a new number or spectrum begins with. */
    readonly typical?: number;
    readonly choices?: "materials" | "pigments" | readonly string[];
    /** A spectrum that may be a colour [r, g, b]. */
    readonly rgb?: boolean;
    readonly required_with?: string;
    readonly spread_of?: string;
}

/** Ways to state one thing, of which a table has one: that whose mark it has, else the first. */
export interface Alternatives {
    readonly required: boolean;
    readonly each: readonly { readonly mark: string; readonly keys: readonly string[] }[];
}

export interface TableInfo {
    /** "layer[].flakes[]"; "" is the paint. */
    readonly path: string;
    readonly title: string;
    readonly keys: readonly KeyInfo[];
    readonly alternatives?: readonly Alternatives[];
}

export interface Named {
    readonly name: string;
    readonly summary: string;
    readonly rgb: Rgb | null;
}

export interface GeometrySet {
    readonly name: string;
    readonly summary?: string;
    readonly geometries: readonly string[];
}

type Vector = readonly [number, number, number];

export interface ShapeInfo {
    readonly name: string;
    readonly title: string;
    /** The light that suits it. */
    readonly light: string;
    /** From the mesh to the world. */
    readonly transform: {
        readonly scale: number;
        readonly rotation_deg: Vector;
        readonly translation_mm: Vector;
    };
    readonly camera: {
        readonly position_mm: Vector;
        readonly target_mm: Vector;
        readonly fov_deg: number;
        /** The least width over height that shows the whole shape. */
        readonly aspect: number;
    };
}

export interface LightInfo {
    readonly name: string;
    readonly title: string;
    /** Of all its lamps, to which the eye adapts. */
    readonly illuminant: string;
}

export interface Schema {
    readonly version: string;
    readonly recipe: { readonly tables: readonly TableInfo[] };
    readonly materials: readonly Named[];
    readonly pigments: readonly Named[];
    /** Of the paints that ship, each an entry of a layer's list. */
    readonly flakes: readonly (Pick<Named, "name" | "summary"> & { readonly value: Table })[];
    readonly paints: readonly {
        readonly name: string;
        readonly title: string;
        readonly toml: string;
    }[];
    readonly geometry_sets: readonly GeometrySet[];
    readonly illuminants: readonly string[];
    readonly observers: readonly string[];
    /** By which paints can be read, and the one to begin with. */
    readonly reading_models: readonly { readonly name: string; readonly title: string }[];
    readonly reading_model: string;
    readonly shapes: readonly ShapeInfo[];
    readonly lights: readonly LightInfo[];
    /** By which the path tracer's picture shows the mean of the flakes. */
    readonly mean_model: string;
    /** The paint that the command line named. */
    readonly start: string | null;
}

/** A model by which paints are read, as people call it. */
export function modelTitle(schema: Schema, name: string): string {
    return schema.reading_models.find((model) => model.name === name)?.title ?? name;
}

export function tableInfo(schema: Schema, path: Path): TableInfo | undefined {
    const generic = genericPath(path);
    return schema.recipe.tables.find((table) => table.path === generic);
}

export function keyInfo(schema: Schema, path: Path): KeyInfo | undefined {
    const key = path[path.length - 1];
    return tableInfo(schema, path.slice(0, -1))?.keys.find((info) => info.key === key);
}

/** Endings of keys that say the unit, and the unit as people write it. */
const UNITS: readonly (readonly [string, string])[] = [
    ["_g_per_cm3", "g/cm³"],
    ["_per_mm", "mm⁻¹"],
    ["_per_um", "µm⁻¹"],
    ["_um", "µm"],
    ["_nm", "nm"],
    ["_mm", "mm"],
    ["_deg", "°"],
];

/** Where a key does not say it in words. */
const WORDS: Readonly<Record<string, string>> = {
    ior: "Binder",
    alpha: "Tilt, alpha",
    alpha_bottom: "Tilt at bottom",
    diameter_spread_um: "± diameter",
    spread_nm: "± thickness",
    wa: "Waves a",
    wb: "Waves b",
    wc: "Waves c",
    wd: "Waves d",
    we: "Waves e",
};

/** "thickness_um" for people: "Thickness", in µm. */
export function labelOf(key: string): { label: string; unit: string } {
    const unit = UNITS.find(([ending]) => key.endsWith(ending));
    const stem = unit === undefined ? key : key.slice(0, -unit[0].length);
    const words = WORDS[key] ?? stem.replace(/_/g, " ");
    return { label: words.charAt(0).toUpperCase() + words.slice(1), unit: unit?.[1] ?? "" };
}

/** Which alternative a table states; 0, the first, where it has no mark. */
export function chosen(table: Table, alternatives: Alternatives): number {
    const found = alternatives.each.findIndex(({ mark }) => mark !== "" && mark in table);
    return Math.max(found, 0);
}

function keysOf(group: Alternatives): string[] {
    return group.each.flatMap(({ keys }) => keys);
}

/** Without those that belong to an alternative of another that the table does not state. */
export function statedGroups(table: Table, info: TableInfo): readonly Alternatives[] {
    const groups = info.alternatives ?? [];
    return groups.filter((group) =>
        groups.every((other) => {
            if (other === group) return true;
            const own = other.each[chosen(table, other)]?.keys ?? [];
            const foreign = keysOf(other).filter((key) => !own.includes(key));
            return !keysOf(group).every((key) => foreign.includes(key));
        }),
    );
}

/** The alternative that the table does not state and that a key marks, or must stand in. */
export function brought(
    table: Table,
    info: TableInfo,
    key: KeyInfo,
): { readonly group: Alternatives; readonly to: number } | undefined {
    for (const group of statedGroups(table, info)) {
        const now = chosen(table, group);
        if (group.each[now]?.keys.includes(key.key) === true) continue;
        const to = group.each.findIndex(
            ({ mark, keys }) => mark === key.key || (key.required && keys.includes(key.key)),
        );
        if (to >= 0) return { group, to };
    }
    return undefined;
}

/** The group in which the key marks what the table states, and without which the first holds. */
export function dropped(table: Table, info: TableInfo, key: string): Alternatives | undefined {
    return statedGroups(table, info).find(
        (group) =>
            !group.required &&
            group.each[0]?.mark === "" &&
            group.each[chosen(table, group)]?.mark === key,
    );
}

/** Keys that belong to alternatives that the table does not state. */
export function foreignKeys(table: Table, info: TableInfo): Set<string> {
    const foreign = new Set<string>();
    const own = new Set<string>();
    for (const group of statedGroups(table, info)) {
        const i = chosen(table, group);
        group.each.forEach(({ keys }, k) => {
            for (const key of keys) (k === i ? own : foreign).add(key);
        });
    }
    for (const key of own) foreign.delete(key);
    return foreign;
}

/** Whether a key goes with an alternative that the table does not state and that it does not bring. */
export function isStranded(table: Table, info: TableInfo, key: KeyInfo): boolean {
    if (brought(table, info, key) !== undefined) return false;
    return statedGroups(table, info).some((group) => {
        const now = group.each[chosen(table, group)]?.keys ?? [];
        return !now.includes(key.key) && keysOf(group).includes(key.key);
    });
}

/** What is said of a number's key where one points at it. @param before  what comes first; empty: nothing */
export function tipOf(info: KeyInfo, before: string): string {
    return [before, info.doc, rangeText(info)].filter((part) => part !== "").join("; ");
}

/** "(0, 1e6] µm", as docs/recipe.md writes ranges. */
export function rangeText(info: KeyInfo): string {
    const { min, max } = info;
    if (min === undefined && max === undefined) return "";
    const low = info.min_excluded === true || min === null ? "(" : "[";
    const high = info.max_excluded === true || max === null ? ")" : "]";
    const from = min === null || min === undefined ? "−∞" : plain(min);
    const to = max === null || max === undefined ? "∞" : plain(max);
    const unit = labelOf(info.key).unit;
    const zero = info.zero === undefined ? "" : "0 or ";
    return `${zero}${low}${from}, ${to}${high}${unit === "" ? "" : ` ${unit}`}`;
}

export function plain(value: number): string {
    return String(Number(value.toPrecision(6))).replace("-", "−");
}

export function allows(info: KeyInfo, value: number): boolean {
    if (!Number.isFinite(value)) return false;
    if (info.zero !== undefined && value === 0) return true;
    const { min, max } = info;
    if (min !== null && min !== undefined && (info.min_excluded ? value <= min : value < min)) {
        return false;
    }
    return !(max !== null && max !== undefined && (info.max_excluded ? value >= max : value > max));
}

/** Numbers that can be moved: sliders of the form, and what a fit may vary. */
export interface Parameter {
    readonly path: Path;
    readonly info: KeyInfo;
    readonly value: number;
}

export function parameters(schema: Schema, recipe: Table): Parameter[] {
    const found: Parameter[] = [];
    const visit = (path: Path) => {
        const table = get(recipe, path);
        const info = tableInfo(schema, path);
        if (!isTable(table) || info === undefined) return;
        for (const key of info.keys) {
            const value = table[key.key];
            const inner = [...path, key.key];
            if (typeof value === "number" && (key.kind === "number" || key.kind === "spectrum")) {
                found.push({ path: inner, info: key, value });
            } else if (key.kind === "table") visit(inner);
            else if (key.kind === "list" && isList(value)) {
                value.forEach((_, i) => {
                    visit([...inner, i]);
                });
            }
        }
    };
    visit([]);
    return found;
}

/** Names of where a number is: "Layer 1, Iron oxide on mica, coat 2". */
export function placeText(recipe: Table, path: Path): string {
    const parts: string[] = [];
    path.slice(0, -1).forEach((step, i) => {
        if (typeof step === "number") {
            const at = get(recipe, path.slice(0, i + 1));
            const name = isTable(at) ? (at.name ?? at.from ?? at.material) : undefined;
            const kind = singular(String(path[i - 1]));
            const number = `${kind} ${String(step + 1)}`;
            parts.push(typeof name === "string" && name !== "" ? name : number);
        } else if (typeof path[i + 1] !== "number") parts.push(step.replace(/_/g, " "));
    });
    const text = parts.join(", ");
    return text.charAt(0).toUpperCase() + text.slice(1);
}

/** An entry of the list "coats" is a coat. */
export function singular(list: string): string {
    return list === "flakes" ? list : list.replace(/s$/, "");
}
