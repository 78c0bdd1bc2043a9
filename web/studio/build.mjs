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

/** What the licences of the libraries in the page want to be kept with them. */
async function notices() {
    const { dependencies } = JSON.parse(await readFile(join(here, "package.json"), "utf8"));
    const texts = Object.entries(dependencies).map(async ([name, version]) => {
        const text = await readFile(join(here, "node_modules", name, "LICENSE"), "utf8");
        if (text.includes("*/")) throw new Error(`the licence of ${name} ends the comment`);
        return `${name} ${version}\n\n${text.trim()}`;
    });
    return ["Made from web/studio by its build.mjs, with:", ...(await Promise.all(texts))];
}

const jsx = { jsx: "automatic", jsxImportSource: "preact" };

const tests = join(here, "node_modules", ".tests"); // where playwright-core is found

/** @param options of build() beside those that all have; tests in Node, but for live_page */
async function buildTest(input, options) {
    await build({
        root: here,
        configFile: false,
        logLevel: "warn",
        esbuild: jsx,
        build: {
            outDir: tests,
            emptyOutDir: false,
            copyPublicDir: false,
            sourcemap: "inline",
            ...options,
            rollupOptions: {
                input,
                output: { entryFileNames: "[name].mjs", chunkFileNames: "[name].mjs" },
            },
        },
    });
}

async function buildTests() {
    const files = [
        "unit.test",
        "studio.test",
        "viewer.test",
        "frame_loop.test",
        "browser.test",
        "layout.test",
        "tools.test",
        "picture.test",
        "live.test",
        "glints.test",
        "pictures",
        "latency",
    ];
    const input = Object.fromEntries(
        files.map((file) => [file.replace(".test", ""), `test/${file}.ts`]),
    );
    await buildTest(input, { ssr: true, target: "node18" });
    // Read by live, for the browser: one file.
    await buildTest({ live_page: "test/live_page.ts" }, { modulePreload: false, minify: false });
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
            banner: `/*\n${(await notices()).join("\n\n")}\n*/`,
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
