/** How much is drawn in a frame, by the time that the last frames took. */

/**
 * As long as drawing may take in a frame without the page becoming slow, unless the least that it shows takes
 * longer: of one that holds the whole picture, of the one that follows a move, and of one that adds a part of a
 * sample. A card draws oftener than processors for less: what is new then waits for less, chips too. Processors
 * compute the next paint as well, whose move waits for the end of the frame under way.
 */
const BY_CARD = { frame_ms: 12, moving_ms: 6, strip_ms: 12 };
const BY_PROCESSOR = { frame_ms: 30, moving_ms: 12, strip_ms: 12 };
/** Who has drawn a frame in less is a card, or as fast as one. */
const CARD_MS = 15;
/** Samples of pixels that are worth a frame on any machine. */
const LEAST_WORK = 4096;
/**
 * Where a frame does not hold the whole picture what is new is drawn once, and not refined before so long:
 * the next move may be on its way.
 */
export const REST_MS = 200;
/** Between looks whether a frame has been drawn. */
const POLL_MS = 2;
/** What a frame that is not shown takes whatever is drawn: browsers make timers that follow each other wait for 4 ms. */
const UNSEEN_MS = 4;

/**
 * Calls back when the graphics processor has drawn what it was told.
 * @return false: never, as the context is lost
 */
export function whenDrawn(gl: WebGL2RenderingContext, then: () => void): boolean {
    const sync = gl.fenceSync(gl.SYNC_GPU_COMMANDS_COMPLETE, 0);
    gl.flush();
    if (sync === null) return false;
    const look = () => {
        // Oftener than the screen shows a picture: a millisecond would count as seventeen.
        if (gl.clientWaitSync(sync, 0, 0) === gl.TIMEOUT_EXPIRED) {
            setTimeout(look, POLL_MS);
            return;
        }
        gl.deleteSync(sync);
        then();
    };
    setTimeout(look, POLL_MS);
    return true;
}

/** Samples of pixels that a frame has time for. */
export interface Budgets {
    readonly budget: number;
    /** In the frame that follows a move. */
    readonly moving: number;
    /** In one that adds to a picture that is there. */
    readonly strip: number;
}

export class Pace {
    /** The last frame's, from when it was begun until the graphics processor had drawn it. */
    frame_ms = 0;
    /** Samples of pixels per millisecond of drawing. */
    private speed = 2000;
    /** What a frame that is shown takes whatever is drawn: the shortest yet. */
    private overhead_ms = 16;

    get budgets(): Budgets {
        const by = this.overhead_ms < CARD_MS ? BY_CARD : BY_PROCESSOR;
        return {
            budget: Math.max(by.frame_ms * this.speed, LEAST_WORK),
            moving: by.moving_ms * this.speed,
            strip: Math.max(by.strip_ms * this.speed, LEAST_WORK),
        };
    }

    /**
     * @param work   samples of pixels of the frame that was drawn
     * @param shown  whether it was for the screen as well
     */
    drawn(frame_ms: number, work: number, shown: boolean): void {
        this.frame_ms = frame_ms;
        if (shown) this.overhead_ms = Math.min(this.overhead_ms, frame_ms);
        const drawing_ms = Math.max(frame_ms - (shown ? this.overhead_ms : UNSEEN_MS), 1);
        // Rows of background take next to nothing: those that follow must not come all at once.
        const speed = Math.min(work / drawing_ms, 1.5 * this.speed);
        this.speed = 0.5 * (this.speed + speed);
    }
}
