#!/usr/bin/env python3
"""How many samples a second Mitsuba takes of a painted ball, beside its own rough conductor.

    PYTHONPATH=build/python build/python-tools/bin/python bench/mitsuba_rates.py
        [--paint metallic-silver] [--variant llvm_ad_spectral] [--spp 64] [--size 512] [--runs 5]
        [--pictures FOLDER]

The ball fills 30 % of the picture and lies under a lamp and an even sky. Printed is the median of
the runs, after one that compiles; the fastest and the slowest say how busy the machine was.
"""

from __future__ import annotations

import argparse
import statistics
import time
from pathlib import Path
from typing import Any

import drjit as dr
import mitsuba as mi
import nacre.mitsuba


def ball(bsdf: dict[str, Any], size: int, spp: int) -> Any:
    look_at = mi.ScalarTransform4f().look_at
    return mi.load_dict(
        {
            "type": "scene",
            "integrator": {"type": "path", "max_depth": 3},
            "sensor": {
                "type": "perspective",
                "fov": 18.5,
                "to_world": look_at([0, -400, 0], [0, 0, 0], [0, 0, 1]),
                "film": {"type": "hdrfilm", "width": size, "height": size},
                "sampler": {"type": "independent", "sample_count": spp},
            },
            "ball": {"type": "sphere", "radius": 40.0, "bsdf": bsdf},
            "lamp": {
                "type": "rectangle",
                "to_world": look_at([200, -200, 300], [0, 0, 0], [0, 0, 1]).scale(60),
                "emitter": {"type": "area", "radiance": {"type": "d65", "scale": 20.0}},
            },
            "sky": {"type": "constant", "radiance": {"type": "d65", "scale": 0.3}},
        }
    )


def seconds(scene: Any, spp: int, seed: int) -> float:
    started = time.perf_counter()
    dr.eval(mi.render(scene, spp=spp, seed=seed))
    dr.sync_thread()
    return time.perf_counter() - started


def main() -> None:
    parser = argparse.ArgumentParser(description=(__doc__ or "").splitlines()[0])
    parser.add_argument("--paint", default="metallic-silver")
    parser.add_argument("--variant", default="llvm_ad_spectral")
    parser.add_argument("--spp", type=int, default=64)
    parser.add_argument("--size", type=int, default=512)
    parser.add_argument("--runs", type=int, default=5)
    parser.add_argument("--pictures", type=Path, help="a folder for what was rendered")
    options = parser.parse_args()
    mi.set_variant(options.variant)

    paint = {"type": "nacre", "recipe": options.paint}
    surfaces = {
        "rough conductor": {"type": "roughconductor", "material": "Al", "alpha": 0.2},
        "microflake": {**paint, "model": "microflake"},
        "nacre, mean": paint,
        "nacre, single flakes": paint,
    }
    samples = options.size**2 * options.spp
    print(f"{'Msamples/s':22}  median  slowest  fastest  first run, s")
    for name, bsdf in surfaces.items():
        scene = ball(bsdf, options.size, options.spp)
        if name.endswith("flakes"):
            nacre.mitsuba.attach(scene)
        first = seconds(scene, options.spp, 0)
        times = [seconds(scene, options.spp, seed + 1) for seed in range(options.runs)]
        rates = [1e-6 * samples / t for t in (statistics.median(times), max(times), min(times))]
        print(f"{name:22}" + "".join(f"{r:9.2f}" for r in rates) + f"{first:15.1f}", flush=True)
        if options.pictures:
            picture = mi.render(scene, spp=options.spp, seed=1)
            file = options.pictures / f"{name.replace(', ', '-').replace(' ', '-')}.png"
            mi.util.write_bitmap(str(file), picture)


if __name__ == "__main__":
    main()
