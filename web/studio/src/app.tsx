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

function useKeysAndDrops(studio: Studio): void {
    useEffect(() => {
        const keys = (event: KeyboardEvent) => {
            if (!(event.ctrlKey || event.metaKey) || typing(event.target)) return;
            const key = event.key.toLowerCase();
            if (key === "z" && !event.shiftKey) studio.undo();
            else if (key === "y" || key === "z") studio.redo();
            else return;
            event.preventDefault();
        };
        const over = (event: DragEvent) => {
            event.preventDefault();
        };
        const drop = (event: DragEvent) => {
            event.preventDefault();
            const file = event.dataTransfer?.files[0];
            if (file === undefined) return;
            void file.text().then((text) => {
                if (/\.(csv|json)$/i.test(file.name)) studio.setStandard(text, file.name);
                else studio.openText(text);
            });
        };
        const paste = (event: ClipboardEvent) => {
            const text = event.clipboardData?.getData("text") ?? "";
            if (typing(event.target) || !text.includes("=")) return;
            event.preventDefault();
            studio.openText(text);
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
        gone: "The studio's program has gone: is it still running? Your paint is safe in this page and in its address; it goes on when the program is back.",
    }[connection];
    return (
        <footer class={connection === "gone" ? "status gone" : "status"}>
            <span role="status" aria-live="polite">
                {said === "" ? notice : said}
            </span>
            <span class="gap" />
            <span class="latency" title="From the last change to its colours on the screen">
                {latency === null ? "" : `${number(latency, 0)} ms`}
            </span>
            <span>{version === undefined ? "" : `Nacre ${version}`}</span>
        </footer>
    );
}
