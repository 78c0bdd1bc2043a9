/** A document in the fragment of an address: JSON, raw deflate, base64url. */

import type { Document } from "./edit";
import { isTable, isValue } from "./tree";

const PREFIX = "#paint=";
/** Of the JSON; a recipe has some kilobytes, and a bomb many. */
const MOST_BYTES = 1 << 20;

type Coder = CompressionStream | DecompressionStream;

async function through(bytes: Uint8Array, coder: Coder): Promise<Uint8Array> {
    const source = new Blob([bytes as BlobPart]).stream();
    const reader = source.pipeThrough(coder).getReader();
    const parts: Uint8Array[] = [];
    let size = 0;
    for (;;) {
        const { done, value } = await reader.read();
        if (done) break;
        size += value.length;
        if (size > MOST_BYTES) {
            await reader.cancel();
            throw new Error(`holds more than ${String(MOST_BYTES)} bytes`);
        }
        parts.push(value);
    }
    const all = new Uint8Array(size);
    let at = 0;
    for (const part of parts) {
        all.set(part, at);
        at += part.length;
    }
    return all;
}

function toBase64Url(bytes: Uint8Array): string {
    let text = "";
    for (const byte of bytes) text += String.fromCharCode(byte);
    return btoa(text).replace(/\+/g, "-").replace(/\//g, "_").replace(/=+$/, "");
}

function fromBase64Url(text: string): Uint8Array {
    const plain = atob(text.replace(/-/g, "+").replace(/_/g, "/"));
    return Uint8Array.from(plain, (character) => character.charCodeAt(0));
}

export async function toFragment({ recipe, locks }: Document): Promise<string> {
    const json = JSON.stringify(locks.size > 0 ? { recipe, locks: [...locks] } : { recipe });
    const bytes = new TextEncoder().encode(json);
    return PREFIX + toBase64Url(await through(bytes, new CompressionStream("deflate-raw")));
}

/** The fragment of a pasted link: a whole address, or what follows its # with or without it; null: no link. */
export function linkIn(text: string): string | null {
    const found = /^\s*(?:\S*#)?(paint=[\w-]+)\s*$/.exec(text)?.[1];
    return found === undefined ? null : `#${found}`;
}

/**
 * The document of an address's fragment; null where the fragment holds none.
 * @throws Error for a fragment that was cut or damaged
 */
export async function fromFragment(fragment: string): Promise<Document | null> {
    if (!fragment.startsWith(PREFIX)) return null;
    let read: unknown;
    try {
        const bytes = fromBase64Url(fragment.slice(PREFIX.length));
        const json = await through(bytes, new DecompressionStream("deflate-raw"));
        read = JSON.parse(new TextDecoder("utf-8", { fatal: true }).decode(json));
    } catch (error) {
        const why = error instanceof Error ? error.message : String(error);
        throw new Error(`The paint in this address cannot be read; was it cut? (${why})`);
    }
    const whole = (read ?? {}) as { recipe?: unknown; locks?: unknown };
    if (!isValue(whole.recipe) || !isTable(whole.recipe)) {
        throw new Error("The address holds something that is no paint.");
    }
    const locks = Array.isArray(whole.locks)
        ? whole.locks.filter((x) => typeof x === "string")
        : [];
    return { recipe: whole.recipe, locks: new Set(locks) };
}
