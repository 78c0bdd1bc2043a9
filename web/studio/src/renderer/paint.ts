/** What is drawn, as the server sends it: a paint's shader, a shape and a light. */

import type { Attachment, Message } from "../protocol";
import type { Value } from "./pass";

/** A paint as `src/nacre/exchange/webgl_shader.h` makes it. */
export interface PaintShader {
    /** Names the text: programs are compiled once for each. */
    readonly program: string;
    /** GLSL ES 3.00 with nacreColour(wi, wo) and what it needs. */
    readonly glsl: string;
    /** Its mirror image is no part of nacreColour(). */
    readonly smoothCoat: boolean;
    /** It has single flakes beside their mean. */
    readonly flakes: boolean;
    /** They are told apart: they have their films. */
    readonly films: boolean;
    readonly uniforms: readonly PaintUniform[];
    readonly textures: readonly PaintTexture[];
}

export interface PaintUniform {
    readonly name: string;
    readonly components: number;
    readonly array: boolean;
    readonly values: ArrayLike<number>;
}

export interface PaintTexture {
    readonly name: string;
    /** Width, height and, of three dimensions, depth. */
    readonly size: readonly number[];
    /** Bits of half floats in RGBA. */
    readonly data: Uint16Array<ArrayBuffer>;
}

/** What tells single flakes of a paint apart. */
export type PaintFilms = Pick<PaintShader, "uniforms" | "textures">;

/** Uniforms as shaders are given them. */
export function uniformValues({ uniforms }: PaintFilms): Record<string, Value> {
    return Object.fromEntries(
        uniforms.map(({ name, components, array, values }) => {
            const single = components === 1 && !array;
            return [name, single ? (values[0] as number) : Float32Array.from(values)];
        }),
    );
}

/** Triangles in millimetres of the shape's own coordinates; z up. */
export interface Mesh {
    readonly positions: Float32Array;
    readonly normals: Float32Array;
    readonly indices: Uint32Array;
}

type Vec3 = readonly [number, number, number];

/** From a shape's coordinates to the world: scale, turn about x, y and z, move. */
export interface Transform {
    readonly scale: number;
    readonly rotation_deg: Vec3;
    readonly translation_mm: Vec3;
}

/** Linear Rec. 709: 1 is the white of the picture. */
export interface Light {
    /** From all directions: a picture of the columns azimuth_deg + 180 ... - 180, zenith first. */
    readonly width: number;
    readonly height: number;
    readonly rgb: Float32Array;
    readonly azimuth_deg: number;
    readonly sun: Sun | null;
    readonly rectangles: readonly Rectangle[];
}

export interface Sun {
    /** Towards it. */
    readonly direction: Vec3;
    readonly rgb: Vec3;
    readonly angular_radius_deg: number;
}

/** Shines from the side of its normal. */
export interface Rectangle {
    readonly corner: Vec3;
    readonly edge_u: Vec3;
    readonly edge_v: Vec3;
    readonly normal: Vec3;
    readonly rgb: Vec3;
}

/**
 * The message `shader`: a session is sent the text of a program once.
 * @param texts  those that came before, by program; it is added to
 */
export function readPaint(
    message: Message,
    attachments: readonly Attachment[],
    texts: Map<string, string>,
): PaintShader {
    const program = String(message.program);
    if (typeof message.glsl === "string") texts.set(program, message.glsl);
    const glsl = texts.get(program);
    if (glsl === undefined) throw new Error(`shader ${program}: its text did not come`);
    return {
        program,
        glsl,
        smoothCoat: message.smooth_coat === true,
        flakes: glsl.includes("#define NACRE_FLAKES "),
        films: false,
        ...numbersOf(message, attachments),
    };
}

/** The message `films`; without it, where the server finds a fault, all flakes of a species are alike. */
export function readFilms(message: Message, attachments: readonly Attachment[]): PaintFilms {
    if (message.type !== "films") return { uniforms: [], textures: [] };
    return numbersOf(message, attachments);
}

export function withFilms(paint: PaintShader, films: PaintFilms): PaintShader {
    const told = new Set([...films.uniforms, ...films.textures].map(({ name }) => name));
    const others = <T extends { readonly name: string }>(list: readonly T[]) =>
        list.filter(({ name }) => !told.has(name));
    return {
        ...paint,
        films: true,
        uniforms: [...others(paint.uniforms), ...films.uniforms],
        textures: [...others(paint.textures), ...films.textures],
    };
}

function numbersOf(message: Message, attachments: readonly Attachment[]): PaintFilms {
    return {
        uniforms: message.uniforms as PaintUniform[],
        textures: attachments.map(({ name, shape, data }) => ({
            name,
            size: shape.slice(0, -1).reverse(),
            data: new Uint16Array(data.buffer as ArrayBuffer, data.byteOffset, data.byteLength / 2),
        })),
    };
}

/** Bytes of GET /api/shape/NAME. */
export function readMesh(bytes: ArrayBuffer): Mesh {
    const [vertices, triangles] = new Uint32Array(bytes, 0, 2) as unknown as [number, number];
    const at = 8;
    return {
        positions: new Float32Array(bytes, at, 3 * vertices),
        normals: new Float32Array(bytes, at + 12 * vertices, 3 * vertices),
        indices: new Uint32Array(bytes, at + 32 * vertices, 3 * triangles),
    };
}

/** Bytes of GET /api/light/NAME. */
export function readLight(bytes: ArrayBuffer): Light {
    const [length] = new Uint32Array(bytes, 0, 1) as unknown as [number];
    const text = new TextDecoder().decode(new Uint8Array(bytes, 4, length));
    const header = JSON.parse(text) as Pick<Light, "sun" | "rectangles" | "azimuth_deg">;
    const [width, height] = new Uint32Array(bytes, 4 + length, 2) as unknown as [number, number];
    const rgb = new Float32Array(bytes, 12 + length, 3 * width * height);
    return { ...header, width, height, rgb };
}
