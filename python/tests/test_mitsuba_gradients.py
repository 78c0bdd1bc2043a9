"""Gradients of paints in Mitsuba 3 by keys of their recipes."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest

import nacre

pytest.importorskip("mitsuba", reason="Mitsuba is not installed here")

import mitsuba as mi
from mitsuba_backends import BACKENDS
from mitsuba_surfaces import NODES, Array, bsdf, directions, interaction, vectors

dr = pytest.importorskip("drjit")

THICKNESS, AMOUNT, ALPHA = "coats[0].thickness_nm", "volume_fraction", "orientation.alpha"


@pytest.fixture(autouse=True, params=BACKENDS)
def _backend(request: pytest.FixtureRequest) -> None:
    mi.set_variant(f"{request.param}_ad_spectral")


@pytest.mark.parametrize(
    ("name", "model", "key"),
    [
        ("tio2-mica-80", "microflake", THICKNESS),
        ("tio2-mica-80", "microflake", AMOUNT),
        ("tio2-mica-80", "microflake", ALPHA),
        ("tio2-mica-80", "nacre", AMOUNT),
        ("satin-silver", "nacre", ALPHA),
    ],
)
def test_gradients_are_those_of_finite_differences(
    paints: Path, name: str, model: str, key: str
) -> None:
    recipe = paints / f"{name}.toml"
    wi, wo = directions(50)
    paint = nacre.Paint(recipe)
    step = 0.02 * paint[key]

    def values(at: float) -> Array:
        changed = paint.with_values({key: at})
        return np.asarray(changed.brdf(wi, wo, NODES, model=model, as_rendered=True) * wo[:, 2:])

    want = (values(paint[key] + step) - values(paint[key] - step)) / (2 * step)
    surface = bsdf(recipe, model=model, differentiate=key)
    params = mi.traverse(surface)
    assert key in params
    dr.enable_grad(params[key])
    params.update()
    si = interaction(wi, NODES)
    value = surface.eval(mi.BSDFContext(), si, vectors(wo))
    dr.forward_from(params[key])
    got = np.array(dr.grad(value)).T
    assert np.max(np.abs(got - want)) < 0.03 * np.max(np.abs(want))
    assert np.median(np.abs(got - want)) < 0.01 * np.median(np.abs(want))


def test_gradients_flow_from_a_picture_to_the_recipe(paints: Path) -> None:
    """Of the mean of a picture by three keys at once; differences of pictures of the same random
    numbers have no noise of their own."""
    keys = (THICKNESS, AMOUNT, ALPHA)
    scene = mi.load_dict(
        {
            "type": "scene",
            "integrator": {"type": "direct", "emitter_samples": 1, "bsdf_samples": 0},
            "sensor": {
                "type": "perspective",
                "fov": 12,
                "to_world": mi.ScalarTransform4f().look_at([0, -400, 0], [0, 0, 0], [0, 0, 1]),
                "film": {"type": "hdrfilm", "width": 8, "height": 8},
            },
            "ball": {
                "type": "sphere",
                "radius": 40.0,
                "bsdf": {
                    "type": "nacre",
                    "recipe": str(paints / "tio2-mica-80.toml"),
                    "model": "microflake",
                    "differentiate": ", ".join(keys),
                },
            },
            "sky": {"type": "constant", "radiance": {"type": "d65"}},
        }
    )
    params = mi.traverse(scene)
    known = list(params.keys())
    names = {key: next(n for n in known if n.endswith(key)) for key in keys}
    seed = 3

    def mean_at(name: str, value: Any) -> float:
        params[name] = mi.Float(value)
        params.update()
        return float(np.array(mi.render(scene, spp=64, seed=seed)).mean())

    want = {}
    for key, name in names.items():
        was = float(dr.slice(params[name]))
        low, high = 0.99 * was, 1.01 * was
        want[key] = (mean_at(name, high) - mean_at(name, low)) / (high - low)
        params[name] = mi.Float(was)
    for name in names.values():
        dr.enable_grad(params[name])
    params.update()
    picture = mi.render(scene, params, spp=64, seed=seed + 1, seed_grad=seed)
    dr.backward(dr.mean(picture, axis=None))
    for key, name in names.items():
        got = float(dr.slice(dr.grad(params[name])))
        assert got == pytest.approx(want[key], rel=5e-3), key
