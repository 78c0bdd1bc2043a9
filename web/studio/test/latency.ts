/**
 * How long the page takes: from a key that moves a film to its chips, and to the live picture of the new
 * paint as the graphics processor has drawn it; and from one drawn frame to the next while the picture is
 * turned. Figures of docs/studio.md:
 *
 *     ./dev studio --latency
 *
 * Arguments: [MOVES [PAINT [KEY [WIDTHxHEIGHT [REST_MS]]]]], by default 30 moves of a film of red-gold in a
 * window of 1280 x 800, each 120 to 220 ms after the picture of the one before was seen. Which renderer draws is said first (test/program.ts tells how to choose it).
 */

import assert from "node:assert/strict";
import { loadavg } from "node:os";
import { argv } from "node:process";
import { setTimeout as sleep } from "node:timers/promises";
import { UnwatchedPage } from "./devtools";
import { Program } from "./program";

/** What the page tells, by the clock of the browser. */
interface Clock {
    /** The last key. */
    key_ms: number;
    /** From the key to its chips on the screen. */
    chips_ms: number[];
    /** From the key until the page had sent the paint. */
    sent_ms: number[];
    /** From the key until the browser had the numbers of the live picture. */
    numbers_ms: number[];
    /** From the key until the page had handed the first frame of a new paint to the graphics processor. */
    begun_ms: number[];
    /** From the key to the first frame of a new paint, drawn. */
    pictures_ms: number[];
    /** When each frame had been drawn on the canvas that is seen. */
    frames_ms: number[];
}

declare global {
    interface Window {
        clock: Clock;
    }
}

/** Runs in the page before its own script: notes when the graphics processor has drawn. */
function watchDrawing(): void {
    const clock: Clock = {
        key_ms: 0,
        chips_ms: [],
        sent_ms: [],
        numbers_ms: [],
        begun_ms: [],
        pictures_ms: [],
        frames_ms: [],
    };
    window.clock = clock;
    addEventListener("keydown", () => (clock.key_ms = performance.now()), true);
    new MutationObserver(() => {
        const current = document.querySelector(".chips")?.getAttribute("data-current") === "true";
        if (!current || clock.key_ms === 0) return;
        const begun_ms = clock.key_ms;
        // A task that a frame starts runs when the frame is on its way.
        requestAnimationFrame(() => {
            setTimeout(() => clock.chips_ms.push(performance.now() - begun_ms));
        });
    }).observe(document, { subtree: true, attributeFilter: ["data-current"] });
    const Plain = window.WebSocket;
    window.WebSocket = class extends Plain {
        constructor(...given: ConstructorParameters<typeof Plain>) {
            super(...given);
            this.addEventListener("message", ({ data }) => {
                if (typeof data !== "string" || !/"type": ?"shader"/.test(data)) return;
                clock.numbers_ms.push(performance.now() - clock.key_ms);
            });
        }
        override send(data: Parameters<WebSocket["send"]>[0]): void {
            super.send(data);
            if (typeof data === "string" && data.startsWith('{"type":"paint"')) {
                clock.sent_ms.push(performance.now() - clock.key_ms);
            }
        }
    };
    const prototype = WebGL2RenderingContext.prototype;
    let onScreen = true;
    let paintIsNew = false;
    /* eslint-disable @typescript-eslint/unbound-method -- called on what they are asked of */
    const { bindFramebuffer, texSubImage3D, texImage3D, drawArrays, drawElements } = prototype;
    /* eslint-enable @typescript-eslint/unbound-method */
    prototype.bindFramebuffer = function (target, buffer) {
        if (target !== this.READ_FRAMEBUFFER) onScreen = buffer === null;
        bindFramebuffer.call(this, target, buffer);
    };
    // Multiple scattering, which every paint has, is the only texture of three dimensions.
    prototype.texSubImage3D = function (...given: unknown[]) {
        paintIsNew = true;
        Reflect.apply(texSubImage3D, this, given);
    };
    prototype.texImage3D = function (...given: unknown[]) {
        paintIsNew = true;
        Reflect.apply(texImage3D, this, given);
    };
    const noted = (gl: WebGL2RenderingContext) => {
        if (!onScreen) return;
        const begun_ms = paintIsNew ? clock.key_ms : null;
        paintIsNew = false;
        const sync = gl.fenceSync(gl.SYNC_GPU_COMMANDS_COMPLETE, 0);
        if (sync === null) return;
        gl.flush();
        // Of the last key: a picture of the one before may come late.
        const isLast = () => begun_ms !== null && begun_ms === clock.key_ms;
        if (isLast()) clock.begun_ms.push(performance.now() - clock.key_ms);
        const look = () => {
            if (gl.clientWaitSync(sync, 0, 0) === gl.TIMEOUT_EXPIRED) {
                setTimeout(look, 1);
                return;
            }
            gl.deleteSync(sync);
            const now_ms = performance.now();
            clock.frames_ms.push(now_ms);
            if (isLast()) clock.pictures_ms.push(now_ms - clock.key_ms);
        };
        look();
    };
    prototype.drawArrays = function (...given) {
        drawArrays.apply(this, given);
        noted(this);
    };
    prototype.drawElements = function (...given) {
        drawElements.apply(this, given);
        noted(this);
    };
}

function quantile(values: readonly number[], fraction: number): string {
    assert.ok(values.length > 0, "nothing was measured");
    const sorted = [...values].sort((a, b) => a - b);
    return (sorted[Math.floor(fraction * (sorted.length - 1))] as number).toFixed(1);
}

function report(what: string, values: readonly number[]): void {
    const of = (fraction: number) => quantile(values, fraction);
    console.log(
        `${what}: median ${of(0.5)} ms, nine of ten within ${of(0.9)}, slowest ${of(1)} (${String(values.length)})`,
    );
}

type Times = "chips_ms" | "sent_ms" | "numbers_ms" | "begun_ms" | "pictures_ms";
const TIMES: readonly Times[] = ["chips_ms", "sent_ms", "numbers_ms", "begun_ms", "pictures_ms"];

/** Waits until all of them have been noted. */
function seen(page: UnwatchedPage, times: readonly Times[]): Promise<void> {
    return page.until((names) => names.every((name) => window.clock[name].length > 0), times);
}

/** @returns from the key to the chips, in ms */
async function move(page: UnwatchedPage): Promise<number> {
    await page.evaluate((names) => {
        for (const name of names) window.clock[name].length = 0;
    }, TIMES);
    await page.pressRight();
    await seen(page, ["chips_ms"]);
    return page.evaluate(() => window.clock.chips_ms[0] as number, null);
}

/** From the key, in ms. */
interface FirstPicture {
    sent_ms: number;
    numbers_ms: number;
    begun_ms: number;
    drawn_ms: number;
}

async function firstPicture(page: UnwatchedPage): Promise<FirstPicture> {
    await seen(page, ["numbers_ms", "pictures_ms"]);
    return page.evaluate(() => {
        const { sent_ms, numbers_ms, begun_ms, pictures_ms } = window.clock;
        const first = (times: number[]) => times[0] as number;
        return {
            sent_ms: first(sent_ms),
            numbers_ms: first(numbers_ms),
            begun_ms: first(begun_ms),
            drawn_ms: first(pictures_ms),
        };
    }, null);
}

/** Each after all of the one before was seen, or at once on its chips. */
async function moves(
    page: UnwatchedPage,
    count: number,
    key: string,
    rest_ms: number,
): Promise<void> {
    await page.evaluate((slider) => {
        const found = document.querySelector<HTMLInputElement>(slider);
        if (found === null) throw new Error(`${slider}: the page has no such slider`);
        found.focus();
    }, `[data-key='${key}'] input[type=range]`);
    const chips: number[] = [];
    const pictures: FirstPicture[] = [];
    for (let i = 0; i < count; ++i) {
        chips.push(await move(page));
        pictures.push(await firstPicture(page));
        await sleep(rest_ms + 100 * Math.random());
    }
    report("from a key to its chips", chips);
    const steps: [keyof FirstPicture, string][] = [
        ["sent_ms", "from a key until its paint is sent"],
        ["numbers_ms", "from a key to the numbers of its live picture"],
        ["begun_ms", "from a key until its live picture is handed to the graphics processor"],
        ["drawn_ms", "from a key to its live picture"],
    ];
    for (const [step, what] of steps) {
        report(
            what,
            pictures.map((times) => times[step]),
        );
    }
    const atOnce: number[] = [];
    for (let i = 0; i < count; ++i) atOnce.push(await move(page));
    report("from a key to its chips, moves at once upon chips", atOnce);
}

async function frames(page: UnwatchedPage, count: number): Promise<void> {
    const box = await page.evaluate(() => {
        const { x, y, width, height } = (
            document.querySelector("canvas.live") as Element
        ).getBoundingClientRect();
        return { x, y, width, height };
    }, null);
    const middle = { x: box.x + box.width / 2, y: box.y + box.height / 2 };
    await page.mouse("mousePressed", middle.x, middle.y);
    await page.evaluate(() => {
        window.clock.frames_ms.length = 0;
    }, null);
    for (let i = 0; i < 4 * count; ++i) {
        await page.mouse("mouseMoved", middle.x + 60 * Math.sin(i / 20), middle.y);
        await sleep(8);
    }
    await page.mouse("mouseReleased", middle.x, middle.y);
    const drawn = await page.evaluate(() => window.clock.frames_ms, null);
    report(
        `between frames of ${box.width.toFixed(0)} x ${box.height.toFixed(0)} pixels as the ball is turned`,
        drawn.slice(1).map((at_ms, i) => at_ms - (drawn[i] as number)),
    );
}

async function measure(page: UnwatchedPage, url: string): Promise<void> {
    await page.goto(url, watchDrawing);
    await page.until(() => document.querySelector(".chips[data-current=true]") !== null, null);
    await page.until(() => window.clock.frames_ms.length > 0, null);
    const renderer = await page.evaluate(() => {
        const gl = document.createElement("canvas").getContext("webgl2");
        const told = gl?.getExtension("WEBGL_debug_renderer_info");
        return told ? String(gl?.getParameter(told.UNMASKED_RENDERER_WEBGL)) : "not told";
    }, null);
    console.log(`drawn by ${renderer}`);
    await sleep(2000); // shaders are compiled, the first pictures drawn
    await moves(page, count, key, rest_ms);
    await frames(page, count);
    console.log(`load ${(loadavg()[0] as number).toFixed(1)}`);
}

const FILM = "layer[0].flakes[0].coats[0].thickness_nm";
const [, , given = "30", paint = "red-gold", key = FILM, size = "1280x800", rest = "120"] = argv;
const count = Number(given);
if (!(Number.isInteger(count) && count > 0))
    throw new Error("MOVES: must be a whole number above 0");
const [width = NaN, height = NaN] = size.split("x").map(Number);
if (!(width >= 600 && height >= 400)) throw new Error("WIDTHxHEIGHT: must be 600x400 at least");
const rest_ms = Number(rest);
if (!(rest_ms >= 0)) throw new Error("REST_MS: must be a number, 0 at least");
const program = await Program.start(paint);
try {
    const page = await UnwatchedPage.open(width, height);
    try {
        await measure(page, program.url);
    } finally {
        await page.close();
    }
} finally {
    await program.end();
}
