"""What arguments may be, and how they become arrays."""

from __future__ import annotations

import os
from collections.abc import Sequence
from typing import Any, TypeAlias

import numpy as np
from numpy.typing import ArrayLike, NDArray

Floats: TypeAlias = NDArray[np.float64]
Floats32: TypeAlias = NDArray[np.float32]
Path: TypeAlias = str | bytes | os.PathLike[str] | os.PathLike[bytes]

ABOUT_WAVELENGTHS = ("wavelength", 'material "')
"""What begins the library's messages about them, for :func:`naming`."""


def doubles(values: ArrayLike) -> Floats:
    """As the extensions want them: double precision, in one piece."""
    return np.asarray(values, dtype=np.float64, order="C")


def wavelengths(values: ArrayLike | None) -> Floats | None:
    """One axis, or None where they are chosen by the paint."""
    if values is None:
        return None
    array = doubles(values)
    return array if array.ndim == 1 else array.reshape(-1)


def direction(theta_deg: ArrayLike, phi_deg: ArrayLike = 0.0) -> Floats:
    """The unit vectors (..., 3) of polar angles from the normal and azimuths, in degrees.

    >>> direction(90, 0).round(12)
    array([1., 0., 0.])
    """
    theta, phi = np.broadcast_arrays(np.radians(theta_deg), np.radians(phi_deg))
    sine = np.sin(theta)
    return np.stack([sine * np.cos(phi), sine * np.sin(phi), np.cos(theta)], axis=-1)


def texts(values: str | Sequence[str] | None) -> list[str]:
    if values is None:
        return []
    return [values] if isinstance(values, str) else list(values)


def optional(module: str, what: str, package: str | None = None) -> Any:
    """A module of an optional package. Raises ImportError saying what it is for."""
    import importlib

    try:
        return importlib.import_module(module)
    except ImportError as error:
        raise ImportError(
            f"{what} needs another package: pip install {package or module}"
        ) from error
