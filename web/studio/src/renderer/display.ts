/**
 * From sums of samples to the screen.
 *
 * While a slider moves, the coarse picture has the mean of the flakes, and so has the first picture of every pixel. If the paint before had the same
 * flakes, its whole picture tells which of them glitter: the mean is multiplied by that picture over its own mean
 * around each of the coarse picture's pixels.
 */

import type { Texture, TextureDataType, WebGLRenderer, WebGLRenderTarget } from "three";
import { FloatType, HalfFloatType, Vector2 } from "three";
import type { PaintShader } from "./paint";
import { filled, makeTarget, Pass } from "./pass";
import type { Shown } from "./passes";
import { AVERAGE, display, EVERYWHERE, GLITTER, SMOOTH } from "./passes";
import type { Sums } from "./sums";

/** Of the whole picture, from which on it is better than the coarse one. */
export const ENOUGH = 4;

/**
 * Pixels of a side over which directions are dealt out [keller-heidrich-2001], and the mean is taken, in a
 * coarse picture.
 */
export const INTERLEAVED = 5;
/** Samples up to which the mean is that wide; then over three pixels. */
const SMOOTHED_WIDE = 5;

/** Of the picture before, so that each stratum of a pixel has been sampled for its flakes. */
const KEPT = 16;

const light = ({ textures }: WebGLRenderTarget): Texture => textures[0] as Texture;
const flakes = ({ textures }: WebGLRenderTarget): Texture => textures[1] as Texture;

const isLike = (one: WebGLRenderTarget | null, other: WebGLRenderTarget): boolean =>
    one?.width === other.width && one.height === other.height;

/** What makes the flakes of a specimen: their places, slopes and sizes, but not what they reflect. */
function flakesOf(paint: PaintShader): string {
    const numbers = ["nacreField", "nacreFieldLevels", "nacreFieldKey"].map(
        (name) => paint.uniforms.find((uniform) => uniform.name === name)?.values,
    );
    return JSON.stringify(numbers.map((values) => Array.from(values ?? [])));
}

/** A whole picture, and of which flakes. */
interface Before {
    readonly sums: Sums;
    readonly flakes: string;
    /** Around the pixels of a coarse picture, and how the flakes glitter over them. */
    means: WebGLRenderTarget | null;
    glitter: WebGLRenderTarget | null;
    /** Whether these are of this picture. */
    known: boolean;
}

export class Display {
    private readonly screens: Readonly<Record<Shown, Pass>>;
    private readonly average: Pass;
    private readonly smooth: Pass;
    private readonly glitter: Pass;
    /** That of a picture whose flakes do not glitter. */
    private readonly even = filled(undefined, "r32f", [1, 1], Float32Array.of(1));
    /** The last whole picture. */
    private before: Before | null = null;
    private glitters = false;
    /** Of the coarse picture: along its rows, and both ways, for the screen to filter. */
    private rowMeans: WebGLRenderTarget | null = null;
    private coarseMeans: WebGLRenderTarget | null = null;
    /** Of which picture these are. */
    private smoothedOf: { readonly sums: Sums; readonly changes: number } | null = null;
    /** Of what is filtered: half floats, which processors first make floats of, only where others are not filtered. */
    private readonly filteredType: TextureDataType;

    constructor(private readonly renderer: WebGLRenderer) {
        const filters = renderer.getContext().getExtension("OES_texture_float_linear") !== null;
        this.filteredType = filters ? FloatType : HalfFloatType;
        const pass = (text: string) => new Pass(renderer, EVERYWHERE, text);
        this.screens = {
            coarse: pass(display("coarse")),
            whole: pass(display("whole")),
            both: pass(display("both")),
        };
        this.average = pass(AVERAGE);
        this.smooth = pass(SMOOTH);
        this.glitter = pass(GLITTER);
    }

    ready(): boolean {
        const passes = [...Object.values(this.screens), this.average, this.smooth, this.glitter];
        return passes.every((pass) => pass.ready());
    }

    /**
     * To be called when a paint takes the place of another in the same picture, which shows single flakes.
     * @param whole  of the paint before
     * @param make   a picture like it
     * @returns one to draw the new paint into
     */
    changePaint(whole: Sums, from: PaintShader, to: PaintShader, make: () => Sums): Sums {
        let next = whole;
        if (from.flakes && whole.samples >= KEPT) {
            next = this.before?.sums ?? make();
            const { means = null, glitter = null } = this.before ?? {};
            this.before = { sums: whole, flakes: flakesOf(from), means, glitter, known: false };
        }
        this.glitters = to.flakes && this.before?.flakes === flakesOf(to);
        return next;
    }

    /** The shape, its light or its place has changed. */
    forget(): void {
        this.glitters = false;
        this.before?.sums.delete();
        this.before?.means?.dispose();
        this.before?.glitter?.dispose();
        this.before = null;
    }

    /**
     * @param mean    of the flakes, coarse or of every pixel, until the whole picture has samples enough
     * @param coarse  the coarse one
     * @param warn    marks colours that the display cannot show
     */
    draw(whole: Sums, mean: Sums | null, coarse: Sums | null, warn: boolean): void {
        let shown: Shown = "whole";
        if (mean !== null && whole.samples < ENOUGH) shown = whole.begun ? "both" : "coarse";
        let glitter = this.even;
        if (mean !== null && shown !== "whole") {
            this.smoothed(mean);
            if (this.glitters && this.before !== null && coarse !== null)
                glitter = this.glitterOf(this.before, coarse);
        }
        const screen = this.screens[shown];
        screen.set({
            whole: light(whole.target),
            wholeFlakes: flakes(whole.target),
            coarseMeans: light(this.coarseMeans ?? whole.target),
            glitter,
            size: this.renderer.getDrawingBufferSize(new Vector2()).toArray(),
            enough: ENOUGH,
            warn: warn ? 1 : 0,
        });
        screen.draw(null);
    }

    /** Drawn once for as many coarse pictures as follow. */
    private glitterOf(before: Before, coarse: Sums): Texture {
        const { sums } = before;
        if (before.known && before.glitter !== null && isLike(before.means, coarse.target)) {
            return light(before.glitter);
        }
        before.means = this.meansOf(sums, coarse, before.means);
        const { width, height } = sums.target;
        before.glitter ??= makeTarget(this.renderer, width, height, HalfFloatType, { red: true });
        this.glitter.set({
            sums: light(sums.target),
            sumsOfFlakes: flakes(sums.target),
            means: light(before.means),
        });
        this.glitter.draw(before.glitter);
        before.known = true;
        return light(before.glitter);
    }

    /** Of a picture that shows no single flakes: along its rows, then its columns. */
    private smoothed(sums: Sums): void {
        const { target, shape, samples, changes } = sums;
        if (this.smoothedOf?.sums === sums && this.smoothedOf.changes === changes) return;
        this.smoothedOf = { sums, changes };
        this.rowMeans = this.meansLike(target, this.rowMeans);
        this.coarseMeans = this.meansLike(target, this.coarseMeans);
        this.smooth.set({
            placeAt: shape.textures[0] as Texture,
            facingAt: shape.textures[1] as Texture,
            width: samples <= SMOOTHED_WIDE ? INTERLEAVED : 2,
        });
        this.smooth.set({ sums: light(target), along: [1, 0] });
        this.smooth.draw(this.rowMeans);
        this.smooth.set({ sums: light(this.rowMeans), along: [0, 1] });
        this.smooth.draw(this.coarseMeans);
    }

    /** Around the pixels of a coarser picture. @param into  what was there before */
    private meansOf(
        { target }: Sums,
        like: Sums,
        into: WebGLRenderTarget | null,
    ): WebGLRenderTarget {
        const means = this.meansLike(like.target, into);
        this.average.set({
            sums: light(target),
            sumsOfFlakes: flakes(target),
            size: [means.width, means.height],
        });
        this.average.draw(means);
        return means;
    }

    /** What means are drawn into, for the screen to filter. */
    private meansLike(like: WebGLRenderTarget, into: WebGLRenderTarget | null): WebGLRenderTarget {
        if (into !== null && isLike(into, like)) return into;
        into?.dispose();
        const { width, height } = like;
        return makeTarget(this.renderer, width, height, this.filteredType, { linear: true });
    }
}
