/** What the page does, against a server that says what a test wants: edits, answers, faults, a lost connection. */

import assert from "node:assert/strict";
import { test } from "node:test";
import { setValue } from "../src/edit";
import { toFragment } from "../src/link";
import { isCurrent, isOld } from "../src/state";
import { Studio } from "../src/studio";
import type { Table } from "../src/tree";
import { get, parsePath } from "../src/tree";
import { COAT, FakeServer, PAINT, SCHEMA, WITH_BALL } from "./fake_server";

/** Lets promises that are settled be heard. */
const settle = () => new Promise((resolve) => setTimeout(resolve, 5));

async function studioWith(
    server: FakeServer,
    schema = SCHEMA,
): Promise<{ studio: Studio; clock: { ms: number } }> {
    const clock = { ms: 0 };
    const studio = new Studio({
        connect: server.connect,
        schema: () => Promise.resolve(schema),
        bytes: () => Promise.reject(new Error("no bytes here")),
        refused: () => Promise.resolve(server.refuses),
        now: () => clock.ms,
        drawn: (then) => {
            then();
        },
        fragment: () => "",
        setFragment: () => undefined,
        address: () => "",
    });
    server.open();
    await settle();
    return { studio, clock };
}

test("the studio opens a paint, measures it, and never has two measurements under way", async () => {
    const server = new FakeServer();
    const { studio, clock } = await studioWith(server);
    server.answerOpen(PAINT);
    assert.equal(server.received("paint").length, 1);
    for (let i = 1; i <= 50; ++i) {
        studio.edit((d) => setValue(d, parsePath(COAT), 20 + i), "slide");
    }
    assert.equal(server.received("paint").length, 1);
    clock.ms = 80;
    server.answerPaint();
    const [, second] = server.received("paint");
    assert.equal(get(second?.recipe as Table, parsePath(COAT)), 70);
    assert.equal(server.received("paint").length, 2);
    clock.ms = 100;
    server.answerPaint();
    await settle();
    assert.equal(studio.store.get().latency_ms, 100);
    assert.equal(studio.store.get().details, studio.store.get().readings);
    assert.equal(studio.store.get().readingsOf, studio.store.get().document);
    studio.undo();
    assert.equal(get(studio.store.get().document.recipe, parsePath(COAT)), 20);
    studio.redo();
    assert.equal(get(studio.store.get().document.recipe, parsePath(COAT)), 70);
});

test("what is saved is of the paint as it is now, and a paint with a fault is not saved", async () => {
    const server = new FakeServer();
    const { studio } = await studioWith(server);
    server.answerOpen(PAINT);
    server.answerPaint();
    const saved: unknown[] = [];
    const save = () => {
        studio.whenCurrent(({ document }) => saved.push(get(document.recipe, parsePath(COAT))));
    };
    save();
    assert.deepEqual(saved, [20], "at once where nothing is awaited");
    studio.edit((d) => setValue(d, parsePath(COAT), 21));
    save();
    assert.deepEqual(saved, [20]);
    server.answerPaint();
    assert.deepEqual(saved, [20, 21]);
    studio.edit((d) => setValue(d, parsePath(COAT), -1));
    save();
    const { id } = server.received("paint").at(-1) ?? {};
    server.answer({ type: "error", id, message: "out of range", key: COAT });
    studio.undo();
    server.answerPaint();
    assert.deepEqual(saved, [20, 21], "what was refused is forgotten");
});

test("a measurement of sparkle says how far it is, can be stopped, and is not begun with nobody there", async () => {
    const server = new FakeServer();
    const { studio } = await studioWith(server);
    server.answerOpen(PAINT);
    server.answerPaint();
    const fraction = () => studio.store.get().sparkleFraction;
    studio.sparkle.measure();
    const first = server.received("sparkle").at(-1)?.id;
    assert.equal(fraction(), 0);
    server.answer({ type: "progress", id: first, about: "sparkle", fraction: 0.4 });
    assert.equal(fraction(), 0.4);
    studio.sparkle.stop();
    assert.equal(server.received("stop").at(-1)?.what, "sparkle");
    assert.equal(fraction(), null);
    server.answer({ type: "progress", id: first, about: "sparkle", fraction: 0.5 });
    assert.equal(fraction(), null, "what was stopped says nothing");

    studio.sparkle.measure();
    const id = server.received("sparkle").at(-1)?.id;
    assert.notEqual(id, first);
    server.answer({ type: "sparkle", id, readings: [], graininess: null, flakes_resolved: true });
    assert.equal(fraction(), null);
    assert.equal(studio.store.get().sparkle?.of, studio.store.get().document);

    server.drop();
    await settle();
    studio.sparkle.measure();
    assert.equal(fraction(), null);
});

test("in a light of another lamp the paint is asked for in that lamp", async () => {
    const server = new FakeServer();
    const { studio } = await studioWith(server);
    const light = (name: string, illuminant: string) => ({ name, title: name, illuminant });
    const lights = [light("sun", "D65"), light("booth-a", "A"), light("booth-fl11", "FL11")];
    studio.store.set({ schema: { ...SCHEMA, lights } });
    server.answerOpen(PAINT);
    server.answerPaint();
    const camera = {
        azimuth_deg: -90,
        elevation_deg: 10,
        distance_mm: 600,
        fov_deg: 11,
        aspect: 1,
        nearest_mm: 50,
    };
    const turned = { turn_deg: 0, light_turn_deg: 0, sparkle: true, camera, shape: "ball" };
    const show = (name: string) => {
        studio.viewer.store.set({ view: { ...turned, light: name } });
    };
    const lamps = () => server.received("paint").map(({ lamp }) => lamp);
    show("sun");
    assert.deepEqual(lamps(), ["D65"], "nothing new in another light of the same lamp");
    show("booth-a");
    assert.deepEqual(lamps(), ["D65", "A"]);
    show("booth-fl11");
    server.answerPaint();
    assert.deepEqual(lamps(), ["D65", "A", "FL11"]);
});

test("a fault is kept until a recipe can be read again, and the last colours stay", async () => {
    const server = new FakeServer();
    const { studio } = await studioWith(server);
    server.answerOpen(PAINT);
    server.answerPaint();
    studio.edit((d) => setValue(d, ["layer", 0, "thickness_um"], -3));
    server.answer({
        type: "error",
        id: server.received("paint").at(-1)?.id,
        message:
            "recipe.toml:7:16: layer[0].thickness_um = -3: must be a number in (0, 1000000] um",
        key: "layer[0].thickness_um",
    });
    assert.equal(studio.store.get().fault?.key, "layer[0].thickness_um");
    assert.ok(studio.store.get().readings);
    studio.undo();
    server.answerPaint();
    assert.equal(studio.store.get().fault, null);
});

test("a paint that the server could not read is said, and the next one is measured", async () => {
    const server = new FakeServer();
    const { studio } = await studioWith(server);
    server.answerOpen(PAINT);
    server.answer({ type: "error", id: null, about: "message", message: "message: too deep" });
    assert.match(studio.store.get().notice, /did not read.*too deep/);
    assert.ok(studio.settled);
    studio.edit((d) => setValue(d, parsePath(COAT), 30));
    assert.equal(server.received("paint").length, 2);
    server.answerPaint();
    await settle();
    assert.ok(isCurrent(studio.store.get()));
});

test("readings at other angles do not stop the picture, another paint does", async () => {
    const server = new FakeServer();
    const { studio } = await studioWith(server, WITH_BALL);
    studio.viewer.resize(48, 48);
    server.answerOpen(PAINT);
    server.answerPaint();
    await settle();
    assert.equal(server.received("render").length, 1);
    const { id } = server.received("render")[0] as { id: number };
    server.answer({ type: "done", id }); // the draft
    await new Promise((resolve) => setTimeout(resolve, 400));
    assert.equal(server.received("render").at(-1)?.samples, 64);
    studio.setSettings({ tolerance: 2 });
    studio.setSettings({ geometries: "ma-t12" });
    server.answerPaint();
    await settle();
    assert.equal(server.received("stop").length, 0);
    studio.edit((d) => setValue(d, parsePath(COAT), 30));
    assert.equal(server.received("stop").length, 1);
});

test("a fit passes over numbers that colours cannot tell, and says so by their names", async () => {
    const server = new FakeServer();
    const { studio } = await studioWith(server);
    server.answerOpen(PAINT);
    server.answerPaint();
    const diameter = "layer[0].flakes[0].diameter_um";
    const refuse = (key: string, why: string) => {
        const id = server.received("fit").at(-1)?.id;
        server.answer({ type: "error", id, about: "fit", key, message: `${key}: ${why}` });
    };
    const untold = "does not change the colours of this paint, so that they cannot tell it";
    studio.fit([diameter, COAT], 4);
    refuse(diameter, untold);
    assert.deepEqual(server.received("fit").at(-1)?.free, [COAT]);
    assert.equal(studio.store.get().fit.running, true);
    assert.match(studio.store.get().fit.skipped.join(), /^Diameter/);
    refuse(COAT, untold);
    const { fit } = studio.store.get();
    assert.equal(fit.running, false);
    assert.match(fit.fault ?? "", /^Thickness, .*does not change the colours/);
    assert.equal(server.received("fit").length, 2);
    studio.fit([diameter, COAT], 4);
    assert.deepEqual(studio.store.get().fit.skipped, []);
    refuse(diameter, "must be a number");
    assert.match(studio.store.get().fit.fault ?? "", /^Diameter.*must be a number/);
    assert.equal(server.received("fit").length, 3);
});

test("what is shown is old while the paint as it is now has a fault", async () => {
    const server = new FakeServer();
    const { studio } = await studioWith(server);
    server.answerOpen(PAINT);
    server.answerPaint();
    assert.ok(!isOld(studio.store.get()));
    studio.edit((d) => setValue(d, parsePath(COAT), 1e308));
    assert.ok(!isOld(studio.store.get()), "it may yet be measured");
    const id = server.received("paint").at(-1)?.id;
    server.answer({ type: "error", id, about: "paint", key: COAT, message: "is too thick" });
    assert.ok(isOld(studio.store.get()));
    studio.undo();
    assert.ok(!isOld(studio.store.get()));
});

test("the server is told the name of a file that is opened", async () => {
    const server = new FakeServer();
    const { studio } = await studioWith(server);
    studio.openText("ior = 1.5", "mine.toml");
    assert.equal(server.received("open").at(-1)?.name, "mine.toml");
    studio.openText("ior = 1.6");
    assert.ok(!("name" in (server.received("open").at(-1) ?? {})));
});

test("the studio says when the server has gone, and goes on when it is back", async () => {
    const server = new FakeServer();
    const { studio } = await studioWith(server);
    server.answerOpen(PAINT);
    studio.setStandard("geometry,L,a,b\n45as15,50,0,0\n", "panel.csv");
    server.drop();
    assert.equal(studio.store.get().connection, "gone");
    studio.edit((d) => setValue(d, parsePath(COAT), 33));
    const before = server.received("paint").length;
    await server.reconnected;
    server.open();
    await settle();
    assert.equal(studio.store.get().connection, "open");
    assert.equal(server.received("paint").length, before + 1);
    const last = server.received("paint").at(-1);
    assert.equal(get(last?.recipe as Table, parsePath(COAT)), 33);
    assert.equal(
        server.received("standard").length,
        2,
        "a session of the server knows no standard",
    );
});

test("an atlas is asked for when sliders rest, and not for what it shows already", async () => {
    const server = new FakeServer();
    const { studio } = await studioWith(server);
    server.answerOpen(PAINT);
    const { document, settings } = studio.store.get();
    const path = parsePath(COAT);
    const values = [10, 20, 30, 40, 50, 60, 70];
    studio.atlas.want(document.recipe, path, [1, 2], settings);
    studio.atlas.want(document.recipe, path, values, settings);
    assert.equal(server.received("atlas").length, 0);
    while (server.received("atlas").length === 0) await settle();
    const [coarse] = server.received("atlas");
    assert.deepEqual(coarse?.values, [10, 60, 70]);
    const colours = { geometries: ["45as15"], lab: [[]], rgb: [[]] };
    server.answer({ type: "atlas", id: coarse.id, key: COAT, values: [10, 60, 70], ...colours });
    const fine = server.received("atlas").at(-1);
    assert.deepEqual(fine?.values, values);
    server.answer({ type: "atlas", id: fine.id, key: COAT, values, ...colours });
    assert.equal(studio.atlas.store.get().busy, false);
    // Its own number in the paint does not matter; another does, and what is under way is given up.
    studio.edit((d) => setValue(d, path, 99));
    studio.atlas.want(studio.store.get().document.recipe, path, values, settings);
    assert.equal(studio.atlas.store.get().busy, false);
    studio.edit((d) => setValue(d, parsePath("layer[0].thickness_um"), 99));
    studio.atlas.want(studio.store.get().document.recipe, path, values, settings);
    assert.equal(studio.atlas.store.get().busy, true);
    studio.atlas.stop();
    assert.equal(studio.atlas.store.get().busy, false);
});

test("a program that does not know the page's token is told from one that has gone", async () => {
    const server = new FakeServer();
    const { studio } = await studioWith(server);
    server.refuses = true;
    server.drop();
    await settle();
    assert.equal(studio.store.get().connection, "refused");
    await server.reconnected;
    server.refuses = false;
    server.open();
    await settle();
    assert.equal(studio.store.get().connection, "open");
});

test("a text that no message holds is refused by its name, and nothing is sent", async () => {
    const server = new FakeServer();
    const { studio } = await studioWith(server);
    server.answerOpen(PAINT);
    const large = new File([new Uint8Array(9_000_000).fill(0x20)], "large.csv");
    studio.openFile(large);
    assert.match(studio.store.get().notice, /large\.csv has 9\.0 MB; at most 6\.0 MB/);
    studio.setStandard(" ".repeat(9_000_000), "typed.csv");
    assert.match(studio.store.get().notice, /typed\.csv has 9\.0 MB/);
    studio.openFile(new File([large], "large.toml"));
    assert.match(studio.store.get().notOpened ?? "", /large\.toml has 9\.0 MB; at most 6\.0 MB/);
    await settle();
    assert.equal(server.received("standard").length, 0);
    assert.equal(server.received("open").length, 1);
});

test("a standard that is refused leaves the one before, which is there again after a break", async () => {
    const server = new FakeServer();
    const { studio } = await studioWith(server);
    server.answerOpen(PAINT);
    studio.setStandard("good", "good.csv");
    const answer = (type: string) => {
        const id = server.received("standard").at(-1)?.id;
        server.answer({ type, id, name: "good.csv", notes: [], message: "bad" });
    };
    answer("standard");
    studio.setStandard("bad", "bad.csv");
    answer("error");
    assert.equal(studio.store.get().standard?.name, "good.csv");
    server.drop();
    await server.reconnected;
    server.open();
    await settle();
    assert.equal(server.received("standard").at(-1)?.csv, "good");
});

test("what is asked of a server that has gone is said or done when it is back", async () => {
    const server = new FakeServer();
    const { studio } = await studioWith(server);
    server.answerOpen(PAINT);
    let lost = false;
    const asked = studio.connection.ask(
        "report",
        {},
        () => undefined,
        undefined,
        () => {
            lost = true;
        },
    );
    assert.ok(asked);
    server.drop();
    assert.ok(lost);
    studio.fit([COAT], 1);
    assert.equal(studio.store.get().fit.running, false);
    assert.match(studio.store.get().fit.fault ?? "", /no server/);
    studio.openText("name = 1");
    assert.equal(server.received("open").at(-1)?.toml === "name = 1", false);
    await server.reconnected;
    server.open();
    await settle();
    assert.equal(server.received("open").at(-1)?.toml, "name = 1");
});

test("undo across another paint tells the server whose comments to keep, and drops what was found", async () => {
    const server = new FakeServer();
    const { studio } = await studioWith(server);
    server.answerOpen(PAINT);
    server.answerPaint();
    const first = server.received("open").at(-1)?.toml;
    studio.store.set({
        fitSetup: { said: new Map([[COAT, true]]), starts: 9 },
        fit: { ...studio.store.get().fit, matches: [] },
    });
    studio.openText("other");
    server.answerOpen({ ...PAINT, name: "Other" });
    server.answerPaint();
    assert.equal(studio.store.get().fit.matches, null);
    assert.deepEqual(studio.store.get().fitSetup, { said: new Map(), starts: 9 });
    studio.undo();
    assert.equal(server.received("open").at(-1)?.toml, first);
});

test("a link that is opened while the server is gone is not replaced by what was dropped before", async () => {
    const server = new FakeServer();
    const { studio } = await studioWith(server);
    server.answerOpen(PAINT);
    const link = await toFragment({ recipe: { ...PAINT, name: "Linked" }, locks: new Set() });
    server.drop();
    studio.openText("dropped");
    await studio.openLink(link);
    await server.reconnected;
    server.open();
    await settle();
    assert.ok(server.received("open").every(({ toml }) => toml !== "dropped"));
    assert.equal(studio.store.get().document.recipe.name, "Linked");
});

test("a paint of a link has not the comments of the text before it", async () => {
    const server = new FakeServer();
    const { studio } = await studioWith(server);
    server.answerOpen(PAINT);
    server.answerPaint();
    const count = server.received("open").length;
    await studio.openLink(await toFragment({ recipe: PAINT, locks: new Set() }));
    const told = server.received("open").slice(count);
    assert.equal(told.length, 1);
    assert.doesNotMatch(String(told[0]?.toml), /#/);
});

test("paints are read by the model that was chosen, and a match by that of its fit", async () => {
    const server = new FakeServer();
    const { studio } = await studioWith(server);
    server.answerOpen(PAINT);
    const models = () => server.received("paint").map(({ model }) => model);
    assert.deepEqual(models(), ["microflake"], "as the server wants to begin");
    server.answerPaint();
    assert.ok(isCurrent(studio.store.get()));
    let saved = "";
    studio.setSettings({ model: "nacre" });
    studio.whenCurrent(({ readingsBy }) => {
        saved = readingsBy?.model ?? "";
    });
    assert.ok(!isCurrent(studio.store.get()), "what is shown is of the other model");
    assert.equal(saved, "");
    assert.deepEqual(models(), ["microflake", "nacre"]);
    server.answerPaint();
    assert.equal(saved, "nacre");
    studio.undo();
    server.answerPaint();
    assert.equal(studio.store.get().settings.model, "nacre", "no part of the paint");

    studio.fit([COAT], 1);
    const fit = server.received("fit").at(-1);
    assert.equal(fit?.model, "nacre");
    studio.setSettings({ model: "microflake" });
    server.answerPaint();
    server.answer({ type: "matches", id: fit.id, matches: [{ recipe: PAINT, parameters: [] }] });
    assert.equal(server.received("paint").at(-1)?.model, "nacre");
    assert.equal(studio.store.get().fit.model, "nacre");
    server.answerPaint();
    assert.equal(studio.store.get().fit.colours.length, 1);
    assert.equal(studio.store.get().readingsBy?.model, "microflake");

    // Another program may begin with another model: the choice is the page's.
    server.drop();
    await server.reconnected;
    server.open();
    await settle();
    assert.equal(server.received("paint").at(-1)?.model, "microflake");
});

test("the model of the command line is there from the first reading on", async () => {
    const server = new FakeServer();
    const { studio } = await studioWith(server, { ...SCHEMA, reading_model: "nacre" });
    server.answerOpen(PAINT);
    assert.equal(server.received("paint")[0]?.model, "nacre");
    assert.equal(studio.store.get().settings.model, "nacre");
    const { document, settings } = studio.store.get();
    studio.atlas.want(document.recipe, parsePath(COAT), [1, 2], settings);
    while (server.received("atlas").length === 0) await settle();
    assert.equal(server.received("atlas")[0]?.model, "nacre");
    studio.atlas.stop();
});
