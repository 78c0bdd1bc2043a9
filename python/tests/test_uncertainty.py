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


def test_what_is_wrong_is_said(paints: Path) -> None:
    paint = nacre.Paint(paints / "tio2-mica-80.toml")
    with pytest.raises(nacre.DomainError, match="thickness"):
        paint.uncertainty({"coats[0].thicknes_nm": 1})
    with pytest.raises(nacre.DomainError):
        paint.uncertainty({"coats[0].thickness_nm": "x"})
    with pytest.raises(nacre.Error):
        paint.uncertainty()
