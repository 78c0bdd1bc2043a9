"""The catalogue: one Parquet file with a row a record, made from the records alone."""

from __future__ import annotations

import hashlib
from collections.abc import Iterable
from pathlib import Path
from typing import Any

import numpy as np
import pyarrow as pa
import pyarrow.parquet as pq

import nacre

from .construction import label
from .folder import CITATION, LIBRARY, LICENSE, PLANNED
from .index import FOLDER as INDEX
from .index import IndexWriter
from .record import Record, read_record, record_folder
from .sweep import SCHEMA
from .table import is_number

FILE = "catalogue.parquet"

_NUMBERS = pa.map_(pa.string(), pa.float64())
_TRIPLES = pa.list_(pa.list_(pa.float64(), 3))
_SPARKLE_NUMBERS = ("spots_per_cm2", "intensity", "contrast", "area_percent", "sparkle")
_SPARKLE = pa.list_(
    pa.struct(
        [("lamp_deg", pa.float64())]
        + [(f"{n}{s}", pa.float64()) for n in _SPARKLE_NUMBERS for s in ("", "_se")]
    )
)

COLUMNS: list[tuple[str, pa.DataType]] = [
    ("id", pa.string()),
    ("name", pa.string()),
    ("sweep", pa.string()),
    ("base", pa.string()),
    ("construction", pa.string()),
    ("pigments", pa.list_(pa.string())),
    ("parameters", _NUMBERS),
    ("swept", _NUMBERS),
    ("swept_names", pa.map_(pa.string(), pa.string())),
    ("geometries", pa.list_(pa.string())),
    ("aspecular_deg", pa.list_(pa.float64())),
    ("Lab", _TRIPLES),
    ("srgb", _TRIPLES),
    ("R", pa.list_(pa.list_(pa.float32()))),
    ("wavelengths_nm", pa.list_(pa.float64())),
    ("illuminant", pa.string()),
    ("observer", pa.string()),
    ("flop_index", pa.float64()),
    ("colour_travel", pa.float64()),
    ("L45", pa.float64()),
    ("a45", pa.float64()),
    ("b45", pa.float64()),
    ("C45", pa.float64()),
    ("h45", pa.float64()),
    ("sparkle", _SPARKLE),
    ("graininess", pa.float64()),
    ("flakes_resolved", pa.bool_()),
    ("thumbnails", pa.list_(pa.string())),
    ("files", pa.list_(pa.string())),
    ("warnings", pa.list_(pa.string())),
    ("recipe_sha256", pa.string()),
    ("seconds", pa.float64()),
    ("version", pa.string()),
]


def schema() -> pa.Schema:
    """The columns, with the versions of the format and of Nacre as metadata."""
    return pa.schema(
        COLUMNS,
        metadata={"nacre:library_schema": str(SCHEMA), "nacre:version": nacre.__version__},
    )


def _row(record: Record) -> Record:
    readings = record["readings"]
    swept = record["swept"]
    numbers = {k: float(v) for k, v in swept.items() if is_number(v)}
    names = {k: label(v) for k, v in swept.items() if k not in numbers}
    row = {name: record[name] for name, _ in COLUMNS if name in record}
    row |= {name: readings[name] for name, _ in COLUMNS if name in readings}
    return row | {
        "parameters": list(record["parameters"].items()),
        "swept": list(numbers.items()),
        "swept_names": list(names.items()),
        **_at_45(readings),
        "thumbnails": [name for name in record["files"] if name.endswith(".png")],
        "files": [*record["files"], "record.json"],
        "seconds": record["seconds"]["total"],
    }


def _at_45(readings: Record) -> dict[str, float | None]:
    """The colour at 45 degrees from the gloss under a lamp at 45, where it was read."""
    if "45as45" not in readings["geometries"]:
        return dict.fromkeys(("L45", "a45", "b45", "C45", "h45"))
    lightness, a, b = readings["Lab"][readings["geometries"].index("45as45")]
    hue = float(np.degrees(np.arctan2(b, a)) % 360)
    return {"L45": lightness, "a45": a, "b45": b, "C45": float(np.hypot(a, b)), "h45": hue}


def write_catalogue(library: Path, ids: Iterable[str]) -> int:
    """Writes catalogue.parquet, the index of searches and checksums.sha256 over these records, in
    this order, each whole or not at all. Returns how many rows there are."""
    fresh = library / f".{FILE}"
    sums: list[str] = []
    rows = 0
    index = IndexWriter()
    ids = list(ids)
    with pq.ParquetWriter(fresh, schema(), compression="zstd") as writer:
        for start in range(0, len(ids), 10_000):
            batch: list[Record] = []
            for identity in ids[start : start + 10_000]:
                record = read_record(library, identity)
                batch.append(_row(record))
                index.add(record)
                sums += _checksums(library, record)
            writer.write_table(pa.Table.from_pylist(batch, schema=schema()))
            rows += len(batch)
    fresh.replace(library / FILE)
    index.write(library)
    for name in (LIBRARY, PLANNED, LICENSE, CITATION, FILE):
        sums.append(f"{_sha256(library / name)}  {name}\n")
    for file in sorted((library / INDEX).iterdir()):
        sums.append(f"{_sha256(file)}  {INDEX}/{file.name}\n")
    fresh_sums = library / ".checksums.sha256"
    fresh_sums.write_text("".join(sums), encoding="utf-8")
    fresh_sums.replace(library / "checksums.sha256")
    return rows


def _sha256(file: Path) -> str:
    return hashlib.sha256(file.read_bytes()).hexdigest()


def _checksums(library: Path, record: Record) -> list[str]:
    """Lines for ``sha256sum -c``; the files' own sums were taken when the record was computed."""
    folder = record_folder(library, record["id"])
    sums = {**record["files"], "record.json": _sha256(folder / "record.json")}
    place = folder.relative_to(library).as_posix()
    return [f"{sha256}  {place}/{name}\n" for name, sha256 in sums.items()]


class Catalogue:
    """A library's catalogue, opened."""

    def __init__(self, library: str | Path) -> None:
        """Opens catalogue.parquet of a library.

        Raises
        ------
        nacre.InputError
            If there is none, or it has another schema than this version reads.
        """
        self.library = Path(library)
        file = self.library / FILE
        if not file.is_file():
            raise nacre.InputError(f"{library}: is no library: it has no {FILE}")
        try:
            self._file = pq.ParquetFile(file)
        except pa.ArrowInvalid as error:
            raise nacre.InputError(f"{file}: is no Parquet file: {error}") from None
        metadata = self._file.schema_arrow.metadata or {}
        version = metadata.get(b"nacre:library_schema", b"none").decode()
        if version != str(SCHEMA):
            raise nacre.InputError(f"{file}: schema version {version}: this Nacre reads {SCHEMA}")

    def __len__(self) -> int:
        return int(self._file.metadata.num_rows)

    def table(self, columns: list[str] | None = None) -> pa.Table:
        """As an Arrow table; ``.to_pandas()`` makes a DataFrame of it."""
        return self._file.read(columns=columns)

    def rows(self, columns: list[str] | None = None) -> list[dict[str, Any]]:
        """As dictionaries, in the catalogue's order; maps are dictionaries too."""
        maps = ("parameters", "swept", "swept_names")
        rows: list[dict[str, Any]] = self.table(columns).to_pylist()
        for row in rows:
            row |= {name: dict(row[name]) for name in maps if name in row}
        return rows
