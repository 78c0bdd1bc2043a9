/** Runs in a page of the studio: what the shader of a paint makes of single flakes, number by number. */

import { fill, Program } from "../src/renderer/gl";
import type { PaintShader } from "../src/renderer/paint";
import { EVERYWHERE, HEAD } from "../src/renderer/passes";
import { shaderOf } from "./live_session";

/** A cell of flakes and the number of a flake in it. */
export interface HashCase {
    /** Of its level: 64 bits, in hexadecimal digits. */
    readonly level: string;
    readonly side: number;
    readonly u: number;
    readonly v: number;
    readonly n: number;
}

/** A shader of the paint with a main() of its own, which writes to integers or floats. */
class Probe {
    private constructor(
        private readonly gl: WebGL2RenderingContext,
        readonly program: Program,
        private readonly floats: boolean,
        private readonly outputs: number,
    ) {}

    static async of(
        paint: PaintShader,
        main: string,
        { floats, outputs }: { floats: boolean; outputs: number },
    ): Promise<Probe> {
        const gl = document.createElement("canvas").getContext("webgl2");
        if (gl === null) throw new Error("there is no WebGL 2");
        if (gl.getExtension("EXT_color_buffer_float") === null) throw new Error("no floats");
        const text = `${HEAD}${paint.glsl}\nvec3 nacreRadiance(vec3 wo) { return wo; }\n${main}`;
        const program = Program.begin(gl, EVERYWHERE, text);
        while (!program.ready()) await new Promise(requestAnimationFrame);
        program.use();
        for (const { name, components, array, values } of paint.uniforms) {
            program.floats(array ? `${name}[0]` : name, components, values);
        }
        paint.textures.forEach(({ name, size, data }, unit) => {
            gl.activeTexture(gl.TEXTURE0 + unit);
            fill(gl, gl.createTexture(), "rgba16f", size, data, { linear: size.length === 3 });
            program.int(name, unit);
        });
        gl.activeTexture(gl.TEXTURE0 + paint.textures.length);
        gl.bindFramebuffer(gl.FRAMEBUFFER, gl.createFramebuffer());
        const attachments = Array.from({ length: outputs }, (_, k) => gl.COLOR_ATTACHMENT0 + k);
        for (const attachment of attachments) {
            const texture = gl.createTexture();
            gl.bindTexture(gl.TEXTURE_2D, texture);
            gl.texStorage2D(gl.TEXTURE_2D, 1, floats ? gl.RGBA32F : gl.RGBA32UI, 1, 1);
            gl.framebufferTexture2D(gl.FRAMEBUFFER, attachment, gl.TEXTURE_2D, texture, 0);
        }
        gl.drawBuffers(attachments);
        gl.viewport(0, 0, 1, 1);
        return new Probe(gl, program, floats, outputs);
    }

    integers(name: string, [x, y, z, w]: readonly [number, number, number, number]): void {
        this.gl.uniform4i(this.program.at(name), x, y, z, w);
    }

    /** Of each output four numbers. */
    draw(): number[] {
        const { gl } = this;
        gl.drawArrays(gl.TRIANGLES, 0, 3);
        return Array.from({ length: this.outputs }, (_, k) => {
            gl.readBuffer(gl.COLOR_ATTACHMENT0 + k);
            const out = this.floats ? new Float32Array(4) : new Uint32Array(4);
            if (this.floats) gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.FLOAT, out);
            else gl.readPixels(0, 0, 1, 1, gl.RGBA_INTEGER, gl.UNSIGNED_INT, out);
            return Array.from(out);
        }).flat();
    }
}

/** What the shader of a paint makes of each, as hexadecimal digits: cell, place, kind, body. */
async function hashes(paintName: string, cases: readonly HashCase[]): Promise<string[][]> {
    const probe = await Probe.of(
        await shaderOf(paintName, "studio"),
        `
uniform ivec4 level;  // 16 bits each, from the lowest
uniform ivec4 at;
layout(location = 0) out uvec4 first;
layout(location = 1) out uvec4 second;
void main() {
    uvec4 k = uvec4(level);
    uvec2 cell = nacreCellKey(uvec2(k.x | k.y << 16, k.z | k.w << 16), at.x, at.y, at.z);
    uvec2 flake = nacreFlakeBits(cell, at.w);
    first = uvec4(cell, flake);
    second = uvec4(nacreHash(flake.x, flake.y), 0u, 0u);
}`,
        { floats: false, outputs: 2 },
    );
    const digits = (...bits: number[]) =>
        bits.map((part) => part.toString(16).padStart(8, "0")).join("");
    return cases.map(({ level, side, u, v, n }) => {
        const part = (k: number) => parseInt(level.slice(12 - 4 * k, 16 - 4 * k), 16);
        probe.integers("level", [part(0), part(1), part(2), part(3)]);
        probe.integers("at", [side, u, v, n]);
        const [low = 0, high = 0, place = 0, kind = 0, a = 0, b = 0] = probe.draw();
        return [digits(high, low), digits(place), digits(kind), digits(b, a)];
    });
}

/** A flake of the first species, and two directions. */
export interface FlakeCase {
    readonly place: number;
    readonly kind: number;
    readonly wi: readonly number[];
    readonly wo: readonly number[];
}

/** What the shader of a paint makes of each: RGB of nacreFlakeColour(). */
async function flakeColours(paintName: string, cases: readonly FlakeCase[]): Promise<number[][]> {
    const probe = await Probe.of(
        await shaderOf(paintName, "studio"),
        `
uniform ivec4 flake;  // 16 bits each: its place and its kind, the lower first
uniform vec3 wi;
uniform vec3 wo;
out vec4 colour;
void main() {
    uvec4 k = uvec4(flake);
    uvec2 body = nacreHash(k.x | k.y << 16, k.z | k.w << 16);
    colour = vec4(nacreFlakeColour(0, body, wi, wo, nacrePair(wi, wo)), 1.);
}`,
        { floats: true, outputs: 1 },
    );
    return cases.map(({ place, kind, wi, wo }) => {
        const halves = (bits: number) => [bits & 0xffff, bits >>> 16] as const;
        probe.integers("flake", [...halves(place), ...halves(kind)]);
        probe.program.floats("wi", 3, wi);
        probe.program.floats("wo", 3, wo);
        return probe.draw().slice(0, 3);
    });
}

declare global {
    interface Window {
        hashes: typeof hashes;
        flakeColours: typeof flakeColours;
    }
}
window.hashes = hashes;
window.flakeColours = flakeColours;
