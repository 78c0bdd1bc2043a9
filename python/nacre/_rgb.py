"""From spectra to linear Rec. 709 by a few wavelengths, for renderers that know three colours."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from . import _film
from ._arrays import Floats

XYZ_TO_SRGB = np.array(
    [
        [3.2404541621, -1.5371385128, -0.4985314096],
        [-0.9692660305, 1.8760108454, 0.0415560175],
        [0.0556434310, -0.2040259135, 1.0572251882],
    ]
)
"""From XYZ under D65 to linear Rec. 709 (IEC 61966-2-1)."""


def shown_alike(lab: Floats) -> Floats:
    """Encoded sRGB (N, C, 3) of CIELAB relative to D65, for colours that are shown side by side:
    those of a row are dimmed alike where one is brighter than the display. Clipped to the gamut."""
    f = np.empty_like(lab)
    f[..., 1] = (lab[..., 0] + 16) / 116
    f[..., 0] = f[..., 1] + lab[..., 1] / 500
    f[..., 2] = f[..., 1] - lab[..., 2] / 200
    white = np.linalg.inv(XYZ_TO_SRGB).sum(axis=1)
    xyz = white * np.where(f > 6 / 29, f**3, 3 * (6 / 29) ** 2 * (f - 4 / 29))
    linear = xyz @ XYZ_TO_SRGB.T
    brightest = np.maximum(linear.max(axis=(1, 2), keepdims=True), 1)
    linear = np.clip(linear / brightest, 0, 1)
    encoded = np.where(linear <= 0.0031308, 12.92 * linear, 1.055 * linear ** (1 / 2.4) - 0.055)
    return np.asarray(encoded)


def weights(nm: Floats) -> Floats:
    """(3, bands): linear Rec. 709 under D65 of what is linear between these wavelengths."""
    if len(nm) == 1:
        return np.ones((3, 1))
    fine = np.arange(nm[0], nm[-1] + 0.5)
    hats = np.array([np.interp(fine, nm, row) for row in np.eye(len(nm))])
    xyz = _film.xyz(fine, hats, observer="2") / 100
    return np.asarray(XYZ_TO_SRGB @ xyz.T)


def resample(values: NDArray[Any], nm: Floats, at: Floats) -> Floats:
    """Linear along the last axis, from its wavelengths to others."""
    if np.array_equal(nm, at):
        return np.asarray(values, dtype=np.float64)
    position = np.clip(np.interp(at, nm, np.arange(len(nm))), 0, len(nm) - 1)
    low = np.minimum(position.astype(int), max(len(nm) - 2, 0))
    part = position - low
    high = np.minimum(low + 1, len(nm) - 1)
    values = np.asarray(values, dtype=np.float64)
    return np.asarray(values[..., low] * (1 - part) + values[..., high] * part)
