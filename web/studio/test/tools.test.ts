/** What stands around the paint: the atlas, the reader's own meshes and lights, the report. */

import assert from "node:assert/strict";
import { writeFile } from "node:fs/promises";
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
    settled,
    studio,
} from "./harness";
import { nacre, Program } from "./program";

begin(false);

const atlasReady = () =>
    page.waitForSelector(".atlas-stage[aria-busy=false] .atlas-field", { state: "visible" });
const reading = async () => (await page.textContent(".atlas-reading")) ?? "";
const notice = (pattern: RegExp) =>
    page.waitForFunction(
        (source) => new RegExp(source).test(document.querySelector(".status")?.textContent ?? ""),
        pattern.source,
    );

test("a thickness that is clicked in the atlas has the colours that it showed there", async () => {
    await open();
    await page.getByRole("tab", { name: "Atlas" }).click();
    await page.selectOption("[aria-label='Number of the atlas']", FILM);
    await page.fill("[aria-label='From']", "160");
    await page.press("[aria-label='From']", "Enter");
    await page.fill("[aria-label='To']", "240");
    await page.press("[aria-label='To']", "Enter");
    await atlasReady();
    const row = page.locator(".atlas-field i").nth(3);
    const box = await row.boundingBox();
    assert.ok(box);
    const place = { x: box.width * 0.25, y: box.height / 2 };
    await row.hover({ position: place });
    const said = await reading();
    assert.match(said, /^180 nm45as45L\* /);
    await row.click({ position: place });
    await settled();
    assert.equal(await page.inputValue(field(FILM)), "180");
    const [L = NaN, a = NaN, b = NaN] = (await chips()).get("45as45") ?? [];
    const numbers = [...said.replaceAll("−", "-").matchAll(/[Lab]\* (-?[\d.]+)/g)].map((m) =>
        Number(m[1]),
    );
    // What the atlas leaves out is the gloss of the surface, at 45 degrees next to nothing.
    [L, a, b].forEach((x, c) => {
        assert.ok(Math.abs(x - (numbers[c] ?? NaN)) < 0.3, `${said} for ${String(x)}`);
    });
    // It stays as it is when its own number moves, and undo takes that back.
    assert.equal(await page.getAttribute(".atlas-stage", "aria-busy"), "false");
    await page.keyboard.press("Control+z");
    await settled();
    assert.equal(await page.inputValue(field(FILM)), "208");
    await page.focus(".atlas-field");
    await page.keyboard.press("Home");
    assert.match(await reading(), /^160 nm/);
    await page.keyboard.press("Enter");
    await settled();
    assert.equal(await page.inputValue(field(FILM)), "160");
});

test("the atlas has the standard in the colours of its chips", async () => {
    await open();
    await page.click("text=Take this paint");
    await page.waitForFunction(() => document.querySelectorAll(".chip .delta").length === 6);
    await page.getByRole("tab", { name: "Atlas" }).click();
    await atlasReady();
    const colours = (selector: string) =>
        page.$$eval(selector, (found) => found.map((i) => getComputedStyle(i).backgroundColor));
    const chips = await colours(".chips .chip .faces i:first-child");
    assert.equal(new Set(chips).size, 6);
    assert.deepEqual(await colours(".atlas-standard i"), chips);
    await page.click("[aria-label='Remove the standard']");
});

test("chips of every set of angles lie within their place", async () => {
    await open();
    const sets = await page.$$eval("[aria-label='Angles'] option", (found) =>
        found.map((option) => (option as HTMLOptionElement).value),
    );
    assert.ok(sets.includes("ma-t12"));
    for (const set of sets) {
        await page.selectOption("[aria-label='Angles']", set);
        await settled();
        const outside = await page.$eval(".chips", (place) => {
            const right = place.getBoundingClientRect().right;
            return [...place.querySelectorAll(".faces, .chip b, .chip > span")]
                .filter((part) => {
                    const range = document.createRange();
                    range.selectNodeContents(part);
                    return (
                        Math.max(
                            part.getBoundingClientRect().right,
                            range.getBoundingClientRect().right,
                        ) > right
                    );
                })
                .map((part) => part.textContent);
        });
        assert.deepEqual(outside, [], set);
    }
});

const ROOF = "v 0 0 0\nv 40 0 0\nv 40 30 20\nv 0 30 20\nf 1 2 3\nf 1 3 4\n";

/** Even light from above, in flat scan lines of Radiance HDR. */
function hdr(width: number, height: number): Buffer {
    const head = `#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y ${String(height)} +X ${String(width)}\n`;
    return Buffer.concat([Buffer.from(head), Buffer.alloc(4 * width * height, 0x80)]);
}

const CORNERS = [
    [0, 0, 0],
    [40, 0, 0],
    [40, 30, 20],
    [0, 30, 20],
] as const;
const TRIANGLES = [
    [0, 1, 2],
    [0, 2, 3],
] as const;

function ply(): string {
    const head = `ply
format ascii 1.0
element vertex 4
property float x
property float y
property float z
element face 2
property list uchar int vertex_indices
end_header`;
    const rows = [...CORNERS, ...TRIANGLES.map((corners) => [3, ...corners])];
    return `${[head, ...rows.map((row) => row.join(" "))].join("\n")}\n`;
}

function stl(): string {
    const facets = TRIANGLES.map((corners) => {
        const vertices = corners.map((corner) => `vertex ${CORNERS[corner].join(" ")}`);
        return ["facet normal 0 0 0", "outer loop", ...vertices, "endloop", "endfacet"].join("\n");
    });
    return `${["solid roof", ...facets, "endsolid roof"].join("\n")}\n`;
}

/** In metres, as glTF is. */
function glb(): Buffer {
    const places = Buffer.from(Float32Array.from(CORNERS.flat(), (mm) => 1e-3 * mm).buffer);
    const corners = Buffer.from(Uint32Array.from(TRIANGLES.flat()).buffer);
    const numbers = Buffer.concat([places, corners]);
    const json = JSON.stringify({
        asset: { version: "2.0" },
        scene: 0,
        scenes: [{ nodes: [0] }],
        nodes: [{ mesh: 0 }],
        meshes: [{ primitives: [{ attributes: { POSITION: 0 }, indices: 1 }] }],
        buffers: [{ byteLength: numbers.length }],
        bufferViews: [
            { buffer: 0, byteOffset: 0, byteLength: places.length },
            { buffer: 0, byteOffset: places.length, byteLength: corners.length },
        ],
        accessors: [
            {
                bufferView: 0,
                componentType: 5126,
                count: CORNERS.length,
                type: "VEC3",
                min: [0, 0, 0],
                max: [0.04, 0.03, 0.02],
            },
            { bufferView: 1, componentType: 5125, count: corners.length / 4, type: "SCALAR" },
        ],
    });
    const chunk = (type: string, data: Buffer) => {
        const head = Buffer.alloc(8);
        head.writeUInt32LE(data.length, 0);
        head.write(type, 4, "latin1");
        return Buffer.concat([head, data]);
    };
    const chunks = [
        chunk("JSON", Buffer.from(json.padEnd(4 * Math.ceil(json.length / 4)))),
        chunk("BIN\0", numbers),
    ];
    const head = Buffer.alloc(12);
    head.write("glTF", 0, "latin1");
    head.writeUInt32LE(2, 4);
    head.writeUInt32LE(12 + chunks.reduce((sum, { length }) => sum + length, 0), 8);
    return Buffer.concat([head, ...chunks]);
}

test("own meshes are also PLY, STL and GLB, own lights OpenEXR", async () => {
    const path = (name: string) => join(folder, name);
    await writeFile(path("roof.ply"), ply());
    await writeFile(path("roof.stl"), stl());
    await writeFile(path("roof.glb"), glb());
    await nacre(
        "render",
        "sphere",
        "--paint",
        "red-gold",
        "--size",
        "64x32",
        "--spp",
        "1",
        "-o",
        path("sky.exr"),
    );
    await open();
    for (const [i, file] of ["roof.ply", "roof.stl", "roof.glb"].entries()) {
        await page.setInputFiles("[aria-label='Own mesh']", path(file));
        await notice(new RegExp(`${file}: 2 triangles, 40 mm, shown as 200 mm`));
        assert.equal(await page.inputValue("[aria-label='Shape']"), `own-shape-${String(i + 1)}`);
    }
    await page.setInputFiles("[aria-label='Own HDR']", path("sky.exr"));
    await notice(/sky\.exr: 64 x 32 pixels/);
    assert.match(await page.inputValue("[aria-label='Light']"), /^own-light-/);
});

test("a mesh and a light of the reader's own are shown, and what cannot be is said", async () => {
    const path = (name: string) => join(folder, name);
    await writeFile(path("roof.obj"), ROOF);
    await writeFile(path("sky.hdr"), hdr(64, 32));
    await writeFile(path("square.hdr"), hdr(32, 32));
    await writeFile(path("empty.glb"), "glTF");
    await writeFile(path("large.ply"), Buffer.alloc(6_000_001, 0x20));
    await writeFile(path("wrong.toml"), "ior = 1.5\nlayer = 3\n");
    await open();
    await page.setInputFiles("[aria-label^='File of a recipe']", path("wrong.toml"));
    await page.waitForSelector(".said:has-text('Not opened: wrong.toml:2:')");
    await page.setInputFiles("[aria-label='Own mesh']", path("roof.obj"));
    await page.waitForSelector(".said:not(:has-text('Not opened'))", { state: "attached" });
    await notice(/roof\.obj: 2 triangles, 40 mm, shown as 200 mm/);
    assert.match(await page.inputValue("[aria-label='Shape']"), /^own-shape-1$/);
    await page.setInputFiles("[aria-label='Own HDR']", path("sky.hdr"));
    await notice(/sky\.hdr: 64 x 32 pixels/);
    assert.match(await page.inputValue("[aria-label='Light']"), /^own-light-/);
    const traced = () =>
        page.waitForFunction(() => {
            const bar = document.querySelector<HTMLProgressElement>(".picture-foot progress");
            return bar !== null && bar.value >= 4;
        });
    await traced();
    assert.match((await page.textContent(".how-far")) ?? "", /Path traced/);

    // What cannot be shown is said by its name, and what is there stays.
    for (const [file, said] of [
        ["square.hdr", /square\.hdr: has 32 x 32 pixels; must be twice as wide as high/],
        ["empty.glb", /'empty\.glb': is no binary glTF/],
        ["large.ply", /large\.ply has 6\.0 MB; at most 6\.0 MB/],
    ] as const) {
        await page.setInputFiles("[aria-label^='File of a recipe']", path(file));
        await notice(said);
    }
    assert.equal(await page.inputValue("[aria-label='Shape']"), "own-shape-1");
    await page.click("text=Y up");
    await notice(/roof\.obj: 2 triangles/);
    assert.equal(await page.getAttribute("text=Y up", "aria-pressed"), "true");
    await traced();
});

test("the report is printed on two pages of A4", async () => {
    // The small report of tests: other pictures, the same page.
    const tab = await newPage();
    await tab.routeWebSocket(/\/api\/session/, (socket) => {
        const server = socket.connectToServer();
        socket.onMessage((message) => {
            const text = String(message);
            const report = text.startsWith('{"type":"report"');
            server.send(report ? text.replace(/}$/, ',"draft":true}') : text);
        });
    });
    await tab.goto(studio.url);
    await tab.waitForSelector(".chips[data-current=true]");
    await tab.getByRole("button", { name: "Report", exact: true }).click();
    await tab.waitForFunction(() =>
        document.querySelector(".status")?.textContent.startsWith("The report can be printed"),
    );
    const html = await tab.getAttribute("iframe.print", "srcdoc");
    assert.ok(html);
    await tab.close();
    const report = await newPage();
    await report.setContent(html);
    await report.emulateMedia({ media: "print" });
    const text = await report.innerText("body");
    for (const part of [
        "Red-gold interference",
        "L* 105.2",
        "Sparkle, lamp at 15°",
        "Composition",
    ]) {
        assert.ok(text.includes(part), part);
    }
    const pdf = (await report.pdf({ preferCSSPageSize: true })).toString("latin1");
    const pages = [...pdf.matchAll(/\/Type \/Page\b/g)].length;
    const boxes = new Set([...pdf.matchAll(/\/MediaBox \[([^\]]*)\]/g)].map((m) => m[1]));
    console.log(`report: ${String(pages)} pages, ${[...boxes].join("; ")}`);
    assert.equal(pages, 2);
    for (const box of boxes) assert.match(box ?? "", /^0 0 59[45][.\d]* 84[12][.\d]*$/);
    await report.close();
});

/** Two kinds of flakes that differ in their films alone: which of them has which film, no colour tells. */
const TWO_FILMS = (first: number, second: number) => `ior = 1.5
[[layer]]
thickness_um = 15
${[first, second]
    .map(
        (thickness) => `[[layer.flakes]]
volume_fraction = 0.04
diameter_um = 20
orientation = { distribution = "beckmann", alpha = 0.13 }
core = { material = "mica", thickness_nm = 300 }
coats = [{ material = "TiO2_anatase", thickness_nm = ${String(thickness)} }]
`,
    )
    .join("")}[substrate]
reflectance = 0.05
`;

test("a fit with two answers has both to choose from, and the second is used", async () => {
    const keys = [0, 1].map((k) => `layer[0].flakes[${String(k)}].coats[0].thickness_nm`);
    const paste = async (toml: string) => {
        await page.evaluate((text) => {
            const data = new DataTransfer();
            data.setData("text", text);
            document.dispatchEvent(new ClipboardEvent("paste", { clipboardData: data }));
        }, toml);
        await page.locator(field(keys[1] ?? "")).waitFor();
        await settled();
    };
    const films = () => Promise.all(keys.map(async (key) => +(await page.inputValue(field(key)))));
    await open();
    await paste(TWO_FILMS(60, 110));
    const wanted = await chips();
    await page.click("text=Take this paint");
    await page.waitForFunction(() => document.querySelectorAll(".chip .delta").length === 6);
    await paste(TWO_FILMS(80, 90));
    await page.waitForFunction(() => document.querySelectorAll(".chip .delta.fails").length > 0);
    await page.getByRole("tab", { name: "Fit" }).click();
    for (const label of await page.locator(".free").all()) {
        const film = (await label.textContent())?.includes("TiO2_anatase") === true;
        await label.locator("input").setChecked(film);
    }
    await page.getByRole("button", { name: "Fit 2 numbers" }).click();
    await page.getByRole("button", { name: "Use match 2" }).waitFor();
    assert.equal(await page.locator(".matches li").count(), 2);
    const found: number[][] = [];
    for (const match of [1, 2]) {
        await page.getByRole("button", { name: `Use match ${String(match)}` }).click();
        await settled();
        assert.match(
            (await page.getAttribute(`.matches li:nth-child(${String(match)})`, "class")) ?? "",
            /used/,
        );
        found.push(await films());
        for (const [geometry, lab] of await chips()) {
            lab.forEach((x, c) => {
                assert.ok(Math.abs(x - (wanted.get(geometry)?.[c] ?? NaN)) < 0.05, geometry);
            });
        }
    }
    // Either has both films, the one where the other has the other.
    found.sort(([a = 0], [b = 0]) => a - b);
    [60, 110, 110, 60].forEach((film, i) => {
        assert.ok(Math.abs((found.flat()[i] ?? NaN) - film) < 0.5, JSON.stringify(found));
    });
    await page.click("[aria-label='Remove the standard']");
});

test("the page says that another program answers, and goes on with its own", async () => {
    const first = await Program.start("white");
    const { port } = new URL(first.url);
    const tab = await newPage();
    await tab.goto(first.url);
    await tab.waitForSelector(".chips[data-current=true]");
    await first.end();
    await tab.waitForSelector(".status.gone");
    const other = await Program.start("white", "--port", port);
    await tab.waitForFunction(() =>
        document.querySelector(".status")?.textContent.startsWith("Another nacre studio"),
    );
    await tab.close();
    await other.end();
    forgive(/WebSocket|ERR_CONNECTION_REFUSED|401/);
});
