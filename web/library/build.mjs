/**
 * Builds the page into the Python package, which ships it: index.html, app.js and app.css. With --check
 * nothing is written, and what is there must be equal. With --tests the tests are built instead.
 */

import { mkdir, readFile, writeFile } from "node:fs/promises";
import { dirname, join } from "node:path";
import process from "node:process";
import { fileURLToPath } from "node:url";
import { build } from "esbuild";

const here = dirname(fileURLToPath(import.meta.url));
const root = join(here, "..", "..");
const page = join(root, "python", "nacre", "library", "page");

async function buildTests() {
    await build({
        absWorkingDir: here,
        entryPoints: { unit: "test/unit.test.ts", browser: "test/browser.test.ts" },
        outdir: join(here, "node_modules", ".tests"), // where playwright-core is found
        bundle: true,
        platform: "node",
        format: "esm",
        target: "node18",
        outExtension: { ".js": ".mjs" },
        sourcemap: "inline",
        external: ["playwright-core"],
    });
}

async function buildPage(check) {
    const result = await build({
        absWorkingDir: here,
        entryPoints: { app: "src/main.ts", style: "src/style.css" },
        outdir: page,
        write: false,
        bundle: true,
        minify: true,
        format: "iife",
        target: ["es2021", "chrome100", "firefox100", "safari15.4"],
        charset: "utf8",
        legalComments: "none",
        banner: { js: "/* Made from web/library by its build.mjs. */" },
    });
    const files = new Map([
        ["index.html", await readFile(join(here, "src", "index.html"), "utf8")],
    ]);
    for (const file of result.outputFiles) {
        files.set(file.path.endsWith(".css") ? "app.css" : "app.js", file.text);
    }
    const stale = [];
    for (const [name, text] of files) {
        const path = join(page, name);
        const old = await readFile(path, "utf8").catch(() => null);
        if (old !== text) stale.push(path);
        if (!check) {
            await mkdir(page, { recursive: true });
            await writeFile(path, text);
        }
    }
    if (check && stale.length > 0) {
        throw new Error(
            `not what web/library builds to; run ./dev web --build: ${stale.join(", ")}`,
        );
    }
}

if (process.argv.includes("--tests")) await buildTests();
else await buildPage(process.argv.includes("--check"));
