/** Colours as numbers: CIELAB relative to the perfect diffuser, as Nacre reads it. */

export type Lab = readonly [L: number, a: number, b: number];

const RADIAN = Math.PI / 180;

export function chroma(lab: Lab): number {
    return Math.hypot(lab[1], lab[2]);
}

/** Hue angle in [0, 360) degrees; 0 for a grey. */
export function hue(lab: Lab): number {
    if (chroma(lab) < 1e-9) return 0;
    const degrees = Math.atan2(lab[2], lab[1]) / RADIAN;
    return degrees < 0 ? (degrees + 360) % 360 : degrees;
}

/** Difference of hue of a sample from a standard as a distance, Delta H* [cie-15-2018]. */
export function deltaHue(standard: Lab, sample: Lab): number {
    const [, a1, b1] = standard;
    const [, a2, b2] = sample;
    // 2 sqrt(C1 C2) sin(dh / 2), without angles.
    const product = chroma(standard) * chroma(sample);
    const cosine = a1 * a2 + b1 * b2;
    const sine = a1 * b2 - a2 * b1;
    // Two forms of one number: near hues lose digits in the second, opposite ones in the first.
    if (cosine > 0) return Math.sqrt(2 / (product + cosine)) * sine;
    return (sine < 0 ? -1 : 1) * Math.sqrt(2 * (product - cosine));
}

function hueOf(a: number, b: number): number {
    if (a === 0 && b === 0) return 0;
    const degrees = Math.atan2(b, a) / RADIAN;
    return degrees < 0 ? degrees + 360 : degrees;
}

/** CIEDE2000 with all parametric factors 1 [sharma-2005]. */
export function deltaE2000(first: Lab, second: Lab): number {
    const [L1, a1, b1] = first;
    const [L2, a2, b2] = second;
    // a* is stretched near the grey axis.
    const meanChroma7 = ((Math.hypot(a1, b1) + Math.hypot(a2, b2)) / 2) ** 7;
    const stretch = 1 + 0.5 * (1 - Math.sqrt(meanChroma7 / (meanChroma7 + 25 ** 7)));
    const C1 = Math.hypot(stretch * a1, b1);
    const C2 = Math.hypot(stretch * a2, b2);
    const h1 = hueOf(stretch * a1, b1);
    const h2 = hueOf(stretch * a2, b2);

    // The shorter way round the circle; greys have no hue.
    const grey = C1 * C2 === 0;
    let dh = grey ? 0 : h2 - h1;
    if (dh > 180) dh -= 360;
    else if (dh < -180) dh += 360;
    const dL = L2 - L1;
    const dC = C2 - C1;
    const dH = 2 * Math.sqrt(C1 * C2) * Math.sin((dh * RADIAN) / 2);

    const L = (L1 + L2) / 2;
    const C = (C1 + C2) / 2;
    let h = h1 + h2;
    if (!grey) {
        if (Math.abs(h1 - h2) > 180) h += h < 360 ? 360 : -360;
        h /= 2;
    }
    const T =
        1 -
        0.17 * Math.cos((h - 30) * RADIAN) +
        0.24 * Math.cos(2 * h * RADIAN) +
        0.32 * Math.cos((3 * h + 6) * RADIAN) -
        0.2 * Math.cos((4 * h - 63) * RADIAN);
    const S_L = 1 + (0.015 * (L - 50) ** 2) / Math.sqrt(20 + (L - 50) ** 2);
    const S_C = 1 + 0.045 * C;
    const S_H = 1 + 0.015 * C * T;
    // Chroma and hue are judged together in the blue.
    const turn = 30 * Math.exp(-(((h - 275) / 25) ** 2));
    const R_T = -2 * Math.sqrt(C ** 7 / (C ** 7 + 25 ** 7)) * Math.sin(2 * turn * RADIAN);
    const [l, c, H] = [dL / S_L, dC / S_C, dH / S_H];
    return Math.sqrt(l * l + c * c + H * H + R_T * c * H);
}

/** From X/Xn, Y/Yn, Z/Zn to linear Rec. 709, whose white is the display's. */
const FROM_WHITE = [
    [3.08039909, -1.53738318, -0.54301591],
    [-0.92122336, 1.8759675, 0.04525586],
    [0.05287394, -0.20397696, 1.15110302],
] as const;

function linear(lab: Lab): number[] {
    const fy = (lab[0] + 16) / 116;
    const [x, y, z] = [fy + lab[1] / 500, fy, fy - lab[2] / 200].map((f) =>
        f > 6 / 29 ? f ** 3 : 3 * (6 / 29) ** 2 * (f - 4 / 29),
    ) as [number, number, number];
    return FROM_WHITE.map(([r, g, b]) => r * x + g * y + b * z);
}

/** The colour on a display whose white is the perfect diffuser. */
export interface Chip {
    /** `#rrggbb`: what is brighter than the display is scaled down until it fits. */
    readonly css: string;
    readonly tooBright: boolean;
    /** More saturated than sRGB: a component was negative and is shown as 0. */
    readonly outOfGamut: boolean;
}

/** One step of 255 is no difference to be warned of. */
const A_STEP = 1 / 255;

export function chip(lab: Lab): Chip {
    const rgb = linear(lab);
    const scale = Math.max(...rgb, 1);
    const encoded = rgb.map((value) => {
        const x = Math.min(Math.max(value / scale, 0), 1);
        return x <= 0.0031308 ? 12.92 * x : 1.055 * x ** (1 / 2.4) - 0.055;
    });
    const css = encoded.map((x) =>
        Math.round(255 * x)
            .toString(16)
            .padStart(2, "0"),
    );
    return {
        css: "#" + css.join(""),
        tooBright: scale > 1 + A_STEP,
        outOfGamut: Math.min(...rgb) < -A_STEP * scale,
    };
}
