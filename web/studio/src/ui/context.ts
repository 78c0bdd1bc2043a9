import { createContext } from "preact";
import { useContext } from "preact/hooks";
import type { AtlasState } from "../atlas";
import type { State } from "../state";
import { useStore } from "../store";
import type { Studio } from "../studio";
import type { Path, Value } from "../tree";
import { get } from "../tree";
import type { ViewerState } from "../viewer";

const StudioContext = createContext<Studio | null>(null);
export const StudioProvider = StudioContext.Provider;

export function useStudio(): Studio {
    const studio = useContext(StudioContext);
    if (studio === null) throw new Error("drawn outside of the studio");
    return studio;
}

export function useStudioState<T>(part: (state: State) => T): T {
    return useStore(useStudio().store, part);
}

/** What the recipe has at a path: the same object until something in it is changed. */
export function useValueAt(path: Path): Value | undefined {
    return useStudioState(({ document }) => get(document.recipe, path));
}

export function useViewerState<T>(part: (state: ViewerState) => T): T {
    return useStore(useStudio().viewer.store, part);
}

export function useAtlasState<T>(part: (state: AtlasState) => T): T {
    return useStore(useStudio().atlas.store, part);
}
