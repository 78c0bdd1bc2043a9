/**
 * Ten tabs, a slider held down in each for a minute: what the server's memory does, and whether it still
 * answers. Run by hand:
 *
 *     NACRE_PROGRAM=build/nacre node web/studio/soak.mjs
 */

import { spawn } from "node:child_process";
import { readFile } from "node:fs/promises";
import process from "node:process";
import { createInterface } from "node:readline";
import { setTimeout as pause } from "node:timers/promises";
import { chromium } from "playwright-core";

const TABS = 10;
const SECONDS = 60;
const SLIDER = "[data-key='layer[0].flakes[0].coats[0].thickness_nm'] input[type=range]";

const program = spawn(process.env.NACRE_PROGRAM, ["studio", "red-gold", "--no-open", "--quiet"], {
    stdio: ["ignore", "pipe", "inherit"],
});
const lines = createInterface({ input: program.stdout });
const url = await new Promise((resolve) => lines.once("line", resolve));

async function megabytes() {
    const status = await readFile(`/proc/${program.pid}/status`, "utf8");
    return Number(/VmRSS:\s+(\d+)/.exec(status)[1]) / 1024;
}

const schema = new URL("/api/schema", url);
schema.search = new URL(url).search;

async function report(when) {
    const begun = performance.now();
    await (await fetch(schema)).arrayBuffer();
    const answered = performance.now() - begun;
    const memory = await megabytes();
    console.log(`${when}: ${memory.toFixed(0)} MB, a request in ${answered.toFixed(0)} ms`);
}

const browser = await chromium.launch({
    executablePath: "/usr/bin/chromium",
    args: ["--no-sandbox", "--disable-3d-apis", "--disable-renderer-backgrounding"],
});
try {
    const tabs = [];
    for (let i = 0; i < TABS; ++i) {
        const tab = await browser.newPage({ viewport: { width: 1280, height: 800 } });
        await tab.goto(url);
        await tab.waitForSelector(".chips[data-current=true]");
        tabs.push(tab);
    }
    await report("start");
    for (const tab of tabs) {
        await tab.evaluate((selector) => {
            window.answers = 0;
            new MutationObserver(() => ++window.answers).observe(
                document.querySelector(".latency"),
                {
                    childList: true,
                    characterData: true,
                    subtree: true,
                },
            );
            const slider = document.querySelector(selector);
            let step = 0;
            window.held = setInterval(() => {
                slider.value = String(200 + 100 * Math.sin(++step / 20));
                slider.dispatchEvent(new Event("input", { bubbles: true }));
            }, 50);
        }, SLIDER);
    }
    let last = 0;
    for (const second of [15, 30, 45, SECONDS]) {
        await pause(1000 * (second - last));
        last = second;
        await report(`${second} s`);
    }
    const seen = [];
    for (const tab of tabs) {
        seen.push(await tab.evaluate(() => (clearInterval(window.held), window.answers)));
    }
    const begun = performance.now();
    for (const tab of tabs) await tab.waitForSelector(".chips[data-current=true]");
    const settled = performance.now() - begun;
    console.log(`colours seen in ${SECONDS} s, a tab: ${seen.join(", ")}`);
    console.log(`let go: all tabs have theirs after ${settled.toFixed(0)} ms`);
} finally {
    await browser.close();
    await report("tabs closed");
    program.kill("SIGINT");
}
