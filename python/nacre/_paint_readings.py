"""A paint under instruments: colours by angle, how sure they are, sparkle."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from numpy.typing import ArrayLike

from . import _nacre
from ._arrays import ABOUT_WAVELENGTHS, wavelengths
from ._errors import naming
from ._measurement import Geometries, Measurement, geometry_text
from ._model import ModelLike, settings_of
from ._opened_paint import OpenedPaint
from ._progress import Progress, reporter
from ._sparkle import Sparkle, sparkle_of
from ._uncertainty import UncertainNumber, Uncertainty


class PaintReadings(OpenedPaint):
    """What instruments read of a paint."""

    @naming(
        wavelengths_nm=(*ABOUT_WAVELENGTHS, "a colour needs"),
        aperture_deg=("aperture", "half angle of the "),
        walks="samples",
    )
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

    @naming(
        wavelengths_nm=ABOUT_WAVELENGTHS,
        correlations="correlation",
        deviations=("uncertainty", "*standard deviation"),
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

    @naming(
        lamps_deg=("angle of a lamp", "number of lamps"),
        lamp_half_angle_deg="half-angle of the lamps",
        field_mm=("field of the camera", "pixels in all pictures", "taking and reading"),
        pixel_um="pixel in um",
        diffuse_samples="directions of diffuse light",
        panel_mm="side of the panel",
        distance_mm="viewing distance",
        illuminance_lx="illuminance",
    )
    def sparkle(
        self,
        *,
        model: ModelLike = None,
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
        model
            One that shows single flakes; None: ``nacre``.
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

        Raises
        ------
        SettingError
            If a number is out of range, or the model shows no single flakes.
        InputError, DomainError
            If the file lacks what the model reads.
        Stopped
            If ``progress`` returned False.
        """
        with reporter(progress, "sparkle") as report:
            return sparkle_of(
                _nacre.sparkle(
                    self._paint,
                    settings_of(_nacre.default_picture_model() if model is None else model),
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
