/** The program `nacre studio` and a browser on its page. */

import assert from "node:assert/strict";
import { mkdtemp, readFile, rm } from "node:fs/promises";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { after, before } from "node:test";
import type { Browser, Download, Page } from "playwright-core";
import { launch, Program } from "./program";

export let folder: string;
export let page: Page;
export let studio: Program;
let browser: Browser;
const faults: string[] = [];

export async function newPage(): Promise<Page> {
    const made = await browser.newPage({ viewport: { width: 1280, height: 800 } });
    made.setDefaultTimeout(900_000); // what never comes is a failure, however slow the machine
    made.on("console", (message) => {
        if (message.type() === "error") faults.push(message.text());
    });
    made.on("pageerror", (error) => faults.push(String(error)));
    made.on("request", (request) => {
        const here = /^(http:\/\/127\.0\.0\.1:|data:|blob:)/.test(request.url());
        if (!here) faults.push(`asked for ${request.url()}`);
    });
    return made;
}

/** For all tests of a file. */
export function begin(webgl: boolean): void {
    before(async () => {
        folder = await mkdtemp(join(tmpdir(), "nacre-studio-"));
        studio = await Program.start("red-gold");
        browser = await launch(webgl);
        page = await newPage();
    });

    after(async () => {
        await browser.close();
        await studio.end();
        await rm(folder, { recursive: true, force: true });
        assert.deepEqual(faults, [], "no error in the console, nothing from elsewhere");
    });
}

/** What must be overlooked because a test brings it about, as a connection that is refused. */
export function forgive(pattern: RegExp): void {
    faults.splice(0, faults.length, ...faults.filter((fault) => !pattern.test(fault)));
}

/** The page anew, with the paint of the command line, when its colours are there. */
export async function open(fragment = ""): Promise<void> {
    await page.goto("about:blank");
    await page.goto(studio.url + fragment);
    await settled();
}

/** Waits until the colours are those of the recipe in the form. */
export async function settled(): Promise<void> {
    await page.waitForFunction(
        () => document.querySelector(".chips")?.getAttribute("data-current") === "true",
    );
}

/** L*a*b* of the chips, by geometry. */
export async function chips(): Promise<Map<string, number[]>> {
    return new Map(
        await page.$$eval(".chip", (found) =>
            found.map((chip): [string, number[]] => {
                const { geometry, lab } = (chip as HTMLElement).dataset;
                return [geometry ?? "", (lab ?? "").split(" ").map(Number)];
            }),
        ),
    );
}

export async function saved(button: string): Promise<{ name: string; text: string; path: string }> {
    const [download] = await Promise.all([
        page.waitForEvent("download"),
        page.getByRole("button", { name: button, exact: true }).click(),
    ]);
    return kept(download);
}

async function kept(download: Download) {
    const name = download.suggestedFilename();
    const path = join(folder, name);
    await download.saveAs(path);
    return { name, path, text: await readFile(path, "utf8") };
}

/** Rows of a table with a header, by its columns. */
export function parsedCsv(text: string): Record<string, string>[] {
    const [head = "", ...lines] = text.trim().split("\n");
    const names = head.split(",");
    return lines.map((line) =>
        Object.fromEntries(line.split(",").map((cell, i) => [names[i] ?? "", cell])),
    );
}

/** Types a number of the recipe. */
export async function type(key: string, value: string): Promise<void> {
    await page.fill(field(key), value);
    await page.press(field(key), "Enter");
}

/** The film of silica, whose thickness turns the colour. */
export const FILM = "layer[0].flakes[0].coats[0].thickness_nm";
export const row = (key: string) => `[data-key='${key}']`;
export const slider = (key: string) => `${row(key)} input[type=range]`;
export const field = (key: string) => `${row(key)} input[type=text]`;
