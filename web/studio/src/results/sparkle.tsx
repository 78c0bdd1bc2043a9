/** What an instrument's camera counts: measured when asked, for it takes seconds. */

import type { VNode } from "preact";
import { number } from "../../../common/dom";
import type { Estimate } from "../protocol";
import { useStudio, useStudioState } from "../ui/context";

export function SparklePanel(): VNode {
    const studio = useStudio();
    const sparkle = useStudioState((state) => state.sparkle);
    const fraction = useStudioState((state) => state.sparkleFraction);
    const document = useStudioState((state) => state.document);
    const old = sparkle !== null && sparkle.of.recipe !== document.recipe;
    return (
        <div class="sparkle">
            <p class="sparkle-start">
                <button
                    type="button"
                    onClick={() => {
                        if (fraction === null) studio.sparkle.measure();
                        else studio.sparkle.stop();
                    }}
                >
                    {fraction === null ? "Measure sparkle and graininess" : "Stop"}
                </button>
                <progress
                    max="1"
                    value={fraction ?? 0}
                    aria-label="Progress of the measurement"
                    class={fraction === null ? "idle" : ""}
                />
            </p>
            {sparkle !== null && (
                <div class={old ? "old" : ""}>
                    <table class="figures">
                        <thead>
                            <tr>
                                {["Lamp", "Sparkle", "Spots per cm²", "Intensity"].map((head) => (
                                    <th key={head} scope="col">
                                        {head}
                                    </th>
                                ))}
                            </tr>
                        </thead>
                        <tbody>
                            {sparkle.value.readings.map((lamp) => (
                                <tr key={lamp.theta_i}>
                                    <th scope="row">{number(lamp.theta_i, 0)}°</th>
                                    <td>{withError(lamp.sparkle)}</td>
                                    <td>{number(lamp.spots_per_cm2?.value, 0)}</td>
                                    <td>{number(lamp.intensity?.value, 1)}</td>
                                </tr>
                            ))}
                        </tbody>
                    </table>
                    <p>
                        Graininess, diffuse light: <b>{withError(sparkle.value.graininess)}</b>
                    </p>
                    {old && <p class="note">Of the paint before the last change.</p>}
                </div>
            )}
        </div>
    );
}

function withError(estimate: Estimate | null): string {
    if (estimate === null) return "–";
    const { value, standard_error: error } = estimate;
    return error === null ? number(value, 1) : `${number(value, 1)} ± ${number(error, 1)}`;
}
