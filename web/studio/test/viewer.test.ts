/** Which pictures are asked for and shown, against a server that says what a test wants. */

import assert from "node:assert/strict";
import { test } from "node:test";
import { Session } from "../src/session";
import type { Table } from "../src/tree";
import type { ViewerState } from "../src/viewer";
import { covers, keptText, Viewer } from "../src/viewer";
import { FakeServer, PAINT, WITH_BALL } from "./fake_server";

const OTHER: Table = { ...PAINT, ior: 1.6 };

/**
 * The picture that was asked for last, with so many samples, else all.
 * @return what was asked
 */
async function answerRender(server: FakeServer, before: number, done?: number) {
    for (let i = 0; i < 3000 && server.received("render").length === before; ++i) {
        await new Promise((resolve) => setTimeout(resolve, 10));
    }
    const asked = server.received("render").at(-1);
    assert.equal(server.received("render").length, before + 1, "a picture is asked for");
    const { id, width, height, samples } = asked as Record<string, number>;
    const shape = [height, width, 3];
    const binary = [{ name: "rgb", dtype: "u8", shape }];
    server.answer({
        type: "picture",
        id,
        samples: done ?? samples,
        of: samples,
        width,
        height,
        binary,
    });
    server.answerBytes(new ArrayBuffer(Math.ceil((3 * (width ?? 0) * (height ?? 0)) / 4) * 4));
    return { recipe: asked?.recipe, samples };
}

test("A is made whole where a draft of it was kept", async () => {
    const server = new FakeServer();
    const session = new Session(server.connect, () => undefined);
    server.open();
    const viewer = new Viewer(session);
    viewer.resize(48, 48);
    viewer.begin(WITH_BALL);
    viewer.paint(PAINT);
    assert.deepEqual(await answerRender(server, 0), { recipe: PAINT, samples: 1 });
    viewer.keep(PAINT);
    assert.equal(viewer.store.get().kept?.samples, 1);
    await answerRender(server, 1); // B, which is the same as yet
    viewer.paint(OTHER);
    assert.deepEqual(await answerRender(server, 2), { recipe: OTHER, samples: 1 });
    assert.deepEqual(await answerRender(server, 3), { recipe: OTHER, samples: 64 });
    assert.deepEqual(await answerRender(server, 4), { recipe: PAINT, samples: 16 });
    assert.equal(viewer.store.get().kept?.samples, 16);
    session.close();
});

/** A viewer of the paint, whose draft was seen. */
async function viewerOf(server: FakeServer) {
    const session = new Session(server.connect, () => undefined);
    server.open();
    const viewer = new Viewer(session);
    viewer.resize(48, 48);
    viewer.begin(WITH_BALL);
    viewer.paint(PAINT);
    await answerRender(server, 0);
    return { session, viewer };
}

test("A gets its samples as soon as B has enough to be seen, and B the rest after it", async () => {
    const server = new FakeServer();
    const { session, viewer } = await viewerOf(server);
    viewer.keep(PAINT);
    await answerRender(server, 1);
    viewer.paint(OTHER);
    await answerRender(server, 2);
    assert.equal(keptText(viewer.store.get()), "draft");
    assert.deepEqual(await answerRender(server, 3, 8), { recipe: OTHER, samples: 64 });
    assert.equal(server.received("render").length, 4, "B cannot be seen yet");
    await answerRender(server, 3, 16);
    assert.equal(server.received("stop").length, 1);
    assert.deepEqual(await answerRender(server, 4), { recipe: PAINT, samples: 16 });
    assert.equal(keptText(viewer.store.get()), "16");
    assert.deepEqual(await answerRender(server, 5, 4), { recipe: OTHER, samples: 64 });
    assert.equal(viewer.store.get().picture?.samples, 16, "B is not seen worse meanwhile");
    await answerRender(server, 5);
    assert.equal(viewer.store.get().picture?.samples, 64);
    assert.equal(server.received("render").length, 6);
    session.close();
});

test("a picture that is begun anew takes the place of a better one of the same when it is as good", async () => {
    const server = new FakeServer();
    const { session, viewer } = await viewerOf(server);
    await answerRender(server, 1, 40);
    viewer.hold("atlas", true);
    assert.equal(server.received("stop").length, 1);
    viewer.hold("atlas", false);
    await answerRender(server, 2, 1);
    assert.equal(viewer.store.get().picture?.samples, 40);
    await answerRender(server, 2, 41);
    assert.equal(viewer.store.get().picture?.samples, 41);
    viewer.resize(60, 60);
    await answerRender(server, 3);
    assert.equal(viewer.store.get().picture?.samples, 1, "of another size");
    session.close();
});

test("in a light with lines the path tracer's picture is shown when it is whole", () => {
    const session = new Session(new FakeServer().connect, () => undefined);
    const viewer = new Viewer(session);
    const lights = [
        { name: "studio", title: "Studio", illuminant: "D65" },
        { name: "booth-fl11", title: "Booth, FL11", illuminant: "FL11" },
    ];
    viewer.begin({ ...WITH_BALL, lights });
    assert.equal(viewer.store.get().enough, 16);
    viewer.setView({ light: "booth-fl11" });
    assert.equal(viewer.store.get().enough, 64);
    viewer.setView({ light: "studio" });
    assert.equal(viewer.store.get().enough, 16);
    session.close();
});

test("the path tracer's picture covers the live one when it is of use, but not its marks", () => {
    const view = { shape: "ball" } as unknown as ViewerState["view"];
    const picture = { samples: 16, of: 64, recipe: PAINT, view } as ViewerState["picture"];
    const state = { picture, recipe: PAINT, view, liveSamples: 3, gamutWarning: false, enough: 16 };
    const all = state as unknown as ViewerState;
    assert.ok(covers(all));
    assert.ok(!covers({ ...all, recipe: OTHER }), "of another paint");
    assert.ok(!covers({ ...all, gamutWarning: true }), "marks are in the live picture");
    assert.ok(covers({ ...all, gamutWarning: true, liveSamples: null }), "there is no other");
});
