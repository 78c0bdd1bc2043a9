/** From the standard back to composition: one fit at a time, by the server. */

import type { Match, Message } from "./protocol";
import { labelOf, placeText } from "./schema";
import type { Session } from "./session";
import type { State } from "./state";
import { NO_FIT } from "./state";
import type { Store } from "./store";
import type { Table } from "./tree";
import { parsePath } from "./tree";

const NO_SERVER = "There is no server to fit it; begin again when it answers.";

/** A number as the page names it: "Diameter, TiO2 on mica". */
export function numberName(recipe: Table, key: string): string {
    const path = parsePath(key);
    const { label } = labelOf(String(path.at(-1)));
    const place = placeText(recipe, path);
    return place === "" ? label : `${label}, ${place}`;
}

/** What the server says of a key, by the key's name on the page. */
function named(message: string, recipe: Table, key: string | undefined): string {
    return key === undefined ? message : message.replace(key, numberName(recipe, key));
}

export class Fitting {
    private id: number | null = null;

    /** @param onMatches  told when matches were found, whose colours are not known yet */
    constructor(
        private readonly store: Store<State>,
        private readonly session: Session,
        private readonly onMatches: () => void,
    ) {}

    begin(free: readonly string[], starts: number): void {
        const { document, settings } = this.store.get();
        const { model } = settings;
        if (!this.session.isOpen) {
            this.store.set({ fit: { ...NO_FIT, fault: NO_SERVER } });
            return;
        }
        this.store.set({ fit: { ...NO_FIT, running: true, began: document, model } });
        this.ask(document.recipe, free, starts, model);
    }

    stop(): void {
        if (this.id === null) return;
        this.session.tell("stop", { what: "fit" });
        this.forget(); // what was stopped says nothing
        this.store.set({ fit: { ...this.store.get().fit, running: false } });
    }

    /** The connection broke. */
    abandon(): void {
        this.id = null;
        const { fit } = this.store.get();
        if (!fit.running) return;
        const fault = "The server went away before the fit had ended.";
        this.store.set({ fit: { ...fit, running: false, fault } });
    }

    private ask(recipe: Table, free: readonly string[], starts: number, model: string): void {
        this.id = this.session.send("fit", { recipe, free, starts, model }, (message) => {
            const { fit } = this.store.get();
            if (message.type === "progress") {
                this.store.set({ fit: { ...fit, fraction: Number(message.fraction) } });
                return;
            }
            this.forget();
            const without = message.type === "error" ? passedOver(message, free) : null;
            if (without !== null) {
                const skipped = [...fit.skipped, numberName(recipe, String(message.key))];
                this.store.set({ fit: { ...fit, skipped } });
                this.ask(recipe, without, starts, model);
                return;
            }
            const ended = { ...fit, running: false, fraction: 1 };
            if (message.type === "matches") {
                const matches = message.matches as readonly Match[];
                this.store.set({ fit: { ...ended, matches, colours: [], fault: null } });
                this.onMatches();
            } else if (message.type === "error") {
                const key = message.key as string | undefined;
                const fault = named(String(message.message), recipe, key);
                this.store.set({ fit: { ...ended, fault } });
            }
        });
    }

    private forget(): void {
        if (this.id !== null) this.session.forget(this.id);
        this.id = null;
    }
}

/**
 * The other numbers where colours cannot tell one, as `nacre fit` passes over those of a pattern; null: it is
 * another fault, or there is no other number.
 */
function passedOver(error: Message, free: readonly string[]): readonly string[] | null {
    const others = free.filter((key) => key !== error.key);
    const untold = String(error.message).includes("does not change the colours");
    return untold && others.length > 0 && others.length < free.length ? others : null;
}
