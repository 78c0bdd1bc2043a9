/**
 * The gallery: a grid of cards of which only those near the view exist, so that ten thousand records
 * scroll as ten do. Cards keep their elements when they are reused for other records.
 */

import type { Lab } from "../../common/colour";
import { chip } from "../../common/colour";
import type { Library, Paint } from "./data";
import { folder } from "./data";
import { angleName, h, number } from "../../common/dom";
import type { Angle } from "../../common/geometry";
import { mainAngles, ramp } from "../../common/geometry";
import type { Query } from "./query";
import { labAt, MEASURES, measureOf } from "./query";

const GAP = 16;
const PADDING = 20;
/** Below the picture, in pixels: chips, name and figures; more where cards say what they show. */
const TEXT = 72;
const KIND = 18;
const SPARE_ROWS = 3;

/** Wishes for the width of a card, in pixels. */
export const SIZES = { small: 132, medium: 180, large: 264 } as const;
export type Size = keyof typeof SIZES;

interface Card {
    readonly cell: HTMLElement;
    readonly link: HTMLAnchorElement;
    readonly picture: HTMLElement;
    readonly image: HTMLImageElement;
    readonly strip: HTMLElement;
    readonly name: HTMLElement;
    readonly figures: HTMLElement;
    readonly kind: HTMLElement;
    readonly pick: HTMLButtonElement;
    paint: Paint | null;
}

interface Row {
    readonly element: HTMLElement;
    readonly cards: Card[];
}

export interface GalleryEvents {
    /** A record is to be compared, or no longer. */
    picked: (paint: Paint) => void;
}

export class Gallery {
    readonly element: HTMLElement;
    private readonly canvas: HTMLElement;
    private readonly nothing: HTMLElement;
    private readonly rows = new Map<number, Row>();
    private readonly spare: Row[] = [];
    private paints: readonly Paint[] = [];
    private distance: Float64Array | null = null;
    private query: Query | null = null;
    private picks: readonly string[] = [];
    private wish: number = SIZES.medium;
    private columns = 0;
    private cardWidth = 0;
    /** The card that the keyboard is at; the only one that Tab reaches. */
    private current = 0;
    private scrollTop = 0;

    private readonly text: number;
    private readonly angles: readonly Angle[];

    /** `kinds`: cards say whether their picture was rendered or drawn, as some were not rendered. */
    constructor(
        private readonly library: Library,
        private readonly events: GalleryEvents,
        kinds: boolean,
    ) {
        this.angles = mainAngles(library.geometries);
        this.text = TEXT + (kinds ? KIND : 0);
        this.canvas = h("div", { class: "canvas", role: "grid", "aria-label": "Paints" });
        this.nothing = h(
            "p",
            { class: "nothing", hidden: true },
            "No paint is within these limits.",
        );
        this.canvas.style.setProperty("--text", `${String(this.text)}px`);
        this.canvas.classList.toggle("kinds", kinds);
        this.element = h("div", { class: "gallery" }, this.canvas, this.nothing);
        this.element.addEventListener("scroll", () => {
            this.scrollTop = this.element.scrollTop;
            this.draw();
        });
        this.canvas.addEventListener("keydown", (event) => {
            this.key(event);
        });
        this.canvas.addEventListener("focusin", (event) => {
            const index = this.indexOf(event.target);
            if (index !== null) this.moveTo(index);
        });
        this.canvas.addEventListener("click", (event) => {
            const button = (event.target as Element).closest(".pick");
            const index = this.indexOf(event.target);
            const paint = index === null ? undefined : this.paints[index];
            if (button !== null && paint !== undefined) this.events.picked(paint);
        });
        new ResizeObserver(() => {
            this.layOut();
        }).observe(this.element);
    }

    /** Shows other records, from the top. */
    show(paints: readonly Paint[], distance: Float64Array | null, query: Query): void {
        this.paints = paints;
        this.distance = distance;
        this.query = query;
        this.current = 0;
        this.scrollTop = 0;
        this.element.scrollTop = 0;
        this.nothing.hidden = paints.length > 0;
        this.canvas.hidden = paints.length === 0;
        this.layOut(true);
    }

    setPicks(ids: readonly string[]): void {
        this.picks = ids;
        for (const row of this.rows.values()) {
            for (const card of row.cards) this.markPick(card);
        }
    }

    setSize(size: Size): void {
        this.wish = SIZES[size];
        const first = Math.floor(this.scrollTop / Math.max(this.rowHeight, 1)) * this.columns;
        this.columns = 0;
        this.layOut();
        this.element.scrollTop = Math.floor(first / this.columns) * this.rowHeight;
    }

    /** After the gallery was out of sight, whose elements then forget where they were. */
    restore(focus: boolean): void {
        this.element.scrollTop = this.scrollTop;
        this.draw();
        if (focus) this.cardAt(this.current)?.link.focus({ preventScroll: true });
    }

    private get rowHeight(): number {
        return this.cardWidth + this.text + GAP;
    }

    private layOut(anew = false): void {
        const width = this.element.clientWidth - 2 * PADDING;
        if (width <= 0) return; // out of sight
        const columns = Math.max(2, Math.floor((width + GAP) / (this.wish + GAP)));
        const cardWidth = Math.floor((width - (columns - 1) * GAP) / columns);
        if (!anew && columns === this.columns && cardWidth === this.cardWidth) {
            this.draw(); // the height may have changed
            return;
        }
        if (columns !== this.columns) {
            for (const row of this.rows.values()) row.element.remove();
            this.rows.clear();
            this.spare.length = 0;
        }
        this.columns = columns;
        this.cardWidth = cardWidth;
        const rowCount = Math.ceil(this.paints.length / columns);
        this.canvas.style.setProperty("--card", `${String(cardWidth)}px`);
        this.canvas.style.height = `${String(2 * PADDING - GAP + rowCount * this.rowHeight)}px`;
        this.canvas.setAttribute("aria-rowcount", String(rowCount));
        this.canvas.setAttribute("aria-colcount", String(columns));
        for (const number of [...this.rows.keys()]) this.retire(number);
        this.draw();
    }

    private draw(): void {
        if (this.columns === 0) return;
        const rowCount = Math.ceil(this.paints.length / this.columns);
        const height = this.rowHeight;
        const from = Math.max(0, Math.floor((this.scrollTop - PADDING) / height) - SPARE_ROWS);
        const to = Math.min(
            rowCount - 1,
            Math.floor((this.scrollTop + this.element.clientHeight) / height) + SPARE_ROWS,
        );
        // The row with the keyboard's card stays: focus would be lost with it.
        const kept = Math.floor(this.current / this.columns);
        for (const number of [...this.rows.keys()]) {
            if ((number < from || number > to) && number !== kept) this.retire(number);
        }
        for (let number = from; number <= to; ++number) this.place(number);
        if (kept < rowCount) this.place(kept);
    }

    private retire(number: number): void {
        const row = this.rows.get(number);
        if (row === undefined) return;
        this.rows.delete(number);
        row.element.hidden = true;
        this.spare.push(row);
    }

    private place(number: number): void {
        if (this.rows.has(number)) return;
        const row = this.spare.pop() ?? this.newRow();
        this.rows.set(number, row);
        const top = PADDING + number * this.rowHeight;
        row.element.style.transform = `translateY(${String(top)}px)`;
        row.element.setAttribute("aria-rowindex", String(number + 1));
        row.cards.forEach((card, column) => {
            this.fill(
                card,
                this.paints[number * this.columns + column],
                number * this.columns + column,
            );
        });
        row.element.hidden = false;
    }

    private newRow(): Row {
        const element = h("div", { class: "row", role: "row" });
        const cards = Array.from({ length: this.columns }, (_, column) => {
            const card = newCard(column);
            element.append(card.cell);
            return card;
        });
        this.canvas.append(element);
        return { element, cards };
    }

    private fill(card: Card, paint: Paint | undefined, index: number): void {
        card.paint = paint ?? null;
        card.cell.hidden = paint === undefined;
        if (paint === undefined || this.query === null) return;
        card.cell.dataset.index = String(index);
        card.link.href = `#/record/${paint.id}`;
        card.link.tabIndex = index === this.current ? 0 : -1;
        card.name.textContent = paint.name;
        card.name.title = paint.name;

        const angles = this.angles;
        const lab = (i: number) => labAt(paint, i);
        const thumbnail = paint.thumbnails[0];
        card.image.hidden = true; // until it is there: never another paint's picture
        if (thumbnail === undefined) {
            card.image.removeAttribute("src");
            card.picture.style.background = ramp(angles, lab);
        } else {
            card.picture.style.background = "";
            card.image.src = `${folder(paint.id)}/${thumbnail}`;
        }
        const [near, far] = [angles[0], angles[angles.length - 1]];
        card.kind.textContent =
            thumbnail !== undefined
                ? "rendered"
                : `readings, ${number(near?.aspecular, 0)}° to ${number(far?.aspecular, 0)}°`;
        card.strip.replaceChildren(
            ...angles.map((angle) => h("i", { style: `background:${chip(lab(angle.index)).css}` })),
        );

        const distance = this.distance?.[paint.index];
        const { sort, at } = this.query;
        const place = this.library.geometries.indexOf(at);
        const figures = [`flop ${number(paint.flop, 1)}`, `travel ${number(paint.travel, 0)}`];
        let first: string | null = null;
        if (distance !== undefined && this.distance !== null) {
            first = `ΔE2000 ${number(distance, 2)}`;
        } else if (sort !== "name" && sort !== "nearness" && sort !== "flop" && sort !== "travel") {
            const label = { L: "L*", C: "C*", h: "h", sparkle: "sparkle", graininess: "grain" }[
                sort
            ];
            first = `${label} ${number(measureOf(paint, sort, place), 1)}`;
        }
        if (first !== null) figures.unshift(first);
        card.figures.textContent = figures.slice(0, 2).join("   ");
        card.link.setAttribute(
            "aria-label",
            [
                paint.name,
                card.kind.textContent,
                ...figures,
                `at ${angleName(at)}: ` + labText(labAt(paint, place)),
            ].join(", "),
        );
        this.markPick(card);
    }

    private markPick(card: Card): void {
        if (card.paint === null) return;
        const place = this.picks.indexOf(card.paint.id);
        card.cell.classList.toggle("picked", place >= 0);
        card.pick.setAttribute("aria-pressed", String(place >= 0));
        card.pick.textContent = place < 0 ? "+" : (["A", "B"][place] ?? "");
        card.pick.setAttribute("aria-label", `Compare ${card.paint.name}`);
    }

    private indexOf(target: EventTarget | null): number | null {
        const cell = (target as Element | null)?.closest<HTMLElement>(".card");
        const index = cell?.dataset.index;
        return index === undefined ? null : Number(index);
    }

    private cardAt(index: number): Card | undefined {
        return this.rows.get(Math.floor(index / this.columns))?.cards[index % this.columns];
    }

    private moveTo(index: number): void {
        const before = this.cardAt(this.current);
        if (before !== undefined) before.link.tabIndex = -1;
        this.current = index;
        const now = this.cardAt(index);
        if (now !== undefined) now.link.tabIndex = 0;
    }

    private key(event: KeyboardEvent): void {
        if (event.ctrlKey || event.altKey || event.metaKey) return;
        const paint = this.paints[this.current];
        if (event.key === "c" && paint !== undefined) {
            this.events.picked(paint);
            return;
        }
        const page = Math.max(1, Math.floor(this.element.clientHeight / this.rowHeight));
        const steps: Record<string, number> = {
            ArrowLeft: -1,
            ArrowRight: 1,
            ArrowUp: -this.columns,
            ArrowDown: this.columns,
            PageUp: -page * this.columns,
            PageDown: page * this.columns,
            Home: -this.current,
            End: this.paints.length - 1 - this.current,
        };
        const step = steps[event.key];
        if (step === undefined) return;
        event.preventDefault();
        const next = Math.min(Math.max(this.current + step, 0), this.paints.length - 1);
        this.moveTo(next);
        this.bringIntoView(next);
        this.cardAt(next)?.link.focus({ preventScroll: true });
    }

    private bringIntoView(index: number): void {
        const top = PADDING + Math.floor(index / this.columns) * this.rowHeight;
        const bottom = top + this.rowHeight;
        if (top - PADDING < this.scrollTop) {
            this.element.scrollTop = top - PADDING;
        } else if (bottom > this.scrollTop + this.element.clientHeight) {
            this.element.scrollTop = bottom - this.element.clientHeight;
        }
        this.scrollTop = this.element.scrollTop;
        this.draw();
    }
}

function labText(lab: Lab): string {
    return `L* ${number(lab[0], 1)}, a* ${number(lab[1], 1)}, b* ${number(lab[2], 1)}`;
}

function newCard(column: number): Card {
    const image = h("img", { alt: "", decoding: "async", hidden: true });
    image.addEventListener("load", () => {
        image.hidden = false;
    });
    const picture = h("span", { class: "picture" }, image);
    const strip = h("span", { class: "strip" });
    const name = h("span", { class: "name" });
    const link = h("a", { tabindex: -1, "aria-keyshortcuts": "c" }, picture, strip, name);
    const figures = h("span", { class: "numbers" });
    const kind = h("span", { class: "kind" });
    const pick = h("button", { class: "pick", type: "button", tabindex: -1 });
    const cell = h(
        "div",
        { class: "card", role: "gridcell", "aria-colindex": column + 1 },
        link,
        h("span", { class: "figures" }, figures, kind),
        pick,
    );
    return { cell, link, picture, image, strip, name, figures, kind, pick, paint: null };
}

/** What sorting is by, for people. */
export function sortName(sort: Query["sort"]): string {
    if (sort === "name") return "Name";
    return sort === "nearness" ? "Nearness" : MEASURES[sort];
}
