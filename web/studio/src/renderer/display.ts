/**
 * From sums of samples to the screen.
 *
 * While a slider moves, the coarse picture has the mean of the flakes. If the paint before had the same
 * flakes, its whole picture tells which of them glitter: the coarse picture is multiplied by that picture
 * over its own mean around each pixel.
 */

import type { Texture, WebGLRenderer, WebGLRenderTarget } from "three";
import { HalfFloatType, Vector2 } from "three";
import type { PaintShader } from "./paint";
import { makeTarget, Pass } from "./pass";
import { AVERAGE, DISPLAY, EVERYWHERE, SMOOTH } from "./passes";
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

/** Of the picture before, so that each part of a pixel has been asked for its flakes. */
const KEPT = 16;

const light = ({ textures }: WebGLRenderTarget): Texture => textures[0] as Texture;
const flakes = ({ textures }: WebGLRenderTarget): Texture => textures[1] as Texture;

const isLike = (means: WebGLRenderTarget | null, { target }: Sums): boolean =>
    means?.width === target.width && means.height === target.height;

/** What makes the flakes of a specimen: their places, slopes and sizes, but not what they reflect. */
function flakesOf(paint: PaintShader): string {
    const numbers = ["nacreField", "nacreFieldLevels", "nacreFieldKey"].map(
        (name) => paint.uniforms.find((uniform) => uniform.name === name)?.values,
    );
    return JSON.stringify(numbers.map((values) => Array.from(values ?? [])));
}

export class Display {
    private readonly screen: Pass;
    private readonly average: Pass;
    private readonly smooth: Pass;
    /** The last whole picture, and of which flakes; its means around the pixels of a coarse one. */
    private before: { sums: Sums; flakes: string; means: WebGLRenderTarget | null } | null = null;
    private glitters = false;
    /** Of the coarse picture, for the screen to filter. */
    private coarseMeans: WebGLRenderTarget | null = null;

    constructor(private readonly renderer: WebGLRenderer) {
        this.screen = new Pass(renderer, EVERYWHERE, DISPLAY);
        this.average = new Pass(renderer, EVERYWHERE, AVERAGE);
        this.smooth = new Pass(renderer, EVERYWHERE, SMOOTH);
    }

    ready(): boolean {
        return this.screen.ready() && this.average.ready() && this.smooth.ready();
    }

    /**
     * To be called when a paint takes the place of another in the same picture.
     * @param whole  of the paint before
     * @param make   a picture like it
     * @returns one to draw the new paint into
     */
    changePaint(whole: Sums, from: PaintShader | null, to: PaintShader, make: () => Sums): Sums {
        let next = whole;
        if (from?.flakes === true && whole.samples >= KEPT) {
            next = this.before?.sums ?? make();
            this.before?.means?.dispose();
            this.before = { sums: whole, flakes: flakesOf(from), means: null };
        }
        this.glitters = to.flakes && this.before?.flakes === flakesOf(to);
        return next;
    }

    /** The shape, its light or its place has changed. */
    forget(): void {
        this.glitters = false;
        this.before?.sums.delete();
        this.before?.means?.dispose();
        this.before = null;
    }

    /** @param warn  marks colours that the display cannot show */
    draw(whole: Sums, coarse: Sums | null, warn: boolean): void {
        const hasCoarse = coarse !== null && coarse.samples > 0;
        const before = this.glitters && hasCoarse ? this.before : null;
        const was = before?.sums ?? whole;
        if (hasCoarse) this.coarseMeans = this.smoothed(coarse, this.coarseMeans);
        if (before !== null && !isLike(before.means, coarse as Sums)) {
            before.means = this.meansOf(before.sums, coarse as Sums, before.means);
        }
        this.screen.set({
            whole: light(whole.target),
            wholeFlakes: flakes(whole.target),
            coarseMeans: light(this.coarseMeans ?? whole.target),
            before: light(was.target),
            beforeFlakes: flakes(was.target),
            beforeMeans: light(before?.means ?? whole.target),
            size: this.renderer.getDrawingBufferSize(new Vector2()).toArray(),
            enough: hasCoarse ? ENOUGH : 0,
            glitters: before === null ? 0 : 1,
            warn: warn ? 1 : 0,
        });
        this.screen.draw(null);
    }

    /** Of a coarse picture. @param into  what was there before */
    private smoothed(sums: Sums, into: WebGLRenderTarget | null): WebGLRenderTarget {
        const { target, shape, samples } = sums;
        const means = this.meansLike(sums, into);
        this.smooth.set({
            sums: light(target),
            sumsOfFlakes: flakes(target),
            placeAt: shape.textures[0] as Texture,
            facingAt: shape.textures[1] as Texture,
            radius: samples <= SMOOTHED_WIDE ? (INTERLEAVED - 1) / 2 : 1,
        });
        this.smooth.draw(means);
        return means;
    }

    /** Around the pixels of a coarser picture. @param into  what was there before */
    private meansOf(
        { target }: Sums,
        like: Sums,
        into: WebGLRenderTarget | null,
    ): WebGLRenderTarget {
        const means = this.meansLike(like, into);
        this.average.set({
            sums: light(target),
            sumsOfFlakes: flakes(target),
            size: [means.width, means.height],
        });
        this.average.draw(means);
        return means;
    }

    /** What means are drawn into, for the screen to filter. */
    private meansLike(like: Sums, into: WebGLRenderTarget | null): WebGLRenderTarget {
        if (into !== null && isLike(into, like)) return into;
        into?.dispose();
        const { width, height } = like.target;
        return makeTarget(this.renderer, width, height, HalfFloatType, { linear: true });
    }
}
