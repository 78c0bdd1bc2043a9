"""Materials, thin films, and colours of spectra."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from contextlib import suppress
from dataclasses import dataclass
from html import escape
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _html, _nacre
from ._arrays import ABOUT_WAVELENGTHS, Floats, doubles
from ._errors import DomainError, SettingError, naming

WAVELENGTHS_NM: Floats = np.arange(400.0, 701.0, 10.0)
"""The default wavelengths, nm."""
WAVELENGTHS_NM.flags.writeable = False


class Material:
    """A substance by its refractive index n + ik; k >= 0 absorbs.

    Parameters
    ----------
    index
        A number, complex or as text ("3.18+3.33i"); the name of a shipped material
        (:func:`material_names`); or the path of a file (.csv, .yml of refractiveindex.info).

    Raises
    ------
    InputError
        With what was tried and the names that exist.
    DomainError
        If a number is out of range.
    """

    def __init__(self, index: str | complex) -> None:
        if isinstance(index, str):
            self._material = _nacre.Material(index)
        else:
            self._material = _nacre.Material.constant(complex(index))

    @classmethod
    @naming(wavelengths_nm=("*must increase", "*wavelengths and"), n="*: n = ", k="*: k = ")
    def sampled(
        cls, name: str, wavelengths_nm: ArrayLike, n: ArrayLike, k: ArrayLike = 0.0
    ) -> Material:
        """From samples (W,) between which n and k are linear.

        Raises
        ------
        SettingError
            If wavelengths do not increase, shapes differ, or an index is out of range.
        """
        nm, n_values = doubles(wavelengths_nm), doubles(n)
        if n_values.shape != nm.shape:
            raise SettingError(
                f"n: has the shape {n_values.shape}, wavelengths_nm {nm.shape}", setting="n"
            )
        try:
            k_values = np.ascontiguousarray(np.broadcast_to(doubles(k), nm.shape))
        except ValueError as error:
            raise SettingError(f"k: {error}", setting="k") from error
        material = cls.__new__(cls)
        material._material = _nacre.Material.sampled(name, nm, n_values, k_values)
        return material

    @property
    def name(self) -> str:
        """As it was asked for."""
        return str(self._material.name)

    @property
    def source(self) -> str:
        """Where the data come from."""
        return str(self._material.source)

    @naming(wavelengths_nm=ABOUT_WAVELENGTHS)
    def index(self, wavelengths_nm: ArrayLike) -> NDArray[np.complex128]:
        """n + ik at vacuum wavelengths in nm, of their shape.

        Raises
        ------
        DomainError
            If the data do not reach there.
        """
        return self._material.index(doubles(wavelengths_nm))

    def __reduce__(self) -> tuple[Callable[..., Material], tuple[Any, ...]]:
        return _from_state, self._material.state()

    def __repr__(self) -> str:
        return f"Material({self.name!r})"

    def _repr_html_(self) -> str:
        known = []
        for nm in WAVELENGTHS_NM:
            with suppress(DomainError):  # the data do not reach there
                known.append((nm, complex(self.index(nm))))
        nm, index = np.array([w for w, _ in known]), np.array([m for _, m in known], complex)
        rows, colours = np.stack([index.real, index.imag]), ("#1f77b4", "#d62728")
        return f"<div>{escape(repr(self))}</div>" + _html.spectra(
            nm, rows, ("n", "k"), colours, "n (blue) and k (red)"
        )


def _from_state(*state: Any) -> Material:
    material = Material.__new__(Material)
    material._material = _nacre.Material.from_state(*state)
    return material


MaterialLike = Material | str | complex | float


def material_names() -> list[str]:
    """Names of the shipped materials."""
    return list(_nacre.material_names())


def _native(material: MaterialLike) -> Any:
    return material._material if isinstance(material, Material) else Material(material)._material


@dataclass(frozen=True, eq=False)
class Film:
    """Reflectance and transmittance of a stack of films."""

    R: Floats
    """(..., W)"""
    T: Floats
    """(..., W): the power that enters the substrate; 1 - R - T is absorbed in the films"""
    wavelengths_nm: Floats
    """(W,) vacuum wavelengths"""
    angles_deg: Floats
    """(...) angles of incidence in the ambient"""

    @property
    def Lab(self) -> Floats:
        """(..., 3) CIELAB of R under D65 for 10 degrees."""
        return lab(self.wavelengths_nm, self.R)

    @property
    def srgb(self) -> Floats:
        """(..., 3) chips of R: encoded sRGB in [0, 1]."""
        return srgb(self.Lab)

    def _repr_html_(self) -> str:
        labels = [f"{angle:g}°" for angle in self.angles_deg.reshape(-1)[:16]]
        rows = self.R.reshape(-1, self.wavelengths_nm.size)[: len(labels)]
        chips, colours = "", ["#777777"] * len(labels)
        with suppress(DomainError):  # wavelengths of which no colour is made
            shown = self.srgb.reshape(-1, 3)[:16]
            chips, colours = _html.chips(shown, labels), [_html.css(chip) for chip in shown]
        return chips + _html.spectra(self.wavelengths_nm, rows, labels, colours, "reflectance")


@naming(angles_deg="angle in deg", wavelengths_nm=ABOUT_WAVELENGTHS, layers="thickness")
def film(
    layers: Iterable[tuple[MaterialLike, float]],
    *,
    ambient: MaterialLike = 1.0,
    substrate: MaterialLike = 1.0,
    angles_deg: ArrayLike = 0.0,
    wavelengths_nm: ArrayLike = WAVELENGTHS_NM,
    polarization: str = "u",
) -> Film:
    """A stack of flat, coherent films between two half spaces.

    Parameters
    ----------
    layers
        Index and thickness in nm of each film, from the ambient inwards.
    ambient, substrate
        Above and below; the ambient must be transparent.
    angles_deg
        Angles of incidence in the ambient, [0, 90], of any shape (...).
    wavelengths_nm
        Vacuum wavelengths (W,).
    polarization
        ``s`` (perpendicular to the plane of incidence), ``p`` (parallel) or ``u`` (unpolarised).

    Returns
    -------
    Film
        R and T of shape (..., W).

    Raises
    ------
    InputError
        If there is no such material.
    DomainError
        If a number is out of range.
    """
    stack = [(_native(material), float(thickness)) for material, thickness in layers]
    # Copies, as the result keeps them.
    angles, nm = doubles(angles_deg).copy(), np.atleast_1d(doubles(wavelengths_nm)).copy()
    reflected, transmitted = _nacre.film(
        _native(ambient),
        [material for material, _ in stack],
        [thickness for _, thickness in stack],
        _native(substrate),
        angles,
        nm,
        polarization,
    )
    return Film(reflected, transmitted, nm, angles)


@naming(wavelengths_nm=ABOUT_WAVELENGTHS)
def xyz(
    wavelengths_nm: ArrayLike,
    reflectance: ArrayLike,
    *,
    illuminant: str = "D65",
    observer: str | int = "10",
) -> Floats:
    """XYZ (..., 3) of reflectances (..., W) at wavelengths in equal steps; the perfect diffuser has
    Y = 100. Illuminants: A, D50, D65, FL2, FL11, E; observers: 2 and 10 degrees.

    Raises
    ------
    DomainError
        If wavelengths are not in equal steps, or a name is none of these.
    """
    nm, values = doubles(wavelengths_nm), doubles(reflectance)
    colours: tuple[Floats, Floats] = _nacre.colours(nm, values, illuminant, str(observer))
    return colours[0]


@naming(wavelengths_nm=ABOUT_WAVELENGTHS)
def lab(
    wavelengths_nm: ArrayLike,
    reflectance: ArrayLike,
    *,
    illuminant: str = "D65",
    observer: str | int = "10",
) -> Floats:
    """CIELAB (..., 3), relative to the perfect diffuser, of reflectances, as :func:`xyz`."""
    nm, values = doubles(wavelengths_nm), doubles(reflectance)
    colours: tuple[Floats, Floats] = _nacre.colours(nm, values, illuminant, str(observer))
    return colours[1]


@naming()
def delta_e_2000(lab1: ArrayLike, lab2: ArrayLike) -> Floats:
    """CIEDE2000 differences (...) of CIELAB colours (..., 3), broadcast together."""
    return _nacre.delta_e_2000(doubles(lab1), doubles(lab2))


@naming()
def srgb(lab: ArrayLike, *, full_light: bool = False) -> Floats:
    """Chips (..., 3) of CIELAB colours: encoded sRGB in [0, 1], the perfect diffuser being white.

    Colours outside the gamut are clipped; brighter ones too, unless with `full_light`, which scales
    them down until they fit.
    """
    return _nacre.srgb_chip(doubles(lab), full_light)


@dataclass(frozen=True, eq=False)
class Chips:
    """Colours as a notebook shows them: a row of squares, labelled.

    >>> Chips([[50, 0, 0]], ["grey"]).css
    ['#777777']
    """

    Lab: ArrayLike
    """(N, 3)"""
    labels: Sequence[str]
    """(N,)"""

    @property
    def css(self) -> list[str]:
        """`#rrggbb`, bright colours scaled down until they fit."""
        return [_html.css(chip) for chip in self._srgb()]

    def _srgb(self) -> Floats:
        colours = doubles(self.Lab)
        if colours.size == 0:
            return np.empty((0, 3))
        return srgb(colours, full_light=True).reshape(-1, 3)

    def _repr_html_(self) -> str:
        return _html.chips(self._srgb(), self.labels)
