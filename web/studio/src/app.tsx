import type { VNode } from "preact";
import { useEffect } from "preact/hooks";
import { number } from "../../common/dom";
import { Composition } from "./composition/composition";
import { PicturePanel } from "./picture/picture";
import { Results } from "./results/readings";
import type { Studio } from "./studio";
import { Top } from "./top";
import { StudioProvider, useStudioState } from "./ui/context";

/** Text that is typed into has an undo of its own. */
function typing(target: EventTarget | null): boolean {
    return target instanceof HTMLInputElement && !["range", "checkbox"].includes(target.type);
}

/** A number that nobody has begun to change has nothing to be undone: the paint has. */
function hasDraft(target: EventTarget | null): boolean {
    return typing(target) && (target as HTMLElement).dataset.draft !== "false";
}

function useKeysAndDrops(studio: Studio): void {
    useEffect(() => {
        const keys = (event: KeyboardEvent) => {
            if (!(event.ctrlKey || event.metaKey) || hasDraft(event.target)) return;
            const key = event.key.toLowerCase();
            if (key === "z" && !event.shiftKey) studio.undo();
            else if (key === "y" || key === "z") studio.redo();
            else return;
            event.preventDefault();
        };
        const over = (event: DragEvent) => {
            if (!typing(event.target) || event.dataTransfer?.types.includes("Files") === true)
                event.preventDefault();
        };
        const drop = (event: DragEvent) => {
            const file = event.dataTransfer?.files[0];
            const text = event.dataTransfer?.getData("text") ?? "";
            if (file === undefined && typing(event.target)) return;
            event.preventDefault();
            if (file !== undefined) studio.openFile(file);
            else if (text.includes("=")) studio.openPasted(text);
        };
        const paste = (event: ClipboardEvent) => {
            const text = event.clipboardData?.getData("text") ?? "";
            if (typing(event.target) || !text.includes("=")) return;
            event.preventDefault();
            studio.openPasted(text);
        };
        const hash = () => {
            void studio.openLink(location.hash);
        };
        document.addEventListener("keydown", keys);
        document.addEventListener("dragover", over);
        document.addEventListener("drop", drop);
        document.addEventListener("paste", paste);
        addEventListener("hashchange", hash);
        return () => {
            document.removeEventListener("keydown", keys);
            document.removeEventListener("dragover", over);
            document.removeEventListener("drop", drop);
            document.removeEventListener("paste", paste);
            removeEventListener("hashchange", hash);
        };
    }, [studio]);
}

export function App({ studio }: { readonly studio: Studio }): VNode {
    useKeysAndDrops(studio);
    return (
        <StudioProvider value={studio}>
            <Top />
            <main class="studio">
                <Composition />
                <PicturePanel />
                <Results />
            </main>
            <StatusLine />
        </StudioProvider>
    );
}

function StatusLine(): VNode {
    const connection = useStudioState((state) => state.connection);
    const latency = useStudioState((state) => state.latency_ms);
    const notice = useStudioState((state) => state.notice);
    const version = useStudioState((state) => state.schema?.version);
    const said = {
        connecting: "Connecting …",
        open: "",
        gone: "The studio's program does not answer: has it ended? The paint is safe in this page, which goes on when the same program answers again.",
        refused:
            "Another nacre studio answers here, which does not know this page. Open the address that it printed, and paste the paint there: Copy link has it.",
    }[connection];
    return (
        <footer class={said === "" || connection === "connecting" ? "status" : "status gone"}>
            <span class="notice" role="status" aria-live="polite">
                <span>{said === "" ? notice : said}</span>
            </span>
            <span class="latency" title="From the last change to its colours on the screen">
                {latency === null ? "" : `${number(latency, 0)} ms`}
            </span>
            <span>{version === undefined ? "" : `Nacre ${version}`}</span>
        </footer>
    );
}
