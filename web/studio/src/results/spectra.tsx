/** Reflectance factors over wavelength, those of the standard dashed. */

import type { VNode } from "preact";
import { useMemo } from "preact/hooks";
import type { Lab } from "../../../common/colour";
import { chip } from "../../../common/colour";
import { angleName } from "../../../common/dom";
import type { Curve } from "../../../common/plots";
import { plot } from "../../../common/plots";
import { niceAbove } from "../slider";
import type { Colours } from "../protocol";
import { useStudioState } from "../ui/context";
import { Made } from "../ui/element";

function curvesOf(colours: Colours, dashed: boolean): Curve[] {
    if (colours.wavelengths_nm.length === 0) return [];
    return colours.reflectance.map((y, i) => ({
        x: colours.wavelengths_nm,
        y,
        colour: chip(colours.lab[i] as Lab).css,
        label: dashed ? "" : angleName(colours.geometries[i] as string),
        dashed,
    }));
}

export function Spectra(): VNode | null {
    const readings = useStudioState((state) => state.details);
    const element = useMemo(() => {
        if (readings === null) return null;
        const standard = readings.standard === null ? [] : curvesOf(readings.standard, true);
        const curves = [...standard, ...curvesOf(readings, false)];
        const most = Math.max(...curves.flatMap(({ y }) => [...y]));
        return plot(curves, {
            width: 340,
            height: 400,
            xLabel: "Wavelength, nm",
            yLabel: "Reflectance factor",
            y: [0, niceAbove(most * 1.02)],
            named: true,
            describedAs: "Reflectance factor over wavelength, a curve an angle",
        });
    }, [readings]);
    return element === null ? null : <Made element={element} />;
}
