"""From colours back to a composition."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

from . import _html, _nacre
from ._arrays import texts
from ._measurement import Difference, Measurement
from ._model import ModelLike, settings_of
from ._paint import Paint
from ._progress import Progress, reporter


@dataclass(frozen=True)
class FittedParameter:
    """A number that was sought."""

    key: str
    value: float
    standard_error: float | None
    """None: the colours do not determine it"""
    start: float
    lo: float
    hi: float
    at_bound: bool


@dataclass(frozen=True)
class Tradeoff:
    """A change of several numbers together that leaves the colours nearly the same."""

    changes: dict[str, tuple[float, float]]
    """from and to, by key"""
    rms_dE: float


@dataclass(frozen=True)
class Alternative:
    """Another local minimum of the colour difference."""

    values: dict[str, float]
    mean_dE2000: float
    max_dE2000: float


@dataclass(frozen=True)
class Remedy:
    """One more free number, or wider bounds of one, that brings an unmatched standard nearer."""

    key: str
    widens: bool
    """the number was free, and is at its bound"""
    lo: float
    hi: float
    value: float
    mean_dE2000: float


@dataclass(frozen=True)
class Match:
    """What a fit found."""

    paint: Paint
    parameters: dict[str, FittedParameter]
    standard: Measurement
    colours: Measurement
    """reached"""
    difference: Difference
    at_start: Difference
    other_lights: dict[str, Difference]
    """by illuminant, where the standard has spectra"""
    matched: bool
    """whether the mean Delta E 2000 is within ``matched_dE``"""
    remedies: list[Remedy]
    """where it is not: what might help, the best first"""
    skipped: dict[str, str]
    """numbers that a pattern of ``free`` means and that cannot be free, and why"""
    converged: bool
    ended: str
    tradeoffs: list[Tradeoff]
    alternatives: list[Alternative]
    solves: int
    seconds: float

    def _spectra(self) -> str:
        """What was measured, dashed, and what was found."""
        lines = []
        for reading, dashed in ((self.standard, True), (self.colours, False)):
            for name, row, colour in zip(reading.geometries, reading.R, reading.srgb, strict=True):
                line = _html.Line(name, reading.wavelengths_nm, row, _html.css(colour), dashed)
                lines.append(line)
        return _html.plot(lines, "wavelength, nm", "reflectance factor (standard dashed)")

    def _repr_html_(self) -> str:
        rows = [
            [p.key, p.start, p.value, "—" if p.standard_error is None else p.standard_error]
            for p in self.parameters.values()
        ]
        return (
            _html.chips(self.standard.srgb, self.standard.geometries)
            + _html.chips(self.colours.srgb, [f"ΔE {de:.2f}" for de in self.difference.dE2000])
            + self._spectra()
            + _html.table(["number", "start", "found", "±"], rows)
        )


def fit(
    standard: Measurement | Paint,
    start: Paint,
    free: str | Sequence[str] | None = None,
    *,
    model: ModelLike = None,
    also: str | Sequence[str] | None = None,
    weights: Mapping[str, float] | None = None,
    starts: int = 8,
    seed: int = 0,
    noise_dE: float | None = None,
    equal_dE: float = 0.3,
    matched_dE: float = 1.0,
    progress: Progress = False,
) -> Match:
    """The composition between bounds whose colours are nearest to a standard's (docs/fit.md).

    Parameters
    ----------
    standard
        Measured colours, or a paint, which is measured first, as ``byk-mac`` reads it.
    start
        A paint with a recipe, from which the search starts.
    free
        Numbers to turn, by key or the end of a key, `*` for any text (what cannot be free is
        skipped); None: those of the recipe's table [fit].
    model
        By which paints are seen: ``nacre`` with its hot spot, else by the equation of transfer.
    also
        More illuminants under which colours are to match: ``["A", "FL11"]``.
    weights
        Of geometries by name; others weigh 1.
    starts, seed
        Descents from different places, 1 to 256, and the seed of those.
    noise_dE
        Standard deviation of the standard's colours in each component; None: from the residual.
    equal_dE
        Mean Delta E 2000 within which compositions count as equal.
    matched_dE
        Mean Delta E 2000 up to which the standard counts as matched.

    Raises
    ------
    DomainError
        If a key or a bound is wrong, or a free number does not change the colours.
    InputError
        If the start has no recipe or no layers.
    Stopped
        If ``progress`` returned False.
    """
    if isinstance(standard, Paint):
        standard = standard.measure(model=None if standard.kind.startswith("measured") else model)
    with reporter(progress, "fit") as report:
        found = _nacre.fit(
            standard._readings,
            start._paint,
            texts(free),
            settings_of(model),
            texts(also),
            dict(weights or {}),
            starts,
            seed,
            noise_dE,
            equal_dE,
            matched_dE,
            report,
        )
    return Match(
        paint=Paint._of(found["paint"]),
        parameters={p["key"]: FittedParameter(**p) for p in found["parameters"]},
        standard=Measurement(found["standard"]),
        colours=Measurement(found["colours"]),
        difference=Difference(**found["difference"]),
        at_start=Difference(**found["at_start"]),
        other_lights={k: Difference(**v) for k, v in found["other_lights"].items()},
        matched=found["matched"],
        remedies=[Remedy(**r) for r in found["remedies"]],
        skipped=found["skipped"],
        converged=found["converged"],
        ended=found["ended"],
        tradeoffs=[Tradeoff(**t) for t in found["tradeoffs"]],
        alternatives=[Alternative(**a) for a in found["alternatives"]],
        solves=found["solves"],
        seconds=found["seconds"],
    )
