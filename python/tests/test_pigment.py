"""Pigments from drawdowns: as the command line has them."""

from __future__ import annotations

from pathlib import Path
from xml.etree import ElementTree

import numpy as np
import pytest
from conftest import Run, rows

import nacre

DRAWDOWN = """ground,thickness_um,volume_fraction,450,650
black,0,,0.0095,0.0095
black,20,0.02,0.0906,0.0119
white,0,,0.6900,0.6900
white,20,0.02,0.3500,0.0130
"""


def test_coefficients_are_those_of_the_command_line(tmp_path: Path, nacre_program: Run) -> None:
    (tmp_path / "d.csv").write_text(DRAWDOWN)
    found = nacre.pigment(tmp_path / "d.csv", geometry="45-0", noise=0.001, name="blue")
    nacre_program(
        *("pigment", tmp_path / "d.csv", "--geometry", "45-0", "--noise", "0.001", "--quiet"),
        *("-o", tmp_path / "p.toml", "--table", tmp_path / "t.csv"),
    )
    table = np.genfromtxt(tmp_path / "t.csv", delimiter=",", skip_header=1)
    np.testing.assert_allclose(found.scattering_per_mm, table[:, 1], rtol=1e-5)
    np.testing.assert_allclose(found.absorption_per_mm, table[:, 3], rtol=1e-5)
    assert (found.scattering_error > 0).all()
    assert [d.ground for d in found.drawdowns] == ["black", "white"]
    shown = ElementTree.fromstring(found._repr_html_())
    assert [e.text for e in shown.iter("title")] == ["scattering", "absorption"]

    found.write(tmp_path / "mine.toml")
    (tmp_path / "paint.toml").write_text(
        "ior = 1.5\n[[layer]]\nthickness_um = 20\n"
        '[[layer.pigment]]\nfrom = "mine.toml"\nvolume_fraction = 0.02\n'
    )
    assert "blue" in nacre.Paint(tmp_path / "paint.toml").to_toml()


def test_a_drawdown_of_random_walks_gives_what_was_walked(
    tmp_path: Path, nacre_program: Run
) -> None:
    # The readings come from a program that shares nothing with the solver.
    pigment = (
        "[[layer.pigment]]\nvolume_fraction = 0.02\nscattering_per_mm = 800\n"
        "absorption_per_mm = { wavelengths_nm = [450, 650], values = [200, 4000] }\n"
    )
    lines, noise = ["ground,thickness_um,volume_fraction,450,650"], 0.0
    for name, ground in (("black", 0.02), ("white", 0.85)):
        for thickness_um, layer in ((0, ""), (20, pigment)):
            recipe = tmp_path / "walked.toml"
            recipe.write_text(
                f"ior = 1.5\n[[layer]]\nthickness_um = {max(thickness_um, 1)}\n{layer}"
                f"[substrate]\nreflectance = {ground}\n"
            )
            walked = rows(
                nacre_program(
                    *("reference", recipe, "--incident", "45", "--outgoing", "0", "--quiet"),
                    *("--wavelength", "450,650", "--samples", 1 << 19, "--seed", 5),
                ).stdout
            )
            factors = [np.pi * float(row["brdf"]) for row in walked]
            noise = max(noise, *(np.pi * float(row["stderr"]) for row in walked))
            lines.append(f"{name},{thickness_um},0.02," + ",".join(map(str, factors)))
    (tmp_path / "d.csv").write_text("\n".join(lines) + "\n")
    found = nacre.pigment(tmp_path / "d.csv", geometry="45-0", noise=noise)
    for value, error, truth in (
        (found.scattering_per_mm, found.scattering_error, 800),
        (found.absorption_per_mm, found.absorption_error, [200, 4000]),
    ):
        assert (np.abs(value - truth) < 4 * error).all()
        assert (error < 0.15 * value).all()


def test_tints_by_random_walks_give_what_was_walked(tmp_path: Path, nacre_program: Run) -> None:
    # Layers that hide their ground, by a program that shares nothing with the solver.
    white = {"scattering": 5000, "absorption": 5}
    (tmp_path / "white.toml").write_text(
        f'name = "w"\nscattering_per_mm = {white["scattering"]}\n'
        f'absorption_per_mm = {white["absorption"]}\nsource = "invented"\n'
    )
    lines, noise = ["ground,thickness_um,volume_fraction,white_volume_fraction,450,650"], 0.0
    for tint, base in ((0.01, 0.1), (0.05, 0.1), (0.1, 0.01)):
        recipe = tmp_path / "walked.toml"
        recipe.write_text(
            "ior = 1.5\n[[layer]]\nthickness_um = 1000\n"
            f"[[layer.pigment]]\nvolume_fraction = {tint}\nscattering_per_mm = 800\n"
            "absorption_per_mm = { wavelengths_nm = [450, 650], values = [200, 4000] }\n"
            f'[[layer.pigment]]\nfrom = "white.toml"\nvolume_fraction = {base}\n'
        )
        walked = rows(
            nacre_program(
                *("reference", recipe, "--incident", "45", "--outgoing", "0", "--quiet"),
                *("--wavelength", "450,650", "--samples", 1 << 17, "--seed", 7),
            ).stdout
        )
        factors = [np.pi * float(row["brdf"]) for row in walked]
        noise = max(noise, *(np.pi * float(row["stderr"]) for row in walked))
        lines.append(f",opaque,{tint},{base}," + ",".join(map(str, factors)))
    (tmp_path / "t.csv").write_text("\n".join(lines) + "\n")
    found = nacre.pigment(
        tmp_path / "t.csv", geometry="45-0", noise=noise, white=tmp_path / "white.toml"
    )
    for value, error, truth in (
        (found.scattering_per_mm, found.scattering_error, 800),
        (found.absorption_per_mm, found.absorption_error, [200, 4000]),
    ):
        assert (np.abs(value - truth) < 4 * error).all()
        assert (error < 0.3 * value).all()
    assert not found.scattering_assumed
    assert all(d.opaque for d in found.drawdowns)
    with pytest.raises(nacre.InputError, match="none of the pigments that ship"):
        nacre.pigment(tmp_path / "t.csv", geometry="45-0", white="rutil-white")


def test_what_is_wrong_is_said(tmp_path: Path) -> None:
    path = tmp_path / "d.csv"
    path.write_text("ground,thickness_um,volume_fraction,450\nblack,20,0.1,45\n")
    with pytest.raises(nacre.InputError, match="in percent"):
        nacre.pigment(path)
    path.write_text("ground,thickness_um,volume_fraction,450\nblack,0,,0.1\nblack,20,0.1,0.2\n")
    with pytest.raises(nacre.DomainError, match="two grounds"):
        nacre.pigment(path)
    with pytest.raises(nacre.SettingError, match="geometry"):
        nacre.pigment(path, geometry="60-0")
