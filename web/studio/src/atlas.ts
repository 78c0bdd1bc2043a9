/** Colours by the values of one number, asked for while somebody looks at them. */

import type { AtlasMessage } from "./protocol";
import { niceAbove } from "./slider";
import type { Scale } from "./slider";
import type { KeyInfo } from "./schema";
import { allows } from "./schema";
import type { Session } from "./session";
import type { Settings } from "./state";
import { Store } from "./store";
import type { Path, Table } from "./tree";
import { pathText, set } from "./tree";

export interface AtlasState {
    readonly atlas: AtlasMessage | null;
    readonly busy: boolean;
    /** Of what is asked for, how much has been made. */
    readonly fraction: number;
    readonly fault: string | null;
}

/** Columns: enough that neighbours differ little, few enough to come in about a second. */
const MOST_VALUES = 60;
/** Every so many of them come first, to be seen meanwhile. */
const COARSE = 5;
/** How long sliders rest before they are asked for: colours of the paint itself come first. */
const REST_MS = 250;

/** Round numbers from end to end that the key allows. */
export function atlasValues(info: KeyInfo, { low, high }: Pick<Scale, "low" | "high">): number[] {
    if (!(high > low)) return [];
    const step = niceAbove((high - low) / MOST_VALUES);
    const values: number[] = [];
    for (let i = Math.ceil(low / step - 1e-9); i * step <= high + 1e-9 * step; ++i) {
        const value = Number((i * step).toPrecision(12));
        if (allows(info, value)) values.push(value);
    }
    return values;
}

export class Atlas {
    readonly store = new Store<AtlasState>({ atlas: null, busy: false, fraction: 0, fault: null });
    private wanted = "";
    private underWay: number | null = null;
    private timer: ReturnType<typeof setTimeout> | undefined;

    /** @param onBusy  told when it begins and ends to keep the server busy */
    constructor(
        private readonly session: Session,
        private readonly onBusy: (busy: boolean) => void,
    ) {}

    /** The paint with each of these in the place of what it has; what it has does not matter. */
    want(recipe: Table, path: Path, values: readonly number[], settings: Settings): void {
        const { geometries, illuminant, observer, model } = settings;
        const fields = {
            recipe: set(recipe, path, values[0]),
            key: pathText(path),
            values,
            geometries,
            illuminant,
            observer,
            model,
        };
        const wanted = JSON.stringify(fields);
        if (wanted === this.wanted || values.length === 0) return;
        this.stop();
        this.wanted = wanted;
        this.setBusy(true);
        const last = values.length - 1;
        const coarse = values.filter((_, i) => i % COARSE === 0 || i === last);
        this.timer = setTimeout(() => {
            this.ask({ ...fields, values: coarse }, () => {
                this.ask(fields, () => {
                    this.setBusy(false);
                });
            });
        }, REST_MS);
    }

    /** Nobody looks any more. */
    stop(): void {
        clearTimeout(this.timer);
        if (this.store.get().busy) this.wanted = "";
        if (this.underWay !== null) {
            this.session.tell("stop", { what: "atlas" });
            this.session.forget(this.underWay);
            this.underWay = null;
        }
        this.setBusy(false);
    }

    private setBusy(busy: boolean): void {
        if (busy === this.store.get().busy) return;
        this.store.set({ busy, fraction: 0 });
        this.onBusy(busy);
    }

    private ask(fields: Readonly<Record<string, unknown>>, then: () => void): void {
        if (!this.session.isOpen) {
            this.stop();
            return;
        }
        const id = this.session.send("atlas", fields, (message) => {
            if (message.type === "progress") {
                this.store.set({ fraction: Number(message.fraction) });
                return;
            }
            this.session.forget(id);
            this.underWay = null;
            if (message.type === "error") {
                this.store.set({ fault: String(message.message) });
                this.setBusy(false);
                return;
            }
            this.store.set({ fault: null, atlas: message as unknown as AtlasMessage });
            then();
        });
        this.underWay = id;
    }
}
