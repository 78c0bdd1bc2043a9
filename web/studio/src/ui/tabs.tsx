/** Panels of which one shows, by the keyboard as ARIA's authoring practices have it. */

import type { ComponentChildren, VNode } from "preact";
import { useRef } from "preact/hooks";

export interface Tab {
    readonly name: string;
    readonly title: string;
    readonly panel: () => ComponentChildren;
}

export function Tabs(props: {
    readonly label: string;
    readonly tabs: readonly Tab[];
    readonly chosen: string;
    readonly onChoose: (name: string) => void;
}): VNode {
    const { tabs, chosen, onChoose } = props;
    const list = useRef<HTMLDivElement>(null);
    const at = tabs.findIndex(({ name }) => name === chosen);
    const keys = (event: KeyboardEvent) => {
        const to =
            event.key === "ArrowRight"
                ? (at + 1) % tabs.length
                : event.key === "ArrowLeft"
                  ? (at + tabs.length - 1) % tabs.length
                  : event.key === "Home"
                    ? 0
                    : event.key === "End"
                      ? tabs.length - 1
                      : null;
        const tab = to === null ? undefined : tabs[to];
        if (to === null || tab === undefined) return;
        event.preventDefault();
        onChoose(tab.name);
        (list.current?.children[to] as HTMLElement | undefined)?.focus();
    };
    return (
        <section class="tabs" aria-label={props.label}>
            <div role="tablist" aria-label={props.label} ref={list} onKeyDown={keys}>
                {tabs.map(({ name, title }) => (
                    <button
                        key={name}
                        type="button"
                        role="tab"
                        id={`tab-${name}`}
                        aria-selected={name === chosen}
                        aria-controls={`panel-${name}`}
                        tabIndex={name === chosen ? 0 : -1}
                        onClick={() => {
                            onChoose(name);
                        }}
                    >
                        {title}
                    </button>
                ))}
            </div>
            {tabs
                .filter(({ name }) => name === chosen)
                .map(({ name, panel }) => (
                    <div
                        key={name}
                        role="tabpanel"
                        id={`panel-${name}`}
                        aria-labelledby={`tab-${name}`}
                        tabIndex={0}
                    >
                        {panel()}
                    </div>
                ))}
        </section>
    );
}
