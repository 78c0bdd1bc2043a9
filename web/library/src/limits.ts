/** A control for two limits of a figure: its histogram, two sliders and two fields. */

import { h, svg } from "../../common/dom";
import type { Limits } from "./query";

const BINS = 48;
const STEPS = 1000;

export interface Domain {
    readonly from: number;
    readonly to: number;
    readonly decimals: number;
}

/** Bars from the bottom of a box of BINS by 1. */
function bars(values: readonly number[], domain: Domain, top: number): string {
    const count = countIn(values, domain);
    return count
        .map((n, i) => {
            const height = n === 0 ? 0 : Math.max(0.04, Math.sqrt(n / top)); // rare ones stay visible
            return height === 0 ? "" : `M${String(i)} 1v${(-height).toFixed(3)}h1V1z`;
        })
        .join("");
}

function countIn(values: readonly number[], domain: Domain): number[] {
    const count = new Array<number>(BINS).fill(0);
    const width = domain.to - domain.from || 1;
    for (const value of values) {
        const bin = Math.min(
            BINS - 1,
            Math.max(0, Math.floor((BINS * (value - domain.from)) / width)),
        );
        count[bin] = (count[bin] ?? 0) + 1;
    }
    return count;
}

/** A whole domain around some values with a step that people would choose. */
export function domainOf(values: readonly number[]): Domain {
    let [low, high] = [Infinity, -Infinity];
    for (const value of values) {
        low = Math.min(low, value);
        high = Math.max(high, value);
    }
    if (!(high > low)) high = low + 1;
    const step = 10 ** Math.floor(Math.log10((high - low) / 20));
    const decimals = Math.max(0, -Math.floor(Math.log10(step)));
    const round = (x: number) => Number(x.toFixed(decimals));
    return {
        from: round(Math.floor(low / step) * step),
        to: round(Math.ceil(high / step) * step),
        decimals,
    };
}

export class LimitsControl {
    readonly element: HTMLFieldSetElement;
    private readonly all: SVGPathElement;
    private readonly found: SVGPathElement;
    private readonly sliders: [HTMLInputElement, HTMLInputElement];
    private readonly fields: [HTMLInputElement, HTMLInputElement];
    private readonly chosen: HTMLElement;
    private domain: Domain = { from: 0, to: 1, decimals: 0 };
    private top = 1;
    private limits: Limits = { from: null, to: null };

    constructor(
        label: string,
        private readonly wraps: boolean,
        private readonly changed: (limits: Limits) => void,
        className = "",
    ) {
        this.all = svg("path", { class: "all" });
        this.found = svg("path", { class: "found" });
        const ends = ["from", "to"] as const;
        const [low, high] = ends.map((end) =>
            h("input", { type: "range", min: 0, max: STEPS, "aria-label": `${label} ${end}` }),
        ) as [HTMLInputElement, HTMLInputElement];
        this.sliders = [low, high];
        const [from, to] = ends.map((end) =>
            h("input", {
                type: "number",
                step: "any",
                "aria-label": `${label} ${end}, as a number`,
            }),
        ) as [HTMLInputElement, HTMLInputElement];
        this.fields = [from, to];
        this.chosen = h("span", { class: "chosen" });
        this.element = h(
            "fieldset",
            { class: `limits ${className}` },
            h("legend", {}, label),
            svg(
                "svg",
                {
                    viewBox: `0 0 ${String(BINS)} 1`,
                    preserveAspectRatio: "none",
                    "aria-hidden": true,
                },
                this.all,
                this.found,
            ),
            h("div", { class: "track" }, this.chosen, low, high),
            h("div", { class: "ends" }, from, h("span", { "aria-hidden": true }, "to"), to),
        );
        this.sliders.forEach((slider, end) => {
            slider.addEventListener("input", () => {
                this.slid(end);
            });
        });
        this.fields.forEach((field, end) => {
            field.addEventListener("change", () => {
                const value = field.value === "" ? null : field.valueAsNumber;
                this.take(end, Number.isNaN(value) ? null : value);
            });
        });
    }

    /** Of all records; a library without the figure has no control for it. */
    setDomain(values: readonly number[], domain: Domain): void {
        this.domain = domain;
        this.top = Math.max(1, ...countIn(values, domain));
        this.all.setAttribute("d", bars(values, domain, this.top));
        this.element.hidden = values.length === 0;
        for (const [end, field] of this.fields.entries()) {
            field.placeholder = String(end === 0 ? domain.from : domain.to);
        }
        this.set(this.limits);
    }

    setFound(values: readonly number[]): void {
        this.found.setAttribute("d", bars(values, this.domain, this.top));
    }

    set(limits: Limits): void {
        this.limits = limits;
        const { from, to } = this.domain;
        const place = (value: number) => (value - from) / (to - from);
        const [low, high] = [limits.from ?? from, limits.to ?? to];
        [low, high].forEach((value, end) => {
            const slider = this.sliders[end] as HTMLInputElement;
            slider.value = String(Math.round(STEPS * place(value)));
            slider.setAttribute("aria-valuetext", value.toFixed(this.domain.decimals));
            const field = this.fields[end] as HTMLInputElement;
            const limit = end === 0 ? limits.from : limits.to;
            if (document.activeElement !== field) field.value = limit === null ? "" : String(limit);
        });
        const percent = (value: number) => {
            const share = Math.min(Math.max(place(value), 0), 1);
            return `${(100 * share).toFixed(1)}%`;
        };
        const [a, b] = [percent(low), percent(high)];
        const around = this.wraps && low > high;
        this.chosen.style.background = around
            ? `linear-gradient(to right, var(--ink) ${b}, transparent ${b} ${a}, var(--ink) ${a})`
            : `linear-gradient(to right, transparent ${a}, var(--ink) ${a} ${b}, transparent ${b})`;
        this.element.classList.toggle("set", limits.from !== null || limits.to !== null);
    }

    private slid(end: number): void {
        const slider = this.sliders[end] as HTMLInputElement;
        const { from, to, decimals } = this.domain;
        const place = Number(slider.value);
        const open = place === (end === 0 ? 0 : STEPS);
        this.take(
            end,
            open ? null : Number((from + ((to - from) * place) / STEPS).toFixed(decimals)),
        );
    }

    private take(end: number, value: number | null): void {
        let { from, to } = this.limits;
        if (end === 0) from = value;
        else to = value;
        // One limit pushes the other along, but round the circle of hues they may pass.
        if (!this.wraps && from !== null && to !== null && from > to) {
            if (end === 0) to = from;
            else from = to;
        }
        this.set({ from, to });
        this.changed({ from, to });
    }
}
