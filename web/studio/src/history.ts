/** Undo and redo as lists of values. */

/** More steps back than anybody remembers. */
const MOST = 500;

export class History<T> {
    private past: T[] = [];
    private future: T[] = [];
    private gesture: string | null = null;

    constructor(private present: T) {}

    get now(): T {
        return this.present;
    }
    get canUndo(): boolean {
        return this.past.length > 0;
    }
    get canRedo(): boolean {
        return this.future.length > 0;
    }

    /**
     * The next value. Changes in a row with one gesture, as one drag of one slider, are one step back.
     * @param gesture  null: a step of its own
     */
    push(value: T, gesture: string | null = null): void {
        if (value === this.present) return;
        if (gesture === null || gesture !== this.gesture) {
            this.past.push(this.present);
            if (this.past.length > MOST) this.past.shift();
        }
        this.gesture = gesture;
        this.present = value;
        this.future = [];
    }

    /** The first value that there is, before which nothing is to be had back. */
    begin(value: T): void {
        this.past = [];
        this.future = [];
        this.gesture = null;
        this.present = value;
    }

    /** The next change is a step of its own, even with the same gesture. */
    endGesture(): void {
        this.gesture = null;
    }

    undo(): T {
        const before = this.past.pop();
        if (before !== undefined) {
            this.future.push(this.present);
            this.present = before;
        }
        this.gesture = null;
        return this.present;
    }

    redo(): T {
        const after = this.future.pop();
        if (after !== undefined) {
            this.past.push(this.present);
            this.present = after;
        }
        this.gesture = null;
        return this.present;
    }
}
