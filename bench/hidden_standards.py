#!/usr/bin/env python3
"""Standards of unknown construction against a library: does nacre fit --library find them?

    PYTHONPATH=build/python build/python-tools/bin/python bench/hidden_standards.py out/library

What follows -- are options of nacre fit, as -- --starts 3.

Twenty standards come from the families of library/sweep.toml, at other points than its records, and
three from none of them. nacre fit is given the readings alone: spectra, L*a*b* or, of every third,
L*a*b* with an instrument's noise. docs/library.md has the table that is printed.
"""

from __future__ import annotations

import argparse
import csv
import json
import os
import resource
import subprocess
import sys
import tempfile
import time
import tomllib
from dataclasses import dataclass
from pathlib import Path

import numpy as np

import nacre
from nacre._toml import dumps
from nacre.library import Plan
from nacre.library.construction import construction

ROOT = Path(__file__).resolve().parent.parent
NOISE = 0.1
"""Standard deviation of a noisy standard's L*, a* and b*: what instruments repeat."""
MORE = {"titania on mica", "aluminium", "tinted aluminium", "iron oxide on silica on aluminium"}
"""Families of which three standards are drawn; of the others one."""

OUTSIDE = """
[[sweep]]
name = "gold on glass in green"
base = "glass-flake"
[sweep.set]
"layer[0].flakes[0].coats" = [{ material = "Au", thickness_nm = 18, spread_nm = 1 }]
"layer[0].flakes[0].volume_fraction" = 0.03
"layer[0].pigment" = [{ absorption_per_mm = { wavelengths_nm = [400, 480, 520, 580, 620, 700], values = [160, 90, 8, 60, 190, 120] }, scattering_per_mm = 3 }]

[[sweep]]
name = "yellow solid"
base = "white"
[sweep.set]
"layer[0].pigment" = [{ absorption_per_mm = { wavelengths_nm = [400, 470, 500, 530, 560, 700], values = [700, 620, 300, 12, 1, 0.3] }, scattering_per_mm = 150 }]

[[sweep]]
name = "copper flakes over cyan"
base = "white-pearl"
[sweep.set]
"layer[0].flakes" = [{ volume_fraction = 0.006, diameter_um = 15, orientation = { distribution = "beckmann", alpha = 0.15 }, core = { material = "Cu", thickness_nm = 200, spread_nm = 20 } }]
"layer[1].pigment[0].absorption_per_mm" = { wavelengths_nm = [400, 500, 560, 620, 700], values = [20, 2, 30, 500, 300] }
"""


@dataclass(frozen=True)
class Standard:
    """A paint to be found, of which the fit sees the readings only."""

    paint: nacre.Paint
    family: str
    construction: str
    inside: bool


def drawn(plan: Path, folder: Path, seed: int) -> list[Standard]:
    """From each sweep that varies, by a Latin hypercube of other seeds than the plan's."""
    tables = tomllib.loads(plan.read_text("utf-8"))
    sweeps = []
    for sweep in tables["sweep"]:
        if "vary" not in sweep:
            continue
        vary = {
            key: {k: v for k, v in axis.items() if k != "steps"} if isinstance(axis, dict) else axis
            for key, axis in sweep["vary"].items()
        }
        count = 3 if sweep["name"] in MORE else 1
        drawing = {"method": "latin-hypercube", "count": count, "seed": seed + len(sweeps)}
        sweeps.append({**sweep, **drawing, "vary": vary})
    return planned(folder, dumps({"sweep": sweeps}), inside=True)


def planned(folder: Path, text: str, inside: bool) -> list[Standard]:
    """The paints of a plan."""
    (folder / "plan.toml").write_text(text, "utf-8")
    paints = [
        (nacre.Paint.from_dict(record.recipe), record.sweep)
        for record in Plan(folder / "plan.toml").records()
    ]
    # As a record's: with the names that "from" stands for.
    return [
        Standard(paint, sweep, construction(paint.to_dict()), inside) for paint, sweep in paints
    ]


def write_readings(standard: Standard, number: int, file: Path) -> str:
    """Writes what an instrument hands over, and returns what kind that is."""
    reading = standard.paint.measure("byk-mac")
    Lab = reading.Lab
    kind = ("spectra", "L\\*a\\*b\\*", "noisy")[number % 3]
    if kind == "noisy":
        Lab = Lab + np.random.default_rng(number).normal(0, NOISE, Lab.shape)
    with open(file, "w", encoding="utf-8", newline="") as out:
        writer = csv.writer(out, lineterminator="\n")
        nm = reading.wavelengths_nm if kind == "spectra" else []
        writer.writerow(["geometry", "L", "a", "b", *(f"R{x:g}" for x in nm)])
        for i, name in enumerate(reading.geometries):
            spectrum = [f"{x:.5f}" for x in reading.R[i]] if kind == "spectra" else []
            writer.writerow([name, *(f"{x:.2f}" for x in Lab[i]), *spectrum])
    return kind


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("library", type=Path)
    parser.add_argument("--nacre", type=Path, default=ROOT / "build" / "nacre")
    parser.add_argument("--plan", type=Path, default=ROOT / "library" / "sweep.toml")
    parser.add_argument("--seed", type=int, default=2026)
    parser.add_argument("--only", type=int, nargs="*", help="numbers of standards, from 1")
    words = sys.argv[1:]
    ours = words.index("--") if "--" in words else len(words)
    given = parser.parse_args(words[:ours])
    print("| | family | given as | nearest | fitted: mean | max | construction | status | CPU s |")
    print("| --- | --- | --- | --- | --- | --- | --- | --- | --- |")
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        standards = drawn(given.plan, folder, given.seed) + planned(folder, OUTSIDE, inside=False)
        for number, standard in enumerate(standards, start=1):
            if given.only and number not in given.only:
                continue
            file = folder / f"standard-{number}.csv"
            kind = write_readings(standard, number, file)
            before = resource.getrusage(resource.RUSAGE_CHILDREN)
            start = time.monotonic()
            command = [given.nacre.resolve(), "fit", file, "--library", given.library, "--format", "json"]
            done = subprocess.run(
                [*command, "--quiet", *words[ours + 1 :]], capture_output=True, text=True, check=False
            )
            if done.returncode not in (0, 4):
                raise SystemExit(f"standard {number}: {done.stderr}")
            after = resource.getrusage(resource.RUSAGE_CHILDREN)
            found = json.loads(done.stdout)
            best = found["constructions"][0]
            nearest = min(one["nearest_mean_delta_e_2000"] for one in found["constructions"])
            same = best["construction"] == standard.construction
            row = [
                str(number),
                standard.family + ("" if standard.inside else " (in no family)"),
                kind,
                f"{nearest:.2f}",
                f"{found['difference']['mean_delta_e_2000']:.3f}",
                f"{found['difference']['max_delta_e_2000']:.3f}",
                "right" if same else best["construction"].replace("|", "\\|"),
                str(done.returncode),
                f"{after.ru_utime - before.ru_utime:.0f}",
            ]
            print("| " + " | ".join(row) + " |", flush=True)
            if os.environ.get("VERBOSE"):
                print(standard.paint.name, standard.construction, time.monotonic() - start)
                for one in found["constructions"]:
                    print("   ", json.dumps(one))


if __name__ == "__main__":
    main()
