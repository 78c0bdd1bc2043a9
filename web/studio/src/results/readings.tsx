/** The right of the studio: chips against the standard, key figures, and what is behind them. */

import type { ComponentChildren, VNode } from "preact";
import { useRef, useState } from "preact/hooks";
import { number } from "../../../common/dom";
import type { Comparison } from "../protocol";
import { modelTitle } from "../schema";
import { isOld } from "../state";
import { useStudio, useStudioState } from "../ui/context";
import { focusSoon } from "../ui/focus";
import { NumberField } from "../ui/number_field";
import type { Tab } from "../ui/tabs";
import { Tabs } from "../ui/tabs";
import { AtlasPanel } from "./atlas";
import { Chips } from "./chips";
import { Fit } from "./fit";
import { Flop } from "./flop";
import { Numbers } from "./numbers";
import { SparklePanel } from "./sparkle";
import { Spectra } from "./spectra";

/** Dimmed while the paint as it is now has none. */
function OfPaint({ children }: { readonly children: ComponentChildren }): VNode {
    const old = useStudioState(isOld);
    return <div class={old ? "old" : ""}>{children}</div>;
}
const ofPaint = (panel: VNode) => <OfPaint>{panel}</OfPaint>;

const TABS: readonly Tab[] = [
    { name: "flop", title: "Flop", panel: () => ofPaint(<Flop />) },
    { name: "numbers", title: "L*a*b*", panel: () => ofPaint(<Numbers />) },
    { name: "spectra", title: "Spectra", panel: () => ofPaint(<Spectra />) },
    { name: "atlas", title: "Atlas", panel: () => <AtlasPanel /> },
    { name: "sparkle", title: "Sparkle", panel: () => <SparklePanel /> },
    { name: "fit", title: "Fit", panel: () => <Fit /> },
];

export function Results(): VNode {
    const [tab, setTab] = useState("flop");
    return (
        <section class="results" aria-label="Readings">
            <Conditions />
            <StandardBar />
            <Chips />
            <KeyFigures />
            <Tabs label="Details" tabs={TABS} chosen={tab} onChoose={setTab} />
        </section>
    );
}

function Conditions(): VNode {
    const studio = useStudio();
    const schema = useStudioState((state) => state.schema);
    const settings = useStudioState((state) => state.settings);
    const select = (
        label: string,
        value: string,
        names: readonly string[],
        change: (name: string) => void,
        text = (name: string) => name,
    ) => (
        <select
            aria-label={label}
            title={label}
            value={value}
            onChange={(event) => {
                change(event.currentTarget.value);
            }}
        >
            {names.map((name) => (
                <option key={name} value={name}>
                    {text(name)}
                </option>
            ))}
        </select>
    );
    return (
        <div class="conditions">
            {select(
                "Angles",
                settings.geometries,
                (schema?.geometry_sets ?? []).map(({ name }) => name),
                (geometries) => {
                    studio.setSettings({ geometries });
                },
                (name) => {
                    const set = schema?.geometry_sets.find((s) => s.name === name);
                    return `${name}, ${String(set?.geometries.length ?? 0)} angles`;
                },
            )}
            {select("Illuminant", settings.illuminant, schema?.illuminants ?? [], (illuminant) => {
                studio.setSettings({ illuminant });
            })}
            {select(
                "Observer",
                settings.observer,
                schema?.observers ?? [],
                (observer) => {
                    studio.setSettings({ observer });
                },
                (name) => (/^\d+$/.test(name) ? `${name}°` : name),
            )}
            <label
                class="reading-model"
                title="By which chips, plots, atlas and fit are computed. The picture is always by nacre: large flakes make it brighter towards the lamp than micro-flakes are."
            >
                Readings by{" "}
                {select(
                    "Readings by",
                    settings.model,
                    (schema?.reading_models ?? []).map(({ name }) => name),
                    (model) => {
                        studio.setSettings({ model });
                    },
                    (name) => (schema === null ? name : modelTitle(schema, name)),
                )}
            </label>
        </div>
    );
}

function StandardBar(): VNode {
    const studio = useStudio();
    const standard = useStudioState((state) => state.standard);
    const tolerance = useStudioState((state) => state.settings.tolerance);
    const readings = useStudioState((state) => state.readings);
    const file = useRef<HTMLInputElement>(null);
    return (
        <div class="standard">
            <input
                ref={file}
                type="file"
                accept=".csv,.json,text/csv"
                class="hidden"
                tabIndex={-1}
                aria-label="File of a standard"
                onChange={(event) => {
                    const [chosen] = event.currentTarget.files ?? [];
                    event.currentTarget.value = "";
                    if (chosen !== undefined) studio.openStandard(chosen);
                }}
            />
            {standard === null ? (
                <>
                    <button type="button" class="small" onClick={() => file.current?.click()}>
                        Load a standard …
                    </button>
                    <button
                        type="button"
                        class="small"
                        disabled={readings === null}
                        title="The paint as it is now becomes the standard"
                        onClick={() => {
                            if (readings !== null)
                                studio.setStandard(readings.csv, "this paint.csv");
                        }}
                    >
                        Take this paint
                    </button>
                </>
            ) : (
                <>
                    <span class="standard-name" title={standard.name}>
                        Standard: <b>{standard.name}</b>
                    </span>
                    <label>
                        ΔE ≤{" "}
                        <NumberField
                            label="Tolerance, Delta E 2000 at each angle"
                            min={0.01}
                            max={100}
                            step="any"
                            value={tolerance}
                            set={(limit) => {
                                studio.setSettings({ tolerance: limit });
                            }}
                        />
                    </label>
                    <button
                        type="button"
                        class="small"
                        aria-label="Remove the standard"
                        onClick={({ currentTarget: button }) => {
                            studio.setStandard(null, "");
                            const leave = studio.store.subscribe(() => {
                                if (studio.store.get().standard !== null) return;
                                leave();
                                if (document.activeElement === button)
                                    focusSoon(".standard button");
                            });
                        }}
                    >
                        Remove
                    </button>
                </>
            )}
        </div>
    );
}

function KeyFigures(): VNode {
    const readings = useStudioState((state) => state.readings);
    const versus: Comparison | null = readings?.standard ?? null;
    const old = useStudioState(isOld);
    const figure = (name: string, value: string, wide = false) => (
        <div class={wide ? "wide" : ""}>
            <dt>{name}</dt>
            <dd>{value}</dd>
        </div>
    );
    return (
        <dl class={old ? "key-figures old" : "key-figures"}>
            {figure("Flop index", number(readings?.flop_index, 2))}
            {figure("Colour travel", number(readings?.colour_travel.length, 1))}
            {figure("Mean ΔE", number(versus?.mean, 2))}
            {figure("Greatest ΔE", number(versus?.max, 2))}
        </dl>
    );
}
