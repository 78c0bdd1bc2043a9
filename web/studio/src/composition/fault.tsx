/** What the server found wrong, at the field that it names. */

import type { VNode } from "preact";
import type { Path } from "../tree";
import { get, parsePath, pathText } from "../tree";
import { useStudioState } from "../ui/context";

/** The message about the value at a path; null where it is about another, or there is none. */
export function useFaultAt(path: Path): string | null {
    const text = pathText(path);
    return useStudioState(({ fault }) =>
        fault?.key === text ? shortened(fault.message, text) : null,
    );
}

/** The message about a table, or about a key in it that is not there and has no field of its own. */
export function useFaultIn(path: Path): string | null {
    const text = pathText(path);
    return useStudioState(({ fault, document }) => {
        if (fault?.key === undefined) return null;
        if (fault.key === text) return shortened(fault.message, text);
        const named = parsePath(fault.key);
        const inside =
            named.length === path.length + 1 && path.every((step, i) => named[i] === step);
        return inside && get(document.recipe, named) === undefined
            ? shortened(fault.message, text)
            : null;
    });
}

/** Without the place, where the message stands at it: "must be ... in (0, 1]". */
function shortened(message: string, key: string): string {
    const after = message.indexOf(key);
    const rest = after < 0 ? message : message.slice(after + key.length).replace(/^[ .:]+/, "");
    const colon = rest.startsWith("= ") ? rest.indexOf(": ") : -1;
    return colon < 0 ? rest : rest.slice(colon + 2);
}

export function FaultText({
    id,
    text,
}: {
    readonly id: string;
    readonly text: string | null;
}): VNode | null {
    if (text === null) return null;
    return (
        <p class="fault" id={id} role="alert">
            {text}
        </p>
    );
}
