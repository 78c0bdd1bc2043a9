/** The page with the live picture, drawn by the processor where there is no graphics card. */

import assert from "node:assert/strict";
import { test } from "node:test";
import { begin, field, FILM, newPage, open, page, settled, slider, studio, type } from "./harness";

begin(true);

/** Where pictures are waited for until they are traced: a window in which they have few pixels. */
const SMALL = { width: 950, height: 400 };
const USUAL = { width: 1280, height: 800 };

test("chips come first, then plots and how long the chips took", async () => {
    await open();
    await page.waitForSelector(".latency:not(:empty)");
    const flop = () => page.innerHTML("#panel-flop");
    const before = await flop();
    await page.focus(slider(FILM));
    for (let i = 0; i < 30; ++i) {
        await page.keyboard.press("ArrowRight");
        await settled();
    }
    await page.waitForFunction(
        (plots) => document.querySelector("#panel-flop")?.innerHTML !== plots,
        before,
    );
    assert.match((await page.textContent(".latency")) ?? "", /^\d+ ms$/);
});

test("the picture that is saved is the path tracer's, which is waited for", async () => {
    await page.setViewportSize(SMALL);
    await open();
    const [file] = await Promise.all([
        page.waitForEvent("download"),
        (async () => {
            await page.getByRole("button", { name: "Picture", exact: true }).click();
            assert.match((await page.textContent(".notice")) ?? "", /^Waiting for the path/);
        })(),
    ]);
    assert.match(file.suggestedFilename(), /\.png$/);
    await page.waitForSelector(".notice:has-text('saved, path traced')");
    await page.setViewportSize(USUAL);
});

test("before there is a picture its place has the grey behind it", async () => {
    const tab = await newPage();
    await tab.routeWebSocket(/\/api\/session/, (socket) => {
        const server = socket.connectToServer();
        let bytesFollow = false;
        server.onMessage((message) => {
            const kept =
                typeof message === "string"
                    ? /"type":"(shader|films|picture)"/.test(message)
                    : bytesFollow;
            bytesFollow = kept;
            if (!kept) socket.send(message);
        });
    });
    await tab.goto(studio.url);
    await tab.waitForSelector(".chips[data-current=true]");
    const opaque = await tab.$$eval(".picture canvas", (found) =>
        found.map((element) => {
            const copy = document.createElement("canvas");
            copy.width = copy.height = 8;
            const context = copy.getContext("2d");
            context?.drawImage(element as HTMLCanvasElement, 0, 0, 8, 8);
            return context?.getImageData(0, 0, 8, 8).data.some((x, i) => i % 4 === 3 && x > 0);
        }),
    );
    assert.deepEqual(opaque, [false, false]);
    await tab.close();
});

test("films of single flakes are asked for once a paint, when its mean has been drawn", async () => {
    const tab = await newPage();
    const told: string[] = [];
    tab.on("websocket", (socket) => {
        const note = (way: string) => (frame: { payload: string | Buffer }) => {
            if (typeof frame.payload !== "string") return;
            const type = /"type":"(shader|films)"/.exec(frame.payload)?.[1];
            if (type !== undefined) told.push(way + type);
        };
        socket.on("framesent", note(">"));
        socket.on("framereceived", note("<"));
    });
    const films = async (count: number) => {
        while (told.filter((message) => message === "<films").length < count) {
            await tab.waitForTimeout(50);
        }
    };
    await tab.goto(studio.url);
    await films(1);
    await tab.focus(slider(FILM));
    await tab.keyboard.press("ArrowRight");
    await films(2);
    const each = ["<shader", ">films", "<films"];
    assert.deepEqual(told, [...each, ...each]);
    await tab.close();
});

/** The mean of what is red, green and blue on the screen, a byte each. */
const mean = (canvas: string) =>
    page.$eval(canvas, (element) => {
        const copy = document.createElement("canvas");
        const { width, height } = element as HTMLCanvasElement;
        copy.width = width;
        copy.height = height;
        const context = copy.getContext("2d");
        context?.drawImage(element as HTMLCanvasElement, 0, 0);
        const pixels = context?.getImageData(0, 0, width, height).data ?? new Uint8ClampedArray();
        const sums = [0, 0, 0];
        pixels.forEach((x, i) => {
            if (i % 4 < 3) sums[i % 4] = (sums[i % 4] ?? 0) + x;
        });
        return sums.map((sum) => (4 * sum) / pixels.length);
    });
const near = (a: readonly number[], b: readonly number[], most: number) =>
    a.every((x, i) => Math.abs(x - (b[i] ?? NaN)) <= most);

test("the picture gets better, follows turning, and A is held beside B", async () => {
    await page.setViewportSize(SMALL);
    await open();
    const traced = (least: number) =>
        page.waitForFunction((n) => {
            const bar = document.querySelector<HTMLProgressElement>(".picture-foot progress");
            return bar !== null && bar.value >= n;
        }, least);
    await page.waitForSelector("canvas.traced.now"); // covers the live picture
    const first = await mean("canvas.traced");
    assert.ok(
        first.every((x) => x > 1 && x < 254),
        String(first),
    );
    // The live one is drawn on until it has a sample.
    const alike = async () => near(await mean("canvas.live"), first, 8);
    for (let i = 0; i < 1200 && !(await alike()); ++i) await page.waitForTimeout(500);
    assert.ok(await alike(), "live and path traced are of one paint");
    await page.focus(".turnable");
    for (let i = 0; i < 6; ++i) await page.keyboard.press("Shift+ArrowRight");
    await page.waitForSelector("canvas.live.now");
    await traced(1);
    assert.ok(!near(await mean("canvas.traced"), first, 0.2), "the light was turned");
    await page.click("text=Keep as A");
    await type(FILM, "300");
    await settled();
    await page.locator(".wipe").fill("0.25");
    assert.equal(await page.locator(".wiped canvas").count(), 1);
    // The line is dragged, and A is drawn anew when its light is turned.
    const line = await page.locator(".wipe-line").boundingBox();
    const place = await page.locator(".picture").boundingBox();
    assert.ok(line && place);
    await page.mouse.move(line.x + line.width / 2, line.y + 40);
    await page.mouse.down();
    await page.mouse.move(place.x + 0.6 * place.width, line.y + 40, { steps: 4 });
    await page.mouse.up();
    const wiped = Number(await page.locator(".wipe").inputValue());
    assert.ok(Math.abs(wiped - 0.6) < 0.02, String(wiped));
    const kept = await mean(".wiped canvas");
    await page.focus(".turnable");
    for (let i = 0; i < 6; ++i) await page.keyboard.press("Shift+ArrowLeft");
    const drawn = async () => !near(await mean(".wiped canvas"), kept, 0.2);
    for (let i = 0; i < 1200 && !(await drawn()); ++i) await page.waitForTimeout(500);
    assert.ok(await drawn(), "A under the light that was turned");
    await page.click("text=Back to A");
    await settled();
    assert.equal(await page.inputValue(field(FILM)), "208");
});

test("the live picture comes back with the graphics processor", async () => {
    await open();
    const says = (part: string, does: boolean) =>
        page.waitForFunction(
            ([text, wanted]) =>
                document.querySelector(".how-far")?.textContent.includes(text) === wanted,
            [part, does] as const,
        );
    await page.waitForSelector("canvas.traced.now"); // covers the live picture, which has begun
    const extension = await page.evaluateHandle(() => {
        const canvas = document.querySelector<HTMLCanvasElement>("canvas.live");
        return canvas?.getContext("webgl2")?.getExtension("WEBGL_lose_context") ?? null;
    });
    await extension.evaluate((it) => it?.loseContext());
    await says("no live picture", true);
    const before = await mean("canvas.traced");
    await type(FILM, "300"); // another paint meanwhile
    const becomes = async (wanted: () => Promise<boolean>, what: string) => {
        for (let i = 0; i < 1200 && !(await wanted()); ++i) await page.waitForTimeout(500);
        assert.ok(await wanted(), what);
    };
    await becomes(async () => !near(await mean("canvas.traced"), before, 8), "another paint");
    await page.waitForFunction(() => {
        const samples = /Path traced, (\d+) of/.exec(
            document.querySelector(".how-far")?.textContent ?? "",
        );
        return Number(samples?.[1] ?? 0) >= 16;
    });
    await says("no live picture", true);
    const traced = await mean("canvas.traced");
    await extension.evaluate((it) => it?.restoreContext());
    await says("no live picture", false);
    await becomes(
        async () => near(await mean("canvas.live"), traced, 8),
        "live and path traced are of one paint",
    );
});

test("single flakes are seen, or their mean", async () => {
    await open();
    await page.selectOption("[aria-label='Shape']", "macro");
    /** Of the square root of the picture's variance to its mean. */
    const contrast = async (canvas: string) => {
        await page.waitForSelector(`${canvas}.now`);
        return page.$eval(canvas, (element) => {
            const copy = document.createElement("canvas");
            const { width, height } = element as HTMLCanvasElement;
            copy.width = width;
            copy.height = height;
            const context = copy.getContext("2d");
            context?.drawImage(element as HTMLCanvasElement, 0, 0);
            const { data } = context?.getImageData(0, 0, width, height) ?? { data: [] };
            const green = [...data].filter((_, i) => i % 4 === 1);
            const mean = green.reduce((sum, x) => sum + x, 0) / green.length;
            const variance = green.reduce((sum, x) => sum + (x - mean) ** 2, 0) / green.length;
            return Math.sqrt(variance) / mean;
        });
    };
    const seen = await contrast("canvas.traced");
    await page.uncheck("text=Sparkle");
    await page.waitForSelector("canvas.live.now");
    const mean = await contrast("canvas.traced");
    console.log(`contrast: flakes ${seen.toFixed(2)}, their mean ${mean.toFixed(2)}`);
    assert.ok(seen > 0.2 && mean < 0.3 * seen);
    await page.check("text=Sparkle");
    await page.waitForSelector("canvas.live.now");
    assert.ok((await contrast("canvas.traced")) > 0.2);
    await page.setViewportSize(USUAL);
});

/** Green as no display shows it: white pigment in a dye that lets 490 to 555 nm through. */
const DEEP_GREEN = `ior = 1.5
[[layer]]
thickness_um = 40
[[layer.pigment]]
scattering_per_mm = 300
anisotropy = 0
[layer.pigment.absorption_per_mm]
wavelengths_nm = [400, 485, 500, 545, 560, 700]
values = [800, 800, 1, 1, 800, 800]
`;

test("colours outside of sRGB are marked by stripes, where one asks for them", async () => {
    await open();
    await page.evaluate((text) => {
        const data = new DataTransfer();
        data.setData("text", text);
        document.dispatchEvent(new ClipboardEvent("paste", { clipboardData: data }));
    }, DEEP_GREEN);
    await page.waitForSelector(".composition :text('Pigment')");
    await settled();
    /** Of the middle of the ball, how much has the grey of the stripes. */
    const striped = () =>
        page.$eval("canvas.live", (element) => {
            const side = 48;
            const copy = document.createElement("canvas");
            copy.width = copy.height = side;
            const { width, height } = element as HTMLCanvasElement;
            const context = copy.getContext("2d");
            context?.drawImage(
                element as HTMLCanvasElement,
                (side - width) / 2,
                (side - height) / 2,
            );
            const { data } = context?.getImageData(0, 0, side, side) ?? { data: [] };
            let count = 0;
            for (let i = 0; i < data.length; i += 4) {
                const pixel = [data[i], data[i + 1], data[i + 2]];
                if (pixel.every((x) => x === 127 || x === 128)) ++count;
            }
            return count / (side * side);
        });
    const becomes = async (least: number, most: number) => {
        let now = await striped();
        for (let i = 0; i < 2400 && !(now >= least && now <= most); ++i) {
            await page.waitForTimeout(250);
            now = await striped();
        }
        assert.ok(now >= least && now <= most, `${String(now)} of the picture`);
    };
    await page.check("text=Mark");
    await becomes(0.2, 0.45); // a third
    await page.uncheck("text=Mark");
    await becomes(0, 0.02);
});
