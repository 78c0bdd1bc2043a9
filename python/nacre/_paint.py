"""A paint: opened, changed, evaluated, measured, written."""

from __future__ import annotations

import os
import tomllib
from collections.abc import Iterator, Mapping, Sequence
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from . import _html, _nacre, _threejs, _toml
from ._arrays import Floats, Floats32, doubles, wavelengths
from ._errors import SettingError
from ._measurement import Geometries, Measurement, geometry_text
from ._model import ModelLike, settings_of
from ._progress import Progress, reporter
from ._sparkle import Sparkle, sparkle_of
from ._uncertainty import UncertainNumber, Uncertainty
from ._values import Export, FittedMaterial, Parameter, Reference, Sample, ShaderMaterial, Solution

Path = str | os.PathLike[str]


class Paint:
    """A paint, from a file of any kind that Nacre reads: a recipe (.toml), a solved paint or a
    table (.h5), a measured BRDF (.bsdf, .binary), measured colours (.csv, .json, CGATS). Contents
    tell. One sample of several is named behind the file: ``Paint("panels.csv#Silver 2")``.

    The recipe is solved once, when values are first asked for; ``paint[key] = value`` makes it
    another paint, to be solved anew.

    Raises
    ------
    InputError
        Naming the file and what is wrong in it.
    """

    def __init__(self, path: Path) -> None:
        """From a file of any kind, or a shipped paint by its name (:func:`shipped_paints`)."""
        self._paint = _nacre.Paint.open(path)

    @classmethod
    def _of(cls, native: _nacre.Paint) -> Paint:
        paint = cls.__new__(cls)
        paint._paint = native
        return paint

    @classmethod
    def from_bytes(cls, data: bytes, name: str, folder: Path | None = None) -> Paint:
        """From the contents of a file of any kind.

        Parameters
        ----------
        name
            Of the file, for messages.
        folder
            Where the names of materials in a recipe start; without it, it may name no files.
        """
        return cls._of(
            _nacre.Paint.from_bytes(data, name, None if folder is None else os.fspath(folder))
        )

    @classmethod
    def from_toml(cls, text: str, folder: Path | None = None) -> Paint:
        """From the text of a recipe (docs/recipe.md). Raises InputError naming line and key."""
        return cls.from_bytes(text.encode(), "recipe", folder)

    @classmethod
    def from_dict(cls, recipe: Mapping[str, Any], folder: Path | None = None) -> Paint:
        """From a recipe as a dictionary, with the keys of its file, as :meth:`to_dict` gives it."""
        return cls.from_toml(_toml.dumps(recipe), folder)

    def copy(self) -> Paint:
        """The same paint, which shares its solution until one of both is changed."""
        return Paint._of(self._paint)

    __copy__ = copy

    # What it is

    @property
    def kind(self) -> str:
        """recipe, solved_paint, brdf_table, measured_brdf or measured_colours."""
        return str(self._paint.kind)

    @property
    def name(self) -> str:
        """The recipe's, or the file's without folder and extension."""
        return str(self._paint.name)

    @property
    def file(self) -> str:
        return str(self._paint.file)

    @property
    def sha256(self) -> str:
        """Of what the recipe says, whatever its layout; empty without a recipe."""
        return str(self._paint.sha256)

    @property
    def wavelengths_nm(self) -> Floats:
        """(W,) at which values are given where none are asked for."""
        return self._paint.wavelengths_nm(None)

    def to_toml(self) -> str:
        """The recipe as a file. Raises InputError if there is none."""
        return str(self._paint.toml())

    def to_dict(self) -> dict[str, Any]:
        """The recipe as a dictionary."""
        return tomllib.loads(self.to_toml())

    # Its numbers

    @property
    def parameters(self) -> dict[str, Parameter]:
        """The numbers of the recipe by their whole keys, with what each may be."""
        return {p[0]: Parameter(*p) for p in self._paint.parameters()}

    def __getitem__(self, key: str) -> float:
        """A number by its key, or the end of it: ``paint["coats[0].thickness_nm"]``.

        Raises
        ------
        DomainError
            If the recipe has no such number, or several keys end so.
        """
        return float(self._paint.value(key))

    def __setitem__(self, key: str, value: float) -> None:
        """Changes a number; DomainError names key, value and range."""
        self._paint = self._paint.with_value(key, value)

    def __iter__(self) -> Iterator[str]:
        return iter(self.parameters)

    def with_values(self, values: Mapping[str, float]) -> Paint:
        """A copy with some numbers changed."""
        changed = self.copy()
        for key, value in values.items():
            changed[key] = value
        return changed

    # Light

    def brdf(
        self,
        wi: ArrayLike,
        wo: ArrayLike,
        wavelengths_nm: ArrayLike | None = None,
        *,
        model: ModelLike = None,
        part: str = "total",
        as_rendered: bool = False,
        patch: tuple[float, float, float] | None = None,
        progress: Progress = False,
    ) -> Floats:
        """The BRDF in 1/sr, without the specular reflection of a smooth interface.

        Parameters
        ----------
        wi, wo
            Directions (..., 3) towards light and eye, z being the normal; leading axes are
            broadcast. Lengths do not matter; below the horizon the BRDF is 0.
        wavelengths_nm
            Vacuum wavelengths (W,); None: :attr:`wavelengths_nm`.
        part
            ``total``, ``single`` (met exactly one flake) or ``multiple``.
        as_rendered
            As a renderer sees it, in single precision: a hundred times faster.
        patch
            x, y and side of a square that shows its single flakes, in mm (model ``nacre``) or as
            fractions of the unit square (``special-effect``); None: the mean over the surface.

        Returns
        -------
        array (..., W)

        Raises
        ------
        InputError, DomainError
            If the file lacks what the model reads, shapes do not fit, or a setting is wrong.
        """
        chosen = None if model is None else settings_of(model)
        arguments = (
            doubles(wi),
            doubles(wo),
            wavelengths(wavelengths_nm),
            chosen,
            part,
            as_rendered,
            patch,
        )
        if progress is False:
            return self._paint.brdf(*arguments, None)
        with reporter(progress, "prepare") as report:
            return self._paint.brdf(*arguments, report)

    def brdf_at(
        self,
        theta_i_deg: ArrayLike,
        theta_o_deg: ArrayLike,
        phi_deg: ArrayLike,
        wavelengths_nm: ArrayLike | None = None,
        *,
        model: ModelLike = None,
        part: str = "total",
        as_rendered: bool = False,
        patch: tuple[float, float, float] | None = None,
        progress: Progress = False,
    ) -> Floats:
        """The same by angles in degrees, of any shape (...): polar angles in [0, 90) and
        phi = phi_o - phi_i, 180 being the mirror side. Equals ``nacre eval`` to the last bit.
        """
        with reporter(progress, "prepare") as report:
            return self._paint.brdf_at(
                doubles(theta_i_deg),
                doubles(theta_o_deg),
                doubles(phi_deg),
                wavelengths(wavelengths_nm),
                settings_of(model),
                part,
                as_rendered,
                patch,
                report,
            )

    def sample(
        self,
        wi: ArrayLike,
        wavelengths_nm: ArrayLike,
        *,
        rng: np.random.Generator | int | None = None,
        u: ArrayLike | None = None,
        model: ModelLike = None,
        progress: Progress = False,
    ) -> Sample:
        """Draws a direction for each wi, specular reflection included, as the renderer does.

        Parameters
        ----------
        wi
            Directions (..., 3) towards the eye.
        wavelengths_nm
            One to eight, which share the direction.
        rng
            A generator of numpy or its seed.
        u
            Instead, the random numbers (..., 3) in [0, 1); broadcast with wi.
        """
        i = doubles(wi)
        if u is None:
            shape = (*i.shape[:-1], 3)
            u = np.random.default_rng(rng).random(shape)
        with reporter(progress, "prepare") as report:
            look = _nacre.look(self._paint, settings_of(model), report)
        return Sample(*look.sample(i, doubles(u), _some(wavelengths_nm)))

    def pdf(
        self,
        wi: ArrayLike,
        wo: ArrayLike,
        wavelengths_nm: ArrayLike,
        *,
        model: ModelLike = None,
        progress: Progress = False,
    ) -> Floats32:
        """Density per solid angle (...) with which :meth:`sample` draws wo, apart from the specular
        lobe, for the same one to eight wavelengths."""
        with reporter(progress, "prepare") as report:
            look = _nacre.look(self._paint, settings_of(model), report)
        return look.pdf(doubles(wi), doubles(wo), _some(wavelengths_nm))

    def albedo(
        self,
        wi: ArrayLike,
        wavelengths_nm: ArrayLike | None = None,
        *,
        model: ModelLike = None,
        progress: Progress = False,
    ) -> Floats32:
        """Directional-hemispherical reflectance (..., W), specular reflection included: a table
        for renderers, within 5e-3. The integral of :meth:`brdf` is exact."""
        with reporter(progress, "prepare") as report:
            look = _nacre.look(self._paint, settings_of(model), report)
        nm = self.wavelengths_nm if wavelengths_nm is None else wavelengths_nm
        return look.albedo(doubles(wi), _some(nm))

    def reference(
        self,
        theta_i_deg: ArrayLike,
        theta_o_deg: ArrayLike,
        phi_deg: ArrayLike,
        wavelengths_nm: ArrayLike | None = None,
        *,
        samples: int = 1 << 20,
        seed: int = 0,
        part: str = "total",
        progress: Progress = False,
    ) -> Reference:
        """The BRDF by random walks through the recipe, to check the solver (docs/reference.md):
        slow, and with standard errors. Equals ``nacre reference`` to the last bit.

        Parameters
        ----------
        theta_i_deg
            Polar angles of the lamp (I...), [0, 90).
        theta_o_deg, phi_deg
            Of the view, broadcast to (O...); phi = phi_o - phi_i, 180 being the mirror side. The
            same walks serve all views and, where the binder's index is the same, eight wavelengths:
            their errors are correlated.
        wavelengths_nm
            Vacuum wavelengths (W,); None: 400 to 700 by 10.
        samples, seed
            Walks per lamp, [2, 1e15], and their seed.
        part
            As in :meth:`brdf`.

        Returns
        -------
        Reference
            Arrays (I..., O..., W).

        Raises
        ------
        InputError
            If there is no recipe with layers, or its materials do not reach these wavelengths.
        DomainError
            If an angle, a wavelength or a setting is out of range.
        Stopped
            If ``progress`` returned False: part of an estimate is none.
        """
        with reporter(progress, "reference") as report:
            brdf, error = _nacre.reference(
                self._paint,
                doubles(theta_i_deg),
                doubles(theta_o_deg),
                doubles(phi_deg),
                wavelengths(wavelengths_nm),
                samples,
                seed,
                part,
                report,
            )
        return Reference(brdf, error, samples)

    def solve(
        self,
        wavelengths_nm: ArrayLike | None = None,
        *,
        exit_nodes: int = 0,
        inner_nodes: int = 0,
        max_orders: int = 0,
        tolerance: float = 1e-4,
        progress: Progress = False,
    ) -> Solution:
        """Solves the light transport now, rather than when values are first asked for.

        Parameters
        ----------
        exit_nodes, inner_nodes
            Directions that leave the coat, and those beyond the critical angle, multiples of 4;
            0: from the recipe.
        max_orders
            Azimuthal orders at most; 0: from the recipe.
        tolerance
            Share of the peak below which the Fourier series may end.
        """
        with reporter(progress, "solve") as report:
            return Solution(
                **self._paint.solve(
                    wavelengths(wavelengths_nm),
                    exit_nodes,
                    inner_nodes,
                    max_orders,
                    tolerance,
                    report,
                )
            )

    @property
    def warnings(self) -> list[str]:
        """What the solver could not resolve, of all solutions so far."""
        return list(self._paint.warnings())

    @property
    def implausible(self) -> list[str]:
        """The numbers that can be computed with and are hardly meant: key, value and why."""
        return list(self._paint.implausible_numbers())

    @property
    def notes(self) -> list[str]:
        """What was decided about measured colours that their file does not say, such as percent."""
        return list(self._paint.notes())

    # Instruments

    def measure(
        self,
        geometry: Geometries = None,
        *,
        model: ModelLike = None,
        illuminant: str | None = None,
        observer: str | int | None = None,
        aperture_deg: tuple[float, float] | None = None,
        wavelengths_nm: ArrayLike | None = None,
        walks: int = 1 << 18,
        seed: int = 0,
        progress: Progress = False,
    ) -> Measurement:
        """What a multi-angle spectrophotometer reads; measured colours are what was read, those
        geometries picked and stated under that light.

        Parameters
        ----------
        geometry
            See :data:`Geometries`.
        illuminant, observer
            A, D50, D65, FL2, FL11 or E; 2 or 10. None: the file's, or else D65 and 10.
        aperture_deg
            Half angles of lamp and detector, [0, 10].
        wavelengths_nm
            In equal steps, at least two.
        walks, seed
            Of models that follow light: walks per lamp, and their seed.

        Raises
        ------
        InputError, DomainError
            If a name is unknown, a number out of range, or the file cannot be stated so.
        """
        with reporter(progress, "measure") as report:
            return Measurement(
                _nacre.measure(
                    self._paint,
                    geometry_text(geometry),
                    settings_of(model),
                    illuminant,
                    None if observer is None else str(observer),
                    aperture_deg,
                    wavelengths(wavelengths_nm),
                    walks,
                    seed,
                    report,
                )
            )

    def uncertainty(
        self,
        deviations: Mapping[str, float | str] | None = None,
        geometry: Geometries = None,
        *,
        correlations: Mapping[tuple[str, ...], float] | None = None,
        model: ModelLike = None,
        illuminant: str | None = None,
        observer: str | int | None = None,
        wavelengths_nm: ArrayLike | None = None,
        samples: int = 0,
        seed: int = 0,
        progress: Progress = False,
    ) -> Uncertainty:
        """How far readings are spread if numbers are known to a standard deviation only
        (docs/uncertainty.md).

        Parameters
        ----------
        deviations
            Standard deviations by key or the end of a key, in the number's own unit or as
            ``"5 %"``: besides those of the recipe's table [uncertainty], or in their place.
        correlations
            Coefficients in [-1, 1] by which numbers are wrong together, each two of a tuple of
            keys or ends of keys: besides those of the recipe, or in their place. Others are
            independent.
        samples, seed
            So many recipes, 10 to 1e6, are drawn and read; 0: first order.

        Raises
        ------
        InputError, DomainError
            As :meth:`measure`, or if nothing is uncertain, a key, a deviation or a coefficient is
            wrong, or coefficients cannot be together.
        """
        with reporter(progress, "uncertainty") as report:
            found = _nacre.uncertainty(
                self._paint,
                geometry_text(geometry),
                settings_of(model),
                illuminant,
                None if observer is None else str(observer),
                wavelengths(wavelengths_nm),
                {key: str(value) for key, value in (deviations or {}).items()},
                [(list(keys), float(value)) for keys, value in (correlations or {}).items()],
                samples,
                seed,
                report,
            )
        found["measurement"] = Measurement(found["measurement"])
        found["numbers"] = [UncertainNumber(*number) for number in found["numbers"]]
        return Uncertainty(**found)

    def sparkle(
        self,
        *,
        model: ModelLike = "nacre",
        lamps_deg: Sequence[float] = (15, 45, 75),
        lamp_half_angle_deg: float = 0.25,
        field_mm: float = 12,
        pixel_um: float = 25,
        diffuse_samples: int = 16,
        panel_mm: float = 100,
        distance_mm: float = 500,
        illuminance_lx: float = 1000,
        seed: int = 0,
        progress: Progress = False,
    ) -> Sparkle:
        """Sparkle and graininess of a panel, by a virtual camera above it (docs/sparkle.md).

        Parameters
        ----------
        lamps_deg
            From the normal, [0, 85], at most 16.
        lamp_half_angle_deg
            Angular radius of the lamps; 0 is a point, the sun has 0.27.
        field_mm, pixel_um
            Sides of what the camera sees and of its pixels on the panel.
        diffuse_samples
            Directions a pixel for the picture in diffuse light, even; 0: none.
        panel_mm
            ``special-effect``: side of the panel over which the facets lie.
        distance_mm, illuminance_lx
            How the panel is looked at.
        """
        with reporter(progress, "sparkle") as report:
            return sparkle_of(
                _nacre.sparkle(
                    self._paint,
                    settings_of(model),
                    [float(lamp) for lamp in lamps_deg],
                    lamp_half_angle_deg,
                    field_mm,
                    pixel_um,
                    diffuse_samples,
                    panel_mm,
                    distance_mm,
                    illuminance_lx,
                    seed,
                    report,
                )
            )

    # Files

    def write(
        self,
        path: Path,
        *,
        model: ModelLike = None,
        wavelengths_nm: ArrayLike | None = None,
        resolution: int = 64,
        incidences: int = 64,
        rgb: bool = False,
        cells: tuple[int, int, int] = (90, 90, 180),
        progress: Progress = False,
    ) -> Export | FittedMaterial | ShaderMaterial | None:
        """Writes a file by its extension, whole or not at all.

        ``.toml``: the recipe. ``.h5``: the solved paint, or the table that ``model`` renders from,
        as ``Model("microflake", table="svd")``. ``.bsdf``: the BRDF as in the RGL database, and
        ``.binary``: as in MERL's, for other renderers; these return their error. ``.gltf``,
        ``.mtlx`` and ``.blender.py``: glTF's material, OpenPBR, and Cycles' nodes as a script for
        Blender, fitted; these return what they miss. ``.three.js``: an ES module for three.js with
        ``nacre``, its mean, or ``microflake`` as a shader, of a recipe or a solved paint; returns
        how far it is from ``nacre``.

        Parameters
        ----------
        resolution, incidences, rgb
            ``.bsdf``: points per side for each incidence, incidences, RGB instead of spectra.
        cells
            ``.binary``: along theta_half, theta_difference and phi_difference.

        Raises
        ------
        SettingError
            If the extension is none of these.
        InputError, DomainError, Error
            If the paint has no such values, or the file cannot be written.
        """
        extension = os.path.splitext(os.fspath(path))[1]
        if os.fspath(path).endswith(".three.js"):
            if wavelengths_nm is not None:
                raise SettingError("wavelengths_nm: a .three.js file has its own sixteen")
            standard = self.measure(
                _threejs.geometries(), model="nacre", illuminant="D65", observer=2
            )
            with reporter(progress, "write") as report:
                shown = settings_of("nacre" if model is None else model)
                return _threejs.write(self._paint, path, shown, standard, report)
        nm, chosen = wavelengths(wavelengths_nm), settings_of(model)
        with reporter(progress, "write") as report:
            if extension == ".toml":
                _nacre.write_text(path, self.to_toml())
                return None
            if extension == ".h5":
                self._paint.write_solved(path, nm, chosen, report)
                return None
            if extension == ".bsdf":
                return Export(
                    *self._paint.write_rgl(path, resolution, incidences, rgb, nm, chosen, report)
                )
            if extension == ".binary":
                return Export(*self._paint.write_merl(path, cells, nm, chosen, report))
            kind = {".gltf": "gltf", ".mtlx": "materialx"}.get(extension)
            if os.fspath(path).endswith(".blender.py"):
                kind = "cycles"
            if kind is not None:
                values, seen, _, tested = self._paint.write_material(path, kind, nm, chosen, report)
                return FittedMaterial(
                    dict(values), dict(seen[0]), *seen[1:], dict(tested[0]), *tested[1:]
                )
        raise SettingError(
            f"path = {os.fspath(path)}: must end in .toml, .h5, .bsdf, .binary, .gltf, "
            ".mtlx, .blender.py or .three.js"
        )

    def __repr__(self) -> str:
        return f"<Paint {self.name!r}: {self.kind}>"

    def _repr_html_(self) -> str:
        if self.kind in ("recipe", "solved_paint"):
            rows = [[p.key, p.value, p.unit] for p in self.parameters.values()]
            return _html.table([self.name, "", ""], rows)
        return _html.table([self.name], [[self.kind.replace("_", " ")]])


def _some(wavelengths_nm: ArrayLike) -> Floats:
    return np.atleast_1d(doubles(wavelengths_nm))


def shipped_paints() -> list[str]:
    """The names of the recipes that ship with Nacre, which :class:`Paint` opens."""
    return list(_nacre.shipped_paints())
