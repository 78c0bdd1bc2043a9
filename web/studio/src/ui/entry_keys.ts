/** Names of the entries of a list that stay with them as they move and change. */

import { useRef } from "preact/hooks";
import type { Value } from "../tree";

/** By the objects that an entry has been: undo brings them back. */
export class EntryKeys {
    private readonly known = new WeakMap<object, number>();
    private before: readonly Value[] = [];
    private next = 0;

    /** @return a key for each entry: that of the same object, or of the one that it was edited from */
    of(entries: readonly Value[]): number[] {
        const same = this.before.length === entries.length;
        const kept = new Set(entries);
        const keys = entries.map((entry, i) => {
            if (typeof entry !== "object") return i;
            const old = this.before[i];
            const edited = same && typeof old === "object" && !kept.has(old);
            const key =
                this.known.get(entry) ?? (edited ? this.known.get(old) : undefined) ?? this.next++;
            this.known.set(entry, key);
            return key;
        });
        this.before = entries;
        return keys;
    }
}

export function useEntryKeys(entries: readonly Value[]): number[] {
    const keys = useRef<EntryKeys | null>(null);
    keys.current ??= new EntryKeys();
    return keys.current.of(entries);
}
