/** Where the keyboard goes when what it was on has gone or moved. */

/** @param selectors  of what takes it once the page has been drawn: the first that is there */
export function focusSoon(...selectors: readonly string[]): void {
    setTimeout(() => {
        for (const selector of selectors) {
            const element = document.querySelector<HTMLElement>(selector);
            if (element === null || element.matches(":disabled")) continue;
            element.focus();
            return;
        }
    });
}
