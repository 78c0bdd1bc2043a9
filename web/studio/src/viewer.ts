/** The pictures: of the paint as it is now (B) and of the one that was kept (A). */

import { Live, Received } from "./live";
import type { Orbit } from "./orbit";
import { fitted, orbitOf } from "./orbit";
import type { Attachment, Message } from "./protocol";
import type { Schema } from "./schema";
import type { Session } from "./session";
import type { Light, Mesh } from "./renderer/paint";
import { Store } from "./store";
import type { Table } from "./tree";

export interface View {
    readonly shape: string;
    readonly light: string;
    readonly camera: Orbit;
    /** Of the shape about the vertical. */
    readonly turn_deg: number;
    readonly light_turn_deg: number;
    /** Whether single flakes are seen, or their mean. */
    readonly sparkle: boolean;
}

export interface Picture {
    readonly width: number;
    readonly height: number;
    /** sRGB and an opaque alpha, row by row from the top. */
    readonly pixels: Uint8ClampedArray;
    readonly samples: number;
    readonly of: number;
    readonly recipe: Table;
    readonly view: View;
    /** Of the place for it, when it was asked for. */
    readonly place: Size;
}

/** In pixels of the screen; another object each time that it changes. */
interface Size {
    readonly width: number;
    readonly height: number;
}

export interface ViewerState {
    readonly view: View | null;
    readonly picture: Picture | null;
    /** The paint that B is held against, and its picture. */
    readonly keptRecipe: Table | null;
    readonly kept: Picture | null;
    readonly fault: string | null;
    /** The recipe that is drawn. */
    readonly recipe: Table | null;
    /** Of the live picture; null: there is none. */
    readonly liveSamples: number | null;
    /** Why the browser draws none. */
    readonly noLive: string | null;
    readonly gamutWarning: boolean;
    /** Samples a pixel from which on the path tracer's picture hides the live one. */
    readonly enough: number;
}

/** Whether the path tracer's picture is of the paint and the view that are asked for. */
export function isCurrent({ picture, recipe, view }: ViewerState): boolean {
    return picture !== null && picture.recipe === recipe && picture.view === view;
}

/** Whether it hides the live picture, which alone can mark colours. */
export function covers(state: ViewerState): boolean {
    const { picture, liveSamples } = state;
    if (picture === null || liveSamples === null) return picture !== null;
    return !state.gamutWarning && isCurrent(state) && picture.samples >= state.enough;
}

/** Whether what is shown as A is of another view than B, or of another paint. */
export function isKeptBehind({ kept, keptRecipe, view }: ViewerState): boolean {
    return keptRecipe !== null && (kept?.view !== view || kept.recipe !== keptRecipe);
}

/** Whether there is an A, of which there is but another view, a draft or a live picture. */
function lacksA(state: ViewerState): boolean {
    const samples = state.kept?.samples ?? 0;
    return state.keptRecipe !== null && (isKeptBehind(state) || samples < KEPT_SAMPLES);
}

/** What A's picture is: "live", "draft" or its samples, and of how many where others follow. */
export function keptText({ kept }: ViewerState): string {
    if (kept === null || kept.of === 0) return "live";
    if (kept.of === 1) return "draft";
    const { samples, of } = kept;
    return samples < of ? `${String(samples)} of ${String(of)}` : String(samples);
}

/** Whether one shows what another does, with more samples. */
function isBetter(one: Picture | null, other: Picture): boolean {
    const alike =
        one?.recipe === other.recipe && one.view === other.view && one.place === other.place;
    return alike && one.samples > other.samples;
}

/** What pictures wait for. */
export type Holder = "colours" | "atlas" | "shape" | "light";

interface Job {
    readonly recipe: Table;
    readonly view: View;
    readonly place: Size;
    readonly kept: boolean;
    readonly quick: boolean;
}

/** How long a slider rests before the whole picture is begun. */
const REST_MS = 300;
/** Samples of a pixel of the whole picture; a quick one has 1, and a third of the width. */
const SAMPLES = 64;
const KEPT_SAMPLES = 16;
const QUICK_PART = 3;
const MOST_PIXELS = 700_000;
/** Samples from which on the path tracer's picture is less noisy than it is worth. */
const ENOUGH = 16;

export class Viewer {
    readonly store = new Store<ViewerState>({
        view: null,
        picture: null,
        keptRecipe: null,
        kept: null,
        fault: null,
        recipe: null,
        liveSamples: null,
        noLive: null,
        gamutWarning: false,
        enough: ENOUGH,
    });
    private live: Live | null = null;
    /** Of the numbers that it was given last. */
    private liveRecipe: Table | null = null;
    private readonly received = new Received();
    private size: Size = { width: 0, height: 0 };
    private meanModel = "";
    /** Lights of lamps whose spectra have lines, which few samples do not meet evenly: greys have a tint. */
    private readonly withLines = new Set<string>();
    private underWay: { id: number; job: Job } | null = null;
    private quickWanted = false;
    private timer: ReturnType<typeof setTimeout> | undefined;
    private readonly holders = new Set<Holder>();
    /** A picture is to be begun when it may be. */
    private postponed = false;

    constructor(private readonly session: Session) {}

    /**
     * Pictures leave the processors to what somebody waits for: the path tracer's stops, and while
     * colours are computed the live one is not refined.
     * @param holder  each ends its own wait
     */
    hold(holder: Holder, held: boolean): void {
        if (held) this.holders.add(holder);
        else this.holders.delete(holder);
        this.live?.hold(this.holders.has("colours"));
        if (held) {
            const job = this.underWay?.job;
            if (job !== undefined && (!job.quick || job.kept)) this.postponed = this.stop();
        } else if (this.holders.size === 0 && this.postponed) this.startLater();
    }

    /** A mesh or a light that the reader brought along, as the server named it. */
    add(schema: Schema, own: { readonly mesh?: Mesh; readonly light?: Light }, name: string): void {
        this.received.add(own, name);
        this.live?.setSchema(schema);
    }

    /** Of the place for the picture, in pixels of the screen. */
    resize(width: number, height: number): void {
        if (width === this.size.width && height === this.size.height) return;
        this.size = { width, height };
        // The path tracer's is of another size; where there is no other it stays meanwhile.
        if (this.store.get().liveSamples !== null) this.store.set({ picture: null });
        this.refresh();
    }

    begin(schema: Schema): void {
        this.meanModel = schema.mean_model;
        for (const { name, illuminant } of schema.lights) {
            if (illuminant.startsWith("FL")) this.withLines.add(name);
        }
        if (this.store.get().view !== null) return;
        const shape = schema.shapes.find(({ name }) => name === "ball") ?? schema.shapes[0];
        if (shape !== undefined) this.setShape(schema, shape.name, true);
    }

    /** @param withLight  take the light that suits it */
    setShape(schema: Schema, name: string, withLight: boolean): void {
        const shape = schema.shapes.find((info) => info.name === name);
        if (shape === undefined) return;
        const { view } = this.store.get();
        this.store.set({
            view: {
                shape: name,
                light: view === null || withLight ? shape.light : view.light,
                camera: orbitOf(shape),
                turn_deg: 0,
                light_turn_deg: view?.light_turn_deg ?? 0,
                sparkle: view?.sparkle ?? true,
            },
        });
        this.refresh();
    }

    setView(change: Partial<View>): void {
        const { view } = this.store.get();
        if (view === null) return;
        this.store.set({ view: { ...view, ...change } });
        this.refresh();
    }

    /** Colours of this recipe are known: it can be drawn. */
    paint(recipe: Table): void {
        if (recipe === this.store.get().recipe) return;
        this.store.set({ recipe });
        this.refresh();
    }

    /** Draws the live picture too, where the browser can: from the next shader() on. */
    attach(
        canvas: HTMLCanvasElement,
        schema: Schema,
        bytes: (path: string) => Promise<ArrayBuffer>,
    ): void {
        const fail = (message: string) => {
            this.live = null;
            this.store.set({ liveSamples: null, noLive: message });
        };
        try {
            const changed = (liveSamples: number) => {
                if (this.store.get().liveSamples === null) return;
                this.store.set({ liveSamples });
                this.pauseWhenCovered();
            };
            const wanted = this.askForFilms.bind(this);
            this.live = new Live(canvas, schema, bytes, this.received, changed, wanted, fail);
            this.live.hold(this.holders.has("colours"));
            this.live.setGamutWarning(this.store.get().gamutWarning);
            this.store.set({ noLive: null });
            const { view } = this.store.get();
            if (view !== null) this.live.show(view, this.size.width, this.size.height);
        } catch (error) {
            fail(error instanceof Error ? error.message : String(error));
        }
    }

    get wantsShader(): boolean {
        return this.live !== null;
    }

    /** Numbers for the live picture of a recipe. */
    shader(recipe: Table, message: Message, attachments: readonly Attachment[]): void {
        this.liveRecipe = recipe;
        this.live?.pause(false);
        const can = this.live?.setPaint(message, attachments) === true;
        this.store.set({ liveSamples: can ? 0 : null });
    }

    /** What tells its single flakes apart, unless another paint comes first. */
    private askForFilms(): void {
        const recipe = this.liveRecipe;
        if (!this.session.isOpen) return; // the paint is asked for again
        const id = this.session.send("films", { recipe }, (message, attachments) => {
            this.session.forget(id);
            if (recipe === this.liveRecipe) this.live?.setFilms(message, attachments);
        });
    }

    setGamutWarning(gamutWarning: boolean): void {
        this.store.set({ gamutWarning });
        this.live?.setGamutWarning(gamutWarning);
        if (gamutWarning) this.live?.pause(false);
        else this.pauseWhenCovered();
    }

    /** What is seen now is what is seen beside it from now on; again: nothing is. */
    keep(recipe: Table | null): void {
        this.store.set({ keptRecipe: recipe, kept: recipe === null ? null : this.shown(recipe) });
        this.refresh();
    }

    /** Not before it has drawn something, which is seen as soon as the view is turned. */
    private pauseWhenCovered(): void {
        const state = this.store.get();
        if (covers(state)) this.live?.pause((state.liveSamples ?? 0) > 0);
    }

    /** What is seen of B. */
    shown(recipe: Table): Picture | null {
        const state = this.store.get();
        const live = covers(state) || state.view === null ? null : this.live?.snapshot();
        if (live === null || live === undefined || state.view === null) return state.picture;
        return { ...live, recipe, view: state.view, place: this.size };
    }

    /** The connection broke: what was under way is begun again when colours have come. */
    abandon(): void {
        this.postponed ||= this.underWay !== null;
        this.underWay = null;
        this.quickWanted = false;
        clearTimeout(this.timer);
    }

    private refresh(): void {
        clearTimeout(this.timer);
        const light = this.store.get().view?.light ?? "";
        this.store.set({ enough: this.withLines.has(light) ? SAMPLES : ENOUGH });
        if (this.underWay?.job.quick === true && !this.underWay.job.kept) {
            this.quickWanted = true;
            return;
        }
        this.stop();
        this.quickWanted = this.postponed = false;
        const { view, liveSamples, recipe } = this.store.get();
        // Not to draw the paint before once more: the numbers of this one are on their way.
        if (recipe === this.liveRecipe) this.live?.pause(false);
        if (view !== null) this.live?.show(view, this.size.width, this.size.height);
        if (liveSamples === null) this.start(true, false);
        else this.startLater();
    }

    /** @return whether there was something to stop */
    private stop(): boolean {
        if (this.underWay === null) return false;
        this.session.tell("stop", { what: "render" });
        this.session.forget(this.underWay.id);
        this.underWay = null;
        return true;
    }

    private startLater(): void {
        clearTimeout(this.timer);
        this.timer = setTimeout(() => {
            this.proceed();
        }, REST_MS);
    }

    private start(quick: boolean, kept: boolean): void {
        const { view, keptRecipe, recipe: now } = this.store.get();
        const recipe = kept ? keptRecipe : now;
        const { width, height } = this.size;
        if (recipe === null || view === null || width * height === 0 || !this.session.isOpen)
            return;
        this.postponed = this.holders.size > 0 && (!quick || kept);
        if (this.postponed) return;
        const shrink =
            Math.min(1, Math.sqrt(MOST_PIXELS / (width * height))) / (quick ? QUICK_PART : 1);
        const job: Job = { recipe, view, place: this.size, kept, quick };
        const { sparkle, ...scene } = view;
        const fields = {
            recipe,
            ...(sparkle ? {} : { model: this.meanModel }),
            scene: { ...scene, camera: fitted(view.camera, width, height) },
            width: Math.max(16, Math.round(width * shrink)),
            height: Math.max(16, Math.round(height * shrink)),
            samples: quick ? 1 : kept ? KEPT_SAMPLES : SAMPLES,
        };
        const id = this.session.send("render", fields, (message, attachments) => {
            this.answered(id, job, message, attachments);
        });
        this.underWay = { id, job };
    }

    private answered(
        id: number,
        job: Job,
        message: Message,
        attachments: readonly Attachment[],
    ): void {
        if (message.type === "picture") {
            const picture = pictureOf(job, message, attachments);
            this.take(job, picture);
            if (picture.samples < picture.of) {
                if (!job.kept && this.isTimeForA) {
                    this.stop();
                    this.proceed();
                }
                return;
            }
        } else if (message.type === "error") {
            this.store.set({ fault: String(message.message) });
        } else if (message.type !== "done") return;
        if (this.underWay?.id !== id) return;
        this.session.forget(id);
        this.underWay = null;
        if (this.quickWanted) this.refresh();
        else if (job.quick && !job.kept) this.startLater();
        else if (message.type !== "error") this.proceed();
        else if (!job.kept && lacksA(this.store.get())) this.start(false, true);
    }

    /** Shows a picture, unless a better one is seen: one that was begun anew has fewer samples at first. */
    private take(job: Job, picture: Picture): void {
        const { kept, picture: shown } = this.store.get();
        if (!isBetter(job.kept ? kept : shown, picture))
            this.store.set(job.kept ? { kept: picture } : { picture });
        if (!job.kept) this.store.set({ fault: null });
        this.pauseWhenCovered();
    }

    /** The picture that is to be made next. */
    private proceed(): void {
        // A draft of A first where it is of another view: what is beside it is seen as it is now.
        if (isKeptBehind(this.store.get())) this.start(true, true);
        else if (this.isTimeForA) this.start(false, true);
        else if (this.tracedSamples < SAMPLES) this.start(false, false);
    }

    /** That the path tracer's picture has of B as it is now. */
    private get tracedSamples(): number {
        const state = this.store.get();
        const { picture } = state;
        return isCurrent(state) && picture?.place === this.size ? picture.samples : 0;
    }

    /** B can be seen, and A beside it is not as good: B's other samples follow A's. */
    private get isTimeForA(): boolean {
        const state = this.store.get();
        return this.tracedSamples >= state.enough && lacksA(state);
    }
}

function pictureOf(job: Job, message: Message, attachments: readonly Attachment[]): Picture {
    const rgb = attachments.find(({ name }) => name === "rgb");
    const [height, width] = rgb?.shape ?? [];
    if (rgb === undefined || height === undefined || width === undefined) {
        throw new Error("a picture came without its pixels");
    }
    const bytes = rgb.data as Uint8Array;
    const pixels = new Uint8ClampedArray(width * height * 4);
    for (let i = 0, from = 0; i < pixels.length; i += 4, from += 3) {
        pixels[i] = bytes[from] as number;
        pixels[i + 1] = bytes[from + 1] as number;
        pixels[i + 2] = bytes[from + 2] as number;
        pixels[i + 3] = 255;
    }
    return {
        width,
        height,
        pixels,
        samples: Number(message.samples),
        of: Number(message.of),
        recipe: job.recipe,
        view: job.view,
        place: job.place,
    };
}
