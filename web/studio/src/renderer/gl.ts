/** What every picture in WebGL 2 needs. */

import type { Mesh } from "./paint";

export class Program {
    private readonly locations = new Map<string, WebGLUniformLocation | null>();
    private checked = false;

    private constructor(
        private readonly gl: WebGL2RenderingContext,
        readonly handle: WebGLProgram,
        private readonly shaders: readonly WebGLShader[],
    ) {}

    /** Begins to compile; ready() tells when that is done. */
    static begin(gl: WebGL2RenderingContext, vertex: string, fragment: string): Program {
        const handle = gl.createProgram();
        const shaders = [
            [gl.VERTEX_SHADER, vertex] as const,
            [gl.FRAGMENT_SHADER, fragment] as const,
        ].map(([type, text]) => {
            const shader = gl.createShader(type) as WebGLShader;
            gl.shaderSource(shader, `#version 300 es\n${text}`);
            gl.compileShader(shader);
            gl.attachShader(handle, shader);
            return shader;
        });
        gl.linkProgram(handle);
        return new Program(gl, handle, shaders);
    }

    /** Whether it can be used; where the browser compiles beside the page, this does not wait. */
    ready(): boolean {
        if (this.checked) return true;
        const { gl } = this;
        const beside = gl.getExtension("KHR_parallel_shader_compile");
        if (
            beside !== null &&
            !gl.getProgramParameter(this.handle, beside.COMPLETION_STATUS_KHR) &&
            !gl.isContextLost()
        ) {
            return false;
        }
        if (!gl.getProgramParameter(this.handle, gl.LINK_STATUS) && !gl.isContextLost()) {
            const logs = this.shaders.map((shader) => gl.getShaderInfoLog(shader));
            throw new Error(`shader: ${[gl.getProgramInfoLog(this.handle), ...logs].join("\n")}`);
        }
        for (const shader of this.shaders) gl.deleteShader(shader);
        this.checked = true;
        return true;
    }

    use(): this {
        this.gl.useProgram(this.handle);
        return this;
    }

    /** null where the text does not use it, which WebGL takes as nothing to set. */
    at(name: string): WebGLUniformLocation | null {
        let location = this.locations.get(name);
        if (location === undefined) {
            location = this.gl.getUniformLocation(this.handle, name);
            this.locations.set(name, location);
        }
        return location;
    }

    int(name: string, value: number): void {
        this.gl.uniform1i(this.at(name), value);
    }

    floats(name: string, components: number, values: ArrayLike<number>): void {
        const { gl } = this;
        const list = Float32Array.from(values);
        const at = this.at(name);
        if (components === 1) gl.uniform1fv(at, list);
        else if (components === 2) gl.uniform2fv(at, list);
        else if (components === 3) gl.uniform3fv(at, list);
        else gl.uniform4fv(at, list);
    }

    matrix(name: string, columns: Float32Array): void {
        const at = this.at(name);
        if (columns.length === 16) this.gl.uniformMatrix4fv(at, false, columns);
        else this.gl.uniformMatrix3fv(at, false, columns);
    }
}

/** Textures that are drawn into, with depth if so wanted. */
export class Target {
    readonly framebuffer: WebGLFramebuffer;
    readonly textures: readonly WebGLTexture[];
    private readonly depth: WebGLRenderbuffer | null = null;

    constructor(
        private readonly gl: WebGL2RenderingContext,
        readonly width: number,
        readonly height: number,
        formats: readonly GLenum[],
        withDepth: boolean,
    ) {
        this.framebuffer = gl.createFramebuffer();
        gl.bindFramebuffer(gl.FRAMEBUFFER, this.framebuffer);
        const attachments: GLenum[] = [];
        this.textures = formats.map((format, index) => {
            const made = gl.createTexture();
            gl.bindTexture(gl.TEXTURE_2D, made);
            gl.texStorage2D(gl.TEXTURE_2D, 1, format, width, height);
            plain(gl, gl.TEXTURE_2D, gl.NEAREST, gl.CLAMP_TO_EDGE);
            const attachment = gl.COLOR_ATTACHMENT0 + index;
            gl.framebufferTexture2D(gl.FRAMEBUFFER, attachment, gl.TEXTURE_2D, made, 0);
            attachments.push(attachment);
            return made;
        });
        if (withDepth) {
            this.depth = gl.createRenderbuffer();
            gl.bindRenderbuffer(gl.RENDERBUFFER, this.depth);
            gl.renderbufferStorage(gl.RENDERBUFFER, gl.DEPTH_COMPONENT24, width, height);
            gl.framebufferRenderbuffer(
                gl.FRAMEBUFFER,
                gl.DEPTH_ATTACHMENT,
                gl.RENDERBUFFER,
                this.depth,
            );
        }
        gl.drawBuffers(attachments);
        this.clear();
    }

    bind(): void {
        this.gl.bindFramebuffer(this.gl.FRAMEBUFFER, this.framebuffer);
        this.gl.viewport(0, 0, this.width, this.height);
    }

    clear(): void {
        const { gl } = this;
        this.bind();
        gl.disable(gl.SCISSOR_TEST);
        gl.clearColor(0, 0, 0, 0);
        gl.clear(gl.COLOR_BUFFER_BIT | (this.depth ? gl.DEPTH_BUFFER_BIT : 0));
    }

    delete(): void {
        for (const made of this.textures) this.gl.deleteTexture(made);
        this.gl.deleteRenderbuffer(this.depth);
        this.gl.deleteFramebuffer(this.framebuffer);
    }
}

/** Triangles for a shader whose first two inputs are places and normals. */
export function fillMesh(
    gl: WebGL2RenderingContext,
    arrays: WebGLVertexArrayObject,
    buffers: readonly [WebGLBuffer, WebGLBuffer, WebGLBuffer],
    mesh: Mesh,
): void {
    const [positions, normals, indices] = buffers;
    gl.bindVertexArray(arrays);
    for (const [at, buffer, data] of [
        [0, positions, mesh.positions],
        [1, normals, mesh.normals],
    ] as const) {
        gl.bindBuffer(gl.ARRAY_BUFFER, buffer);
        gl.bufferData(gl.ARRAY_BUFFER, data, gl.STATIC_DRAW);
        gl.enableVertexAttribArray(at);
        gl.vertexAttribPointer(at, 3, gl.FLOAT, false, 0, 0);
    }
    gl.bindBuffer(gl.ELEMENT_ARRAY_BUFFER, indices);
    gl.bufferData(gl.ELEMENT_ARRAY_BUFFER, mesh.indices, gl.STATIC_DRAW);
    gl.bindVertexArray(null);
}

/** RGB of all textures together, each divided by its alpha, the number of its samples; and 1. */
export function sumOfMeans(gl: WebGL2RenderingContext, target: Target): Float32Array {
    const { width, height } = target;
    const data = new Float32Array(4 * width * height);
    target.bind();
    target.textures.forEach((_, index) => {
        const sums = new Float32Array(data.length);
        gl.readBuffer(gl.COLOR_ATTACHMENT0 + index);
        gl.readPixels(0, 0, width, height, gl.RGBA, gl.FLOAT, sums);
        for (let i = 0; i < data.length; i += 4) {
            const scale = 1 / Math.max(sums[i + 3] as number, 1);
            for (let c = i; c < i + 3; ++c) {
                data[c] = (data[c] as number) + scale * (sums[c] as number);
            }
            data[i + 3] = 1;
        }
    });
    return data;
}

function plain(gl: WebGL2RenderingContext, target: GLenum, filter: GLenum, wrap: GLenum): void {
    gl.texParameteri(target, gl.TEXTURE_MIN_FILTER, filter);
    gl.texParameteri(target, gl.TEXTURE_MAG_FILTER, filter);
    gl.texParameteri(target, gl.TEXTURE_WRAP_S, wrap);
    gl.texParameteri(target, gl.TEXTURE_WRAP_T, gl.CLAMP_TO_EDGE);
    gl.texParameteri(target, gl.TEXTURE_WRAP_R, gl.CLAMP_TO_EDGE);
}

export interface Filtering {
    readonly linear?: boolean;
    readonly repeat?: boolean;
}

/** Puts numbers into a texture, which must be one of its own: of two or three dimensions. */
export function fill(
    gl: WebGL2RenderingContext,
    texture: WebGLTexture,
    format: "rgba16f" | "r32f",
    size: readonly number[],
    data: Uint16Array | Float32Array,
    { linear = false, repeat = false }: Filtering = {},
): void {
    const [width = 1, height = 1, depth] = size;
    const target = depth === undefined ? gl.TEXTURE_2D : gl.TEXTURE_3D;
    const [inside, order] = format === "r32f" ? [gl.R32F, gl.RED] : [gl.RGBA16F, gl.RGBA];
    const type = data instanceof Uint16Array ? gl.HALF_FLOAT : gl.FLOAT;
    gl.bindTexture(target, texture);
    if (depth === undefined) {
        gl.texImage2D(target, 0, inside, width, height, 0, order, type, data);
    } else {
        gl.texImage3D(target, 0, inside, width, height, depth, 0, order, type, data);
    }
    plain(gl, target, linear ? gl.LINEAR : gl.NEAREST, repeat ? gl.REPEAT : gl.CLAMP_TO_EDGE);
}
