/**
 * Single flakes in the live picture: which of them a sample draws from.
 *
 * The paint's text finds the flakes on a patch of the surface and what they reflect
 * (src/nacre/exchange/webgl_flakes.glsl); here the pixel is divided into patches, as the path tracer
 * does it (FlakeStrata in src/nacre/render/render.cpp).
 */

import type { Transform } from "./paint";
import type { Value } from "./pass";
import type { Matrix, Vec3 } from "./space";
import { inverseRigid, shapeMatrix } from "./space";

/** Samples of a pixel between which its flakes are divided: the first ones, so that each is sampled once. */
const STRATA = 16;
/** Of the samples after them, one of so many draws from flakes again. */
const FEWER = 4;
const SIDE = Math.sqrt(STRATA);

/** Of a pixel about its middle, in pixels; x to the right and y up. */
export interface Stratum {
    /** Where the sample looks: anywhere in the stratum. */
    readonly place: readonly [number, number];
    readonly middle: readonly [number, number];
    readonly size: readonly [number, number];
    /** How much more than the mean weight what lies at the far ends has. */
    readonly tilt: readonly [number, number];
}

/** A tent of half-width 1 about 0, from a number in [0, 1). */
const tent = (u: number): number =>
    u < 0.5 ? Math.sqrt(2 * u) - 1 : 1 - Math.sqrt(Math.max(2 - 2 * u, 0));

/** One of SIDE sides of equal weight. @param within  in [0, 1) */
function sideOf(index: number, within: number): readonly [number, number, number, number] {
    const [begin, end] = [tent(index / SIDE), tent((index + 1) / SIDE)];
    const [middle, length] = [0.5 * (begin + end), end - begin];
    const fall = (0.5 * length) / (1 - Math.abs(middle));
    return [tent((index + within) / SIDE), middle, length, middle < 0 ? fall : -fall];
}

/** Whether a sample draws from flakes, and where it looks. @param shown  flakes are */
export function sampleOf(sample: number, shown: boolean): { sampled: boolean; stratum: Stratum } {
    if (!shown) return { sampled: false, stratum: stratumOf(sample) };
    const sampled = sample < STRATA || sample % FEWER === 0;
    const before = Math.min(sample, STRATA) + Math.ceil(Math.max(sample - STRATA, 0) / FEWER);
    // Those that draw from flakes take all strata in turn, and so do the others.
    return { sampled, stratum: stratumOf(sampled ? before : sample - before) };
}

/** The strata that follow each other are far apart. */
function stratumOf(index: number): Stratum {
    const [round, number] = [Math.floor(index / STRATA), index % STRATA];
    // Bits of the number, turned round and dealt out to columns and rows.
    const bit = (k: number): number => (number >> k) & 1;
    const column = 2 * bit(0) + bit(2);
    const row = 2 * (bit(0) ^ bit(1)) + (bit(2) ^ bit(3));
    // Places that fill the stratum evenly.
    const x = sideOf(column, (round * 0.7548776662 + 0.5) % 1);
    const y = sideOf(row, (round * 0.569840291 + 0.5) % 1);
    return {
        place: [x[0], y[0]],
        middle: [x[1], y[1]],
        size: [x[2], y[2]],
        tilt: [x[3], y[3]],
    };
}

/** From the world to the millimetres of the shape before it was turned and moved. */
export function restMatrix(transform: Transform, turn_deg: number, pivot: Vec3): Matrix {
    return inverseRigid(shapeMatrix({ ...transform, scale: 1 }, turn_deg, pivot));
}

/** Uniforms of the text below. @param toRest  restMatrix() */
export function flakeValues(
    toRest: Matrix,
    { middle, size, tilt }: Stratum,
    shown: boolean,
    sampled: boolean,
): Record<string, Value> {
    return {
        flakesShown: shown ? 1 : 0,
        flakesSampled: sampled ? 1 : 0,
        toRest,
        stratumMiddle: middle,
        stratumSize: size,
        stratumTilt: tilt,
    };
}

/** After the paint's text, and after radianceFrom(). */
export const FLAKES = `
#ifdef NACRE_FLAKES
uniform bool flakesShown;
uniform bool flakesSampled;
uniform mat4 toRest;
uniform vec2 stratumMiddle;  // in pixels, from the middle of this one
uniform vec2 stratumSize;
uniform vec2 stratumTilt;

vec3 lookedAtFrom;
mat3 lookedAtFrame;
vec3 nacreRadiance(vec3 wo) {
    float ignored;
    return radianceFrom(lookedAtFrom, lookedAtFrame * wo, ignored);
}

/// What the stratum of a pixel covers of the surface, which is flat there.
NacrePatch patchOn(vec3 place, mat3 toWorld) {
    vec3 n = toWorld[2], q = place - eye;
    float depth = dot(q, ahead);
    q /= depth;
    float facing = dot(n, q);
    if (abs(facing) < 1e-6) facing = -1e-6;
    vec3 stepX = across * (2. / size.x), stepY = upwards * (2. / size.y);
    vec3 edgeX = depth * (stepX - q * (dot(n, stepX) / facing));
    vec3 edgeY = depth * (stepY - q * (dot(n, stepY) / facing));
    vec2 from = stratumMiddle - shift;
    vec3 middle = place + from.x * edgeX + from.y * edgeY;
    mat3 turn = mat3(toRest);
    return NacrePatch((toRest * vec4(middle, 1.)).xyz, normalize(turn * n), normalize(turn * toWorld[0]),
                      stratumSize.x * (turn * edgeX), stratumSize.y * (turn * edgeY), stratumTilt);
}

vec3 shadedFlakes(vec3 place, mat3 toWorld, vec3 wi, vec3 towardsSun) {
    if (!flakesShown) {
        nacreShowNone();
        nacreSunResolved = nacreResolved;
        return vec3(0.);
    }
    lookedAtFrom = place;
    lookedAtFrame = toWorld;
    float angle = 2. * PI * (1. - sun.w);
    return nacreFlakes(patchOn(place, toWorld), flakesSampled, wi, towardsSun, sunRadiance * angle, angle,
                       mixBits(pixelBits ^ (sampleIndex * 0x9e3779b9u)));
}
#else
const bool flakesSampled = false;
vec3 shadedFlakes(vec3 place, mat3 toWorld, vec3 wi, vec3 towardsSun) { return vec3(0.); }
void nacreWithoutSunlit() {}
#endif
`;
