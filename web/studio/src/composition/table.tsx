/** A table of the recipe as a form: its numbers and choices, and the tables in it. */

import type { ComponentChildren, VNode } from "preact";
import { useState } from "preact/hooks";
import { insertEntry, moveEntry, removeEntry, setValue } from "../edit";
import type { KeyInfo, Schema, TableInfo } from "../schema";
import {
    brought,
    chosen,
    dropped,
    foreignKeys,
    isStranded,
    labelOf,
    placeText,
    singular,
    tableInfo,
} from "../schema";
import { fittingStarter, newEntry, switched, TILTS } from "../starters";
import type { Path, Table, Value } from "../tree";
import { get, isList, isTable, pathText } from "../tree";
import { useStudio, useStudioState, useValueAt } from "../ui/context";
import { useEntryKeys } from "../ui/entry_keys";
import { focusSoon } from "../ui/focus";
import { Icon, IconButton } from "../ui/icons";
import type { Choice } from "../ui/picker";
import { Picker } from "../ui/picker";
import { steady } from "../ui/steady";
import { FaultText, useFaultIn } from "./fault";
import { ValueRow } from "./rows";

/** Beside a pigment that ships only its amount and a name may stand. */
const BESIDE_PRESET = new Set([
    "name",
    "volume_fraction",
    "mass_fraction",
    "density_g_per_cm3",
    "binder_density_g_per_cm3",
]);

/** Films are stated from the core outwards, and met from the outside inwards. */
const REVERSED = new Set(["coats"]);

/** What they cover, and light meets last. */
const INNERMOST = "core";

/** Not shown as rows: a name is its section's title. */
const IN_TITLE = "name";

function offered(table: Table, info: TableInfo): KeyInfo[] {
    const foreign = foreignKeys(table, info);
    const preset = info.keys.some((key) => key.choices === "pigments" && key.key in table);
    return info.keys.filter(
        (key) =>
            !(key.key in table) &&
            !foreign.has(key.key) &&
            !isStranded(table, info, key) &&
            key.key !== IN_TITLE &&
            key.choices !== "pigments" &&
            (!preset || BESIDE_PRESET.has(key.key)),
    );
}

export const TableForm = steady(({ path }: { readonly path: Path }): VNode | null => {
    const schema = useStudioState((state) => state.schema);
    const table = useValueAt(path);
    const info = schema === null ? undefined : tableInfo(schema, path);
    const fault = useFaultIn(path);
    if (schema === null || info === undefined || !isTable(table)) return null;
    const rows: ComponentChildren[] = [];
    const inner: ComponentChildren[] = [];
    const isInnermost = ({ key }: KeyInfo) => key === INNERMOST;
    for (const key of [
        ...info.keys.filter((key) => !isInnermost(key)),
        ...info.keys.filter(isInnermost),
    ]) {
        const value = table[key.key];
        const at = [...path, key.key];
        if (key.kind === "list") {
            const shown = isList(value) || path.length === 0 || isListOfLayer(path, key.key);
            if (shown && tableInfo(schema, [...at, 0]) !== undefined) {
                if (!foreignKeys(table, info).has(key.key)) {
                    inner.push(<ListForm key={key.key} path={at} />);
                }
            }
        } else if (value === undefined || key.key === IN_TITLE) continue;
        else if (key.kind === "table") {
            if (isTable(value) && tableInfo(schema, at) !== undefined) {
                inner.push(<SectionForm key={key.key} path={at} info={key} />);
            }
        } else rows.push(<ValueRow key={key.key} path={at} info={key} value={value} />);
    }
    return (
        <>
            <FaultText id={`fault-${pathText(path)}`} text={fault} />
            {rows}
            {inner}
        </>
    );
});

/** Layers offer flakes and pigments, and flakes with a core coats, even when they have none. */
function isListOfLayer(path: Path, key: string): boolean {
    return (path.length === 2 && path[0] === "layer") || key === "coats";
}

/** What a table could have besides, could say in another way, or could do without. */
export const More = steady(({ path }: { readonly path: Path }): VNode | null => {
    const schema = useStudioState((state) => state.schema);
    const studio = useStudio();
    // What may be done depends on which keys are there, not on their values.
    useStudioState(({ document }) => keysOf(get(document.recipe, path)));
    const table = get(studio.store.get().document.recipe, path);
    const info = schema === null ? undefined : tableInfo(schema, path);
    if (schema === null || info === undefined || !isTable(table)) return null;
    return <MoreOf path={path} table={table} info={info} schema={schema} />;
});

function keysOf(table: Value | undefined): string {
    return isTable(table) ? Object.keys(table).join(" ") : "";
}

function MoreOf(props: {
    readonly path: Path;
    readonly table: Table;
    readonly info: TableInfo;
    readonly schema: Schema;
}): VNode | null {
    const { path, table, info, schema } = props;
    const studio = useStudio();
    const place = useStudioState(({ document }) => placeText(document.recipe, [...path, ""]));
    const known = (key: KeyInfo) =>
        key.kind !== "table" || tableInfo(schema, [...path, key.key]) !== undefined;
    const lists = (key: KeyInfo) =>
        key.kind === "list" && (path.length === 0 || isListOfLayer(path, key.key));
    const add = offered(table, info).filter((key) => known(key) && !lists(key));
    const marks = new Set(
        (info.alternatives ?? [])
            .filter((g) => g.required)
            .flatMap((g) => g.each.map((a) => a.mark)),
    );
    const remove = info.keys.filter(
        (key) =>
            key.key in table &&
            (!key.required || dropped(table, info, key.key) !== undefined) &&
            !marks.has(key.key) &&
            !(key.required_with !== undefined && key.required_with in table) &&
            key.key !== IN_TITLE &&
            key.kind !== "list" &&
            key.kind !== "table" &&
            key.choices !== "pigments",
    );
    const foreign = foreignKeys(table, info);
    const preset = info.keys.some((key) => key.choices === "pigments" && key.key in table);
    const instead = preset
        ? []
        : (info.alternatives ?? []).flatMap((group, g) =>
              group.each.flatMap(({ mark }, i) => {
                  const now = chosen(table, group);
                  const mine = group.each[now]?.mark ?? "";
                  if (i === now || mark === "" || mine === "" || foreign.has(mine)) return [];
                  if (mark === TILTS) return []; // read from a file: a table made up takes minutes to solve
                  return [{ g, i, text: `${labelOf(mark).label} in place of ${lower(mine)}` }];
              }),
          );
    if (add.length + remove.length + instead.length === 0) return null;
    const act = (value: string) => {
        const [what, one, two] = value.split(":");
        studio.edit((document) => {
            const now = get(document.recipe, path);
            if (what === "add") {
                const key = info.keys.find((k) => k.key === one);
                if (key === undefined) return document;
                const other = isTable(now) ? brought(now, info, key) : undefined;
                if (other === undefined || !isTable(now)) {
                    const table = isTable(now) ? now : {};
                    const value = fittingStarter(schema, path, key, table);
                    return setValue(document, [...path, key.key], value);
                }
                const more = switched(schema, path, now, other.group, other.to);
                return setValue(document, path, more);
            }
            if (what === "remove") {
                const group = isTable(now) ? dropped(now, info, one ?? "") : undefined;
                if (group === undefined || !isTable(now))
                    return setValue(document, [...path, one ?? ""], undefined);
                return setValue(document, path, switched(schema, path, now, group, 0));
            }
            const group = info.alternatives?.[Number(one)];
            if (group === undefined || !isTable(now)) return document;
            const changed = switched(schema, path, now, group, Number(two));
            return setValue(document, path, changed);
        });
    };
    return (
        <select
            class="more"
            aria-label={`More of ${place === "" ? "the paint" : place}`}
            data-at={pathText(path)}
            value=""
            onChange={(event) => {
                act(event.currentTarget.value);
                event.currentTarget.value = "";
            }}
        >
            <option value="">More</option>
            {add.length > 0 && (
                <optgroup label="Add">
                    {add.map(({ key }) => (
                        <option key={key} value={`add:${key}`}>
                            {labelOf(key).label}
                        </option>
                    ))}
                </optgroup>
            )}
            {instead.length > 0 && (
                <optgroup label="Say otherwise">
                    {instead.map(({ g, i, text }) => (
                        <option key={text} value={`instead:${String(g)}:${String(i)}`}>
                            {text}
                        </option>
                    ))}
                </optgroup>
            )}
            {remove.length > 0 && (
                <optgroup label="Leave out">
                    {remove.map(({ key }) => (
                        <option key={key} value={`remove:${key}`}>
                            {labelOf(key).label}
                        </option>
                    ))}
                </optgroup>
            )}
        </select>
    );
}

function lower(key: string): string {
    return labelOf(key).label.toLowerCase();
}

/** A heading that folds its section away, with buttons beside it. */
function Folding(props: {
    readonly path: Path;
    readonly kind: string;
    readonly title: VNode | string;
    readonly label: string;
    readonly tools: ComponentChildren;
    readonly children: ComponentChildren;
}): VNode {
    const [open, setOpen] = useState(true);
    return (
        <section
            class={`part ${props.kind}`}
            aria-label={props.label}
            data-part={pathText(props.path)}
        >
            <header>
                <button
                    type="button"
                    class="fold"
                    aria-expanded={open}
                    aria-label={`${open ? "Fold" : "Unfold"} ${props.label}`}
                    onClick={() => {
                        setOpen(!open);
                    }}
                >
                    <Icon name={open ? "open" : "closed"} />
                </button>
                <h3>{props.title}</h3>
                <span class="tools">
                    <More path={props.path} />
                    {props.tools}
                </span>
            </header>
            {open && props.children}
        </section>
    );
}

/** A table that a paint has once, as the clearcoat. */
function SectionForm({ path, info }: { readonly path: Path; readonly info: KeyInfo }): VNode {
    const studio = useStudio();
    const { label } = labelOf(info.key);
    return (
        <Folding
            path={path}
            kind={info.key}
            title={label}
            label={label}
            tools={
                !info.required && (
                    <IconButton
                        icon="remove"
                        label={`Remove ${label}`}
                        onClick={() => {
                            studio.edit((document) => setValue(document, path, undefined));
                            focusSoon(
                                `select.more[data-at='${pathText(path.slice(0, -1))}']`,
                                ".paint-name .name",
                            );
                        }}
                    />
                )
            }
        >
            <TableForm path={path} />
        </Folding>
    );
}

const ListForm = steady(({ path }: { readonly path: Path }): VNode => {
    const value = useValueAt(path);
    const entries = isList(value) ? value : [];
    const list = String(path.at(-1));
    const keys = useEntryKeys(entries);
    const order = [...entries.keys()];
    if (REVERSED.has(list)) order.reverse();
    const add = <AddEntry path={path} at={entries.length} />;
    return (
        <div class={`list ${list}`} data-list={pathText(path)}>
            {REVERSED.has(list) && add}
            {order.map((i) => (
                <EntryForm key={keys[i]} path={path} i={i} count={entries.length} />
            ))}
            {!REVERSED.has(list) && add}
        </div>
    );
});

/** The button of an entry's heading. */
function toolOf(list: Path, i: number, icon: "up" | "down" | "remove"): string {
    const part = pathText([...list, i]);
    return `[data-part='${part}'] > header .icon-button[data-icon='${icon}']`;
}

const OWN_PIGMENT = "own coefficients";
const NEW_FLAKES = "New flakes";

const AddEntry = steady(
    ({ path, at }: { readonly path: Path; readonly at: number }): VNode | null => {
        const studio = useStudio();
        const schema = useStudioState((state) => state.schema);
        if (schema === null) return null;
        const list = String(path.at(-1));
        const kind = singular(list);
        const insert = (entry?: Value) => {
            studio.edit((document) => {
                const last = get(document.recipe, [...path, at - 1]);
                const made = entry ?? newEntry(schema, path, last);
                return insertEntry(document, path, at, made);
            });
        };
        const pick = (choices: readonly Choice[], made: (name: string) => Value | undefined) => (
            <Picker
                class="add"
                label={list === "pigment" ? "Add a pigment" : "Add flakes"}
                text={list === "pigment" ? "+ Pigment" : "+ Flakes"}
                chosen={null}
                choices={choices}
                onChoose={(name) => {
                    insert(made(name));
                }}
            />
        );
        if (list === "pigment") {
            const own = { name: OWN_PIGMENT, summary: "scattering and absorption", rgb: null };
            return pick([...schema.pigments, own], (name) =>
                name === OWN_PIGMENT
                    ? { scattering_per_mm: 10, absorption_per_mm: 10 }
                    : { from: name, volume_fraction: 0.05 },
            );
        }
        if (list === "flakes") {
            const made = { name: NEW_FLAKES, summary: "TiO2 on mica, to begin with" };
            return pick(
                [made, ...schema.flakes],
                (name) => schema.flakes.find((known) => known.name === name)?.value,
            );
        }
        return (
            <button
                type="button"
                class="add"
                onClick={() => {
                    insert();
                }}
            >
                + {kind.charAt(0).toUpperCase() + kind.slice(1)}
            </button>
        );
    },
);

interface EntryProps {
    readonly path: Path;
    readonly i: number;
    readonly count: number;
}

const EntryForm = steady(({ path, i, count }: EntryProps): VNode | null => {
    const studio = useStudio();
    const schema = useStudioState((state) => state.schema);
    const at = [...path, i];
    const table = useValueAt(at);
    const list = String(path.at(-1));
    const kind = singular(list);
    const number = list === "layer" && count === 1 ? "" : ` ${String(i + 1)}`;
    const heading = `${kind.charAt(0).toUpperCase()}${kind.slice(1)}${number}`;
    if (!isTable(table) || schema === null) return null;
    const named = tableInfo(schema, at)?.keys.some(({ key }) => key === IN_TITLE) === true;
    const name = typeof table.name === "string" ? table.name : "";
    const label = name === "" ? heading : `${heading}, ${name}`;
    const title = named ? (
        <input
            type="text"
            class="name"
            value={name}
            placeholder={typeof table.from === "string" ? table.from : heading}
            aria-label={`Name of ${heading.toLowerCase()}`}
            onChange={(event) => {
                const text = event.currentTarget.value;
                studio.edit((document) =>
                    setValue(document, [...at, IN_TITLE], text === "" ? undefined : text),
                );
            }}
        />
    ) : (
        heading
    );
    // On the screen a list that is shown from its end goes the other way.
    const up = REVERSED.has(list) ? 1 : -1;
    const move = (by: -1 | 1, word: "up" | "down") => (
        <IconButton
            icon={word}
            label={`Move ${label} ${word}`}
            disabled={i + by < 0 || i + by >= count}
            onClick={() => {
                studio.edit((document) => moveEntry(document, path, i, by));
                const other = word === "up" ? "down" : "up";
                focusSoon(toolOf(path, i + by, word), toolOf(path, i + by, other));
            }}
        />
    );
    return (
        <Folding
            path={at}
            kind={list}
            title={title}
            label={label}
            tools={
                <>
                    {count > 1 && move(up, "up")}
                    {count > 1 && move(up === 1 ? -1 : 1, "down")}
                    <IconButton
                        icon="copy"
                        label={`Duplicate ${label}`}
                        onClick={() => {
                            studio.edit((document) => insertEntry(document, path, i + 1, table));
                        }}
                    />
                    <IconButton
                        icon="remove"
                        label={`Remove ${label}`}
                        onClick={() => {
                            studio.edit((document) => removeEntry(document, path, i));
                            focusSoon(
                                toolOf(path, i, "remove"),
                                toolOf(path, i - 1, "remove"),
                                `[data-list='${pathText(path)}'] > .add`,
                                `[data-list='${pathText(path)}'] > .add button`,
                            );
                        }}
                    />
                </>
            }
        >
            <TableForm path={at} />
        </Folding>
    );
});
