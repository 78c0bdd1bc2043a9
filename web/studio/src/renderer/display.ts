/**
 * From sums of samples to the screen.
 *
 * While a slider moves, the coarse picture has the mean of the flakes. If the paint before had the same
 * flakes, its whole picture tells which of them glitter: the coarse picture is multiplied by that picture
 * over its own mean around each pixel.
 */

import { Program, Target } from "./gl";
import type { PaintShader } from "./paint";
import { AVERAGE, DISPLAY, EVERYWHERE } from "./passes";
import type { Sums } from "./sums";

/** Of the whole picture, from which on it is better than the coarse one. */
export const ENOUGH = 4;

/** Of the picture before, so that each part of a pixel has been asked for its flakes. */
const KEPT = 16;

/** What makes the flakes of a specimen: their places, slopes and sizes, but not what they reflect. */
function flakesOf(paint: PaintShader): string {
    const numbers = ["nacreField", "nacreFieldLevels", "nacreFieldKey"].map(
        (name) => paint.uniforms.find((uniform) => uniform.name === name)?.values,
    );
    return JSON.stringify(numbers.map((values) => Array.from(values ?? [])));
}

export class Display {
    private readonly program: Program;
    private readonly average: Program;
    /** The last whole picture, and of which flakes; its means around the pixels of a coarse one. */
    private before: { sums: Sums; flakes: string; means: Target | null } | null = null;
    private glitters = false;

    constructor(
        private readonly gl: WebGL2RenderingContext,
        private readonly nothing: WebGLVertexArrayObject,
    ) {
        this.program = Program.begin(gl, EVERYWHERE, DISPLAY);
        this.average = Program.begin(gl, EVERYWHERE, AVERAGE);
    }

    ready(): boolean {
        return this.program.ready() && this.average.ready();
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
            this.before?.means?.delete();
            this.before = { sums: whole, flakes: flakesOf(from), means: null };
        }
        this.glitters = to.flakes && this.before?.flakes === flakesOf(to);
        return next;
    }

    /** The shape, its light or its place has changed. */
    forget(): void {
        this.glitters = false;
        this.before?.sums.delete();
        this.before?.means?.delete();
        this.before = null;
    }

    /** @param warn  marks colours that the display cannot show */
    draw(whole: Sums, coarse: Sums | null, warn: boolean): void {
        const { gl } = this;
        const hasCoarse = coarse !== null && coarse.samples > 0;
        const before = this.glitters && hasCoarse ? this.before : null;
        const pictures = {
            whole: whole.target,
            coarse: (coarse ?? whole).target,
            before: (before?.sums ?? whole).target,
            beforeMeans: before === null ? whole.target : this.meansOf(before, coarse as Sums),
        };
        const program = this.program.use();
        let unit = 0;
        for (const [name, { textures }] of Object.entries(pictures)) {
            const names = name === "whole" || name === "before" ? [name, `${name}Flakes`] : [name];
            names.forEach((sampler, k) => {
                gl.activeTexture(gl.TEXTURE0 + unit);
                gl.bindTexture(gl.TEXTURE_2D, textures[k] as WebGLTexture);
                program.int(sampler, unit++);
            });
        }
        program.floats("size", 2, [gl.drawingBufferWidth, gl.drawingBufferHeight]);
        program.floats("enough", 1, [hasCoarse ? ENOUGH : 0]);
        program.int("glitters", before === null ? 0 : 1);
        program.int("warn", warn ? 1 : 0);
        gl.bindFramebuffer(gl.FRAMEBUFFER, null);
        gl.viewport(0, 0, gl.drawingBufferWidth, gl.drawingBufferHeight);
        gl.bindVertexArray(this.nothing);
        gl.drawArrays(gl.TRIANGLES, 0, 3);
    }

    private meansOf(before: { sums: Sums; means: Target | null }, like: Sums): Target {
        const { gl } = this;
        const { width, height } = like.target;
        if (before.means?.width === width && before.means.height === height) return before.means;
        before.means?.delete();
        before.means = new Target(gl, width, height, [gl.RGBA16F], false);
        const program = this.average.use();
        [...before.sums.target.textures].forEach((texture, unit) => {
            gl.activeTexture(gl.TEXTURE0 + unit);
            gl.bindTexture(gl.TEXTURE_2D, texture);
            program.int(["before", "beforeFlakes"][unit] as string, unit);
        });
        program.floats("size", 2, [width, height]);
        before.means.bind();
        gl.bindVertexArray(this.nothing);
        gl.drawArrays(gl.TRIANGLES, 0, 3);
        return before.means;
    }
}
