"""What a search reads of a library: arrays that are mapped into memory and not read."""

from __future__ import annotations

import json
import shutil
from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

import nacre

FOLDER = "index"

Floats = NDArray[np.float64]


def sparkle_numbers(record: dict[str, Any]) -> list[float]:
    """What a search compares of sparkle: `sparkle` under each lamp, then graininess; nan where a
    paint has none."""
    lamps = [lamp["sparkle"] for lamp in record["sparkle"] or []]
    return [np.nan if x is None else float(x) for x in (*lamps, record["graininess"])]


class IndexWriter:
    """Gathers records, in the catalogue's order, and writes the index."""

    def __init__(self) -> None:
        self._ids: list[str] = []
        self._Lab: list[Floats] = []
        self._sparkle: list[list[float]] = []
        self._constructions: dict[str, int] = {}
        self._construction: list[int] = []
        self._head: dict[str, Any] = {}

    def add(self, record: dict[str, Any]) -> None:
        """A record as record.json has it."""
        readings = record["readings"]
        if not self._head:
            names = ("geometries", "theta_i_deg", "theta_o_deg", "phi_deg")
            self._head = {name: readings[name] for name in names}
            self._head["settings"] = record["settings"]
        self._ids.append(record["id"])
        self._Lab.append(np.array(readings["Lab"]))
        self._sparkle.append(sparkle_numbers(record))
        number = self._constructions.setdefault(record["construction"], len(self._constructions))
        self._construction.append(number)

    def write(self, library: Path) -> None:
        """Replaces the index of a library."""
        fresh = library / ".index"
        shutil.rmtree(fresh, ignore_errors=True)
        fresh.mkdir()
        if self._ids:
            # A plane a component: the search reads lightness alone first.
            np.save(fresh / "Lab.npy", np.ascontiguousarray(np.stack(self._Lab).transpose(2, 0, 1)))
            np.save(fresh / "sparkle.npy", np.array(self._sparkle))
            np.save(fresh / "construction.npy", np.array(self._construction, dtype=np.int32))
            np.save(fresh / "id.npy", np.array(self._ids, dtype="S32"))
        head = {**self._head, "constructions": list(self._constructions), "count": len(self._ids)}
        (fresh / "index.json").write_text(json.dumps(head, ensure_ascii=False), encoding="utf-8")
        shutil.rmtree(library / FOLDER, ignore_errors=True)
        fresh.rename(library / FOLDER)


@dataclass(frozen=True)
class Index:
    """The index of a library, opened."""

    library: Path
    geometries: list[str]
    """(G,)"""
    directions_deg: Floats
    """(G, 3): theta_i, theta_o, phi"""
    settings: dict[str, Any]
    """with which the records were computed"""
    constructions: list[str]
    count: int

    @classmethod
    def open(cls, library: str | Path) -> Index:
        """Opens the index of a library.

        Raises
        ------
        nacre.InputError
            If the folder is no library, or an empty one.
        """
        file = Path(library) / FOLDER / "index.json"
        if not file.is_file():
            raise nacre.InputError(f"{library}: is no library: it has no {FOLDER}/{file.name}")
        head = json.loads(file.read_text(encoding="utf-8"))
        if head["count"] == 0:
            raise nacre.InputError(f"{library}: has no records")
        directions: Sequence[Sequence[float]] = [
            head[name] for name in ("theta_i_deg", "theta_o_deg", "phi_deg")
        ]
        return cls(
            Path(library),
            head["geometries"],
            np.array(directions).T,
            head["settings"],
            head["constructions"],
            head["count"],
        )

    def _map(self, name: str) -> Any:
        return np.load(self.library / FOLDER / f"{name}.npy", mmap_mode="r")

    @cached_property
    def Lab(self) -> Floats:
        """(3, N, G)"""
        array: Floats = self._map("Lab")
        return array

    @cached_property
    def sparkle(self) -> Floats:
        """(N, S), see :func:`sparkle_numbers`"""
        array: Floats = self._map("sparkle")
        return array

    @cached_property
    def construction(self) -> NDArray[np.int32]:
        """(N,) which of the constructions"""
        array: NDArray[np.int32] = self._map("construction")
        return array

    def id(self, i: int) -> str:
        """Of a record, by its place."""
        return str(self._map("id")[i].decode())
