/** The left of the studio: what the paint is made of, from the top down. */

import type { VNode } from "preact";
import { setValue } from "../edit";
import { useStudio, useStudioState } from "../ui/context";
import { More, TableForm } from "./table";

export function Composition(): VNode {
    const studio = useStudio();
    const name = useStudioState((state) => state.document.recipe.name);
    const fault = useStudioState((state) => state.fault);
    const notOpened = useStudioState((state) => state.notOpened);
    const warnings = useStudioState((state) => state.paint?.warnings);
    const wrong = notOpened === null ? fault?.message : `Not opened: ${notOpened}`;
    const said = wrong === undefined ? (warnings ?? []) : [wrong];
    return (
        <section class="composition" aria-label="Composition">
            <div class="paint-name">
                <input
                    type="text"
                    class="name"
                    aria-label="Name of the paint"
                    placeholder="Without a name"
                    value={typeof name === "string" ? name : ""}
                    onChange={(event) => {
                        const text = event.currentTarget.value;
                        studio.edit((document) =>
                            setValue(document, ["name"], text === "" ? undefined : text),
                        );
                    }}
                />
                <More path={[]} />
            </div>
            <div class="form">
                <TableForm path={[]} />
            </div>
            <div class="said-place">
                <div
                    class={wrong === undefined ? "said" : "said wrong"}
                    role="status"
                    aria-label="What the server says of the recipe"
                >
                    {said.map((text) => (
                        <p key={text}>{text}</p>
                    ))}
                </div>
            </div>
        </section>
    );
}
