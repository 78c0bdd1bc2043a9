/** A picture that samples add up to. */

import type { TextureDataType, WebGLRenderer, WebGLRenderTarget } from "three";
import { DataUtils, FloatType } from "three";
import { makeTarget } from "./pass";

export class Sums {
    /** Light, and that of single flakes apart from it. */
    readonly target: WebGLRenderTarget;
    /** Where the shape is seen by the sample under way, and its normals. */
    readonly shape: WebGLRenderTarget;
    /** From where in its pixels that was seen last. */
    shapeFrom: readonly [number, number] | null = null;
    /** Of every pixel. */
    samples = 0;
    /** That have the sample under way. */
    rows = 0;
    /** How often rows were added. */
    changes = 0;
    /** Number of the place in its pixels where the first sample looked, and each later one further on. */
    private first = 0;

    /** @param type  of the sums: floats of one or the other width */
    constructor(
        private readonly renderer: WebGLRenderer,
        width: number,
        height: number,
        private readonly type: TextureDataType,
    ) {
        this.target = makeTarget(renderer, width, height, type, { count: 2 });
        this.shape = makeTarget(renderer, width, height, FloatType, { count: 2, depth: true });
    }

    /** Whether there is something in it. */
    get begun(): boolean {
        return this.samples > 0 || this.rows > 0;
    }

    /** Samples of pixels until all have the sample under way. */
    get left(): number {
        return (this.target.height - this.rows) * this.target.width;
    }

    /** Number of the place where the sample under way looks. */
    get place(): number {
        return this.first + this.samples;
    }

    /** Begins anew, of another view. */
    restart(): void {
        this.samples = this.rows = this.first = 0;
        this.shapeFrom = null;
    }

    /** Begins anew where it looked last, as triangles may take longer than a coarse picture. */
    restartWhereSeen(): void {
        if (this.rows === 0 && this.samples > 0) --this.samples;
        this.first = this.place;
        this.samples = this.rows = 0;
    }

    /** So many rows more have the sample under way. */
    added(rows: number): void {
        ++this.changes;
        this.rows += rows;
        if (this.rows < this.target.height) return;
        this.rows = 0;
        ++this.samples;
    }

    /** RGB of light and flakes together, each divided by the number of its samples; and 1. */
    means(): { width: number; height: number; data: Float32Array } {
        const { width, height } = this.target;
        const data = new Float32Array(4 * width * height);
        for (let index = 0; index < this.target.textures.length; ++index) {
            const sums = this.read(index);
            for (let i = 0; i < data.length; i += 4) {
                const scale = 1 / Math.max(sums[i + 3] as number, 1);
                for (let c = i; c < i + 3; ++c) {
                    data[c] = (data[c] as number) + scale * (sums[c] as number);
                }
                data[i + 3] = 1;
            }
        }
        return { width, height, data };
    }

    delete(): void {
        this.target.dispose();
        this.shape.dispose();
    }

    private read(index: number): ArrayLike<number> {
        const { target, type } = this;
        const { width, height } = target;
        const count = 4 * width * height;
        const read = (into: Float32Array | Uint16Array) => {
            this.renderer.readRenderTargetPixels(target, 0, 0, width, height, into, 0, index);
        };
        if (type === FloatType) {
            const sums = new Float32Array(count);
            read(sums);
            return sums;
        }
        const halves = new Uint16Array(count);
        read(halves);
        return Float32Array.from(halves, (bits) => DataUtils.fromHalfFloat(bits));
    }
}
