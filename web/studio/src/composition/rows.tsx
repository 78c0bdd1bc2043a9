/** Values of the recipe that are no plain numbers. */

import type { VNode } from "preact";
import { useId } from "preact/hooks";
import { setValue } from "../edit";
import type { KeyInfo, Rgb } from "../schema";
import { labelOf, placeText } from "../schema";
import { TABULATED, withChoice } from "../starters";
import type { Path, Value } from "../tree";
import { get, isList, isTable, pathText } from "../tree";
import { useStudio, useStudioState } from "../ui/context";
import { focusSoon } from "../ui/focus";
import { Picker } from "../ui/picker";
import { steady } from "../ui/steady";
import { FaultText, useFaultAt } from "./fault";
import { NumberRow } from "./number_row";

interface RowProps {
    readonly path: Path;
    readonly info: KeyInfo;
    readonly value: Value;
}

export const ValueRow = steady(({ path, info, value }: RowProps): VNode => {
    if (typeof value === "number" && info.kind !== "material") {
        return <NumberRow path={path} info={info} value={value} />;
    }
    switch (info.kind) {
        case "material":
            return <MaterialRow path={path} info={info} value={value} />;
        case "choice":
            return <ChoiceRow path={path} info={info} value={value} />;
        case "text":
            return info.choices === "pigments" ? (
                <PigmentRow path={path} info={info} value={value} />
            ) : (
                <TextRow path={path} info={info} value={value} />
            );
        case "spectrum":
            return isColour(value) ? (
                <ColourRow path={path} info={info} value={value} />
            ) : (
                <SamplesRow path={path} info={info} value={value} />
            );
        default:
            return <SamplesRow path={path} info={info} value={value} />;
    }
});

/** What all of them need: label, message, and how to set another value. */
function useRow({ path, info }: RowProps) {
    const studio = useStudio();
    const place = useStudioState((state) => placeText(state.document.recipe, path));
    const fault = useFaultAt(path);
    const id = useId();
    const { label } = labelOf(info.key);
    return {
        id,
        label,
        full: place === "" ? label : `${label}, ${place}`,
        fault,
        faultText: <FaultText id={`${id}-fault`} text={fault} />,
        describedBy: fault === null ? undefined : `${id}-fault`,
        class: fault === null ? "row" : "row wrong",
        set: (value: Value | undefined) => {
            studio.edit((document) => setValue(document, path, value));
        },
    };
}

function textOf(value: Value | undefined): string {
    return typeof value === "string" || typeof value === "number" ? String(value) : "";
}

/** Of a material that is an index. */
const AN_INDEX = "a number: its index";

function MaterialRow(props: RowProps): VNode {
    const row = useRow(props);
    const { value } = props;
    const materials = useStudioState((state) => state.schema?.materials) ?? [];
    const { info, path } = props;
    const own = isTable(value) ? "own samples" : typeof value === "string" ? value : null;
    const known = materials.some(({ name }) => name === value);
    const choices = [
        ...(own !== null && !known ? [{ name: own, rgb: null }] : []),
        ...materials,
        { name: AN_INDEX, summary: "the same at all wavelengths", rgb: null },
    ];
    const picker = (
        <Picker
            label={row.full}
            choices={choices}
            chosen={typeof value === "number" ? AN_INDEX : own}
            onChoose={(name) => {
                if (name === AN_INDEX) row.set(typeof value === "number" ? value : 1.5);
                else if (name !== own) row.set(name);
            }}
        />
    );
    if (typeof value === "number") {
        return (
            <>
                <div class={row.class}>
                    <span class="label" title={info.doc}>
                        {row.label}
                    </span>
                    {picker}
                </div>
                <NumberRow
                    path={path}
                    info={{ ...info, kind: "number" }}
                    value={value}
                    label="Index"
                />
            </>
        );
    }
    return (
        <div class={row.class} data-key={path.join(".")}>
            <span class="label" title={info.doc}>
                {row.label}
            </span>
            {picker}
            {row.faultText}
        </div>
    );
}

function PigmentRow(props: RowProps): VNode {
    const row = useRow(props);
    const pigments = useStudioState((state) => state.schema?.pigments) ?? [];
    return (
        <div class={row.class}>
            <span class="label">Pigment</span>
            <Picker
                label={row.full}
                choices={pigments}
                chosen={textOf(props.value)}
                onChoose={row.set}
            />
            {row.faultText}
        </div>
    );
}

function ChoiceRow(props: RowProps): VNode {
    const row = useRow(props);
    const { info, value } = props;
    const all = Array.isArray(info.choices) ? (info.choices as readonly string[]) : [];
    const words = all.filter((word) => word !== TABULATED || word === value);
    const studio = useStudio();
    const choose = (word: string) => {
        const { schema } = studio.store.get();
        const at = props.path.slice(0, -1);
        studio.edit((document) => {
            const table = get(document.recipe, at);
            if (schema === null || !isTable(table)) return document;
            return setValue(document, at, withChoice(schema, at, table, info.key, word));
        });
    };
    return (
        <div class={row.class}>
            <label for={row.id} title={info.doc}>
                {row.label}
            </label>
            <select
                id={row.id}
                aria-label={row.full}
                aria-describedby={row.describedBy}
                value={textOf(value)}
                onChange={(event) => {
                    choose(event.currentTarget.value);
                }}
            >
                {words.map((word) => (
                    <option key={word} value={word}>
                        {word}
                    </option>
                ))}
            </select>
            {row.faultText}
        </div>
    );
}

function TextRow(props: RowProps): VNode {
    const row = useRow(props);
    return (
        <div class={row.class}>
            <label for={row.id} title={props.info.doc}>
                {row.label}
            </label>
            <input
                id={row.id}
                type="text"
                aria-label={row.full}
                aria-describedby={row.describedBy}
                value={textOf(props.value)}
                onChange={(event) => {
                    row.set(event.currentTarget.value);
                }}
            />
            {row.faultText}
        </div>
    );
}

function isColour(value: Value): boolean {
    return isList(value) && value.length === 3 && value.every((x) => typeof x === "number");
}

const encode = (x: number) => (x <= 0.0031308 ? 12.92 * x : 1.055 * x ** (1 / 2.4) - 0.055);
const decode = (x: number) => (x <= 0.04045 ? x / 12.92 : ((x + 0.055) / 1.055) ** 2.4);

/** A reflectance given as linear Rec. 709. */
function ColourRow(props: RowProps): VNode {
    const row = useRow(props);
    const linear = props.value as unknown as Rgb;
    const hex = linear
        .map((x) => Math.round(255 * encode(Math.min(Math.max(x, 0), 1))))
        .map((byte) => byte.toString(16).padStart(2, "0"))
        .join("");
    return (
        <div class={row.class}>
            <label for={row.id} title={props.info.doc}>
                {row.label}
            </label>
            <span class="colour">
                <input
                    id={row.id}
                    type="color"
                    aria-label={row.full}
                    aria-describedby={row.describedBy}
                    value={`#${hex}`}
                    onChange={(event) => {
                        const bytes = event.currentTarget.value.slice(1).match(/../g) ?? [];
                        const channel = (byte: string) =>
                            Number(decode(parseInt(byte, 16) / 255).toFixed(4));
                        row.set(bytes.map(channel));
                    }}
                />
                <span>{linear.map((x) => x.toFixed(3)).join(" ")}</span>
            </span>
            {row.faultText}
        </div>
    );
}

/** Samples over wavelengths, or the name of a file of them. */
function SamplesRow(props: RowProps): VNode {
    const row = useRow(props);
    const { value, info } = props;
    const wavelengths = isTable(value) ? get(value, ["wavelengths_nm"]) : undefined;
    const text = isList(wavelengths)
        ? `${String(wavelengths.length)} samples, ${textOf(wavelengths[0])} to ${textOf(wavelengths.at(-1))} nm`
        : typeof value === "string"
          ? value
          : "as in the recipe";
    return (
        <div class={row.class}>
            <span class="label" title={info.doc}>
                {row.label}
            </span>
            <span class="plain">{text}</span>
            {info.kind === "spectrum" && (
                <button
                    type="button"
                    class="small"
                    aria-label={`One number in place of samples: ${row.full}`}
                    onClick={() => {
                        row.set(meanOf(value));
                        focusSoon(`[data-key='${pathText(props.path)}'] input[type=text]`);
                    }}
                >
                    One number
                </button>
            )}
            {row.faultText}
        </div>
    );
}

function meanOf(value: Value): number {
    const values = isTable(value) ? value.values : undefined;
    const numbers = isList(values) ? values.filter((x) => typeof x === "number") : [];
    if (numbers.length === 0) return 0.5;
    const mean = numbers.reduce((sum, x) => sum + x, 0) / numbers.length;
    return Number(mean.toPrecision(4));
}
