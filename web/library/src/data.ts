/**
 * What the page shows, as `nacre-library page` writes it beside the page. A page that is opened from
 * disk may not fetch files but may run scripts: each file is a script that hands over its part.
 */

import type { Lab } from "../../common/colour";

/** page/data/library.js */
export interface Library {
    readonly schema: number;
    readonly title: string;
    readonly version: string;
    readonly records: number;
    /** Of all records alike, as are light and observer: a library has one setting. */
    readonly geometries: readonly string[];
    readonly wavelengths_nm: readonly number[];
    readonly illuminant: string;
    readonly observer: string;
    readonly sweeps: readonly string[];
    readonly constructions: readonly string[];
    readonly pigments: readonly string[];
    readonly gallery_files: number;
    readonly records_per_file: number;
    /** Of the sparkle in the gallery; null where none was computed. */
    readonly sparkle_lamp_deg: number | null;
}

/** page/data/gallery-0000.js: columns, so that keys are not written for each record. */
interface GalleryPart {
    readonly id: readonly string[];
    readonly name: readonly string[];
    readonly sweep: readonly number[];
    readonly construction: readonly number[];
    readonly pigments: readonly (readonly number[])[];
    readonly Lab: readonly (readonly number[])[];
    readonly flop_index: readonly (number | null)[];
    readonly colour_travel: readonly (number | null)[];
    readonly sparkle: readonly (number | null)[];
    readonly graininess: readonly (number | null)[];
    readonly thumbnails: readonly (readonly string[])[];
}

/** What the gallery knows of a record; figures are rounded to 1e-4. */
export interface Paint {
    readonly index: number;
    readonly id: string;
    readonly name: string;
    readonly sweep: number;
    readonly construction: number;
    readonly pigments: readonly number[];
    /** By geometry. */
    readonly lab: readonly Lab[];
    readonly flop: number | null;
    readonly travel: number | null;
    readonly sparkle: number | null;
    readonly graininess: number | null;
    readonly thumbnails: readonly string[];
}

/** A value of a recipe, as TOML has them. */
export type Value = string | number | boolean | readonly Value[] | Table;

export interface Table {
    readonly [key: string]: Value;
}

/** Sparkle under a lamp, as `nacre sparkle` reads it. */
export interface Sparkle {
    readonly lamp_deg: number;
    readonly sparkle: number | null;
    readonly sparkle_se: number | null;
    readonly spots_per_cm2: number | null;
    readonly spots_per_cm2_se: number | null;
    readonly intensity: number | null;
    readonly intensity_se: number | null;
}

/** page/data/records-0000.js: everything about some records, figures unrounded. */
export interface Details {
    readonly id: string;
    readonly Lab: readonly Lab[];
    /** (geometry, wavelength), rounded to 1e-6 for curves */
    readonly R: readonly (readonly number[])[];
    readonly flop_index: number | null;
    readonly colour_travel: number | null;
    /** A lamp each; _se are standard errors. */
    readonly sparkle: readonly Sparkle[] | null;
    readonly graininess: number | null;
    readonly warnings: readonly string[];
    readonly swept: Readonly<Record<string, number | string>>;
    readonly parameters: Readonly<Record<string, number>>;
    readonly recipe: Table;
    readonly recipe_text: string;
    readonly files: readonly { readonly name: string; readonly bytes: number }[];
    readonly seconds: number | null;
    readonly version: string;
}

const waiting = new Map<string, (part: unknown) => void>();

declare global {
    interface Window {
        nacreLibrary: (name: string, part: unknown) => void;
    }
}

window.nacreLibrary = (name, part) => {
    waiting.get(name)?.(part);
};

function load(name: string): Promise<unknown> {
    return new Promise((resolve, reject) => {
        const script = document.createElement("script");
        const file = `page/data/${name}.js`;
        const fail = (why: string) => {
            reject(new Error(`${file}: ${why}`));
        };
        waiting.set(name, (part) => {
            waiting.delete(name);
            resolve(part);
        });
        script.src = file;
        script.onerror = () => {
            fail("could not be read");
        };
        script.onload = () => {
            if (waiting.delete(name)) fail("holds no part of that name");
            script.remove();
        };
        document.head.append(script);
    });
}

const numbered = (kind: string, n: number) => `${kind}-${String(n).padStart(4, "0")}`;

/** The schema that this page reads; `nacre-library page` writes page and data together. */
const SCHEMA = 1;

export async function loadLibrary(): Promise<Library> {
    const library = (await load("library")) as Library;
    if (library.schema !== SCHEMA) {
        throw new Error(
            `page/data/library.js: schema ${String(library.schema)}, but this page reads ${String(SCHEMA)}: ` +
                "write the page again",
        );
    }
    return library;
}

function triples(flat: readonly number[]): Lab[] {
    const lab: Lab[] = [];
    for (let i = 0; i + 2 < flat.length; i += 3) {
        lab.push([flat[i] as number, flat[i + 1] as number, flat[i + 2] as number]);
    }
    return lab;
}

export async function loadPaints(library: Library): Promise<Paint[]> {
    const files = Array.from({ length: library.gallery_files }, (_, n) =>
        load(numbered("gallery", n)),
    );
    const paints: Paint[] = [];
    for (const part of (await Promise.all(files)) as GalleryPart[]) {
        part.id.forEach((id, i) => {
            const at = <T>(column: readonly T[]) => column[i] as T;
            paints.push({
                index: paints.length,
                id,
                name: at(part.name),
                sweep: at(part.sweep),
                construction: at(part.construction),
                pigments: at(part.pigments),
                lab: triples(at(part.Lab)),
                flop: at(part.flop_index),
                travel: at(part.colour_travel),
                sparkle: at(part.sparkle),
                graininess: at(part.graininess),
                thumbnails: at(part.thumbnails),
            });
        });
    }
    if (paints.length !== library.records) {
        throw new Error(
            `page/data: ${String(paints.length)} records, but library.js says ${String(library.records)}`,
        );
    }
    return paints;
}

const files = new Map<number, Promise<readonly Details[]>>();

export async function loadDetails(library: Library, paint: Paint): Promise<Details> {
    const file = Math.floor(paint.index / library.records_per_file);
    let loading = files.get(file);
    if (loading === undefined) {
        loading = load(numbered("records", file)) as Promise<readonly Details[]>;
        files.set(file, loading);
        loading.catch(() => files.delete(file)); // asked for again, it may be there
    }
    const details = (await loading)[paint.index % library.records_per_file];
    if (details?.id !== paint.id) {
        throw new Error(`page/data/${numbered("records", file)}.js: does not hold ${paint.id}`);
    }
    return details;
}

/** Where the files of a record are, relative to the page. */
export function folder(id: string): string {
    return `records/${id.slice(0, 2)}/${id}`;
}
