/** The colours that a number can give, as its values run from left to right: click one to take it. */

import type { VNode } from "preact";
import { useEffect, useMemo, useRef, useState } from "preact/hooks";
import type { Lab } from "../../../common/colour";
import { chip, deltaE2000 } from "../../../common/colour";
import { angleName, number } from "../../../common/dom";
import { ticks } from "../../../common/plots";
import { atlasValues } from "../atlas";
import { setValue } from "../edit";
import type { AtlasMessage, Readings } from "../protocol";
import type { Parameter } from "../schema";
import { labelOf, parameters, placeText, plain } from "../schema";
import { scaleOf } from "../slider";
import { pathText } from "../tree";
import { useAtlasState, useStudio, useStudioState } from "../ui/context";
import { cssOf } from "../ui/picker";
import { groups, standardAt } from "./chips";

interface Ends {
    readonly low: number;
    readonly high: number;
}

/** Films' thicknesses, which turn the colour, before all other numbers. */
function isFilm({ path }: Parameter): boolean {
    return path[path.length - 1] === "thickness_nm";
}

export function AtlasPanel(): VNode | null {
    const studio = useStudio();
    const schema = useStudioState((state) => state.schema);
    const document = useStudioState((state) => state.document);
    const sound = useStudioState((state) => state.fault === null);
    const settings = useStudioState((state) => state.settings);
    const connected = useStudioState((state) => state.connection === "open");
    const fault = useAtlasState((state) => state.fault);
    const setup = useStudioState((state) => state.atlasSetup);
    const { key, ends: own } = setup;
    const { recipe } = document;

    const all = useMemo(
        () => (schema === null ? [] : parameters(schema, recipe)),
        [schema, recipe],
    );
    const films = all.filter(isFilm);
    const at = (text: string | null) => all.find(({ path }) => pathText(path) === text);
    const film = films.find(({ path }) => path.includes("coats")) ?? films[0];
    const chosen = at(key) ?? film ?? all[0];
    const name = chosen === undefined ? "" : pathText(chosen.path);
    const ends = useEnds(chosen, own.get(name));
    const values = useMemo(
        () => (chosen === undefined || ends === null ? [] : atlasValues(chosen.info, ends)),
        [chosen?.info, ends?.low, ends?.high],
    );

    // A recipe that the server refused has no colours at other values either.
    useEffect(() => {
        if (chosen === undefined || !sound || !connected) return;
        studio.atlas.want(recipe, chosen.path, values, settings);
    }, [studio, recipe, name, values, settings, sound, connected]);
    useEffect(
        () => () => {
            studio.atlas.stop();
        },
        [studio],
    );
    if (chosen === undefined || ends === null) return null;

    const { label, unit } = labelOf(chosen.info.key);
    const option = ({ path, info }: Parameter) => {
        const place = placeText(recipe, path);
        const text = labelOf(info.key).label + (place === "" ? "" : `, ${place}`);
        return (
            <option key={pathText(path)} value={pathText(path)}>
                {text}
            </option>
        );
    };
    const setEnds = (change: Partial<Ends>) => {
        const now = new Map(own).set(name, { ...ends, ...change });
        studio.store.set({ atlasSetup: { ...setup, ends: now } });
    };
    return (
        <div class="atlas">
            <div class="atlas-bar">
                <select
                    aria-label="Number of the atlas"
                    value={name}
                    onChange={(event) => {
                        const { value } = event.currentTarget;
                        studio.store.set({ atlasSetup: { ...setup, key: value } });
                    }}
                >
                    {films.length > 0 && <optgroup label="Films">{films.map(option)}</optgroup>}
                    <optgroup label="Other numbers">
                        {all.filter((one) => !isFilm(one)).map(option)}
                    </optgroup>
                </select>
                <span>From</span>
                <EndField
                    label="From"
                    value={ends.low}
                    set={(low) => {
                        setEnds({ low });
                    }}
                />
                <span>to</span>
                <EndField
                    label="To"
                    value={ends.high}
                    set={(high) => {
                        setEnds({ high });
                    }}
                />
                <span>{unit}</span>
            </div>
            {values.length === 0 ? (
                <p class="fault-line">
                    Between {plain(ends.low)} and {plain(ends.high)} {unit} nothing is allowed.
                </p>
            ) : fault !== null ? (
                <p class="fault-line">{fault}</p>
            ) : (
                <Colours
                    of={name}
                    label={label}
                    unit={unit}
                    now={chosen.value}
                    locked={document.locks.has(name)}
                    take={(value) => {
                        studio.edit((before) => setValue(before, chosen.path, value));
                    }}
                />
            )}
        </div>
    );
}

/** Those that were chosen, else those of the number's slider, which stay while it moves. */
function useEnds(chosen: Parameter | undefined, own: Ends | undefined): Ends | null {
    const kept = useRef<{ name: string; ends: Ends } | null>(null);
    if (chosen === undefined) return null;
    if (own !== undefined) return own;
    const { path, info, value } = chosen;
    const name = pathText(path);
    const old = kept.current;
    if (old?.name === name && value >= old.ends.low && value <= old.ends.high) return old.ends;
    const { low, high } = scaleOf(info, value);
    kept.current = { name, ends: { low, high } };
    return kept.current.ends;
}

function EndField(props: {
    readonly label: string;
    readonly value: number;
    readonly set: (value: number) => void;
}): VNode {
    return (
        <input
            type="number"
            step="any"
            aria-label={props.label}
            value={props.value}
            onChange={(event) => {
                const typed = event.currentTarget.valueAsNumber;
                if (Number.isFinite(typed)) props.set(typed);
                else event.currentTarget.value = String(props.value);
            }}
        />
    );
}

interface Place {
    readonly column: number;
    readonly geometry: number;
}

function Colours(props: {
    readonly of: string;
    readonly label: string;
    readonly unit: string;
    readonly now: number;
    readonly locked: boolean;
    readonly take: (value: number) => void;
}): VNode {
    const { now, take, unit } = props;
    const newest = useAtlasState((state) => state.atlas);
    const busy = useAtlasState((state) => state.busy);
    const readings = useStudioState((state) => state.readings);
    const fraction = useAtlasState((state) => state.fraction);
    const [hover, setHover] = useState<Place | null>(null);
    const atlas = newest?.key === props.of ? newest : null;
    const rows = useMemo(() => (atlas === null ? [] : rowsOf(atlas)), [atlas]);
    if (atlas === null)
        return <p class="empty">{busy ? "Solving the paint at each value …" : ""}</p>;

    const { values } = atlas;
    const [first, last] = [values[0] as number, values[values.length - 1] as number];
    const share = (value: number) => (last > first ? (value - first) / (last - first) : 0.5);
    const inside = now >= first && now <= last;
    const place = hover ?? {
        column: nearest(values, now),
        geometry: rows[0]?.geometry ?? 0,
    };
    const columnAt = (event: MouseEvent, element: Element) => {
        const { left, width } = element.getBoundingClientRect();
        const wanted = first + ((event.clientX - left) / width) * (last - first);
        return nearest(values, wanted);
    };
    const point = (event: PointerEvent & { currentTarget: HTMLElement }) => {
        const row = (event.target as Element).closest<HTMLElement>("[data-row]");
        const geometry = row === null ? place.geometry : Number(row.dataset.row);
        setHover({ column: columnAt(event, event.currentTarget), geometry });
    };
    const choose = (column: number) => {
        const value = values[column];
        if (value !== undefined && !props.locked) take(value);
    };
    const keys = (event: KeyboardEvent) => {
        const row = rows.findIndex(({ geometry }) => geometry === place.geometry);
        const move = (columns: number, down: number) => {
            const to = rows[Math.min(Math.max(row + down, 0), rows.length - 1)];
            const column = Math.min(Math.max(place.column + columns, 0), values.length - 1);
            setHover({ column, geometry: to?.geometry ?? 0 });
        };
        if (event.key === "ArrowLeft") move(-1, 0);
        else if (event.key === "ArrowRight") move(1, 0);
        else if (event.key === "ArrowUp") move(0, -1);
        else if (event.key === "ArrowDown") move(0, 1);
        else if (event.key === "Home") move(-values.length, 0);
        else if (event.key === "End") move(values.length, 0);
        else if (event.key === "Enter" || event.key === " ") choose(place.column);
        else return;
        event.preventDefault();
    };
    const percent = (part: number) => `${(100 * part).toFixed(2)}%`;
    return (
        <div class="stage atlas-stage" aria-busy={busy}>
            <div class="atlas-labels" aria-hidden="true">
                {rows.map(({ geometry, label }) => (
                    <span key={geometry}>{label}</span>
                ))}
            </div>
            <div
                class={props.locked ? "atlas-field locked" : "atlas-field"}
                role="application"
                tabIndex={0}
                aria-label={`Atlas of ${props.label.toLowerCase()}: arrow keys go from colour to colour, Enter takes one.`}
                onPointerMove={point}
                onPointerDown={point}
                onPointerLeave={() => {
                    setHover(null);
                }}
                onClick={(event) => {
                    choose(columnAt(event, event.currentTarget));
                }}
                onKeyDown={keys}
                onBlur={() => {
                    setHover(null);
                }}
            >
                {rows.map(({ geometry, background }) => (
                    <i
                        key={geometry}
                        class={geometry === place.geometry && hover !== null ? "at" : ""}
                        data-row={geometry}
                        style={{ background }}
                    />
                ))}
                {inside && <b class="now" style={{ left: percent(share(now)) }} />}
                {hover !== null && (
                    <b
                        class="cursor"
                        style={{ left: percent(share(values[hover.column] ?? now)) }}
                    />
                )}
            </div>
            {readings?.standard != null && (
                <div class="atlas-standard" title="The standard">
                    {rows.map(({ geometry }) => (
                        <StandardChip key={geometry} readings={readings} geometry={geometry} />
                    ))}
                </div>
            )}
            <div class="atlas-axis" aria-hidden="true">
                {ticks(first, last, 5).map((tick) => (
                    <span key={tick} style={{ left: percent(share(tick)) }}>
                        {plain(tick)}
                    </span>
                ))}
            </div>
            <progress
                class={busy ? "" : "done"}
                max={1}
                value={fraction}
                aria-label="Colours of the atlas"
            />
            <Reading
                atlas={atlas}
                place={place}
                unit={unit}
                readings={readings}
                hovers={hover !== null}
            />
        </div>
    );
}

function nearest(values: readonly number[], wanted: number): number {
    let best = 0;
    values.forEach((value, i) => {
        if (Math.abs(value - wanted) < Math.abs((values[best] as number) - wanted)) best = i;
    });
    return best;
}

/** By lamp and angle, as the chips are; each a gradient through its colours. */
function rowsOf({ geometries, rgb }: AtlasMessage) {
    const parts = groups(geometries);
    return parts.flatMap(({ title, places }) =>
        places.map(({ i, label }) => {
            const colours = (rgb[i] ?? []).map(cssOf);
            const stops = colours.length === 1 ? [...colours, ...colours] : colours;
            return {
                geometry: i,
                label: parts.length > 1 ? `${lampOf(title)}${label}` : label,
                background: `linear-gradient(to right, ${stops.join(", ")})`,
            };
        }),
    );
}

/** "Lamp at 45°" before an angle: "45° ". */
function lampOf(title: string): string {
    const lamp = /\d+/.exec(title)?.[0];
    return lamp === undefined ? "" : `${lamp} / `;
}

/** As in the chips: brighter than the display is dimmed, and its hue kept. */
function StandardChip(props: { readonly readings: Readings; readonly geometry: number }): VNode {
    const standard = standardAt(props.readings, props.geometry);
    return <i style={standard === null ? {} : { background: chip(standard).css }} />;
}

function Reading(props: {
    readonly atlas: AtlasMessage;
    readonly place: Place;
    readonly unit: string;
    readonly readings: Readings | null;
    readonly hovers: boolean;
}): VNode {
    const { atlas, place, unit, readings } = props;
    const value = atlas.values[place.column];
    const lab = atlas.lab[place.geometry]?.[place.column];
    const differences = atlas.lab.flatMap((row, i) => {
        const standard = readings === null ? null : standardAt(readings, i);
        const here = row[place.column];
        return standard === null || here === undefined ? [] : [deltaE2000(standard, here)];
    });
    const mean = differences.reduce((sum, x) => sum + x, 0) / differences.length;
    return (
        <p class="atlas-reading" role="status">
            <b>
                {value === undefined ? "" : plain(value)} {unit}
            </b>
            <span>{angleName(atlas.geometries[place.geometry] ?? "")}</span>
            {lab !== undefined && <LabText lab={lab} />}
            {differences.length > 0 && <span>mean ΔE {number(mean, 1)}</span>}
        </p>
    );
}

function LabText({ lab }: { readonly lab: Lab }): VNode {
    return (
        <span>
            L* {number(lab[0], 1)} a* {number(lab[1], 1)} b* {number(lab[2], 1)}
        </span>
    );
}
