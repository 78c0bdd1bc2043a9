/** The picture as a file: the path tracer's, which is waited for, as the report waits for its own. */

import { fileName, pngOf, save } from "./files";
import { messageOf } from "./errors";
import type { Studio } from "./studio";
import type { Picture, ViewerState } from "./viewer";
import { isCurrent } from "./viewer";

/** With samples enough to be seen, of the paint and the view as they are now. */
function traced(state: ViewerState, recipe: unknown): Picture | null {
    const { picture, enough } = state;
    if (picture === null || !isCurrent(state) || state.recipe !== recipe) return null;
    return picture.samples >= enough ? picture : null;
}

export class PictureFile {
    /** Ends the wait for a picture. */
    private leave: (() => void) | null = null;

    constructor(private readonly studio: Studio) {}

    /** Now or when there is one. Marks are in the live picture alone, which is saved as it is. */
    save(): void {
        this.leave?.();
        this.leave = null;
        const { viewer, store } = this.studio;
        const { gamutWarning, liveSamples } = viewer.store.get();
        if (gamutWarning && liveSamples !== null) {
            const marked = viewer.shown(store.get().document.recipe);
            if (marked !== null) this.write(marked, "The live picture was saved, with its marks.");
            return;
        }
        if (this.look()) return;
        this.studio.say("Waiting for the path tracer's picture, to save it …");
        const look = () => {
            if (this.look()) this.leave?.();
        };
        const leaving = [viewer.store.subscribe(look), store.subscribe(look)];
        this.leave = () => {
            for (const end of leaving) end();
        };
    }

    /** @return whether the wait is over */
    private look(): boolean {
        const { viewer, store } = this.studio;
        const { document, fault, connection } = store.get();
        const state = viewer.store.get();
        const picture = traced(state, document.recipe);
        if (picture !== null) {
            const samples = `${String(picture.samples)} of ${String(picture.of)} samples a pixel`;
            this.write(picture, `The picture was saved, path traced, ${samples}.`);
            return true;
        }
        const why =
            fault !== null
                ? "the paint as it is now has none"
                : connection !== "open"
                  ? "there is no server to make it"
                  : state.fault;
        if (why === null) return false;
        this.studio.say(`The picture was not saved: ${why}.`);
        return true;
    }

    private write({ width, height, pixels }: Picture, said: string): void {
        const { studio } = this;
        const { name } = studio.store.get().document.recipe;
        const canvas = document.createElement("canvas");
        canvas.width = width;
        canvas.height = height;
        const image = new ImageData(pixels as Uint8ClampedArray<ArrayBuffer>, width, height);
        canvas.getContext("2d")?.putImageData(image, 0, 0);
        pngOf(canvas).then(
            (blob) => {
                save(fileName(name, "png"), blob, "image/png");
                studio.say(said);
            },
            (error: unknown) => {
                studio.say(messageOf(error));
            },
        );
    }
}
