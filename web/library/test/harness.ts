/** A browser with the page of a library, and what that page must say. */

import assert from "node:assert/strict";
import { mkdtemp, readFile, rm } from "node:fs/promises";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { env } from "node:process";
import { after, before } from "node:test";
import { pathToFileURL } from "node:url";
import type { BrowserContext, Page } from "playwright-core";
import { chromium } from "playwright-core";

/** As python/tests/synthetic_library.py writes it. */
interface Expected {
    readonly target: readonly [number, number, number];
    readonly nearest: Readonly<Record<string, readonly (readonly [string, number])[]>>;
    readonly with_Fe2O3_mica: number;
    readonly flop_10_to_20: number;
    readonly hue_300_to_40: number;
    readonly sparkling: number;
    readonly ids: readonly string[];
    readonly nasty: { readonly id: string; readonly name: string };
    readonly first: { readonly id: string; readonly chips: readonly string[] };
    readonly difference: {
        readonly standard: string;
        readonly sample: string;
        readonly geometries: readonly string[];
        readonly dLab: readonly (readonly number[])[];
        readonly dC: readonly number[];
        readonly dH: readonly number[];
        readonly dE2000: readonly number[];
        readonly mean: number;
        readonly max: number;
    };
}

const given = env.LIBRARY;
if (given === undefined) throw new Error("LIBRARY: the folder of a library that has a page");
export const library: string = given;
export const home = pathToFileURL(join(library, "index.html")).href;

export let expected: Expected;
let profile: string;
let context: BrowserContext;
export let page: Page;
const faults: string[] = [];

before(async () => {
    expected = JSON.parse(await readFile(join(library, "expected.json"), "utf8")) as Expected;
    profile = await mkdtemp(join(tmpdir(), "nacre-page-"));
    context = await chromium.launchPersistentContext(profile, {
        executablePath: "/usr/bin/chromium",
        args: [
            "--no-sandbox",
            "--disable-gpu",
            "--disable-background-networking",
            "--disable-component-update",
            "--disable-sync",
            "--no-first-run",
        ],
        viewport: { width: 1280, height: 800 },
    });
    page = await context.newPage();
    page.setDefaultTimeout(900_000); // what never comes is a failure, however slow the machine
    page.on("console", (message) => {
        if (message.type() === "error") faults.push(message.text());
    });
    page.on("pageerror", (error) => faults.push(String(error)));
    page.on("request", (request) => {
        const local = /^(file:|data:|blob:|http:\/\/localhost:)/.test(request.url());
        if (!local) faults.push(`asked for ${request.url()}`);
    });
});

after(async () => {
    await context.close();
    await rm(profile, { recursive: true, force: true });
    assert.deepEqual(faults, [], "no error in the console, nothing from elsewhere");
});

export async function open(hash: string): Promise<void> {
    await page.goto("about:blank");
    await page.goto(`${home}#${hash}`);
    await page.waitForSelector(".card:not([hidden]), .record");
}

/** Cards in the order in which they are shown, of those rows that exist. */
export async function shownIds(): Promise<string[]> {
    return page.$$eval(".card:not([hidden])", (cards) =>
        cards
            .filter((card) => !card.closest<HTMLElement>(".row")?.hidden)
            .map((card) => ({
                index: Number((card as HTMLElement).dataset.index),
                id: card.querySelector("a")?.hash.split("/").pop() ?? "",
            }))
            .sort((a, b) => a.index - b.index)
            .map((card) => card.id),
    );
}

/** Waits until the gallery says that it shows so many, and returns what it says. */
export async function count(wanted: number): Promise<void> {
    const text = wanted.toLocaleString("en").replace(/,/g, "\u2009");
    await page.waitForFunction((n) => document.querySelector(".count b")?.textContent === n, text);
}

export const plain = (text: string | null) => Number((text ?? "").replace("\u2212", "-"));

/** As the page prints numbers, for comparing with exact ones. */
export function rounds(shown: number, exact: number, decimals: number): void {
    const step = 10 ** -decimals;
    assert.ok(
        Math.abs(shown - exact) <= 0.5 * step + 1e-9,
        `the page shows ${String(shown)} for ${String(exact)}`,
    );
}
