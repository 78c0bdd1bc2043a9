/** Where a shape is seen in a picture, and how it faces; a coarse picture has a coarser shape. */

import type { WebGLRenderer } from "three";
import { coarser } from "./coarse_mesh";
import type { Mesh, Transform } from "./paint";
import { clear, Pass } from "./pass";
import { SHAPE_FRAGMENT, SHAPE_VERTEX } from "./passes";
import type { Camera, Eye } from "./space";
import { screenMatrix, shapeMatrix } from "./space";
import type { Sums } from "./sums";

/** Sides of the cells in which a coarse picture's shape has one vertex, in its pixels, and at least. */
const COARSE_CELL = 2;
const LEAST_COARSE_CELL = 1;

export class Shape {
    private readonly whole: Pass;
    private readonly coarse: Pass;
    private mesh: Mesh | null = null;
    /** Of the cells of the coarse one, in the mesh's units; 0: there are none yet. */
    private cell = 0;

    constructor(private readonly renderer: WebGLRenderer) {
        this.whole = new Pass(renderer, SHAPE_VERTEX, SHAPE_FRAGMENT, { depth: true });
        this.coarse = new Pass(renderer, SHAPE_VERTEX, SHAPE_FRAGMENT, { depth: true });
    }

    ready(): boolean {
        return this.whole.ready() && this.coarse.ready();
    }

    setMesh(mesh: Mesh): void {
        this.whole.setMesh(mesh);
        this.mesh = mesh;
        this.cell = 0;
    }

    /**
     * Into the picture's own textures, unless they have it already.
     * @param shift   in pixels, of the place where samples look
     * @param coarse  the picture is
     */
    draw(
        sums: Sums,
        transform: Transform,
        turn_deg: number,
        camera: Camera,
        eye: Eye,
        shift: readonly [number, number],
        coarse: boolean,
    ): void {
        if (sums.shapeFrom?.[0] === shift[0] && sums.shapeFrom[1] === shift[1]) return;
        sums.shapeFrom = shift;
        const { shape: target } = sums;
        const moved = [(-2 * shift[0]) / target.width, (-2 * shift[1]) / target.height] as const;
        if (coarse) this.fit(target.height, transform, camera);
        const pass = coarse ? this.coarse : this.whole;
        pass.set({
            toWorld: shapeMatrix(transform, turn_deg, camera.target_mm),
            toScreen: screenMatrix(eye, camera.distance_mm, moved),
        });
        clear(this.renderer, target);
        pass.draw(target);
    }

    /** The coarse one, to a picture of so many rows. */
    private fit(rows: number, { scale }: Transform, { distance_mm, fov_deg }: Camera): void {
        const seen_mm = 2 * distance_mm * Math.tan((fov_deg * Math.PI) / 360);
        const pixel = seen_mm / rows / scale;
        if (this.mesh === null) return;
        if (this.cell <= COARSE_CELL * pixel && this.cell >= LEAST_COARSE_CELL * pixel) return;
        // Between both, so that it fits for a while as the camera comes closer or goes away.
        this.cell = Math.sqrt(COARSE_CELL * LEAST_COARSE_CELL) * pixel;
        this.coarse.setMesh(coarser(this.mesh, this.cell));
    }
}
