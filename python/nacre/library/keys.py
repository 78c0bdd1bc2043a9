"""The values of a recipe by their keys, as ``--set`` of the command line has them.

A recipe is a dictionary here, as :meth:`nacre.Paint.to_dict` gives it. A key is the path of a
value, entries of lists counted from 0, ``layer[0].flakes[0].coats[0].thickness_nm``; ``X.max`` is
the largest sample of the spectrum X, and setting it scales the others.
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from typing import Any

Recipe = dict[str, Any]
Step = str | int


def _steps(key: str) -> list[Step]:
    """The path as what to look up, one after the other."""
    steps: list[Step] = []
    for part in key.split("."):
        match = re.fullmatch(r"(\w+)((?:\[\d+\])*)", part)
        if match is None:
            raise ValueError(f"{key}: is no path of a key, as in layer[0].thickness_um")
        steps.append(match[1])
        steps += [int(index) for index in re.findall(r"\d+", match[2])]
    return steps


def _is_spectrum(value: Any) -> bool:
    return isinstance(value, dict) and "wavelengths_nm" in value and "values" in value


def _walk(value: Any, path: str) -> Iterator[tuple[str, Any]]:
    if path:
        yield path, value
    if _is_spectrum(value):
        yield f"{path}.max", max(value["values"])
    elif isinstance(value, dict):
        for key, inner in value.items():
            yield from _walk(inner, f"{path}.{key}" if path else key)
    elif isinstance(value, list) and value and isinstance(value[0], dict):
        for i, inner in enumerate(value):
            yield from _walk(inner, f"{path}[{i}]")


def all_values(recipe: Recipe) -> dict[str, Any]:
    """Every value by its whole key: numbers, texts, lists and tables."""
    return dict(_walk(recipe, ""))


def numbers(recipe: Recipe) -> dict[str, float]:
    """The numbers alone, spectra by their largest sample."""
    return {
        key: float(value)
        for key, value in all_values(recipe).items()
        if isinstance(value, int | float) and not isinstance(value, bool)
    }


def matching(recipe: Recipe, pattern: str) -> list[str]:
    """The whole keys that a pattern means: itself, or keys that end so from a dot on; ``*`` stands
    for any text. None where none matches.

    Raises
    ------
    ValueError
        If the pattern is without ``*`` and several keys end so.
    """
    keys = list(all_values(recipe))
    if pattern in keys:
        return [pattern]
    text = ".*".join(re.escape(part) for part in pattern.split("*"))
    found = [key for key in keys if re.fullmatch(rf"(?:.*\.)?{text}", key)]
    if len(found) > 1 and "*" not in pattern:
        raise ValueError(
            f"{pattern}: may mean {', '.join(found)}; write more of the key, or *{pattern} for all"
        )
    return found


def get(recipe: Recipe, key: str) -> Any:
    """The value of a whole key; KeyError without it."""
    return all_values(recipe)[key]


def put(recipe: Recipe, key: str, value: Any) -> None:
    """Sets the value of a whole key in place. What is not there is added, tables on its way too.

    Raises
    ------
    ValueError
        If the path leads through something that is no table, or beyond the end of a list.
    """
    *way, last = _steps(key)
    place: Any = recipe
    for i, step in enumerate(way):
        if isinstance(step, int):
            if not isinstance(place, list) or step >= len(place):
                raise ValueError(f"{key}: the recipe has no entry [{step}] there")
            place = place[step]
        elif not isinstance(place, dict):
            raise ValueError(f"{key}: {step} cannot stand in what is no table")
        elif step not in place and (i + 1 == len(way) or isinstance(way[i + 1], str)):
            place = place.setdefault(step, {})
        elif step not in place:
            raise ValueError(f"{key}: the recipe has no {step}")
        else:
            place = place[step]
    if last == "max" and _is_spectrum(place):
        largest = max(place["values"])
        if largest <= 0:
            raise ValueError(f"{key}: a spectrum of zeros cannot be scaled")
        # As set_parameter() of the C++ library, to the last bit.
        place["values"] = [
            value if x == largest else value * (x / largest) for x in place["values"]
        ]
    elif isinstance(last, int):
        if not isinstance(place, list) or last >= len(place):
            raise ValueError(f"{key}: the recipe has no entry [{last}] there")
        place[last] = value
    elif isinstance(place, dict):
        place[last] = value
    else:
        raise ValueError(f"{key}: {last} cannot stand in what is no table")
