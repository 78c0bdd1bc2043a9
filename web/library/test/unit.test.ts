/** What needs no browser: colours, geometries, queries. */

import assert from "node:assert/strict";
import { test } from "node:test";
import type { Lab } from "../../common/colour";
import { chip, deltaE2000, deltaHue, hue } from "../../common/colour";
import type { Library, Paint } from "../src/data";
import { byLamp, geometry, mainAngles, ramp } from "../../common/geometry";
import { domainOf } from "../src/limits";
import { apart, ticks } from "../../common/plots";
import { emptyQuery, find, read, within, write } from "../src/query";

function close(value: number, wanted: number, tolerance: number): void {
    assert.ok(Math.abs(value - wanted) <= tolerance, `${String(value)} is not ${String(wanted)}`);
}

test("Delta E 2000 of the pairs that Sharma, Wu and Dalal publish, to their four decimals", () => {
    // [sharma-2005, table 1]: those in which hues go round the circle, greys, and small differences
    const pairs: [Lab, Lab, number][] = [
        [[50, 2.6772, -79.7751], [50, 0, -82.7485], 2.0425],
        [[50, -1.3802, -84.2814], [50, 0, -82.7485], 1.0],
        [[50, 0, 0], [50, -1, 2], 2.3669],
        [[50, 2.49, -0.001], [50, -2.49, 0.0009], 7.1792],
        [[50, 2.49, -0.001], [50, -2.49, 0.0011], 7.2195],
        [[50, -0.001, 2.49], [50, 0.0011, -2.49], 4.7461],
        [[50, 2.5, 0], [73, 25, -18], 27.1492],
        [[60.2574, -34.0099, 36.2677], [60.4626, -34.1751, 39.4387], 1.2644],
        [[22.7233, 20.0904, -46.694], [23.0331, 14.973, -42.5619], 2.0373],
        [[2.0776, 0.0795, -1.135], [0.9033, -0.0636, -0.5514], 0.9082],
    ];
    for (const [a, b, wanted] of pairs) {
        close(deltaE2000(a, b), wanted, 5e-5);
        close(deltaE2000(b, a), wanted, 5e-5);
    }
});

test("Delta H* with Delta L* and Delta C* makes up Delta E*ab", () => {
    const pairs: [Lab, Lab][] = [
        [
            [40, 30, 20],
            [42, -10, 25],
        ],
        [
            [40, 30, -1],
            [40, 30, 1],
        ],
        [
            [40, 5, 5],
            [40, -5, -5],
        ],
    ];
    for (const [a, b] of pairs) {
        const [dL, da, db] = [b[0] - a[0], b[1] - a[1], b[2] - a[2]];
        const dC = Math.hypot(b[1], b[2]) - Math.hypot(a[1], a[2]);
        const dH = deltaHue(a, b);
        close(dL ** 2 + dC ** 2 + dH ** 2, dL ** 2 + da ** 2 + db ** 2, 1e-9);
    }
    assert.ok(deltaHue([40, 30, -1], [40, 30, 1]) > 0, "anticlockwise through 0");
});

test("hues lie in [0, 360)", () => {
    close(hue([50, 1, -1]), 315, 1e-9);
    assert.equal(hue([50, 0, 0]), 0);
    assert.ok(hue([50, 1, -1e-300]) < 360);
});

test("chips: white, greys, what is too bright and what is outside sRGB", () => {
    assert.deepEqual(chip([100, 0, 0]), { css: "#ffffff", tooBright: false, outOfGamut: false });
    assert.equal(chip([0, 0, 0]).css, "#000000");
    assert.equal(chip([53.585, 0, 0]).css, "#808080"); // Y = 0.2159: sRGB's middle
    assert.ok(chip([140, 0, 0]).tooBright);
    assert.equal(chip([140, 0, 0]).css, "#ffffff");
    assert.ok(chip([50, -90, 0]).outOfGamut);
});

test("names of geometries", () => {
    assert.deepEqual(geometry("45as-15"), { name: "45as-15", lamp: 45, aspecular: -15 });
    assert.deepEqual(geometry("15as38.3az43"), { name: "15as38.3az43", lamp: 15, aspecular: null });
    assert.deepEqual(geometry("45to30,90"), { name: "45to30,90", lamp: 45, aspecular: null });
    assert.ok(Number.isNaN(geometry("window").lamp));
    const names = ["15as15", "45as110", "45as15", "45as25az90"];
    assert.deepEqual([...byLamp(names).keys()], [15, 45]);
    assert.deepEqual(
        mainAngles(names).map((angle) => angle.index),
        [2, 1],
    );
});

test("a ramp goes from the smallest aspecular angle to the largest, in proportion", () => {
    const angles = mainAngles(["45as110", "45as10", "45as35"]);
    const labs: Lab[] = [
        [0, 0, 0],
        [100, 0, 0],
        [50, 0, 0],
    ];
    const css = ramp(angles, (i) => labs[i] as Lab);
    assert.match(
        css,
        /^linear-gradient\(to right, #ffffff 0\.0%, .*#777777 25\.0%, .*#000000 100\.0%\)$/,
    );
});

test("ticks are round and within", () => {
    assert.deepEqual(ticks(0, 1, 5), [0, 0.2, 0.4, 0.6, 0.8, 1]);
    assert.deepEqual(ticks(-15, 110, 4), [0, 50, 100]);
    assert.deepEqual(apart([10, 11, 50], 5, 0, 100), [10, 15, 50]);
    assert.deepEqual(apart([99, 100], 5, 0, 100), [95, 100]);
});

test("domains hold all values and end on round ones", () => {
    assert.deepEqual(domainOf([0.31, 44.3]), { from: 0, to: 45, decimals: 0 });
    const same = domainOf([3, 3]);
    assert.ok(same.from <= 3 && same.to > 3);
});

const library: Library = {
    schema: 1,
    title: "Three",
    version: "",
    records: 3,
    geometries: ["45as15", "45as45"],
    wavelengths_nm: [],
    illuminant: "D65",
    observer: "10",
    sweeps: ["s"],
    constructions: ["clear / A", "clear / B"],
    pigments: ["A", "B"],
    sparkle_lamp_deg: null,
    gallery_files: 1,
    records_per_file: 32,
};

function paint(
    index: number,
    name: string,
    lab: Lab,
    pigments: number[],
    flop: number | null,
): Paint {
    return {
        index,
        id: `id${String(index)}`,
        name,
        sweep: 0,
        construction: pigments[0] ?? 0,
        pigments,
        lab: [[90, 0, 0], lab],
        flop,
        travel: 1,
        sparkle: null,
        graininess: null,
        thumbnails: [],
    };
}

const paints = [
    paint(0, "Paint 10", [50, 10, -1], [0], 12),
    paint(1, "Paint 9", [40, 10, 10], [1], null),
    paint(2, "Red", [30, -10, 1], [0, 1], 3),
];

function names(change: (query: ReturnType<typeof emptyQuery>) => void): string[] {
    const query = emptyQuery("45as45");
    change(query);
    return find(library, paints, query).paints.map((found) => found.name);
}

test("records are found", () => {
    assert.deepEqual(
        names(() => undefined),
        ["Paint 9", "Paint 10", "Red"],
    );
    assert.deepEqual(
        names((query) => (query.text = "PAINT id0")),
        ["Paint 10"],
    );
    assert.deepEqual(
        names((query) => (query.chosen = { ...query.chosen, with: ["A", "B"] })),
        ["Red"],
    );
    assert.deepEqual(
        names((query) => (query.limits = { flop: { from: 3, to: null } })),
        ["Paint 10", "Red"],
    );
    assert.deepEqual(
        names((query) => (query.limits = { h: { from: 300, to: 50 } })),
        ["Paint 9", "Paint 10"],
    );
    assert.ok(!within("flop", 5, { from: 6, to: 4 }), "only hues go round");
    assert.deepEqual(
        names((query) => {
            query.target = [31, -9, 0];
            query.sort = "nearness";
        }),
        ["Red", "Paint 9", "Paint 10"],
    );
});

test("records without a figure come last in either direction", () => {
    for (const descending of [false, true]) {
        const order = names((query) => {
            query.sort = "flop";
            query.descending = descending;
        });
        assert.equal(order[2], "Paint 9");
        assert.equal(order[0], descending ? "Paint 10" : "Red");
    }
});

test("a query is what its address says", () => {
    const usual = emptyQuery("45as45");
    const query = emptyQuery("45as15");
    query.text = "a & b";
    query.limits = {
        h: { from: 330, to: 30 },
        flop: { from: null, to: 20.5 },
        L: { from: -1, to: null },
    };
    query.chosen = { with: ["B"], of: ["clear / A"], sweep: [] };
    query.target = [50.5, -20, 10];
    query.sort = "nearness";
    query.descending = true;
    assert.deepEqual(read(write(query, usual), usual, library), query);
    assert.equal(write(usual, usual), "");
    assert.deepEqual(read("at=x&flop=..&with=C&lab=1,2&sort=y", usual, library), usual);
});
