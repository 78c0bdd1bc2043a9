/**
 * The page in Debian's Chromium, opened from disk, with 10 000 records. What must be found was computed
 * by the Python package (python/tests/synthetic_library.py).
 *
 *     LIBRARY=FOLDER node --test browser.mjs
 */

import assert from "node:assert/strict";
import { mkdtemp, readFile, rm } from "node:fs/promises";
import { createServer } from "node:http";
import type { AddressInfo } from "node:net";
import { tmpdir } from "node:os";
import { extname, join, normalize } from "node:path";
import { env } from "node:process";
import { after, before, test } from "node:test";
import { pathToFileURL } from "node:url";
import type { BrowserContext, Page } from "playwright-core";
import { chromium } from "playwright-core";

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

const library = env.LIBRARY;
if (library === undefined) throw new Error("LIBRARY: the folder of a library that has a page");
const home = pathToFileURL(join(library, "index.html")).href;

let expected: Expected;
let profile: string;
let context: BrowserContext;
let page: Page;
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

async function open(hash: string): Promise<void> {
    await page.goto("about:blank");
    await page.goto(`${home}#${hash}`);
    await page.waitForSelector(".card:not([hidden]), .record");
}

/** Cards in the order in which they are shown, of those rows that exist. */
async function shownIds(): Promise<string[]> {
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
async function count(wanted: number): Promise<void> {
    const text = wanted.toLocaleString("en").replace(/,/g, "\u2009");
    await page.waitForFunction((n) => document.querySelector(".count b")?.textContent === n, text, {
        timeout: 10_000,
    });
}

const plain = (text: string | null) => Number((text ?? "").replace("\u2212", "-"));

/** As the page prints numbers, for comparing with exact ones. */
function rounds(shown: number, exact: number, decimals: number): void {
    const step = 10 ** -decimals;
    assert.ok(
        Math.abs(shown - exact) <= 0.5 * step + 1e-9,
        `the page shows ${String(shown)} for ${String(exact)}`,
    );
}

test("all records are there, and few of them as elements", async () => {
    await open("/");
    await count(expected.ids.length);
    const cards = await page.$$eval(".card", (found) => found.length);
    assert.ok(cards > 10 && cards < 120, `${String(cards)} cards`);
    const height = await page.$eval(".canvas", (canvas) => canvas.clientHeight);
    assert.ok(height > (expected.ids.length / 10) * 150);
});

test("the last record is reached and is the last", async () => {
    await open("/");
    await page.focus(".card a[tabindex='0']");
    await page.keyboard.press("End");
    const last = await page.$eval(":focus", (link) =>
        Number((link.closest(".card") as HTMLElement).dataset.index),
    );
    assert.equal(last, expected.ids.length - 1);
    await page.keyboard.press("Home");
    const first = await page.$eval(":focus", (link) =>
        Number((link.closest(".card") as HTMLElement).dataset.index),
    );
    assert.equal(first, 0);
});

test("filters find as many as the catalogue has", async () => {
    await open("/");
    await page.fill("[aria-label='Flop index from, as a number']", "10");
    await page.fill("[aria-label='Flop index to, as a number']", "20");
    await page.keyboard.press("Enter");
    await count(expected.flop_10_to_20);
    await page.click(".reset");
    await count(expected.ids.length);

    await page.fill("[aria-label='Hue h from, as a number']", "300");
    await page.fill("[aria-label='Hue h to, as a number']", "40");
    await page.keyboard.press("Enter");
    await count(expected.hue_300_to_40);
    await page.click(".reset");

    await page.getByLabel("Fe2O3|mica", { exact: false }).first().check();
    await count(expected.with_Fe2O3_mica);
    await page.click(".reset");

    await page.fill("[aria-label='Sparkle from, as a number']", "50");
    await page.keyboard.press("Enter");
    await count(expected.sparkling);
    await page.click(".reset");

    const id = expected.ids[expected.ids.length - 1] as string;
    await page.fill("[aria-label='Search by name or hash']", id.slice(0, 16));
    await count(1);
    assert.deepEqual(await shownIds(), [id]);
});

test("a slider limits, and the keyboard moves it", async () => {
    await open("/");
    await count(expected.ids.length);
    await page.focus("[aria-label='Flop index from']");
    for (let i = 0; i < 30; ++i) await page.keyboard.press("ArrowRight");
    await page.waitForFunction(() => location.hash.includes("flop="));
    const address = await page.evaluate(() => location.hash);
    const from = Number(/flop=([\d.]+)\.\./.exec(address)?.[1]);
    assert.ok(from > 0, address);
    assert.notEqual(await page.textContent(".count b"), String(expected.ids.length));
});

for (const angle of ["45as15", "45as45", "45as-15"]) {
    test(`the nearest at ${angle} are those that nacre.delta_e_2000 finds`, async () => {
        await open("/");
        await page.selectOption(".at select", angle);
        const [L, a, b] = expected.target.map(String) as [string, string, string];
        await page.fill("[aria-label='L* to be near to']", L);
        await page.fill("[aria-label='a* to be near to']", a);
        await page.fill("[aria-label='b* to be near to']", b);
        await page.waitForFunction(() => location.hash.includes("sort=nearness"));
        const wanted = expected.nearest[angle] ?? [];
        assert.ok(wanted.length >= 20);
        await page.waitForFunction(
            (id) =>
                document
                    .querySelector(".card[data-index='0'] a")
                    ?.getAttribute("href")
                    ?.endsWith(id),
            wanted[0]?.[0] ?? "",
        );
        assert.deepEqual(
            (await shownIds()).slice(0, wanted.length),
            wanted.map(([id]) => id),
        );
        for (const [i, [, distance]] of wanted.entries()) {
            const text = await page.textContent(`.card[data-index='${String(i)}'] .numbers`);
            rounds(Number(/ΔE2000 ([\d.]+)/.exec(text ?? "")?.[1]), distance, 2);
        }
    });
}

test("a record's page says what record.json says", async () => {
    const { id, chips } = expected.first;
    const folder = join(library, "records", id.slice(0, 2), id);
    const record = JSON.parse(await readFile(join(folder, "record.json"), "utf8")) as {
        name: string;
        flop_index: number;
        colour_travel: number;
        graininess: number;
        sparkle: { lamp_deg: number; sparkle: number }[];
        warnings: string[];
        readings: { geometries: string[]; Lab: number[][]; R: number[][] };
    };
    await open(`/record/${id}`);
    assert.equal(await page.textContent("h1"), record.name);
    const rows = await page.$$eval("table.figures tbody tr", (found) =>
        found.map((row) => [...row.children].map((cell) => cell.textContent)),
    );
    const { geometries, Lab } = record.readings;
    assert.equal(rows.length, geometries.length);
    for (const [name, ...values] of rows) {
        const lab = Lab[geometries.indexOf((name ?? "").replace("\u2212", "-"))];
        assert.ok(lab !== undefined, `${String(name)} was not read`);
        lab.forEach((exact, c) => {
            rounds(plain(values[c] ?? null), exact, 2);
        });
        rounds(plain(values[3] ?? null), Math.hypot(lab[1] ?? NaN, lab[2] ?? NaN), 2);
    }
    const figures = new Map(
        await page.$$eval(".key-figures > div", (found) =>
            found.map((div): [string, string] => [
                div.querySelector("dt")?.textContent ?? "",
                div.querySelector("dd")?.textContent ?? "",
            ]),
        ),
    );
    rounds(plain(figures.get("Flop index") ?? null), record.flop_index, 2);
    rounds(plain(figures.get("Colour travel") ?? null), record.colour_travel, 1);
    rounds(plain(figures.get("Graininess") ?? null), record.graininess, 1);
    for (const { lamp_deg, sparkle } of record.sparkle) {
        const shown = figures.get(`Sparkle, lamp at ${String(lamp_deg)}°`) ?? "";
        rounds(plain(shown.split(" ")[0] ?? null), sparkle, 1);
    }
    assert.ok(record.warnings.length > 0);
    assert.ok((await page.textContent(".warnings"))?.includes(record.warnings[0] as string));

    const shown = await page.$$eval(".chip", (found) =>
        found.map((chip) => getComputedStyle(chip.querySelector("i") as Element).backgroundColor),
    );
    const rgb = chips.map(
        (hex) =>
            `rgb(${[1, 3, 5].map((i) => String(parseInt(hex.slice(i, i + 2), 16))).join(", ")})`,
    );
    assert.deepEqual([...shown].sort(), rgb.sort());

    const text = await readFile(join(folder, "recipe.toml"), "utf8");
    assert.equal(await page.textContent("pre"), text);
    const composition = (await page.textContent(".composition")) ?? "";
    for (const words of ["TiO2_rutile", "mica", "45 µm", "18 ± 6 µm", "500 ± 60 nm"]) {
        assert.ok(composition.includes(words), `${words} in ${composition}`);
    }
    assert.equal(await page.locator(".plot").count(), 3);
    assert.equal(await page.locator(".plot").first().locator(".curve").count(), geometries.length);

    const links = await page.$$eval(".downloads a", (found) =>
        found.map((link) => (link as HTMLAnchorElement).href),
    );
    const names = links.map((link) => link.split("/").pop());
    assert.deepEqual(names, ["recipe.toml", "readings.csv", "record.json", "ball.png"]);
    for (const link of links) await readFile(new URL(link));
});

test("pictures are those of the records, or said to be ramps", async () => {
    const [rendered, drawn] = expected.ids as [string, string];
    await open(`/record/${rendered}`);
    await page.waitForFunction(
        () => document.querySelector<HTMLImageElement>(".pictures img")?.naturalWidth === 192,
    );
    assert.match((await page.textContent(".pictures")) ?? "", /Ball, rendered/);
    await open(`/record/${drawn}`);
    assert.match((await page.textContent(".pictures")) ?? "", /No picture was rendered/);
    const ramp = await page.$eval(".ramp", (element) => getComputedStyle(element).backgroundImage);
    assert.match(ramp, /^linear-gradient\(to right, rgb/);
});

test("two records are compared as nacre compares them", async () => {
    const { standard, sample, geometries, dLab, dC, dH, dE2000, mean, max } = expected.difference;
    await open("/");
    for (const id of [standard, sample]) {
        await page.fill("[aria-label='Search by name or hash']", id);
        await page.waitForSelector(`.row:not([hidden]) [data-index="0"] a[href$="${id}"]`);
        await count(1);
        await page.focus(".row:not([hidden]) .card:not([hidden]) a");
        await page.keyboard.press("c");
    }
    await page.click(".tray .button");
    await page.waitForSelector(".compare");
    assert.equal(await page.evaluate(() => location.hash), `#/compare/${standard}/${sample}`);
    const rows = await page.$$eval(".differences tbody tr", (found) =>
        found.map((row) => [...row.children].map((cell) => cell.textContent)),
    );
    assert.equal(rows.length, geometries.length);
    for (const [name, ...values] of rows) {
        const i = geometries.indexOf((name ?? "").replace("\u2212", "-"));
        const wanted = [...(dLab[i] ?? []), dC[i], dH[i], dE2000[i]];
        wanted.forEach((exact, k) => {
            rounds(plain(values[6 + k] ?? null), exact ?? NaN, 2);
        });
    }
    const figures = await page.$$eval(".key-figures dd", (found) =>
        found.map((dd) => dd.textContent),
    );
    rounds(plain(figures[0] ?? null), mean, 2);
    rounds(plain(figures[1] ?? null), max, 2);
    assert.equal(await page.locator(".small-plots .curve").count(), 2 * geometries.length);

    await page.click("text=Swap A and B");
    await page.waitForFunction((id) => location.hash.startsWith(`#/compare/${id}`), sample);
    await page.waitForFunction(
        (first) =>
            document.querySelector(".differences tbody td:nth-child(8)")?.textContent !== first,
        rows[0]?.[7] ?? "",
    );
});

test("the back button returns to the same place of the same query", async () => {
    await open("/");
    await page.fill("[aria-label='Flop index from, as a number']", "10");
    await page.keyboard.press("Enter");
    await page.waitForFunction(() => location.hash.includes("flop="));
    await page.$eval(".gallery", (gallery) => (gallery.scrollTop = 5000));
    await page.waitForFunction(() => document.querySelector(".gallery")?.scrollTop === 5000);
    const address = await page.evaluate(() => location.hash);
    const middle = () =>
        page.evaluate(() => document.elementFromPoint(700, 450)?.closest("a")?.hash ?? "nothing");
    const card = await middle();
    await page.mouse.click(700, 450);
    await page.waitForSelector(".record");
    assert.equal(await page.evaluate(() => location.hash), card);
    const first = await page.textContent("h1");
    await page.goBack();
    await page.waitForSelector(".record", { state: "detached" });
    assert.equal(await page.evaluate(() => location.hash), address);
    assert.equal(await page.$eval(".gallery", (gallery) => gallery.scrollTop), 5000);
    assert.equal(await middle(), card);
    assert.equal(await page.$eval(":focus", (link) => (link as HTMLAnchorElement).hash), card);
    await page.goForward();
    await page.waitForSelector(".record");
    assert.equal(await page.textContent("h1"), first);
});

test("names are text, whatever they hold", async () => {
    const { id, name } = expected.nasty;
    await open(`/?q=${id}`);
    await count(1);
    assert.equal(await page.textContent(".row:not([hidden]) .card:not([hidden]) .name"), name);
    await open(`/record/${id}`);
    assert.equal(await page.textContent("h1"), name);
    assert.equal(await page.locator("b[title]").count(), 0);
});

test("what is not there is said", async () => {
    await open("/record/0123456789abcdef");
    assert.match((await page.textContent(".record")) ?? "", /no such record/);
    await page.goto(`${home}#/?q=no-such-name`);
    await page.waitForSelector(".nothing:not([hidden])");
});

test("every grey is neutral, in both themes", async () => {
    for (const theme of ["light", "dark"] as const) {
        await page.emulateMedia({ colorScheme: theme });
        await open(`/record/${expected.first.id}`);
        const coloured = await page.evaluate(() => {
            const paints = ".chip i, .dot, .ramp, .slot i, .swatch, .curve, .curve *, img";
            const found: string[] = [];
            for (const element of document.querySelectorAll("body, body *")) {
                if (element.matches(paints)) continue;
                const style = getComputedStyle(element);
                for (const value of [
                    style.color,
                    style.backgroundColor,
                    style.fill,
                    style.borderTopColor,
                ]) {
                    const [r, g, b, alpha] = (value.match(/[\d.]+/g) ?? []).map(Number);
                    if (alpha !== 0 && (r !== g || g !== b))
                        found.push(`${element.className}: ${value}`);
                }
            }
            return found;
        });
        assert.deepEqual(coloured, []);
    }
    await page.emulateMedia({ colorScheme: "light" });
});

test("everything has a name for those who do not see it", async () => {
    for (const hash of ["/", `/record/${expected.first.id}`]) {
        await open(hash);
        const nameless = await page.evaluate(() => {
            const labelled = (element: Element) =>
                [
                    element.getAttribute("aria-label"),
                    element.textContent,
                    element.getAttribute("title"),
                ].some((text) => (text ?? "").trim() !== "") ||
                ((element as HTMLInputElement).labels?.length ?? 0) > 0;
            return [
                ...document.querySelectorAll(
                    "button, a[href], input, select, img, svg[role='img']",
                ),
            ]
                .filter(
                    (element) =>
                        !element.closest("[hidden]") &&
                        !labelled(element) &&
                        element.getAttribute("alt") === null,
                )
                .map((element) => element.outerHTML);
        });
        assert.deepEqual(nameless, []);
    }
});

test("a tablet's page has no sideways scrolling, and its filters open and close", async () => {
    await page.setViewportSize({ width: 820, height: 1180 });
    await open("/");
    await count(expected.ids.length);
    const wide = () =>
        page.evaluate(
            () => document.documentElement.scrollWidth > document.documentElement.clientWidth,
        );
    assert.equal(await wide(), false);
    assert.equal(await page.isVisible(".filters"), false);
    await page.click(".show-filters");
    await page.waitForSelector(".filters", { state: "visible" });
    await page.keyboard.press("Escape");
    await page.waitForSelector(".filters", { state: "hidden" });
    await open(`/compare/${expected.ids[0] as string}/${expected.ids[1] as string}`);
    assert.equal(await wide(), false);
    await page.setViewportSize({ width: 1280, height: 800 });
});

test("scrolling through ten thousand: frame times are reported", async (t) => {
    await open("/");
    await count(expected.ids.length);
    const times = await page.evaluate(async () => {
        const gallery = document.querySelector(".gallery") as HTMLElement;
        const frames: number[] = [];
        let last = performance.now();
        for (let i = 0; i < 240; ++i) {
            gallery.scrollTop += 160; // 9600 pixels a second at 60 frames
            await new Promise(requestAnimationFrame);
            const now = performance.now();
            frames.push(now - last);
            last = now;
        }
        return frames.sort((a, b) => a - b);
    });
    const at = (share: number) => (times[Math.floor(share * (times.length - 1))] ?? NaN).toFixed(1);
    t.diagnostic(
        `frames of a fast scroll: median ${at(0.5)} ms, 95 % ${at(0.95)} ms, longest ${at(1)} ms`,
    );
    const start = await page.evaluate(() => performance.now());
    await page.fill("[aria-label='L* to be near to']", "50");
    await page.fill("[aria-label='a* to be near to']", "10");
    await page.fill("[aria-label='b* to be near to']", "10");
    await page.waitForFunction(() =>
        document
            .querySelector(".row:not([hidden]) [data-index='0'] .numbers")
            ?.textContent.startsWith("ΔE"),
    );
    const end = await page.evaluate(() => performance.now());
    t.diagnostic(`typing a colour until the nearest are shown: ${(end - start).toFixed(0)} ms`);
    const scrolled = await page.$$eval(".row", (rows) => rows.length);
    assert.ok(scrolled < 30, `${String(scrolled)} rows`);
});

test("a web server serves the same page", async () => {
    const types: Record<string, string> = {
        ".html": "text/html",
        ".js": "text/javascript",
        ".css": "text/css",
        ".png": "image/png",
    };
    const server = createServer((request, response) => {
        const path = normalize(decodeURIComponent((request.url ?? "/").split("?")[0] as string));
        readFile(join(library, path === "/" ? "index.html" : path)).then(
            (data) =>
                response
                    .writeHead(200, { "content-type": types[extname(path)] ?? "text/html" })
                    .end(data),
            () => response.writeHead(404).end(),
        );
    });
    await new Promise<void>((resolve) => server.listen(0, "localhost", resolve));
    try {
        const { port } = server.address() as AddressInfo;
        await page.goto(`http://localhost:${String(port)}/#/record/${expected.first.id}`);
        await page.waitForSelector(".record");
        assert.equal(await page.locator(".plot").count(), 3);
        await page.click(".back");
        await count(expected.ids.length);
    } finally {
        await page.goto("about:blank");
        server.closeAllConnections();
        server.close();
    }
});
