/** Runs in a page of the studio: what the shader of a paint makes of single flakes, number by number. */

import type { WebGLRenderer } from "three";
import { FloatType, RGBAIntegerFormat, UnsignedIntType, WebGLRenderTarget } from "three";
import type { PaintShader } from "../src/renderer/paint";
import { uniformValues } from "../src/renderer/paint";
import { filled, Pass, rendererOn } from "../src/renderer/pass";
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
        private readonly renderer: WebGLRenderer,
        readonly pass: Pass,
        private readonly target: WebGLRenderTarget,
        private readonly floats: boolean,
    ) {}

    static async of(
        paint: PaintShader,
        main: string,
        { floats, outputs }: { floats: boolean; outputs: number },
    ): Promise<Probe> {
        const renderer = rendererOn(document.createElement("canvas"));
        const text = `${HEAD}${paint.glsl}\nvec3 nacreRadiance(vec3 wo) { return wo; }\n${main}`;
        const pass = new Pass(renderer, EVERYWHERE, text);
        while (!pass.ready()) await new Promise(requestAnimationFrame);
        pass.set(uniformValues(paint));
        for (const { name, size, data } of paint.textures) {
            const filtering = { linear: size.length === 3 };
            pass.set({ [name]: filled(undefined, "rgba16f", size, data, filtering) });
        }
        const target = new WebGLRenderTarget(1, 1, {
            count: outputs,
            type: floats ? FloatType : UnsignedIntType,
            ...(floats ? {} : { format: RGBAIntegerFormat }),
            depthBuffer: false,
        });
        return new Probe(renderer, pass, target, floats);
    }

    /** Of each output four numbers. */
    draw(): number[] {
        this.pass.draw(this.target);
        return this.target.textures.flatMap((_, k) => {
            const out = this.floats ? new Float32Array(4) : new Uint32Array(4);
            this.renderer.readRenderTargetPixels(this.target, 0, 0, 1, 1, out, 0, k);
            return Array.from(out);
        });
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
        probe.pass.set({ level: [part(0), part(1), part(2), part(3)], at: [side, u, v, n] });
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
        probe.pass.set({ flake: [...halves(place), ...halves(kind)], wi, wo });
        return probe.draw().slice(0, 3);
    });
}

/** The sides of a patch, and a light's area in slopes over that of a lobe. */
export interface LevelCase {
    readonly side_mm: readonly number[];
    readonly light_area: number;
}

/** What the shader of a paint resolves of its first species on each: nacreLevels(). */
async function flakeLevels(
    paintName: string,
    cases: readonly LevelCase[],
): Promise<{ resolved: number; widening: number }[]> {
    const probe = await Probe.of(
        await shaderOf(paintName, "studio"),
        `
uniform vec3 patch_;
out vec4 levels;
void main() {
    NacreShown shown = nacreLevels(0, patch_.xy, patch_.z);
    levels = vec4(shown.resolved, shown.widening, 0., 0.);
}`,
        { floats: true, outputs: 1 },
    );
    return cases.map(({ side_mm: [x = 0, y = 0], light_area }) => {
        probe.pass.set({ patch_: [x, y, light_area] });
        const [resolved = 0, widening = 0] = probe.draw();
        return { resolved, widening };
    });
}

declare global {
    interface Window {
        hashes: typeof hashes;
        flakeColours: typeof flakeColours;
        flakeLevels: typeof flakeLevels;
    }
}
window.hashes = hashes;
window.flakeColours = flakeColours;
window.flakeLevels = flakeLevels;
