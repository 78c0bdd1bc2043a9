/**
 * The live picture against the path tracer's: the colours of a ball.
 *
 * In pictures of 48 pixels each holds some thousands of flakes, of which the path tracer shows every one
 * and the live picture, told to leave them out, the mean.
 */

import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import type { Lab } from "../../common/colour";
import { deltaE2000 } from "../../common/colour";
import { LiveBrowser } from "./live_browser";

/** Paints in a studio's daylight, and two in the booth's other lamps, to which the eye adapts. */
const SCENES = [
    ...["red-gold", "metallic-silver", "white", "ruby", "green-violet"].map((paint) => ({
        paint,
        light: "studio",
    })),
    { paint: "red-gold", light: "booth-a" },
    { paint: "green-violet", light: "booth-fl11" },
];
const SIZE = 48;
const SAMPLES = 64;
const TRACED_SAMPLES = 256;

let browser: LiveBrowser;

before(async () => {
    browser = await LiveBrowser.start();
});

after(() => browser.end());

/** From linear Rec. 709, relative to its white [cie-15-2018]. */
function labOf(rgb: ArrayLike<number>): Lab {
    const rows = [
        [0.4124564, 0.3575761, 0.1804375],
        [0.2126729, 0.7151522, 0.072175],
        [0.0193339, 0.119192, 0.9503041],
    ];
    const [x, y, z] = rows.map((row) => {
        const dot = (values: ArrayLike<number>) =>
            row.reduce((sum, weight, c) => sum + weight * (values[c] ?? 0), 0);
        const t = dot(rgb) / dot([1, 1, 1]);
        return t > (6 / 29) ** 3 ? Math.cbrt(t) : (t * (29 / 6) ** 2) / 3 + 4 / 29;
    }) as [number, number, number];
    return [116 * y - 16, 500 * (x - y), 200 * (y - z)];
}

/** Whether a pixel is wholly on the ball, which covers 65 % of the picture. */
function onBall(at: number): boolean {
    const [x, y] = [(at % SIZE) + 0.5 - SIZE / 2, Math.floor(at / SIZE) + 0.5 - SIZE / 2];
    return Math.hypot(x, y) < 0.42 * SIZE;
}

for (const { paint, light } of SCENES) {
    test(`${paint} on a ball in the light ${light} has the path tracer's colours`, async () => {
        const scene = { paint, shape: "ball", light, size: SIZE };
        const live = await browser.page.evaluate(
            ([where, samples]) => window.live(where, samples, false),
            [scene, SAMPLES] as const,
        );
        const traced = await browser.page.evaluate(
            ([where, samples]) => window.traced(where, samples, 0),
            [scene, TRACED_SAMPLES] as const,
        );
        let [sum, count] = [0, 0];
        for (let at = 0; at < SIZE * SIZE; ++at) {
            if (!onBall(at)) continue;
            sum += deltaE2000(
                labOf(traced.data.slice(3 * at, 3 * at + 3)),
                labOf(live.data.slice(4 * at, 4 * at + 3)),
            );
            ++count;
        }
        assert.ok(count > 1000);
        console.log(
            `${paint}, ${light}: Delta E 2000 ${(sum / count).toFixed(2)}, mean over the ball`,
        );
        assert.ok(sum / count < 2);
    });
}

test("what a slider shows first has the whole picture's light, without grain", async () => {
    const [size, block, samples] = [480, 40, 4];
    const { coarseness, first, whole } = await browser.page.evaluate(
        ([where, count, path]) => window.moved(where, count, path, 0.5, false),
        [
            { paint: "red-gold", shape: "ball", light: "studio", size },
            samples,
            ["substrate", "reflectance"],
        ] as const,
    );
    /** Mean luminance of a block, as far as a screen shows it. */
    const meanOf = ({ data }: typeof whole, column: number, row: number): number => {
        let sum = 0;
        for (let y = row; y < row + block; ++y) {
            for (let x = column; x < column + block; ++x) {
                [0.2126, 0.7152, 0.0722].forEach((weight, c) => {
                    sum += weight * Math.min(Math.max(data[4 * (size * y + x) + c] ?? 0, 0), 1);
                });
            }
        }
        return sum / block ** 2;
    };
    const apart: number[] = [];
    const light: number[] = [];
    for (let row = 0; row < size; row += block) {
        for (let column = 0; column < size; column += block) {
            const far = Math.hypot(column + block / 2 - size / 2, row + block / 2 - size / 2);
            if (far > 0.36 * size) continue;
            light.push(meanOf(whole, column, row));
            apart.push(meanOf(first, column, row) - meanOf(whole, column, row));
        }
    }
    const mean = (values: readonly number[]) => values.reduce((a, b) => a + b, 0) / values.length;
    const grain = Math.sqrt(mean(apart.map((x) => x ** 2))) / mean(light);
    const shift = mean(apart) / mean(light);
    console.log(
        `a slider's first picture, ${String(coarseness)} times coarser: ${(100 * grain).toFixed(1)} % from the whole one, ${(100 * shift).toFixed(1)} % on average`,
    );
    if (coarseness === 1) return; // a machine that draws the whole picture at once
    // Each pixel by itself: 17 to 22 % and -5 to -10 %, as screens show no more than white.
    assert.ok(Math.abs(shift) < 0.06);
    assert.ok(grain < 0.145);
});

test("before flakes are drawn, which takes long, the mean is seen in every pixel", async () => {
    const size = 320;
    const scene = { paint: "red-gold", shape: "ball", light: "studio", size };
    const { coarse, fine } = await browser.page.evaluate(
        (where) => window.beforeFlakes(where),
        scene,
    );
    if (coarse === null) return; // a machine that draws flakes at once
    const whole = await browser.page.evaluate((where) => window.live(where, 32, false), scene);
    /** Around the rim of the ball, which in a coarse picture is as wide as its pixels. */
    const apart = ({ data }: typeof whole): number => {
        let [sum, light] = [0, 0];
        for (let at = 0; at < size * size; ++at) {
            const far = Math.hypot((at % size) - size / 2, Math.floor(at / size) - size / 2);
            if (far < 0.4 * size || far > 0.5 * size) continue;
            const wanted = Math.min(whole.data[4 * at + 1] ?? 0, 1);
            sum += ((data[4 * at + 1] ?? 0) - wanted) ** 2;
            light += wanted ** 2;
        }
        return Math.sqrt(sum / light);
    };
    const [before, after] = [apart(coarse), apart(fine)];
    console.log(
        `the rim before flakes: ${(100 * before).toFixed(1)} % from the whole, then ${(100 * after).toFixed(1)} %`,
    );
    assert.ok(after < 0.8 * before);
});
