/**
 * Single flakes in the live picture: the same as the path tracer's, at the same places.
 */

import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import COLOURS from "./flake_colours.json";
import HASHES from "./flake_hash.json";
import LEVELS from "./flake_levels.json";
import { LiveBrowser } from "./live_browser";
import type { LivePicture, Scene } from "./live_page";

/** A quarter of them draw from flakes, in the same strata of a pixel as the live picture's first sixteen. */
const TRACED_SAMPLES = 64;

let browser: LiveBrowser;

before(async () => {
    browser = await LiveBrowser.start();
});

after(() => browser.end());

test("the shader hashes flakes to the program's integers", async () => {
    const got = await browser.page.evaluate(
        (cases) => window.hashes("metallic-silver", cases),
        HASHES,
    );
    assert.deepEqual(
        got,
        HASHES.map(({ cell, place, kind, body }) => [cell, place, kind, body]),
    );
});

test("the shader gives single flakes the path tracer's colours", async () => {
    const got = await browser.page.evaluate(
        (cases) => window.flakeColours("red-gold", cases),
        COLOURS,
    );
    assert.ok(COLOURS.length > 16);
    const of = (rgb: readonly number[]) => rgb.map((x) => x / rgb.reduce((sum, y) => sum + y, 0));
    let [worst, farthest] = [0, 0];
    COLOURS.forEach(({ rgb }, k) => {
        const mine = got[k] as number[];
        const largest = Math.max(...rgb);
        rgb.forEach((want, c) => {
            worst = Math.max(worst, Math.abs((mine[c] as number) - want) / largest);
            const other = of((COLOURS[0] as { rgb: number[] }).rgb)[c] as number;
            farthest = Math.max(farthest, Math.abs((of(rgb)[c] as number) - other));
        });
    });
    console.log(`single flakes: within ${(100 * worst).toFixed(2)} % of their brightest component`);
    // By sixteen wavelengths in place of 31, and half floats (kShaderError of webgl_shader_test.cpp).
    assert.ok(worst < 0.02);
    assert.ok(farthest > 0.1);
});

test("the shader resolves as many flakes as the program", async () => {
    const got = await browser.page.evaluate(
        (cases) => window.flakeLevels("red-gold", cases),
        LEVELS,
    );
    LEVELS.forEach(({ resolved, widening }, k) => {
        const mine = got[k] as { resolved: number; widening: number };
        assert.ok(Math.abs(mine.resolved - resolved) < 1e-4, `resolved, case ${String(k)}`);
        assert.ok(Math.abs(mine.widening - widening) < 1e-4 * widening, `case ${String(k)}`);
    });
});

/** ln of the luminance, less its mean over the neighbourhood: what glitters. */
function glitter({ data, width, height }: LivePicture): number[] {
    const channels = data.length / (width * height);
    const logs = Array.from({ length: width * height }, (_, pixel) => {
        const from = channels * pixel;
        const [r = 0, g = 0, b = 0] = data.slice(from, from + 3);
        return Math.log(0.01 + Math.max(0.2126 * r + 0.7152 * g + 0.0722 * b, 0));
    });
    const at = (x: number, y: number): number => logs[y * width + x] as number;
    const reach = 4;
    const inside = (k: number, size: number): number => Math.min(Math.max(k, 0), size - 1);
    return Array.from({ length: width * height }, (_, pixel) => {
        const [x, y] = [pixel % width, Math.floor(pixel / width)];
        let sum = 0;
        for (let v = y - reach; v <= y + reach; ++v) {
            for (let u = x - reach; u <= x + reach; ++u) {
                sum += at(inside(u, width), inside(v, height));
            }
        }
        return at(x, y) - sum / (2 * reach + 1) ** 2;
    });
}

function correlation(a: readonly number[], b: readonly number[]): number {
    const mean = (list: readonly number[]) => list.reduce((sum, x) => sum + x, 0) / list.length;
    const [ma, mb] = [mean(a), mean(b)];
    const product = (p: readonly number[], mp: number, q: readonly number[], mq: number) =>
        p.reduce((sum, x, k) => sum + (x - mp) * ((q[k] as number) - mq), 0);
    return product(a, ma, b, mb) / Math.sqrt(product(a, ma, a, ma) * product(b, mb, b, mb));
}

/** Of the brightest fiftieth of the pixels of one, the part that is among those of the other. */
function shared(a: readonly number[], b: readonly number[]): number {
    const brightest = (list: readonly number[]) =>
        list
            .map((_, k) => k)
            .sort((k, l) => (list[l] as number) - (list[k] as number))
            .slice(0, Math.floor(list.length / 50));
    const others = new Set(brightest(b));
    return brightest(a).filter((k) => others.has(k)).length / others.size;
}

interface Expectation {
    readonly name: string;
    readonly scene: Scene;
    readonly samples: number;
    /** Of glitter with that of the same specimen. */
    readonly correlation: number;
    readonly shared: number;
}

const EXPECTED: readonly Expectation[] = [
    {
        name: "single flakes of two millimetres",
        scene: { paint: "flat metallic-silver", shape: "macro", light: "microscope", size: 64 },
        samples: 16,
        correlation: 0.85,
        shared: 0.6,
    },
    {
        // Lobes of more flakes overlap: less contrast, over as much noise.
        name: "single wavy flakes under a rough coat",
        scene: { paint: "satin-silver", shape: "macro", light: "microscope", size: 64 },
        samples: 16,
        correlation: 0.6,
        shared: 0.2,
    },
    {
        name: "the glitter of a ball in the sun",
        scene: { paint: "flat metallic-silver", shape: "ball", light: "sun", size: 96 },
        samples: 24,
        correlation: 0.65,
        shared: 0.5,
    },
];

for (const { name, scene, samples, ...least } of EXPECTED) {
    test(`${name} are the path tracer's`, async () => {
        const live = await browser.page.evaluate(
            ([where, count]) => window.live(where, count, true),
            [scene, samples] as const,
        );
        const traced = await Promise.all(
            [0, 1].map((specimen) =>
                browser.page.evaluate(
                    ([where, count, which]) => window.traced(where, count, which),
                    [scene, TRACED_SAMPLES, specimen] as const,
                ),
            ),
        );
        const own = glitter(live);
        const glitters = traced.map(glitter) as [number[], number[]];
        const [same, other] = glitters.map((theirs) => ({
            correlation: correlation(own, theirs),
            shared: shared(own, theirs),
        })) as [
            Pick<Expectation, "correlation" | "shared">,
            Pick<Expectation, "correlation" | "shared">,
        ];
        // The rim of a highlight is in all pictures; what else another specimen shares with this one is chance.
        const common = correlation(...glitters);
        const apart =
            (other.correlation - same.correlation * common) /
            Math.sqrt((1 - same.correlation ** 2) * (1 - common ** 2));
        console.log(
            `${name}: specimens correlate by ${common.toFixed(3)}, apart from that by ${apart.toFixed(3)}`,
        );
        for (const [of, found] of [
            ["the same specimen", same],
            ["another", other],
        ] as const) {
            console.log(
                `${name}, ${of}: correlation ${found.correlation.toFixed(3)}, ` +
                    `brightest pixels shared ${found.shared.toFixed(2)}`,
            );
        }
        assert.ok(same.correlation > least.correlation);
        assert.ok(same.shared > least.shared);
        assert.ok(Math.abs(apart) < 0.2);
        assert.ok(other.shared < 0.5 * same.shared);
    });
}

/**
 * What a colour is beside its brightness, less its mean over the neighbourhood: red over green and blue over
 * both, of bright pixels alone, where it is no noise.
 */
function hues({ data, width, height }: LivePicture, bright: readonly boolean[]): number[] {
    const channels = data.length / (width * height);
    return [0, 1].flatMap((which) => {
        const values = Array.from({ length: width * height }, (_, pixel) => {
            const [r = 0, g = 0, b = 0] = data
                .slice(channels * pixel, channels * pixel + 3)
                .map((x) => Math.max(x, 0));
            const sum = r + g + b + 1e-6;
            return which === 0 ? (r - g) / sum : (b - 0.5 * (r + g)) / sum;
        });
        const kept = values.filter((_, pixel) => bright[pixel]);
        const mean = kept.reduce((sum, x) => sum + x, 0) / kept.length;
        return kept.map((x) => x - mean);
    });
}

/** The pixels above the median of a picture. */
function brightOf({ data, width, height }: LivePicture): boolean[] {
    const channels = data.length / (width * height);
    const light = Array.from({ length: width * height }, (_, pixel) =>
        data.slice(channels * pixel, channels * pixel + 3).reduce((sum, x) => sum + x, 0),
    );
    const median = [...light].sort((a, b) => a - b)[Math.floor(light.length / 2)] as number;
    return light.map((x) => x > median);
}

test("single flakes have the path tracer's hues", async () => {
    const scene = { paint: "red-gold", shape: "macro", light: "microscope", size: 64 };
    const live = await browser.page.evaluate((where) => window.live(where, 64, true), scene);
    const traced = await Promise.all(
        [0, 1].map((specimen) =>
            browser.page.evaluate(([where, which]) => window.traced(where, 256, which), [
                scene,
                specimen,
            ] as const),
        ),
    );
    const bright = brightOf(live);
    const own = hues(live, bright);
    const [same = 0, other = 0] = traced.map((picture) => correlation(own, hues(picture, bright)));
    console.log(`hues: correlation ${same.toFixed(3)}, of another specimen ${other.toFixed(3)}`);
    assert.ok(same > 0.8);
    assert.ok(other < 0.3);
});

test("flakes stay in sight while a slider moves what lies around them", async () => {
    const scene = { paint: "red-gold", shape: "macro", light: "microscope", size: 96 };
    const key = ["substrate", "reflectance"];
    const { coarseness, first, whole } = await browser.page.evaluate(
        ([where, path]) => window.moved(where, 16, path, 0.5, true),
        [scene, key] as const,
    );
    const found = correlation(glitter(first), glitter(whole));
    console.log(
        `a slider's first picture, ${String(coarseness)} times coarser: glitter correlates by ${found.toFixed(3)}`,
    );
    assert.ok(found > 0.5);
});
