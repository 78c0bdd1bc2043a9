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
        ("satin-silver", "nacre", "clearcoat.roughness"),
        ("satin-silver", "nacre", "diameter_um"),
        ("satin-silver", "nacre", "ior"),
        ("satin-silver", "nacre", "waviness"),
        ("tio2-mica-80", "nacre", "ior"),
        ("tio2-mica-80", "microflake", "ior"),
        ("tio2-mica-80", "nacre", "flakes[0].diameter_um"),
        ("tio2-mica-80", "nacre", "diameter_spread_um"),
        ("tio2-mica-80", "nacre", "core.thickness_nm"),
        ("tio2-mica-80", "nacre", "coats[0].spread_nm"),
        ("tio2-mica-80", "nacre", "layer[0].thickness_um"),
        ("tio2-mica-80", "nacre", "substrate.reflectance"),
        ("solid-red", "nacre", "anisotropy"),
        ("solid-red", "nacre", "scattering_per_mm.max"),
        ("solid-red", "nacre", "pigment[0].absorption_per_mm.max"),
        ("tinted-grey", "nacre", "pigment[0].diameter_nm"),
        ("tinted-grey", "nacre", "pigment[0].spread"),
        ("tinted-grey", "nacre", "pigment[0].volume_fraction"),
    ],
)
def test_gradients_are_those_of_finite_differences(
    paints: Path, name: str, model: str, key: str
) -> None:
    recipe = paints / f"{name}.toml"
    paint = nacre.Paint(recipe)
    step = (0.01 if key == "ior" else 0.02) * paint[key]
    want, got = derivatives(paint, model, key, paint[key] - step, paint[key] + step)
    assert np.max(np.abs(got - want)) < 0.03 * np.max(np.abs(want))
    accepted = 0.02 if key == "diameter_spread_um" else 0.01  # which is of the hot spot alone
    assert np.median(np.abs(got - want)) < accepted * np.median(np.abs(want))


def derivatives(
    paint: nacre.Paint, model: str, key: str, low: float, high: float
) -> tuple[Array, Array]:
    """By a number: differences of Nacre's values, and the gradient in Mitsuba."""
    wi, wo = directions(50)

    def values(at: float) -> Array:
        changed = paint.with_values({key: at})
        return np.asarray(changed.brdf(wi, wo, NODES, model=model, as_rendered=True) * wo[:, 2:])

    want = (values(high) - values(low)) / (high - low)
    surface = mi.load_dict(
        {"type": "nacre", "toml": paint.to_toml(), "model": model, "differentiate": key}
    )
    params = mi.traverse(surface)
    assert key in params
    dr.enable_grad(params[key])
    params.update()
    si = interaction(wi, NODES)
    value = surface.eval(mi.BSDFContext(), si, vectors(wo))
    dr.forward_from(params[key])
    return want, np.array(dr.grad(value)).T


@pytest.mark.parametrize(
    ("name", "key", "high"),
    [
        ("tio2-mica-80", "substrate.reflectance", 0.01),  # of which the hot spot has a table
        ("tio2-mica-80", "clearcoat.absorption_per_mm", 0.1),
        ("ruby", "scattering_per_mm", 0.1),
    ],
)
def test_gradients_by_numbers_that_are_zero(paints: Path, name: str, key: str, high: float) -> None:
    paint = nacre.Paint(paints / f"{name}.toml").with_values({key: 0})
    want, got = derivatives(paint, "nacre", key, 0, high)
    assert np.max(np.abs(want)) > 0
    assert np.max(np.abs(got - want)) < 0.03 * np.max(np.abs(want))


def test_patterns_name_one_number_or_are_refused(paints: Path) -> None:
    recipe = paints / "tio2-mica-80.toml"
    assert "*.volume_fraction" in mi.traverse(bsdf(recipe, differentiate="*.volume_fraction"))
    with pytest.raises(RuntimeError, match=r"thickness_nm: means 2 numbers, .*; must mean one"):
        bsdf(recipe, differentiate="layer*thickness_nm")


def test_scalar_variants_list_no_parameters_that_they_cannot_change(paints: Path) -> None:
    mi.set_variant("scalar_spectral")
    surface = bsdf(paints / "tio2-mica-80.toml", differentiate=THICKNESS)
    assert THICKNESS not in mi.traverse(surface)
    with pytest.raises(RuntimeError, match="is not a number of this recipe"):
        bsdf(paints / "tio2-mica-80.toml", differentiate="thikness")


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
