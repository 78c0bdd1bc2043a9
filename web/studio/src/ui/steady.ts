/** Components that are drawn anew only when what they were given is another. */

import type { ComponentClass, FunctionComponent } from "preact";
import { Component, createElement } from "preact";
import type { Path } from "../tree";
import { pathText } from "../tree";

/**
 * A slider moves sixty times a second, and the processors are needed for the paint's colours: of a form
 * of fifty rows only the one that moves is to be drawn.
 * @return  the same component, drawn when a property is another object or a path has other steps, or
 *          when it asks for it itself
 */
export function steady<Props extends object>(
    draw: FunctionComponent<Props>,
): ComponentClass<Props> {
    return class Steady extends Component<Props> {
        override shouldComponentUpdate(next: Readonly<Props>): boolean {
            return !sameProps(this.props, next);
        }

        override render() {
            return createElement(draw, this.props);
        }
    };
}

function sameProps(one: object, other: object): boolean {
    const [before, after] = [Object.entries(one), new Map(Object.entries(other))];
    return (
        before.length === after.size &&
        before.every(([name, value]) => after.has(name) && same(name, value, after.get(name)))
    );
}

/** Paths are written anew at each drawing. */
function same(name: string, one: unknown, other: unknown): boolean {
    return name === "path" ? pathText(one as Path) === pathText(other as Path) : one === other;
}
