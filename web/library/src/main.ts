/**
 * The page of a library. Its address says what is shown, so that links and the back button work:
 * #/?QUERY is the gallery, #/record/ID a record, #/compare/ID/ID two of them.
 */

import { chip } from "../../common/colour";
import { comparePage } from "./compare";
import type { Library, Paint } from "./data";
import { loadDetails, loadLibrary, loadPaints } from "./data";
import { h } from "../../common/dom";
import { Filters } from "./filters";
import type { Size } from "./gallery";
import { Gallery, SIZES } from "./gallery";
import { mainAngles } from "../../common/geometry";
import type { Query } from "./query";
import { emptyQuery, find, labAt, read, write } from "./query";
import { recordPage } from "./record";
import { remembered, remember } from "../../common/memory";
import { themeButton } from "../../common/theme";
import { Toolbar } from "./toolbar";

/** The usual angle of a library: 45 degrees from the mirror direction, else the middle one. */
function usualAngle(library: Library): string {
    const names = library.geometries;
    const angles = mainAngles(names);
    const place =
        angles.find((angle) => angle.aspecular === 45) ?? angles[Math.floor(angles.length / 2)];
    return names[place?.index ?? 0] ?? "";
}

class Page {
    private readonly byId: Map<string, Paint>;
    private readonly usual: Query;
    private query: Query;
    private shownQuery: string | null = null;
    private picks: Paint[] = [];
    private readonly gallery: Gallery;
    private readonly filters: Filters;
    private readonly toolbar: Toolbar;
    private readonly tray: HTMLElement;
    private readonly browse: HTMLElement;
    private readonly sheet: HTMLElement;
    private pending = 0;
    private route = 0;

    constructor(
        private readonly library: Library,
        paints: readonly Paint[],
        private readonly allPaints = paints,
    ) {
        this.byId = new Map(paints.map((paint) => [paint.id, paint]));
        this.usual = emptyQuery(usualAngle(library));
        this.query = { ...this.usual };
        this.gallery = new Gallery(
            library,
            {
                picked: (paint) => {
                    this.pick(paint);
                },
            },
            paints.some((paint) => paint.thumbnails.length === 0),
        );
        const change = (part: (query: Query) => void) => {
            part(this.query);
            this.changed();
        };
        this.filters = new Filters(library, paints, change, () => {
            const { at, target, sort, descending } = this.query;
            this.query = { ...emptyQuery(at), target, sort, descending };
            this.changed();
        });
        const kept = remembered("size");
        const size: Size = kept !== null && kept in SIZES ? (kept as Size) : "medium";
        this.toolbar = new Toolbar(
            library,
            {
                change,
                size: (chosen) => {
                    remember("size", chosen);
                    this.gallery.setSize(chosen);
                },
                filters: () => {
                    this.openFilters(!this.browse.classList.contains("filtering"));
                },
            },
            size,
        );
        this.gallery.setSize(size);
        this.tray = h("section", { class: "tray", "aria-label": "To compare" });
        const close = h("button", { type: "button", class: "close-filters" }, "Show paints");
        close.addEventListener("click", () => {
            this.openFilters(false);
            this.toolbar.filtersButton.focus();
        });
        this.filters.element.append(close);
        this.browse = h(
            "div",
            { class: "browse" },
            this.filters.element,
            h("div", { class: "shown" }, this.toolbar.element, this.gallery.element),
        );
        this.browse.addEventListener("keydown", (event) => {
            if (event.key === "Escape" && this.browse.classList.contains("filtering")) {
                this.openFilters(false);
                this.toolbar.filtersButton.focus();
            }
        });
        this.sheet = h("div", { class: "sheet", hidden: true });

        document.body.replaceChildren(
            h(
                "header",
                { class: "top" },
                h("a", { class: "title", href: "#/" }, library.title),
                this.tray,
                themeButton(),
            ),
            h("main", {}, this.browse, this.sheet),
        );
        this.showPicks();
        window.addEventListener("hashchange", () => {
            void this.go();
        });
        void this.go();
    }

    private openFilters(open: boolean): void {
        this.browse.classList.toggle("filtering", open);
        this.toolbar.filtersButton.setAttribute("aria-expanded", String(open));
        if (open) this.filters.element.querySelector("input")?.focus();
    }

    /** The reader changed the query: the address follows, without a step for the back button. */
    private changed(): void {
        if (this.pending !== 0) return; // more changes before the next frame are one
        this.pending = requestAnimationFrame(() => {
            this.pending = 0;
            const text = write(this.query, this.usual);
            history.replaceState(null, "", text === "" ? "#/" : `#/?${text}`);
            this.showQuery(text);
        });
    }

    private showQuery(text: string): void {
        this.shownQuery = text;
        const found = find(this.library, this.allPaints, this.query);
        this.filters.show(this.query, found);
        this.toolbar.show(this.query, found);
        this.gallery.show(found.paints, found.distance, this.query);
    }

    private async go(): Promise<void> {
        const route = ++this.route;
        const address = location.hash.replace(/^#/, "");
        const [path = "", text = ""] = address.split(/\?(.*)/s);
        const [kind, ...ids] = path.split("/").filter(Boolean).map(decodeURIComponent);
        if (kind === undefined) {
            this.showGallery(text);
            return;
        }
        const paints = ids.map((id) => this.byId.get(id));
        let page: HTMLElement;
        try {
            const details = await Promise.all(
                paints.map(async (paint) => {
                    if (paint === undefined) throw new Error("The library has no such record.");
                    return { paint, details: await loadDetails(this.library, paint) };
                }),
            );
            const [first, second] = details;
            if (kind === "record" && first !== undefined && second === undefined) {
                const pick = this.pickButton(first.paint);
                page = recordPage(this.library, first.paint, first.details, pick);
            } else if (kind === "compare" && first !== undefined && second !== undefined) {
                page = comparePage(this.library, first, second);
                this.picks = [first.paint, second.paint];
                this.showPicks();
            } else {
                throw new Error("There is no such page.");
            }
        } catch (error) {
            const message = error instanceof Error ? error.message : String(error);
            page = h(
                "article",
                { class: "record" },
                h("h1", { tabindex: -1 }, "Not found"),
                h("p", {}, message),
            );
        }
        if (route !== this.route) return; // the reader went on meanwhile
        const back = h(
            "a",
            { class: "back", href: this.shownQuery ? `#/?${this.shownQuery}` : "#/" },
            "← Gallery",
        );
        page.prepend(h("nav", {}, back));
        this.sheet.replaceChildren(page);
        this.sheet.hidden = false;
        this.browse.hidden = true;
        this.sheet.scrollTop = 0;
        const heading = page.querySelector<HTMLElement>("h1");
        heading?.focus({ preventScroll: true });
        const names = paints.flatMap((paint) => (paint === undefined ? [] : [paint.name]));
        document.title = [...names, this.library.title].join(" – ");
    }

    private showGallery(text: string): void {
        const returning = this.browse.hidden;
        this.browse.hidden = false;
        this.sheet.hidden = true;
        this.sheet.replaceChildren();
        document.title = this.library.title;
        if (text !== this.shownQuery) {
            this.query = read(text, this.usual, this.library);
            this.showQuery(text);
        } else if (returning) {
            this.gallery.restore(true);
        }
    }

    private pickButton(paint: Paint): HTMLElement {
        const button = h("button", { type: "button", class: "button" });
        const show = () => {
            const picked = this.picks.includes(paint);
            button.textContent = picked ? "Do not compare" : "Compare…";
            button.setAttribute("aria-pressed", String(picked));
        };
        button.addEventListener("click", () => {
            this.pick(paint);
            show();
        });
        show();
        return button;
    }

    /** A is kept: the next one to be compared with it takes the place of B. */
    private pick(paint: Paint): void {
        const others = this.picks.filter((other) => other !== paint);
        if (others.length < this.picks.length) this.picks = others;
        else this.picks = [...others.slice(0, 1), paint];
        this.showPicks();
    }

    private showPicks(): void {
        this.gallery.setPicks(this.picks.map((paint) => paint.id));
        const places = ["A", "B"].map((letter, i) => {
            const paint = this.picks[i];
            if (paint === undefined) {
                return h(
                    "span",
                    { class: "slot empty" },
                    h("b", {}, letter),
                    h("span", {}, "no paint"),
                );
            }
            const remove = h(
                "button",
                { type: "button", "aria-label": `Do not compare ${paint.name}` },
                "×",
            );
            remove.addEventListener("click", () => {
                this.pick(paint);
            });
            const lab = labAt(paint, this.library.geometries.indexOf(this.query.at));
            const swatch = h("i", { style: `background:${chip(lab).css}` });
            const name = h("a", { href: `#/record/${paint.id}`, title: paint.name }, paint.name);
            return h("span", { class: "slot" }, h("b", {}, letter), swatch, name, remove);
        });
        const [a, b] = this.picks;
        const ready = a !== undefined && b !== undefined;
        const go = h(
            "a",
            {
                class: "button",
                role: "link",
                href: ready ? `#/compare/${a.id}/${b.id}` : null,
                "aria-disabled": String(!ready),
            },
            "Compare",
        );
        this.tray.replaceChildren(...places, go);
    }
}

async function start(): Promise<void> {
    const message = document.querySelector("#message");
    try {
        const library = await loadLibrary();
        document.title = library.title;
        new Page(library, await loadPaints(library));
    } catch (error) {
        if (message === null) throw error;
        message.textContent = error instanceof Error ? error.message : String(error);
    }
}

void start();
