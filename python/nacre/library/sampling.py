"""Where in its ranges a sweep looks: grids, lists, Latin hypercubes and Sobol sequences."""

from __future__ import annotations

import itertools
import math
import warnings
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

METHODS = ("grid", "list", "latin-hypercube", "sobol")

Value = Any
"""A number, or what else TOML holds: the name of a material, a table, ..."""


@dataclass(frozen=True)
class Range:
    """The numbers from lo to hi, both included, along a linear or a logarithmic scale."""

    lo: float
    hi: float
    logarithmic: bool = False
    steps: int = 0
    """of a grid; 0: none given"""

    def at(self, u: float) -> float:
        """The number at u in [0, 1], to six significant digits: recipes are read by people."""
        if self.logarithmic:
            value = math.exp(math.log(self.lo) + u * math.log(self.hi / self.lo))
        else:
            value = self.lo + u * (self.hi - self.lo)
        return min(max(float(f"{value:.6g}"), self.lo), self.hi)

    def grid(self) -> list[Value]:
        """The values of a grid: ``steps`` of them, ends included."""
        return [self.at(i / (self.steps - 1)) for i in range(self.steps)]


@dataclass(frozen=True)
class Choice:
    """Some values, all of them as likely."""

    values: tuple[Value, ...]

    def at(self, u: float) -> Value:
        """The value at u in [0, 1]: each has an equal share of it."""
        return self.values[min(int(u * len(self.values)), len(self.values) - 1)]

    def grid(self) -> list[Value]:
        return list(self.values)


Axis = Range | Choice
Point = tuple[Value, ...]
"""A value for each axis."""


def grid(axes: Sequence[Axis]) -> list[Point]:
    """Every combination; the last axis turns fastest."""
    return list(itertools.product(*(axis.grid() for axis in axes)))


def together(axes: Sequence[Choice]) -> list[Point]:
    """The first values of all axes, then the second ones, and so on."""
    return list(zip(*(axis.values for axis in axes), strict=True))


def _points(axes: Sequence[Axis], unit: NDArray[np.float64]) -> list[Point]:
    rows: Iterable[list[float]] = unit.tolist()
    return [tuple(axis.at(u) for axis, u in zip(axes, row, strict=True)) for row in rows]


def latin_hypercube(axes: Sequence[Axis], count: int, seed: int) -> list[Point]:
    """Along each axis, one point in each of ``count`` equal intervals; another count makes another
    design altogether [mckay-1979]."""
    from scipy.stats import qmc  # late: workers do without

    return _points(axes, qmc.LatinHypercube(len(axes), rng=seed).random(count))


def sobol(axes: Sequence[Axis], count: int, seed: int) -> list[Point]:
    """The first points of a scrambled Sobol sequence [sobol-1967; owen-1998]: a larger count keeps
    those of a smaller one. A power of two covers the ranges best."""
    from scipy.stats import qmc

    with warnings.catch_warnings():
        warnings.simplefilter("ignore", UserWarning)  # that the count is no power of two
        return _points(axes, qmc.Sobol(len(axes), rng=seed).random(count))
