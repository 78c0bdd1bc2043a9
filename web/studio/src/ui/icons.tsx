/** Small pictures for buttons, each with a name for those who do not see it. */

import type { VNode } from "preact";

const PATHS = {
    up: "M8 13V3M3.5 7.5 8 3l4.5 4.5",
    down: "M8 3v10M3.5 8.5 8 13l4.5-4.5",
    remove: "m4 4 8 8m0-8-8 8",
    copy: "M5.5 5.5v-3h8v8h-3m-8-5h8v8h-8z",
    lock: "M3.5 7.5h9v6h-9zM5.5 7.5V5a2.5 2.5 0 0 1 5 0v2.5",
    unlock: "M3.5 7.5h9v6h-9zM5.5 7.5V5a2.5 2.5 0 0 1 4.6-1.4",
    open: "m5 6 3 3.5L11 6",
    closed: "m6 5 3.5 3L6 11",
    undo: "M6 3 2.5 6.5 6 10M2.5 6.5H9a4 4 0 0 1 0 8H6",
    redo: "m10 3 3.5 3.5L10 10m3.5-3.5H7a4 4 0 0 0 0 8h3",
    add: "M8 3v10M3 8h10",
} as const;

export type IconName = keyof typeof PATHS;

export function Icon({ name }: { readonly name: IconName }): VNode {
    return (
        <svg class="icon" viewBox="0 0 16 16" width="16" height="16" aria-hidden="true">
            <path d={PATHS[name]} />
        </svg>
    );
}

export function IconButton(props: {
    readonly icon: IconName;
    readonly label: string;
    readonly onClick: () => void;
    readonly disabled?: boolean;
    readonly pressed?: boolean;
}): VNode {
    return (
        <button
            type="button"
            class="icon-button"
            data-icon={props.icon}
            aria-label={props.label}
            title={props.label}
            disabled={props.disabled ?? false}
            aria-pressed={props.pressed}
            onClick={props.onClick}
        >
            <Icon name={props.icon} />
        </button>
    );
}
