"""Scripts for Blender, before Python's compiler and, where it is installed, before Cycles."""

from __future__ import annotations

import ast
import importlib.util
import json
import math
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest
from nacre._rgb import XYZ_TO_SRGB
from numpy.typing import NDArray

import nacre

NM = [400.0, 430, 460, 490, 520, 550, 580, 610, 640, 670, 700]


def lab(rgb: NDArray[np.float64]) -> NDArray[np.float64]:
    """CIELAB (N, 3) of linear Rec. 709, relative to its white [cie-15-2018]."""
    xyz_of_rgb = np.linalg.inv(XYZ_TO_SRGB)
    t = rgb @ xyz_of_rgb.T / xyz_of_rgb.sum(axis=1)
    f = np.where(t > (6 / 29) ** 3, np.cbrt(t), t * (29 / 6) ** 2 / 3 + 4 / 29)
    return np.stack(
        [116 * f[:, 1] - 16, 500 * (f[:, 0] - f[:, 1]), 200 * (f[:, 1] - f[:, 2])], axis=-1
    )


def test_a_script_holds_what_was_fitted_and_what_it_misses(paints: Path, tmp_path: Path) -> None:
    file = tmp_path / "ruby.blender.py"
    fitted = nacre.Paint(paints / "ruby.toml").write(file, wavelengths_nm=NM)
    assert isinstance(fitted, nacre.FittedMaterial)
    text = file.read_text(encoding="utf-8")
    (paint,) = (
        ast.literal_eval(node.value)
        for node in ast.parse(text).body
        if isinstance(node, ast.Assign) and ast.unparse(node.targets[0]) == "PAINT"
    )
    assert paint["name"] == "Ruby"
    assert 12e-6 < paint["flake_size"] < 25e-6  # between those of its two kinds of flakes
    for k, lobe in enumerate(paint["lobes"], start=1):
        for key in ("roughness", "widening", "lean"):
            assert lobe[key] == pytest.approx(fitted.parameters[f"lobe {k} {key}"], rel=1e-5)
    # The diffuse colour and the lobes' are at most 1 together, so that no light is made.
    colors = np.array([lobe["color"] for lobe in paint["lobes"]])
    assert colors.shape == (3, 4, 3)
    assert np.all(colors >= 0)
    assert np.all(colors.sum(axis=0) + paint["diffuse"] <= 1 + 1e-5)
    assert paint["coat"] == {"ior": 1.5, "roughness": 0}
    for angle, delta_e in (fitted.delta_e_2000 | fitted.tested_delta_e_2000).items():
        assert f"{angle} {delta_e:.1f}" in text


@pytest.mark.parametrize("name", ["red-gold", "satin-silver"])
def test_cycles_misses_the_paint_by_what_the_script_says(
    name: str, paints: Path, tmp_path: Path
) -> None:
    if importlib.util.find_spec("bpy") is None:
        pytest.skip("there is no package bpy, which is Blender with Cycles")
    paint = nacre.Paint(paints / f"{name}.toml")
    file = tmp_path / f"{name}.blender.py"
    fitted = paint.write(file, wavelengths_nm=NM)
    assert isinstance(fitted, nacre.FittedMaterial)
    said = fitted.delta_e_2000 | fitted.tested_delta_e_2000
    standard = paint.measure(list(said), illuminant="D65", observer=2, wavelengths_nm=NM)
    angles = np.stack([standard.theta_i_deg, standard.theta_o_deg, standard.phi_deg], axis=-1)
    rendered = subprocess.run(
        [sys.executable, Path(__file__).with_name("blender_patch.py"), file],
        input=json.dumps(angles.tolist()),
        capture_output=True,
        text=True,
        check=True,
    )
    (line,) = (row for row in rendered.stdout.splitlines() if row.startswith("BRDF "))
    factor = math.pi * np.array(json.loads(line.removeprefix("BRDF ")))
    seen = lab(factor)
    missed = nacre.delta_e_2000(standard.Lab, seen)
    # Cycles evaluates ramps by tables of 256 colours, in single precision.
    np.testing.assert_allclose(missed, list(said.values()), atol=0.05)
