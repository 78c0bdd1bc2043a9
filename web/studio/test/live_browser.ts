/** A browser in which test/live_page.ts draws live pictures of a studio. */

import { readFile } from "node:fs/promises";
import { dirname, join } from "node:path";
import { fileURLToPath } from "node:url";
import type { Browser, Page } from "playwright-core";
import type {} from "./live_page";
import { launch, Program } from "./program";

export class LiveBrowser {
    private constructor(
        private readonly studio: Program,
        private readonly browser: Browser,
        readonly page: Page,
    ) {}

    static async start(): Promise<LiveBrowser> {
        const studio = await Program.start("red-gold");
        const browser = await launch();
        const context = await browser.newContext({ bypassCSP: true });
        const page = await context.newPage();
        page.setDefaultTimeout(900_000); // what never comes is a failure, however slow the machine
        // Any file of the studio's: the page itself would draw as well.
        await page.goto(studio.url.replace("/?", "/studio.css?"));
        const script = join(dirname(fileURLToPath(import.meta.url)), "live_page.mjs");
        await page.addScriptTag({ type: "module", content: await readFile(script, "utf8") });
        await page.waitForFunction(() => typeof window.live === "function");
        return new LiveBrowser(studio, browser, page);
    }

    async end(): Promise<void> {
        await this.browser.close();
        await this.studio.end();
    }
}
