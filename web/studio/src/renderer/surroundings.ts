/** Light from all directions, and where most of it comes from. */

import type { Light } from "./paint";

export interface Surroundings {
    readonly width: number;
    readonly height: number;
    /** RGBA, for linear filtering. */
    readonly picture: Float32Array<ArrayBuffer>;
    /** Of each row, the probability of a column up to and with this one: (height, width). */
    readonly byColumn: Float32Array<ArrayBuffer>;
    /** The probability of a row up to and with this one: (height). */
    readonly byRow: Float32Array<ArrayBuffer>;
}

const LARGEST_HALF = 65504;

/**
 * The probability of a direction goes with the luminance there. A texel counts its neighbours as well,
 * of which linear filtering shows some: none that is lit has no probability.
 */
export function surroundings(light: Light): Surroundings {
    const { width, height, rgb } = light;
    const picture = new Float32Array(4 * width * height);
    const luminance = new Float32Array(width * height);
    for (let i = 0; i < width * height; ++i) {
        const [r, g, b] = [0, 1, 2].map((c) =>
            Math.min(rgb[3 * i + c] as number, LARGEST_HALF),
        ) as [number, number, number];
        picture.set([r, g, b, 1], 4 * i);
        luminance[i] = Math.max(0.2126 * r + 0.7152 * g + 0.0722 * b, 0);
    }
    const byColumn = new Float32Array(width * height);
    const byRow = new Float32Array(height);
    const sums = new Float64Array(width);
    let total = 0;
    for (let y = 0; y < height; ++y) {
        let sum = 0;
        for (let x = 0; x < width; ++x) {
            let near = 1e-9;
            for (let v = Math.max(y - 1, 0); v <= Math.min(y + 1, height - 1); ++v) {
                for (const u of [x - 1 + width, x, x + 1]) {
                    near += luminance[v * width + (u % width)] as number;
                }
            }
            sums[x] = sum += near;
        }
        for (let x = 0; x < width; ++x) byColumn[y * width + x] = (sums[x] as number) / sum;
        total += sum * (Math.cos((Math.PI * y) / height) - Math.cos((Math.PI * (y + 1)) / height));
        byRow[y] = total;
    }
    for (let y = 0; y < height; ++y) byRow[y] = (byRow[y] as number) / total;
    return { width, height, picture, byColumn, byRow };
}
