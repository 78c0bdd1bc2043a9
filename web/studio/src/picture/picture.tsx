/** The middle of the studio: the picture, its shape and light, and A beside B. */

import type { VNode } from "preact";
import { useEffect, useLayoutEffect, useRef, useState } from "preact/hooks";
import { caveatsText } from "../gamut";
import { orbitOf, turned, wrapped } from "../orbit";
import { LIGHT_FILES, MESH_FILES } from "../own_files";
import { isOld } from "../state";
import { useStudio, useStudioState, useViewerState } from "../ui/context";
import type { Picture, View } from "../viewer";
import { covers, isCurrent, isKeptBehind, keptText } from "../viewer";

export function PicturePanel(): VNode {
    return (
        <section class="picture-panel" aria-label="Picture">
            <PictureBar />
            <Canvas />
            <PictureFoot />
        </section>
    );
}

function PictureBar(): VNode {
    const studio = useStudio();
    const schema = useStudioState((state) => state.schema);
    const view = useViewerState((state) => state.view);
    const kept = useViewerState((state) => state.keptRecipe);
    const own = useStudioState((state) => state.ownShape);
    return (
        <div class="picture-bar">
            <Choice
                label="Shape"
                chosen={view?.shape ?? ""}
                entries={schema?.shapes ?? []}
                own={{ text: "Own mesh …", files: MESH_FILES }}
                choose={(name) => {
                    if (schema !== null) studio.viewer.setShape(schema, name, false);
                }}
                bring={(file) => void studio.ownFiles.bring("shape", file)}
            />
            {own !== null && own.name === view?.shape && !/\.gl(tf|b)$/i.test(own.file.name) && (
                <button
                    type="button"
                    class="small"
                    aria-pressed={own.yUp}
                    title="The file's vertical is y, not z"
                    onClick={() => void studio.ownFiles.bring("shape", own.file, !own.yUp)}
                >
                    Y up
                </button>
            )}
            <Choice
                label="Light"
                chosen={view?.light ?? ""}
                entries={schema?.lights ?? []}
                own={{ text: "Own HDR …", files: LIGHT_FILES }}
                choose={(light) => {
                    studio.viewer.setView({ light });
                }}
                bring={(file) => void studio.ownFiles.bring("light", file)}
            />
            <button
                type="button"
                title="Turn back to where the shape began"
                onClick={() => {
                    const shape = schema?.shapes.find(({ name }) => name === view?.shape);
                    if (shape === undefined) return;
                    studio.viewer.setView({
                        camera: orbitOf(shape),
                        turn_deg: 0,
                        light_turn_deg: 0,
                    });
                }}
            >
                Front
            </button>
            <span class="gap" />
            <button
                type="button"
                aria-pressed={kept !== null}
                title={
                    kept === null
                        ? "Keep the paint as it is now as A, and see changes beside it"
                        : "Stop comparing"
                }
                onClick={() => {
                    const { recipe } = studio.store.get().document;
                    studio.viewer.keep(kept === null ? recipe : null);
                }}
            >
                {kept === null ? "Keep as A" : "A | B"}
            </button>
            {kept !== null && (
                <button
                    type="button"
                    title="Make A the paint again; the present one can be had back by undo"
                    onClick={() => {
                        studio.useMatch(kept);
                    }}
                >
                    Back to A
                </button>
            )}
        </div>
    );
}

/** What there is to choose from, and at the end a file of the reader's. */
function Choice(props: {
    readonly label: string;
    readonly chosen: string;
    readonly entries: readonly { readonly name: string; readonly title: string }[];
    readonly own: { readonly text: string; readonly files: string };
    readonly choose: (name: string) => void;
    readonly bring: (file: File) => void;
}): VNode {
    const { label, chosen, entries, own } = props;
    const file = useRef<HTMLInputElement>(null);
    return (
        <>
            <select
                aria-label={label}
                title={entries.find(({ name }) => name === chosen)?.title}
                value={chosen}
                onChange={(event) => {
                    const { value } = event.currentTarget;
                    event.currentTarget.value = chosen;
                    if (value === "") file.current?.click();
                    else props.choose(value);
                }}
            >
                {entries.map(({ name, title }) => (
                    <option key={name} value={name}>
                        {title}
                    </option>
                ))}
                <option value="">{own.text}</option>
            </select>
            <input
                ref={file}
                type="file"
                accept={own.files}
                class="hidden"
                tabIndex={-1}
                aria-label={own.text.replace(" …", "")}
                onChange={(event) => {
                    const [brought] = event.currentTarget.files ?? [];
                    event.currentTarget.value = "";
                    if (brought !== undefined) props.bring(brought);
                }}
            />
        </>
    );
}

/** Degrees of turning by a pixel of dragging, and by a press of an arrow key. */
const DEGREES_PER_PIXEL = 0.4;
const DEGREES_PER_KEY = 5;

function draw(canvas: HTMLCanvasElement | null, picture: Picture | null): void {
    const context = canvas?.getContext("2d");
    if (canvas === null || context === null || context === undefined) return;
    if (picture === null) {
        context.clearRect(0, 0, canvas.width, canvas.height);
        return;
    }
    if (canvas.width !== picture.width || canvas.height !== picture.height) {
        canvas.width = picture.width;
        canvas.height = picture.height;
    }
    const pixels = picture.pixels as Uint8ClampedArray<ArrayBuffer>;
    context.putImageData(new ImageData(pixels, picture.width, picture.height), 0, 0);
}

function Canvas(): VNode {
    const studio = useStudio();
    const place = useRef<HTMLDivElement>(null);
    const canvas = useRef<HTMLCanvasElement>(null);
    const keptCanvas = useRef<HTMLCanvasElement>(null);
    const liveCanvas = useRef<HTMLCanvasElement>(null);
    const ready = useStudioState((state) => state.schema !== null);
    const covered = useViewerState(covers);
    const picture = useViewerState((state) => state.picture);
    const kept = useViewerState((state) => state.kept);
    const keptRecipe = useViewerState((state) => state.keptRecipe);
    const behind = useViewerState(isKeptBehind);
    const view = useViewerState((state) => state.view);
    const name = useStudioState((state) => state.document.recipe.name);
    const old = useStudioState(isOld);
    const [wipe, setWipe] = useState(0.5);
    const drag = useRef<{ x: number; y: number } | null>(null);
    const wiping = useRef(false);

    useEffect(() => {
        const element = place.current;
        if (element === null) return;
        const observer = new ResizeObserver(() => {
            studio.viewer.resize(element.clientWidth, element.clientHeight);
        });
        observer.observe(element);
        return () => {
            observer.disconnect();
        };
    }, [studio]);
    useEffect(() => {
        if (ready && liveCanvas.current !== null) studio.attach(liveCanvas.current);
    }, [studio, ready]);
    useLayoutEffect(() => {
        draw(canvas.current, picture);
    }, [picture]);
    useLayoutEffect(() => {
        draw(keptCanvas.current, kept);
    }, [kept]);

    const turn = (right: number, up: number, light: boolean, nearer = 1) => {
        if (view === null) return;
        const change: Partial<View> = light
            ? { light_turn_deg: wrapped(view.light_turn_deg + right) }
            : {
                  turn_deg: wrapped(view.turn_deg + right),
                  camera: turned(view.camera, up, nearer),
              };
        studio.viewer.setView(change);
    };
    const keys = (event: KeyboardEvent) => {
        const by: Record<string, readonly [number, number, number]> = {
            ArrowLeft: [-DEGREES_PER_KEY, 0, 1],
            ArrowRight: [DEGREES_PER_KEY, 0, 1],
            ArrowUp: [0, DEGREES_PER_KEY, 1],
            ArrowDown: [0, -DEGREES_PER_KEY, 1],
            "+": [0, 0, 1.2],
            "-": [0, 0, 1 / 1.2],
        };
        const step = by[event.key];
        if (step === undefined) return;
        event.preventDefault();
        turn(step[0], step[1], event.shiftKey, step[2]);
    };
    const shown = `${typeof name === "string" ? name : "The paint"}, ${view?.shape ?? ""}, ${view?.light ?? ""}`;
    return (
        <div class={old ? "picture stage old-paint" : "picture stage"} ref={place}>
            <div
                class="turnable"
                role="application"
                tabIndex={0}
                aria-label={`Picture: ${shown}. Arrow keys turn the shape, with Shift the light; plus and minus bring it nearer.`}
                onKeyDown={keys}
                onPointerDown={(event) => {
                    if (event.button !== 0) return;
                    event.currentTarget.setPointerCapture(event.pointerId);
                    drag.current = { x: event.clientX, y: event.clientY };
                }}
                onPointerMove={(event) => {
                    const from = drag.current;
                    if (from === null) return;
                    const right = (event.clientX - from.x) * DEGREES_PER_PIXEL;
                    const up = (event.clientY - from.y) * DEGREES_PER_PIXEL;
                    drag.current = { x: event.clientX, y: event.clientY };
                    turn(right, up, event.shiftKey);
                }}
                onPointerUp={() => {
                    drag.current = null;
                }}
                onPointerCancel={() => {
                    drag.current = null;
                }}
                onWheel={(event) => {
                    event.preventDefault();
                    turn(0, 0, false, Math.exp(-event.deltaY / 600));
                }}
            >
                <canvas ref={liveCanvas} class={covered ? "live" : "live now"} />
                <canvas
                    ref={canvas}
                    class={covered ? "traced now" : "traced"}
                    width="16"
                    height="16"
                />
                {keptRecipe !== null && (
                    <div
                        class={behind ? "wiped behind" : "wiped"}
                        style={{ clipPath: `inset(0 ${String(100 - 100 * wipe)}% 0 0)` }}
                    >
                        <canvas ref={keptCanvas} width="16" height="16" />
                    </div>
                )}
            </div>
            {keptRecipe !== null && (
                <>
                    <span class="side a">{behind ? "A, as it was seen before" : "A"}</span>
                    <span class="side b">B</span>
                    <div
                        class="wipe-line"
                        style={{ left: `${String(100 * wipe)}%` }}
                        onPointerDown={(event) => {
                            if (event.button !== 0) return;
                            event.currentTarget.setPointerCapture(event.pointerId);
                            wiping.current = true;
                        }}
                        onPointerMove={(event) => {
                            const box = place.current?.getBoundingClientRect();
                            if (!wiping.current || box === undefined) return;
                            const at = (event.clientX - box.left) / box.width;
                            setWipe(Math.min(Math.max(at, 0), 1));
                        }}
                        onPointerUp={() => {
                            wiping.current = false;
                        }}
                        onPointerCancel={() => {
                            wiping.current = false;
                        }}
                    />
                    <input
                        class="wipe"
                        type="range"
                        min="0"
                        max="1"
                        step="0.01"
                        value={wipe}
                        aria-label="Wipe between A, kept, and B, as it is now"
                        onInput={(event) => {
                            setWipe(Number(event.currentTarget.value));
                        }}
                    />
                </>
            )}
        </div>
    );
}

function PictureFoot(): VNode {
    const picture = useViewerState((state) => state.picture);
    const fault = useViewerState((state) => state.fault);
    const noLive = useViewerState((state) => state.noLive);
    const readings = useStudioState((state) => state.readings);
    const old = useStudioState(isOld);
    const outside = readings === null ? "" : caveatsText(readings);
    const live = useViewerState((state) => state.liveSamples);
    const covered = useViewerState(covers);
    const current = useViewerState(isCurrent);
    const warn = useViewerState((state) => state.gamutWarning);
    const sparkle = useViewerState((state) => state.view?.sparkle ?? true);
    const kept = useViewerState((state) => (state.keptRecipe === null ? null : keptText(state)));
    const studio = useStudio();
    // Drafts have one sample.
    const traced =
        picture !== null && picture.of > 1 && (current || live === null) ? picture : null;
    const of = traced === null ? "" : `${String(traced.samples)} of ${String(traced.of)}`;
    const b =
        live !== null && !covered
            ? `Live${traced === null ? "" : `, path traced ${of}`}`
            : traced !== null
              ? `Path traced, ${of}`
              : picture === null
                ? "No picture yet"
                : "Draft";
    const now = old ? `Of the paint before: ${b}` : b;
    const samples = kept === null ? now : `${now}; A: ${kept}`;
    return (
        <div class="picture-foot">
            <span
                class="how-far"
                title={
                    fault ??
                    (noLive === null
                        ? `${samples}. Samples a pixel of the path tracer's picture`
                        : `No live picture: ${noLive}`)
                }
            >
                {fault ?? (noLive === null ? samples : `${samples}; no live picture`)}
            </span>
            <progress
                max={traced?.of ?? 1}
                value={traced?.samples ?? 0}
                aria-label="Samples of the picture"
            />
            <label title="Single flakes, or their mean">
                <input
                    type="checkbox"
                    checked={sparkle}
                    onChange={(event) => {
                        studio.viewer.setView({ sparkle: event.currentTarget.checked });
                    }}
                />{" "}
                Sparkle
            </label>
            {live !== null && (
                <label title="Colours outside of sRGB, in the live picture">
                    <input
                        type="checkbox"
                        checked={warn}
                        onChange={(event) => {
                            studio.viewer.setGamutWarning(event.currentTarget.checked);
                        }}
                    />{" "}
                    Mark
                </label>
            )}
            <span
                class={old ? "gamut old" : "gamut"}
                role="status"
                title={
                    outside === ""
                        ? ""
                        : `${outside}, of ${String(readings?.lab.length ?? 0)} angles: marked by ! and ↑ at the chips`
                }
            >
                {outside}
            </span>
        </div>
    );
}
