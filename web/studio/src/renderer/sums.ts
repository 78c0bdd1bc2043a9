/** A picture that samples add up to. */

import { Target } from "./gl";

export class Sums {
    /** Light, and that of single flakes apart from it. */
    readonly target: Target;
    /** Where the shape is seen by the sample under way, and its normals. */
    readonly shape: Target;
    /** Of every pixel. */
    samples = 0;
    /** That have the sample under way. */
    rows = 0;

    /** @param format  of the sums: floats of one or the other width */
    constructor(gl: WebGL2RenderingContext, width: number, height: number, format: GLenum) {
        this.target = new Target(gl, width, height, [format, format], false);
        this.shape = new Target(gl, width, height, [gl.RGBA32F, gl.RGBA32F], true);
    }

    /** So many rows more have the sample under way. */
    added(rows: number): void {
        this.rows += rows;
        if (this.rows < this.target.height) return;
        this.rows = 0;
        ++this.samples;
    }

    delete(): void {
        this.target.delete();
        this.shape.delete();
    }
}
