/** L* over the aspecular angle, and the way of the colour through a* and b*. */

import type { VNode } from "preact";
import { useMemo } from "preact/hooks";
import type { Lab } from "../../../common/colour";
import { chip } from "../../../common/colour";
import { byLamp } from "../../../common/geometry";
import type { Curve } from "../../../common/plots";
import { plot } from "../../../common/plots";
import type { Colours, Readings } from "../protocol";
import { useStudioState } from "../ui/context";
import { Made } from "../ui/element";

const WIDTH = 340;

/** The range of an axis in steps, so that it stays where it is while a slider moves. */
function stepped(values: readonly number[], step: number): [number, number] {
    const low = Math.floor(Math.min(...values) / step) * step;
    const high = Math.ceil(Math.max(...values) / step) * step;
    return [low, Math.max(high, low + step)];
}

function curvesOf(
    colours: Colours,
    dashed: boolean,
    x: (lab: Lab, degrees: number) => number,
    y: (lab: Lab) => number,
): Curve[] {
    return [...byLamp(colours.geometries)].map(([lamp, angles]) => {
        const labs = angles.map(({ index }) => colours.lab[index] as Lab);
        const curve: Curve = {
            x: labs.map((lab, i) => x(lab, angles[i]?.aspecular ?? 0)),
            y: labs.map(y),
            colour: "var(--line)",
            label: `${String(lamp)}°${dashed ? " std" : ""}`,
            dashed,
        };
        return dashed ? curve : { ...curve, pointColours: labs.map((lab) => chip(lab).css) };
    });
}

function both(
    readings: Readings,
    x: (lab: Lab, degrees: number) => number,
    y: (lab: Lab) => number,
): Curve[] {
    const standard = readings.standard;
    return [
        ...(standard === null ? [] : curvesOf(standard, true, x, y)),
        ...curvesOf(readings, false, x, y),
    ];
}

export function Flop(): VNode | null {
    const readings = useStudioState((state) => state.details);
    const plots = useMemo(() => {
        if (readings === null) return null;
        const lightness = both(
            readings,
            (_, degrees) => degrees,
            (lab) => lab[0],
        );
        const travel = both(
            readings,
            (lab) => lab[1],
            (lab) => lab[2],
        );
        const against = readings.standard === null ? "" : "; the standard dashed";
        const degrees = stepped(
            lightness.flatMap(({ x }) => [...x]),
            15,
        );
        const top = stepped([...lightness.flatMap(({ y }) => [...y]), 99], 25)[1];
        const a = stepped(
            travel.flatMap(({ x }) => [...x]),
            20,
        );
        const b = stepped(
            travel.flatMap(({ y }) => [...y]),
            20,
        );
        return [
            plot(lightness, {
                width: WIDTH,
                height: 158,
                xLabel: "Aspecular angle, °",
                yLabel: "L*",
                named: lightness.length > 1,
                x: degrees,
                y: [0, top],
                describedAs: `Lightness over the aspecular angle${against}`,
            }),
            plot(travel, {
                width: WIDTH,
                height: 226,
                xLabel: "a*",
                yLabel: "b*",
                x: a,
                y: b,
                square: true,
                describedAs: `The way of the colour through a* and b*${against}`,
            }),
        ];
    }, [readings]);
    if (plots === null) return null;
    return (
        <>
            {plots.map((element, i) => (
                <Made key={i} element={element} />
            ))}
        </>
    );
}
