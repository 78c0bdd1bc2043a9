"""The light of a paint: values, samples, walks, solutions."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike

from . import _nacre
from ._arrays import ABOUT_WAVELENGTHS, Floats, Floats32, doubles, wavelengths
from ._errors import SettingError, naming
from ._model import ModelLike, settings_of
from ._opened_paint import OpenedPaint
from ._progress import Progress, reporter
from ._values import Reference, Sample, Solution


class PaintLight(OpenedPaint):
    """How a paint scatters light."""

    @naming(wavelengths_nm=ABOUT_WAVELENGTHS)
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
            ``total``, ``single`` (met exactly one flake) or ``multiple``. The lobe of a rough
            interface is part of the total alone.
        as_rendered
            As a renderer gets it, a hundred times faster: in single precision, multiple
            scattering interpolated in tables. For the shipped paints at byk-mac's angles it is
            off by up to 2.6 % where the value is above a thousandth of the paint's largest, and
            by up to 0.28 in CIEDE2000.
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

    @naming(wavelengths_nm=ABOUT_WAVELENGTHS)
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

        Raises
        ------
        SettingError
            If an angle, a wavelength or another argument is out of range.
        InputError, DomainError
            As :meth:`brdf`.
        MemoryError
            If the product of the arrays has more places than memory.
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

    @naming(wavelengths_nm=ABOUT_WAVELENGTHS)
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
            One to eight, which share the direction; as for :meth:`albedo`.
        rng
            A generator of numpy or its seed.
        u
            Instead, the random numbers (..., 3) in [0, 1); broadcast with wi.

        Raises
        ------
        SettingError
            If a direction has no length, a random number is outside [0, 1), or wavelengths are out
            of range or not one to eight.
        InputError, DomainError
            If the file lacks what the model reads, or shapes do not fit.
        Stopped
            If ``progress`` returned False.
        """
        i = doubles(wi)
        if u is None:
            shape = (*i.shape[:-1], 3)
            u = np.random.default_rng(rng).random(shape)
        with reporter(progress, "prepare") as report:
            look = _nacre.look(self._paint, settings_of(model), _some(wavelengths_nm), report)
        return Sample(*look.sample(i, doubles(u), _some(wavelengths_nm)))

    @naming(wavelengths_nm=ABOUT_WAVELENGTHS)
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
        lobe, for the same one to eight wavelengths.

        Raises
        ------
        SettingError, InputError, DomainError, Stopped
            As :meth:`sample`.
        """
        with reporter(progress, "prepare") as report:
            look = _nacre.look(self._paint, settings_of(model), _some(wavelengths_nm), report)
        return look.pdf(doubles(wi), doubles(wo), _some(wavelengths_nm))

    @naming(wavelengths_nm=ABOUT_WAVELENGTHS)
    def albedo(
        self,
        wi: ArrayLike,
        wavelengths_nm: ArrayLike | None = None,
        *,
        model: ModelLike = None,
        progress: Progress = False,
    ) -> Floats32:
        """Directional-hemispherical reflectance (..., W), specular reflection included: a table
        for renderers, within 5e-3. The integral of :meth:`brdf` is exact. Between 400 and 700 nm
        from the solution at :attr:`wavelengths_nm`; beyond, of one for those that are asked for.

        Raises
        ------
        SettingError
            If a direction has no length, or a wavelength is out of range.
        InputError, DomainError, Stopped
            As :meth:`sample`.
        """
        nm = _some(self.wavelengths_nm if wavelengths_nm is None else wavelengths_nm)
        with reporter(progress, "prepare") as report:
            look = _nacre.look(self._paint, settings_of(model), nm, report)
        return look.albedo(doubles(wi), nm)

    @naming(wavelengths_nm=ABOUT_WAVELENGTHS)
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

    @naming(wavelengths_nm=ABOUT_WAVELENGTHS)
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

        Raises
        ------
        SettingError
            If a number is out of range, or nodes are no multiple of 4.
        InputError
            If there is no recipe with layers, its materials do not reach these wavelengths, or a
            solved paint has others.
        Stopped
            If ``progress`` returned False.
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
        """What the solver could not resolve, of the last eight solutions."""
        return list(self._paint.warnings())

    @property
    def implausible(self) -> list[str]:
        """The numbers that can be computed with and are hardly meant: key, value and why.

        Of measured colours: where columns contradict each other.
        """
        return list(self._paint.implausible_numbers())

    @property
    def notes(self) -> list[str]:
        """What was decided about measured colours that their file does not say, such as percent."""
        return list(self._paint.notes())


def _some(wavelengths_nm: ArrayLike) -> Floats:
    if wavelengths_nm is None:
        raise SettingError("wavelengths_nm = None: must be numbers", setting="wavelengths_nm")
    return np.atleast_1d(doubles(wavelengths_nm))
