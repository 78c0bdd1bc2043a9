/** Light or dark greys: the system's choice until the reader makes one. */

import { h } from "./dom";
import { remember, remembered } from "./memory";

function isDark(): boolean {
    const chosen = document.documentElement.dataset.theme;
    if (chosen !== undefined) return chosen === "dark";
    return matchMedia("(prefers-color-scheme: dark)").matches;
}

export function themeButton(): HTMLElement {
    const button = h("button", { type: "button", class: "theme" });
    const kept = remembered("theme");
    if (kept === "light" || kept === "dark") document.documentElement.dataset.theme = kept;
    const show = () => {
        button.textContent = isDark() ? "Light" : "Dark";
        button.setAttribute("aria-label", `Use ${isDark() ? "light" : "dark"} greys`);
    };
    button.addEventListener("click", () => {
        const theme = isDark() ? "light" : "dark";
        document.documentElement.dataset.theme = theme;
        remember("theme", theme);
        show();
    });
    matchMedia("(prefers-color-scheme: dark)").addEventListener("change", show);
    show();
    return button;
}
