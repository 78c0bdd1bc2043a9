/**
 * The pictures of docs/studio.md, taken from the page itself:
 *
 *     ./dev studio --pictures
 */

import { mkdtemp, rm, writeFile } from "node:fs/promises";
import { tmpdir } from "node:os";
import { join } from "node:path";
import type { Page } from "playwright-core";
import { launch, nacre, Program } from "./program";

const IMAGES = join(process.cwd(), "..", "..", "docs", "images");
const FILM = "[data-key='layer[0].flakes[0].coats[0].thickness_nm'] input[type=text]";

async function settled(page: Page): Promise<void> {
    await page.waitForFunction(
        () => document.querySelector(".chips")?.getAttribute("data-current") === "true",
    );
}

/** The picture has so many samples a pixel. */
async function drawn(page: Page, samples: number): Promise<void> {
    await page.waitForFunction((least) => {
        const bar = document.querySelector<HTMLProgressElement>(".picture-foot progress");
        return bar !== null && bar.value >= least;
    }, samples);
}

const folder = await mkdtemp(join(tmpdir(), "nacre-studio-"));
const standard = join(folder, "panel-17.csv");
await writeFile(standard, await nacre("measure", "red-gold", "--geometry", "byk-mac"));
const program = await Program.start("red-gold");
const browser = await launch(true);
const page = await browser.newPage({
    viewport: { width: 1280, height: 800 },
    colorScheme: "dark",
});
page.setDefaultTimeout(900_000); // what never comes is a failure, however slow the machine
await page.goto(program.url);
await settled(page);
// The time at the bottom is that of a move, not of the start, when shaders are compiled too.
await drawn(page, 64);
await page.fill(FILM, "209");
await page.press(FILM, "Enter");
await settled(page);
await page.fill(FILM, "208");
await page.press(FILM, "Enter");
await settled(page);
await drawn(page, 64);
await page.screenshot({ path: join(IMAGES, "studio.jpg"), quality: 88 });

await page.emulateMedia({ colorScheme: "light" });
await page.selectOption("[aria-label='Shape']", "speed-shape");
await page.fill(FILM, "190");
await page.press(FILM, "Enter");
await page.setInputFiles("[aria-label='File of a standard']", standard);
await page.waitForFunction(() => document.querySelectorAll(".chip .delta").length === 6);
await page.getByRole("tab", { name: "Fit" }).click();
await page.locator(".fit-start button").click();
await page.getByRole("button", { name: "Use match 1" }).waitFor();
await drawn(page, 64);
await page.screenshot({ path: join(IMAGES, "studio-fit.jpg"), quality: 88 });

await browser.close();
await program.end();
await rm(folder, { recursive: true });
