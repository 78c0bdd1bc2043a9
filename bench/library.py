#!/usr/bin/env python3
"""What a library of paints costs: seconds and bytes a record, how workers scale, how fast a search is.

    PYTHONPATH=build/python build/python-tools/bin/python bench/library.py [--records N] [--plan FILE]

Without a plan: readings alone, of pearls whose films and flakes vary. Times are of whole runs, the
start of the workers and the catalogue included; run it on a machine that does nothing else.
"""

from __future__ import annotations

import argparse
import statistics
import tempfile
import time
from pathlib import Path

import numpy as np

import nacre
from nacre.library import Plan, engine
from nacre.library.find import Standard, _Search
from nacre.library.index import Index, IndexWriter

PLAN = """
[[sweep]]
name = "pearls"
base = "pearl-gold"
method = "sobol"
count = {records}
[sweep.vary]
"coats[0].thickness_nm" = {{ from = 40, to = 160 }}
"orientation.alpha" = {{ from = 0.1, to = 0.25 }}
"flakes[0].volume_fraction" = {{ from = 0.02, to = 0.1, scale = "log" }}
"""


def size_of(folder: Path) -> int:
    """As the file system counts it, in whole blocks."""
    return sum(512 * file.stat().st_blocks for file in folder.rglob("*"))


def scaling(plan: Plan, folder: Path, most: int) -> None:
    alone = 0.0
    print("workers  seconds  records/s  efficiency  kB/record")
    for workers in [0] + [2**k for k in range(most.bit_length()) if 2**k <= most]:
        library = folder / str(workers)
        done = engine.run(plan, library, workers=workers)
        alone = done.seconds if workers == 1 else alone
        efficiency = f"{alone / done.seconds / workers:10.3f}" if workers else "   no Dask"
        size = size_of(library) / done.planned / 1000
        rate = done.planned / done.seconds
        print(f"{workers:7}  {done.seconds:7.1f}  {rate:9.2f}  {efficiency}  {size:9.1f}", flush=True)


def search(folder: Path, records: int) -> None:
    """Made-up paints: the colours of two shipped ones at six angles, and much noise."""
    rng = np.random.default_rng(0)
    reading = nacre.Paint("pearl-gold").measure()
    head = {
        "geometries": reading.geometries,
        "theta_i_deg": reading.theta_i_deg.tolist(),
        "theta_o_deg": reading.theta_o_deg.tolist(),
        "phi_deg": reading.phi_deg.tolist(),
    }
    bases = [reading.Lab, nacre.Paint("metallic-silver").measure().Lab]
    writer = IndexWriter()
    for i in range(records):
        Lab = bases[i % 2] * rng.normal(1, 0.2, (6, 1)) + rng.normal(0, 8, (1, 3))
        record = {"id": f"{i:032x}", "construction": "", "settings": {}, "sparkle": None}
        writer.add({**record, "graininess": None, "readings": {**head, "Lab": Lab}})
    folder.mkdir()
    writer.write(folder)
    index = Index.open(folder)
    seconds = []
    with nacre.threads(1):
        for _ in range(50):
            Lab = np.asarray(index.Lab[:, rng.integers(records)]).T + rng.normal(0, 2, (6, 3))
            start = time.perf_counter()
            _Search(index, Standard("", Lab, list(range(6)), None), 0.0).nearest(10)
            seconds.append(time.perf_counter() - start)
    median, worst = statistics.median(seconds), max(seconds)
    print(f"search among {records}: median {1000 * median:.1f} ms, longest {1000 * worst:.1f} ms")


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--records", type=int, default=1000)
    parser.add_argument("--workers", type=int, default=2, help="at most")
    parser.add_argument("--plan", type=Path, help="instead of --records")
    chosen = parser.parse_args()
    with tempfile.TemporaryDirectory() as room:
        file = chosen.plan or Path(room) / "plan.toml"
        if not chosen.plan:
            file.write_text(PLAN.format(records=chosen.records), encoding="utf-8")
        plan = Plan(file)
        scaling(plan, Path(room), chosen.workers)
        search(Path(room) / "index", 100_000)


if __name__ == "__main__":
    main()
