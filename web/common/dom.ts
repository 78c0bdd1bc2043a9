/** Elements without markup in text: names of paints are data and are never read as HTML. */

type Child = Node | string | null | undefined;
type Attributes = Record<string, string | number | boolean | null | undefined>;

function fill(element: Element, attributes: Attributes, children: readonly Child[]): void {
    for (const [name, value] of Object.entries(attributes)) {
        if (value === null || value === undefined || value === false) continue;
        // A style attribute is refused by the page's own security policy; style as an object is not.
        if (name === "style") (element as HTMLElement).style.cssText = String(value);
        else element.setAttribute(name, value === true ? "" : String(value));
    }
    for (const child of children) if (child !== null && child !== undefined) element.append(child);
}

export function h<K extends keyof HTMLElementTagNameMap>(
    tag: K,
    attributes: Attributes = {},
    ...children: readonly Child[]
): HTMLElementTagNameMap[K] {
    const element = document.createElement(tag);
    fill(element, attributes, children);
    return element;
}

export function svg<K extends keyof SVGElementTagNameMap>(
    tag: K,
    attributes: Attributes = {},
    ...children: readonly Child[]
): SVGElementTagNameMap[K] {
    const element = document.createElementNS("http://www.w3.org/2000/svg", tag);
    fill(element, attributes, children);
    return element;
}

/** A number with so many decimals and a real minus sign; a dash where there is none. */
export function number(value: number | null | undefined, decimals: number): string {
    if (value === null || value === undefined || Number.isNaN(value)) return "–";
    const text = value.toFixed(decimals);
    return (Number(text) === 0 ? text.replace("-", "") : text).replace("-", "\u2212");
}

/** A geometry for people: "45as−15". */
export function angleName(name: string): string {
    return name.replace(/-/g, "\u2212");
}
