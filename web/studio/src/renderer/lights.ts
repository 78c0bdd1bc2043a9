/** The lamps of a light as uniforms of the shader. */

import type { Program } from "./gl";
import type { Light } from "./paint";
import type { Vec3 } from "./space";
import { turnedDirection, turnedPlace } from "./space";

/** @param turn  of the light about the vertical through the pivot, in degrees */
export function setLight(program: Program, light: Light, turn: number, pivot: Vec3): void {
    const { sun, rectangles, azimuth_deg } = light;
    const radians = Math.PI / 180;
    program.floats("azimuth", 1, [(azimuth_deg + turn) * radians]);
    const towards = sun ? turnedDirection(sun.direction, turn) : ([0, 0, 1] as const);
    const radius = sun ? Math.cos(sun.angular_radius_deg * radians) : 2;
    program.floats("sun", 4, [...towards, radius]);
    program.floats("sunRadiance", 3, sun?.rgb ?? [0, 0, 0]);
    program.int("rectangleCount", rectangles.length);
    if (rectangles.length === 0) return;
    const list = (name: string, of: (k: Light["rectangles"][number]) => Vec3) => {
        program.floats(`${name}[0]`, 3, rectangles.flatMap(of));
    };
    list("corner", (r) => turnedPlace(r.corner, turn, pivot));
    list("edgeU", (r) => turnedDirection(r.edge_u, turn));
    list("edgeV", (r) => turnedDirection(r.edge_v, turn));
    list("rectangleNormal", (r) => turnedDirection(r.normal, turn));
    list("rectangleRadiance", (r) => r.rgb);
}
