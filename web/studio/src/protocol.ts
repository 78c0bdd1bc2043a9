/** Messages of the server, as docs/studio-api.md has them. */

import type { Lab } from "../../common/colour";
import type { Rgb } from "./schema";
import type { Table } from "./tree";

export interface RecipeMessage {
    readonly type: "recipe";
    readonly name: string;
    readonly toml: string;
    readonly tree: Table;
    readonly warnings: readonly string[];
}

export interface ErrorMessage {
    readonly message: string;
    /** The path of the key, where it is one of the recipe. */
    readonly key?: string;
    readonly line?: number;
}

/** Colours at angles. */
export interface Colours {
    readonly name: string;
    readonly geometries: readonly string[];
    readonly lab: readonly Lab[];
    /** sRGB, not clipped, the perfect diffuser being the display's white. */
    readonly rgb: readonly Rgb[];
    readonly out_of_gamut: readonly boolean[];
    readonly too_bright: readonly boolean[];
    /** Empty where only colours were read. */
    readonly wavelengths_nm: readonly number[];
    readonly reflectance: readonly (readonly number[])[];
}

/** The standard, and the paint's differences from it in the order of the paint's angles. */
export interface Comparison extends Colours {
    /** Why nothing could be compared. */
    readonly problem?: string;
    readonly delta_e_2000?: readonly (number | null)[];
    readonly dL?: readonly (number | null)[];
    readonly dC?: readonly (number | null)[];
    readonly dH?: readonly (number | null)[];
    readonly mean?: number;
    readonly max?: number;
    readonly passes?: readonly (boolean | null)[];
    readonly all_pass?: boolean | null;
}

export interface Readings extends Colours {
    readonly flop_index: number | null;
    readonly colour_travel: { readonly length: number };
    readonly standard: Comparison | null;
    /** As `nacre measure` prints it. */
    readonly csv: string;
}

export interface Standard extends Colours {
    readonly notes: readonly string[];
}

export interface Estimate {
    readonly value: number;
    /** null where it is not known. */
    readonly standard_error: number | null;
}

export interface Sparkle {
    readonly readings: readonly {
        readonly theta_i: number;
        readonly sparkle: Estimate | null;
        readonly spots_per_cm2: Estimate | null;
        readonly intensity: Estimate | null;
    }[];
    readonly graininess: Estimate | null;
}

export interface Match {
    readonly recipe: Table;
    readonly mean_delta_e: number;
    readonly max_delta_e: number;
    readonly parameters: readonly {
        readonly key: string;
        readonly value: number;
        readonly sd: number | null;
        readonly at_bound: boolean;
    }[];
}

/** Colours by geometry and value of one number. */
export interface AtlasMessage {
    readonly key: string;
    readonly values: readonly number[];
    readonly geometries: readonly string[];
    readonly lab: readonly (readonly Lab[])[];
    /** sRGB in [0, 1]. */
    readonly rgb: readonly (readonly Rgb[])[];
}

/** What came with a message as bytes. */
export interface Attachment {
    readonly name: string;
    readonly dtype: "f32" | "f16" | "u8" | "u16" | "u32";
    readonly shape: readonly number[];
    readonly data: ArrayBufferView;
}

export interface Message {
    readonly type: string;
    /** Of the question; null where the server could not read it. */
    readonly id?: number | null;
    readonly [field: string]: unknown;
}
