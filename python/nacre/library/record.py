"""A record: one paint's recipe with what was computed for it, in a folder of its own.

A record's folder appears by one rename, so that it is there whole or not at all, whatever is
killed.
"""

from __future__ import annotations

import hashlib
import json
import os
import shutil
import socket
import time
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import asdict, dataclass, field
from pathlib import Path
from typing import Any

import numpy as np

import nacre
from nacre import Measurement, Paint

from .construction import construction, ingredients
from .settings import PictureSettings, Settings
from .sweep import SCHEMA, PlannedRecord

Record = dict[str, Any]
"""What record.json holds (docs/library.md)."""


def record_folder(library: Path, identity: str) -> Path:
    return library / "records" / identity[:2] / identity


def failure_file(library: Path, identity: str) -> Path:
    return library / "failed" / f"{identity}.json"


def record_ids(library: Path) -> set[str]:
    """Of the records that are there."""
    found: set[str] = set()
    records = library / "records"
    if records.is_dir():
        for shelf in os.scandir(records):
            found.update(entry.name for entry in os.scandir(shelf.path))
    return found


def failures(library: Path) -> dict[str, Record]:
    """What failed and why, by the record's id."""
    folder = library / "failed"
    files = sorted(folder.glob("*.json")) if folder.is_dir() else []
    return {file.stem: json.loads(file.read_text(encoding="utf-8")) for file in files}


def read_record(library: Path, identity: str) -> Record:
    """record.json of a record that is there."""
    file = record_folder(library, identity) / "record.json"
    record: Record = json.loads(file.read_text(encoding="utf-8"))
    return record


@dataclass(frozen=True)
class Outcome:
    """How the computation of a record ended."""

    id: str
    seconds: float
    error: str = ""
    """empty: the record is there"""


@dataclass
class _Clock:
    """Wall-clock seconds of each step of a record."""

    steps: dict[str, float] = field(default_factory=dict)

    @contextmanager
    def step(self, name: str) -> Iterator[None]:
        start = time.perf_counter()
        try:
            yield
        finally:
            self.steps[name] = self.steps.get(name, 0.0) + time.perf_counter() - start

    @property
    def total(self) -> float:
        return sum(self.steps.values())


def compute(planned: PlannedRecord, settings: Settings, library: Path, threads: int = 1) -> Outcome:
    """Computes a record and puts it into the library; what goes wrong becomes a file in failed/.

    Parameters
    ----------
    threads
        To compute with, of the whole process; results do not depend on it.
    """
    if (record_folder(library, planned.id) / "record.json").is_file():
        return Outcome(planned.id, 0.0)
    nacre.set_threads(threads)
    clock = _Clock()
    room = library / ".work" / f"{planned.id}.{socket.gethostname()}.{os.getpid()}"
    try:
        shutil.rmtree(room, ignore_errors=True)
        room.mkdir(parents=True)
        write_record(room, planned, settings, clock)
        _put(room, record_folder(library, planned.id))
    except Exception as error:  # whatever it is, the rest goes on
        return record_failure(planned, library, error, clock.total)
    finally:
        shutil.rmtree(room, ignore_errors=True)
    failure_file(library, planned.id).unlink(missing_ok=True)
    return Outcome(planned.id, clock.total)


def _put(room: Path, folder: Path) -> None:
    folder.parent.mkdir(parents=True, exist_ok=True)
    try:
        room.rename(folder)
    except OSError:
        # Another worker, thought dead, may have been first: its record is the same.
        if not (folder / "record.json").is_file():
            raise


def record_failure(
    planned: PlannedRecord, library: Path, error: BaseException, seconds: float
) -> Outcome:
    """Writes down why a record failed. What Nacre refuses it refuses again, and is left alone by
    later runs; what may be the machine's fault is tried again."""
    message = f"{type(error).__name__}: {error}"
    report = {
        "schema": SCHEMA,
        "id": planned.id,
        "name": planned.name,
        "sweep": planned.sweep,
        "base": planned.base,
        "swept": planned.swept,
        "error": message,
        "again": not isinstance(error, nacre.Error),
        "host": socket.gethostname(),
    }
    file = failure_file(library, planned.id)
    file.parent.mkdir(parents=True, exist_ok=True)
    write_whole(file, json.dumps(report, indent=1, ensure_ascii=False) + "\n")
    return Outcome(planned.id, seconds, message)


def write_whole(file: Path, text: str | bytes) -> None:
    """Writes a file by a rename: whole or not at all."""
    data = text.encode() if isinstance(text, str) else text
    fresh = file.with_name(f".{file.name}.{socket.gethostname()}.{os.getpid()}")
    try:
        fresh.write_bytes(data)
        fresh.replace(file)
    finally:
        fresh.unlink(missing_ok=True)


def write_record(
    room: Path, planned: PlannedRecord, settings: Settings, clock: _Clock | None = None
) -> None:
    """Writes all files of a record into an empty folder.

    Raises
    ------
    nacre.Error
        If the recipe is refused, or a step of the computation fails.
    RuntimeError
        If another version of Nacre planned the record.
    """
    if planned.version != nacre.__version__:
        here = nacre.__version__
        raise RuntimeError(f"{here} is here, and Nacre {planned.version} was asked for")
    clock = clock or _Clock()
    with clock.step("recipe"):
        Paint.from_dict(planned.recipe).write(room / "recipe.toml")
        paint = Paint(room / "recipe.toml")  # what is computed is what the file says
    readings: list[Measurement] = []
    with clock.step("readings"):
        for file, geometry in settings.readings_files().items():
            reading = paint.measure(
                geometry,
                model=settings.model,
                illuminant=settings.illuminant,
                observer=settings.observer,
            )
            reading.write(room / file)
            readings.append(reading)
    record = _described(paint, planned, settings, readings)
    if settings.sparkle is not None:
        with clock.step("sparkle"):
            record |= _sparkle(paint, settings)
    for name, picture in settings.thumbnails.items():
        with clock.step(name):
            _render(paint, picture, room / f"{name}.png")
    if settings.reference is not None:
        with clock.step("reference"):
            _render(paint, settings.reference, room / "reference.exr")
    if settings.solved:
        with clock.step("solved"):
            paint.write(room / "solved.h5")
    if settings.rgl is not None:
        with clock.step("rgl"):
            rgl = settings.rgl
            paint.write(room / "paint.bsdf", resolution=rgl.resolution, incidences=rgl.incidences)
    record["warnings"] = [*paint.warnings, *paint.implausible]
    record["seconds"] = {**clock.steps, "total": clock.total}
    record["files"] = {
        file.name: hashlib.sha256(file.read_bytes()).hexdigest() for file in sorted(room.iterdir())
    }
    write_whole(
        room / "record.json",
        json.dumps(record, indent=1, ensure_ascii=False, allow_nan=False) + "\n",
    )


def _render(paint: Paint, picture: PictureSettings, file: Path) -> None:
    nacre.render(
        picture.scene,
        paint,
        spp=picture.samples,
        size=(picture.width, picture.height),
        noise=file.suffix == ".exr",
    ).write(file)


def _described(
    paint: Paint, planned: PlannedRecord, settings: Settings, readings: list[Measurement]
) -> Record:
    """What is known once the readings are; infinite and undefined numbers are None."""
    first = readings[0]
    recipe = paint.to_dict()
    return {
        "schema": SCHEMA,
        "id": planned.id,
        "name": planned.name,
        "sweep": planned.sweep,
        "base": planned.base,
        "swept": planned.swept,
        "version": nacre.__version__,
        "recipe_sha256": paint.sha256,
        "construction": construction(recipe),
        "pigments": ingredients(recipe),
        "parameters": {key: number.value for key, number in paint.parameters.items()},
        "settings": settings.to_dict(),
        "commands": {
            file: ["nacre", *settings.command(geometry)]
            for file, geometry in settings.readings_files().items()
        },
        "readings": _readings(readings),
        "flop_index": _number(first.flop_index),
        "colour_travel": _number(first.colour_travel),
        "sparkle": None,
        "graininess": None,
        "flakes_resolved": None,
    }


def _number(value: float | None) -> float | None:
    return None if value is None or not np.isfinite(value) else float(value)


_ANGLES = ("theta_i_deg", "aspecular_deg", "theta_o_deg", "phi_deg")
_COLOURS = ("Lab", "srgb", "R")


def _readings(readings: list[Measurement]) -> Record:
    """Of all sets, each geometry once, where it comes first."""
    first = readings[0]
    columns: dict[str, list[Any]] = {name: [] for name in ("geometries", *_ANGLES, *_COLOURS)}
    for reading in readings:
        for i, geometry in enumerate(reading.geometries):
            if geometry in columns["geometries"]:
                continue
            columns["geometries"].append(geometry)
            for name in _ANGLES:
                columns[name].append(_number(getattr(reading, name)[i]))
            for name in _COLOURS:
                columns[name].append(getattr(reading, name)[i].tolist())
    return {
        **columns,
        "wavelengths_nm": first.wavelengths_nm.tolist(),
        "illuminant": first.illuminant,
        "observer": first.observer,
    }


def _sparkle(paint: Paint, settings: Settings) -> Record:
    assert settings.sparkle is not None
    seen = paint.sparkle(**asdict(settings.sparkle))
    lamps = []
    for lamp in seen.lamps:
        estimates = {
            "spots_per_cm2": lamp.spots_per_cm2,
            "intensity": lamp.intensity,
            "contrast": lamp.contrast,
            "area_percent": lamp.area_percent,
            "sparkle": lamp.sparkle,
        }
        row: Record = {"lamp_deg": lamp.lamp_deg}
        for name, estimate in estimates.items():
            row[name] = None if estimate is None else _number(estimate.value)
            row[f"{name}_se"] = None if estimate is None else _number(estimate.standard_error)
        lamps.append(row)
    diffuse = seen.diffuse
    return {
        "sparkle": lamps,
        "graininess": None if diffuse is None else _number(diffuse.graininess.value),
        "graininess_se": None if diffuse is None else _number(diffuse.graininess.standard_error),
        "flakes_resolved": seen.flakes_resolved,
    }
