/** The program nacre: its commands, and the studio that it serves. */

import type { ChildProcess } from "node:child_process";
import { execFile, spawn } from "node:child_process";
import { env } from "node:process";
import { createInterface } from "node:readline";
import { promisify } from "node:util";
import type { Browser } from "playwright-core";
import { chromium } from "playwright-core";

const given = env.NACRE_PROGRAM;
if (given === undefined) throw new Error("NACRE_PROGRAM: the program nacre");
const program: string = given;

const run = promisify(execFile);

/** What a command writes to its standard output. */
export async function nacre(...args: string[]): Promise<string> {
    return (await run(program, [...args, "--quiet"], { maxBuffer: 1 << 24 })).stdout;
}

export class Program {
    private constructor(
        readonly url: string,
        private readonly process: ChildProcess,
    ) {}

    static async start(recipe: string, ...options: string[]): Promise<Program> {
        const process = spawn(program, ["studio", recipe, "--no-open", "--quiet", ...options], {
            stdio: ["ignore", "pipe", "inherit"],
        });
        const lines = createInterface({ input: process.stdout });
        for await (const line of lines) return new Program(line, process);
        throw new Error("nacre studio ended before it printed its address");
    }

    async end(): Promise<void> {
        const ended = new Promise((resolve) => this.process.once("exit", resolve));
        this.process.kill("SIGINT");
        await ended;
    }
}

export const CHROMIUM = "/usr/bin/chromium";

/**
 * For Debian's Chromium as it is without a graphics card: it draws the page itself, and WebGL 2 by SwiftShader, on
 * the same processor, where this flag allows it. NACRE_WEBGL has other flags: a card that Vulkan knows takes
 * "--use-angle=vulkan --enable-features=Vulkan --disable-vulkan-surface --ignore-gpu-blocklist".
 */
export function flags(webgl: boolean): string[] {
    const drawing = env.NACRE_WEBGL ?? "--enable-unsafe-swiftshader";
    return ["--no-sandbox", ...(webgl ? drawing.split(" ") : ["--disable-3d-apis"])];
}

export function launch(webgl = true): Promise<Browser> {
    return chromium.launch({ executablePath: CHROMIUM, args: flags(webgl) });
}
