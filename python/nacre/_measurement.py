"""What a multi-angle spectrophotometer reads."""

from __future__ import annotations

import os
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from . import _html, _nacre
from ._arrays import ABOUT_WAVELENGTHS, Floats, Path, doubles, optional
from ._errors import SettingError, naming

Geometries = str | Sequence[str] | None
"""A set by its name ("byk-mac"), a file of a set (.toml), or names as in "45as15" (lamp and
aspecular angle), "45as25az90" (out of the plane) and "45to30,90" (theta and phi of the view), as a
list or with commas; None: those of the readings, where there are some, else "byk-mac"."""


def geometry_sets() -> dict[str, str]:
    """The sets of geometries that are built in, and a line about each."""
    return dict(_nacre.geometry_sets())


def geometry_text(geometry: Geometries) -> str:
    if geometry is None:
        return ""
    if not isinstance(geometry, Sequence):
        raise TypeError(f"geometry: must be text or a list of it, not {type(geometry).__name__}")
    if len(geometry) == 0:
        raise SettingError("geometry: names none", setting="geometry")
    return geometry if isinstance(geometry, str) else ",".join(geometry)


@dataclass(frozen=True, eq=False)
class Difference:
    """Colour differences by geometry: sample less standard."""

    geometries: list[str]
    """(G,)"""
    Lab_standard: Floats
    """(G, 3)"""
    Lab_sample: Floats
    """(G, 3)"""
    dLab: Floats
    """(G, 3)"""
    dC: Floats
    """(G,) of chroma C*"""
    dH: Floats
    """(G,) of hue, Delta H*"""
    dE2000: Floats
    """(G,) CIEDE2000"""
    weights: Floats
    """(G,)"""
    mean_dE2000: float
    """weighted"""
    max_dE2000: float
    illuminant: str
    observer: str

    def to_pandas(self) -> Any:
        """A DataFrame, a row a geometry."""
        pandas = optional("pandas", "to_pandas()")
        columns: dict[str, object] = {"geometry": self.geometries}
        for label, values in (
            ("_standard", self.Lab_standard),
            ("_sample", self.Lab_sample),
        ):
            columns |= {f"{c}{label}": values[:, i] for i, c in enumerate("Lab")}
        columns |= {f"d{c}": self.dLab[:, i] for i, c in enumerate("Lab")}
        columns |= {"dC": self.dC, "dH": self.dH, "dE2000": self.dE2000, "weight": self.weights}
        return pandas.DataFrame(columns).set_index("geometry")

    def _repr_html_(self) -> str:
        return _html.table(
            ["geometry", "ΔL*", "Δa*", "Δb*", "ΔE2000"],
            [
                [name, *map(float, delta), float(de)]
                for name, delta, de in zip(self.geometries, self.dLab, self.dE2000, strict=True)
            ],
        )


class Measurement:
    """Readings at some geometries, computed or measured. Immutable.

    ``R`` is relative to the perfect diffuser (pi times the BRDF), ``XYZ`` has Y = 100 there; the
    specular reflection of a smooth interface is left out.
    """

    def __init__(self, readings: _nacre.Readings) -> None:
        """From the extension; see :meth:`Paint.measure`, :meth:`read`, :meth:`from_spectra`."""
        self._readings = readings

    @classmethod
    def read(cls, path: Path) -> Measurement:
        """A file that an instrument or Nacre wrote, CSV or JSON (docs/measure.md).

        Raises
        ------
        InputError
            Naming file, line and column or member of what is wrong.
        """
        from ._paint import Paint

        paint = Paint(path)
        if paint.kind != "measured_colours":
            raise SettingError(
                f"path = {os.fsdecode(path)}: holds no measured colours", setting="path"
            )
        return paint.measure()

    @classmethod
    @naming(wavelengths_nm=ABOUT_WAVELENGTHS)
    def from_spectra(
        cls,
        geometry: Geometries,
        wavelengths_nm: ArrayLike,
        R: ArrayLike,
        *,
        name: str = "",
        illuminant: str = "D65",
        observer: str | int = "10",
    ) -> Measurement:
        """From reflectance factors (G, W) at wavelengths in equal steps.

        Raises
        ------
        DomainError
            If shapes do not fit or wavelengths are not in equal steps.
        """
        text = geometry_text(geometry) or "byk-mac"
        return cls(
            _nacre.Readings.from_spectra(
                name, text, doubles(wavelengths_nm), doubles(R), illuminant, str(observer)
            )
        )

    @property
    def name(self) -> str:
        """Of the panel."""
        return str(self._readings.name)

    @property
    def geometries(self) -> list[str]:
        """(G,) as instruments print them: "45as15"."""
        return list(self._readings.geometries)

    @property
    def theta_i_deg(self) -> Floats:
        """(G,) polar angle of the lamp."""
        return self._readings.theta_i_deg

    @property
    def theta_o_deg(self) -> Floats:
        """(G,) polar angle of the view."""
        return self._readings.theta_o_deg

    @property
    def phi_deg(self) -> Floats:
        """(G,) azimuth of the view from the lamp's; 180 is the mirror side."""
        return self._readings.phi_deg

    @property
    def aspecular_deg(self) -> Floats:
        """(G,) angle between the view and the mirror direction."""
        return self._readings.aspecular_deg

    @property
    def wavelengths_nm(self) -> Floats:
        """(W,) vacuum wavelengths; empty where only colours are known."""
        return self._readings.wavelengths_nm

    @property
    def R(self) -> Floats:
        """(G, W) reflectance factor; NaN where a reading has a colour only."""
        return self._readings.R

    @property
    def standard_error(self) -> Floats | None:
        """(G, W) of R, where it was estimated by following light."""
        return self._readings.standard_error

    @property
    def XYZ(self) -> Floats:
        """(G, 3) tristimulus values; the perfect diffuser has Y = 100."""
        return self._readings.XYZ

    @property
    def Lab(self) -> Floats:
        """(G, 3) CIELAB relative to the perfect diffuser."""
        return self._readings.Lab

    @property
    def C(self) -> Floats:
        """(G,) chroma C*."""
        return self._readings.C

    @property
    def h(self) -> Floats:
        """(G,) hue angle, deg in [0, 360)."""
        return self._readings.h

    @property
    def illuminant(self) -> str:
        """A, D50, D65, FL2, FL11 or E: under which colours are stated."""
        return str(self._readings.illuminant)

    @property
    def observer(self) -> str:
        """ "2" or "10" degrees."""
        return str(self._readings.observer)

    @property
    def aperture_deg(self) -> tuple[float, float]:
        """Half angles of lamp and detector; 0 is a point."""
        lamp, detector = self._readings.aperture_deg
        return lamp, detector

    @property
    def flop_index(self) -> float | None:
        """None where 45as15, 45as45 and 45as110 were not all read."""
        return self._readings.flop_index

    @property
    def colour_travel(self) -> float | None:
        """Length of the path in a*b* as the view leaves the mirror direction; lit from 45 deg."""
        return self._readings.colour_travel

    @property
    def srgb(self) -> Floats:
        """(G, 3) chips: encoded sRGB in [0, 1], bright ones scaled down until they fit."""
        return _nacre.srgb_chip(self.Lab, True)

    def csv(self) -> str:
        """As the command line writes it (docs/measure.md)."""
        return str(self._readings.csv())

    def json(self) -> str:
        """The same as JSON."""
        return str(self._readings.json())

    def write(self, path: Path) -> None:
        """As CSV or JSON, by the extension; whole or not at all.

        Raises
        ------
        SettingError
            If the extension is neither.
        Error
            If the file cannot be written.
        """
        path = os.fsdecode(path)
        extension = os.path.splitext(path)[1]
        if extension not in (".csv", ".json"):
            raise SettingError(f"path = {path}: must end in .csv or .json", setting="path")
        _nacre.write_text(path, self.csv() if extension == ".csv" else self.json())

    @naming(weights="weight of")
    def difference(
        self, standard: Measurement, weights: Mapping[str, float] | None = None
    ) -> Difference:
        """Of this sample from a standard, at the geometries that both have.

        Parameters
        ----------
        weights
            In the mean, by the geometry's name, >= 0; others weigh 1.

        Raises
        ------
        DomainError
            If they have no geometry in common, or lights that neither can be restated under.
        """
        if not isinstance(standard, Measurement):
            raise TypeError(f"standard: must be a Measurement, not {type(standard).__name__}")
        return Difference(
            **_nacre.difference(standard._readings, self._readings, dict(weights or {}))
        )

    def to_pandas(self) -> Any:
        """A DataFrame, a row a geometry: angles, L, a, b, C, h, X, Y, Z, and R by wavelength."""
        pandas = optional("pandas", "to_pandas()")
        columns: dict[str, object] = {
            "theta_i_deg": self.theta_i_deg,
            "aspecular_deg": self.aspecular_deg,
            "theta_o_deg": self.theta_o_deg,
            "phi_deg": self.phi_deg,
        }
        columns |= {c: self.Lab[:, i] for i, c in enumerate("Lab")}
        columns |= {"C": self.C, "h": self.h}
        columns |= {c: self.XYZ[:, i] for i, c in enumerate("XYZ")}
        columns |= {f"R{nm:g}": self.R[:, i] for i, nm in enumerate(self.wavelengths_nm)}
        return pandas.DataFrame(columns, index=pandas.Index(self.geometries, name="geometry"))

    def to_xarray(self) -> Any:
        """A Dataset over geometry, wavelength_nm and the components of colours."""
        xarray = optional("xarray", "to_xarray()")
        data: dict[str, object] = {
            "R": (("geometry", "wavelength_nm"), self.R, {"units": "1"}),
            "Lab": (("geometry", "lab"), self.Lab),
            "XYZ": (("geometry", "xyz"), self.XYZ),
        }
        if self.standard_error is not None:
            data["standard_error"] = (("geometry", "wavelength_nm"), self.standard_error)
        degrees = {"units": "deg"}
        coordinates = {
            "geometry": self.geometries,
            "wavelength_nm": ("wavelength_nm", self.wavelengths_nm, {"units": "nm"}),
            "lab": ["L", "a", "b"],
            "xyz": ["X", "Y", "Z"],
            "theta_i_deg": ("geometry", self.theta_i_deg, degrees),
            "theta_o_deg": ("geometry", self.theta_o_deg, degrees),
            "phi_deg": ("geometry", self.phi_deg, degrees),
            "aspecular_deg": ("geometry", self.aspecular_deg, degrees),
        }
        attributes = {
            "name": self.name,
            "illuminant": self.illuminant,
            "observer": self.observer,
        }
        return xarray.Dataset(data, coords=coordinates, attrs=attributes)

    def to_colour(self) -> Any:
        """`colour.MultiSpectralDistributions` of R, a label a geometry (package colour-science).

        Raises
        ------
        SettingError
            If the readings have no spectra.
        """
        if self.wavelengths_nm.size == 0:
            raise SettingError("to_colour(): the readings have no spectra")
        colour = optional("colour", "to_colour()", "colour-science")
        return colour.MultiSpectralDistributions(
            self.R.T, self.wavelengths_nm, labels=self.geometries, name=self.name
        )

    def __repr__(self) -> str:
        return (
            f"<Measurement {self.name!r}: {', '.join(self.geometries)}; "
            f"{self.illuminant}, {self.observer} deg>"
        )

    def _flop(self) -> str:
        """Lightness by the aspecular angle, a line a lamp, of what was read in its plane."""
        in_plane = np.abs(np.sin(np.radians(self.phi_deg))) < 1e-6
        lines = []
        for lamp in np.unique(self.theta_i_deg):
            read = in_plane & (self.theta_i_deg == lamp)
            lines.append(
                _html.Line(
                    f"lamp at {lamp:g}°", self.aspecular_deg[read], self.Lab[read, 0], "#888"
                )
            )
        return _html.plot(lines, "aspecular angle, deg", "L*")

    def _repr_html_(self) -> str:
        html = _html.chips(self.srgb, self.geometries)
        colours = [_html.css(colour) for colour in self.srgb]
        if self.wavelengths_nm.size:
            html += _html.spectra(
                self.wavelengths_nm, self.R, self.geometries, colours, "reflectance factor"
            )
        html += self._flop()
        rows = [
            [name, *map(float, lab), float(c), float(h)]
            for name, lab, c, h in zip(self.geometries, self.Lab, self.C, self.h, strict=True)
        ]
        return html + _html.table(["geometry", "L*", "a*", "b*", "C*", "h"], rows)
