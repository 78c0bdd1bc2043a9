/** What a new layer, flake, pigment or film begins with: numbers of paints that are made. */

import type { Alternatives, KeyInfo, Schema, TableInfo } from "./schema";
import { chosen, foreignKeys, statedGroups, tableInfo } from "./schema";
import type { Path, Table, Value } from "./tree";
import { isTable } from "./tree";

/** Entries with more than what they must have, by generic path. */
const EXAMPLES: Readonly<Record<string, Value>> = {
    lean: { tilt_deg: 5, azimuth_deg: 0 },
    "layer[].flakes[]": {
        name: "TiO2 on mica",
        volume_fraction: 0.03,
        diameter_um: 18,
        orientation: { distribution: "beckmann", alpha: 0.1 },
        core: { material: "mica", thickness_nm: 500, spread_nm: 60 },
        coats: [{ material: "TiO2_anatase", thickness_nm: 110, spread_nm: 5 }],
    },
    "layer[].flakes[].coats[]": { material: "SiO2", thickness_nm: 100, spread_nm: 5 },
    "layer[].flakes[].core": { material: "mica", thickness_nm: 500, spread_nm: 60 },
    "layer[].flakes[].orientation.tilts": [
        { tilt_deg: 0, density: 1 },
        { tilt_deg: 15, density: 0 },
    ],
    "clearcoat.orange_peel": { wc: 0.005, wd: 0.005 },
};

/** A value for a key that a table lacks, which the other keys of the table allow. */
export function fittingStarter(schema: Schema, table: Path, info: KeyInfo, now: Table): Value {
    const value = starter(schema, table, info);
    const mean = info.spread_of === undefined ? undefined : now[info.spread_of];
    if (typeof value !== "number" || typeof mean !== "number") return value;
    return Math.min(value, Number((mean / 4).toPrecision(2)));
}

/** The same of a table that has no keys yet. */
function starter(schema: Schema, table: Path, info: KeyInfo): Value {
    const generic = [...table, info.key]
        .map((step) => (typeof step === "number" ? "[]" : `.${step}`))
        .join("")
        .slice(1);
    const example = EXAMPLES[generic];
    if (example !== undefined) return example;
    const entry = info.kind === "list" ? EXAMPLES[`${generic}[]`] : undefined;
    if (entry !== undefined) return [entry];
    if (generic === "layer[].pigment") return [newPigment(schema)];
    switch (info.kind) {
        case "number":
        case "spectrum":
            return info.typical ?? info.default ?? info.min ?? 0;
        case "material":
            return schema.materials[0]?.name ?? 1.5;
        case "text":
            return info.choices === "pigments" ? (schema.pigments[0]?.name ?? "") : "";
        case "choice":
            return (
                (Array.isArray(info.choices) ? (info.choices[0] as string | undefined) : "") ?? ""
            );
        case "flag":
            return true;
        case "list":
            return [required(schema, [...table, info.key, 0])];
        case "table":
            return required(schema, [...table, info.key]);
    }
}

/** @param last  the entry before it */
export function newEntry(schema: Schema, list: Path, last?: Value): Value {
    // Densities over tilts that rise.
    if (list.at(-1) === TILTS && isTable(last) && typeof last.tilt_deg === "number") {
        return { tilt_deg: Math.min(last.tilt_deg + 5, 90), density: 0 };
    }
    const info = tableInfo(schema, list.slice(0, -1))?.keys.find((k) => k.key === list.at(-1));
    if (info === undefined) return {};
    const made = starter(schema, list.slice(0, -1), info);
    return (Array.isArray(made) ? (made[0] as Value | undefined) : made) ?? {};
}

function newPigment(schema: Schema): Value {
    const first = schema.pigments[0];
    if (first === undefined) return { scattering_per_mm: 10, absorption_per_mm: 10 };
    return { from: first.name, volume_fraction: 0.05 };
}

/** A table with the keys that it must have. */
function required(schema: Schema, path: Path): Table {
    const info = tableInfo(schema, path);
    if (info === undefined) return {};
    const keys = new Set(
        (info.alternatives ?? []).flatMap(({ each }) => each.flatMap((a) => a.keys)),
    );
    const table: Record<string, Value> = {};
    for (const key of info.keys) {
        if (key.required && !keys.has(key.key)) table[key.key] = starter(schema, path, key);
    }
    for (const group of info.alternatives ?? []) {
        if (statedGroups(table, info).includes(group))
            addMarked(schema, path, info, group.each[0], table);
    }
    return table;
}

/** The key of an orientation that tables its tilts, which its distribution says too. */
export const TILTS = "tilts";
export const TABULATED = "tabulated";

/** The distribution that goes with the tilts of an orientation, or with its alpha. */
function distributed(table: Table): Table {
    if (!("distribution" in table)) return table;
    const tabulated = table.distribution === TABULATED;
    if (TILTS in table === tabulated) return table;
    return { ...table, distribution: tabulated ? "beckmann" : TABULATED };
}

/** The table with another word chosen, and what goes with it. */
export function withChoice(schema: Schema, path: Path, table: Table, key: string, word: string) {
    const group = tableInfo(schema, path)?.alternatives?.find(({ each }) =>
        each.some(({ mark }) => mark === TILTS),
    );
    if (group === undefined || key !== "distribution") return { ...table, [key]: word };
    const to = group.each.findIndex(({ mark }) => (mark === TILTS) === (word === TABULATED));
    return { ...switched(schema, path, table, group, to), [key]: word };
}

function addMarked(
    schema: Schema,
    path: Path,
    info: TableInfo,
    one: Alternatives["each"][number] | undefined,
    table: Record<string, Value>,
): void {
    // Ways to say one thing within this alternative: one of them is enough.
    const within = (info.alternatives ?? []).filter(
        ({ required, each }) =>
            required &&
            each.every(({ mark, keys }) => mark !== one?.mark && isWithin(keys, one?.keys ?? [])),
    );
    const apart = new Set(within.flatMap(({ each }) => each.flatMap(({ keys }) => keys)));
    for (const key of info.keys) {
        const needed = key.required
            ? !apart.has(key.key)
            : key.required_with !== undefined && key.required_with in table;
        const wanted = key.key === one?.mark || (needed && one?.keys.includes(key.key) === true);
        if (wanted && table[key.key] === undefined) table[key.key] = starter(schema, path, key);
    }
    for (const { each } of within) {
        if (!each.some(({ mark }) => mark in table)) addMarked(schema, path, info, each[0], table);
    }
}

function isWithin(some: readonly string[], all: readonly string[]): boolean {
    return some.every((key) => all.includes(key));
}

/** The table stating another of the alternatives, with what that one needs. */
export function switched(
    schema: Schema,
    path: Path,
    table: Table,
    group: Alternatives,
    to: number,
): Table {
    const info = tableInfo(schema, path);
    const one = group.each[to];
    if (info === undefined || one === undefined || chosen(table, group) === to) return table;
    const leaving = new Set(group.each.flatMap(({ keys }) => keys));
    for (const key of one.keys) leaving.delete(key);
    const kept = Object.entries(table).filter(([key]) => !leaving.has(key));
    const result: Record<string, Value> = Object.fromEntries(kept);
    addMarked(schema, path, info, one, result);
    // What another alternative needs beside what this one brought.
    const foreign = foreignKeys(result, info);
    for (const key of info.keys) {
        const needed = key.required_with !== undefined && key.required_with in result;
        if (!needed || key.key in result || foreign.has(key.key)) continue;
        result[key.key] = starter(schema, path, key);
    }
    return distributed(result);
}
