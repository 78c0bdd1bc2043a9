/** The line above the gallery: how many paints, nearest to which colour, in which order. */

import type { Lab } from "../../common/colour";
import { chip } from "../../common/colour";
import type { Library } from "./data";
import { angleName, h } from "../../common/dom";
import type { Size } from "./gallery";
import { SIZES, sortName } from "./gallery";
import type { Found, Query, SortKey } from "./query";
import { measures } from "./query";

/** 10 000 */
function grouped(count: number): string {
    return count.toLocaleString("en").replace(/,/g, "\u2009");
}

export interface ToolbarEvents {
    change: (part: (query: Query) => void) => void;
    size: (size: Size) => void;
    filters: () => void;
}

export class Toolbar {
    readonly element: HTMLElement;
    readonly filtersButton: HTMLButtonElement;
    private readonly count: HTMLElement;
    private readonly fields: HTMLInputElement[];
    private readonly swatch: HTMLElement;
    private readonly clear: HTMLButtonElement;
    private readonly at: HTMLSelectElement;
    private readonly sort: HTMLSelectElement;
    private readonly direction: HTMLButtonElement;

    constructor(
        private readonly library: Library,
        private readonly events: ToolbarEvents,
        size: Size,
    ) {
        const { change } = events;
        // As wide as its longest text, so that nothing moves when the count changes.
        const longest = 2 * grouped(library.records).length + " of ".length;
        const width = `min-width:${String(longest + 1)}ch`;
        this.count = h("p", { class: "count", role: "status", style: width });
        this.filtersButton = h(
            "button",
            {
                type: "button",
                class: "show-filters",
                "aria-expanded": "false",
                "aria-controls": "filters",
            },
            "Filters",
        );
        this.filtersButton.addEventListener("click", events.filters);

        this.fields = (["L*", "a*", "b*"] as const).map((name) => {
            const field = h("input", {
                type: "number",
                step: "any",
                "aria-label": `${name} to be near to`,
            });
            field.addEventListener("input", () => {
                this.typed();
            });
            return field;
        });
        this.swatch = h("span", { class: "swatch", title: "The colour typed in" });
        this.clear = h(
            "button",
            { type: "button", class: "clear", "aria-label": "Clear this colour" },
            "×",
        );
        this.clear.addEventListener("click", () => {
            for (const field of this.fields) field.value = "";
            this.typed();
        });

        this.at = h(
            "select",
            {},
            ...library.geometries.map((name) => h("option", { value: name }, angleName(name))),
        );
        this.at.addEventListener("change", () => {
            change((query) => (query.at = this.at.value));
        });

        const keys: SortKey[] = ["name", "nearness", ...measures];
        this.sort = h(
            "select",
            {},
            ...keys.map((key) => h("option", { value: key }, sortName(key))),
        );
        this.sort.addEventListener("change", () => {
            change((query) => {
                query.sort = this.sort.value as SortKey;
                query.descending = false;
            });
        });
        this.direction = h("button", { type: "button", class: "direction" });
        this.direction.addEventListener("click", () => {
            change((query) => (query.descending = !query.descending));
        });

        const sizes = (Object.keys(SIZES) as Size[]).map((name) => {
            const radio = h("input", {
                type: "radio",
                name: "size",
                value: name,
                checked: name === size,
            });
            radio.addEventListener("change", () => {
                events.size(name);
            });
            return h(
                "label",
                { title: `${name} pictures` },
                radio,
                h("span", {}, name.charAt(0).toUpperCase()),
            );
        });

        const [L, a, b] = this.fields;
        this.element = h(
            "div",
            { class: "toolbar", role: "search" },
            this.filtersButton,
            this.count,
            h("label", { class: "at" }, "At ", this.at),
            h(
                "fieldset",
                { class: "target" },
                h("legend", {}, "Nearest to"),
                this.swatch,
                h("span", { "aria-hidden": true }, "L*"),
                L,
                h("span", { "aria-hidden": true }, "a*"),
                a,
                h("span", { "aria-hidden": true }, "b*"),
                b,
                this.clear,
            ),
            h("label", { class: "sort" }, "Sort ", this.sort),
            this.direction,
            h(
                "fieldset",
                { class: "sizes" },
                h("legend", { class: "hidden" }, "Size of pictures"),
                ...sizes,
            ),
        );
    }

    show(query: Query, found: Found): void {
        const [shown, all] = [found.paints.length, this.library.records];
        this.count.replaceChildren(
            h("b", {}, grouped(shown)),
            shown === all ? " paints" : ` of ${grouped(all)}`,
        );
        this.at.value = query.at;
        this.sort.value = query.sort;
        for (const option of this.sort.options) {
            option.disabled = option.value === "nearness" && query.target === null;
        }
        this.direction.textContent = query.descending ? "↓" : "↑";
        const direction = query.descending ? "largest first" : "smallest first";
        this.direction.setAttribute("aria-label", `Order: ${direction}`);
        this.direction.title = direction;
        this.fields.forEach((field, i) => {
            const value = query.target?.[i];
            // What is being typed is the reader's.
            if (!this.fields.includes(document.activeElement as HTMLInputElement)) {
                field.value = value === undefined ? "" : String(value);
            }
        });
        this.swatch.style.background = query.target === null ? "" : chip(query.target).css;
        this.swatch.classList.toggle("empty", query.target === null);
        this.clear.disabled = query.target === null;
    }

    private typed(): void {
        const values = this.fields.map((field) => field.valueAsNumber);
        const target = values.some(Number.isNaN) ? null : (values as unknown as Lab);
        this.events.change((query) => {
            if (target === null && query.sort === "nearness") {
                query.sort = "name";
                query.descending = false;
            } else if (target !== null && query.target === null) {
                query.sort = "nearness";
                query.descending = false;
            }
            query.target = target;
        });
    }
}
