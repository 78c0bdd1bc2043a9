/** A mesh, and light from all around, from files of the reader's. */

import type { Connection } from "./connection";
import { messageOf } from "./errors";
import { base64Of, MOST_NAME, tooLarge } from "./files";
import type { Attachment, Message } from "./protocol";
import { readLight, readMesh } from "./renderer/paint";
import type { LightInfo, ShapeInfo } from "./schema";
import type { OwnFile, State } from "./state";
import type { Store } from "./store";
import type { Viewer } from "./viewer";

/** Files by their endings. */
export const MESH_FILES = ".obj,.ply,.stl,.glb,.gltf";
export const LIGHT_FILES = ".hdr,.exr";
const ending = (list: string) =>
    new RegExp(`(${list.replace(/\./g, "\\.").replace(/,/g, "|")})$`, "i");
const [MESH, LIGHT] = [ending(MESH_FILES), ending(LIGHT_FILES)];

export type OwnKind = "shape" | "light";

/** What a file of this name holds; null: neither. */
export function kindOf(name: string): OwnKind | null {
    return MESH.test(name) ? "shape" : LIGHT.test(name) ? "light" : null;
}

export class OwnFiles {
    constructor(
        private readonly store: Store<State>,
        private readonly viewer: Viewer,
        private readonly connection: Connection,
    ) {}

    /** To a server that knows nothing of them. */
    bringAgain(): void {
        const { ownShape, ownLight } = this.store.get();
        if (ownShape !== null) void this.bring("shape", ownShape.file, ownShape.yUp);
        if (ownLight !== null) void this.bring("light", ownLight.file);
    }

    /** No answer will come. */
    abandon(): void {
        for (const what of ["shape", "light"] as const) this.viewer.hold(what, false);
    }

    /** Shows what a file holds. */
    async bring(what: OwnKind, file: File, yUp = false): Promise<void> {
        const { ownShape, ownLight } = this.store.get();
        const before = what === "shape" ? ownShape : ownLight;
        const large = tooLarge(file.name, file.size, "shown");
        if (large !== null) {
            this.say(large);
            return;
        }
        this.say(`Reading ${file.name} …`);
        this.viewer.hold(what, true);
        try {
            const base64 = await base64Of(file);
            const fields = { file: file.name.slice(-MOST_NAME), base64 };
            const sent = this.connection.ask(
                what,
                what === "shape" ? { ...fields, y_up: yUp } : fields,
                (message, attachments) => {
                    this.viewer.hold(what, false);
                    if (message.type === "error") this.say(String(message.message));
                    else this.brought({ file, yUp, name: "" }, before, message, attachments);
                },
                undefined,
                () => {
                    this.say(`${file.name}: the server went away before it was read.`);
                },
            );
            if (sent) return;
            this.say(`${file.name}: there is no server to read it.`);
        } catch (error) {
            this.say(`${file.name}: ${messageOf(error)}`);
        }
        this.viewer.hold(what, false);
    }

    /** @param before  the one whose place it takes */
    private brought(
        own: OwnFile,
        before: OwnFile | null,
        message: Message,
        attachments: readonly Attachment[],
    ): void {
        const { schema } = this.store.get();
        const data = attachments[0]?.data;
        if (schema === null || data === undefined) return;
        this.store.set({ notOpened: null }); // what was said of a file before
        const bytes = data.buffer as ArrayBuffer;
        const view = this.viewer.store.get().view;
        // Sent again to a server that had gone, it is shown if it was.
        const again = before?.file === own.file;
        if (message.type === "shape") {
            const info = message.shape as ShapeInfo;
            const shapes = [...schema.shapes.filter(({ name }) => name !== before?.name), info];
            const now = { ...schema, shapes };
            this.store.set({ schema: now, ownShape: { ...own, name: info.name } });
            this.viewer.add(now, { mesh: readMesh(bytes) }, info.name);
            if (!again || view?.shape === before.name) {
                this.viewer.setShape(now, info.name, false);
            }
            const [extent, shown] = [message.extent_mm, message.shown_mm].map((mm) =>
                Number(Number(mm).toPrecision(3)),
            );
            const size = `${String(extent)} mm${extent === shown ? "" : `, shown as ${String(shown)} mm`}`;
            this.say(`${own.file.name}: ${String(message.triangles)} triangles, ${size}.`);
        } else {
            const info = message.light as LightInfo;
            const lights = [...schema.lights.filter(({ name }) => name !== before?.name), info];
            const now = { ...schema, lights };
            this.store.set({ schema: now, ownLight: { ...own, name: info.name } });
            this.viewer.add(now, { light: readLight(bytes) }, info.name);
            if (!again || view?.light === before.name) this.viewer.setView({ light: info.name });
            const size = `${String(message.width)} x ${String(message.height)} pixels`;
            this.say(
                `${own.file.name}: ${size}, a white panel that lies flat is white. ${String(message.note)}`,
            );
        }
    }

    private say(notice: string): void {
        this.store.set({ notice });
    }
}
