/** Readings as numbers. */

import type { VNode } from "preact";
import type { Lab } from "../../../common/colour";
import { chip, chroma, hue } from "../../../common/colour";
import { angleName, number } from "../../../common/dom";
import { useStudioState } from "../ui/context";
import { AngleText, groups } from "./chips";

export function Numbers(): VNode | null {
    const readings = useStudioState((state) => state.details);
    if (readings === null) return null;
    const versus = readings.standard;
    const order = groups(readings.geometries).flatMap(({ places }) => places.map(({ i }) => i));
    const name = (i: number) => (
        <th scope="row">
            <i class="dot" style={{ background: chip(readings.lab[i] as Lab).css }} />
            <AngleText text={angleName(readings.geometries[i] as string)} />
        </th>
    );
    return (
        <>
            <table class="figures">
                <thead>
                    <tr>
                        {["Angle", "L*", "a*", "b*", "C*", "h"].map((head) => (
                            <th key={head} scope="col">
                                {head}
                            </th>
                        ))}
                    </tr>
                </thead>
                <tbody>
                    {order.map((i) => {
                        const lab = readings.lab[i] as Lab;
                        return (
                            <tr key={i}>
                                {name(i)}
                                {[...lab, chroma(lab)].map((x, c) => (
                                    <td key={c}>{number(x, 2)}</td>
                                ))}
                                <td>{number(hue(lab), 1)}</td>
                            </tr>
                        );
                    })}
                </tbody>
            </table>
            {versus?.dL !== undefined && (
                <table class="figures" aria-label="Differences from the standard">
                    <thead>
                        <tr>
                            {["Sample − standard", "ΔL*", "ΔC*", "ΔH*", "ΔE2000"].map((head) => (
                                <th key={head} scope="col">
                                    {head}
                                </th>
                            ))}
                        </tr>
                    </thead>
                    <tbody>
                        {order.map((i) => (
                            <tr key={i}>
                                {name(i)}
                                {[versus.dL, versus.dC, versus.dH].map((column, c) => (
                                    <td key={c}>{number(column?.[i], 2)}</td>
                                ))}
                                <td class="strong">{number(versus.delta_e_2000?.[i], 2)}</td>
                            </tr>
                        ))}
                    </tbody>
                </table>
            )}
        </>
    );
}
