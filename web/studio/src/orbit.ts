/** Where a picture is taken from: angles about the middle of the shape. */

import type { ShapeInfo } from "./schema";

/** As the server takes it. */
export interface OrbitCamera {
    /** From +x to +y; -90 is in front. */
    readonly azimuth_deg: number;
    readonly elevation_deg: number;
    readonly distance_mm: number;
    readonly fov_deg: number;
}

export interface Orbit extends OrbitCamera {
    /** The least width over height of a picture for which the field of view is meant. */
    readonly aspect: number;
    /** From the middle, out of the shape's reach whichever way it is turned. */
    readonly nearest_mm: number;
}

const DEGREES = 180 / Math.PI;

/** By which the server leaves room around a shape, and a camera stays before its surface. */
const ROOM = 1.05;
const BEFORE = 1.02;

export function orbitOf(shape: ShapeInfo): Orbit {
    const { position_mm, target_mm, fov_deg, aspect } = shape.camera;
    const [x, y, z] = [0, 1, 2].map(
        (i) => (position_mm[i] as number) - (target_mm[i] as number),
    ) as [number, number, number];
    const distance_mm = Math.hypot(x, y, z);
    // The aspect is that of the shape's greatest reach about the vertical.
    const reach = Math.atan((aspect / ROOM) * Math.tan(fov_deg / 2 / DEGREES));
    return {
        azimuth_deg: Math.atan2(y, x) * DEGREES,
        elevation_deg: Math.asin(z / distance_mm) * DEGREES,
        distance_mm,
        fov_deg,
        aspect,
        nearest_mm: BEFORE * distance_mm * Math.sin(reach),
    };
}

/** With a field of view that shows narrow pictures as much from side to side as others. */
export function fitted(orbit: Orbit, width: number, height: number): OrbitCamera {
    const { azimuth_deg, elevation_deg, distance_mm, fov_deg, aspect } = orbit;
    const wider = Math.max(1, (aspect * height) / width);
    const half = Math.tan(fov_deg / 2 / DEGREES);
    const shown_deg = 2 * DEGREES * Math.atan(half * wider);
    return { azimuth_deg, elevation_deg, distance_mm, fov_deg: shown_deg };
}

const clamp = (value: number, low: number, high: number) => Math.min(Math.max(value, low), high);

/** Turned by so many degrees and brought nearer by a factor. */
export function turned(orbit: Orbit, up_deg: number, nearer = 1): Orbit {
    return {
        ...orbit,
        elevation_deg: clamp(orbit.elevation_deg + up_deg, -85, 85),
        distance_mm: clamp(orbit.distance_mm / nearer, orbit.nearest_mm, 1e5),
    };
}

/** In (-180, 180]. */
export function wrapped(degrees: number): number {
    const turn = ((degrees % 360) + 360) % 360;
    return turn > 180 ? turn - 360 : turn;
}
