"""Which paint of a library reads like this? The nearest records to a standard.

Distance is the mean of Delta E 2000 over the angles that both have. It is computed exactly for
those records alone that two lower bounds do not rule out. The bounds hold for every pair of
colours, so that no record is missed. Delta E 2000 is the root of

    (dL / S_L)^2 + x^2 + y^2 + R_T x y,    x = dC' / S_C,  y = dH' / S_H    [sharma-2005]

and |R_T| < 2, so that it is at least |dL| / S_L, which takes a few operations. Of the rest,

- x^2 + y^2 + R_T x y >= (1 - |R_T| / 2) (x^2 + y^2);
- |R_T| / 2 <= sin 60 deg sqrt(c^7 / (c^7 + 25^7)) for any c that is at least the mean of both C';
- S_H <= S_C = 1 + 0.045 times that mean, since the factor T of S_H is at most 1.93;
- dC'^2 + dH'^2 = da'^2 + db^2 >= da^2 + db^2, since a' = (1 + G) a with 0 <= G <= 1/2 for both, and
  for the same reason c = 1.5 times the mean of both C*.
"""

from __future__ import annotations

import csv
from collections.abc import Sequence
from dataclasses import asdict, dataclass
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

import nacre
from nacre import Measurement, Paint

from .index import Floats, Index
from .record import read_record, record_folder

SAME_DEG = 0.1
"""Angles that differ by less are the same, as for ``nacre measure --versus``."""


Places = NDArray[np.intp] | slice


@dataclass(frozen=True)
class Match:
    """A record and how far it is from the standard."""

    id: str
    name: str
    construction: str
    distance: float
    """mean Delta E 2000, and the weighted difference of sparkle where that was asked for"""
    mean_dE2000: float
    max_dE2000: float
    dE2000: dict[str, float]
    """by geometry"""
    sparkle_log2: float | None
    """mean of the ratios of sparkle and graininess as powers of two"""
    folder: Path


@dataclass(frozen=True)
class Standard:
    """What is looked for."""

    name: str
    Lab: Floats
    """(G, 3)"""
    places: list[int]
    """(G,) which geometries of the library these are"""
    sparkle: Floats | None
    """as the index has it"""


def lightness_bound(L: Floats, L_standard: Floats) -> Floats:
    """A lower bound of the mean Delta E 2000.

    Parameters
    ----------
    L
        (N, G) lightness of the records.
    L_standard
        (G,)

    Returns
    -------
    array (N,)
    """
    mean: Floats = np.abs(_of_lightness(L, L_standard)).mean(axis=1)
    return mean


def colour_bound(Lab: Floats, Lab_standard: Floats) -> Floats:
    """A lower bound of the mean Delta E 2000 that is never below the one of lightness alone.

    Parameters
    ----------
    Lab
        (3, N, G) of the records.
    Lab_standard
        (G, 3)

    Returns
    -------
    array (N,)
    """
    L, a, b = Lab
    L0, a0, b0 = Lab_standard.T
    c = 0.75 * (np.hypot(a, b) + np.hypot(a0, b0))
    c7 = c**7
    least = 1.0 - np.sin(np.radians(60.0)) * np.sqrt(c7 / (c7 + 25.0**7))
    chromatic = least * ((a - a0) ** 2 + (b - b0) ** 2) / (1.0 + 0.045 * c) ** 2
    mean: Floats = np.sqrt(_of_lightness(L, L0) ** 2 + chromatic).mean(axis=1)
    return mean


def _of_lightness(L: Floats, L_standard: Floats) -> Floats:
    off = (0.5 * (L + L_standard) - 50.0) ** 2
    return np.asarray((L - L_standard) / (1.0 + 0.015 * off / np.sqrt(20.0 + off)))


def _sparkle_distance(sparkle: Floats, standard: Floats) -> Floats:
    """Mean over lamps and graininess of |log2 (1 + x) / (1 + y)|; 1 is what is just noticed."""
    seen = np.abs(np.log2((1.0 + sparkle) / (1.0 + standard)))
    return np.asarray(np.nanmean(seen, axis=1))


def standard_of(path: str | Path, index: Index, sparkle: bool, sparkle_file: str = "") -> Standard:
    """Reads a standard, or computes its readings as the library's were.

    Parameters
    ----------
    path
        Measured colours, or a paint of any kind that Nacre reads.
    sparkle
        Whether sparkle is compared as well.
    sparkle_file
        What ``nacre sparkle -o FILE.csv`` wrote about the standard; empty: it is computed.

    Raises
    ------
    nacre.InputError
        If the standard has no angle of the library's, or no sparkle.
    """
    paint = Paint(path)
    settings = index.settings
    light = {"illuminant": settings["illuminant"], "observer": settings["observer"]}
    if paint.kind == "measured_colours":
        readings = [paint.measure(**light)]
    else:
        readings = [
            paint.measure(geometry, model=settings["model"], **light)
            for geometry in settings["geometries"]
        ]
    Lab, places = _common(readings, index)
    if not places:
        there = ", ".join(index.geometries)
        raise nacre.InputError(f"{path}: has none of the library's angles: {there}")
    numbers = None
    if sparkle:
        numbers = _sparkle_of(paint, index, sparkle_file)
    return Standard(paint.name, Lab, places, numbers)


def _common(readings: Sequence[Measurement], index: Index) -> tuple[Floats, list[int]]:
    colours: list[Floats] = []
    places: list[int] = []
    for reading in readings:
        angles = np.stack([reading.theta_i_deg, reading.theta_o_deg, reading.phi_deg], axis=1)
        for angle, colour in zip(angles, reading.Lab, strict=True):
            for place, direction in enumerate(index.directions_deg):
                if place not in places and np.all(np.abs(angle - direction) < SAME_DEG):
                    colours.append(colour)
                    places.append(place)
                    break
    return np.array(colours).reshape(-1, 3), places


def _sparkle_of(paint: Paint, index: Index, file: str) -> Floats:
    wanted = index.settings["sparkle"]
    if wanted is None:
        raise nacre.InputError(f"{index.library}: its records have no sparkle to compare")
    if file:
        return _read_sparkle(file, wanted["lamps_deg"])
    if paint.kind not in ("recipe", "solved_paint"):
        raise nacre.InputError(
            f"{paint.file}: has no sparkle; --standard-sparkle names what nacre sparkle wrote"
        )
    seen = paint.sparkle(**wanted)
    grain = np.nan if seen.diffuse is None else seen.diffuse.graininess.value
    return np.array([*(lamp.sparkle.value for lamp in seen.lamps), grain])


def _read_sparkle(file: str, lamps_deg: Sequence[float]) -> Floats:
    rows: dict[str, dict[str, str]] = {}
    try:
        with open(file, encoding="utf-8-sig", newline="") as text:
            rows = {row["geometry"]: row for row in csv.DictReader(text)}
        names = [f"{lamp:g}s" for lamp in lamps_deg]
        values = [float(rows[name]["sparkle"]) for name in names]
        grain = rows.get("diffuse", {}).get("graininess") or "nan"
        return np.array([*values, float(grain)])
    except (OSError, UnicodeDecodeError, KeyError, ValueError) as error:
        raise nacre.InputError(
            f"{file}: must be a table of nacre sparkle, with a row a lamp of {lamps_deg}: {error!r}"
        ) from None


def find(
    library: str | Path | Index,
    standard: str | Path | Standard,
    count: int = 10,
    *,
    sparkle_weight: float = 0.0,
    sparkle_file: str = "",
    each_construction: bool = False,
) -> list[Match]:
    """The records nearest to a standard, the nearest first.

    Parameters
    ----------
    standard
        A file of measured colours, or a paint.
    count
        How many, >= 1.
    sparkle_weight
        What a ratio of two in sparkle and graininess adds to the mean Delta E 2000, >= 0.
    sparkle_file
        See :func:`standard_of`.
    each_construction
        The best of each construction alone.

    Raises
    ------
    nacre.InputError
        If the library or the standard cannot be read or have nothing in common.
    """
    index = library if isinstance(library, Index) else Index.open(library)
    if not isinstance(standard, Standard):
        standard = standard_of(standard, index, sparkle_weight > 0, sparkle_file)
    search = _Search(index, standard, sparkle_weight)
    if each_construction:
        places = search.best_of_each(index.construction)[:count]
    else:
        places = search.nearest(count)
    return [search.match(place) for place in places]


class _Search:
    """A standard, and the records of a library about it."""

    def __init__(self, index: Index, standard: Standard, sparkle_weight: float) -> None:
        self._index = index
        self._standard = standard
        self._whole = standard.places == list(range(len(index.geometries)))
        self._sparkle: Floats | None = None
        """(N,) what sparkle adds to the distance"""
        if sparkle_weight > 0:
            assert standard.sparkle is not None
            self._sparkle = sparkle_weight * _sparkle_distance(index.sparkle, standard.sparkle)
        self._weight = sparkle_weight

    def _Lab(self, places: Places) -> Floats:
        """(3, len(places), G) at the geometries of the standard"""
        Lab = self._index.Lab[:, places]
        return Lab if self._whole else Lab[:, :, self._standard.places]

    def _with_sparkle(self, distances: Floats, places: Places) -> Floats:
        return distances if self._sparkle is None else distances + self._sparkle[places]

    def _differences(self, places: Places) -> Floats:
        """(len(places), G) Delta E 2000"""
        Lab = np.moveaxis(self._Lab(places), 0, -1)
        differences: Floats = nacre.delta_e_2000(Lab, self._standard.Lab)
        return differences

    def _distances(self, places: Places) -> Floats:
        return self._with_sparkle(np.asarray(self._differences(places).mean(axis=1)), places)

    def nearest(self, count: int) -> list[int]:
        """The places of the nearest records; of two alike, the earlier one comes first."""
        index, standard = self._index, self._standard
        everything = slice(None)
        L = index.Lab[0] if self._whole else index.Lab[0][:, standard.places]
        bound = self._with_sparkle(lightness_bound(L, standard.Lab[:, 0]), everything)
        first = min(max(20 * count, 1000), index.count)
        places = np.argpartition(bound, first - 1)[:first]
        rank = min(count, first) - 1
        # No record beyond this is among the nearest; the bounds may be off by rounding.
        limit = np.partition(self._distances(places), rank)[rank] * (1 + 1e-9) + 1e-9
        places = np.flatnonzero(bound <= limit)
        bound = self._with_sparkle(colour_bound(self._Lab(places), standard.Lab), places)
        places = places[bound <= limit]
        order = np.argsort(self._distances(places), kind="stable")[:count]
        nearest: list[int] = places[order].tolist()
        return nearest

    def best_of_each(self, construction: NDArray[np.int32]) -> list[int]:
        """The place of the best record of each construction, the best first."""
        distances = self._distances(np.arange(self._index.count))
        order = np.argsort(distances, kind="stable")
        _, firsts = np.unique(construction[order], return_index=True)
        places: list[int] = order[np.sort(firsts)].tolist()
        return places

    def match(self, place: int) -> Match:
        index = self._index
        at = np.array([place])
        differences = self._differences(at)[0]
        record = read_record(index.library, index.id(place))
        return Match(
            record["id"],
            record["name"],
            record["construction"],
            float(self._distances(at)[0]),
            float(differences.mean()),
            float(differences.max()),
            {
                index.geometries[geometry]: float(value)
                for geometry, value in zip(self._standard.places, differences, strict=True)
            },
            None if self._sparkle is None else float(self._sparkle[place]) / self._weight,
            record_folder(index.library, record["id"]),
        )


def as_row(match: Match) -> dict[str, Any]:
    """For tables: a column a geometry."""
    row = {name: value for name, value in asdict(match).items() if name != "dE2000"}
    return row | {f"dE2000_{name}": value for name, value in match.dE2000.items()}
