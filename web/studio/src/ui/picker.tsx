/** A list to choose from by name, each with its colour: a button, and a listbox that it opens. */

import type { VNode } from "preact";
import { useEffect, useId, useLayoutEffect, useRef, useState } from "preact/hooks";
import type { Rgb } from "../schema";

export interface Choice {
    readonly name: string;
    /** For people; the name where there is none. */
    readonly title?: string;
    readonly summary?: string;
    readonly rgb?: Rgb | null;
}

export function cssOf(rgb: Rgb): string {
    const byte = (x: number) => String(Math.round(255 * Math.min(Math.max(x, 0), 1)));
    return `rgb(${rgb.map(byte).join(", ")})`;
}

export function Swatch({ rgb }: { readonly rgb: Rgb | null | undefined }): VNode | null {
    if (rgb === undefined) return null;
    if (rgb === null) return <i class="swatch none" />;
    return <i class="swatch" style={{ background: cssOf(rgb) }} />;
}

/** Between a list and its button, and at least to the window's edge, in pixels. */
const GAP = 2;
const MARGIN = 8;
const MOST_HEIGHT = 380;

/** Where a list has room: what scrolls around the button does not cut it off. */
function place(list: HTMLElement, button: HTMLElement): void {
    const { top, bottom, left, width } = button.getBoundingClientRect();
    const below = innerHeight - bottom - GAP - MARGIN;
    const above = top - GAP - MARGIN;
    const wanted = Math.min(MOST_HEIGHT, list.scrollHeight);
    const up = below < wanted && above > below;
    const { style } = list;
    style.minWidth = `${String(width)}px`;
    style.maxHeight = `${String(Math.min(MOST_HEIGHT, up ? above : below))}px`;
    style.left = `${String(Math.max(MARGIN, Math.min(left, innerWidth - list.offsetWidth - MARGIN)))}px`;
    style.top = up ? "auto" : `${String(bottom + GAP)}px`;
    style.bottom = up ? `${String(innerHeight - top + GAP)}px` : "auto";
}

/** How long typed letters count as one word. */
const WORD_MS = 800;

export function Picker(props: {
    readonly label: string;
    readonly choices: readonly Choice[];
    /** The name chosen; null where the button is for an action. */
    readonly chosen: string | null;
    /** On the button, in place of what is chosen. */
    readonly text?: string;
    readonly disabled?: boolean;
    readonly class?: string;
    readonly onChoose: (name: string) => void;
}): VNode {
    const { choices, chosen, onChoose } = props;
    const [open, setOpen] = useState(false);
    const [active, setActive] = useState(0);
    const id = useId();
    const root = useRef<HTMLDivElement>(null);
    const button = useRef<HTMLButtonElement>(null);
    const list = useRef<HTMLUListElement>(null);
    const word = useRef({ text: "", at: 0 });
    const now = choices.find(({ name }) => name === chosen);

    // At once, so that keys that follow are the list's.
    useLayoutEffect(() => {
        if (!open || list.current === null || button.current === null) return;
        const [its, from] = [list.current, button.current];
        place(its, from);
        its.focus({ preventScroll: true });
        const outside = (event: PointerEvent) => {
            if (root.current?.contains(event.target as Node) !== true) setOpen(false);
        };
        // Followed, not closed: the last of a scroll may arrive after the click that opened the list.
        const moved = (event: Event) => {
            if (event.target !== its) place(its, from);
        };
        const gone = new IntersectionObserver(([button]) => {
            if (button?.isIntersecting === false) setOpen(false);
        });
        gone.observe(from);
        document.addEventListener("pointerdown", outside);
        document.addEventListener("scroll", moved, true);
        addEventListener("resize", moved);
        return () => {
            gone.disconnect();
            document.removeEventListener("pointerdown", outside);
            document.removeEventListener("scroll", moved, true);
            removeEventListener("resize", moved);
        };
    }, [open]);
    useEffect(() => {
        if (open) list.current?.children[active]?.scrollIntoView({ block: "nearest" });
    }, [open, active]);

    const show = () => {
        setActive(
            Math.max(
                0,
                choices.findIndex(({ name }) => name === chosen),
            ),
        );
        setOpen(true);
    };
    const close = () => {
        setOpen(false);
        button.current?.focus();
    };
    const choose = (i: number) => {
        const choice = choices[i];
        close();
        if (choice !== undefined) onChoose(choice.name);
    };
    const find = (key: string) => {
        const time = Date.now();
        const fresh = time - word.current.at > WORD_MS;
        word.current = { text: (fresh ? "" : word.current.text) + key.toLowerCase(), at: time };
        const from = fresh ? active + 1 : active;
        const order = [...choices.keys()].map((i) => (i + from) % choices.length);
        const found = order.find((i) => {
            const { title, name } = choices[i] as Choice;
            return (title ?? name).toLowerCase().startsWith(word.current.text);
        });
        if (found !== undefined) setActive(found);
    };
    const keys = (event: KeyboardEvent) => {
        const last = choices.length - 1;
        if (event.key === "ArrowDown") setActive(Math.min(active + 1, last));
        else if (event.key === "ArrowUp") setActive(Math.max(active - 1, 0));
        else if (event.key === "Home") setActive(0);
        else if (event.key === "End") setActive(last);
        else if (event.key === "Enter" || event.key === " ") choose(active);
        else if (event.key === "Escape") close();
        else if (event.key === "Tab") setOpen(false);
        else if (event.key.length === 1 && !event.ctrlKey && !event.metaKey) find(event.key);
        else return;
        if (event.key !== "Tab") event.preventDefault();
        event.stopPropagation();
    };

    return (
        <div class={`picker ${props.class ?? ""}`} ref={root}>
            <button
                type="button"
                ref={button}
                class="picked"
                aria-label={now === undefined ? props.label : `${props.label}: ${now.name}`}
                aria-haspopup="listbox"
                aria-expanded={open}
                disabled={props.disabled ?? false}
                onClick={() => {
                    if (open) setOpen(false);
                    else show();
                }}
                onKeyDown={(event) => {
                    if (event.key === "ArrowDown" || event.key === "ArrowUp") {
                        event.preventDefault();
                        show();
                    }
                }}
            >
                {props.text === undefined && <Swatch rgb={now?.rgb} />}
                <span>{props.text ?? now?.title ?? now?.name ?? chosen ?? ""}</span>
            </button>
            {open && (
                <ul
                    ref={list}
                    class="choices"
                    role="listbox"
                    tabIndex={-1}
                    aria-label={props.label}
                    aria-activedescendant={`${id}-${String(active)}`}
                    onKeyDown={keys}
                >
                    {choices.map((choice, i) => (
                        <li
                            key={choice.name}
                            id={`${id}-${String(i)}`}
                            role="option"
                            aria-selected={choice.name === chosen}
                            class={i === active ? "active" : ""}
                            onPointerMove={() => {
                                setActive(i);
                            }}
                            onClick={() => {
                                choose(i);
                            }}
                        >
                            <Swatch rgb={choice.rgb} />
                            <span>
                                {choice.title ?? choice.name}
                                {choice.summary !== undefined && <small>{choice.summary}</small>}
                            </span>
                        </li>
                    ))}
                </ul>
            )}
        </div>
    );
}
