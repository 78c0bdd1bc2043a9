/** Which records the gallery shows and in which order; also as text, for the address of the page. */

import type { Lab } from "../../common/colour";
import { chroma, deltaE2000, hue } from "../../common/colour";
import type { Library, Paint } from "./data";

/** Figures of a record that can be limited and sorted by. */
export const MEASURES = {
    L: "Lightness L*",
    C: "Chroma C*",
    h: "Hue h",
    flop: "Flop index",
    travel: "Colour travel",
    sparkle: "Sparkle",
    graininess: "Graininess",
} as const;
export type Measure = keyof typeof MEASURES;
export const measures = Object.keys(MEASURES) as Measure[];

/** Inclusive; null is open. Of the hue, a first limit above the second goes round through 0. */
export interface Limits {
    readonly from: number | null;
    readonly to: number | null;
}

/** Lists of which some are chosen. */
export const CHOICES = { with: "Flakes and pigments", of: "Construction", sweep: "Sweep" } as const;
export type Choice = keyof typeof CHOICES;
export const choices = Object.keys(CHOICES) as Choice[];

export type SortKey = "name" | "nearness" | Measure;

export interface Query {
    text: string;
    /** The geometry of lightness, chroma, hue and nearness. */
    at: string;
    limits: Partial<Record<Measure, Limits>>;
    /** Of materials a record must have all, of the others one. */
    chosen: Record<Choice, readonly string[]>;
    target: Lab | null;
    sort: SortKey;
    descending: boolean;
}

export function emptyQuery(at: string): Query {
    return {
        text: "",
        at,
        limits: {},
        chosen: { with: [], of: [], sweep: [] },
        target: null,
        sort: "name",
        descending: false,
    };
}

/** `at` is the place of a geometry in the library's list. */
export function measureOf(paint: Paint, measure: Measure, at: number): number | null {
    if (measure === "L" || measure === "C" || measure === "h") {
        const lab = labAt(paint, at);
        return measure === "L" ? lab[0] : measure === "C" ? chroma(lab) : hue(lab);
    }
    return paint[measure];
}

export function labAt(paint: Paint, at: number): Lab {
    const lab = paint.lab[at];
    if (lab === undefined) throw new Error(`${paint.id}: has no reading number ${String(at)}`);
    return lab;
}

export function within(measure: Measure, value: number | null, limits: Limits): boolean {
    if (value === null) return false;
    const { from, to } = limits;
    if (measure === "h" && from !== null && to !== null && from > to) {
        return value >= from || value <= to;
    }
    return (from === null || value >= from) && (to === null || value <= to);
}

/** What of a record a choice is among, as places in the library's lists. */
function members(paint: Paint, choice: Choice): readonly number[] {
    if (choice === "with") return paint.pigments;
    return [choice === "of" ? paint.construction : paint.sweep];
}

export function listOf(library: Library, choice: Choice): readonly string[] {
    if (choice === "with") return library.pigments;
    return choice === "of" ? library.constructions : library.sweeps;
}

export interface Found {
    readonly paints: Paint[];
    /** Delta E 2000 from the target by a record's index. */
    readonly distance: Float64Array | null;
    /** How many of those found have each entry of the library's lists. */
    readonly counts: Record<Choice, number[]>;
}

export function find(library: Library, paints: readonly Paint[], query: Query): Found {
    const at = library.geometries.indexOf(query.at);
    const words = query.text.toLowerCase().split(/\s+/).filter(Boolean);
    const limits = measures.flatMap((measure) => {
        const limit = query.limits[measure];
        return limit === undefined ? [] : [{ measure, limit }];
    });
    const chosen = choices.flatMap((choice) => {
        const names = query.chosen[choice];
        const list = listOf(library, choice);
        return names.length === 0
            ? []
            : [{ choice, places: names.map((name) => list.indexOf(name)) }];
    });
    const shown = paints.filter((paint) => {
        for (const { choice, places } of chosen) {
            const has = members(paint, choice);
            const is = (place: number) => has.includes(place);
            if (!(choice === "with" ? places.every(is) : places.some(is))) return false;
        }
        for (const { measure, limit } of limits) {
            if (!within(measure, measureOf(paint, measure, at), limit)) return false;
        }
        if (words.length === 0) return true;
        const text = `${paint.name} ${paint.id}`.toLowerCase();
        return words.every((word) => text.includes(word));
    });

    const { target } = query;
    let distance: Float64Array | null = null;
    if (target !== null) {
        distance = new Float64Array(paints.length).fill(NaN);
        for (const paint of shown) {
            distance[paint.index] = deltaE2000(target, labAt(paint, at));
        }
    }

    const counts = { with: [], of: [], sweep: [] } as Record<Choice, number[]>;
    for (const choice of choices) {
        const count = new Array<number>(listOf(library, choice).length).fill(0);
        for (const paint of shown) {
            for (const place of members(paint, choice)) count[place] = (count[place] ?? 0) + 1;
        }
        counts[choice] = count;
    }
    return { paints: sorted(shown, query, at, distance), distance, counts };
}

const collator = new Intl.Collator("en", { numeric: true });

/** Records without the figure come last, in either direction; equal ones stay in the order of names. */
function sorted(
    paints: readonly Paint[],
    query: Query,
    at: number,
    distance: Float64Array | null,
): Paint[] {
    const { sort } = query;
    const byName = [...paints]; // the library's order
    const sign = query.descending ? -1 : 1;
    if (sort === "name") {
        return byName.sort((a, b) => sign * collator.compare(a.name, b.name));
    }
    const value = (paint: Paint) =>
        sort === "nearness"
            ? (distance?.[paint.index] ?? NaN)
            : (measureOf(paint, sort, at) ?? NaN);
    const values = new Map(byName.map((paint) => [paint, value(paint)]));
    return byName.sort((a, b) => {
        const [x, y] = [values.get(a) as number, values.get(b) as number];
        if (Number.isNaN(x) || Number.isNaN(y))
            return Number(Number.isNaN(x)) - Number(Number.isNaN(y));
        return sign * (x - y);
    });
}

const SORT_KEYS: readonly string[] = ["name", "nearness", ...measures];

/** As "at=45as15&L=20..60&h=330..30&with=Al&lab=50,20,10&sort=-flop"; what is as usual is left out. */
export function write(query: Query, usual: Query): string {
    const text = new URLSearchParams();
    if (query.text !== "") text.set("q", query.text);
    if (query.at !== usual.at) text.set("at", query.at);
    for (const measure of measures) {
        const limit = query.limits[measure];
        if (limit !== undefined) text.set(measure, [limit.from ?? "", limit.to ?? ""].join(".."));
    }
    for (const choice of choices) {
        for (const name of query.chosen[choice]) text.append(choice, name);
    }
    if (query.target !== null) text.set("lab", query.target.join(","));
    const sort = (query.descending ? "-" : "") + query.sort;
    if (sort !== usual.sort) text.set("sort", sort);
    return text.toString();
}

/** Reads what write() wrote; an address may be typed in, and what makes no sense there is left out. */
export function read(text: string, usual: Query, library: Library): Query {
    const given = new URLSearchParams(text);
    const query: Query = { ...usual, limits: {}, chosen: { ...usual.chosen } };
    query.text = given.get("q") ?? "";
    const at = given.get("at");
    if (at !== null && library.geometries.includes(at)) query.at = at;
    for (const measure of measures) {
        const limit = /^(-?[\d.]*)\.\.(-?[\d.]*)$/.exec(given.get(measure) ?? "");
        const number = (digits: string | undefined) => {
            const value = Number(digits);
            return digits === undefined || digits === "" || Number.isNaN(value) ? null : value;
        };
        const [from, to] = [number(limit?.[1]), number(limit?.[2])];
        if (from !== null || to !== null) query.limits[measure] = { from, to };
    }
    for (const choice of choices) {
        const list = listOf(library, choice);
        query.chosen[choice] = given.getAll(choice).filter((name) => list.includes(name));
    }
    const lab = (given.get("lab") ?? "").split(",").map(Number);
    const [L, a, b] = lab;
    if (lab.length === 3 && lab.every(Number.isFinite))
        query.target = [L as number, a as number, b as number];
    const sort = given.get("sort") ?? query.sort;
    const key = sort.replace(/^-/, "");
    if (SORT_KEYS.includes(key) && (key !== "nearness" || query.target !== null)) {
        query.sort = key as SortKey;
        query.descending = sort.startsWith("-");
    }
    return query;
}
