/** Where a slider begins and ends: allowed ranges leave room for studies, a hand wants what is near. */

import type { KeyInfo } from "./schema";

export interface Scale {
    readonly low: number;
    readonly high: number;
    readonly step: number;
}

/** Of numbers that are 0 now, by unit. */
const FROM_ZERO: Readonly<Record<string, number>> = {
    nm: 100,
    um: 50,
    "1/mm": 100,
    "1/um": 1,
    deg: 45,
    "g/cm^3": 5,
};

/** The smallest of 1, 2 and 5 times a power of ten that is not below. */
export function niceAbove(value: number): number {
    const power = 10 ** Math.floor(Math.log10(value));
    const factor = [1, 2, 5, 10].find((m) => m * power >= value * (1 - 1e-9)) ?? 10;
    return Number((factor * power).toPrecision(12));
}

/** @param bounds  of a fit, which a designer has chosen */
export function scaleOf(info: KeyInfo, value: number, bounds?: readonly [number, number]): Scale {
    const min = info.min ?? -Infinity;
    const max = info.max ?? Infinity;
    let low: number;
    let high: number;
    if (bounds !== undefined) [low, high] = bounds;
    else if (max - min <= 1.0000001 && value > max / 4) [low, high] = [min, max];
    else if (min < 0) [low, high] = [min, max];
    else {
        const reach = value > 0 ? niceAbove(2 * value) : (FROM_ZERO[info.unit] ?? 1);
        [low, high] = [0, Math.min(reach, max)];
    }
    if (!Number.isFinite(low)) low = -niceAbove(2 * Math.abs(value) || 1);
    if (!Number.isFinite(high)) high = niceAbove(2 * Math.abs(value) || 1);
    if (low < min && info.zero === undefined) low = min;
    // A round step of about 1/500 of the way, so that numbers stay readable.
    const step = niceAbove((high - low) / 500);
    return { low, high, step };
}

/** The nearest number that a slider stands for and the key allows. */
export function settled(info: KeyInfo, scale: Scale, raw: number): number {
    const rounded = Number((Math.round(raw / scale.step) * scale.step).toPrecision(12));
    let value = Math.min(Math.max(rounded, scale.low), scale.high);
    const { min, max } = info;
    if (info.zero !== undefined && min !== null && min !== undefined && value < min) {
        return value < min / 2 ? 0 : min;
    }
    // An open end is approached by a step.
    if (min !== null && min !== undefined) {
        value = Math.max(value, info.min_excluded ? min + scale.step : min);
    }
    if (max !== null && max !== undefined) {
        value = Math.min(value, info.max_excluded ? max - scale.step : max);
    }
    return Number(value.toPrecision(12));
}
