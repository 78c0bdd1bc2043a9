/** Edits of a document: the recipe, and the numbers that are locked. */

import type { Path, Table, Value } from "./tree";
import { get, isList, isTable, parsePath, pathText, set } from "./tree";

export interface Document {
    readonly recipe: Table;
    /** Paths as text. A locked number has no slider to move and is never free in a fit. */
    readonly locks: ReadonlySet<string>;
    /** The text from which it was opened: the server takes its comments into the texts that it writes. */
    readonly toml?: string;
}

/** Tables of a recipe whose keys are paths of numbers. */
const BY_PATH = ["fit", "uncertainty"];

export function setValue(document: Document, path: Path, value: Value | undefined): Document {
    const recipe = set(document.recipe, path, value);
    return value === undefined
        ? renamed({ ...document, recipe }, (key) => (startsWith(key, path) ? null : key))
        : { ...document, recipe };
}

export function setLock(document: Document, path: Path, locked: boolean): Document {
    const locks = new Set(document.locks);
    if (locked) locks.add(pathText(path));
    else locks.delete(pathText(path));
    return { ...document, locks };
}

/** The key of [uncertainty] that is no path: which numbers are wrong together. */
const CORRELATION = "correlation";

function startsWith(path: Path, start: Path): boolean {
    return start.every((step, i) => path[i] === step);
}

/** What is said of numbers elsewhere follows them: locks, bounds of a fit, uncertainties. */
function renamed(document: Document, name: (path: Path) => Path | null): Document {
    const renamedText = (text: string) => {
        const path = name(parsePath(text));
        return path === null ? null : pathText(path);
    };
    const locks = new Set<string>();
    for (const lock of document.locks) {
        const text = renamedText(lock);
        if (text !== null) locks.add(text);
    }
    let recipe = document.recipe;
    for (const key of BY_PATH) {
        const table = recipe[key];
        if (!isTable(table)) continue;
        const entries = Object.entries(table).flatMap(([path, value]): [string, Value][] => {
            if (path === CORRELATION) {
                const kept = isList(value) ? correlations(value, renamedText) : value;
                return isList(kept) && kept.length === 0 ? [] : [[path, kept]];
            }
            const text = renamedText(path);
            return text === null ? [] : [[text, value]];
        });
        const kept = entries.length > 0 ? Object.fromEntries(entries) : undefined;
        recipe = set(recipe, [key], kept);
    }
    return { ...document, recipe, locks };
}

/** Those of which two numbers or more are left. */
function correlations(
    stated: readonly Value[],
    renamedText: (text: string) => string | null,
): readonly Value[] {
    return stated.flatMap((entry): Value[] => {
        const of = isTable(entry) ? entry.of : undefined;
        if (!isTable(entry) || !isList(of)) return [entry];
        const kept = of.flatMap((key): Value[] => {
            const text = typeof key === "string" ? renamedText(key) : key;
            return text === null ? [] : [text];
        });
        return kept.length < 2 ? [] : [{ ...entry, of: kept }];
    });
}

function reindexed(document: Document, list: Path, place: (i: number) => number | null): Document {
    return renamed(document, (path) => {
        const i = path[list.length];
        if (!startsWith(path, list) || typeof i !== "number") return path;
        const to = place(i);
        return to === null ? null : [...list, to, ...path.slice(list.length + 1)];
    });
}

function listAt(document: Document, path: Path): readonly Value[] {
    const list = get(document.recipe, path);
    return isList(list) ? list : [];
}

function withList(document: Document, path: Path, list: readonly Value[]): Document {
    return { ...document, recipe: set(document.recipe, path, list.length > 0 ? list : undefined) };
}

/** A new entry at a place of a list, which is made if it is not there. */
export function insertEntry(document: Document, list: Path, at: number, entry: Value): Document {
    const entries = [...listAt(document, list)];
    // A copy, so that no two entries of a list are one object, by which they are told apart.
    entries.splice(at, 0, isTable(entry) ? { ...entry } : entry);
    const moved = reindexed(document, list, (i) => (i >= at ? i + 1 : i));
    return withList(moved, list, entries);
}

export function removeEntry(document: Document, list: Path, at: number): Document {
    const entries = listAt(document, list).filter((_, i) => i !== at);
    const moved = reindexed(document, list, (i) => (i === at ? null : i > at ? i - 1 : i));
    return withList(moved, list, entries);
}

/** One place up (-1) or down (+1); at the ends nothing changes. */
export function moveEntry(document: Document, list: Path, at: number, by: -1 | 1): Document {
    const entries = [...listAt(document, list)];
    const [one, other] = [entries[at], entries[at + by]];
    if (one === undefined || other === undefined) return document;
    entries[at] = other;
    entries[at + by] = one;
    const moved = reindexed(document, list, (i) => (i === at ? at + by : i === at + by ? at : i));
    return withList(moved, list, entries);
}
