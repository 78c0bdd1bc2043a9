/** What the reader saves. */

export function save(name: string, content: BlobPart, type: string): void {
    const url = URL.createObjectURL(new Blob([content], { type }));
    const link = document.createElement("a");
    link.href = url;
    link.download = name;
    link.click();
    setTimeout(() => {
        URL.revokeObjectURL(url);
    }, 10_000);
}

/** Characters of a file's name that the server is told, the last ones. */
export const MOST_NAME = 80;

/** What fits in a message to the server, as base64 too. */
export const MOST_BYTES = 6_000_000;
/** Of text as JSON has it; the server takes 8 MiB a message, of which the text is not all. */
const MOST_TEXT_BYTES = 8_000_000;

/** Why so many bytes are not sent; null: they may be. */
export function tooLarge(name: string, bytes: number, what: string): string | null {
    if (bytes <= MOST_BYTES) return null;
    const [has, most] = [bytes, MOST_BYTES].map((n) => (n / 1e6).toFixed(1));
    return `${name} has ${has ?? ""} MB; at most ${most ?? ""} MB can be ${what}.`;
}

/** The same of a text, where what JSON writes by two characters counts twice. */
export function textTooLarge(name: string, text: string): string | null {
    const bytes = new Blob([text]).size;
    const said = tooLarge(name, bytes, "read");
    if (said !== null) return said;
    const written = new Blob([JSON.stringify(text)]).size;
    if (written <= MOST_TEXT_BYTES) return null;
    return `${name} has ${(written / 1e6).toFixed(1)} MB as JSON; at most ${(MOST_TEXT_BYTES / 1e6).toFixed(1)} MB can be read.`;
}

/** A name for a file after what people call the paint. */
export function fileName(name: unknown, ending: string): string {
    const plain =
        typeof name === "string" ? name.toLowerCase().replace(/[^\p{L}\p{N}]+/gu, "-") : "";
    const trimmed = plain.replace(/^-+|-+$/g, "").slice(0, 80);
    return `${trimmed === "" ? "paint" : trimmed}.${ending}`;
}

/** The bytes of a file as base64. */
export function base64Of(file: Blob): Promise<string> {
    return new Promise((resolve, reject) => {
        const reader = new FileReader();
        reader.onload = () => {
            const url = reader.result as string;
            resolve(url.slice(url.indexOf(",") + 1));
        };
        reader.onerror = () => {
            reject(new Error("the browser could not read it"));
        };
        reader.readAsDataURL(file);
    });
}

/** Asks the browser to print a page, which it does on paper or as PDF. */
export function print(html: string): void {
    document.querySelector("iframe.print")?.remove();
    const frame = document.createElement("iframe");
    frame.className = "print";
    frame.title = "Report";
    frame.addEventListener("load", () => {
        frame.contentWindow?.focus();
        frame.contentWindow?.print();
    });
    frame.srcdoc = html;
    document.body.append(frame); // it stays until the next: some browsers print it later
}

export function pngOf(canvas: HTMLCanvasElement): Promise<Blob> {
    return new Promise((resolve, reject) => {
        canvas.toBlob((blob) => {
            if (blob === null) reject(new Error("the browser could not write a PNG"));
            else resolve(blob);
        }, "image/png");
    });
}
