/**
 * Builds the page that `nacre studio` serves: index.html, studio.js and studio.css in
 * src/apps/studio/page. With --check nothing is written, and what is there must be equal. With --tests
 * the tests are built instead.
 */

import { mkdir, readFile, writeFile } from "node:fs/promises";
import { dirname, join } from "node:path";
import process from "node:process";
import { fileURLToPath } from "node:url";
import { build } from "vite";

const here = dirname(fileURLToPath(import.meta.url));
const page = join(here, "..", "..", "src", "apps", "studio", "page");

const jsx = { jsx: "automatic", jsxImportSource: "preact" };

async function buildTests() {
    await build({
        root: here,
        configFile: false,
        logLevel: "warn",
        esbuild: jsx,
        build: {
            ssr: true,
            outDir: join(here, "node_modules", ".tests"), // where playwright-core is found
            target: "node18",
            sourcemap: "inline",
            rollupOptions: {
                input: {
                    unit: "test/unit.test.ts",
                    browser: "test/browser.test.ts",
                    picture: "test/picture.test.ts",
                    live: "test/live.test.ts",
                    live_page: "test/live_page.ts", // read by live, for the browser
                    pictures: "test/pictures.ts",
                },
                output: { entryFileNames: "[name].mjs", chunkFileNames: "[name].mjs" },
            },
        },
    });
}

async function buildPage(check) {
    const { output } = await build({
        root: here,
        configFile: false,
        logLevel: "warn",
        base: "./",
        esbuild: {
            ...jsx,
            legalComments: "none",
            banner: "/* Made from web/studio by its build.mjs. */",
        },
        build: {
            write: false,
            target: ["es2021", "chrome100", "firefox100", "safari15.4"],
            modulePreload: false,
            assetsInlineLimit: 0,
            chunkSizeWarningLimit: 1200,
            rollupOptions: {
                output: { entryFileNames: "studio.js", assetFileNames: "studio[extname]" },
            },
        },
    });
    const files = new Map(
        output.map((file) => [file.fileName, file.type === "chunk" ? file.code : file.source]),
    );
    const expected = ["index.html", "studio.css", "studio.js"];
    if ([...files.keys()].sort().join() !== expected.join()) {
        throw new Error(`built ${[...files.keys()].join(", ")} in place of ${expected.join(", ")}`);
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
            `not what web/studio builds to; run ./dev studio --build: ${stale.join(", ")}`,
        );
    }
}

if (process.argv.includes("--tests")) await buildTests();
else await buildPage(process.argv.includes("--check"));
