/**
 * Chromium, asked by its own protocol for what is wanted and no more. Playwright watches all that goes over the
 * network: the browser copies each message of a paint to it, half a megabyte, while the picture is drawn. Pictures
 * come some 20 ms later by it, on two cores, and frames as a shape is turned 16 ms.
 */

import type { ChildProcess } from "node:child_process";
import { spawn } from "node:child_process";
import { mkdtemp, rm } from "node:fs/promises";
import { tmpdir } from "node:os";
import { join } from "node:path";
import type { Readable, Writable } from "node:stream";
import { CHROMIUM, flags } from "./program";

type Answer = Record<string, unknown>;

interface Waiting {
    readonly then: (answer: Answer) => void;
    readonly fail: (error: Error) => void;
}

/** What `--remote-debugging-pipe` reads and writes: JSON, each message ended by a zero. */
class Pipe {
    private readonly waiting = new Map<number, Waiting>();
    private text = "";
    private last = 0;

    constructor(
        private readonly out: Writable,
        input: Readable,
    ) {
        input.setEncoding("utf8");
        input.on("data", (part: string) => {
            const messages = (this.text + part).split("\0");
            this.text = messages.pop() ?? "";
            for (const message of messages) this.read(message);
        });
        input.on("close", () => {
            for (const { fail } of this.waiting.values()) fail(new Error("the browser ended"));
        });
    }

    send(method: string, params: Answer, sessionId?: string): Promise<Answer> {
        const id = ++this.last;
        return new Promise((then, fail) => {
            this.waiting.set(id, { then, fail });
            this.out.write(`${JSON.stringify({ id, method, params, sessionId })}\0`);
        });
    }

    private read(message: string): void {
        const { id, result, error } = JSON.parse(message) as {
            readonly id?: number;
            readonly result?: Answer;
            readonly error?: { readonly message: string };
        };
        const asked = id === undefined ? undefined : this.waiting.get(id);
        if (id === undefined || asked === undefined) return; // an event
        this.waiting.delete(id);
        if (error) asked.fail(new Error(error.message));
        else asked.then(result ?? {});
    }
}

/** One page of a browser of its own. */
export class UnwatchedPage {
    private constructor(
        private readonly pipe: Pipe,
        private readonly session: string,
        private readonly process: ChildProcess,
        private readonly profile: string,
    ) {}

    /** An empty page. */
    static async open(width: number, height: number): Promise<UnwatchedPage> {
        const profile = await mkdtemp(join(tmpdir(), "nacre-chromium-"));
        const process = spawn(
            CHROMIUM,
            [
                "--headless",
                "--no-first-run",
                "--remote-debugging-pipe",
                `--user-data-dir=${profile}`,
                `--window-size=${String(width)},${String(height)}`,
                ...flags(true),
            ],
            { stdio: ["ignore", "ignore", "ignore", "pipe", "pipe"] },
        );
        const pipe = new Pipe(process.stdio[3] as Writable, process.stdio[4] as Readable);
        const { targetId } = await pipe.send("Target.createTarget", { url: "about:blank" });
        const attached = await pipe.send("Target.attachToTarget", { targetId, flatten: true });
        const page = new UnwatchedPage(pipe, String(attached.sessionId), process, profile);
        const size = { width, height, deviceScaleFactor: 1, mobile: false };
        await page.send("Emulation.setDeviceMetricsOverride", size);
        return page;
    }

    /** @param before  runs in the page before its own script */
    async goto(url: string, before: () => void): Promise<void> {
        await this.send("Page.enable", {});
        const source = `(${before.toString()})()`;
        await this.send("Page.addScriptToEvaluateOnNewDocument", { source });
        await this.send("Page.navigate", { url });
        await this.send("Page.disable", {});
    }

    /** What a function makes in the page, which is handed what JSON can tell. */
    async evaluate<Given, Made>(
        make: (given: Given) => Made | Promise<Made>,
        given: Given,
    ): Promise<Made> {
        const { result, exceptionDetails } = (await this.send("Runtime.evaluate", {
            expression: `(${make.toString()})(${JSON.stringify(given)})`,
            awaitPromise: true,
            returnByValue: true,
        })) as { result: { value: Made }; exceptionDetails?: unknown };
        if (exceptionDetails !== undefined) throw new Error(JSON.stringify(exceptionDetails));
        return result.value;
    }

    /** Waits until a function of the page is true, which is asked every millisecond. */
    async until<Given>(isTrue: (given: Given) => boolean, given: Given): Promise<void> {
        const { exceptionDetails } = await this.send("Runtime.evaluate", {
            expression: `new Promise((then) => {
                const look = () => {
                    if ((${isTrue.toString()})(${JSON.stringify(given)})) then();
                    else setTimeout(look, 1);
                };
                look();
            })`,
            awaitPromise: true,
        });
        if (exceptionDetails !== undefined) throw new Error(JSON.stringify(exceptionDetails));
    }

    async pressRight(): Promise<void> {
        const key = { key: "ArrowRight", code: "ArrowRight", windowsVirtualKeyCode: 39 };
        await this.send("Input.dispatchKeyEvent", { type: "rawKeyDown", ...key });
        await this.send("Input.dispatchKeyEvent", { type: "keyUp", ...key });
    }

    /** The left button, pressed, moved or released. */
    async mouse(type: "mousePressed" | "mouseMoved" | "mouseReleased", x: number, y: number) {
        const button = { button: "left", buttons: type === "mouseReleased" ? 0 : 1, clickCount: 1 };
        await this.send("Input.dispatchMouseEvent", { type, x, y, ...button });
    }

    async close(): Promise<void> {
        const ended = new Promise((resolve) => this.process.once("exit", resolve));
        this.process.kill();
        await ended;
        await rm(this.profile, { recursive: true, force: true, maxRetries: 5 });
    }

    private send(method: string, params: Answer): Promise<Answer> {
        return this.pipe.send(method, params, this.session);
    }
}
