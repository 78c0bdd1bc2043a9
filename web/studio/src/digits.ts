/** Numbers of the recipe as their fields have them. */

/** Six significant digits, as people write numbers. */
export function digits(value: number): string {
    return String(Number(value.toPrecision(6))).replace("e+", "e");
}

/** Characters for which a field has room. */
const ROOM = 7;

/** The same where nobody types: with as many digits as are seen whole. */
export function shortDigits(value: number): string {
    const text = digits(value);
    if (text.length <= ROOM) return text;
    const power = (places: number) => value.toExponential(places).replace(/\.?0*e\+?/, "e");
    return [4, 3, 2, 1].map(power).find(({ length }) => length <= ROOM) ?? power(0);
}
