"""From colours back to a composition."""

from __future__ import annotations

import os
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace
from typing import Any

from . import _html, _nacre
from ._arrays import Path, texts
from ._errors import SettingError, naming
from ._measurement import Difference, Measurement
from ._model import ModelLike, settings_of
from ._paint import Paint, as_paint
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


@dataclass(frozen=True, eq=False)
class Match:
    """What a fit found."""

    paint: Paint
    uncertain_paint: Paint
    """the same, whose table [uncertainty] has the standard errors found and their correlations"""
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
    constructions: list[ConstructionMatch] = field(default_factory=list)
    """of a fit from a library: what each construction came to, the best, which is this, first"""

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


@dataclass(frozen=True, eq=False)
class ConstructionMatch:
    """What a fit from a library found for one construction."""

    construction: str
    """materials without numbers, from the top down: ``clear / TiO2_anatase|mica``"""
    record: str
    """folder of the record whose colours were nearest, from which the fit started"""
    name: str
    """of that record's paint"""
    nearest_mean_dE2000: float
    """of that record"""
    match: Match


@naming(
    free="keys",
    also="illuminant",
    weights="weight of",
    equal_dE="the Delta E that counts as equal",
    matched_dE="the Delta E that counts as matched",
    noise_dE="noise in Delta E",
)
def fit(
    standard: Measurement | Paint | Path,
    start: Paint | Path | None = None,
    free: str | Sequence[str] | None = None,
    *,
    library: Path | None = None,
    constructions: int = 4,
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
        Measured colours, or a paint, which is measured first, as ``byk-mac`` reads it; either also
        by its path.
    start
        A paint with a recipe, from which the search starts, or its path or shipped name.
    free
        Numbers to turn, by key or the end of a key, `*` for any text (what cannot be free is
        skipped); None: those of the recipe's table [fit].
    library
        In place of both, a folder made by nacre-library: the nearest record of each of the nearest
        constructions is a start, and what its sweep varies is free.
    constructions
        With a library: how many are tried, at least 1.
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
    SettingError
        If not exactly one of ``start`` and ``library`` is given, or ``free`` with a library.
    InputError
        If the start has no recipe or no layers, or the folder is no library.
    Stopped
        If ``progress`` returned False.
    """
    if (start is None) == (library is None):
        raise SettingError(
            "start or library: one of them says where the fit starts", setting="start"
        )
    if library is not None and free is not None:
        raise SettingError(
            "free: belongs to start; a library's sweeps say what varies", setting="free"
        )
    if constructions < 1:
        raise SettingError(
            f"constructions = {constructions}: must be at least 1", setting="constructions"
        )
    if not isinstance(standard, Measurement):
        standard = as_paint(standard, "standard", "a Measurement, a Paint")
        standard = standard.measure(model=None if standard.kind.startswith("measured") else model)
    settings = _nacre.FitSettings(
        standard._readings,
        settings_of(model),
        texts(also),
        dict(weights or {}),
        starts,
        seed,
        noise_dE,
        equal_dE,
        matched_dE,
    )
    with reporter(progress, "fit") as report:
        if start is not None:
            first = as_paint(start, "start")._paint
            one = _nacre.fit(standard._readings, first, texts(free), settings, report)
            return _match(one)
        assert library is not None
        found = _nacre.fit_from_library(
            standard._readings, os.fsdecode(library), constructions, settings, report
        )
    matches = [ConstructionMatch(**{**one, "match": _match(one["match"])}) for one in found]
    return replace(matches[0].match, constructions=matches)


def _match(found: dict[str, Any]) -> Match:
    return Match(
        paint=Paint._of(found["paint"]),
        uncertain_paint=Paint._of(found["uncertain_paint"]),
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
