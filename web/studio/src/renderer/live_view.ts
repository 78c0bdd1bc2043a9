/**
 * The live picture: a paint on a shape in a light, drawn by WebGL 2 from the paint's own numbers, better
 * from frame to frame.
 *
 * Single flakes are those of the path tracer. It has no waves of the coat, shadows or light from one part
 * of the shape to another.
 */

import { Display } from "./display";
import type { Part } from "./flakes";
import { restMatrix, sampleOf, setFlakes } from "./flakes";
import type { Target } from "./gl";
import { fill, fillMesh, Program, sumOfMeans } from "./gl";
import { setLight } from "./lights";
import type { Light, Mesh, PaintShader, Transform } from "./paint";
import { EVERYWHERE, MOST_RECTANGLES, SHAPE_FRAGMENT, SHAPE_VERTEX, shading } from "./passes";
import type { Camera, Eye } from "./space";
import { eyeOf, screenMatrix, shapeMatrix } from "./space";
import { Sums } from "./sums";
import { surroundings } from "./surroundings";

export interface LiveState {
    /** Of every pixel of the whole picture. */
    readonly samples: number;
    /** Whether a paint's program is still being compiled. */
    readonly compiling: boolean;
    /** The last frame's, from when it was begun until the graphics processor had drawn it. */
    readonly frame_ms: number;
    /** Linear size of the picture that follows a slider, over that of the whole one. */
    readonly coarseness: number;
}

export interface LiveOptions {
    readonly onChange?: (state: LiveState) => void;
    /** The graphics processor was lost, or a paint's shader is refused. */
    readonly onFault?: (message: string) => void;
    /** Samples after which the picture is finished. */
    readonly samples?: number;
}

/** As long as drawing may take in a frame without the page becoming slow. */
const FRAME_MS = 30;
/** Samples of pixels that are worth a frame on any machine. */
const LEAST_WORK = 4096;
const COARSE_SAMPLES = 24;
const MOST_COARSE = 8;
/** Of a sample that asks flakes, over one that does not, where processors draw. */
const ASKING_COST = 6;
const MOST_SAMPLES = 1024;

/** Draws where WebGL 2 can draw into floats; else its constructor throws an Error that says what lacks. */
export class LiveView {
    private readonly gl: WebGL2RenderingContext;
    private readonly sumFormat: GLenum;
    private readonly mostSamples: number;
    private readonly shapeProgram: Program;
    private readonly shown: Display;
    private readonly programs = new Map<string, Program>();
    private readonly arrays: WebGLVertexArrayObject;
    private readonly nothing: WebGLVertexArrayObject;
    private readonly buffers: readonly [WebGLBuffer, WebGLBuffer, WebGLBuffer];
    private readonly lightTextures: readonly [WebGLTexture, WebGLTexture, WebGLTexture];
    private readonly paintTextures = new Map<string, { texture: WebGLTexture; target: GLenum }>();

    private indices = 0;
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
    private coarseness = 3;
    /** Samples of pixels per millisecond of drawing. */
    private speed = 2000;
    /** What a frame takes whatever is drawn: the shortest yet. */
    private overhead_ms = 16;
    private frame_ms = 0;
    private underWay: { sync: WebGLSync; begun: number; work: number } | null = null;
    private request = 0;
    private dirty = false;
    private stopped = false;
    private held = false;
    private lost = false;

    constructor(
        private readonly canvas: HTMLCanvasElement,
        private readonly options: LiveOptions = {},
    ) {
        const gl = canvas.getContext("webgl2", {
            alpha: true, // until the first frame what lies behind is seen
            antialias: false,
            depth: false,
            preserveDrawingBuffer: true,
        });
        if (gl === null) throw new Error("this browser has no WebGL 2");
        if (gl.getExtension("EXT_color_buffer_float") === null) {
            throw new Error("this browser's WebGL 2 does not draw into floats");
        }
        this.gl = gl;
        // Half floats count to 2048; their sums lose light before that.
        const precise = gl.getExtension("EXT_float_blend") !== null;
        this.sumFormat = precise ? gl.RGBA32F : gl.RGBA16F;
        this.mostSamples = Math.min(options.samples ?? MOST_SAMPLES, precise ? 1e6 : 128);
        this.shapeProgram = Program.begin(gl, SHAPE_VERTEX, SHAPE_FRAGMENT);
        this.nothing = gl.createVertexArray();
        this.shown = new Display(gl, this.nothing);
        this.arrays = gl.createVertexArray();
        this.buffers = [gl.createBuffer(), gl.createBuffer(), gl.createBuffer()];
        this.lightTextures = [gl.createTexture(), gl.createTexture(), gl.createTexture()];
        canvas.addEventListener("webglcontextlost", this.onLost);
    }

    setShape(mesh: Mesh, transform: Transform): void {
        fillMesh(this.gl, this.arrays, this.buffers, mesh);
        this.indices = mesh.indices.length;
        this.transform = transform;
        this.restart();
    }

    setLight(light: Light): void {
        if (light.rectangles.length > MOST_RECTANGLES) {
            throw new Error(
                `a light of ${String(light.rectangles.length)} rectangles: must be at most ${String(MOST_RECTANGLES)}`,
            );
        }
        const { gl } = this;
        const { width, height, picture, byColumn, byRow } = surroundings(light);
        const [all, columns, rows] = this.lightTextures;
        gl.activeTexture(gl.TEXTURE0);
        fill(gl, all, "rgba16f", [width, height], picture, { linear: true, repeat: true });
        fill(gl, columns, "r32f", [width, height], byColumn);
        fill(gl, rows, "r32f", [height, 1], byRow);
        this.light = light;
        this.restart();
    }

    /** Its numbers are shown from the next frame on; a program that is new, when it is compiled. */
    setPaint(paint: PaintShader): void {
        if (!this.programs.has(paint.program)) {
            this.programs.set(
                paint.program,
                Program.begin(this.gl, EVERYWHERE, shading(paint.glsl, paint.smoothCoat)),
            );
        }
        this.nextPaint = paint;
        this.schedule();
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
        this.dirty = true;
        this.schedule();
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
        this.canvas.width = Math.max(1, width);
        this.canvas.height = Math.max(1, height);
        this.whole?.delete();
        this.whole = this.make(1);
        this.coarse?.delete();
        this.coarse = null;
        this.restart();
    }

    get state(): LiveState {
        return {
            samples: this.whole?.samples ?? 0,
            compiling: this.nextPaint !== null,
            frame_ms: this.frame_ms,
            coarseness: this.coarseness,
        };
    }

    /** The whole picture so far in linear Rec. 709, not clipped: RGB and 1, the bottom row first. */
    pixels(): { width: number; height: number; data: Float32Array } {
        const { gl, whole } = this;
        if (!whole) throw new Error("the picture has no size yet");
        const { width, height } = whole.target;
        const data = sumOfMeans(gl, whole.target);
        return { width, height, data };
    }

    /** Draws nothing until resume(), as while another picture covers this one. */
    pause(): void {
        this.stopped = true;
        cancelAnimationFrame(this.request);
        this.request = 0;
    }

    resume(): void {
        this.stopped = false;
        this.dirty = true;
        this.schedule();
    }

    /** Draws what is new once and does not refine it, as while colours are computed. */
    hold(held: boolean): void {
        if (held === this.held) return;
        this.held = held;
        if (!held) this.schedule();
    }

    dispose(): void {
        this.pause();
        this.canvas.removeEventListener("webglcontextlost", this.onLost);
        this.gl.getExtension("WEBGL_lose_context")?.loseContext();
    }

    private readonly onLost = (): void => {
        this.lost = true;
        this.options.onFault?.("the graphics processor was lost");
    };

    private restart(): void {
        this.shown.forget();
        if (this.whole) this.whole.samples = this.whole.rows = 0;
        if (this.coarse) this.coarse.samples = this.coarse.rows = 0;
        this.dirty = true;
        this.schedule();
    }

    private schedule(): void {
        if (this.request !== 0 || this.stopped || this.lost) return;
        this.request = requestAnimationFrame(() => {
            this.request = 0;
            try {
                this.frame();
            } catch (error) {
                this.nextPaint = null;
                this.options.onFault?.(error instanceof Error ? error.message : String(error));
            }
        });
    }

    private frame(): void {
        const { gl } = this;
        if (this.underWay !== null) {
            const { sync, begun, work } = this.underWay;
            if (gl.clientWaitSync(sync, 0, 0) === gl.TIMEOUT_EXPIRED) {
                this.schedule();
                return;
            }
            gl.deleteSync(sync);
            this.underWay = null;
            this.frame_ms = performance.now() - begun;
            this.overhead_ms = Math.min(this.overhead_ms, this.frame_ms);
            const drawing_ms = Math.max(this.frame_ms - this.overhead_ms, 1);
            this.speed = 0.5 * this.speed + (0.5 * work) / drawing_ms;
        }
        this.takePaint();
        if (this.held && !this.dirty) {
            if (this.nextPaint !== null) this.schedule();
            return;
        }
        const begun = performance.now();
        const work = this.draw();
        if (work > 0 || this.dirty) {
            this.display();
            this.dirty = false;
            this.options.onChange?.(this.state);
        }
        if (work > 0) {
            const sync = gl.fenceSync(gl.SYNC_GPU_COMMANDS_COMPLETE, 0);
            if (sync !== null) this.underWay = { sync, begun, work };
            gl.flush();
            this.schedule();
        } else if (this.nextPaint !== null) this.schedule();
    }

    /** Hands over the numbers of a paint whose program is there. */
    private takePaint(): void {
        const paint = this.nextPaint;
        if (paint === null || this.programs.get(paint.program)?.ready() !== true) return;
        const { gl } = this;
        this.nextPaint = null;
        if (this.whole) {
            this.whole = this.shown.changePaint(this.whole, this.paint, paint, () => this.make(1));
        }
        this.paint = paint;
        const program = (this.programs.get(paint.program) as Program).use();
        for (const { name, components, array, values } of paint.uniforms) {
            program.floats(array ? `${name}[0]` : name, components, values);
        }
        gl.activeTexture(gl.TEXTURE0);
        for (const { name, size, data } of paint.textures) {
            const target = size.length === 3 ? gl.TEXTURE_3D : gl.TEXTURE_2D;
            const known = this.paintTextures.get(name) ?? { texture: gl.createTexture(), target };
            this.paintTextures.set(name, known);
            fill(gl, known.texture, "rgba16f", size, data, { linear: size.length === 3 });
        }
        if (this.whole) this.whole.samples = this.whole.rows = 0;
        if (this.coarse) this.coarse.samples = this.coarse.rows = 0;
        this.dirty = true;
    }

    /** As many samples as there is time for in a frame. @returns how many of one pixel */
    private draw(): number {
        const { whole } = this;
        if (!whole || !this.transform || !this.light || !this.camera || !this.paint) return 0;
        if (!this.shapeProgram.ready() || !this.shown.ready()) return 0;
        const pixels = whole.target.width * whole.target.height;
        const budget = Math.max(FRAME_MS * this.speed, LEAST_WORK);
        // A picture that a frame can hold is never coarse.
        if (pixels <= budget) return this.add(whole, Math.min(budget, 8 * pixels));
        if (whole.samples === 0 && whole.rows === 0) {
            whole.target.clear();
            const wanted = Math.min(Math.ceil(Math.sqrt(pixels / budget)), MOST_COARSE);
            const coarse = this.coarseOf(wanted);
            if (coarse.samples === 0) return this.add(coarse, pixels / wanted ** 2);
        }
        const { coarse } = this;
        if (
            coarse &&
            coarse.samples > 0 &&
            coarse.samples < Math.min(COARSE_SAMPLES, this.mostSamples) &&
            whole.samples === 0
        ) {
            return this.add(coarse, budget);
        }
        return this.add(whole, budget);
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
        return new Sums(this.gl, width, height, this.sumFormat);
    }

    private add(sums: Sums, budget: number): number {
        const { width, height } = sums.target;
        if (sums.samples === 0 && sums.rows === 0) sums.target.clear();
        let work = 0;
        while (work < 0.75 * budget && sums.samples < this.mostSamples) {
            // A coarse picture's pixels are others: it shows the mean.
            const shown = this.sparkle && sums === this.whole && this.paint?.flakes === true;
            const { asks, part } = sampleOf(sums.samples, shown);
            const cost = asks ? ASKING_COST * width : width;
            const rows = Math.max(
                1,
                Math.min(height - sums.rows, Math.round((budget - work) / cost)),
            );
            const eye = eyeOf(this.camera as Camera, this.canvas.width / this.canvas.height);
            if (sums.rows === 0) this.drawShape(sums.shape, eye, part.place);
            this.shade(sums, eye, part, rows, shown, asks);
            work += rows * cost;
            sums.added(rows);
        }
        return work;
    }

    private drawShape(target: Target, eye: Eye, shift: readonly [number, number]): void {
        const { gl } = this;
        const camera = this.camera as Camera;
        target.clear();
        const program = this.shapeProgram.use();
        const transform = this.transform as Transform;
        program.matrix("toWorld", shapeMatrix(transform, this.turn_deg, camera.target_mm));
        const moved = [(-2 * shift[0]) / target.width, (-2 * shift[1]) / target.height] as const;
        program.matrix("toScreen", screenMatrix(eye, camera.distance_mm, moved));
        gl.disable(gl.BLEND);
        gl.enable(gl.DEPTH_TEST);
        gl.bindVertexArray(this.arrays);
        gl.drawElements(gl.TRIANGLES, this.indices, gl.UNSIGNED_INT, 0);
        gl.bindVertexArray(this.nothing);
        gl.disable(gl.DEPTH_TEST);
    }

    private shade(
        sums: Sums,
        eye: Eye,
        part: Part,
        rows: number,
        shown: boolean,
        asks: boolean,
    ): void {
        const { gl } = this;
        const { target, shape } = sums;
        const paint = this.paint as PaintShader;
        const program = (this.programs.get(paint.program) as Program).use();
        let unit = 0;
        const texture = (name: string, made: WebGLTexture, kind: GLenum = gl.TEXTURE_2D) => {
            gl.activeTexture(gl.TEXTURE0 + unit);
            gl.bindTexture(kind, made);
            program.int(name, unit++);
        };
        for (const [name, { texture: made, target: kind }] of this.paintTextures) {
            texture(name, made, kind);
        }
        const names = ["surroundings", "byColumn", "byRow"];
        names.forEach((name, k) => {
            texture(name, this.lightTextures[k] as WebGLTexture);
        });
        texture("placeAt", shape.textures[0] as WebGLTexture);
        texture("facingAt", shape.textures[1] as WebGLTexture);
        const camera = this.camera as Camera;
        setLight(program, this.light as Light, this.lightTurn_deg, camera.target_mm);
        program.floats("eye", 3, eye.place);
        program.floats("ahead", 3, eye.ahead);
        program.floats("across", 3, eye.across);
        program.floats("upwards", 3, eye.upwards);
        program.floats("size", 2, [target.width, target.height]);
        program.floats("shift", 2, part.place);
        const toRest = restMatrix(this.transform as Transform, this.turn_deg, camera.target_mm);
        setFlakes(program, toRest, part, shown, asks);
        gl.uniform1ui(program.at("sampleIndex"), sums.samples);
        target.bind();
        gl.enable(gl.SCISSOR_TEST);
        gl.scissor(0, sums.rows, target.width, rows);
        gl.enable(gl.BLEND);
        gl.blendFunc(gl.ONE, gl.ONE);
        gl.bindVertexArray(this.nothing);
        gl.drawArrays(gl.TRIANGLES, 0, 3);
        gl.disable(gl.BLEND);
        gl.disable(gl.SCISSOR_TEST);
    }

    private display(): void {
        if (this.whole && this.shown.ready()) this.shown.draw(this.whole, this.coarse, this.warn);
    }
}
