"""From drawdowns to pigments."""

from __future__ import annotations

import os
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from . import _html, _nacre
from ._errors import naming
from ._film import MaterialLike, _native
from ._progress import Progress, reporter


@dataclass(frozen=True, eq=False)
class DrawdownFit:
    """One application of the paint, as measured and by the coefficients found."""

    ground: str
    thickness_um: float
    volume_fraction: float
    measured: NDArray[np.float64]
    """(W,)"""
    modelled: NDArray[np.float64]
    """(W,)"""
    white_volume_fraction: float
    """of a known white beside it, in a tint"""
    opaque: bool
    """so thick that nothing is seen of the ground; ``thickness_um`` says nothing then"""
    dE2000: float | None
    """under D65 for the observer of 10 deg; None where 400 to 700 nm are not covered"""


@dataclass(frozen=True, eq=False)
class Pigment:
    """Coefficients of a pigment in 1/mm, for a volume fraction of 1, each of shape (W,)."""

    wavelengths_nm: NDArray[np.float64]
    scattering_per_mm: NDArray[np.float64]
    absorption_per_mm: NDArray[np.float64]
    scattering_error: NDArray[np.float64]
    """standard errors; NaN where the noise is not known, infinite where not determined"""
    absorption_error: NDArray[np.float64]
    noise: float | None
    """standard deviation of a reading, given or from the residuals"""
    rms_residual: float
    hidden_nm: NDArray[np.float64]
    """where the paint hides its grounds, so that only the ratio of both is determined"""
    absorption_only_nm: NDArray[np.float64]
    """of tints: where scattering is known to no better than half of itself"""
    scattering_assumed: bool
    """all tints have one ratio of pigment to white: scattering was taken as 0"""
    drawdowns: list[DrawdownFit]
    toml: str
    """what a recipe names by `from`, once it is written to a file"""

    def _repr_html_(self) -> str:
        rows = np.stack([self.scattering_per_mm, self.absorption_per_mm])
        names, colours = ("scattering", "absorption"), ("#1f77b4", "#d62728")
        what = "scattering (blue) and absorption (red), 1/mm,"
        return _html.spectra(self.wavelengths_nm, rows, names, colours, what)

    def write(self, path: str | os.PathLike[str]) -> None:
        """Write the file that a recipe names by ``from`` in ``[[layer.pigment]]``."""
        _nacre.write_text(os.fspath(path), self.toml)


@naming()
def pigment(
    drawdown: str | os.PathLike[str],
    *,
    geometry: str = "d8-included",
    binder: MaterialLike = 1.5,
    anisotropy: float = 0.0,
    matt_ground: bool = False,
    noise: float | None = None,
    white: str | os.PathLike[str] | None = None,
    name: str = "pigment",
    progress: Progress = False,
) -> Pigment:
    """A pigment's coefficients from drawdowns over black and white, or from tints in a known white
    (docs/drawdown.md).

    Parameters
    ----------
    drawdown
        CSV with the columns ground, thickness_um (0: the bare ground), volume_fraction, and one for
        each wavelength in nm; of tints white_volume_fraction. A thickness may be ``opaque``.
    geometry
        How it was read: ``d8-included`` (sphere, with gloss), ``d8-excluded``, ``45-0``.
    binder
        Its index: a number or a material.
    anisotropy
        g of the pigment, in (-1, 1), which a drawdown does not determine.
    matt_ground
        The bare grounds have no glossy surface.
    noise
        Standard deviation of a reading; None: from the residuals.
    white
        The white of tints: the name of a pigment that ships, such as ``rutile-white``, or the file
        of one.
    name
        What people call the pigment.

    Raises
    ------
    InputError
        If the file is wrong: line, column, value and allowed range.
    DomainError
        If it cannot tell scattering from absorption, or a number is out of range.
    Stopped
        If ``progress`` returned False.
    """
    with reporter(progress, "pigment") as report:
        found = _nacre.pigment(
            os.fspath(drawdown),
            geometry,
            _native(binder),
            anisotropy,
            matt_ground,
            noise,
            None if white is None else os.fspath(white),
            name,
            report,
        )
    found["drawdowns"] = [DrawdownFit(**d) for d in found["drawdowns"]]
    return Pigment(**found)
