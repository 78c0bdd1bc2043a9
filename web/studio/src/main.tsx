import { render } from "preact";
import { App } from "./app";
import type { Schema } from "./schema";
import type { Socket } from "./session";
import { Studio } from "./studio";
import "./style.css";

/** Given by the program in the address that it prints. */
const token = new URLSearchParams(location.search).get("token") ?? "";
const query = `?token=${encodeURIComponent(token)}`;

async function answer(path: string): Promise<Response> {
    const response = await fetch(path, { headers: { "X-Nacre-Token": token } });
    if (!response.ok) throw new Error(`${String(response.status)} ${response.statusText}: ${path}`);
    return response;
}

const studio = new Studio({
    connect: () => {
        const scheme = location.protocol === "https:" ? "wss:" : "ws:";
        return new WebSocket(`${scheme}//${location.host}/api/session${query}`) as Socket;
    },
    schema: async () => (await (await answer("/api/schema")).json()) as Schema,
    bytes: async (path) => (await answer(path)).arrayBuffer(),
    refused: async () => {
        try {
            const headers = { "X-Nacre-Token": token };
            const { status } = await fetch("/api/schema", { method: "HEAD", headers });
            return status === 401;
        } catch {
            return false; // nothing answers
        }
    },
    now: () => performance.now(),
    drawn: (then) => {
        // After the next drawing: a task that a frame starts runs when the frame is on its way.
        requestAnimationFrame(() => {
            setTimeout(then);
        });
    },
    fragment: () => location.hash,
    setFragment: (fragment) => {
        history.replaceState(null, "", fragment);
    },
    address: () => location.href,
});

render(<App studio={studio} />, document.body);
