/** An element that was made without the framework, as the plots that both pages share. */

import type { VNode } from "preact";
import { useLayoutEffect, useRef } from "preact/hooks";

export function Made({ element }: { readonly element: Element }): VNode {
    const place = useRef<HTMLDivElement>(null);
    useLayoutEffect(() => {
        place.current?.replaceChildren(element);
    }, [element]);
    return <div ref={place} />;
}
