"""Paints in Mitsuba as its tests ask them: at single directions, without a picture."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import drjit as dr
import mitsuba as mi
import numpy as np
from nacre.mitsuba._bands import single
from numpy.typing import NDArray

Array = NDArray[np.float64]
NODES = [410.0, 490.0, 560.0, 630.0]
"""Wavelengths in nm."""


def directions(count: int) -> tuple[Array, Array]:
    """Pairs of them, half near the mirror direction."""
    rng = np.random.default_rng(7)

    def upwards(n: int) -> Array:
        z, phi = rng.uniform(0.1, 1, n), rng.uniform(0, 2 * np.pi, n)
        s = np.sqrt(1 - z * z)
        return np.stack([s * np.cos(phi), s * np.sin(phi), z], axis=-1)

    wi, wo = upwards(count), upwards(count)
    near = wi[::2] * [-1, -1, 1] + rng.normal(0, 0.1, (len(wi[::2]), 3))
    near[:, 2] = np.abs(near[:, 2]) + 0.01
    wo[::2] = near / np.linalg.norm(near, axis=-1, keepdims=True)
    return wi, wo


def vectors(w: Array) -> Any:
    return mi.Vector3f(*[mi.Float(single(x)) for x in w.T])


def interaction(wi: Array, wavelengths: list[float]) -> Any:
    si = dr.zeros(mi.SurfaceInteraction3f, len(wi))
    si.wi = vectors(wi)
    si.sh_frame = mi.Frame3f(mi.Vector3f(0, 0, 1))
    if mi.is_spectral:
        si.wavelengths = mi.UnpolarizedSpectrum(*wavelengths)
    return si


def bsdf(recipe: Path, **settings: Any) -> Any:
    return mi.load_dict({"type": "nacre", "recipe": str(recipe), **settings})


def disagreement(got: Array, want: Array) -> float:
    return float(np.max(np.abs(got - want) / (np.abs(want) + 1e-3 * np.max(np.abs(want)))))
