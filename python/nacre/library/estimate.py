"""What a plan will cost, measured on some of its records."""

from __future__ import annotations

import contextlib
import tempfile
import time
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

import nacre

from .record import write_record
from .settings import Settings
from .sweep import PlannedRecord


@dataclass(frozen=True)
class Cost:
    """Of a record, as the mean over those that were measured."""

    measured: int
    seconds: float
    """of one thread"""
    bytes: float


def spread(records: Sequence[PlannedRecord], count: int) -> list[PlannedRecord]:
    """Some records, evenly spread over all of them."""
    count = min(count, len(records))
    return [records[int((i + 0.5) * len(records) / count)] for i in range(count)]


def measure_cost(records: Sequence[PlannedRecord], settings: Settings) -> Cost:
    """Computes records with one thread into a folder that is deleted afterwards.

    Those that fail cost what they took until then. What Nacre loads once for all records is
    loaded before, by the first record.
    """
    sizes: list[int] = []
    seconds: list[float] = []
    with nacre.threads(1), tempfile.TemporaryDirectory(prefix="nacre-library-") as folder:
        for i, record in enumerate([records[0], *records]):
            room = Path(folder) / str(i)
            room.mkdir()
            start = time.perf_counter()
            with contextlib.suppress(nacre.Error):
                write_record(room, record, settings)
            seconds.append(time.perf_counter() - start)
            sizes.append(sum(file.stat().st_size for file in room.iterdir()))
    count = len(records)
    return Cost(count, sum(seconds[1:]) / count, sum(sizes[1:]) / count)


def shown_time(seconds: float) -> str:
    """For people, as "3 h 20 min"."""
    if seconds < 90:
        return f"{seconds:.2g} s" if seconds < 10 else f"{seconds:.0f} s"
    minutes = round(seconds / 60)
    return f"{minutes} min" if minutes < 90 else f"{minutes // 60} h {minutes % 60:02} min"


def shown_size(size: float) -> str:
    """For people, as "3.2 GB"."""
    units = ["B", "kB", "MB", "GB", "TB"]
    while size >= 1000 and len(units) > 1:
        size /= 1000
        units.pop(0)
    return f"{size:.3g} {units[0]}"
