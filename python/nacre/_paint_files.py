"""Files that are written of a paint."""

from __future__ import annotations

import os

from numpy.typing import ArrayLike

from . import _nacre
from ._arrays import ABOUT_WAVELENGTHS, Path, wavelengths
from ._errors import SettingError, naming
from ._model import ModelLike, settings_of
from ._paint_readings import PaintReadings
from ._progress import Progress, reporter
from ._values import Export, FittedMaterial, ShaderMaterial, fitted_material, shader_material


class PaintFiles(PaintReadings):
    """How a paint is written."""

    def to_toml(self) -> str:
        """The recipe as a file. Raises InputError if there is none."""
        return str(self._paint.toml())

    @naming(
        wavelengths_nm=ABOUT_WAVELENGTHS,
        resolution="resolution",
        incidences="incident angles",
        cells="cells along",
    )
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
        path = os.fsdecode(path)
        extension = os.path.splitext(path)[1]
        if path.endswith(".three.js"):
            if wavelengths_nm is not None:
                raise SettingError(
                    "wavelengths_nm: a .three.js file has its own sixteen", setting="wavelengths_nm"
                )
            with reporter(progress, "write") as report:
                return shader_material(self._paint.write_shader(path, settings_of(model), report))
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
            if path.endswith(".blender.py"):
                kind = "cycles"
            if kind is not None:
                values, seen, _, tested = self._paint.write_material(path, kind, nm, chosen, report)
                return fitted_material(values, seen, tested)
        raise SettingError(
            f"path = {path}: must end in .toml, .h5, .bsdf, .binary, .gltf, "
            ".mtlx, .blender.py or .three.js",
            setting="path",
        )
