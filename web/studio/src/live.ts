/** The live picture: what the server sends, handed to the renderer. */

import { fitted } from "./orbit";
import type { Attachment, Message } from "./protocol";
import { LiveView } from "./renderer/live_view";
import type { Light, Mesh } from "./renderer/paint";
import { readFilms, readLight, readMesh, readPaint } from "./renderer/paint";
import type { Schema } from "./schema";
import type { Picture, View } from "./viewer";

/** Texels around the horizon of what shines from all sides. */
const LIGHT_WIDTH = 512;

/** What is sent once: it outlives a live picture whose graphics processor was lost. */
export class Received {
    readonly texts = new Map<string, string>();
    readonly meshes = new Map<string, Promise<Mesh>>();
    readonly lights = new Map<string, Promise<Light>>();

    /** What the reader brought along, and is not asked of the server. */
    add(own: { readonly mesh?: Mesh; readonly light?: Light }, name: string): void {
        if (own.mesh !== undefined) this.meshes.set(name, Promise.resolve(own.mesh));
        if (own.light !== undefined) this.lights.set(name, Promise.resolve(own.light));
    }
}

export class Live {
    private readonly view: LiveView;
    private shape = "";
    private light = "";

    /**
     * @param bytes  what the server has at an address
     * @throws Error where the browser cannot draw it
     */
    constructor(
        private readonly canvas: HTMLCanvasElement,
        private schema: Schema,
        private readonly bytes: (path: string) => Promise<ArrayBuffer>,
        private readonly received: Received,
        onChange: (samples: number) => void,
        onFilmsWanted: () => void,
        private readonly onFault: (message: string) => void,
    ) {
        this.view = new LiveView(canvas, {
            onChange: ({ samples }) => {
                onChange(samples);
            },
            onFilmsWanted,
            onFault,
        });
    }

    /** One that names what the reader brought along. */
    setSchema(schema: Schema): void {
        this.schema = schema;
    }

    show(view: View, width: number, height: number): void {
        const shape = this.schema.shapes.find(({ name }) => name === view.shape);
        if (shape === undefined || width * height === 0) return;
        if (this.shape !== view.shape) {
            this.shape = view.shape;
            const mesh = known(this.received.meshes, view.shape, () =>
                this.bytes(`/api/shape/${encodeURIComponent(view.shape)}`).then(readMesh),
            );
            this.when(mesh, (ready) => {
                if (this.shape === view.shape) this.view.setShape(ready, shape.transform);
            });
        }
        if (this.light !== view.light) {
            this.light = view.light;
            const light = known(this.received.lights, view.light, () =>
                this.bytes(
                    `/api/light/${encodeURIComponent(view.light)}?width=${String(LIGHT_WIDTH)}`,
                ).then(readLight),
            );
            this.when(light, (ready) => {
                if (this.light === view.light) this.view.setLight(ready);
            });
        }
        this.view.resize(width, height);
        const camera = fitted(view.camera, width, height);
        this.view.setCamera({ ...camera, target_mm: shape.camera.target_mm });
        this.view.turn("shape", view.turn_deg);
        this.view.turn("light", view.light_turn_deg);
        this.view.setSparkle(view.sparkle);
    }

    /** A message `shader`. @return whether the paint can be drawn */
    setPaint(message: Message, attachments: readonly Attachment[]): boolean {
        if (message.problem !== undefined) return false;
        this.view.setPaint(readPaint(message, attachments, this.received.texts));
        return true;
    }

    /** A message `films` of the paint that is drawn. */
    setFilms(message: Message, attachments: readonly Attachment[]): void {
        this.view.setFilms(readFilms(message, attachments));
    }

    pause(paused: boolean): void {
        if (paused) this.view.pause();
        else this.view.resume();
    }

    hold(held: boolean): void {
        this.view.hold(held);
    }

    setGamutWarning(warn: boolean): void {
        this.view.setGamutWarning(warn);
    }

    /** What is drawn now. */
    snapshot(): Pick<Picture, "width" | "height" | "pixels" | "samples" | "of"> | null {
        const { width, height } = this.canvas;
        const copy = document.createElement("canvas");
        copy.width = width;
        copy.height = height;
        const context = copy.getContext("2d");
        if (context === null) return null;
        context.drawImage(this.canvas, 0, 0);
        const pixels = context.getImageData(0, 0, width, height).data;
        return { width, height, pixels, samples: 0, of: 0 };
    }

    private when<T>(promise: Promise<T>, then: (value: T) => void): void {
        promise.then(then).catch((error: unknown) => {
            this.onFault(error instanceof Error ? error.message : String(error));
        });
    }
}

function known<T>(all: Map<string, Promise<T>>, name: string, make: () => Promise<T>): Promise<T> {
    const promise = all.get(name) ?? make();
    all.set(name, promise);
    promise.catch(() => all.delete(name)); // to be asked for again
    return promise;
}
