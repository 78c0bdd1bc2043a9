"""How far readings are spread where numbers of a recipe are known to a standard deviation."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from . import _html
from ._measurement import Measurement

Array = NDArray[np.float64]


@dataclass(frozen=True)
class UncertainNumber:
    """A number of the recipe that is not known exactly."""

    key: str
    value: float
    sd: float
    meets_range: bool
    """it is not allowed all values within three standard deviations"""


@dataclass(frozen=True, eq=False)
class Uncertainty:
    """Standard deviations of readings: to first order, or of the draws if there were some."""

    measurement: Measurement
    """of the recipe as it is"""
    numbers: list[UncertainNumber]
    correlation: Array
    """(N, N), of the numbers"""
    Lab_sd: Array
    """(G, 3)"""
    Lab_covariance: Array
    """(G, 3, 3)"""
    C_sd: Array
    """(G,); NaN near grey"""
    h_sd: Array
    """(G,), deg; NaN near grey"""
    R_sd: Array
    """(G, W), of reflectance factors"""
    change: Array
    """(G, N, 3): of L*, a*, b* with one standard deviation of each number, to first order"""
    shares: Array
    """(G, N): which part of the variance of L*, a*, b* together each number makes: its
    covariance with them. They sum to 1; of correlated numbers one may be negative."""
    first_order_fails: list[list[str]]
    """by geometry, which of L, a, b, C, h"""
    flop_index: tuple[float, float] | None
    """value and standard deviation"""
    colour_travel: tuple[float, float] | None
    samples: int
    """recipes drawn; 0: first order"""

    def _repr_html_(self) -> str:
        rows = [
            [name, *(f"{v:.2f} ± {s:.2f}" for v, s in zip(lab, sd, strict=True))]
            for name, lab, sd in zip(
                self.measurement.geometries, self.measurement.Lab, self.Lab_sd, strict=True
            )
        ]
        return _html.table(["", "L*", "a*", "b*"], rows)
