/** A number of the recipe: slider, field, unit and lock. */

import type { VNode } from "preact";
import { useEffect, useId, useRef, useState } from "preact/hooks";
import { digits, shortDigits } from "../digits";
import type { Document } from "../edit";
import { setLock, setValue } from "../edit";
import type { KeyInfo } from "../schema";
import { labelOf, placeText, tipOf } from "../schema";
import type { Scale } from "../slider";
import { scaleOf, settled } from "../slider";
import type { Path } from "../tree";
import { pathText } from "../tree";
import { useStudio, useStudioState, useValueAt } from "../ui/context";
import { IconButton } from "../ui/icons";
import { FaultText, useFaultAt } from "./fault";

/** Bounds of the recipe's own table [fit]. */
function boundsOf(bounds: unknown): readonly [number, number] | undefined {
    if (!Array.isArray(bounds) || bounds.length !== 2) return undefined;
    const [low, high] = bounds as readonly unknown[];
    return typeof low === "number" && typeof high === "number" ? [low, high] : undefined;
}

export function NumberRow(props: {
    readonly path: Path;
    readonly info: KeyInfo;
    readonly value: number;
    /** In place of the key's. */
    readonly label?: string;
}): VNode {
    const { path, info, value } = props;
    const studio = useStudio();
    const text = pathText(path);
    const locked = useStudioState((state) => state.document.locks.has(text));
    const place = useStudioState((state) => placeText(state.document.recipe, path));
    const bounds = boundsOf(useValueAt(["fit", text]));
    const fault = useFaultAt(path);
    const id = useId();
    const [draft, setDraft] = useState<string | null>(null);
    const [focused, setFocused] = useState(false);
    const [wrong, setWrong] = useState<{ readonly text: string; readonly of: Document } | null>(
        null,
    );
    // It is of what was typed into this paint: an undo or a step of the arrows is another.
    const stands = useStudioState(({ document }) => wrong?.of === document);
    useEffect(() => {
        if (!stands) setWrong(null);
    }, [stands]);
    const scale = useRef<Scale | null>(null);
    const dragging = useRef(false);

    const old = scale.current;
    const far = old === null || value > old.high || value < old.low;
    const tiny = old !== null && value > 0 && value < old.high / 40;
    if (far || (tiny && !dragging.current)) scale.current = scaleOf(info, value, bounds);
    const { low, high, step } = scale.current as Scale;

    const { unit } = labelOf(info.key);
    const label = props.label ?? labelOf(info.key).label;
    const full = place === "" ? label : `${label}, ${place}`;
    const change = (to: number, gesture: string | null) => {
        studio.edit((document) => setValue(document, path, to), gesture);
    };
    const commit = () => {
        if (draft === null) return;
        const typed = Number(draft.trim().replace("−", "-").replace(",", "."));
        setDraft(null);
        if (draft.trim() === "" || !Number.isFinite(typed)) {
            const of = studio.store.get().document;
            setWrong({ text: `“${draft}” is not a number`, of });
            return;
        }
        setWrong(null);
        if (typed !== value) change(typed, null);
    };
    const stepBy = (sign: number, event: KeyboardEvent) => {
        event.preventDefault();
        setDraft(null);
        const size = event.shiftKey ? 10 * step : step;
        change(settled(info, { low, high: Infinity, step }, value + sign * size), `type ${text}`);
    };
    const hidden = shortDigits(value) === digits(value) ? "" : digits(value);
    const message = stands && wrong !== null ? wrong.text : fault;
    return (
        <div class={message === null ? "row number" : "row number wrong"} data-key={text}>
            <label for={id} title={info.doc}>
                {label}
            </label>
            <input
                type="range"
                min={low}
                max={high}
                step="any"
                value={value}
                disabled={locked}
                aria-label={`${full}, slider`}
                aria-valuetext={`${digits(value)} ${unit}`}
                onInput={(event) => {
                    dragging.current = true;
                    setWrong(null);
                    const raw = Number(event.currentTarget.value);
                    change(settled(info, { low, high, step }, raw), `slide ${text}`);
                }}
                onChange={() => {
                    dragging.current = false;
                    studio.endGesture();
                }}
                onKeyDown={(event) => {
                    const by: Record<string, number> = {
                        ArrowRight: 1,
                        ArrowUp: 1,
                        ArrowLeft: -1,
                        ArrowDown: -1,
                        PageUp: 20,
                        PageDown: -20,
                    };
                    const steps = by[event.key];
                    if (steps === undefined) return;
                    event.preventDefault();
                    const size = event.shiftKey ? 10 * step : step;
                    const next = settled(info, { low, high, step }, value + steps * size);
                    change(next, `slide ${text}`);
                }}
                onBlur={() => {
                    studio.endGesture();
                }}
            />
            <input
                id={id}
                type="text"
                inputMode="decimal"
                autocomplete="off"
                value={draft ?? (focused ? digits(value) : shortDigits(value))}
                readOnly={locked}
                title={tipOf(info, hidden)}
                aria-label={full}
                aria-invalid={message !== null}
                data-draft={draft !== null}
                aria-describedby={message === null ? undefined : `${id}-fault`}
                onInput={(event) => {
                    setDraft(event.currentTarget.value);
                }}
                onFocus={(event) => {
                    setFocused(true);
                    event.currentTarget.value = digits(value); // before it is selected
                    event.currentTarget.select();
                }}
                onBlur={() => {
                    setFocused(false);
                    commit();
                    studio.endGesture();
                }}
                onKeyDown={(event) => {
                    if (event.key === "Enter") commit();
                    else if (event.key === "Escape") {
                        setDraft(null);
                        setWrong(null);
                    } else if (locked) return;
                    else if (event.key === "ArrowUp") stepBy(1, event);
                    else if (event.key === "ArrowDown") stepBy(-1, event);
                }}
            />
            <span class="unit">{unit}</span>
            <IconButton
                icon={locked ? "lock" : "unlock"}
                label={locked ? `Unlock ${full}` : `Lock ${full}`}
                pressed={locked}
                onClick={() => {
                    studio.edit((document) => setLock(document, path, !locked));
                }}
            />
            <FaultText id={`${id}-fault`} text={message} />
        </div>
    );
}
