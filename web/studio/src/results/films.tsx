/** The atlas of a film: its colour by thickness and angle, to choose a thickness from. */

import type { VNode } from "preact";

export function Films(): VNode {
    return <p class="empty">…</p>;
}
