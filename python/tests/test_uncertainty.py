"""Uncertainties of readings: as the command line has them."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from conftest import Run, rows

import nacre

KEY = "layer[0].flakes[0].coats[0].thickness_nm"


def test_deviations_are_those_of_the_command_line(paints: Path, nacre_program: Run) -> None:
    path = paints / "tio2-mica-80.toml"
    found = nacre.Paint(path).uncertainty(
        {"coats[0].thickness_nm": 0.5, "volume_fraction": "3 %"},
        wavelengths_nm=range(400, 701, 20),
    )
    printed = rows(
        nacre_program(
            *("measure", path, "--uncertainty", "coats[0].thickness_nm=0.5", "--quiet"),
            *("--uncertainty", "volume_fraction=3%", "--wavelength", "400:700:20"),
        ).stdout
    )
    columns = [[float(row[f"{c}_sd"]) for c in "Lab"] for row in printed]
    # Differences of paints carry what compilers round differently (a wheel is built for others).
    np.testing.assert_allclose(found.Lab_sd, columns, rtol=1e-6)
    assert {n.key for n in found.numbers} >= {KEY}
    assert found.Lab_covariance.shape == (len(printed), 3, 3)
    outer = np.einsum("gni,gnj->gij", found.change, found.change)
    np.testing.assert_allclose(found.Lab_covariance, outer, atol=1e-9)
    np.testing.assert_allclose(found.shares.sum(axis=1), 1)
    assert found.flop_index is not None
    assert found.R_sd.shape == (len(printed), 16)
    assert "±" in found._repr_html_()


def test_correlations_are_those_of_the_command_line(paints: Path, nacre_program: Run) -> None:
    path = paints / "tio2-mica-80.toml"
    found = nacre.Paint(path).uncertainty(
        {"coats[0].thickness_nm": 0.5, "volume_fraction": "3 %"},
        correlations={("volume_fraction", "coats[0].thickness_nm"): -0.6},
        wavelengths_nm=range(400, 701, 20),
    )
    printed = rows(
        nacre_program(
            *("measure", path, "--uncertainty", "coats[0].thickness_nm=0.5", "--quiet"),
            *("--uncertainty", "volume_fraction=3%", "--wavelength", "400:700:20"),
            *("--correlation", "coats[0].thickness_nm,volume_fraction=-0.6"),
        ).stdout
    )
    columns = [[float(row[f"{c}_sd"]) for c in "Lab"] for row in printed]
    np.testing.assert_allclose(found.Lab_sd, columns, rtol=1e-6)
    # J S J^T, with the correlations of the numbers.                 [jcgm-100-2008, eq. 13]
    together = np.einsum("gni,nm,gmj->gij", found.change, found.correlation, found.change)
    np.testing.assert_allclose(found.Lab_covariance, together, atol=1e-9)
    np.testing.assert_allclose(found.shares.sum(axis=1), 1)
    np.testing.assert_allclose(found.correlation.diagonal(), 1)
    assert np.sort(found.correlation, axis=None)[0] == -0.6


def test_a_fit_knows_how_sure_it_is(paints: Path) -> None:
    start = nacre.Paint(paints / "tio2-mica-80.toml")
    free = ["coats[0].thickness_nm", "volume_fraction"]
    standard = start.with_values({"coats[0].thickness_nm": 84}).measure()
    match = nacre.fit(standard, start, free, starts=1, noise_dE=0.2)
    known = match.uncertain_paint.uncertainty()
    errors = {key: p.standard_error for key, p in match.parameters.items()}
    for number in known.numbers:
        error = errors[number.key]
        assert error is not None
        assert number.sd == pytest.approx(error, rel=1e-3)
    assert 0 < abs(known.correlation[0, 1]) < 1


def test_what_is_wrong_is_said(paints: Path) -> None:
    paint = nacre.Paint(paints / "tio2-mica-80.toml")
    with pytest.raises(nacre.DomainError, match="thickness"):
        paint.uncertainty({"coats[0].thicknes_nm": 1})
    with pytest.raises(nacre.DomainError):
        paint.uncertainty({"coats[0].thickness_nm": "x"})
    with pytest.raises(nacre.Error):
        paint.uncertainty()
    known: dict[str, float | str] = {"coats[0].thickness_nm": 1, "volume_fraction": "3 %"}
    pair = ("coats[0].thickness_nm", "volume_fraction")
    with pytest.raises(nacre.Error, match=r"coefficient = 1.5: must be a number in \[-1, 1\]"):
        paint.uncertainty(known, correlations={pair: 1.5})
    with pytest.raises(nacre.Error, match="has no standard deviation"):
        paint.uncertainty({"volume_fraction": 0.001}, correlations={pair: 0.5})
