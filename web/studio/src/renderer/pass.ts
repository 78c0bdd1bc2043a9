/** Pictures of numbers by three.js, which draws here what shaders make of them and changes nothing itself. */

import type { TextureDataType } from "three";
import {
    BufferAttribute,
    BufferGeometry,
    Camera,
    ClampToEdgeWrapping,
    CustomBlending,
    Data3DTexture,
    DataTexture,
    DoubleSide,
    FloatType,
    GLSL3,
    HalfFloatType,
    LessDepth,
    LinearFilter,
    LinearSRGBColorSpace,
    Mesh,
    NearestFilter,
    NoBlending,
    OneFactor,
    RawShaderMaterial,
    RedFormat,
    RepeatWrapping,
    RGBAFormat,
    Scene,
    Texture,
    WebGLRenderer,
    WebGLRenderTarget,
} from "three";
import type { Mesh as Triangles } from "./paint";

/** @throws Error that says what the browser lacks, where WebGL 2 does not draw into floats */
export function rendererOn(canvas: HTMLCanvasElement): WebGLRenderer {
    // Asked for here: three.js would write to the console that there is none.
    const context = canvas.getContext("webgl2", {
        alpha: true, // until the first frame what lies behind is seen
        antialias: false,
        depth: false,
        preserveDrawingBuffer: true,
    });
    if (context === null) throw new Error("this browser has no WebGL 2");
    if (context.getExtension("EXT_color_buffer_float") === null) {
        throw new Error("this browser's WebGL 2 does not draw into floats");
    }
    const renderer = new WebGLRenderer({ canvas, context });
    renderer.autoClear = false;
    renderer.sortObjects = false;
    renderer.setClearColor(0, 0);
    renderer.outputColorSpace = LinearSRGBColorSpace; // shaders encode what is seen
    renderer.debug.onShaderError = (gl, program, vertex, fragment) => {
        const logs = [gl.getProgramInfoLog(program)];
        logs.push(gl.getShaderInfoLog(vertex), gl.getShaderInfoLog(fragment));
        throw new Error(`shader: ${logs.join("\n")}`);
    };
    return renderer;
}

/** Shaders have matrices of their own. */
const CAMERA = new Camera();

/** Of a uniform; of vectors, matrices and arrays all components in a row. */
export type Value = number | Float32Array | readonly number[] | Texture;

export interface PassOptions {
    /** Adds to what the target has, else it takes its place. */
    readonly adds?: boolean;
    /** Nearer triangles hide those behind them. */
    readonly depth?: boolean;
}

/** A vertex and a fragment shader, the numbers that they are given, and the triangles: one over everything. */
export class Pass {
    private readonly scene = new Scene();
    private readonly mesh: Mesh<BufferGeometry, RawShaderMaterial>;
    private compiled = false;
    private fault: unknown = null;

    /** Begins to compile; ready() tells when that is done. */
    constructor(
        private readonly renderer: WebGLRenderer,
        vertexShader: string,
        fragmentShader: string,
        { adds = false, depth = false }: PassOptions = {},
    ) {
        const material = new RawShaderMaterial({
            glslVersion: GLSL3,
            vertexShader,
            fragmentShader,
            side: DoubleSide,
            depthTest: depth,
            depthWrite: depth,
            depthFunc: LessDepth,
            blending: adds ? CustomBlending : NoBlending,
            blendSrc: OneFactor,
            blendDst: OneFactor,
        });
        this.mesh = new Mesh(new BufferGeometry(), material);
        this.mesh.geometry.setDrawRange(0, 3);
        this.mesh.frustumCulled = false;
        this.scene.add(this.mesh);
        this.scene.matrixWorldAutoUpdate = false;
        renderer.compileAsync(this.scene, CAMERA).then(
            () => (this.compiled = true),
            (error: unknown) => (this.fault = error),
        );
    }

    /** Whether it can be used; where the browser compiles beside the page, this does not wait. */
    ready(): boolean {
        if (this.fault !== null) throw this.fault as Error;
        return this.compiled;
    }

    /** Triangles for a vertex shader whose inputs are `position` and `normal`. */
    setMesh({ positions, normals, indices }: Triangles): void {
        const geometry = new BufferGeometry();
        geometry.setAttribute("position", new BufferAttribute(positions, 3));
        geometry.setAttribute("normal", new BufferAttribute(normals, 3));
        geometry.setIndex(new BufferAttribute(indices, 1));
        this.mesh.geometry.dispose();
        this.mesh.geometry = geometry;
    }

    /** All that the shaders have must be set before it is first drawn; what they do not have is left out. */
    set(values: Readonly<Record<string, Value>>): void {
        const { uniforms } = this.mesh.material;
        for (const [name, value] of Object.entries(values)) {
            const known = uniforms[name];
            if (known === undefined) uniforms[name] = { value };
            else known.value = value;
        }
    }

    /**
     * @param target  null: the canvas
     * @param rows    that are drawn: the first, counted from the bottom, and how many
     * @throws Error  of a shader that the browser refuses
     */
    draw(target: WebGLRenderTarget | null, rows?: readonly [number, number]): void {
        if (target !== null) {
            target.scissorTest = rows !== undefined;
            if (rows !== undefined) target.scissor.set(0, rows[0], target.width, rows[1]);
        }
        this.renderer.setRenderTarget(target);
        this.renderer.render(this.scene, CAMERA);
    }
}

/** What is drawn into, cleared. @param type  of each of its textures, which have RGBA or only red */
export function makeTarget(
    renderer: WebGLRenderer,
    width: number,
    height: number,
    type: TextureDataType,
    { count = 1, depth = false, linear = false, red = false } = {},
): WebGLRenderTarget {
    const target = new WebGLRenderTarget(width, height, {
        count,
        type,
        format: red ? RedFormat : RGBAFormat,
        minFilter: linear ? LinearFilter : NearestFilter,
        magFilter: linear ? LinearFilter : NearestFilter,
        depthBuffer: depth,
    });
    clear(renderer, target);
    return target;
}

export function clear(renderer: WebGLRenderer, target: WebGLRenderTarget): void {
    target.scissorTest = false;
    renderer.setRenderTarget(target);
    renderer.clear(true, target.depthBuffer, false);
}

export interface Filtering {
    readonly linear?: boolean;
    readonly repeat?: boolean;
}

/**
 * A texture with these numbers, of two or three dimensions.
 * @param before  one that is not needed any more: the same where its size is
 */
export function filled(
    before: Texture | undefined,
    format: "rgba16f" | "r32f",
    size: readonly number[],
    data: Uint16Array<ArrayBuffer> | Float32Array<ArrayBuffer>,
    { linear = false, repeat = false }: Filtering = {},
): Texture {
    const [width = 1, height = 1, depth] = size;
    if (before instanceof DataTexture || before instanceof Data3DTexture) {
        const { image } = before;
        const deep = "depth" in image ? image.depth : undefined;
        if (image.width === width && image.height === height && deep === depth) {
            image.data = data;
            before.needsUpdate = true;
            return before;
        }
    }
    before?.dispose();
    const texture =
        depth === undefined
            ? new DataTexture(data, width, height)
            : new Data3DTexture(data, width, height, depth);
    texture.format = format === "r32f" ? RedFormat : RGBAFormat;
    texture.internalFormat = format === "r32f" ? "R32F" : "RGBA16F";
    texture.type = data instanceof Uint16Array ? HalfFloatType : FloatType;
    texture.minFilter = texture.magFilter = linear ? LinearFilter : NearestFilter;
    texture.wrapS = repeat ? RepeatWrapping : ClampToEdgeWrapping;
    texture.needsUpdate = true;
    return texture;
}
