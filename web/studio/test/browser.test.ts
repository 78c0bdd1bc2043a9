/**
 * The page in Debian's Chromium, served by the program itself.
 *
 *     NACRE_PROGRAM=build/nacre node --test browser.mjs
 */

import assert from "node:assert/strict";
import { readFile, writeFile } from "node:fs/promises";
import { join } from "node:path";
import { test } from "node:test";
import {
    begin,
    chips,
    field,
    FILM,
    folder,
    forgive,
    newPage,
    open,
    page,
    parsedCsv,
    row,
    saved,
    settled,
    slider,
    type,
} from "./harness";
import { nacre, Program } from "./program";

begin(false);

test("a slider that is moved shows the colours that nacre measure has", async () => {
    await open();
    const before = await chips();
    await page.locator(slider(FILM)).scrollIntoViewIfNeeded();
    const box = await page.locator(slider(FILM)).boundingBox();
    assert.ok(box);
    await page.mouse.move(box.x + box.width * 0.4, box.y + box.height / 2);
    await page.mouse.down();
    for (let i = 0; i < 12; ++i) {
        await page.mouse.move(box.x + box.width * (0.4 + 0.02 * i), box.y + box.height / 2);
    }
    await page.mouse.up();
    await settled();
    const moved = Number(await page.inputValue(field(FILM)));
    assert.notEqual(moved, 208);

    const recipe = await saved("Save recipe");
    assert.match(recipe.text, new RegExp(`thickness_nm = ${String(moved)}\\b`));
    assert.match(recipe.text, /# 40 to 50 um on cars/, "comments are kept");
    const measured = await nacre("measure", recipe.path, "--geometry", "byk-mac");
    const shown = await chips();
    const rows = parsedCsv(measured);
    assert.equal(rows.length, 6);
    for (const { geometry = "", L, a, b } of rows) {
        const lab = shown.get(geometry);
        assert.ok(lab, geometry);
        assert.notDeepEqual(lab, before.get(geometry));
        [L, a, b].forEach((text, c) => {
            const digits = (text ?? "").split(".")[1]?.length ?? 0;
            assert.ok(
                Math.abs((lab[c] as number) - Number(text)) <= 0.51 * 10 ** -digits,
                geometry,
            );
        });
    }
    assert.equal((await saved("Readings")).text, measured);
});

/** Waits until the fit that was begun has found something, and takes it. */
async function useMatch(): Promise<void> {
    await page.getByRole("button", { name: "Use match 1" }).click();
    await settled();
}

test("by the model that is chosen, chips, files and fits are those of the commands with --model", async () => {
    await open();
    const model = page.locator("[aria-label='Readings by']");
    assert.equal(await model.inputValue(), "microflake");
    const first = await chips();
    const place = await page.locator(".chips").boundingBox();
    await model.selectOption("nacre");
    await settled();
    assert.deepEqual(await page.locator(".chips").boundingBox(), place, "nothing jumps");
    const shown = await chips();
    const readings = await saved("Readings");
    assert.equal(
        readings.text,
        await nacre("measure", "red-gold", "--model", "nacre", "--geometry", "byk-mac"),
    );
    assert.match(readings.name, /\.nacre\.csv$/);
    for (const { geometry = "", L, a, b } of parsedCsv(readings.text)) {
        assert.deepEqual(shown.get(geometry), [L, a, b].map(Number), geometry);
        assert.notDeepEqual(shown.get(geometry), first.get(geometry), geometry);
    }

    // The fit's recipe is that of nacre fit, number by number.
    const standard = join(folder, "by-nacre.csv");
    await writeFile(standard, readings.text);
    await type(FILM, "190");
    await settled();
    // Copied: the recipe that is saved below takes the name of this one.
    const start = join(folder, "start.toml");
    await writeFile(start, (await saved("Save recipe")).text);
    await page.setInputFiles("[aria-label='File of a standard']", standard);
    await page.waitForFunction(() => document.querySelectorAll(".chip .delta.fails").length > 0);
    await page.getByRole("tab", { name: "Fit" }).click();
    for (const label of await page.locator(".free").all()) {
        const film = /^Thickness.*, SiO2190/.test((await label.textContent()) ?? "");
        await label.locator("input").setChecked(film);
    }
    await page.getByLabel("Starts").fill("1");
    await page.getByLabel("Starts").press("Enter");
    await page.getByRole("button", { name: "Fit 1 number" }).click();
    await useMatch();
    const found = await saved("Save recipe");
    const wanted = join(folder, "fitted.toml");
    const free = ["--free", FILM, "--starts", "1", "--model", "nacre"];
    await nacre("fit", standard, "--start", start, ...free, "-o", wanted);
    assert.equal(found.text, await readFile(wanted, "utf8"));

    // What was found goes by the model that found it, which is said where readings go by another.
    assert.equal(await page.locator(".found-by").count(), 0);
    await model.selectOption("microflake");
    await settled();
    assert.match((await page.textContent(".found-by")) ?? "", /^Found and read by nacre/);
    await page.click("[aria-label='Remove the standard']");
    await page.waitForFunction(() => document.querySelectorAll(".chip .delta").length === 0);
});

test("the command line says by which model readings begin", async () => {
    const other = await Program.start("red-gold", "--model", "nacre");
    const tab = await newPage();
    await tab.goto(other.url);
    await tab.waitForSelector(".chips[data-current=true]");
    assert.equal(await tab.inputValue("[aria-label='Readings by']"), "nacre");
    await tab.close();
    await other.end();
});

test("undo and redo take a whole drag back and forth", async () => {
    await open();
    const first = await chips();
    await page.focus(slider(FILM));
    for (let i = 0; i < 5; ++i) await page.keyboard.press("ArrowRight");
    await settled();
    const second = await chips();
    assert.notDeepEqual(second, first);
    await page.click("[aria-label='Undo (Ctrl+Z)']");
    await settled();
    assert.deepEqual(await chips(), first);
    assert.equal(await page.inputValue(field(FILM)), "208");
    assert.ok(await page.isDisabled("[aria-label='Undo (Ctrl+Z)']"));
    await page.click("[aria-label='Redo (Ctrl+Y)']");
    await settled();
    assert.deepEqual(await chips(), second);
});

test("an error is shown at the field that it names, and the colours stay", async () => {
    await open();
    const before = await chips();
    await type("layer[0].thickness_um", "-3");
    const wrong = page.locator(`${row("layer[0].thickness_um")} [role=alert]`);
    await wrong.waitFor();
    assert.match((await wrong.textContent()) ?? "", /must be .*\(0, 1000000\] um/);
    assert.equal(await page.getAttribute(field("layer[0].thickness_um"), "aria-invalid"), "true");
    assert.equal(await page.locator("[aria-invalid=true]").count(), 1);
    assert.deepEqual(await chips(), before);
    await type("layer[0].thickness_um", "16");
    await settled();
    assert.equal(await wrong.count(), 0);

    await page.evaluate((text) => {
        const data = new DataTransfer();
        data.setData("text", text);
        document.dispatchEvent(new ClipboardEvent("paste", { clipboardData: data }));
    }, "ior = 1.5\n[[layer]]\nthickness_mm = 15\n");
    await page.waitForFunction(() =>
        document.querySelector(".said")?.textContent.includes("thickness_mm"),
    );
    assert.equal(
        await page.inputValue("[aria-label='Name of the paint']"),
        "Red-gold interference",
    );
    // All of it is seen, and nothing is said of the paint, whose colours these are.
    const hidden = await page.$eval(".said", (said) => said.scrollHeight - said.clientHeight);
    assert.equal(hidden, 0);
    assert.equal(await page.locator(".composition [role=alert], .chips.old").count(), 0);
    await type("layer[0].thickness_um", "17");
    await settled();
    assert.equal(await page.textContent(".said"), "");
});

test("a standard is compared with, and a fit finds it", async () => {
    const wanted = await nacre("measure", "red-gold", "--geometry", "byk-mac");
    const path = join(folder, "standard.csv");
    await writeFile(path, wanted);
    await open();
    await type(FILM, "190");
    await settled();
    await page.setInputFiles("[aria-label='File of a standard']", path);
    await page.waitForFunction(() => document.querySelectorAll(".chip .delta.fails").length > 0);
    const shown = await saved("Save recipe");
    const compared = await nacre("measure", shown.path, "--versus", path, "--format", "csv");
    const rows = parsedCsv(compared);
    for (const reading of rows) {
        if (!(reading.geometry ?? "").startsWith("45as")) continue;
        const text = await page.textContent(`[data-geometry='${reading.geometry ?? ""}'] .delta`);
        const exact = Number(reading.dE2000 ?? reading.delta_e_2000);
        const seen = Number(/[\d.]+/.exec(text ?? "")?.[0]);
        assert.ok(Math.abs(seen - exact) < 0.006, `${String(seen)} for ${String(exact)}`);
    }

    await page.getByRole("tab", { name: "Fit" }).click();
    for (const label of await page.locator(".free").all()) {
        const film = /^Thickness.*, SiO2190/.test((await label.textContent()) ?? "");
        await label.locator("input").setChecked(film);
    }
    await page.getByRole("button", { name: "Fit 1 number" }).waitFor();
    await page.getByLabel("Starts").fill("1");
    await page.getByLabel("Starts").press("Enter");
    await page.getByRole("button", { name: "Fit 1 number" }).click();
    await page.getByRole("button", { name: "Use match 1" }).click();
    await settled();
    assert.ok(Math.abs(Number(await page.inputValue(field(FILM))) - 208) < 0.1);
    await page.waitForFunction(
        () =>
            document.querySelectorAll(".chip .delta").length === 6 &&
            document.querySelectorAll(".chip .delta.fails").length === 0,
    );
    await page.click("[aria-label='Remove the standard']");
    await page.waitForFunction(() => document.querySelectorAll(".chip .delta").length === 0);
});

test("a locked number has no slider and is not free", async () => {
    await open();
    await page.locator(`${row(FILM)} button`).click();
    assert.ok(await page.isDisabled(slider(FILM)));
    assert.equal(await page.getAttribute(field(FILM), "readonly"), "");
    await page.click("text=Take this paint");
    await page.getByRole("tab", { name: "Fit" }).click();
    const free = page.locator(".free", { hasText: "locked" });
    await free.waitFor();
    assert.ok(await free.locator("input").isDisabled());
    assert.equal(await free.locator("input").isChecked(), false);
});

test("layers, films and pigments are added, moved, copied and removed by name", async () => {
    await open();
    await page.getByRole("button", { name: "Duplicate Layer", exact: true }).click();
    await page.locator(row("layer[1].thickness_um")).waitFor();
    await type("layer[1].thickness_um", "30");
    await settled();
    await page.getByRole("button", { name: "Move Layer 2 up" }).click();
    await settled();
    assert.equal(await page.inputValue(field("layer[0].thickness_um")), "30");
    await page.getByRole("button", { name: "Remove Layer 1" }).click();
    await settled();
    assert.equal(await page.inputValue(field("layer[0].thickness_um")), "16");

    await page.getByRole("button", { name: "Add a pigment" }).click();
    await page.getByRole("option", { name: /chalk/i }).click();
    await settled();
    assert.match((await saved("Save recipe")).text, /from = "chalk"/);

    await page.getByRole("button", { name: "Add flakes" }).click();
    await page.getByRole("option", { name: /^Aluminium, silver dollar/ }).click();
    await settled();
    assert.match((await saved("Save recipe")).text, /name = "aluminium, silver dollar"/i);
    await page.getByRole("button", { name: /^Remove Flakes 2/ }).click();
    await settled();

    const outer = "Material, Layer 1, Fe2O3 on SiO2 on aluminium, Fe2O3";
    await page.getByRole("button", { name: `${outer}: Fe2O3` }).click();
    await page
        .getByRole("option", { name: /^TiO2_anatase\b/ })
        .first()
        .click();
    await settled();
    assert.match((await saved("Save recipe")).text, /TiO2_anatase/);
});

test("the address holds the paint and its locks", async () => {
    await open();
    await type(FILM, "250");
    await page.locator(`${row(FILM)} button`).click();
    await settled();
    await page.waitForFunction(() => location.hash.startsWith("#paint="));
    // Written a moment after the last change.
    const fragment = await page.evaluate(async () => {
        let last = "";
        while (last !== location.hash) {
            last = location.hash;
            await new Promise((resolve) => setTimeout(resolve, 800));
        }
        return last;
    });
    const before = await chips();
    await open(fragment);
    assert.equal(await page.inputValue(field(FILM)), "250");
    assert.ok(await page.isDisabled(slider(FILM)));
    assert.deepEqual(await chips(), before);
});

test("everything can be done from the keyboard", async () => {
    await open();
    const reach = async (label: string) => {
        for (let i = 0; i < 300; ++i) {
            const at = await page.evaluate(
                () =>
                    document.activeElement?.getAttribute("aria-label") ??
                    document.activeElement?.textContent ??
                    "",
            );
            if (at.startsWith(label)) return;
            await page.keyboard.press("Tab");
        }
        assert.fail(`${label} is not reached`);
    };
    const before = await chips();
    await reach("Thickness, Layer 1, Fe2O3 on SiO2 on aluminium, SiO2, slider");
    const outline = await page.evaluate(
        () => getComputedStyle(document.activeElement as Element).outlineStyle,
    );
    assert.equal(outline, "solid", "focus is seen");
    await page.keyboard.press("PageUp");
    await settled();
    assert.notDeepEqual(await chips(), before);
    await page.keyboard.press("Control+z");
    await settled();
    assert.deepEqual(await chips(), before);

    await reach("Material, Layer 1, Fe2O3 on SiO2 on aluminium, SiO2");
    await page.keyboard.press("Enter");
    await page.keyboard.type("mgf");
    await page.keyboard.press("Enter");
    await settled();
    assert.notDeepEqual(await chips(), before);
    assert.match((await saved("Save recipe")).text, /material = "MgF2"/);

    await reach("Flop");
    await page.keyboard.press("ArrowRight");
    assert.equal(await page.locator("[role=tabpanel] table").count(), 1);
});

test("the keyboard goes on where it was used, as parts move and go", async () => {
    await open();
    const at = () => page.evaluate(() => document.activeElement?.getAttribute("aria-label") ?? "");
    const press = async (name: string) => {
        await page.getByRole("button", { name, exact: true }).focus();
        await page.keyboard.press("Enter");
        await settled();
    };
    const focused = (name: string) =>
        page.waitForFunction(
            (label) => document.activeElement?.getAttribute("aria-label") === label,
            name,
        );
    await press("Duplicate Layer");
    await press("Duplicate Layer 2");
    await press("Move Layer 3 up");
    await focused("Move Layer 2 up");
    await page.keyboard.press("Enter");
    await focused("Move Layer 1 down"); // first of all it cannot go further up
    await press("Remove Layer 3");
    await focused("Remove Layer 2");
    await page.keyboard.press("Enter");
    await focused("Remove Layer");
    assert.equal(await at(), "Remove Layer");
});

test("what a number cannot be is forgotten when the number is another", async () => {
    await open();
    await page.fill(field(FILM), "thin");
    await page.press(field(FILM), "Enter");
    const wrong = page.locator(`${row(FILM)} [role=alert]`);
    await wrong.waitFor();
    assert.match((await wrong.textContent()) ?? "", /thin.* is not a number/);
    await page.focus(slider(FILM));
    await page.keyboard.press("ArrowRight");
    await settled();
    assert.equal(await wrong.count(), 0);
    // Nothing has been typed since: Ctrl+Z is the paint's.
    await page.focus(field(FILM));
    await page.keyboard.press("Control+z");
    await settled();
    assert.equal(await page.inputValue(field(FILM)), "208");
});

test("More offers only what makes a valid paint", async () => {
    await open();
    const undo = "[aria-label='Undo (Ctrl+Z)']";
    const offered = await page.$$eval("select.more", (found) =>
        found.flatMap((select) => {
            const { options, dataset } = select as HTMLSelectElement;
            return [...options]
                .slice(1)
                .map(({ value, text }) => ({ value, text, at: dataset.at ?? "" }));
        }),
    );
    assert.ok(offered.length > 20, String(offered.length));
    assert.ok(!offered.some(({ text }) => text.startsWith("Tilts")));
    for (const { value, text, at } of offered) {
        await page.selectOption(`select.more[data-at='${at}']`, value);
        await page.waitForSelector(`${undo}:not(:disabled)`);
        await page.waitForFunction(
            () =>
                document.querySelector(".chips")?.getAttribute("data-current") === "true" ||
                document.querySelector(".said.wrong") !== null,
        );
        const said = page.locator(".said.wrong, .row.wrong");
        assert.equal(await said.count(), 0, `${at}: ${text}`);
        await page.click(undo);
        await page.waitForSelector(`${undo}:disabled`);
        await settled();
    }
});

test("the page says when the program has gone", async () => {
    const other = await Program.start("white");
    const tab = await newPage();
    await tab.goto(other.url);
    await tab.waitForSelector(".chip");
    await other.end();
    await tab.waitForSelector(".status.gone");
    assert.match((await tab.textContent(".status")) ?? "", /does not answer/);
    await tab.close();
    forgive(/WebSocket|ERR_CONNECTION_REFUSED/);
});
