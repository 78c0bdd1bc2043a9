"""Parts of a library for elsewhere: the catalogue as a table, records as a library of their own."""

from __future__ import annotations

import csv
import io
import re
import shutil
import tempfile
import zipfile
from collections.abc import Sequence
from pathlib import Path
from typing import Any

import pyarrow as pa
import pyarrow.parquet as pq

import nacre

from .catalogue import Catalogue, write_catalogue
from .folder import CITATION, LIBRARY, LICENSE, PLANNED
from .record import record_folder, write_whole

_PLAIN = (
    *("id", "name", "sweep", "base", "construction", "flop_index", "colour_travel"),
    *("L45", "a45", "b45", "C45", "h45", "graininess", "seconds", "version"),
)


def export(
    library: str | Path, to: str | Path, sweeps: Sequence[str] = (), ids: Sequence[str] = ()
) -> int:
    """Writes a part of a library, whole or not at all, and returns how many records it has.

    Parameters
    ----------
    to
        ``.csv``: a row a record, for spreadsheets. ``.parquet``: rows of the catalogue. ``.zip``,
        or the name of a folder that does not exist: a library of these records.
    sweeps, ids
        Only records of these sweeps, or whose ids begin so; none: all records.

    Raises
    ------
    nacre.InputError
        If the library cannot be read or has no such sweep or record.
    nacre.Error
        If the folder exists.
    """
    library, to = Path(library), Path(to)
    catalogue = Catalogue(library)
    rows = _chosen(catalogue, sweeps, ids)
    if to.suffix == ".csv":
        everything = catalogue.rows()
        write_whole(to, _csv([everything[row] for row in rows]))
    elif to.suffix == ".parquet":
        sink = pa.BufferOutputStream()
        pq.write_table(catalogue.table().take(rows), sink, compression="zstd")
        write_whole(to, sink.getvalue().to_pybytes())
    else:
        everything = catalogue.rows(["id"])
        _library(library, to, [everything[row]["id"] for row in rows])
    return len(rows)


def _chosen(catalogue: Catalogue, sweeps: Sequence[str], ids: Sequence[str]) -> list[int]:
    rows = catalogue.rows(["id", "sweep"])
    for sweep in sweeps:
        known = list(dict.fromkeys(row["sweep"] for row in rows))
        if sweep not in known:
            there = ", ".join(known)
            raise nacre.InputError(f"{catalogue.library}: has no sweep {sweep}; it has {there}")
    for start in ids:
        if not any(row["id"].startswith(start) for row in rows):
            raise nacre.InputError(f"{catalogue.library}: has no record {start}")
    return [
        i
        for i, row in enumerate(rows)
        if (not sweeps or row["sweep"] in sweeps)
        and (not ids or any(row["id"].startswith(start) for start in ids))
    ]


def _csv(rows: Sequence[dict[str, Any]]) -> str:
    tables = [_flat(row) for row in rows]
    columns = list(dict.fromkeys(name for table in tables for name in table))
    text = io.StringIO()
    writer = csv.DictWriter(text, columns, restval="", lineterminator="\n")
    writer.writeheader()
    writer.writerows(tables)
    return text.getvalue()


def _flat(row: dict[str, Any]) -> dict[str, Any]:
    flat = {name: row[name] for name in _PLAIN}
    flat["pigments"] = "; ".join(row["pigments"])
    for geometry, Lab in zip(row["geometries"], row["Lab"], strict=True):
        flat |= {f"{c}_{geometry}": value for c, value in zip("Lab", Lab, strict=True)}
    for lamp in row["sparkle"] or []:
        name = f"{lamp['lamp_deg']:g}s"
        flat |= {f"{key}_{name}": lamp[key] for key in ("spots_per_cm2", "intensity", "sparkle")}
    flat |= row["swept"] | row["swept_names"]
    return {name: _cell(value) for name, value in flat.items()}


def _cell(value: Any) -> Any:
    """A text that a spreadsheet would run as a formula is written with an apostrophe in front, as
    all of Nacre's CSV."""
    if isinstance(value, str) and re.match(r"'*[=+@-]", value):
        return "'" + value
    return "" if value is None else value


def _library(library: Path, to: Path, ids: Sequence[str]) -> None:
    if to.exists() and to.suffix != ".zip":
        raise nacre.Error(f"{to}: is there already")
    with tempfile.TemporaryDirectory(dir=to.absolute().parent, prefix=".export-") as room:
        part = Path(room) / to.stem
        part.mkdir()
        for name in (LIBRARY, LICENSE, CITATION):
            shutil.copyfile(library / name, part / name)
        write_whole(part / PLANNED, "".join(f"{identity}\n" for identity in ids))
        for identity in ids:
            shutil.copytree(record_folder(library, identity), record_folder(part, identity))
        write_catalogue(part, ids)
        if to.suffix == ".zip":
            archive = Path(room) / "archive.zip"
            with zipfile.ZipFile(archive, "w", zipfile.ZIP_DEFLATED) as zipped:
                for file in sorted(part.rglob("*")):
                    zipped.write(file, file.relative_to(part.parent))
            archive.replace(to)
        else:
            part.rename(to)
