/** A server of the studio for tests without one: it hears what is sent, and answers when told. */

import type { Schema, ShapeInfo } from "../src/schema";
import type { Socket } from "../src/session";
import type { Table } from "../src/tree";

type Sent = Readonly<Record<string, unknown>>;

export class FakeServer {
    private socket: Socket | null = null;
    private readonly sent: Sent[] = [];
    /** Whether it knows nothing of the page's token. */
    refuses = false;
    private back: () => void = () => undefined;
    /** Settled when a client connects after drop(). */
    reconnected: Promise<void> = Promise.resolve();

    readonly connect = (): Socket => {
        this.socket = {
            onopen: null,
            onclose: null,
            onmessage: null,
            binaryType: "",
            send: (data) => this.sent.push(JSON.parse(data) as Sent),
            close: () => undefined,
        };
        this.back();
        return this.socket;
    };

    open(): void {
        this.socket?.onopen?.();
    }

    drop(): void {
        this.reconnected = new Promise((resolve) => {
            this.back = resolve;
        });
        this.socket?.onclose?.();
    }

    received(type: string): Sent[] {
        return this.sent.filter((message) => message.type === type);
    }

    answer(message: Sent): void {
        this.socket?.onmessage?.({ data: JSON.stringify(message) });
    }

    answerBytes(data: ArrayBuffer): void {
        this.socket?.onmessage?.({ data });
    }

    answerOpen(tree: Table): void {
        const id = this.received("open").at(-1)?.id;
        this.answer({ type: "recipe", id, name: "", toml: "", tree, warnings: [] });
    }

    /** Of the newest paint; what its colours are nobody looks at. */
    answerPaint(): void {
        const asked = this.received("paint").at(-1);
        const id = asked?.id;
        this.answer({ type: "recipe", id, name: "", toml: "", tree: asked?.recipe, warnings: [] });
        this.answer({
            type: "readings",
            id,
            geometries: ["45as15"],
            lab: [[50, 0, 0]],
            rgb: [[0.5, 0.5, 0.5]],
            standard: null,
        });
        this.answer({ type: "done", id });
    }
}

const text = { unit: "", doc: "", required: false } as const;
const number = { kind: "number", unit: "um", doc: "", required: true, min: 0, max: 1e6 } as const;
const fraction = { ...number, unit: "", max: 1, min_excluded: true } as const;

/** With two films, whose outer one tests move. */
export const PAINT: Table = {
    name: "Pearl",
    ior: 1.5,
    layer: [
        {
            thickness_um: 15,
            flakes: [
                {
                    name: "TiO2 on mica",
                    volume_fraction: 0.03,
                    core: { material: "mica", thickness_nm: 500 },
                    coats: [
                        { material: "TiO2_anatase", thickness_nm: 80 },
                        { material: "SiO2", thickness_nm: 20 },
                    ],
                },
            ],
        },
        { thickness_um: 30 },
    ],
    fit: { "layer[1].thickness_um": [20, 40] },
};
export const COAT = "layer[0].flakes[0].coats[1].thickness_nm";

/** As the server describes recipes, but with few of their keys. */
export const SCHEMA: Schema = {
    version: "0",
    recipe: {
        tables: [
            {
                path: "",
                title: "recipe",
                keys: [
                    { key: "name", kind: "text", ...text },
                    { key: "ior", kind: "material", ...text, required: true, choices: "materials" },
                    { key: "layer", kind: "list", ...text },
                    { key: "fit", kind: "table", ...text },
                ],
            },
            {
                path: "layer[]",
                title: "layer",
                keys: [
                    { key: "thickness_um", ...number },
                    { key: "flakes", kind: "list", ...text },
                    { key: "pigment", kind: "list", ...text },
                ],
            },
            {
                path: "layer[].flakes[]",
                title: "flakes",
                keys: [
                    { key: "name", kind: "text", ...text },
                    { key: "volume_fraction", ...fraction },
                    { key: "area_density_per_um", ...number },
                    { key: "d50_um", ...number, typical: 18 },
                    { key: "d10_um", ...number, typical: 8 },
                    { key: "d90_um", ...number, typical: 32 },
                    { key: "diameter_um", ...number, required: false },
                    { key: "core", kind: "table", ...text, required: true },
                    { key: "coats", kind: "list", ...text },
                    { key: "reflectance", ...fraction, kind: "spectrum", typical: 0.5 },
                    { key: "transmittance", ...fraction, kind: "spectrum", required: false },
                ],
                alternatives: [
                    {
                        required: true,
                        each: [
                            { mark: "volume_fraction", keys: ["volume_fraction"] },
                            { mark: "area_density_per_um", keys: ["area_density_per_um"] },
                        ],
                    },
                    {
                        required: false,
                        each: [
                            { mark: "core", keys: ["core", "coats"] },
                            { mark: "reflectance", keys: ["reflectance", "transmittance"] },
                        ],
                    },
                    {
                        required: false,
                        each: [
                            { mark: "diameter_um", keys: ["diameter_um"] },
                            { mark: "d50_um", keys: ["d50_um", "d10_um", "d90_um"] },
                        ],
                    },
                    {
                        required: false,
                        each: [
                            { mark: "", keys: ["d50_um"] },
                            { mark: "d10_um", keys: ["d10_um", "d50_um", "d90_um"] },
                        ],
                    },
                ],
            },
            {
                path: "layer[].flakes[].core",
                title: "core",
                keys: [
                    { key: "material", kind: "material", ...text, required: true },
                    { key: "thickness_nm", ...number, unit: "nm" },
                ],
            },
            {
                path: "layer[].flakes[].coats[]",
                title: "coats",
                keys: [
                    { key: "material", kind: "material", ...text, required: true },
                    { key: "thickness_nm", ...number, unit: "nm" },
                ],
            },
            {
                path: "layer[].pigment[]",
                title: "pigment",
                keys: [
                    { key: "from", kind: "text", ...text, choices: "pigments" },
                    { key: "volume_fraction", ...fraction },
                ],
                alternatives: [],
            },
        ],
    },
    materials: [{ name: "mica", summary: "", rgb: [0.5, 0.5, 0.5] }],
    pigments: [{ name: "chalk", summary: "", rgb: [1, 1, 1] }],
    flakes: [{ name: "Pearl", summary: "", value: { name: "pearl", volume_fraction: 0.03 } }],
    paints: [{ name: "pearl", title: "Pearl", toml: 'name = "Pearl"' }],
    geometry_sets: [{ name: "byk-mac", geometries: ["45as15"] }],
    illuminants: ["D65"],
    observers: ["10"],
    reading_models: [
        { name: "microflake", title: "microflake" },
        { name: "nacre", title: "nacre, as the picture" },
    ],
    reading_model: "microflake",
    shapes: [],
    lights: [],
    mean_model: "microflake",
    start: null,
};

const BALL: ShapeInfo = {
    name: "ball",
    title: "Ball",
    light: "studio",
    transform: { scale: 1, rotation_deg: [0, 0, 0], translation_mm: [0, 0, 0] },
    camera: {
        position_mm: [0, -300, 100],
        target_mm: [0, 0, 0],
        fov_deg: 20,
        aspect: 1,
    },
};
/** With a shape to be seen. */
export const WITH_BALL: Schema = { ...SCHEMA, shapes: [BALL] };
