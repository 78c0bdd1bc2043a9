"""What a paint hands back."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from . import _html, _rgb
from ._arrays import Floats, Floats32


@dataclass(frozen=True)
class Parameter:
    """A number of a recipe, by its key."""

    key: str
    value: float
    lo: float
    hi: float
    unit: str


@dataclass(frozen=True, eq=False)
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


@dataclass(frozen=True, eq=False)
class Reference:
    """A BRDF by random walks, estimates that owe nothing to the solver."""

    brdf: Floats
    """(..., W) in 1/sr"""
    standard_error: Floats
    """(..., W) of the BRDF, from the walks themselves; of little worth above 5 % of it"""
    samples: int
    """walks per direction of the lamp"""


@dataclass(frozen=True, eq=False)
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
        """(...) whether light leaves"""
        valid: NDArray[np.bool_] = self.kind >= 0
        return valid

    @property
    def specular(self) -> NDArray[np.bool_]:
        """(...) whether it does in the specular direction of a smooth interface"""
        specular: NDArray[np.bool_] = self.kind == 1
        return specular


@dataclass(frozen=True)
class Export:
    """The error of a written table against the BRDF, over incidences from 5 to 80 deg."""

    error_of_flux: float
    error_over_peak: float


def _side_by_side(title: str, lab: Floats, delta_e_2000: dict[str, float]) -> str:
    """Colours of the paint, and below them the material's."""
    notes = [f"ΔE {delta_e:.1f}" for delta_e in delta_e_2000.values()]
    chips = _html.chip_pairs(_rgb.shown_alike(lab), list(delta_e_2000), notes)
    return f"<div>{title}: paint above, material below</div>{chips}"


@dataclass(frozen=True, eq=False)
class ShaderMaterial:
    """How far a shader made of a paint is from the paint, under D65 for 2 degrees. A notebook shows
    the colours of both, one above the other."""

    delta_e_2000: dict[str, float]
    """By geometry: byk-mac's, and lamps at 15, 30, 60 and 75 degrees."""
    mean_delta_e_2000: float
    max_delta_e_2000: float
    Lab: Floats
    """(geometries, 2, 3): CIELAB of the paint and of the shader"""

    def _repr_html_(self) -> str:
        return _side_by_side("Shader", self.Lab, self.delta_e_2000)


@dataclass(frozen=True, eq=False)
class FittedMaterial:
    """A material of another renderer, and its CIEDE2000 from the paint (docs/export.md). A notebook
    shows the colours of both, one above the other."""

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
    Lab: Floats
    """(6, 2, 3): CIELAB of the paint and of the material at byk-mac's angles, under D65 for 2
    degrees"""
    tested_Lab: Floats
    """(geometries, 2, 3): the same at angles that the fit did not see"""

    def _repr_html_(self) -> str:
        return (
            _side_by_side("byk-mac's angles", self.Lab, self.delta_e_2000)
            + _side_by_side(
                "Angles that the fit did not see", self.tested_Lab, self.tested_delta_e_2000
            )
            + _html.table(["parameter", ""], list(self.parameters.items()))
        )


def _by_angle(differences: _Differences) -> tuple[dict[str, float], float, float]:
    return {angle[0]: angle[1] for angle in differences[0]}, *differences[1:]


def _lab(differences: _Differences) -> Floats:
    return np.array([angle[2:] for angle in differences[0]])


def shader_material(differences: _Differences) -> ShaderMaterial:
    """Of what the extension gives."""
    return ShaderMaterial(*_by_angle(differences), _lab(differences))


def fitted_material(
    parameters: list[tuple[str, float]], seen: _Differences, tested: _Differences
) -> FittedMaterial:
    """Of what the extension gives."""
    return FittedMaterial(
        dict(parameters), *_by_angle(seen), *_by_angle(tested), _lab(seen), _lab(tested)
    )


_Differences = tuple[list[tuple[str, float, list[float], list[float]]], float, float]
