/** All that the page shows. */

import type { Document } from "./edit";
import type { ErrorMessage, Match, Readings, RecipeMessage, Sparkle, Standard } from "./protocol";
import type { Schema } from "./schema";

export interface Settings {
    readonly geometries: string;
    readonly illuminant: string;
    readonly observer: string;
    /** By which paints are read, and seen by fits; empty until the server has said with which to begin. */
    readonly model: string;
    /** Of Delta E 2000 at each angle. */
    readonly tolerance: number;
}

export interface FitState {
    readonly running: boolean;
    readonly fraction: number;
    readonly matches: readonly Match[] | null;
    /** Of the matches, as far as they have been measured. */
    readonly colours: readonly Readings[];
    readonly fault: string | null;
    /** Numbers that colours cannot tell, by their names on the page: they are left as they are. */
    readonly skipped: readonly string[];
    /** The paint from which it began. */
    readonly began: Document | null;
    /** By which it saw paints. */
    readonly model: string;
}

/** What was chosen for the next fit. */
export interface FitSetup {
    /** Numbers that were ticked or not, by path; others are as usual. */
    readonly said: ReadonlyMap<string, boolean>;
    readonly starts: number;
}

/** What was chosen for the atlas. */
export interface AtlasSetup {
    /** The path of its number; null: the first film. */
    readonly key: string | null;
    /** From where to where, by path, where it was said. */
    readonly ends: ReadonlyMap<string, { readonly low: number; readonly high: number }>;
}

/** A mesh or a light from a file. The server forgets it with the connection. */
export interface OwnFile {
    readonly file: File;
    /** Its vertical is y. */
    readonly yUp: boolean;
    /** As the server named it. */
    readonly name: string;
}

export interface State {
    /** Refused: what answers is not the program that made this page's token. */
    readonly connection: "connecting" | "open" | "gone" | "refused";
    readonly schema: Schema | null;
    readonly document: Document;
    readonly canUndo: boolean;
    readonly canRedo: boolean;
    /** The last recipe that could be read, and what is to be said of it. */
    readonly paint: RecipeMessage | null;
    readonly readings: Readings | null;
    /** Of which the readings are, and how they were made. */
    readonly readingsOf: Document | null;
    readonly readingsBy: Settings | null;
    /** The readings for plots and tables, which come after the picture: what a slider changes first is chips. */
    readonly details: Readings | null;
    readonly fault: ErrorMessage | null;
    /** Why the last text that was pasted, dropped or chosen did not become the paint. */
    readonly notOpened: string | null;
    /** From the change to chips on the screen. */
    readonly latency_ms: number | null;
    readonly settings: Settings;
    readonly standard: Standard | null;
    readonly sparkle: { readonly of: Document; readonly value: Sparkle } | null;
    /** How far its measurement is, in [0, 1]; null: none is under way. */
    readonly sparkleFraction: number | null;
    readonly fit: FitState;
    readonly fitSetup: FitSetup;
    readonly atlasSetup: AtlasSetup;
    /** That the reader brought along. */
    readonly ownShape: OwnFile | null;
    readonly ownLight: OwnFile | null;
    /** For the status line and screen readers. */
    readonly notice: string;
}

/** Whether the readings are of the paint as it is now, and made as was chosen. */
export function isCurrent({ readingsOf, document, readingsBy, settings }: State): boolean {
    return readingsOf === document && readingsBy === settings;
}

/** Whether what is shown is of a paint before: the server finds a fault in the one of now. */
export function isOld({ fault, readingsOf, document }: State): boolean {
    return fault !== null && readingsOf !== document;
}

export const NO_FIT_SETUP: FitSetup = { said: new Map(), starts: 4 };
export const NO_ATLAS_SETUP: AtlasSetup = { key: null, ends: new Map() };

export const NO_FIT: FitState = {
    running: false,
    fraction: 0,
    matches: null,
    colours: [],
    fault: null,
    skipped: [],
    began: null,
    model: "",
};
