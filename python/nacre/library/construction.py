"""What a paint is made of, in words: its kinds and materials without their numbers."""

from __future__ import annotations

from typing import Any

from .keys import Recipe
from .table import is_number


def _material(value: Any) -> str:
    if isinstance(value, dict):
        return str(value.get("name") or "own material")
    return value if isinstance(value, str) else f"n = {value:g}"


def label(value: Any) -> str:
    """A value of a recipe that is no number in a few words: tables by what they are made of."""
    if isinstance(value, list):
        return " + ".join(label(item) for item in value)
    if isinstance(value, dict):
        for key in ("name", "from", "material"):
            if value.get(key):
                return label(value[key])
        return "{...}"
    return f"{value:.4g}" if is_number(value) else str(value)


def flake_stack(flakes: Recipe) -> str:
    """The films of a species of flakes from the outside in, as "TiO2_anatase|mica"."""
    if "core" not in flakes:
        return "prescribed flakes"
    films = [*reversed(flakes.get("coats", [])), flakes["core"]]
    sides = " on one side" if flakes.get("coated_sides") == "one" else ""
    return "|".join(_material(film["material"]) for film in films) + sides


def pigment_name(pigment: Recipe) -> str:
    name = pigment.get("name")
    if name:
        return str(name)
    return _material(pigment["material"]) if "material" in pigment else "pigment"


def _is_zero(spectrum: Any) -> bool:
    if isinstance(spectrum, dict):
        return not any(spectrum.get("values", [0]))
    return bool(spectrum == 0)


def _clearcoat(coat: Recipe) -> str:
    tinted = "" if _is_zero(coat.get("absorption_per_mm", 0)) else "tinted "
    return ("rough " if coat.get("roughness", 0) else "") + tinted + "clear"


def construction(recipe: Recipe) -> str:
    """From the top down, as "clear / TiO2_anatase|mica + carbon black / substrate". Paints with the
    same text differ in numbers only."""
    coats = [_clearcoat(recipe["clearcoat"])] if "clearcoat" in recipe else []
    for layer in recipe.get("layer", []):
        parts = sorted(flake_stack(flakes) for flakes in layer.get("flakes", []))
        parts += sorted(pigment_name(pigment) for pigment in layer.get("pigment", []))
        coats.append(" + ".join(parts) or "clear")
    if not recipe.get("layer") and "microfacet" in recipe:
        coats.append("facets")
    return " / ".join(coats)


def ingredients(recipe: Recipe) -> list[str]:
    """Stacks of flakes and names of pigments, each once, from the top down."""
    found: list[str] = []
    for layer in recipe.get("layer", []):
        found += [flake_stack(flakes) for flakes in layer.get("flakes", [])]
        found += [pigment_name(pigment) for pigment in layer.get("pigment", [])]
    return list(dict.fromkeys(found))
