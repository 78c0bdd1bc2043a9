/** Runs in a page of the studio, beside it: draws its own live picture from what the server says. */

import type { LiveState } from "../src/renderer/live_view";
import { LiveView } from "../src/renderer/live_view";
import type { PaintShader, Transform } from "../src/renderer/paint";
import { readLight, readMesh } from "../src/renderer/paint";
import { orbitOf } from "../src/orbit";
import type { Path } from "../src/tree";
import { set } from "../src/tree";
import "./live_probes";
import { api, asked, recipeOf, schema, shaderOf } from "./live_session";

export interface LivePicture {
    /** Linear Rec. 709 in RGBA, row by row from the top; handed over in one piece, as a list is number by number. */
    readonly data: Float64Array;
    readonly width: number;
    readonly height: number;
}

export interface Scene {
    readonly paint: string;
    readonly shape: string;
    readonly light: string;
    /** Pixels of a side. */
    readonly size: number;
}

/** Pictures of a scene, one after the other in the same view. */
class Views {
    private seen: (state: LiveState) => void = () => undefined;
    private failed: (message: Error) => void = () => undefined;
    private readonly canvas = document.createElement("canvas");
    private readonly view: LiveView;

    constructor(samples: number) {
        this.view = new LiveView(this.canvas, {
            samples,
            onFault: (message) => {
                this.failed(new Error(message));
            },
            onChange: (state) => {
                this.seen(state);
            },
        });
    }

    async begin(scene: Scene, sparkle: boolean): Promise<void> {
        const shape = (await schema()).shapes.find(({ name }) => name === scene.shape);
        if (shape === undefined) throw new Error(`there is no ${scene.shape}`);
        const answers = await Promise.all([
            api(`shape/${scene.shape}`),
            api(`light/${scene.light}?width=1024`),
        ]);
        const [mesh, light] = await Promise.all(answers.map((answer) => answer.arrayBuffer()));
        this.view.setSparkle(sparkle);
        this.view.resize(scene.size, scene.size);
        const { transform } = shape as unknown as { transform: Transform };
        this.view.setShape(readMesh(mesh as ArrayBuffer), transform);
        this.view.setLight(readLight(light as ArrayBuffer));
        this.view.setCamera({ ...orbitOf(shape), target_mm: shape.camera.target_mm });
    }

    /** Shows the paint, until it is as wanted. */
    shown(paint: PaintShader | null, wanted: (state: LiveState) => boolean): Promise<void> {
        return new Promise((resolve, reject) => {
            this.failed = reject;
            this.seen = (state) => {
                if (wanted(state)) resolve();
            };
            if (paint !== null) this.view.setPaint(paint);
        });
    }

    /** The whole picture. */
    whole(): LivePicture {
        const { width, height, data } = this.view.pixels();
        const turned = new Float64Array(data.length);
        for (let y = 0; y < height; ++y) {
            const from = 4 * width * (height - 1 - y);
            turned.set(data.subarray(from, from + 4 * width), 4 * width * y);
        }
        return { width, height, data: turned };
    }

    /** What is on the screen. */
    screen(): LivePicture {
        const { width, height } = this.canvas;
        const flat = new OffscreenCanvas(width, height).getContext("2d");
        if (flat === null) throw new Error("there is no 2-D canvas");
        flat.drawImage(this.canvas, 0, 0);
        const linear = (byte: number) =>
            byte <= 10.31475 ? byte / 255 / 12.92 : ((byte / 255 + 0.055) / 1.055) ** 2.4;
        return {
            width,
            height,
            data: Float64Array.from(flat.getImageData(0, 0, width, height).data, linear),
        };
    }

    end(): void {
        this.view.dispose();
    }
}

/** The live picture, with single flakes or their mean. */
async function live(scene: Scene, samples: number, sparkle: boolean): Promise<LivePicture> {
    const views = new Views(samples);
    await views.begin(scene, sparkle);
    const paint = await shaderOf(scene.paint, scene.light);
    await views.shown(paint, (state) => state.samples >= samples);
    const picture = views.whole();
    views.end();
    return picture;
}

/**
 * What is on the screen when a slider has just moved, and the whole picture that it becomes.
 * @param key  of the recipe's number
 */
async function moved(
    scene: Scene,
    samples: number,
    key: Path,
    value: number,
    sparkle: boolean,
): Promise<{ coarseness: number; first: LivePicture; whole: LivePicture }> {
    const views = new Views(samples);
    await views.begin(scene, sparkle);
    await views.shown(
        await shaderOf(scene.paint, scene.light),
        (state) => state.samples >= samples,
    );
    const next = await shaderOf(scene.paint, scene.light, (recipe) => set(recipe, key, value));
    let coarseness = 0;
    await views.shown(next, (state) => {
        // A frame of a fast machine holds samples of the whole picture.
        coarseness = state.samples === 0 ? state.coarseness : 1;
        return state.samples < samples;
    });
    const first = views.screen();
    await views.shown(null, (state) => state.samples >= samples);
    const whole = views.whole();
    views.end();
    return { coarseness, first, whole };
}

/** What is on the screen before flakes are: the coarse picture, if there is one, and what follows it. */
async function beforeFlakes(
    scene: Scene,
): Promise<{ coarse: LivePicture | null; fine: LivePicture }> {
    const views = new Views(1);
    await views.begin(scene, true);
    const paint = await shaderOf(scene.paint, scene.light);
    let coarse: LivePicture | null = null;
    await views.shown(paint, (state) => {
        const drawn = state.fine || state.samples > 0;
        if (!drawn) coarse = views.screen();
        return drawn;
    });
    const fine = views.screen();
    views.end();
    return { coarse, fine };
}

/** The path tracer's, in RGB. */
async function traced(scene: Scene, samples: number, specimen: number): Promise<LivePicture> {
    const { paint, size, shape, light } = scene;
    const fields = {
        type: "render",
        recipe: await recipeOf(paint),
        scene: { shape, light, camera: null, turn_deg: 0, light_turn_deg: 0, specimen },
        width: size,
        height: size,
        samples,
        linear: true,
    };
    const [, arrays] = await asked(fields, "picture");
    const linear = arrays.find(({ name }) => name === "linear");
    if (linear === undefined) throw new Error("a picture came without its linear values");
    return { width: size, height: size, data: Float64Array.from(linear.data as Float32Array) };
}

declare global {
    interface Window {
        live: typeof live;
        moved: typeof moved;
        beforeFlakes: typeof beforeFlakes;
        traced: typeof traced;
    }
}
window.live = live;
window.moved = moved;
window.beforeFlakes = beforeFlakes;
window.traced = traced;
