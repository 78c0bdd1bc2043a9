/** The lamps of a light as uniforms of the shader. */

import type { Light } from "./paint";
import type { Value } from "./pass";
import { MOST_RECTANGLES } from "./passes";
import type { Vec3 } from "./space";
import { turnedDirection, turnedPlace } from "./space";

/** @param turn  of the light about the vertical through the pivot, in degrees */
export function lightValues(light: Light, turn: number, pivot: Vec3): Record<string, Value> {
    const { sun, rectangles, azimuth_deg } = light;
    const radians = Math.PI / 180;
    const towards = sun ? turnedDirection(sun.direction, turn) : ([0, 0, 1] as const);
    const radius = sun ? Math.cos(sun.angular_radius_deg * radians) : 2;
    const list = (of: (rectangle: Light["rectangles"][number]) => Vec3): Float32Array => {
        const values = new Float32Array(3 * MOST_RECTANGLES);
        values.set(rectangles.flatMap(of));
        return values;
    };
    return {
        azimuth: (azimuth_deg + turn) * radians,
        sun: [...towards, radius],
        sunRadiance: sun?.rgb ?? [0, 0, 0],
        rectangleCount: rectangles.length,
        corner: list((r) => turnedPlace(r.corner, turn, pivot)),
        edgeU: list((r) => turnedDirection(r.edge_u, turn)),
        edgeV: list((r) => turnedDirection(r.edge_v, turn)),
        rectangleNormal: list((r) => turnedDirection(r.normal, turn)),
        rectangleRadiance: list((r) => r.rgb),
    };
}
