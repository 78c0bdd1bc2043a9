/** From the standard back to composition: which numbers are free, how it goes, and what was found. */

import type { VNode } from "preact";
import { chip } from "../../../common/colour";
import { number } from "../../../common/dom";
import type { Match, Readings } from "../protocol";
import type { Parameter } from "../schema";
import { labelOf, modelTitle, parameters, placeText, plain } from "../schema";
import type { Table } from "../tree";
import { parsePath, pathText } from "../tree";
import { useStudio, useStudioState } from "../ui/context";
import { NumberField } from "../ui/number_field";
import { standardAt } from "./chips";

/** As the server has it. */
const MOST_STARTS = 64;

/** What a colourist turns first: free until it is said otherwise. */
const USUAL = new Set(["volume_fraction", "alpha"]);

function usual({ path, info }: Parameter): boolean {
    const coat = info.key === "thickness_nm" && path.includes("coats");
    return path[0] === "layer" && (coat || USUAL.has(info.key));
}

/** Nothing to be found from a 0, of which nothing says how large it may become. */
function canBeFree({ path, value }: Parameter, recipe: Table): boolean {
    const bounds = recipe.fit;
    const bounded = typeof bounds === "object" && pathText(path) in bounds;
    return path[0] !== "fit" && path[0] !== "uncertainty" && (value !== 0 || bounded);
}

export function Fit(): VNode {
    const schema = useStudioState((state) => state.schema);
    const document = useStudioState((state) => state.document);
    const standard = useStudioState((state) => state.standard);
    const fit = useStudioState((state) => state.fit);
    const model = useStudioState((state) => state.settings.model);
    const studio = useStudio();
    const setup = useStudioState((state) => state.fitSetup);
    const { said, starts } = setup;
    if (schema === null || standard === null) {
        return (
            <p class="empty">
                Load a standard first: measured readings as CSV. The fit then turns numbers of this
                paint until its colours match.
            </p>
        );
    }
    const { recipe, locks } = document;
    const all = parameters(schema, recipe).filter((parameter) => canBeFree(parameter, recipe));
    const isFree = (parameter: Parameter) => {
        const key = pathText(parameter.path);
        return !locks.has(key) && (said.get(key) ?? usual(parameter));
    };
    const free = all.filter(isFree).map(({ path }) => pathText(path));
    return (
        <div class="fit">
            <p class="fit-start">
                {fit.running ? (
                    <button
                        type="button"
                        onClick={() => {
                            studio.stopFit();
                        }}
                    >
                        Stop
                    </button>
                ) : (
                    <button
                        type="button"
                        disabled={free.length === 0}
                        onClick={() => {
                            studio.fit(free, starts);
                        }}
                    >
                        Fit {String(free.length)} {free.length === 1 ? "number" : "numbers"}
                    </button>
                )}
                <label>
                    from{" "}
                    <NumberField
                        label="Starts"
                        min={1}
                        max={MOST_STARTS}
                        step="1"
                        value={starts}
                        disabled={fit.running}
                        set={(n) => {
                            studio.store.set({ fitSetup: { ...setup, starts: n } });
                        }}
                    />{" "}
                    {starts === 1 ? "start" : "starts"}
                </label>
                <progress
                    max="1"
                    value={fit.fraction}
                    aria-label="Progress of the fit"
                    class={fit.running ? "" : "idle"}
                />
            </p>
            {fit.fault !== null && (
                <p class="fault-line" role="alert">
                    {fit.fault}
                </p>
            )}
            {fit.skipped.length > 0 && (
                <p class="found-by" role="status">
                    Left as they are, since they do not change the colours: {fit.skipped.join("; ")}
                    .
                </p>
            )}
            {fit.matches !== null && fit.model !== model && (
                <p class="found-by">Found and read by {modelTitle(schema, fit.model)}.</p>
            )}
            {fit.matches !== null && <Matches matches={fit.matches} colours={fit.colours} />}
            <fieldset disabled={fit.running}>
                <legend>Free numbers</legend>
                {all.map((parameter) => {
                    const key = pathText(parameter.path);
                    const { label, unit } = labelOf(parameter.info.key);
                    return (
                        <label key={key} class="free">
                            <input
                                type="checkbox"
                                checked={isFree(parameter)}
                                disabled={locks.has(key)}
                                onChange={(event) => {
                                    const ticked = event.currentTarget.checked;
                                    const now = new Map(said).set(key, ticked);
                                    studio.store.set({ fitSetup: { ...setup, said: now } });
                                }}
                            />
                            <span>
                                {label}
                                <small>{placeText(recipe, parameter.path)}</small>
                            </span>
                            <b>
                                {locks.has(key) ? "locked, " : ""}
                                {plain(parameter.value)} {unit}
                            </b>
                        </label>
                    );
                })}
            </fieldset>
        </div>
    );
}

function Matches(props: {
    readonly matches: readonly Match[];
    readonly colours: readonly Readings[];
}): VNode {
    const studio = useStudio();
    const recipe = useStudioState((state) => state.document.recipe);
    return (
        <ol class="matches" aria-label="Paints that were found">
            {props.matches.map((match, i) => (
                <li key={i} class={match.recipe === recipe ? "used" : ""}>
                    <div class="match-head">
                        <b>Mean ΔE {number(match.mean_delta_e, 2)}</b>
                        <span>greatest {number(match.max_delta_e, 2)}</span>
                        <button
                            type="button"
                            class="small"
                            aria-label={`Use match ${String(i + 1)}`}
                            onClick={() => {
                                studio.useMatch(match.recipe);
                            }}
                        >
                            Use
                        </button>
                    </div>
                    <div class="stage match-chips">
                        {props.colours[i]?.lab.map((lab, k) => {
                            const standard = standardAt(props.colours[i] as Readings, k);
                            return (
                                <div class="faces" key={k}>
                                    {standard !== null && (
                                        <i style={{ background: chip(standard).css }} />
                                    )}
                                    <i style={{ background: chip(lab).css }} />
                                </div>
                            );
                        })}
                    </div>
                    <dl>
                        {match.parameters.map(({ key, value, sd, at_bound }) => {
                            const path = parsePath(key);
                            const { label, unit } = labelOf(String(path.at(-1)));
                            const error =
                                sd === null ? "" : ` ± ${plain(Number(sd.toPrecision(2)))}`;
                            return [
                                <dt key={`${key} name`}>
                                    {label} <small>{placeText(match.recipe, path)}</small>
                                </dt>,
                                <dd key={key}>
                                    {plain(value)}
                                    {error} {unit}
                                    {at_bound && " (at its bound)"}
                                </dd>,
                            ];
                        })}
                    </dl>
                </li>
            ))}
        </ol>
    );
}
