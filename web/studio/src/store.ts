/** One value that changes, and those who want to know. */

import { useEffect, useReducer, useRef } from "preact/hooks";

export class Store<T extends object> {
    private readonly listeners = new Set<() => void>();

    constructor(private value: T) {}

    get(): T {
        return this.value;
    }

    set(change: Partial<T>): void {
        this.value = { ...this.value, ...change };
        for (const listener of [...this.listeners]) listener();
    }

    subscribe(listener: () => void): () => void {
        this.listeners.add(listener);
        return () => {
            this.listeners.delete(listener);
        };
    }
}

/** A part of the store's value; the component is drawn anew when it is another one. */
export function useStore<T extends object, U>(store: Store<T>, part: (value: T) => U): U {
    const [, redraw] = useReducer<number, undefined>((n) => n + 1, 0);
    const now = part(store.get());
    const newest = useRef(part);
    newest.current = part;
    useEffect(() => {
        let last = now;
        const look = () => {
            const next = newest.current(store.get());
            if (Object.is(next, last)) return;
            last = next;
            redraw(undefined);
        };
        look(); // what changed between drawing and here
        return store.subscribe(look);
    }, [store, now]);
    return now;
}
