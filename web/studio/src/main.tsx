import { render } from "preact";
import { App } from "./app";
import type { Schema } from "./schema";
import type { Socket } from "./session";
import { Studio } from "./studio";
import "./style.css";

/** Given by the program in the address that it prints. */
const token = new URLSearchParams(location.search).get("token") ?? "";
const query = `?token=${encodeURIComponent(token)}`;

const studio = new Studio({
    connect: () => {
        const scheme = location.protocol === "https:" ? "wss:" : "ws:";
        return new WebSocket(`${scheme}//${location.host}/api/session${query}`) as Socket;
    },
    schema: async () => {
        const response = await fetch(`/api/schema${query}`);
        if (!response.ok) throw new Error(`${String(response.status)} ${response.statusText}`);
        return (await response.json()) as Schema;
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
