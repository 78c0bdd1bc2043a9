/**
 * One request under way at most, and of those that wait only the newest: nothing queues, however fast a
 * slider is moved.
 */
export class Latest<T> {
    private underWay: T | null = null;
    private waiting: T | null = null;

    /** @param send  starts a request; finished() is called when it has been answered */
    constructor(private readonly send: (request: T) => void) {}

    get busy(): boolean {
        return this.underWay !== null;
    }

    want(request: T): void {
        if (this.underWay !== null) {
            this.waiting = request;
            return;
        }
        this.underWay = request;
        this.send(request);
    }

    finished(): void {
        const next = this.waiting;
        this.underWay = this.waiting = null;
        if (next !== null) this.want(next);
    }

    /** The connection broke: what was under way will not be answered. @return the newest request */
    abandon(): T | null {
        const newest = this.waiting ?? this.underWay;
        this.underWay = this.waiting = null;
        return newest;
    }
}
