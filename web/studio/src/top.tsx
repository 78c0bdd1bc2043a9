/** The bar at the top: opening, undoing, saving. */

import type { VNode } from "preact";
import { useMemo, useRef } from "preact/hooks";
import { themeButton } from "../../common/theme";
import { fileName, save } from "./files";
import { LIGHT_FILES, MESH_FILES } from "./own_files";
import { PictureFile } from "./picture_file";
import { report } from "./report";
import type { State } from "./state";
import { useStudio, useStudioState } from "./ui/context";
import { Made } from "./ui/element";
import { IconButton } from "./ui/icons";
import { Picker } from "./ui/picker";

export function Top(): VNode {
    const studio = useStudio();
    const schema = useStudioState((state) => state.schema);
    const canUndo = useStudioState((state) => state.canUndo);
    const canRedo = useStudioState((state) => state.canRedo);
    const theme = useMemo(() => themeButton(), []);
    const file = useRef<HTMLInputElement>(null);
    return (
        <header class="top">
            <h1>
                Nacre <span>Studio</span>
            </h1>
            <Picker
                label="Start from a paint that ships"
                text="Start from …"
                class="start"
                chosen={null}
                choices={schema?.paints ?? []}
                onChoose={(name) => {
                    const paint = schema?.paints.find((p) => p.name === name);
                    if (paint !== undefined) studio.openText(paint.toml);
                }}
            />
            <button type="button" onClick={() => file.current?.click()}>
                Open …
            </button>
            <input
                ref={file}
                type="file"
                accept={`.toml,.csv,.json,${MESH_FILES},${LIGHT_FILES},application/toml,text/plain`}
                class="hidden"
                tabIndex={-1}
                aria-label="File of a recipe, a standard, a mesh or a light"
                onChange={(event) => {
                    const [chosen] = event.currentTarget.files ?? [];
                    event.currentTarget.value = "";
                    if (chosen !== undefined) studio.openFile(chosen);
                }}
            />
            <span class="pair">
                <IconButton
                    icon="undo"
                    label="Undo (Ctrl+Z)"
                    disabled={!canUndo}
                    onClick={() => {
                        studio.undo();
                    }}
                />
                <IconButton
                    icon="redo"
                    label="Redo (Ctrl+Y)"
                    disabled={!canRedo}
                    onClick={() => {
                        studio.redo();
                    }}
                />
            </span>
            <span class="gap" />
            <Saving />
            <Made element={theme} />
        </header>
    );
}

function Saving(): VNode {
    const studio = useStudio();
    // Not while the server has yet to answer: buttons that go out and on with each move would flicker.
    const sound = useStudioState(
        ({ readings, readingsOf, document, fault }) =>
            readings !== null && (fault === null || readingsOf === document),
    );
    const nameOf = ({ document }: State) => document.recipe.name;
    const picture = useMemo(() => new PictureFile(studio), [studio]);
    return (
        <span class="saving">
            <button
                type="button"
                disabled={!sound}
                title="Save the recipe, .toml"
                onClick={() => {
                    studio.whenCurrent((state) => {
                        const toml = state.paint?.toml ?? "";
                        save(fileName(nameOf(state), "toml"), toml, "application/toml");
                    });
                }}
            >
                Save recipe
            </button>
            <button
                type="button"
                disabled={!sound}
                title="Save the path tracer's picture, .png"
                onClick={() => {
                    picture.save();
                }}
            >
                Picture
            </button>
            <button
                type="button"
                disabled={!sound}
                title="Save the readings, .csv"
                onClick={() => {
                    studio.whenCurrent((state) => {
                        const csv = state.readings?.csv ?? "";
                        // The table itself does not say by which model it was read.
                        const ending = `${state.readingsBy?.model ?? ""}.csv`;
                        save(fileName(nameOf(state), ending), csv, "text/csv");
                    });
                }}
            >
                Readings
            </button>
            <button
                type="button"
                disabled={!sound}
                title="Print the report of the panel, or save it as PDF"
                onClick={() => {
                    report(studio, "pdf");
                }}
            >
                Report
            </button>
            <button
                type="button"
                disabled={!sound}
                aria-label="Report as HTML"
                title="Save the report of the panel, .html"
                onClick={() => {
                    report(studio, "html");
                }}
            >
                HTML
            </button>
            <button
                type="button"
                title="Copy an address that holds this paint"
                onClick={() => {
                    studio.copyLink();
                }}
            >
                Copy link
            </button>
        </span>
    );
}
