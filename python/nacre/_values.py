"""What a paint hands back."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from ._arrays import Floats, Floats32


@dataclass(frozen=True)
class Parameter:
    """A number of a recipe, by its key."""

    key: str
    value: float
    lo: float
    hi: float
    unit: str


@dataclass(frozen=True)
class Solution:
    """How finely a paint was solved, and the solver's estimates of its own errors."""

    wavelengths_nm: Floats
    """(W,)"""
    exit_nodes: int
    inner_nodes: int
    orders: int
    """azimuthal Fourier orders"""
    unresolved_scattering: float
    """fraction by which the quadrature misses scattering in some direction"""
    azimuthal_tail: float
    """last azimuthal orders over the peak"""


@dataclass(frozen=True)
class Reference:
    """A BRDF by random walks, estimates that owe nothing to the solver."""

    brdf: Floats
    """(..., W) in 1/sr"""
    standard_error: Floats
    """(..., W) of the BRDF, from the walks themselves; of little worth above 5 % of it"""
    samples: int
    """walks per direction of the lamp"""


@dataclass(frozen=True)
class Sample:
    """Directions drawn by a paint's BRDF."""

    wo: Floats32
    """(..., 3) unit vectors; zero where no light leaves"""
    weight: Floats32
    """(..., W): f cos / pdf, or the reflectance over its probability for the specular lobe"""
    pdf: Floats32
    """(...) per solid angle, 1/sr; of the specular lobe, its probability"""
    kind: NDArray[np.int8]
    """(...) -1 none, 0 by density, 1 specular, 2 by a random walk of unknown density"""

    @property
    def valid(self) -> NDArray[np.bool_]:
        valid: NDArray[np.bool_] = self.kind >= 0
        return valid

    @property
    def specular(self) -> NDArray[np.bool_]:
        specular: NDArray[np.bool_] = self.kind == 1
        return specular


@dataclass(frozen=True)
class Export:
    """The error of a written table against the BRDF, over incidences from 5 to 80 deg."""

    error_of_flux: float
    error_over_peak: float


@dataclass(frozen=True)
class ShaderMaterial:
    """How far a shader made of a paint is from the paint, under D65 for 2 degrees."""

    delta_e_2000: dict[str, float]
    """By geometry: byk-mac's, and lamps at 15, 30, 60 and 75 degrees."""
    mean_delta_e_2000: float
    max_delta_e_2000: float


@dataclass(frozen=True)
class FittedMaterial:
    """A material of another renderer, and its CIEDE2000 from the paint (docs/export.md)."""

    parameters: dict[str, float]
    """By the format's names."""
    delta_e_2000: dict[str, float]
    """At byk-mac's angles, which are fitted among others."""
    mean_delta_e_2000: float
    max_delta_e_2000: float
    tested_delta_e_2000: dict[str, float]
    """At angles that the fit did not see."""
    tested_mean_delta_e_2000: float
    tested_max_delta_e_2000: float
