/** The panel beside the gallery: what limits the records that it shows. */

import type { Library, Paint } from "./data";
import { h } from "../../common/dom";
import type { Domain } from "./limits";
import { domainOf, LimitsControl } from "./limits";
import type { Choice, Found, Measure, Query } from "./query";
import { CHOICES, choices, listOf, measureOf, MEASURES, measures } from "./query";

/** Longer lists get a field to search them. */
const LONG_LIST = 8;

interface Entry {
    readonly name: string;
    readonly box: HTMLInputElement;
    readonly count: HTMLElement;
    readonly element: HTMLElement;
}

export class Filters {
    readonly element: HTMLElement;
    private readonly search: HTMLInputElement;
    private readonly reset: HTMLButtonElement;
    private readonly controls = new Map<Measure, LimitsControl>();
    private readonly entries = new Map<Choice, Entry[]>();
    private at = -1;

    constructor(
        private readonly library: Library,
        private readonly paints: readonly Paint[],
        private readonly change: (part: (query: Query) => void) => void,
        clear: () => void,
    ) {
        this.search = h("input", {
            type: "search",
            placeholder: "Name or hash",
            "aria-label": "Search by name or hash",
        });
        this.search.addEventListener("input", () => {
            change((query) => (query.text = this.search.value.trim()));
        });
        this.reset = h("button", { type: "button", class: "reset" }, "Reset");
        this.reset.addEventListener("click", clear);

        for (const measure of measures) {
            const control = new LimitsControl(
                MEASURES[measure],
                measure === "h",
                (limits) => {
                    change((query) => {
                        const { [measure]: _, ...others } = query.limits;
                        const open = limits.from === null && limits.to === null;
                        query.limits = open ? others : { ...others, [measure]: limits };
                    });
                },
                measure === "h" ? "hue" : "",
            );
            this.controls.set(measure, control);
        }
        const control = (measure: Measure) => this.controls.get(measure)?.element ?? null;
        this.element = h(
            "section",
            { class: "filters", "aria-label": "Filters", id: "filters" },
            h("div", { class: "filters-head" }, h("h2", {}, "Filters"), this.reset),
            this.search,
            control("h"),
            control("C"),
            control("L"),
            control("flop"),
            control("travel"),
            control("sparkle"),
            control("graininess"),
            ...choices.map((choice) => this.list(choice)),
        );
        for (const measure of ["flop", "travel", "sparkle", "graininess"] as const) {
            const values = this.valuesOf(paints, measure, 0);
            this.controls.get(measure)?.setDomain(values, domainOf(values));
        }
    }

    /** Shows a query and what it found. */
    show(query: Query, found: Found): void {
        const at = this.library.geometries.indexOf(query.at);
        if (at !== this.at) {
            this.at = at;
            for (const measure of ["L", "C", "h"] as const) {
                const values = this.valuesOf(this.paints, measure, at);
                const circle: Domain = { from: 0, to: 360, decimals: 0 };
                const domain = measure === "h" ? circle : domainOf(values);
                this.controls.get(measure)?.setDomain(values, domain);
            }
        }
        if (document.activeElement !== this.search) this.search.value = query.text;
        for (const [measure, control] of this.controls) {
            control.set(query.limits[measure] ?? { from: null, to: null });
            control.setFound(this.valuesOf(found.paints, measure, at));
        }
        for (const [choice, entries] of this.entries) {
            entries.forEach((entry, place) => {
                const count = found.counts[choice][place] ?? 0;
                entry.count.textContent = String(count);
                entry.box.checked = query.chosen[choice].includes(entry.name);
                entry.element.classList.toggle("none", count === 0 && !entry.box.checked);
            });
        }
        const lists = choices.some((choice) => query.chosen[choice].length > 0);
        const any = lists || query.text !== "" || Object.keys(query.limits).length > 0;
        this.reset.disabled = !any;
    }

    private valuesOf(paints: readonly Paint[], measure: Measure, at: number): number[] {
        const values: number[] = [];
        for (const paint of paints) {
            const value = measureOf(paint, measure, at);
            if (value !== null) values.push(value);
        }
        return values;
    }

    private list(choice: Choice): HTMLElement | null {
        const names = listOf(this.library, choice);
        if (names.length < 2) return null; // nothing to choose
        const entries = names.map((name): Entry => {
            const box = h("input", { type: "checkbox", value: name });
            const count = h("span", { class: "count" });
            const element = h("label", {}, box, h("span", { class: "label" }, name), count);
            box.addEventListener("change", () => {
                this.change((query) => {
                    const others = query.chosen[choice].filter((other) => other !== name);
                    query.chosen = {
                        ...query.chosen,
                        [choice]: box.checked ? [...others, name] : others,
                    };
                });
            });
            return { name, box, count, element };
        });
        this.entries.set(choice, entries);
        const box = h("div", { class: "entries" }, ...entries.map((entry) => entry.element));
        let search: HTMLInputElement | null = null;
        if (names.length > LONG_LIST) {
            const label = `Search in ${CHOICES[choice].toLowerCase()}`;
            search = h("input", { type: "search", placeholder: "Search", "aria-label": label });
            const field = search;
            field.addEventListener("input", () => {
                const words = field.value.toLowerCase();
                for (const entry of entries) {
                    entry.element.hidden = !entry.name.toLowerCase().includes(words);
                }
            });
        }
        const how = choice === "with" ? "all of" : "any of";
        return h(
            "fieldset",
            { class: "choice" },
            h("legend", {}, CHOICES[choice], h("span", { class: "how" }, how)),
            search,
            box,
        );
    }
}
