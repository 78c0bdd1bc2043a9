/** Colours that a display does not show as they are: how they are marked and counted. */

import type { Colours } from "./protocol";

type Flags = Pick<Colours, "out_of_gamut" | "too_bright">;

interface Kind {
    readonly of: (colours: Flags) => readonly boolean[];
    /** At the chip. */
    readonly mark: string;
    readonly name: string;
    readonly means: string;
}

const KINDS: readonly Kind[] = [
    {
        of: ({ out_of_gamut }) => out_of_gamut,
        mark: "!",
        name: "outside sRGB",
        means: "outside sRGB, clipped",
    },
    {
        of: ({ too_bright }) => too_bright,
        mark: "↑",
        name: "too bright",
        means: "too bright: brighter than white, dimmed",
    },
];

/** What is to be said of the colour at an angle. */
export function caveatsAt(colours: Flags, i: number): readonly Kind[] {
    return KINDS.filter(({ of }) => of(colours)[i] === true);
}

/** At how many angles there is which caveat: "1 outside sRGB, 3 too bright". */
export function caveatsText(colours: Flags): string {
    return KINDS.map(({ of, name }) => ({ count: of(colours).filter(Boolean).length, name }))
        .filter(({ count }) => count > 0)
        .map(({ count, name }) => `${String(count)} ${name}`)
        .join(", ");
}
