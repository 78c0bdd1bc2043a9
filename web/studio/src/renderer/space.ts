/** Places and turns, in the world of docs/scene.md: right-handed, z up, millimetres. */

import type { Transform } from "./paint";

export type Vec3 = readonly [number, number, number];
/** Column by column, as WebGL has them. */
export type Matrix = Float32Array;

const RADIANS = Math.PI / 180;

export const add = (a: Vec3, b: Vec3): Vec3 => [a[0] + b[0], a[1] + b[1], a[2] + b[2]];
export const minus = (a: Vec3, b: Vec3): Vec3 => [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
export const times = (s: number, a: Vec3): Vec3 => [s * a[0], s * a[1], s * a[2]];
export const cross = (a: Vec3, b: Vec3): Vec3 => [
    a[1] * b[2] - a[2] * b[1],
    a[2] * b[0] - a[0] * b[2],
    a[0] * b[1] - a[1] * b[0],
];
export const normalized = (a: Vec3): Vec3 => times(1 / Math.hypot(...a), a);

export function multiplied(a: Matrix, b: Matrix): Matrix {
    const out = new Float32Array(16);
    for (let column = 0; column < 4; ++column) {
        for (let row = 0; row < 4; ++row) {
            let sum = 0;
            for (let k = 0; k < 4; ++k) {
                sum += (a[4 * k + row] as number) * (b[4 * column + k] as number);
            }
            out[4 * column + row] = sum;
        }
    }
    return out;
}

/** About the axis x, y or z, which are 0, 1 and 2. */
function turnMatrix(axis: 0 | 1 | 2, angle_deg: number): Matrix {
    const out = scaleMatrix(1);
    const [cos, sin] = [Math.cos(angle_deg * RADIANS), Math.sin(angle_deg * RADIANS)];
    const [i, j] = [(axis + 1) % 3, (axis + 2) % 3];
    out[5 * i] = out[5 * j] = cos;
    out[4 * i + j] = sin;
    out[4 * j + i] = -sin;
    return out;
}

function scaleMatrix(s: number): Matrix {
    return new Float32Array([s, 0, 0, 0, 0, s, 0, 0, 0, 0, s, 0, 0, 0, 0, 1]);
}

function moveMatrix(by: Vec3): Matrix {
    const out = scaleMatrix(1);
    out.set(by, 12);
    return out;
}

/** From a shape to the world, then turned about the vertical through a place. */
export function shapeMatrix(transform: Transform, turn_deg: number, pivot: Vec3): Matrix {
    const [x, y, z] = transform.rotation_deg;
    return [
        turnedAbout(pivot, turn_deg),
        moveMatrix(transform.translation_mm),
        turnMatrix(2, z),
        turnMatrix(1, y),
        turnMatrix(0, x),
        scaleMatrix(transform.scale),
    ].reduce(multiplied);
}

/** Of a matrix that turns and moves. */
export function inverseRigid(m: Matrix): Matrix {
    const out = scaleMatrix(1);
    for (let row = 0; row < 3; ++row) {
        let moved = 0;
        for (let k = 0; k < 3; ++k) {
            const turn = m[4 * row + k] as number;
            out[4 * k + row] = turn;
            moved -= turn * (m[12 + k] as number);
        }
        out[12 + row] = moved;
    }
    return out;
}

function turnedAbout(pivot: Vec3, turn_deg: number): Matrix {
    return [moveMatrix(pivot), turnMatrix(2, turn_deg), moveMatrix(times(-1, pivot))].reduce(
        multiplied,
    );
}

/** A direction turned about the vertical. */
export function turnedDirection(w: Vec3, turn_deg: number): Vec3 {
    const [cos, sin] = [Math.cos(turn_deg * RADIANS), Math.sin(turn_deg * RADIANS)];
    return [cos * w[0] - sin * w[1], sin * w[0] + cos * w[1], w[2]];
}

export const turnedPlace = (at: Vec3, turn_deg: number, pivot: Vec3): Vec3 =>
    add(pivot, turnedDirection(minus(at, pivot), turn_deg));

/** A camera by angles about what it looks at. */
export interface Camera {
    readonly target_mm: Vec3;
    /** From +x to +y; -90 is in front. */
    readonly azimuth_deg: number;
    readonly elevation_deg: number;
    readonly distance_mm: number;
    /** From bottom to top. */
    readonly fov_deg: number;
}

export interface Eye {
    readonly place: Vec3;
    /** To the middle of the picture, to its right edge from there, and to its top. */
    readonly ahead: Vec3;
    readonly across: Vec3;
    readonly upwards: Vec3;
}

export function eyeOf(camera: Camera, aspect: number): Eye {
    const [azimuth, elevation] = [camera.azimuth_deg * RADIANS, camera.elevation_deg * RADIANS];
    const out: Vec3 = [
        Math.cos(elevation) * Math.cos(azimuth),
        Math.cos(elevation) * Math.sin(azimuth),
        Math.sin(elevation),
    ];
    const ahead = times(-1, out);
    const right = normalized(cross(ahead, [0, 0, 1]));
    const half = Math.tan(0.5 * camera.fov_deg * RADIANS);
    return {
        place: add(camera.target_mm, times(camera.distance_mm, out)),
        ahead,
        across: times(half * aspect, right),
        upwards: times(half, cross(right, ahead)),
    };
}

/** To the screen. @param shift in the picture, whose edges are at -1 and 1 */
export function screenMatrix(
    eye: Eye,
    distance_mm: number,
    shift: readonly [number, number],
): Matrix {
    const [near, far] = [0.1 * distance_mm, 10 * distance_mm];
    const rows = [eye.across, eye.upwards].map((v) =>
        times(1 / (v[0] ** 2 + v[1] ** 2 + v[2] ** 2), v),
    );
    const [x, y] = rows as [Vec3, Vec3];
    const { ahead, place } = eye;
    const depth = (far + near) / (far - near);
    const view = (v: Vec3, by: Vec3): number => v[0] * by[0] + v[1] * by[1] + v[2] * by[2];
    const out = new Float32Array(16);
    const fill = (row: number, v: Vec3, constant: number) => {
        for (let k = 0; k < 3; ++k) out[4 * k + row] = v[k] as number;
        out[12 + row] = constant - view(v, place);
    };
    fill(0, add(x, times(shift[0], ahead)), 0);
    fill(1, add(y, times(shift[1], ahead)), 0);
    fill(2, times(depth, ahead), (-2 * far * near) / (far - near));
    fill(3, ahead, 0);
    return out;
}
