"""Sparkle and graininess."""

from __future__ import annotations

from dataclasses import dataclass, fields
from typing import Any, NamedTuple

from . import _html
from ._arrays import Floats32, optional


class Estimate(NamedTuple):
    """A value and the standard deviation of its error."""

    value: float
    standard_error: float


@dataclass(frozen=True, eq=False)
class LampReading:
    """Sparkle under one lamp; thresholds are those of the eye (docs/sparkle.md)."""

    lamp_deg: float
    Y: float
    """luminance; the perfect diffuser has 100"""
    background_Y: float
    threshold_Y: float
    eye_blur_um: float
    area_mm2: float
    spots_per_cm2: Estimate
    intensity: Estimate | None
    """geometric mean of the visible spots, in thresholds; None: no spots"""
    contrast: Estimate | None
    area_percent: Estimate
    sparkle: Estimate
    pixel_contrast: Estimate
    picture: Floats32
    """(H, W, 3): X, Y, Z relative to the perfect diffuser, Y = 1"""


@dataclass(frozen=True)
class DiffuseReading:
    """Graininess in diffuse light."""

    Y: float
    graininess: Estimate
    """in thresholds"""
    pixel_contrast: Estimate


@dataclass(frozen=True, eq=False)
class Sparkle:
    """What the virtual camera read."""

    lamps: list[LampReading]
    diffuse: DiffuseReading | None
    flakes_resolved: bool
    """False: flakes lie in heaps too dense to be told apart, and graininess is too large"""

    def _rows(self) -> list[dict[str, object]]:
        rows: list[dict[str, object]] = []
        readings: list[tuple[str, object]] = [(f"{x.lamp_deg:g}s", x) for x in self.lamps]
        if self.diffuse is not None:
            readings.append(("diffuse", self.diffuse))
        for name, reading in readings:
            row: dict[str, object] = {"geometry": name}
            for field in fields(reading):  # type: ignore[arg-type]
                value = getattr(reading, field.name)
                if field.name == "picture":
                    continue
                if isinstance(value, Estimate):
                    row[field.name], row[f"{field.name}_se"] = value
                else:
                    row[field.name] = value
            rows.append(row)
        return rows

    def to_pandas(self) -> Any:
        """A DataFrame, a row a lamp and one for diffuse light; _se are standard errors."""
        pandas = optional("pandas", "to_pandas()")
        return pandas.DataFrame(self._rows()).set_index("geometry")

    def _repr_html_(self) -> str:
        names = ["geometry", "Y", "spots_per_cm2", "intensity", "graininess"]
        return _html.table(names, [[row.get(name, "") for name in names] for row in self._rows()])


def _estimates(values: dict[str, Any]) -> dict[str, Any]:
    return {k: Estimate(*v) if isinstance(v, tuple) else v for k, v in values.items()}


def sparkle_of(values: dict[str, Any]) -> Sparkle:
    diffuse = values["diffuse"]
    return Sparkle(
        [LampReading(**_estimates(lamp)) for lamp in values["lamps"]],
        None if diffuse is None else DiffuseReading(**_estimates(diffuse)),
        values["flakes_resolved"],
    )
