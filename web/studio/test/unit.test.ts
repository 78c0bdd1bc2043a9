/** What needs no browser: trees, edits, undo, links, the newest request, forms from the schema, the connection. */

import assert from "node:assert/strict";
import { test } from "node:test";
import type { FunctionComponent } from "preact";
import { atlasValues } from "../src/atlas";
import type { Document } from "../src/edit";
import { insertEntry, moveEntry, removeEntry, setLock } from "../src/edit";
import { digits, shortDigits } from "../src/digits";
import { fileName } from "../src/files";
import { caveatsAt, caveatsText } from "../src/gamut";
import { History } from "../src/history";
import { Latest } from "../src/latest";
import { EntryKeys } from "../src/ui/entry_keys";
import { fromFragment, linkIn, toFragment } from "../src/link";
import { fitted, orbitOf, turned, wrapped } from "../src/orbit";
import { coarser } from "../src/renderer/coarse_mesh";
import type { Mesh } from "../src/renderer/paint";
import type { KeyInfo } from "../src/schema";
import {
    allows,
    brought,
    chosen,
    dropped,
    foreignKeys,
    keyInfo,
    labelOf,
    parameters,
    placeText,
    rangeText,
    tableInfo,
    tipOf,
} from "../src/schema";
import { Session, unpack } from "../src/session";
import { niceAbove, scaleOf, settled } from "../src/slider";
import { newEntry, switched } from "../src/starters";
import type { Path, Table } from "../src/tree";
import { genericPath, get, numbers, parsePath, pathText, set } from "../src/tree";
import { steady } from "../src/ui/steady";
import { COAT, FakeServer, PAINT, SCHEMA } from "./fake_server";

const DOCUMENT: Document = { recipe: PAINT, locks: new Set(["layer[1].thickness_um"]) };

test("a path is written and read as messages name keys", () => {
    assert.equal(pathText(parsePath(COAT)), COAT);
    assert.deepEqual(parsePath("layer[10].thickness_um"), ["layer", 10, "thickness_um"]);
    assert.equal(genericPath(parsePath(COAT)), "layer[].flakes[].coats[].thickness_nm");
    assert.equal(get(PAINT, parsePath(COAT)), 20);
    assert.equal(get(PAINT, parsePath("layer[7].thickness_um")), undefined);
});

test("an edit makes a new tree, leaves the old one, and shares what is the same", () => {
    const changed = set(PAINT, parsePath(COAT), 25);
    assert.equal(get(PAINT, parsePath(COAT)), 20);
    assert.equal(get(changed, parsePath(COAT)), 25);
    assert.equal(get(changed, ["layer", 1]), get(PAINT, ["layer", 1]));
    assert.equal("name" in set(PAINT, ["name"], undefined), false);
    assert.equal(numbers(PAINT.layer as never).length, 6);
});

test("locks and bounds follow their numbers when entries move or go", () => {
    const moved = moveEntry(DOCUMENT, ["layer"], 1, -1);
    assert.deepEqual([...moved.locks], ["layer[0].thickness_um"]);
    assert.deepEqual(moved.recipe.fit, { "layer[0].thickness_um": [20, 40] });
    assert.equal(get(moved.recipe, ["layer", 0, "thickness_um"]), 30);

    const inserted = insertEntry(DOCUMENT, ["layer"], 0, { thickness_um: 5 });
    assert.deepEqual([...inserted.locks], ["layer[2].thickness_um"]);

    const removed = removeEntry(DOCUMENT, ["layer"], 1);
    assert.deepEqual([...removed.locks], []);
    assert.equal("fit" in removed.recipe, false);

    assert.equal(moveEntry(DOCUMENT, ["layer"], 0, -1), DOCUMENT);
    assert.equal("layer" in removeEntry(removed, ["layer"], 0).recipe, false);
    assert.deepEqual([...setLock(DOCUMENT, ["ior"], true).locks].sort(), [
        "ior",
        "layer[1].thickness_um",
    ]);
});

test("correlations follow their numbers, and go with the last two of them", () => {
    const of = (keys: string[]) => ({ of: keys, coefficient: 0.8 });
    const upper = "layer[0].thickness_um";
    const lower = "layer[1].thickness_um";
    const correlation = [of([upper, lower]), of([upper, lower, "ior"])];
    const recipe = { ...PAINT, uncertainty: { [upper]: 1, [lower]: 2, ior: 0.1, correlation } };
    const start: Document = { recipe, locks: new Set() };
    const moved = moveEntry(start, ["layer"], 1, -1).recipe.uncertainty;
    assert.deepEqual(moved, {
        [lower]: 1,
        [upper]: 2,
        ior: 0.1,
        correlation: [of([lower, upper]), of([lower, upper, "ior"])],
    });
    const removed = removeEntry(start, ["layer"], 1).recipe.uncertainty;
    assert.deepEqual(removed, { [upper]: 1, ior: 0.1, correlation: [of([upper, "ior"])] });
    const alone = {
        ...PAINT,
        uncertainty: { [upper]: 1, [lower]: 2, correlation: [correlation[0]] },
    };
    const without = removeEntry({ recipe: alone as never, locks: new Set() }, ["layer"], 1);
    assert.deepEqual(without.recipe.uncertainty, { [upper]: 1 });
});

test("undo and redo go back and forth, and a drag is one step", () => {
    const history = new History(0);
    history.push(1);
    for (const x of [2, 3, 4]) history.push(x, "slide a");
    history.push(5, "slide b");
    history.endGesture();
    history.push(6, "slide b");
    assert.deepEqual([history.undo(), history.undo(), history.undo()], [5, 4, 1]);
    assert.equal(history.redo(), 4);
    history.push(9);
    assert.equal(history.canRedo, false);
    assert.deepEqual([history.undo(), history.undo(), history.undo()], [4, 1, 0]);
    assert.equal(history.canUndo, false);
    assert.equal(history.undo(), 0);
});

test("of requests one is under way, and of those that wait the newest is sent", () => {
    const sent: number[] = [];
    const latest = new Latest<number>((n) => sent.push(n));
    for (let n = 0; n < 100; ++n) latest.want(n);
    assert.deepEqual(sent, [0]);
    latest.finished();
    assert.deepEqual(sent, [0, 99]);
    latest.finished();
    assert.equal(latest.busy, false);
    latest.want(100);
    latest.want(101);
    assert.equal(latest.abandon(), 101);
    assert.equal(latest.busy, false);
});

test("a paint goes into an address and comes back", async () => {
    const fragment = await toFragment(DOCUMENT);
    assert.match(fragment, /^#paint=[\w-]+$/);
    const read = await fromFragment(fragment);
    assert.deepEqual(read?.recipe, PAINT);
    assert.deepEqual(read.locks, DOCUMENT.locks);
    assert.equal(await fromFragment("#elsewhere"), null);
    await assert.rejects(fromFragment(fragment.slice(0, -9)), /was it cut/);
    await assert.rejects(fromFragment("#paint=%%%"), /was it cut/);
    const list = await toFragment({ recipe: [1] as unknown as Table, locks: new Set() });
    await assert.rejects(fromFragment(list), /no paint/);
});

test("an address with what no recipe can hold is refused", async () => {
    const deep = (levels: number) => {
        let recipe: Table = {};
        for (let i = 1; i < levels; ++i) recipe = { a: recipe };
        return recipe;
    };
    const fragmentOf = (recipe: unknown) =>
        toFragment({ recipe: recipe as Table, locks: new Set() });
    assert.deepEqual((await fromFragment(await fragmentOf(deep(32))))?.recipe, deep(32));
    const bad = [deep(33), deep(200), null, { layer: null }, { layer: [{ flakes: [null] }] }];
    for (const recipe of bad) {
        await assert.rejects(fromFragment(await fragmentOf(recipe)), /no paint/);
    }
});

test("an address that would unfold to more than a paint is refused", async () => {
    const bomb = await toFragment({ recipe: { name: "a".repeat(2 << 20) }, locks: new Set() });
    assert.ok(bomb.length < 10_000);
    await assert.rejects(fromFragment(bomb), /more than/);
});

const info = (change: Partial<KeyInfo>): KeyInfo => ({
    key: "thickness_um",
    kind: "number",
    unit: "um",
    doc: "",
    required: true,
    min: 0,
    max: 1e6,
    ...change,
});

test("a slider reaches a round number above twice the value, and never beyond what is allowed", () => {
    assert.equal(niceAbove(90), 100);
    assert.equal(niceAbove(0.16), 0.2);
    assert.equal(niceAbove(1), 1);
    assert.deepEqual(scaleOf(info({}), 45), { low: 0, high: 100, step: 0.2 });
    assert.equal(scaleOf(info({ max: 60 }), 45).high, 60);
    assert.deepEqual(scaleOf(info({ min: -1, max: 1 }), 0.2), { low: -1, high: 1, step: 0.005 });
    const bounded = scaleOf(info({}), 30, [20, 40]);
    assert.deepEqual([bounded.low, bounded.high], [20, 40]);
    assert.ok(scaleOf(info({ unit: "nm" }), 0).high >= 50);
});

test("a slider stands for allowed numbers only", () => {
    const open = info({ min: 0, min_excluded: true });
    const scale = scaleOf(open, 15);
    assert.ok(settled(open, scale, 0) > 0);
    const roughness = info({ key: "roughness", min: 0.01, max: 1, zero: "smooth", unit: "" });
    const rough = scaleOf(roughness, 0);
    assert.equal(settled(roughness, rough, 0.001), 0);
    assert.equal(settled(roughness, rough, 0.008), 0.01);
    for (let raw = rough.low; raw <= rough.high; raw += rough.step / 3) {
        assert.ok(allows(roughness, settled(roughness, rough, raw)));
    }
    assert.equal(settled(info({}), scaleOf(info({}), 45), 33.3333), 33.4);
});

test("keys become labels with units, and ranges are written as in the documents", () => {
    assert.deepEqual(labelOf("thickness_um"), { label: "Thickness", unit: "µm" });
    assert.deepEqual(labelOf("area_density_per_um"), { label: "Area density", unit: "µm⁻¹" });
    assert.equal(rangeText(info({ min_excluded: true })), "(0, 1000000] µm");
    assert.equal(
        rangeText(info({ key: "roughness", min: 0.01, max: 1, zero: "" })),
        "0 or [0.01, 1]",
    );
    assert.equal(allows(info({ min_excluded: true }), 0), false);
    assert.equal(allows(info({}), 1e7), false);
});

test("the tip of a number has its document and its range, or what there is of them", () => {
    assert.equal(tipOf(info({ doc: "How thick" }), ""), "How thick; [0, 1000000] µm");
    assert.equal(tipOf(info({}), ""), "[0, 1000000] µm");
    assert.equal(tipOf(info({ doc: "How thick" }), "-1e9"), "-1e9; How thick; [0, 1000000] µm");
});

test("every number of a paint is a parameter of the form", () => {
    const found = parameters(SCHEMA, PAINT).map(({ path }) => pathText(path));
    assert.ok(found.includes(COAT));
    assert.equal(found.length, 6, found.join());
    assert.equal(placeText(PAINT, parsePath(COAT)), "Layer 1, TiO2 on mica, SiO2");
});

test("of alternatives a table shows the keys of the one that it states", () => {
    const flakes = tableInfo(SCHEMA, ["layer", 0, "flakes", 0]);
    assert.ok(flakes);
    const filmed = get(PAINT, ["layer", 0, "flakes", 0]) as Table;
    const hidden = foreignKeys(filmed, flakes);
    assert.ok(hidden.has("reflectance") && hidden.has("area_density_per_um"));
    assert.ok(!hidden.has("coats") && !hidden.has("volume_fraction"));

    const body = flakes.alternatives?.find(({ each }) => each[0]?.mark === "core");
    assert.ok(body);
    assert.equal(chosen(filmed, body), 0);
    const grey = switched(SCHEMA, ["layer", 0, "flakes", 0], filmed, body, 1);
    assert.equal("core" in grey || "coats" in grey, false);
    assert.equal(grey.reflectance, 0.5);
    assert.equal(grey.volume_fraction, 0.03);
    assert.equal(chosen(grey, body), 1);
});

test("sizes are a mean diameter, a median, or three quantiles", () => {
    const path = ["layer", 0, "flakes", 0];
    const flakes = tableInfo(SCHEMA, path);
    assert.ok(flakes);
    const keyOf = (name: string) => {
        const key = flakes.keys.find(({ key }) => key === name);
        assert.ok(key);
        return key;
    };
    const plain = newEntry(SCHEMA, ["layer", 0, "flakes"]) as Table;
    assert.ok("diameter_um" in plain && !("d50_um" in plain));
    const hidden = foreignKeys(plain, flakes);
    for (const key of ["d10_um", "d50_um", "d90_um"]) assert.ok(hidden.has(key), key);

    const median: Table = { volume_fraction: 0.03, d50_um: 20 };
    assert.ok(foreignKeys(median, flakes).has("diameter_um"));
    for (const key of ["d10_um", "d90_um"]) {
        const other = brought(median, flakes, keyOf(key));
        assert.ok(other, key);
        const all = switched(SCHEMA, path, median, other.group, other.to);
        assert.deepEqual(all, { volume_fraction: 0.03, d50_um: 20, d10_um: 8, d90_um: 32 });
        const group = dropped(all, flakes, "d10_um");
        assert.ok(group);
        assert.deepEqual(switched(SCHEMA, path, all, group, 0), median);
    }
    assert.equal(brought(plain, flakes, keyOf("transmittance")), undefined);
    assert.equal(dropped(median, flakes, "d50_um"), undefined);
});

test("a new entry has what the schema requires", () => {
    for (const list of [["layer"], ["layer", 0, "flakes"], ["layer", 0, "pigment"]]) {
        const entry = newEntry(SCHEMA, list);
        const needed =
            tableInfo(SCHEMA, [...list, 0])?.keys.filter(({ required }) => required) ?? [];
        const alternatives = tableInfo(SCHEMA, [...list, 0])?.alternatives ?? [];
        const either = new Set(alternatives.flatMap(({ each }) => each.flatMap((one) => one.keys)));
        for (const { key } of needed) {
            if (!either.has(key)) assert.ok(key in (entry as Table), `${key} in ${list.join(".")}`);
        }
    }
});

test("bytes are laid out as the message before them says", () => {
    const bytes = new ArrayBuffer(12);
    new Uint8Array(bytes).set([1, 2, 3]);
    new Float32Array(bytes, 4).set([0.5, 7]);
    const [rgb, values] = unpack(
        [
            { name: "rgb", dtype: "u8", shape: [1, 1, 3] },
            { name: "values", dtype: "f32", shape: [2] },
        ],
        bytes,
    );
    assert.deepEqual([...(rgb?.data as Uint8Array)], [1, 2, 3]);
    assert.deepEqual([...(values?.data as Float32Array)], [0.5, 7]);
});

test("answers reach those who asked, with the bytes behind them", () => {
    const server = new FakeServer();
    const session = new Session(server.connect, () => undefined);
    server.open();
    const got: unknown[] = [];
    session.send("render", {}, (message, attachments) => {
        got.push(
            message.type,
            attachments.map(({ name }) => name),
        );
    });
    const [asked] = server.received("render");
    server.answer({
        type: "picture",
        id: asked?.id,
        binary: [{ name: "rgb", dtype: "u8", shape: [4] }],
    });
    assert.deepEqual(got, []);
    server.answerBytes(new ArrayBuffer(4));
    assert.deepEqual(got, ["picture", ["rgb"]]);
    server.answer({ type: "picture", id: 12345 });
    assert.equal(got.length, 2);
    session.close();
});

test("an error about a message whose id was not read ends what waits, and is said", () => {
    const server = new FakeServer();
    const said: string[] = [];
    const session = new Session(
        server.connect,
        () => undefined,
        (why) => said.push(why),
    );
    server.open();
    const ended: string[] = [];
    for (const type of ["paint", "fit"]) {
        const id = session.send(type, {}, (message) => {
            session.forget(id);
            ended.push(`${type}: ${String(message.message)}`);
        });
    }
    const forgotten = session.send("render", {}, () => ended.push("render"));
    session.forget(forgotten);
    server.answer({ type: "stopped", id: null, jobs: 0 });
    assert.deepEqual(ended, [], "nobody asked");
    server.answer({ type: "error", id: null, about: "message", message: "nests too deep" });
    assert.deepEqual(ended, ["paint: nests too deep", "fit: nests too deep"]);
    assert.deepEqual(said, ["nests too deep"]);
    session.close();
});

test("a camera is angles about the shape, and turning stops before the poles", () => {
    const orbit = orbitOf({
        name: "ball",
        title: "Ball",
        light: "studio",
        transform: { scale: 1, rotation_deg: [0, 0, 0], translation_mm: [0, 0, 0] },
        camera: { position_mm: [0, -600, 0], target_mm: [0, 0, 0], fov_deg: 11, aspect: 1.5 },
    });
    assert.ok(Math.abs(orbit.azimuth_deg + 90) < 1e-9 && orbit.distance_mm === 600);
    const half = (fov_deg: number) => Math.tan((fov_deg * Math.PI) / 360);
    assert.ok(Math.abs(fitted(orbit, 300, 200).fov_deg - 11) < 1e-9, "wide enough for the shape");
    const narrow = fitted(orbit, 200, 300);
    assert.ok(Math.abs(half(narrow.fov_deg) / half(11) - 2.25) < 1e-9, "as much from side to side");
    assert.ok(!("aspect" in narrow), "the server knows no such key");
    assert.equal(turned(orbit, 500).elevation_deg, 85);
    const nearest = turned(orbit, 0, 1e9).distance_mm;
    assert.ok(nearest > 80 && nearest < 90, "before the surface of a ball of 82 mm");
    assert.equal(wrapped(190), -170);
    assert.equal(wrapped(-540), 180);
});

/** A grid of places over two sides of length 1, and their normals. */
function sheet(columns: number, rows: number, at: (u: number, v: number) => number[]): Mesh {
    const places: number[] = [];
    const indices: number[] = [];
    for (let row = 0; row <= rows; ++row) {
        for (let column = 0; column <= columns; ++column) {
            places.push(...at(column / columns, row / rows));
            if (row === rows || column === columns) continue;
            const first = row * (columns + 1) + column;
            const above = first + columns + 1;
            indices.push(first, first + 1, above, above, first + 1, above + 1);
        }
    }
    const part = (from: number) =>
        Float32Array.from(places.filter((_, i) => i % 6 >= from && i % 6 < from + 3));
    return { positions: part(0), normals: part(3), indices: Uint32Array.from(indices) };
}

test("a coarse picture's ball has fewer triangles, as far from the middle and facing the same way", () => {
    const radius = 40;
    const ball = sheet(256, 128, (u, v) => {
        const [phi, theta] = [2 * Math.PI * u, Math.PI * v];
        const n = [
            Math.sin(theta) * Math.cos(phi),
            Math.sin(theta) * Math.sin(phi),
            Math.cos(theta),
        ];
        return [...n.map((x) => radius * x), ...n];
    });
    for (const cell of [2, 4, 8]) {
        const { positions, normals, indices } = coarser(ball, cell);
        assert.ok(indices.length > 0 && indices.length < ball.indices.length / 2);
        // Means of places on a ball lie below it by at most the height of a cell's cap.
        const cap = radius - Math.sqrt(radius ** 2 - 0.75 * cell ** 2);
        for (let i = 0; i < positions.length; i += 3) {
            const place = Array.from(positions.subarray(i, i + 3));
            const normal = Array.from(normals.subarray(i, i + 3));
            const [far, length] = [Math.hypot(...place), Math.hypot(...normal)];
            assert.ok(far < radius * 1.00001 && far > radius - 2 * cap, `${String(far)} mm`);
            const cosine =
                place.reduce((sum, x, k) => sum + x * (normal[k] as number), 0) / far / length;
            assert.ok(cosine > 0.9999, `cosine ${String(cosine)}`);
        }
        assert.ok(indices.every((vertex) => 3 * vertex < positions.length));
    }
});

test("both sides of a thin plate are kept apart, and a mesh of few triangles is left as it is", () => {
    const side = (z: number, facing: number) =>
        sheet(40, 40, (u, v) => [10 * u, 10 * v, z, 0, 0, facing]);
    const [top, below] = [side(0.01, 1), side(0, -1)];
    const plate: Mesh = {
        positions: Float32Array.of(...top.positions, ...below.positions),
        normals: Float32Array.of(...top.normals, ...below.normals),
        indices: Uint32Array.of(...top.indices, ...below.indices.map((i) => i + 41 * 41)),
    };
    const { positions, normals, indices } = coarser(plate, 1);
    assert.ok(indices.length < plate.indices.length / 10);
    for (let i = 0; i < positions.length; i += 3) {
        const facing = (normals[i + 2] as number) > 0 ? 1 : -1;
        assert.ok(Math.abs((positions[i + 2] as number) - (facing > 0 ? 0.01 : 0)) < 1e-6);
    }
    assert.equal(coarser(plate, 0.1), plate);
    assert.equal(coarser(plate, 1e-9), plate);
});

test("files are named after the paint, and by no path", () => {
    assert.equal(fileName("Red-gold interference", "toml"), "red-gold-interference.toml");
    assert.equal(fileName("../../etc/passwd", "csv"), "etc-passwd.csv");
    assert.equal(fileName(undefined, "png"), "paint.png");
    assert.equal(fileName("Grün 7", "toml"), "grün-7.toml");
});

test("an atlas has round values that the key allows, from end to end", () => {
    const info = keyInfo(SCHEMA, parsePath("layer[0].flakes[0].volume_fraction"));
    assert.ok(info);
    assert.deepEqual(atlasValues(info, { low: 0, high: 0.2 }).slice(0, 3), [0.005, 0.01, 0.015]);
    assert.equal(atlasValues(info, { low: 0, high: 0.2 }).at(-1), 0.2);
    assert.deepEqual(atlasValues(info, { low: 3, high: 4 }), []);
    assert.deepEqual(atlasValues(info, { low: 1, high: 0.5 }), []);
});

test("a steady component is drawn when a property or a step of its path is another", () => {
    const draw: FunctionComponent<{ path: Path; value?: unknown }> = () => null;
    const Row = steady(draw);
    type Props = Parameters<typeof draw>[0];
    const draws = (one: Props, other: Props) =>
        new Row(one).shouldComponentUpdate?.(other, {}, {}) ?? true;
    const value = { a: 1 };
    assert.equal(draws({ path: ["layer", 0], value }, { path: ["layer", 0], value }), false);
    assert.equal(draws({ path: ["layer", 0], value }, { path: ["layer", 1], value }), true);
    assert.equal(
        draws({ path: ["layer", 0], value }, { path: ["layer", 0], value: { a: 1 } }),
        true,
    );
    assert.equal(draws({ path: ["layer", 0], value }, { path: ["layer", 0] }), true);
    assert.equal(draws({ path: ["layer", 0] }, { path: ["layer", 0], value }), true);
});

test("a link is told from a recipe, whole or from its # on", () => {
    for (const text of [
        "http://127.0.0.1:1/?token=a#paint=ab-_9",
        "#paint=ab-_9",
        " paint=ab-_9\n",
    ]) {
        assert.equal(linkIn(text), "#paint=ab-_9", text);
    }
    for (const text of ['paint="red"', "ior = 1.5", "a#paint=b\nior = 1.5"]) {
        assert.equal(linkIn(text), null, text);
    }
});

test("entries of a list keep their keys as they move, change and come back", () => {
    const keys = new EntryKeys();
    const [a, b, c] = [{ n: 1 }, { n: 2 }, { n: 3 }];
    assert.deepEqual(keys.of([a, b]), [0, 1]);
    assert.deepEqual(keys.of([b, a]), [1, 0], "moved");
    const changed = { n: 4 };
    assert.deepEqual(keys.of([b, changed]), [1, 0], "changed");
    assert.deepEqual(keys.of([c, b, changed]), [2, 1, 0], "one before them");
    assert.deepEqual(keys.of([c, changed]), [2, 0], "one taken out");
    assert.deepEqual(keys.of([c, b, changed]), [2, 1, 0], "and back");
});

test("numbers that are longer than their field are shown by powers of ten", () => {
    assert.equal(shortDigits(-1_000_000_000), "-1e9");
    assert.equal(shortDigits(1e308), "1e308");
    assert.equal(shortDigits(-1.23456e-12), "-1e-12");
    assert.equal(shortDigits(0.000123456), "1.23e-4");
    assert.equal(shortDigits(123456789), "1.235e8");
    for (const value of [0, 15, 0.12345, -12.5, 1234560]) {
        assert.equal(shortDigits(value), digits(value));
    }
});

test("colours outside sRGB and too bright ones are marked and counted apart", () => {
    const colours = {
        out_of_gamut: [true, false, false, false],
        too_bright: [true, true, true, false],
    };
    assert.equal(caveatsText(colours), "1 outside sRGB, 3 too bright");
    assert.equal(caveatsText({ ...colours, out_of_gamut: [] }), "3 too bright");
    assert.equal(caveatsText({ out_of_gamut: [false], too_bright: [false] }), "");
    const marks = [0, 1, 3].map((i) =>
        caveatsAt(colours, i)
            .map(({ mark }) => mark)
            .join(""),
    );
    assert.deepEqual(marks, ["!↑", "↑", ""]);
});
