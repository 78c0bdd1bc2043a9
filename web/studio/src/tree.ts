/** A recipe as its tree, which is never changed in place: each edit makes a new tree that shares the rest. */

export type Value = string | number | boolean | readonly Value[] | Table;
export interface Table {
    readonly [key: string]: Value;
}

export type Step = string | number;
/** From the paint downwards: `["layer", 0, "thickness_um"]`. */
export type Path = readonly Step[];

export function isTable(value: Value | undefined): value is Table {
    return typeof value === "object" && (value as unknown) !== null && !Array.isArray(value);
}

export function isList(value: Value | undefined): value is readonly Value[] {
    return Array.isArray(value);
}

/** How deep tables and lists lie in each other at most, as in the program's reader of TOML. */
const MOST_LEVELS = 32;

/** Whether what came as JSON is what a recipe may hold: nothing is null, and nothing lies too deep. */
export function isValue(value: unknown, levels = MOST_LEVELS): value is Value {
    if (typeof value !== "object") return value !== undefined;
    if (value === null || levels === 0) return false;
    return Object.values(value).every((inner) => isValue(inner, levels - 1));
}

/** As messages and tables name a key: "layer[0].flakes[1].volume_fraction". */
export function pathText(path: Path): string {
    let text = "";
    for (const step of path) {
        if (typeof step === "number") text += `[${String(step)}]`;
        else text += text === "" ? step : `.${step}`;
    }
    return text;
}

export function parsePath(text: string): Path {
    const steps: Step[] = [];
    for (const part of text.matchAll(/\[(\d+)\]|[^.[\]]+/g)) {
        steps.push(part[1] === undefined ? part[0] : Number(part[1]));
    }
    return steps;
}

/** The same for all entries of a list: "layer[].flakes[]". */
export function genericPath(path: Path): string {
    return pathText(path).replace(/\[\d+\]/g, "[]");
}

export function get(tree: Value | undefined, path: Path): Value | undefined {
    let value = tree;
    for (const step of path) {
        if (typeof step === "number") value = isList(value) ? value[step] : undefined;
        else value = isTable(value) ? value[step] : undefined;
    }
    return value;
}

/** With the value at the path replaced, or without its key where the value is undefined. */
export function set(tree: Table, path: Path, value: Value | undefined): Table {
    return replaced(tree, path, value) as Table;
}

function replaced(
    tree: Value | undefined,
    path: Path,
    value: Value | undefined,
): Value | undefined {
    const [step, ...rest] = path;
    if (step === undefined) return value;
    if (typeof step === "number") {
        const list = isList(tree) ? [...tree] : [];
        const inner = replaced(list[step], rest, value);
        if (inner === undefined) list.splice(step, 1);
        else list[step] = inner;
        return list;
    }
    const table: Record<string, Value> = isTable(tree) ? { ...tree } : {};
    const inner = replaced(table[step], rest, value);
    if (inner === undefined) Reflect.deleteProperty(table, step);
    else table[step] = inner;
    return table;
}

/** Every number in the tree with its path, in the order of the tree. */
export function numbers(tree: Value, path: Path = []): { path: Path; value: number }[] {
    if (typeof tree === "number") return [{ path, value: tree }];
    if (isList(tree)) return tree.flatMap((item, i) => numbers(item, [...path, i]));
    if (isTable(tree)) {
        return Object.entries(tree).flatMap(([key, item]) => numbers(item, [...path, key]));
    }
    return [];
}
