/** Geometries by their names, as `nacre measure` writes them: "45as15", "45as25az90", "45to30,90". */

import type { Lab } from "./colour";
import { chip } from "./colour";

export interface Geometry {
    readonly name: string;
    /** NaN where the name is a word. */
    readonly lamp: number;
    /** Angle from the mirror direction in the lamp's plane; null out of the plane. */
    readonly aspecular: number | null;
}

export function geometry(name: string): Geometry {
    const angles = /^([\d.]+)as(-?[\d.]+)(az-?[\d.]+)?$/.exec(name);
    if (angles === null) {
        const lamp = /^([\d.]+)to/.exec(name);
        return { name, lamp: lamp === null ? NaN : Number(lamp[1]), aspecular: null };
    }
    const inPlane = angles[3] === undefined;
    return { name, lamp: Number(angles[1]), aspecular: inPlane ? Number(angles[2]) : null };
}

export interface Angle {
    /** Place in the set of geometries. */
    readonly index: number;
    readonly lamp: number;
    readonly aspecular: number;
}

/** The angles in the plane by lamp, each from the smallest aspecular angle to the largest. */
export function byLamp(names: readonly string[]): Map<number, Angle[]> {
    const lamps = new Map<number, Angle[]>();
    names.forEach((name, index) => {
        const { lamp, aspecular } = geometry(name);
        if (aspecular === null) return;
        const angles = lamps.get(lamp) ?? [];
        angles.push({ index, lamp, aspecular });
        lamps.set(lamp, angles);
    });
    for (const angles of lamps.values()) angles.sort((a, b) => a.aspecular - b.aspecular);
    return lamps;
}

/** The lamp that was read at most angles; of two, the one nearest to 45 degrees. */
export function mainAngles(names: readonly string[]): readonly Angle[] {
    const sets = [...byLamp(names).values()];
    const tilt = (angles: Angle[]) => Math.abs((angles[0]?.lamp ?? 0) - 45);
    sets.sort((a, b) => b.length - a.length || tilt(a) - tilt(b));
    return sets[0] ?? [];
}

function mixed(from: Lab, to: Lab, share: number): Lab {
    const at = (c: 0 | 1 | 2) => from[c] + share * (to[c] - from[c]);
    return [at(0), at(1), at(2)];
}

/**
 * A gradient over the aspecular angle, from the smallest at the left to the largest at the right;
 * L*a*b* is linear between the angles that were read.
 */
export function ramp(angles: readonly Angle[], labAt: (index: number) => Lab): string {
    const first = angles[0];
    const last = angles[angles.length - 1];
    if (first === undefined || last === undefined) return "none";
    const width = last.aspecular - first.aspecular;
    const stops: string[] = [];
    const stop = (lab: Lab, degrees: number) => {
        const place = width > 0 ? (100 * (degrees - first.aspecular)) / width : 0;
        stops.push(`${chip(lab).css} ${place.toFixed(1)}%`);
    };
    angles.forEach((angle, i) => {
        const lab = labAt(angle.index);
        const before = angles[i - 1];
        if (before !== undefined) {
            const steps = 4; // sRGB is not linear in between
            for (let k = 1; k < steps; ++k) {
                const share = k / steps;
                const degrees = before.aspecular + share * (angle.aspecular - before.aspecular);
                stop(mixed(labAt(before.index), lab, share), degrees);
            }
        }
        stop(lab, angle.aspecular);
    });
    if (stops.length === 1) stops.push(stops[0] as string);
    return `linear-gradient(to right, ${stops.join(", ")})`;
}
