/** The report of the panel, which the program writes. */

import { fileName, print, save } from "./files";
import type { Studio } from "./studio";

/** @param as  pdf: the browser's way to paper and PDF opens; html: a file is saved */
export function report(studio: Studio, as: "pdf" | "html"): void {
    const { document, settings } = studio.store.get();
    const { geometries, illuminant, observer, model, tolerance } = settings;
    studio.say("Making the report …");
    const asked = studio.connection.ask(
        "report",
        {
            recipe: document.recipe,
            geometries,
            illuminant,
            observer,
            model,
            tolerance: { limit: tolerance },
        },
        (message) => {
            if (message.type === "error") {
                studio.say(String(message.message));
                return;
            }
            const html = String(message.html);
            if (as === "pdf") print(html);
            else save(fileName(document.recipe.name, "html"), html, "text/html");
            studio.say(as === "pdf" ? "The report can be printed." : "The report was saved.");
        },
        (fraction) => {
            studio.say(`Making the report … ${(100 * fraction).toFixed(0)} %`);
        },
        () => {
            studio.say("The server went away before the report was made.");
        },
    );
    if (!asked) studio.say("There is no server to make the report.");
}
