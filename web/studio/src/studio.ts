/** What the page does: edits, undo, asking the server, and keeping what it answers. */

import { Atlas } from "./atlas";
import type { Server } from "./connection";
import { Connection } from "./connection";
import type { Document } from "./edit";
import { messageOf } from "./errors";
import { Fitting } from "./fitting";
import { History } from "./history";
import { Latest } from "./latest";
import { tooLarge } from "./files";
import { fromFragment, linkIn, toFragment } from "./link";
import type { ErrorMessage, Message, Readings, RecipeMessage, Standard } from "./protocol";
import { kindOf, OwnFiles } from "./own_files";
import { SparkleMeter } from "./sparkle";
import type { Schema } from "./schema";
import type { Session } from "./session";
import type { Settings, State } from "./state";
import { isCurrent, NO_ATLAS_SETUP, NO_FIT, NO_FIT_SETUP } from "./state";
import { Store } from "./store";
import type { Table } from "./tree";
import { Viewer } from "./viewer";

const EMPTY: Document = { recipe: {}, locks: new Set() };
const LINK_AFTER_MS = 400;

interface PaintRequest {
    readonly recipe: Table;
    /** null: of a match, which is looked at beside the paint. */
    readonly document: Document | null;
    readonly settings: Settings;
    /** By which it is read: a match by that of its fit. */
    readonly model: string;
    /** In which the live picture shows it. */
    readonly lamp: string;
    /** When the change was made, for the time from slider to chips. */
    readonly since: number;
}

export interface Surroundings extends Server {
    /** What the server has at an address of its own. */
    readonly bytes: (path: string) => Promise<ArrayBuffer>;
    readonly now: () => number;
    /** Calls back when what was set has been drawn. */
    readonly drawn: (then: () => void) => void;
    readonly fragment: () => string;
    readonly setFragment: (fragment: string) => void;
    readonly address: () => string;
}

export class Studio {
    readonly store: Store<State>;
    readonly connection: Connection;
    readonly viewer: Viewer;
    readonly atlas: Atlas;
    readonly sparkle: SparkleMeter;
    readonly ownFiles: OwnFiles;
    private readonly history = new History<Document>(EMPTY);
    private readonly session: Session;
    private readonly painting: Latest<PaintRequest>;
    private linkTimer: ReturnType<typeof setTimeout> | undefined;
    private readonly fitting: Fitting;

    constructor(private readonly around: Surroundings) {
        this.store = new Store<State>({
            connection: "connecting",
            schema: null,
            document: EMPTY,
            canUndo: false,
            canRedo: false,
            paint: null,
            readings: null,
            readingsOf: null,
            readingsBy: null,
            details: null,
            fault: null,
            notOpened: null,
            latency_ms: null,
            settings: {
                geometries: "byk-mac",
                illuminant: "D65",
                observer: "10",
                model: "",
                tolerance: 1,
            },
            standard: null,
            sparkle: null,
            sparkleFraction: null,
            fit: NO_FIT,
            fitSetup: NO_FIT_SETUP,
            atlasSetup: NO_ATLAS_SETUP,
            ownShape: null,
            ownLight: null,
            notice: "",
        });
        this.painting = new Latest((request) => {
            this.sendPaint(request);
        });
        this.connection = new Connection(around, this.store, {
            begin: (schema) => {
                const { settings } = this.store.get();
                const model = settings.model === "" ? schema.reading_model : settings.model;
                this.store.set({ settings: { ...settings, model } });
                this.viewer.begin(schema);
            },
            start: (schema) => {
                void this.start(schema);
            },
            back: () => {
                this.ownFiles.bringAgain();
                this.measure();
            },
            lost: () => {
                this.abandon();
            },
            opened: (document) => {
                this.load(document);
            },
            standardTaken: this.standardTaken.bind(this),
        });
        this.session = this.connection.session;
        this.viewer = new Viewer(this.session);
        let shownIn = this.lamp;
        this.viewer.store.subscribe(() => {
            if (this.lamp === shownIn) return;
            shownIn = this.lamp;
            this.measure();
        });
        this.atlas = new Atlas(this.session, (busy) => {
            this.viewer.hold("atlas", busy);
        });
        this.sparkle = new SparkleMeter(this.store, this.session);
        this.fitting = new Fitting(this.store, this.session, () => {
            this.measureMatch();
        });
        this.ownFiles = new OwnFiles(this.store, this.viewer, this.connection);
    }

    /** The paint of the address, else that which the command line named, else the first that ships. */
    private async start(schema: Schema): Promise<void> {
        if (await this.openLink(this.around.fragment())) return;
        const toml = schema.start ?? schema.paints[0]?.toml;
        if (toml !== undefined) this.openText(toml);
    }

    /** What the server was working on will not be answered. */
    private abandon(): void {
        this.painting.abandon();
        this.viewer.hold("colours", false);
        this.viewer.abandon();
        this.atlas.stop();
        this.ownFiles.abandon();
        this.sparkle.abandon();
        this.fitting.abandon();
    }

    /** A place for the live picture, which is begun anew where the graphics processor was lost and is back. */
    attach(canvas: HTMLCanvasElement): void {
        const begin = () => {
            const { schema } = this.store.get();
            if (schema !== null) this.viewer.attach(canvas, schema, this.around.bytes);
            this.measure();
        };
        canvas.addEventListener("webglcontextrestored", begin);
        begin();
    }

    // ---- documents ----

    /** @param gesture  one drag of one slider is one step back */
    edit(change: (document: Document) => Document, gesture: string | null = null): void {
        const before = this.history.now;
        if (before === EMPTY) this.history.begin(change(before));
        else this.history.push(change(before), gesture);
        this.changed();
    }

    endGesture(): void {
        this.history.endGesture();
    }

    undo(): void {
        this.history.undo();
        this.changed();
    }

    redo(): void {
        this.history.redo();
        this.changed();
    }

    private changed(): void {
        this.store.set({
            document: this.history.now,
            canUndo: this.history.canUndo,
            canRedo: this.history.canRedo,
            notOpened: null,
        });
        this.measure();
        clearTimeout(this.linkTimer);
        this.linkTimer = setTimeout(() => {
            void toFragment(this.history.now).then(this.around.setFragment);
        }, LINK_AFTER_MS);
    }

    openText(toml: string, name?: string): void {
        this.connection.openText(toml, name);
    }

    /** Another paint: what was found and chosen for the one before goes. */
    private load(document: Document): void {
        this.stopFit();
        const { starts } = this.store.get().fitSetup;
        this.store.set({
            fit: NO_FIT,
            fitSetup: { ...NO_FIT_SETUP, starts },
            atlasSetup: NO_ATLAS_SETUP,
        });
        this.edit(() => document);
    }

    /** A text that was pasted or dropped: a link of the studio, or a recipe. */
    openPasted(text: string): void {
        const link = linkIn(text);
        if (link === null) this.openText(text);
        else void this.openLink(link);
    }

    /** A file that was dropped or chosen: its ending says what it is for. */
    openFile(file: File): void {
        const { name } = file;
        const own = kindOf(name);
        if (own !== null) void this.ownFiles.bring(own, file);
        else if (/\.(csv|json)$/i.test(name)) this.openStandard(file);
        else {
            const large = tooLarge(name, file.size, "read");
            if (large !== null) this.store.set({ notOpened: large });
            else {
                void file.text().then((text) => {
                    this.openText(text, name);
                });
            }
        }
    }

    /** A file of measured colours. */
    openStandard(file: File): void {
        const large = tooLarge(file.name, file.size, "read");
        if (large !== null) {
            this.say(large);
            return;
        }
        void file.text().then((text) => {
            this.setStandard(text, file.name);
        });
    }

    /** @return whether the fragment held a paint */
    async openLink(fragment: string): Promise<boolean> {
        try {
            const document = await fromFragment(fragment);
            if (document === null) return false;
            this.connection.openNothing();
            this.load(document);
            return true;
        } catch (error) {
            this.say(messageOf(error));
            return false;
        }
    }

    say(notice: string): void {
        this.store.set({ notice });
    }

    setSettings(change: Partial<Settings>): void {
        const { settings, fit } = this.store.get();
        // What was found is shown at the new angles, in the new light.
        this.store.set({ settings: { ...settings, ...change }, fit: { ...fit, colours: [] } });
        this.measure();
    }

    // ---- colours ----

    /** The illuminant of the light in the picture. */
    private get lamp(): string {
        const { view } = this.viewer.store.get();
        const lights = this.store.get().schema?.lights ?? [];
        return lights.find(({ name }) => name === view?.light)?.illuminant ?? "D65";
    }

    private measure(): void {
        const { document, settings } = this.store.get();
        if (!this.session.isOpen || Object.keys(document.recipe).length === 0) return;
        const { recipe } = document;
        // Readings alone leave the picture of the paint as it is, which goes on beside them.
        if (recipe !== this.viewer.store.get().recipe) this.viewer.hold("colours", true);
        const since = this.around.now();
        const { model } = settings;
        this.painting.want({ recipe, document, settings, model, lamp: this.lamp, since });
    }

    /**
     * Calls back with what the server says of the paint as it is now, which may be yet to come; never
     * where it finds a fault or goes away.
     */
    whenCurrent(then: (state: State) => void): void {
        const look = (): boolean => {
            const state = this.store.get();
            const current = isCurrent(state);
            if (current) then(state);
            return current || state.fault !== null || state.connection !== "open";
        };
        if (look()) return;
        const leave = this.store.subscribe(() => {
            if (look()) leave();
        });
    }

    /** No answer is awaited. */
    get settled(): boolean {
        return !this.painting.busy;
    }

    private sendPaint({ recipe, document, settings, model, lamp, since }: PaintRequest): void {
        const { geometries, illuminant, observer, tolerance } = settings;
        const fields = {
            recipe,
            geometries,
            illuminant,
            observer,
            model,
            tolerance: { limit: tolerance },
            shader: document !== null && this.viewer.wantsShader,
            lamp,
        };
        if (document !== null) this.connection.tellTextOf(document);
        let chipsAreDrawn = Promise.resolve();
        let paint: RecipeMessage | null = null;
        let details: Pick<State, "details" | "latency_ms"> | null = null;
        const id = this.session.send("paint", fields, (message, attachments) => {
            if (document === null) {
                this.receiveMatch(id, { recipe, settings }, message);
                return;
            }
            switch (message.type) {
                case "recipe":
                    paint = message as unknown as RecipeMessage; // shown with its readings
                    break;
                case "readings": {
                    const readings = message as unknown as Readings;
                    this.store.set({
                        paint,
                        readings,
                        readingsOf: document,
                        readingsBy: settings,
                        fault: null,
                    });
                    chipsAreDrawn = new Promise((then) => {
                        this.around.drawn(() => {
                            details = { details: readings, latency_ms: this.around.now() - since };
                            then();
                        });
                    });
                    break;
                }
                case "shader":
                    // A picture drawn by the processor would hold them up.
                    void chipsAreDrawn.then(() => {
                        this.viewer.shader(document.recipe, message, attachments);
                    });
                    break;
                case "error":
                    this.store.set({ fault: message as unknown as ErrorMessage });
                    this.answered(id, null);
                    break;
                case "done":
                    this.answered(id, document.recipe, chipsAreDrawn);
                    void chipsAreDrawn.then(() => {
                        this.around.drawn(() => {
                            if (details !== null) this.store.set(details);
                        });
                    });
                    break;
            }
        });
    }

    private answered(id: number, recipe: Table | null, drawn = Promise.resolve()): void {
        this.session.forget(id);
        this.painting.finished();
        if (recipe !== null) this.viewer.paint(recipe);
        void drawn.then(() => {
            if (!this.painting.busy) this.viewer.hold("colours", false);
        });
        this.measureMatch();
    }

    /** The next match that has no colours, when nobody waits for those of the paint. */
    private measureMatch(): void {
        const { fit, settings } = this.store.get();
        const match = fit.matches?.[fit.colours.length];
        if (match === undefined || this.painting.busy || !this.session.isOpen) return;
        const { recipe } = match;
        const since = this.around.now();
        const { model } = fit;
        const lamp = this.lamp;
        this.painting.want({ recipe, document: null, settings, model, lamp, since });
    }

    private receiveMatch(
        id: number,
        of: Pick<PaintRequest, "recipe" | "settings">,
        message: Message,
    ): void {
        if (message.type === "readings") {
            const { fit, settings } = this.store.get();
            const match = fit.matches?.[fit.colours.length];
            if (match?.recipe !== of.recipe || settings !== of.settings) return; // of another fit
            const colours = [...fit.colours, message as unknown as Readings];
            this.store.set({ fit: { ...fit, colours } });
        } else if (message.type === "done") this.answered(id, null);
        else if (message.type === "error") {
            this.session.forget(id);
            this.painting.finished();
        }
    }

    // ---- the standard ----

    setStandard(csv: string | null, name: string): void {
        this.connection.setStandard(csv, name);
    }

    private standardTaken(standard: Standard | null, isNew: boolean): void {
        if (isNew) {
            this.stopFit();
            this.store.set({ fit: NO_FIT });
        }
        this.store.set({ standard, notice: standard?.notes.join(" ") ?? "" });
        this.measure();
    }

    // ---- the fit ----

    fit(free: readonly string[], starts: number): void {
        this.fitting.begin(free, starts);
    }

    stopFit(): void {
        this.fitting.stop();
    }

    useMatch(recipe: Table): void {
        this.edit((document) => ({ ...document, recipe }));
    }

    // ---- the link ----

    copyLink(): void {
        void toFragment(this.history.now)
            .then((fragment) => {
                this.around.setFragment(fragment);
                return navigator.clipboard.writeText(this.around.address());
            })
            .then(
                () => {
                    this.say("The address of this page holds the paint; it was copied.");
                },
                () => {
                    this.say(
                        "The address of this page holds the paint; the browser did not let it be copied.",
                    );
                },
            );
    }
}
