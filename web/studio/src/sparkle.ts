/** Sparkle and graininess: measured when asked for, which takes seconds. */

import type { Sparkle } from "./protocol";
import type { Session } from "./session";
import type { State } from "./state";
import type { Store } from "./store";

export class SparkleMeter {
    private id: number | null = null;

    constructor(
        private readonly store: Store<State>,
        private readonly session: Session,
    ) {}

    measure(): void {
        if (!this.session.isOpen) return;
        const { document } = this.store.get();
        this.store.set({ sparkleFraction: 0 });
        this.id = this.session.send("sparkle", { recipe: document.recipe }, (message) => {
            if (message.type === "progress") {
                this.store.set({ sparkleFraction: Number(message.fraction) });
                return;
            }
            if (message.type === "error") {
                this.store.set({ sparkle: null, notice: String(message.message) });
            } else {
                const value = message as unknown as Sparkle;
                this.store.set({ sparkle: { of: document, value } });
            }
            this.abandon();
        });
    }

    stop(): void {
        if (this.id !== null) this.session.tell("stop", { what: "sparkle" });
        this.abandon();
    }

    /** It ended, or the connection broke: what is still said of it is not heard. */
    abandon(): void {
        if (this.id !== null) this.session.forget(this.id);
        this.id = null;
        this.store.set({ sparkleFraction: null });
    }
}
