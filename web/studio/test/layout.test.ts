/** What the page looks like: nothing is cut, whatever the window, the angles and the system's colours. */

import assert from "node:assert/strict";
import { test } from "node:test";
import { begin, field, FILM, open, page, settled, type } from "./harness";

begin(false);

const USUAL = { width: 1280, height: 800 };

test("names and sliders of numbers are seen whole, on tablets too", async () => {
    await open();
    for (const [width, height] of [
        [1280, 800],
        [1024, 768],
        [820, 1180],
    ] as const) {
        await page.setViewportSize({ width, height });
        const rows = await page.$$eval(".row.number", (found) =>
            found.map((row) => {
                const label = row.querySelector("label") as Element;
                const slider = row.querySelector("input[type=range]") as Element;
                return {
                    cut: label.scrollWidth > label.clientWidth ? label.textContent : "",
                    slider: slider.getBoundingClientRect().width,
                };
            }),
        );
        assert.ok(rows.length > 8);
        for (const { cut, slider } of rows) {
            assert.equal(cut, "", `at ${String(width)} x ${String(height)}`);
            assert.ok(slider >= 90, `${String(slider)} at ${String(width)} x ${String(height)}`);
        }
        const wide = await page.evaluate(() => document.documentElement.scrollWidth);
        assert.equal(wide, width);
        // Who moves the last slider sees the picture and the chips.
        await page.locator(".row.number").last().scrollIntoViewIfNeeded();
        for (const selector of [".picture", ".chips"]) {
            const box = await page.locator(selector).boundingBox();
            assert.ok(box && box.y >= 0 && box.y + box.height <= height, selector);
        }
    }
    await page.setViewportSize({ width: 1280, height: 800 });
    // As light meets them.
    const headings = await page.$$eval("section.flakes .part", (found) =>
        found.map((part) => part.querySelector("h3")?.textContent),
    );
    assert.deepEqual(headings, ["Orientation", "Coat 2", "Coat 1", "Core"]);
});

test("lists to choose from are seen whole, wherever their button is", async () => {
    await open();
    for (const label of ["Add a pigment", "Start from a paint that ships"]) {
        const button = page.getByRole("button", { name: label });
        await button.scrollIntoViewIfNeeded();
        await button.click();
        const list = page.getByRole("listbox", { name: label });
        const box = await list.boundingBox();
        assert.ok(box && box.height >= 200, `${label}: ${String(box?.height)}`);
        assert.ok(box.y >= 0 && box.y + box.height <= 800);
        // What is at its corners is the list itself, and not what it lies over.
        const covered = await list.evaluate((element) => {
            const { left, right, top, bottom } = element.getBoundingClientRect();
            const inset = 3;
            return [left + inset, right - inset].some((x) =>
                [top + inset, bottom - inset].some(
                    (y) => document.elementFromPoint(x, y)?.closest(".choices") !== element,
                ),
            );
        });
        assert.ok(!covered, label);
        await page.keyboard.press("Escape");
        assert.equal(await list.count(), 0);
    }
});

test("a list stays with its button when the form scrolls, until the button is out of sight", async () => {
    await open();
    const button = page.getByRole("button", { name: "Add a pigment" });
    await button.scrollIntoViewIfNeeded();
    await button.click();
    const list = page.getByRole("listbox", { name: "Add a pigment" });
    const scroll = (by: number) =>
        button.evaluate((element, by) => {
            let pane: Element | null = element;
            while (pane !== null && pane.scrollTop === 0) pane = pane.parentElement;
            pane?.scrollBy(0, by);
            return new Promise<boolean>((resolve) =>
                requestAnimationFrame(() =>
                    requestAnimationFrame(() => {
                        resolve(pane !== null);
                    }),
                ),
            );
        }, by);
    const gap = async () => {
        const [its, from] = [await list.boundingBox(), await button.boundingBox()];
        assert.ok(its && from);
        return its.y < from.y ? from.y - its.y - its.height : its.y - from.y - from.height;
    };
    const before = await gap();
    assert.ok(await scroll(-40));
    assert.ok(Math.abs((await gap()) - before) < 0.5, String(await gap()));
    await scroll(-5000);
    await list.waitFor({ state: "detached" });
});

test("the angles of every set are seen whole, in chips and in tables", async () => {
    await open();
    await page.click("text=Take this paint");
    await page.getByRole("tab", { name: "L*a*b*" }).click();
    const angles = page.locator("[aria-label='Angles']");
    const sets = await angles
        .locator("option")
        .evaluateAll((found) => found.map((option) => (option as HTMLOptionElement).value));
    assert.ok(sets.length >= 6);
    for (const set of sets) {
        await angles.selectOption(set);
        await settled();
        const count = await page.locator(".chip").count();
        await page.waitForFunction(
            (rows) => document.querySelector(".figures tbody")?.children.length === rows,
            count,
        );
        for (const width of [USUAL.width, 1024, 820]) {
            await page.setViewportSize({ ...USUAL, width });
            const cut = await page.$$eval(".chip b, .results, .figures", (found) =>
                found.flatMap((part) => {
                    const { right } = part.getBoundingClientRect();
                    const bar = document.querySelector(".standard")?.getBoundingClientRect();
                    const by = part.matches(".figures")
                        ? right - ((bar?.right ?? NaN) - 12) // as far as the bar's own padding
                        : part.scrollWidth - part.clientWidth;
                    if (by <= 0.5) return [];
                    const name = part.matches("b") ? part.textContent : part.localName;
                    return [`${name} by ${String(by)} px`];
                }),
            );
            assert.deepEqual(cut, [], `${set} at ${String(width)}`);
        }
    }
    await page.setViewportSize(USUAL);
    await page.click("[aria-label='Remove the standard']");
});

test("many chips leave room for a plot, and nothing is left empty below the form", async () => {
    await open();
    for (const set of ["byk-mac", "ma-t12", "full"]) {
        await page.locator("[aria-label='Angles']").selectOption(set);
        await settled();
        await page.waitForSelector("#panel-flop svg");
        const room = await page.$eval(
            ".tabs",
            (tabs, height) => height - tabs.getBoundingClientRect().top,
            USUAL.height - 26,
        );
        assert.ok(room >= 250, `${set}: ${String(room)} px`);
    }
    const { height } = (await page.locator(".said-place").boundingBox()) ?? { height: 0 };
    assert.equal(height, 0);
});

test("a number that is longer than its field is shown short until it is typed", async () => {
    await open();
    await type(FILM, "-1000000000");
    const box = page.locator(field(FILM));
    assert.equal(await box.inputValue(), "-1000000000");
    await box.blur();
    assert.equal(await box.inputValue(), "-1e9");
    assert.match((await box.getAttribute("title")) ?? "", /^-1000000000; /);
    // What is of the paint before is dimmed.
    await page.waitForSelector(".said.wrong");
    for (const part of [".chip-row", ".key-figures", "#panel-flop > div", "canvas.now"]) {
        const opacity = await page.$eval(part, (found) => getComputedStyle(found).opacity);
        assert.equal(opacity, "0.55", part);
    }
    await box.focus();
    assert.equal(await box.inputValue(), "-1000000000");
    await page.keyboard.press("Control+z");
    await settled();
});

test("what is said at the bottom is seen whole, however long", async () => {
    await open();
    const csv = `${"geometry,".repeat(60)}\n1,2\n`;
    const file = { name: "wrong.csv", mimeType: "text/csv", buffer: Buffer.from(csv) };
    await page.setInputFiles("[aria-label='File of a standard']", file);
    await page.waitForSelector(".notice:has-text('cannot be used')");
    const cut = await page.$eval(".notice span", (text) => {
        const { bottom } = text.getBoundingClientRect();
        return text.scrollHeight > text.clientHeight || bottom > innerHeight;
    });
    assert.equal(cut, false);
});

test("on a telephone all stands in one column", async () => {
    await open();
    await page.setViewportSize({ width: 412, height: 915 });
    assert.equal(await page.evaluate(() => document.documentElement.scrollWidth), 412);
    const boxes = await page.$$eval(".picture-panel, .composition, .results", (found) =>
        found
            .map((part) => part.getBoundingClientRect())
            .map(({ left, width }) => ({ left, width })),
    );
    assert.deepEqual(
        boxes,
        boxes.map(() => ({ left: 0, width: 412 })),
    );
    await page.setViewportSize(USUAL);
});

test("chips keep their colours where the system chooses the page's", async () => {
    await open();
    const colours = () =>
        page.$$eval(".faces i, .dot", (found) =>
            found.map((face) => getComputedStyle(face).backgroundColor),
        );
    const before = await colours();
    await page.emulateMedia({ forcedColors: "active" });
    assert.ok(await page.evaluate(() => matchMedia("(forced-colors: active)").matches));
    assert.deepEqual(await colours(), before);
    assert.ok(new Set(before).size >= 6);
    await page.emulateMedia({ forcedColors: "none" });
});
