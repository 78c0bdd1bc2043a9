/** A number that is no part of the recipe: what it cannot be is said, and what is in force stays in sight. */

import type { VNode } from "preact";
import { plain } from "../schema";
import { useStudio } from "./context";

export function NumberField(props: {
    readonly label: string;
    readonly value: number;
    readonly min: number;
    readonly max: number;
    /** "1": whole numbers. */
    readonly step: string;
    readonly disabled?: boolean;
    readonly set: (value: number) => void;
}): VNode {
    const { label, value, min, max, step } = props;
    const studio = useStudio();
    return (
        <input
            type="number"
            min={min}
            max={max}
            step={step}
            value={value}
            disabled={props.disabled ?? false}
            aria-label={label}
            onChange={(event) => {
                const typed = event.currentTarget.valueAsNumber;
                const whole = step !== "1" || Number.isInteger(typed);
                if (typed >= min && typed <= max && whole) {
                    props.set(typed);
                    return;
                }
                event.currentTarget.value = String(value);
                const what = step === "1" ? "a whole number" : "a number";
                studio.say(
                    `${label}: must be ${what} from ${plain(min)} to ${plain(max)}; it is still ${plain(value)}.`,
                );
            }}
        />
    );
}
