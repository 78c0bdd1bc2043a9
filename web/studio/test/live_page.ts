/** Runs in a page of the studio, beside it: draws its own live picture from what the server says. */

import { LiveView } from "../src/renderer/live_view";
import { readLight, readMesh, readPaint } from "../src/renderer/paint";
import type { Transform } from "../src/renderer/paint";
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

const SCENE = { shape: "ball", light: "studio" };

/** The live picture of a paint on the ball. */
async function live(paintName: string, size: number, samples: number): Promise<LivePicture> {
    const shape = (await schema()).shapes.find(({ name }) => name === SCENE.shape);
    if (shape === undefined) throw new Error("there is no ball");
    const fields = { type: "paint", recipe: await recipeOf(paintName), shader: true };
    const paint = readPaint(...(await asked(fields, "shader")), new Map());
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
        void Promise.all([api("shape/ball"), api("light/studio?width=1024")])
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
async function traced(paintName: string, size: number, samples: number): Promise<LivePicture> {
    const fields = {
        type: "render",
        recipe: await recipeOf(paintName),
        scene: { ...SCENE, camera: null, turn_deg: 0, light_turn_deg: 0 },
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

declare global {
    interface Window {
        live: typeof live;
        traced: typeof traced;
    }
}
window.live = live;
window.traced = traced;
