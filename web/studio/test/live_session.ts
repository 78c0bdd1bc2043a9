/** What a page of the tests asks the studio's server for. */

import type { Attachment, Message } from "../src/protocol";
import { readFilms, readPaint, withFilms } from "../src/renderer/paint";
import type { PaintShader } from "../src/renderer/paint";
import type { Schema } from "../src/schema";
import { unpack } from "../src/session";
import { get, set } from "../src/tree";
import type { Path, Table } from "../src/tree";

/** The answer of a type to one message, with its arrays; errors are thrown. */
export function asked(fields: object, type: string): Promise<[Message, Attachment[]]> {
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

export async function api(path: string): Promise<Response> {
    const token = new URLSearchParams(location.search).get("token") ?? "";
    return fetch(`/api/${path}${path.includes("?") ? "&" : "?"}token=${token}`);
}

export const schema = async () => (await (await api("schema")).json()) as Schema;

/** The tree of a paint that ships; of "flat NAME" with flakes that lie as its pieces do and are not wavy. */
export async function recipeOf(name: string): Promise<Table> {
    const shipped = name.replace(/^flat /, "");
    const paint = (await schema()).paints.find((known) => known.name === shipped);
    if (paint === undefined) throw new Error(`there is no paint ${shipped}`);
    const [opened] = await asked({ type: "open", toml: paint.toml }, "recipe");
    const tree = opened.tree as Table;
    if (shipped === name) return tree;
    const flakes: Path = ["layer", 0, "flakes", 0];
    const alpha: Path = [...flakes, "orientation", "alpha"];
    const slopes = Math.hypot(
        get(tree, alpha) as number,
        get(tree, [...flakes, "waviness"]) as number,
    );
    return set(set(tree, alpha, slopes), [...flakes, "waviness"], undefined);
}

/** @param change  of the paint's recipe, before it is asked for */
export async function shaderOf(
    paintName: string,
    light: string,
    change: (recipe: Table) => Table = (recipe) => recipe,
): Promise<PaintShader> {
    const lamp = (await schema()).lights.find(({ name }) => name === light)?.illuminant;
    const recipe = change(await recipeOf(paintName));
    const fields = { type: "paint", recipe, shader: true, lamp };
    return withFilms(
        readPaint(...(await asked(fields, "shader")), new Map()),
        readFilms(...(await asked({ type: "films", recipe }, "films"))),
    );
}
