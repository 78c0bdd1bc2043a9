/** Runs in a page of the studio, beside it: draws its own live picture from what the server says. */

import { Program } from "../src/renderer/gl";
import { LiveView } from "../src/renderer/live_view";
import { readLight, readMesh, readPaint } from "../src/renderer/paint";
import type { PaintShader, Transform } from "../src/renderer/paint";
import { EVERYWHERE, HEAD } from "../src/renderer/passes";
import type { Attachment, Message } from "../src/protocol";
import { orbitOf } from "../src/orbit";
import type { Schema } from "../src/schema";
import { unpack } from "../src/session";
import type { Table } from "../src/tree";

export interface LivePicture {
    /** Linear Rec. 709 in RGBA, row by row from the top. */
    readonly data: number[];
    readonly width: number;
    readonly height: number;
}

/** The answer of a type to one message, with its arrays; errors are thrown. */
function asked(fields: object, type: string): Promise<[Message, Attachment[]]> {
    return new Promise((resolve, reject) => {
        const query = new URLSearchParams(location.search);
        const socket = new WebSocket(
            `ws://${location.host}/api/session?token=${query.get("token") ?? ""}`,
        );
        socket.binaryType = "arraybuffer";
        let last: Message | null = null;
        socket.onopen = () => {
            socket.send(JSON.stringify({ id: 1, ...fields }));
        };
        const take = (message: Message, attachments: Attachment[]) => {
            if (message.type === "error") reject(new Error(String(message.message)));
            const whole = message.type !== "picture" || message.samples === message.of;
            if (message.type !== type || !whole) return;
            resolve([message, attachments]);
            socket.close();
        };
        socket.onmessage = ({ data }: MessageEvent<string | ArrayBuffer>) => {
            if (typeof data === "string") {
                last = JSON.parse(data) as Message;
                if (!Array.isArray(last.binary)) take(last, []);
            } else if (last !== null) {
                take(last, unpack(last.binary as Omit<Attachment, "data">[], data));
            }
        };
    });
}

async function api(path: string): Promise<Response> {
    const token = new URLSearchParams(location.search).get("token") ?? "";
    return fetch(`/api/${path}${path.includes("?") ? "&" : "?"}token=${token}`);
}

const schema = async () => (await (await api("schema")).json()) as Schema;

/** The tree of a paint that ships. */
async function recipeOf(name: string): Promise<Table> {
    const paint = (await schema()).paints.find((known) => known.name === name);
    if (paint === undefined) throw new Error(`there is no paint ${name}`);
    const [opened] = await asked({ type: "open", toml: paint.toml }, "recipe");
    return opened.tree as Table;
}

export interface Scene {
    readonly paint: string;
    readonly shape: string;
    readonly light: string;
    /** Pixels of a side. */
    readonly size: number;
}

async function shaderOf(paintName: string, light: string): Promise<PaintShader> {
    const lamp = (await schema()).lights.find(({ name }) => name === light)?.illuminant;
    const fields = { type: "paint", recipe: await recipeOf(paintName), shader: true, lamp };
    return readPaint(...(await asked(fields, "shader")), new Map());
}

/** The live picture, with single flakes or their mean. */
async function live(scene: Scene, samples: number, sparkle: boolean): Promise<LivePicture> {
    const shape = (await schema()).shapes.find(({ name }) => name === scene.shape);
    if (shape === undefined) throw new Error(`there is no ${scene.shape}`);
    const paint = await shaderOf(scene.paint, scene.light);
    const { size } = scene;
    const canvas = document.createElement("canvas");
    const view = await new Promise<LiveView>((resolve, reject) => {
        const made = new LiveView(canvas, {
            samples,
            onFault: (message) => {
                reject(new Error(message));
            },
            onChange: (state) => {
                if (state.samples >= samples) resolve(made);
            },
        });
        made.setSparkle(sparkle);
        void Promise.all([api(`shape/${scene.shape}`), api(`light/${scene.light}?width=1024`)])
            .then((answers) => Promise.all(answers.map((answer) => answer.arrayBuffer())))
            .then(([mesh, light]) => {
                made.resize(size, size);
                const { transform } = shape as unknown as { transform: Transform };
                made.setShape(readMesh(mesh as ArrayBuffer), transform);
                made.setLight(readLight(light as ArrayBuffer));
                made.setCamera({ ...orbitOf(shape), target_mm: shape.camera.target_mm });
                made.setPaint(paint);
            }, reject);
    });
    const { width, height, data } = view.pixels();
    view.dispose();
    const rows = Array.from({ length: height }, (_, y) =>
        Array.from(data.subarray(4 * width * (height - 1 - y), 4 * width * (height - y))),
    );
    return { width, height, data: rows.flat() };
}

/** The path tracer's, in RGB. */
async function traced(scene: Scene, samples: number, specimen: number): Promise<LivePicture> {
    const { paint, size, shape, light } = scene;
    const fields = {
        type: "render",
        recipe: await recipeOf(paint),
        scene: { shape, light, camera: null, turn_deg: 0, light_turn_deg: 0, specimen },
        width: size,
        height: size,
        samples,
        linear: true,
    };
    const [, arrays] = await asked(fields, "picture");
    const linear = arrays.find(({ name }) => name === "linear");
    if (linear === undefined) throw new Error("a picture came without its linear values");
    return { width: size, height: size, data: Array.from(linear.data as Float32Array) };
}

/** A cell of flakes and the number of a flake in it. */
export interface HashCase {
    /** Of its level: 64 bits, in hexadecimal digits. */
    readonly level: string;
    readonly side: number;
    readonly u: number;
    readonly v: number;
    readonly n: number;
}

/** What the shader of a paint makes of each, as hexadecimal digits: cell, place, kind, body. */
async function hashes(paintName: string, cases: readonly HashCase[]): Promise<string[][]> {
    const gl = document.createElement("canvas").getContext("webgl2");
    if (gl === null) throw new Error("there is no WebGL 2");
    const program = Program.begin(
        gl,
        EVERYWHERE,
        `${HEAD}${(await shaderOf(paintName, "studio")).glsl}
vec3 nacreRadiance(vec3 wo) { return wo; }
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
    );
    while (!program.ready()) await new Promise(requestAnimationFrame);
    program.use();
    gl.bindFramebuffer(gl.FRAMEBUFFER, gl.createFramebuffer());
    const attachments = [gl.COLOR_ATTACHMENT0, gl.COLOR_ATTACHMENT1];
    for (const attachment of attachments) {
        const texture = gl.createTexture();
        gl.bindTexture(gl.TEXTURE_2D, texture);
        gl.texStorage2D(gl.TEXTURE_2D, 1, gl.RGBA32UI, 1, 1);
        gl.framebufferTexture2D(gl.FRAMEBUFFER, attachment, gl.TEXTURE_2D, texture, 0);
    }
    gl.drawBuffers(attachments);
    gl.viewport(0, 0, 1, 1);
    const digits = (...bits: number[]) =>
        bits.map((part) => part.toString(16).padStart(8, "0")).join("");
    return cases.map(({ level, side, u, v, n }) => {
        const part = (k: number) => parseInt(level.slice(12 - 4 * k, 16 - 4 * k), 16);
        gl.uniform4i(program.at("level"), part(0), part(1), part(2), part(3));
        gl.uniform4i(program.at("at"), side, u, v, n);
        gl.drawArrays(gl.TRIANGLES, 0, 3);
        const [a, b] = attachments.map((attachment) => {
            const out = new Uint32Array(4);
            gl.readBuffer(attachment);
            gl.readPixels(0, 0, 1, 1, gl.RGBA_INTEGER, gl.UNSIGNED_INT, out);
            return out;
        }) as [Uint32Array, Uint32Array];
        const [low = 0, high = 0, place = 0, kind = 0] = a;
        return [digits(high, low), digits(place), digits(kind), digits(b[1] ?? 0, b[0] ?? 0)];
    });
}

declare global {
    interface Window {
        live: typeof live;
        traced: typeof traced;
        hashes: typeof hashes;
    }
}
window.live = live;
window.hashes = hashes;
window.traced = traced;
