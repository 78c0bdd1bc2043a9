"""A paint as a material of three.js: an ES module with its textures inside.

The shader comes from src/nacre/exchange/webgl_shader.h. What the file says about its error is found
by the same arithmetic, from the same textures.
"""

from __future__ import annotations

import base64
import json
import os
from importlib import resources
from typing import Any

import numpy as np

from . import _html, _nacre, _rgb
from ._arrays import Floats, direction
from ._measurement import Measurement
from ._values import ShaderMaterial

Path = str | os.PathLike[str]


def module(shader: _nacre.WebglShader, about: dict[str, Any]) -> str:
    """The ES module; about: what `about` in it says."""
    replaced = {
        "ABOUT": json.dumps(about, indent=2, ensure_ascii=True),
        "SMOOTH_COAT": json.dumps(shader.smooth_coat),
        "GLSL": json.dumps(shader.glsl),
    }
    for name, (size, halves) in shader.textures.items():
        key = name.removeprefix("nacre").upper()
        replaced[f"{key}_SIZE"] = json.dumps(size)
        replaced[key] = json.dumps(base64.b64encode(halves).decode("ascii"))
    text = (resources.files(__package__) / "_threejs.js").read_text(encoding="utf-8")
    for name, value in replaced.items():
        text = text.replace(f"'@{name}@'", value)
    return text


# Its error

LAMPS_DEG, ASPECULAR_DEG = (15, 30, 60, 75), (15, 25, 45, 75)


def geometries() -> list[str]:
    """At which a file says how far it is from the paint."""
    byk_mac = [f"45as{angle}" for angle in (-15, 15, 25, 45, 75, 110)]
    return byk_mac + [f"{lamp}as{angle}" for lamp in LAMPS_DEG for angle in ASPECULAR_DEG]


def lab(xyz: Floats) -> Floats:
    """CIELAB (N, 3) relative to D65, whose Y is 1 [cie-15-2018]."""
    t = xyz / np.linalg.inv(_rgb.XYZ_TO_SRGB).sum(axis=1)
    f = np.where(t > (6 / 29) ** 3, np.cbrt(t), t * (29 / 6) ** 2 / 3 + 4 / 29)
    return np.stack(
        [116 * f[:, 1] - 16, 500 * (f[:, 0] - f[:, 1]), 200 * (f[:, 1] - f[:, 2])], axis=-1
    )


def differences(shader: _nacre.WebglShader, standard: Measurement) -> ShaderMaterial:
    """From what an instrument reads of the paint under D65 for 2 degrees."""
    wi = direction(standard.theta_i_deg)
    wo = direction(standard.theta_o_deg, standard.phi_deg)
    rgb = np.maximum(shader.brdf(wi, wo), 0)
    xyz = np.pi * rgb @ np.linalg.inv(_rgb.XYZ_TO_SRGB).T
    shown = lab(xyz)
    delta = _nacre.delta_e_2000(standard.Lab, shown)
    by_angle = dict(zip(standard.geometries, map(float, delta), strict=True))
    both = np.stack([standard.Lab, shown], axis=1)
    return ShaderMaterial(by_angle, float(delta.mean()), float(delta.max()), both)


def write(
    paint: _nacre.Paint, path: Path, model: _nacre.Model, standard: Measurement, progress: Any
) -> ShaderMaterial:
    """standard: the paint, read at geometries() under D65 for 2 degrees."""
    shader = _nacre.webgl_shader(paint, model, progress)
    error = differences(shader, standard)
    about = {
        "name": paint.name,
        "generator": f"Nacre {_nacre.version()}",
        "recipe_sha256": paint.sha256,
        "colour_differences": {
            "from": "the paint by the model nacre, in CIEDE2000 under D65 for 2 degrees",
            "by_angle": {name: round(de, 2) for name, de in error.delta_e_2000.items()},
            "chips": {  # of CSS: the paint's, the material's
                name: [_html.css(colour) for colour in pair]
                for name, pair in zip(error.delta_e_2000, _rgb.shown_alike(error.Lab), strict=True)
            },
            "mean": round(error.mean_delta_e_2000, 2),
            "greatest": round(error.max_delta_e_2000, 2),
        },
    }
    _nacre.write_text(path, module(shader, about))
    return error
