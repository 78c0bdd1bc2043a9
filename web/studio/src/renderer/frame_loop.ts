/** When a frame of the live picture is drawn, how much goes into it, and whether it is shown. */

import type { Budgets } from "./pace";
import { Pace, REST_MS, whenDrawn } from "./pace";

/** What a frame has added. */
export interface Drawn {
    /** Samples of pixels, as costly as such without flakes. */
    readonly work: number;
    /** Now: it ends a sample of a picture that is seen. Soon: it is a part of one, which may wait. */
    readonly seen: "now" | "soon" | "not";
}

/** What is drawn. */
export interface Drawing {
    /** Whether something is awaited that the next frame may have, as a program that is being compiled. */
    readonly awaits: boolean;
    /** Hands over what has come since the last frame. @return whether there is something new to be seen */
    takeNew(): boolean;
    /**
     * Adds to the picture.
     * @param isNew  what is there is to be shown whatever is added to it
     * @return null: there was nothing to add
     */
    draw(budgets: Budgets, isNew: boolean): Drawn | null;
    /** Puts on the screen what is there. */
    show(): void;
    failed(error: unknown): void;
}

/** Between frames that show a part of a sample: to be shown takes processors as long as to be drawn. */
const SHOWN_MS = 100;

export class FrameLoop {
    private readonly pace = new Pace();
    /** Whether a frame is being drawn. */
    private underWay = false;
    private request = 0;
    private timer: ReturnType<typeof setTimeout> | undefined;
    /** Until then what is there is not refined. */
    private restsUntil = 0;
    private isNew = false;
    /** When the last frame was shown. */
    private shownAt = 0;
    private stopped = false;
    private held = false;
    private lost = false;

    constructor(
        private readonly gl: WebGL2RenderingContext,
        private readonly drawing: Drawing,
    ) {}

    /** The last frame's, from when it was begun until the graphics processor had drawn it. */
    get frame_ms(): number {
        return this.pace.frame_ms;
    }

    /** What is there has changed, and is shown with the next frame. */
    renew(): void {
        this.isNew = true;
        this.schedule();
    }

    /** The next frame may have more to draw. */
    schedule(): void {
        if (this.request !== 0 || this.stopped || this.lost) return;
        this.request = requestAnimationFrame(() => {
            this.request = 0;
            this.attempt();
        });
    }

    /** Draws a frame in this turn, unless one is being drawn: it is waited for. */
    now(): void {
        if (this.stopped || this.lost) return;
        this.attempt();
        this.schedule();
    }

    /** What is there is a draft that follows moves: it is not refined before the next one may have come. */
    rest(): void {
        this.restsUntil = performance.now() + REST_MS;
    }

    /** Draws nothing until resume(). */
    pause(): void {
        this.stopped = true;
        cancelAnimationFrame(this.request);
        clearTimeout(this.timer);
        this.request = 0;
    }

    resume(): void {
        if (!this.stopped) return;
        this.stopped = false;
        this.renew();
    }

    /** Draws what is new once and does not refine it. */
    hold(held: boolean): void {
        if (held === this.held) return;
        this.held = held;
        if (!held) this.schedule();
    }

    /** The graphics processor is gone. */
    end(): void {
        this.lost = true;
        this.pause();
    }

    private attempt(): void {
        try {
            this.frame();
        } catch (error) {
            this.drawing.failed(error);
        }
    }

    private scheduleAt(when: number): void {
        clearTimeout(this.timer);
        this.timer = setTimeout(() => {
            this.schedule();
        }, when - performance.now());
    }

    private frame(): void {
        if (this.underWay) return; // its end schedules the next
        if (this.drawing.takeNew()) this.isNew = true;
        const begun = performance.now();
        if (!this.isNew && (this.held || begun < this.restsUntil)) {
            if (this.drawing.awaits) this.schedule();
            else if (!this.held) this.scheduleAt(this.restsUntil);
            return;
        }
        const drawn = this.drawing.draw(this.pace.budgets, this.isNew);
        const shown = this.isNew || (drawn !== null && this.shows(drawn, begun));
        if (shown) {
            this.isNew = false;
            this.shownAt = begun;
            this.drawing.show();
        }
        if (drawn !== null) this.waitUntilDrawn(begun, drawn.work, shown);
        else if (this.drawing.awaits) this.schedule();
    }

    private shows({ seen }: Drawn, now: number): boolean {
        return seen === "now" || (seen === "soon" && now - this.shownAt >= SHOWN_MS);
    }

    /** Until the graphics processor has drawn a frame, which tells how fast it is. */
    private waitUntilDrawn(begun: number, work: number, shown: boolean): void {
        this.underWay = whenDrawn(this.gl, () => {
            this.underWay = false;
            this.pace.drawn(performance.now() - begun, work, shown);
            // Of what is not shown the screen's next frame need not be waited for.
            if (shown || this.stopped || this.lost) this.schedule();
            else this.attempt();
        });
    }
}
