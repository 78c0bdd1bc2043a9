/**
 * The live picture: a paint on a shape in a light, drawn by WebGL 2 from the paint's own numbers, better
 * from frame to frame. three.js draws; what it draws are the shaders of passes.ts.
 *
 * Single flakes are those of the path tracer. It has no waves of the coat, shadows or light from one part
 * of the shape to another.
 */

import type { Texture, TextureDataType, WebGLRenderer } from "three";
import { FloatType, HalfFloatType } from "three";
import { Display, ENOUGH, INTERLEAVED } from "./display";
import type { Stratum } from "./flakes";
import { flakeValues, restMatrix, sampleOf } from "./flakes";
import type { Drawing, Drawn } from "./frame_loop";
import { FrameLoop } from "./frame_loop";
import { lightValues } from "./lights";
import type { Light, Mesh, PaintFilms, PaintShader, Transform } from "./paint";
import type { Budgets } from "./pace";
import { uniformValues, withFilms } from "./paint";
import { clear, filled, Pass, rendererOn } from "./pass";
import { EVERYWHERE, MOST_RECTANGLES, shading } from "./passes";
import { Shape } from "./shape";
import type { Camera, Eye } from "./space";
import { eyeOf } from "./space";
import { Sums } from "./sums";
import { surroundings } from "./surroundings";

export interface LiveState {
    /** Of every pixel of the whole picture. */
    readonly samples: number;
    /** Whether the mean was drawn in every pixel, as it is before flakes are that take long. */
    readonly fine: boolean;
    /** Whether a paint's program is still being compiled. */
    readonly compiling: boolean;
    /** The last frame's, from when it was begun until the graphics processor had drawn it. */
    readonly frame_ms: number;
    /** Linear size of the picture that follows a slider, over that of the whole one. */
    readonly coarseness: number;
}

export interface LiveOptions {
    readonly onChange?: (state: LiveState) => void;
    /** What tells single flakes of the paint apart is wanted: setFilms(). */
    readonly onFilmsWanted?: () => void;
    /** The graphics processor was lost, or a paint's shader is refused. */
    readonly onFault?: (message: string) => void;
    /** Samples after which the picture is finished. */
    readonly samples?: number;
}

/** What filled() takes beside a texture that was. */
type Numbers = Parameters<typeof filled> extends [unknown, ...infer Rest] ? Rest : never;

const COARSE_SAMPLES = 24;
/** Fine enough for lights; coarse enough for many samples of a pixel, and to tell glitter from its mean. */
const LEAST_COARSE = 3;
const MOST_COARSE = 10;
/** Of a sample with flakes, over one that does not, where processors draw. */
const COST_OF_FLAKES = 6;
const MOST_SAMPLES = 1024;

/** Draws where WebGL 2 can draw into floats; else its constructor throws an Error that says what lacks. */
export class LiveView implements Drawing {
    private readonly renderer: WebGLRenderer;
    private readonly sumType: TextureDataType;
    private readonly mostSamples: number;
    private readonly shape: Shape;
    private readonly shown: Display;
    private readonly paints = new Map<string, Pass>();
    private readonly paintTextures = new Map<string, Texture>();
    private readonly lightTextures: Record<string, Texture> = {};

    private transform: Transform | null = null;
    private light: Light | null = null;
    private camera: Camera | null = null;
    private turn_deg = 0;
    private lightTurn_deg = 0;
    private paint: PaintShader | null = null;
    /** Whose program is not compiled yet. */
    private nextPaint: PaintShader | null = null;
    private warn = false;
    private sparkle = true;

    private whole: Sums | null = null;
    private coarse: Sums | null = null;
    /** The mean in every pixel, shown before flakes are where these take long. */
    private fine: Sums | null = null;
    private coarseness = 3;
    /** Whether films were asked for. */
    private filmsWanted = false;
    private readonly loop: FrameLoop;

    constructor(
        private readonly canvas: HTMLCanvasElement,
        private readonly options: LiveOptions = {},
    ) {
        this.renderer = rendererOn(canvas);
        const context = this.renderer.getContext() as WebGL2RenderingContext;
        this.loop = new FrameLoop(context, this);
        // Half floats count to 2048; their sums lose light before that.
        const precise = context.getExtension("EXT_float_blend") !== null;
        this.sumType = precise ? FloatType : HalfFloatType;
        this.mostSamples = Math.min(options.samples ?? MOST_SAMPLES, precise ? 1e6 : 128);
        this.shape = new Shape(this.renderer);
        this.shown = new Display(this.renderer);
        // Shaders must have all that they name.
        this.paintTextures.set(
            "nacreFilms",
            filled(undefined, "rgba16f", [1, 1], new Uint16Array(4)),
        );
        canvas.addEventListener("webglcontextlost", this.onLost);
    }

    setShape(mesh: Mesh, transform: Transform): void {
        this.shape.setMesh(mesh);
        this.transform = transform;
        this.restart();
    }

    setLight(light: Light): void {
        if (light.rectangles.length > MOST_RECTANGLES) {
            throw new Error(
                `a light of ${String(light.rectangles.length)} rectangles: must be at most ${String(MOST_RECTANGLES)}`,
            );
        }
        const { width, height, picture, byColumn, byRow } = surroundings(light);
        const take = (name: string, ...numbers: Numbers) => {
            this.lightTextures[name] = filled(this.lightTextures[name], ...numbers);
        };
        const filtering = { linear: true, repeat: true };
        take("surroundings", "rgba16f", [width, height], picture, filtering);
        take("byColumn", "r32f", [width, height], byColumn);
        take("byRow", "r32f", [height, 1], byRow);
        this.light = light;
        this.restart();
    }

    /** Its numbers are shown from the next frame on; a program that is new, when it is compiled. */
    setPaint(paint: PaintShader): void {
        if (!this.paints.has(paint.program)) {
            const text = shading(paint.glsl, paint.smoothCoat);
            this.paints.set(
                paint.program,
                new Pass(this.renderer, EVERYWHERE, text, { adds: true }),
            );
        }
        this.nextPaint = paint;
        this.loop.now();
    }

    /** Those of the paint that is drawn, whose mean is shown until they come. */
    setFilms(films: PaintFilms): void {
        if (this.paint === null || this.paint.films) return;
        this.paint = withFilms(this.paint, films);
        this.handOver(this.paint, films);
        this.loop.schedule();
    }

    setCamera(camera: Camera): void {
        const same = JSON.stringify(camera) === JSON.stringify(this.camera);
        this.camera = camera;
        if (!same) this.restart();
    }

    /** About the vertical through what the camera looks at, counterclockwise seen from above. */
    turn(what: "shape" | "light", angle_deg: number): void {
        const before = what === "shape" ? this.turn_deg : this.lightTurn_deg;
        if (angle_deg === before) return;
        if (what === "shape") this.turn_deg = angle_deg;
        else this.lightTurn_deg = angle_deg;
        this.restart();
    }

    /** Whether stripes mark the colours that the display cannot show. */
    setGamutWarning(warn: boolean): void {
        this.warn = warn;
        this.loop.renew();
    }

    /** Whether single flakes are seen, or their mean. */
    setSparkle(sparkle: boolean): void {
        if (sparkle === this.sparkle) return;
        this.sparkle = sparkle;
        this.restart();
    }

    /** Of the picture, in pixels of the screen. */
    resize(width: number, height: number): void {
        if (this.canvas.width === width && this.canvas.height === height && this.whole) return;
        this.renderer.setSize(Math.max(1, width), Math.max(1, height), false);
        this.whole?.delete();
        this.whole = this.make(1);
        for (const sums of [this.coarse, this.fine]) sums?.delete();
        this.coarse = this.fine = null;
        this.restart();
    }

    get state(): LiveState {
        return {
            samples: this.whole?.samples ?? 0,
            fine: this.isFine,
            compiling: this.nextPaint !== null,
            frame_ms: this.loop.frame_ms,
            coarseness: this.coarseness,
        };
    }

    /** The whole picture so far in linear Rec. 709, not clipped: RGB and 1, the bottom row first. */
    pixels(): { width: number; height: number; data: Float32Array } {
        if (!this.whole) throw new Error("the picture has no size yet");
        return this.whole.means();
    }

    /** Draws nothing until resume(), as while another picture covers this one. */
    pause(): void {
        this.loop.pause();
    }

    resume(): void {
        this.loop.resume();
    }

    /** Draws what is new once and does not refine it, as while colours are computed. */
    hold(held: boolean): void {
        this.loop.hold(held);
    }

    dispose(): void {
        this.loop.end();
        this.canvas.removeEventListener("webglcontextlost", this.onLost);
        this.renderer.dispose();
        this.renderer.forceContextLoss();
    }

    /** The canvas takes another view once the processor is back. */
    private readonly onLost = (event: Event): void => {
        event.preventDefault(); // else it would stay away
        this.loop.end();
        this.canvas.removeEventListener("webglcontextlost", this.onLost);
        this.renderer.dispose();
        this.options.onFault?.("the graphics processor was lost");
    };

    private restart(): void {
        this.shown.forget();
        for (const sums of [this.whole, this.coarse, this.fine]) sums?.restart();
        this.loop.renew();
    }

    // ---- what the loop of frames asks for ----

    get awaits(): boolean {
        return this.nextPaint !== null;
    }

    failed(error: unknown): void {
        this.nextPaint = null;
        this.options.onFault?.(error instanceof Error ? error.message : String(error));
    }

    /** Hands over the numbers of a paint whose program is there. */
    takeNew(): boolean {
        const paint = this.nextPaint;
        const pass = paint === null ? undefined : this.paints.get(paint.program);
        if (paint === null || pass?.ready() !== true) return false;
        this.nextPaint = null;
        if (this.whole && this.sparkle && this.paint !== null) {
            this.whole = this.shown.changePaint(this.whole, this.paint, paint, () => this.make(1));
        }
        this.paint = paint;
        this.filmsWanted = false;
        this.handOver(paint, paint);
        if (this.whole) this.whole.samples = this.whole.rows = 0;
        for (const sums of [this.coarse, this.fine]) sums?.restartWhereSeen();
        return true;
    }

    private handOver({ program }: PaintShader, numbers: PaintFilms): void {
        const pass = this.paints.get(program) as Pass;
        pass.set(uniformValues(numbers));
        for (const { name, size, data } of numbers.textures) {
            const filtering = { linear: size.length === 3 };
            const texture = filled(this.paintTextures.get(name), "rgba16f", size, data, filtering);
            this.paintTextures.set(name, texture);
        }
        pass.set(Object.fromEntries(this.paintTextures));
    }

    /** As many samples as there is time for in a frame. */
    draw({ budget, moving, strip }: Budgets, isNew: boolean): Drawn | null {
        const { whole } = this;
        if (!whole || !this.transform || !this.light || !this.camera || !this.paint) return null;
        if (!this.shape.ready() || !this.shown.ready()) return null;
        const pixels = whole.target.width * whole.target.height;
        // One sample shows a part of a pixel's flakes, which glitter more than all of them.
        const { sampled } = sampleOf(0, this.showsFlakesIn(whole));
        const least = sampled ? ENOUGH * COST_OF_FLAKES * pixels : pixels;
        const awaited = sampled && !this.paint.films;
        // The first frame of a paint goes without them.
        if (awaited && !isNew && !this.filmsWanted && this.nextPaint === null) {
            this.filmsWanted = true;
            this.options.onFilmsWanted?.();
        }
        if (least <= budget && !awaited) {
            const wanted = whole.samples === 0 ? Math.max(moving, least) : budget;
            return this.add(whole, Math.min(wanted, 8 * least));
        }
        if (!whole.begun && this.fine?.begun !== true) {
            clear(this.renderer, whole.target);
            const wanted = Math.ceil(Math.sqrt(pixels / moving));
            const coarse = this.coarseOf(Math.min(Math.max(wanted, LEAST_COARSE), MOST_COARSE));
            if (coarse.samples === 0) {
                if (pixels > budget) this.loop.rest();
                // Of every pixel: without its last rows there would be nothing to see.
                const all = coarse.target.width * coarse.target.height;
                return this.add(coarse, Math.max(all, Math.min(moving, COARSE_SAMPLES * all)));
            }
        }
        const { coarse } = this;
        if (
            coarse &&
            coarse.samples > 0 &&
            coarse.samples < Math.min(COARSE_SAMPLES, this.mostSamples) &&
            whole.samples === 0
        ) {
            return this.add(coarse, strip);
        }
        if (sampled && !whole.begun && !this.isFine) {
            this.fine ??= this.make(1);
            return this.add(this.fine, Math.min(strip, this.fine.left));
        }
        return awaited ? null : this.add(whole, strip);
    }

    /** Whether the mean is there in every pixel, of a picture whose flakes take longer. */
    private get isFine(): boolean {
        return this.fine !== null && this.fine.samples > 0;
    }

    /** Which is shown until the whole picture has samples enough. */
    private get mean(): Sums | null {
        const mean = this.isFine ? this.fine : this.coarse;
        return mean !== null && mean.samples > 0 ? mean : null;
    }

    /** Other pictures' pixels are others, or are seen before flakes are: they show the mean. */
    private showsFlakesIn(sums: Sums): boolean {
        return this.sparkle && sums === this.whole && this.paint?.flakes === true;
    }

    private coarseOf(coarseness: number): Sums {
        // Coarser at once, finer only when it is worth it.
        if (
            this.coarse === null ||
            coarseness > this.coarseness ||
            coarseness < 0.7 * this.coarseness
        ) {
            this.coarseness = coarseness;
            this.coarse?.delete();
            this.coarse = this.make(coarseness);
        }
        return this.coarse;
    }

    private make(coarseness: number): Sums {
        const width = Math.max(1, Math.ceil(this.canvas.width / coarseness));
        const height = Math.max(1, Math.ceil(this.canvas.height / coarseness));
        return new Sums(this.renderer, width, height, this.sumType);
    }

    /** @param budget  samples of pixels */
    private add(sums: Sums, budget: number): Drawn | null {
        const { width, height } = sums.target;
        if (sums.samples === 0 && sums.rows === 0) clear(this.renderer, sums.target);
        let work = 0;
        while (work < 0.75 * budget && sums.samples < this.mostSamples) {
            const shown = this.showsFlakesIn(sums);
            const { sampled, stratum } = sampleOf(shown ? sums.samples : sums.place, shown);
            const cost = sampled ? COST_OF_FLAKES * width : width;
            const rows = Math.max(
                1,
                Math.min(height - sums.rows, Math.round((budget - work) / cost)),
            );
            const eye = eyeOf(this.camera as Camera, this.canvas.width / this.canvas.height);
            if (sums.rows === 0) this.drawShape(sums, eye, stratum.place);
            this.shade(sums, eye, stratum, rows, shown, sampled);
            work += rows * cost;
            sums.added(rows);
        }
        return work > 0 ? { work, seen: this.isSeen(sums) } : null;
    }

    /** What ends a sample at once, strips that can be seen now and then. */
    private isSeen(sums: Sums): Drawn["seen"] {
        if (sums === this.coarse || sums.rows === 0) return "now";
        const isOver = this.mean === null || sums.samples + 1 >= ENOUGH;
        return sums === this.whole && isOver ? "soon" : "not";
    }

    private drawShape(sums: Sums, eye: Eye, shift: readonly [number, number]): void {
        const [transform, camera] = [this.transform as Transform, this.camera as Camera];
        const coarse = sums === this.coarse;
        this.shape.draw(sums, transform, this.turn_deg, camera, eye, shift, coarse);
    }

    private shade(
        sums: Sums,
        eye: Eye,
        stratum: Stratum,
        rows: number,
        shown: boolean,
        sampled: boolean,
    ): void {
        const { target, shape, samples, rows: from } = sums;
        const paint = this.paint as PaintShader;
        const camera = this.camera as Camera;
        const toRest = restMatrix(this.transform as Transform, this.turn_deg, camera.target_mm);
        const pass = this.paints.get(paint.program) as Pass;
        pass.set({
            ...this.lightTextures,
            ...lightValues(this.light as Light, this.lightTurn_deg, camera.target_mm),
            placeAt: shape.textures[0] as Texture,
            facingAt: shape.textures[1] as Texture,
            eye: eye.place,
            ahead: eye.ahead,
            across: eye.across,
            upwards: eye.upwards,
            size: [target.width, target.height],
            shift: stratum.place,
            ...flakeValues(toRest, stratum, shown, sampled),
            sampleIndex: samples,
            interleaved: sums === this.whole ? 0 : INTERLEAVED,
        });
        pass.draw(target, [from, rows]);
    }

    show(): void {
        if (this.whole && this.shown.ready()) {
            this.shown.draw(this.whole, this.mean, this.coarse, this.warn);
        }
        this.options.onChange?.(this.state);
    }
}
