/** What the reader chose last time; a browser may refuse to keep it, and that is no fault. */

export function remembered(key: string): string | null {
    try {
        return localStorage.getItem(`nacre-${key}`);
    } catch {
        return null;
    }
}

export function remember(key: string, value: string): void {
    try {
        localStorage.setItem(`nacre-${key}`, value);
    } catch {
        // chosen for this visit only
    }
}
