"""The static page of a library: index.html, page/ and what they show.

The page opens from disk and from any web server, and reads nothing else at run time. A page that
was opened from disk may not fetch files but may run scripts; so the data are scripts, each of which
hands over its part by ``nacreLibrary(name, part)``. The page's sources are in web/library.
"""

from __future__ import annotations

import argparse
import json
import os
import shutil
import tomllib
from collections import Counter
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np

import nacre

from .catalogue import Catalogue
from .record import record_folder, write_whole

ABOUT = "Writes the page of a library: index.html and page/."

SCHEMA = 1
"""Of the data; web/library/src/data.ts reads it. The page and its data are written together."""

_SOURCES = Path(__file__).with_name("page")
_RECORDS_PER_FILE = 32
_RECORDS_PER_GALLERY_FILE = 32 * _RECORDS_PER_FILE
_PICTURES = ("ball.png", "panel.png", "macro.png")
"""Thumbnails in the order of the page; the first that there is stands in the gallery."""

Row = dict[str, Any]


@dataclass(frozen=True)
class Written:
    """What :func:`write_page` wrote."""

    records: int
    bytes: int


def write_page(library: str | Path) -> Written:
    """Writes index.html and page/ into a library, page/ by one rename and index.html after it.

    Raises
    ------
    nacre.InputError
        If the folder is no library, its catalogue is empty, or a record of it lacks its recipe.
    OSError
        If a file cannot be written; a page that was there is then as it was.
    """
    library = Path(library)
    catalogue = Catalogue(library)
    if len(catalogue) == 0:
        raise nacre.InputError(f"{library}: has no records to show")
    fresh, old = library / ".page", library / ".page.old"
    for left_over in (fresh, old):
        shutil.rmtree(left_over, ignore_errors=True)
    try:
        (fresh / "data").mkdir(parents=True)
        for name in ("app.js", "app.css"):
            shutil.copyfile(_SOURCES / name, fresh / name)
        size = _write_data(library, catalogue, fresh / "data")
        page = library / "page"
        if page.exists():
            page.rename(old)
        fresh.rename(page)
    finally:
        shutil.rmtree(fresh, ignore_errors=True)
    shutil.rmtree(old, ignore_errors=True)
    write_whole(library / "index.html", (_SOURCES / "index.html").read_bytes())
    return Written(len(catalogue), size)


class _Names:
    """Texts by number: those that many records share are written once."""

    def __init__(self, count: Counter[Any]) -> None:
        # The most frequent first: that is how lists of them are read.
        self.names = sorted(count, key=lambda name: (-count[name], name))
        self._numbers = {name: number for number, name in enumerate(self.names)}

    def __getitem__(self, name: Any) -> int:
        return self._numbers[name]


def _title(library: Path) -> str:
    """As the plan calls it, else the folder's name."""
    try:
        plan = tomllib.loads((library / "library.toml").read_text(encoding="utf-8"))
    except OSError:
        plan = {}
    about = plan.get("library")
    name = about.get("name") if isinstance(about, dict) else None
    return str(name) if name else library.resolve().name


def _settings(library: Path, catalogue: Catalogue) -> Row:
    """What all records have in common."""
    rows = catalogue.table(["geometries", "wavelengths_nm", "illuminant", "observer"]).to_pylist()
    for row in rows:
        if row != rows[0]:
            raise nacre.InputError(
                f"{library}: its records were not all read alike: {row} and {rows[0]}"
            )
    return dict(rows[0])


def _batches(catalogue: Catalogue) -> Iterator[list[Row]]:
    """All rows, a few at a time: as Python objects all of them would take gigabytes. Spectra come
    as arrays (G, W)."""
    table = catalogue.table()
    for start in range(0, len(table), _RECORDS_PER_GALLERY_FILE):
        some = table.slice(start, _RECORDS_PER_GALLERY_FILE)
        rows: list[Row] = some.drop_columns(["R"]).to_pylist()
        spectra = (
            some.column("R").combine_chunks().flatten().flatten().to_numpy(zero_copy_only=False)
        )
        shape = (len(rows), len(rows[0]["geometries"]), len(rows[0]["wavelengths_nm"]))
        for row, reflectance in zip(rows, spectra.reshape(shape), strict=True):
            row["R"] = reflectance
        yield rows


def _write_data(library: Path, catalogue: Catalogue, folder: Path) -> int:
    few = catalogue.table(["sweep", "construction", "pigments", "sparkle"]).to_pylist()
    sweeps = _Names(Counter(row["sweep"] for row in few))
    constructions = _Names(Counter(row["construction"] for row in few))
    pigments = _Names(Counter(name for row in few for name in row["pigments"]))
    lamps = [lamp["lamp_deg"] for row in few for lamp in row["sparkle"] or []]
    # Near the mirror direction a paint sparkles most.
    lamp_deg = min(lamps) if lamps else None

    size = gallery_files = 0
    for number, rows in enumerate(_batches(catalogue)):
        part = {
            "id": [row["id"] for row in rows],
            "name": [row["name"] for row in rows],
            "sweep": [sweeps[row["sweep"]] for row in rows],
            "construction": [constructions[row["construction"]] for row in rows],
            "pigments": [[pigments[name] for name in row["pigments"]] for row in rows],
            "Lab": [np.ravel(row["Lab"]).round(4).tolist() for row in rows],
            "flop_index": [_rounded(row["flop_index"]) for row in rows],
            "colour_travel": [_rounded(row["colour_travel"]) for row in rows],
            "sparkle": [_rounded(_sparkle(row, lamp_deg)) for row in rows],
            "graininess": [_rounded(row["graininess"]) for row in rows],
            "thumbnails": [[x for x in _PICTURES if x in row["thumbnails"]] for row in rows],
        }
        size += _write_part(folder, f"gallery-{number:04}", part)
        gallery_files += 1
        first_file = number * _RECORDS_PER_GALLERY_FILE // _RECORDS_PER_FILE
        for start in range(0, len(rows), _RECORDS_PER_FILE):
            some = rows[start : start + _RECORDS_PER_FILE]
            name = f"records-{first_file + start // _RECORDS_PER_FILE:04}"
            size += _write_part(folder, name, [_details(library, row) for row in some])
    return size + _write_part(
        folder,
        "library",
        {
            "schema": SCHEMA,
            "title": _title(library),
            "version": nacre.__version__,
            "records": len(few),
            **_settings(library, catalogue),
            "sweeps": sweeps.names,
            "constructions": constructions.names,
            "pigments": pigments.names,
            "sparkle_lamp_deg": lamp_deg,
            "gallery_files": gallery_files,
            "records_per_file": _RECORDS_PER_FILE,
        },
    )


def _rounded(value: float | None) -> float | None:
    return None if value is None else round(value, 4)


def _sparkle(row: Row, lamp_deg: float | None) -> float | None:
    for lamp in row["sparkle"] or []:
        if lamp["lamp_deg"] == lamp_deg:
            value: float | None = lamp["sparkle"]
            return value
    return None


def _details(library: Path, row: Row) -> Row:
    """Everything about a record; figures are those of record.json, but for curves."""
    folder = record_folder(library, row["id"])
    try:
        recipe = (folder / "recipe.toml").read_text(encoding="utf-8")
        files = [
            {"name": entry.name, "bytes": entry.stat().st_size} for entry in os.scandir(folder)
        ]
    except OSError as error:
        raise nacre.InputError(f"{library}: {row['id']} is in the catalogue, but {error}") from None
    reflectance = row["R"].astype(float).round(6)
    kept = ["id", "Lab", "flop_index", "colour_travel", "sparkle", "graininess"]
    kept += ["warnings", "seconds", "version"]
    return {name: row[name] for name in kept} | {
        "R": [[None if np.isnan(x) else x for x in curve] for curve in reflectance.tolist()],
        "parameters": dict(row["parameters"]),
        "swept": dict(row["swept"]) | dict(row["swept_names"]),
        "recipe": tomllib.loads(recipe),
        "recipe_text": recipe,
        "files": sorted(files, key=lambda file: str(file["name"])),
    }


def _write_part(folder: Path, name: str, part: Any) -> int:
    """Returns the file's size in bytes."""
    text = json.dumps(part, ensure_ascii=False, allow_nan=False, separators=(",", ":"))
    data = f'nacreLibrary("{name}",{text});\n'.encode()
    (folder / f"{name}.js").write_bytes(data)
    return len(data)


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Those of ``nacre-library page``."""
    parser.add_argument("library", type=Path, metavar="LIBRARY")


def main(arguments: argparse.Namespace) -> int:
    """``nacre-library page LIBRARY``"""
    written = write_page(arguments.library)
    page = arguments.library / "index.html"
    print(f"{page}: {written.records} paints, {written.bytes / 1e6:.1f} MB of data")
    return 0
