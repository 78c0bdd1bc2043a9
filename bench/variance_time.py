#!/usr/bin/env python3
"""Variance times time of Nacre's pictures of a ball, beside Mitsuba 3's.

    PYTHONPATH=build/python build/python-tools/bin/python bench/variance_time.py
        [--paint metallic-silver] [--spp 64 256] [--size 256] [--seeds 8]

The ball lies under an even sky and one rectangle; the same camera, shapes and lights in both.
Printed are, by surface: relative variance of a pixel's luminance, mean over the pixels that the
ball fills (from pictures of as many seeds); processor time of all threads for one sample of a
pixel, of the whole picture; and their product, variance at equal time, over that of the smooth
micro-flakes. Variances of both programs are of the luminance that their own wavelengths give.
"""

from __future__ import annotations

import argparse
import tempfile
import time
from collections.abc import Callable
from pathlib import Path
from typing import Any

import drjit as dr
import mitsuba as mi
import nacre
import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]
LUMINANCE = np.array([0.2126, 0.7152, 0.0722])  # of linear sRGB
SCENE = """
[camera]
position_mm = [0, -300, 150]
target_mm = [0, 0, 0]
up = [0, 0, 1]
vertical_fov_deg = 18
[environment]
type = "constant"
illuminant = "D65"
scale = 0.3
[[lights]]
type = "rectangle"
center_mm = [-300, -300, 600]
width_mm = 300
height_mm = 300
illuminant = "D65"
scale = 4
[[shapes]]
type = "sphere"
radius_mm = 40
material = "paint"
[materials.paint]
type = "paint"
"""


def in_mitsuba(bsdf: dict[str, Any], size: int, spp: int) -> Any:
    """SCENE, whose white has the luminance 1 in both programs."""
    look_at = mi.ScalarTransform4f().look_at
    return mi.load_dict(
        {
            "type": "scene",
            "integrator": {"type": "path", "max_depth": 5},
            "sensor": {
                "type": "perspective",
                "fov": 18.0,
                "fov_axis": "y",
                "to_world": look_at([0, -300, 150], [0, 0, 0], [0, 0, 1]),
                "film": {
                    "type": "hdrfilm",
                    "width": size,
                    "height": size,
                    "pixel_format": "luminance",
                    "rfilter": {"type": "box"},
                },
                "sampler": {"type": "multijitter", "sample_count": spp},
            },
            "ball": {"type": "sphere", "radius": 40.0, "bsdf": bsdf},
            "lamp": {
                "type": "rectangle",
                "to_world": look_at([-300, -300, 600], [0, 0, 0], [0, 1, 0]).scale(150),
                "emitter": {"type": "area", "radiance": {"type": "d65", "scale": 4.0}},
            },
            "sky": {"type": "constant", "radiance": {"type": "d65", "scale": 0.3}},
        }
    )


def mitsuba_pictures(bsdf: dict[str, Any], size: int, spp: int) -> Callable[[int], Array]:
    scene = in_mitsuba(bsdf, size, spp)

    def picture(seed: int) -> Array:
        rendered = mi.render(scene, spp=spp, seed=seed)
        dr.eval(rendered)
        dr.sync_thread()
        return np.array(rendered, dtype=np.float64)[..., 0]

    return picture


def nacre_pictures(
    scene: Path, paint: nacre.Paint, model: str | None, size: int, spp: int
) -> Callable[[int], Array]:
    def picture(seed: int) -> Array:
        seen = nacre.render(
            scene, paint, spp=spp, size=(size, size), model=model, seed=seed, noise=False
        )
        return np.asarray(seen.rgb, dtype=np.float64) @ LUMINANCE

    return picture


def measure(picture: Callable[[int], Array], seeds: int, ball: Array) -> tuple[float, float, float]:
    """Relative variance, processor seconds of a picture, and the mean, of the ball's pixels."""
    picture(1000)  # compiles, solves, binds
    started = time.process_time()
    pictures = np.array([picture(seed) for seed in range(1, seeds + 1)])
    seconds = (time.process_time() - started) / seeds
    seen = pictures[:, ball]
    mean = seen.mean(axis=0)
    return float(np.mean(seen.var(axis=0, ddof=1) / mean**2)), seconds, float(mean.mean())


def main() -> None:
    parser = argparse.ArgumentParser(description=(__doc__ or "").splitlines()[0])
    parser.add_argument("--paint", default="metallic-silver")
    parser.add_argument("--spp", type=int, nargs="+", default=[64, 256])
    parser.add_argument("--size", type=int, default=256)
    parser.add_argument("--seeds", type=int, default=8)
    options = parser.parse_args()
    mi.set_variant("llvm_ad_spectral")

    x, y = np.meshgrid(np.arange(options.size), np.arange(options.size))
    middle = 0.5 * (options.size - 1)
    # The ball's outline has a radius of .39 of the picture's height.
    ball = np.hypot(x - middle, y - middle) < 0.36 * options.size

    with tempfile.TemporaryDirectory() as folder:
        scene, table = Path(folder) / "scene.toml", Path(folder) / "paint.bsdf"
        scene.write_text(SCENE)
        paint = nacre.Paint(options.paint)
        paint.write(table, model="microflake")
        measured = {"type": "measured", "filename": str(table)}
        conductor = {"type": "roughconductor", "material": "Al", "alpha": 0.2}
        for spp in options.spp:
            size = options.size
            surfaces = {
                "microflake": nacre_pictures(scene, paint, "microflake", size, spp),
                "nacre": nacre_pictures(scene, paint, "nacre", size, spp),
                "its RGL file": nacre_pictures(scene, nacre.Paint(table), None, size, spp),
                "Mitsuba, RGL file": mitsuba_pictures(measured, size, spp),
                "Mitsuba, conductor": mitsuba_pictures(conductor, size, spp),
            }
            print(f"{spp:4} samples         mean  variance  ns/sample  variance x time", flush=True)
            first = 0.0
            for name, picture in surfaces.items():
                variance, seconds, mean = measure(picture, options.seeds, ball)
                nanoseconds = 1e9 * seconds / (size**2 * spp)
                product = variance * seconds
                first = first or product
                print(
                    f"{name:20}{mean:8.4f}{variance:10.2e}{nanoseconds:11.0f}{product / first:17.2f}",
                    flush=True,
                )


if __name__ == "__main__":
    main()
