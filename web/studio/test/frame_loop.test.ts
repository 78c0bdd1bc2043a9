/** The loop of frames of the live picture, by a clock and a graphics processor of its own. */

import assert from "node:assert/strict";
import type { TestContext } from "node:test";
import { test } from "node:test";
import type { Drawing, Drawn } from "../src/renderer/frame_loop";
import { FrameLoop } from "../src/renderer/frame_loop";
import { REST_MS } from "../src/renderer/pace";

/** Between frames of the screen. */
const SCREEN_MS = 16;

class Stage implements Drawing {
    awaits = false;
    isNew = false;
    next: Drawn | null = { work: 1000, seen: "now" };
    /** When each was drawn and shown. */
    readonly drawn_ms: number[] = [];
    readonly shown_ms: number[] = [];
    readonly loop: FrameLoop;
    /** Of the graphics processor, for what it was told last. */
    private busyUntil = 0;
    private now_ms = 0;
    private readonly timers = new Map<number, { at_ms: number; then: () => void }>();
    /** For the screen's next frame. */
    private readonly waiting = new Map<number, () => void>();

    /** @param frame_ms  how long the graphics processor draws a frame */
    constructor(
        t: TestContext,
        private readonly frame_ms: number,
    ) {
        t.mock.method(performance, "now", () => this.now_ms);
        let timers = 0;
        t.mock.method(globalThis, "setTimeout", (then: () => void, wait_ms = 0) => {
            this.timers.set(++timers, { at_ms: this.now_ms + Math.max(1, wait_ms), then });
            return timers;
        });
        t.mock.method(globalThis, "clearTimeout", (timer: number) => this.timers.delete(timer));
        const screen = globalThis as unknown as Record<string, unknown>;
        let requests = 0;
        screen.requestAnimationFrame = (then: () => void) => {
            this.waiting.set(++requests, then);
            return requests;
        };
        screen.cancelAnimationFrame = (request: number) => this.waiting.delete(request);
        const gl = {
            SYNC_GPU_COMMANDS_COMPLETE: 1,
            TIMEOUT_EXPIRED: 2,
            fenceSync: () => ({}),
            flush: () => undefined,
            clientWaitSync: () => (this.now_ms < this.busyUntil ? 2 : 0),
            deleteSync: () => undefined,
        };
        this.loop = new FrameLoop(gl as unknown as WebGL2RenderingContext, this);
    }

    pass(time_ms: number): void {
        for (const until = this.now_ms + time_ms; this.now_ms < until;) {
            ++this.now_ms;
            for (const [timer, { at_ms, then }] of [...this.timers]) {
                if (at_ms > this.now_ms || !this.timers.delete(timer)) continue;
                then();
            }
            if (this.now_ms % SCREEN_MS !== 0) continue;
            const waited = [...this.waiting.values()];
            this.waiting.clear();
            for (const then of waited) then();
        }
    }

    takeNew(): boolean {
        const taken = this.isNew;
        this.isNew = false;
        return taken;
    }

    draw(): Drawn | null {
        if (this.next === null) return null;
        this.drawn_ms.push(this.now_ms);
        this.busyUntil = this.now_ms + this.frame_ms;
        return this.next;
    }

    show(): void {
        this.shown_ms.push(this.now_ms);
    }

    failed(error: unknown): void {
        throw error;
    }
}

test("a paint is drawn in the turn in which it comes, or when the frame under way ends", (t) => {
    const stage = new Stage(t, 40);
    stage.pass(5);
    stage.isNew = true;
    stage.loop.now();
    assert.deepEqual(stage.shown_ms, [5]);
    stage.pass(10);
    stage.isNew = true;
    stage.loop.now();
    assert.deepEqual(stage.shown_ms, [5], "the first is being drawn");
    stage.pass(50);
    const [, second = 0] = stage.shown_ms;
    assert.ok(second >= 45 && second <= 64, String(second));
});

test("what is new is drawn once while it is held, and refined when it no longer is", (t) => {
    const stage = new Stage(t, 10);
    stage.loop.hold(true);
    stage.loop.renew();
    stage.pass(200);
    assert.deepEqual(stage.drawn_ms, [SCREEN_MS]);
    stage.loop.hold(false);
    stage.pass(200);
    assert.ok(stage.drawn_ms.length > 5);
});

test("a draft is not refined before the next move may have come", (t) => {
    const stage = new Stage(t, 10);
    stage.loop.renew();
    stage.loop.rest();
    stage.pass(REST_MS - 1);
    assert.deepEqual(stage.drawn_ms, [SCREEN_MS]);
    stage.pass(100);
    assert.ok(stage.drawn_ms.length > 1);
});

test("nothing is drawn while it is paused; what is there is shown when it goes on", (t) => {
    const stage = new Stage(t, 10);
    stage.loop.pause();
    stage.isNew = true;
    stage.loop.now();
    stage.loop.renew();
    stage.pass(100);
    assert.deepEqual(stage.drawn_ms, []);
    stage.next = null; // all samples are there
    stage.loop.resume();
    stage.pass(100);
    assert.equal(stage.shown_ms.length, 1);
});

test("parts of samples follow each other at once, and are seen now and then or not at all", (t) => {
    const stage = new Stage(t, 6);
    stage.loop.renew();
    stage.pass(SCREEN_MS);
    stage.next = { work: 1000, seen: "soon" };
    stage.pass(1000);
    const soon = stage.shown_ms.length;
    assert.ok(soon >= 8 && soon <= 11, String(soon));
    assert.ok(stage.drawn_ms.length > 100, String(stage.drawn_ms.length));
    stage.next = { work: 1000, seen: "not" };
    stage.pass(1000);
    assert.equal(stage.shown_ms.length, soon);
});

test("a lost graphics processor is asked for nothing more", (t) => {
    const stage = new Stage(t, 10);
    stage.loop.renew();
    stage.pass(SCREEN_MS);
    stage.loop.end();
    stage.loop.resume();
    stage.pass(100);
    assert.deepEqual(stage.drawn_ms, [SCREEN_MS]);
});
