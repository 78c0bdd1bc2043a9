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
