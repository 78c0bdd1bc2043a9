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

export function pngOf(canvas: HTMLCanvasElement): Promise<Blob> {
    return new Promise((resolve, reject) => {
        canvas.toBlob((blob) => {
            if (blob === null) reject(new Error("the browser could not write a PNG"));
            else resolve(blob);
        }, "image/png");
    });
}
