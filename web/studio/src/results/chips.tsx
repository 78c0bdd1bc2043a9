/** A chip an angle, its upper half the standard where there is one, on the grey of a light booth. */

import type { VNode } from "preact";
import { Fragment } from "preact";
import type { Lab } from "../../../common/colour";
import { chip } from "../../../common/colour";
import { angleName, number } from "../../../common/dom";
import { byLamp } from "../../../common/geometry";
import { caveatsAt } from "../gamut";
import type { Readings } from "../protocol";
import { isCurrent, isOld } from "../state";
import { useStudioState } from "../ui/context";

interface Group {
    readonly title: string;
    readonly places: readonly { readonly i: number; readonly label: string }[];
}

const OFF_THE_PLANE = "Off the plane";

/** Angles by lamp, from the smallest to the largest, and those off the plane together at the end. */
export function groups(names: readonly string[]): Group[] {
    const result: Group[] = [...byLamp(names)].map(([lamp, angles]) => ({
        title: `Lamp at ${String(lamp)}°`,
        places: angles.map(({ index, aspecular }) => ({
            i: index,
            label: `${number(aspecular, 1).replace(/\.0$/, "")}°`,
        })),
    }));
    const seen = new Set(result.flatMap(({ places }) => places.map(({ i }) => i)));
    const others = names
        .map((name, i) => ({ i, label: angleName(name) }))
        .filter(({ i }) => !seen.has(i));
    if (others.length > 0) result.push({ title: OFF_THE_PLANE, places: others });
    return result;
}

/** Where the standard was read at an angle of this name. */
export function standardAt(readings: Readings, i: number): Lab | null {
    const { standard, geometries } = readings;
    const place = standard?.geometries.indexOf(geometries[i] as string) ?? -1;
    return standard?.lab[place] ?? null;
}

/** The name of an angle, which breaks before its azimuth and after its comma where there is no room. */
export function AngleText({ text }: { readonly text: string }): VNode {
    const parts = text.replace(/az/, " az").replace(/,/, ", ").split(" ");
    return (
        <>
            {parts.map((part, i) => (
                <Fragment key={part}>
                    {i > 0 && <wbr />}
                    {part}
                </Fragment>
            ))}
        </>
    );
}

export function Chips(): VNode {
    const readings = useStudioState((state) => state.readings);
    const old = useStudioState(isOld);
    const current = useStudioState(isCurrent);
    if (readings === null) return <div class="stage chips" aria-busy="true" />;
    const parts = groups(readings.geometries);
    return (
        <div
            class={old ? "stage chips old" : "stage chips"}
            role="group"
            aria-label="Chips"
            data-current={current}
        >
            {readings.standard?.problem !== undefined && (
                <p class="problem">{readings.standard.problem}</p>
            )}
            {parts.map((group) => (
                <section key={group.title} aria-label={group.title}>
                    {parts.length > 1 && <h3>{group.title}</h3>}
                    <ol class={group.title === OFF_THE_PLANE ? "chip-row named" : "chip-row"}>
                        {group.places.map(({ i, label }) => (
                            <Chip key={i} readings={readings} i={i} label={label} />
                        ))}
                    </ol>
                </section>
            ))}
        </div>
    );
}

function Chip({ readings, i, label }: { readings: Readings; i: number; label: string }): VNode {
    const lab = readings.lab[i] as Lab;
    const standard = standardAt(readings, i);
    const versus = readings.standard;
    const difference = versus?.delta_e_2000?.[i];
    const passes = versus?.passes?.[i];
    const caveats = caveatsAt(readings, i);
    const numbers = `L* ${number(lab[0], 2)}, a* ${number(lab[1], 2)}, b* ${number(lab[2], 2)}`;
    return (
        <li
            class="chip"
            data-geometry={readings.geometries[i]}
            data-lab={lab.join(" ")}
            title={[
                angleName(readings.geometries[i] as string),
                numbers,
                ...caveats.map(({ means }) => means),
            ].join("\n")}
        >
            <div class="faces">
                {standard !== null && <i style={{ background: chip(standard).css }} />}
                <i style={{ background: chip(lab).css }} />
                <span class="marks">
                    {caveats.map(({ mark, means }) => (
                        <abbr key={mark} title={means} aria-label={means}>
                            {mark}
                        </abbr>
                    ))}
                </span>
            </div>
            <b>
                <AngleText text={label} />
            </b>
            <span class="lightness">
                <span class="hidden">L* </span>
                {number(lab[0], 1)}
            </span>
            {versus !== null && (
                <span class={passes === false ? "delta fails" : "delta"}>
                    <span class="hidden">Delta E </span>
                    {number(difference, 2)}
                    {passes === false && <abbr title="beyond the tolerance"> ✗</abbr>}
                    {passes === true && <abbr title="within the tolerance"> ✓</abbr>}
                </span>
            )}
        </li>
    );
}
