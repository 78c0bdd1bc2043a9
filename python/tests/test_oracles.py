"""Against packages that share no code with Nacre: tmm for films, colour-science for colours,
miepython for pigments' particles."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

import nacre
from nacre import _nacre

NM = np.arange(400.0, 701, 20)


@pytest.mark.parametrize("polarization", ["s", "p", "u"])
@pytest.mark.parametrize("angle_deg", [0.0, 30.0, 75.0])
def test_films(polarization: str, angle_deg: float) -> None:
    tmm = pytest.importorskip("tmm", reason="the oracle tmm is not installed")
    thickness = [80.0, 500.0, 15.0]
    materials = ["TiO2_anatase", "mica", "3.18+3.33i"]
    film = nacre.film(
        list(zip(materials, thickness, strict=True)),
        ambient=1.5,
        substrate="1.7+0.2i",
        angles_deg=angle_deg,
        wavelengths_nm=NM,
        polarization=polarization,
    )
    for i, nm in enumerate(NM):
        index = [nacre.Material(m).index(nm)[()] for m in materials]
        stack = ([1.5, *index, 1.7 + 0.2j], [np.inf, *thickness, np.inf], np.radians(angle_deg), nm)
        each = [tmm.coh_tmm(p, *stack) for p in (polarization if polarization != "u" else "sp")]
        assert film.R[i] == pytest.approx(np.mean([e["R"] for e in each]), abs=1e-12)
        assert film.T[i] == pytest.approx(np.mean([e["T"] for e in each]), abs=1e-12)


def spectra() -> np.ndarray[tuple[int, int], np.dtype[np.float64]]:
    """Smooth, like those of films."""
    films = [[(2.4, thickness_nm)] for thickness_nm in (60, 90, 140)]
    nm = np.arange(360.0, 781, 5)
    return np.stack([nacre.film(f, substrate=1.58, wavelengths_nm=nm).R for f in films])


@pytest.mark.parametrize("illuminant", ["D65", "A", "FL2"])
@pytest.mark.parametrize("observer", [2, 10])
def test_tristimulus_values(illuminant: str, observer: int) -> None:
    colour = pytest.importorskip("colour", reason="the oracle colour-science is not installed")
    nm, values = np.arange(360.0, 781, 5), spectra()
    cmfs = colour.MSDS_CMFS[
        {2: "CIE 1931 2 Degree Standard Observer", 10: "CIE 1964 10 Degree Standard Observer"}[
            observer
        ]
    ]
    light = colour.SDS_ILLUMINANTS[illuminant]
    shape = colour.SpectralShape(360, 780, 5)
    cmfs, light = cmfs.copy().align(shape), light.copy().align(shape)
    found = nacre.xyz(nm, values, illuminant=illuminant, observer=observer)
    for i, row in enumerate(values):
        sd = colour.SpectralDistribution(row, nm)
        expected = colour.sd_to_XYZ(sd, cmfs, light, method="Integration")
        np.testing.assert_allclose(found[i], expected, rtol=2e-4)


def test_lab_and_differences() -> None:
    colour = pytest.importorskip("colour", reason="the oracle colour-science is not installed")
    nm, values = np.arange(360.0, 781, 5), spectra()
    lab = nacre.lab(nm, values)
    white = nacre.xyz(nm, np.ones_like(nm))
    expected = colour.XYZ_to_Lab(nacre.xyz(nm, values) / 100, colour.XYZ_to_xy(white / 100))
    np.testing.assert_allclose(lab, expected, rtol=1e-9, atol=1e-9)
    found = nacre.delta_e_2000(lab[:, None], lab)
    np.testing.assert_allclose(
        found, colour.difference.delta_E_CIE2000(lab[:, None], lab), rtol=1e-9, atol=1e-9
    )
    assert found.shape == (3, 3)
    assert found[0, 1] > 5
    grey = nacre.srgb([[50.0, 0.0, 0.0], [100.0, 0, 0], [200.0, 0, 0]])
    expected_grey = colour.XYZ_to_sRGB(colour.Lab_to_XYZ([50, 0, 0]))
    np.testing.assert_allclose(grey[0], expected_grey, atol=2e-3)
    np.testing.assert_allclose(grey[1:], 1, atol=2e-3)


def particles(recipe: str) -> dict[str, Any]:
    """Coefficients, 1/um, and phase function of the pigment in a layer that has nothing else, as
    renderers get them."""
    paint = nacre.Paint.from_toml(f"ior = 1.5\n[[layer]]\nthickness_um = 20\n{recipe}")
    model = nacre.Model("microflake")
    arrays = _nacre.appearance_arrays(paint._paint, model._model, True, None)
    layer = arrays["layers"][0]
    return {
        "nm": arrays["wavelengths_nm"],
        "scattering": layer["pigments"][0]["scattering_per_um"],
        "extinction": layer["extinction_per_um"][0],  # single precision, the same in any direction
        "phase": layer["pigments"][0]["phase"],
    }


@pytest.mark.parametrize("diameter_nm", [30, 180, 900])
def test_spheres(diameter_nm: float) -> None:
    miepython = pytest.importorskip("miepython", reason="the oracle miepython is not installed")
    found = particles(
        f'[[layer.pigment]]\nmaterial = "Fe2O3"\nvolume_fraction = 0.1\n'
        f'diameter_nm = {diameter_nm}\ncrowding = "independent"\n'
    )
    nm, relative = found["nm"], np.conj(nacre.Material("Fe2O3").index(found["nm"])) / 1.5
    extinction, scattering, _, _ = miepython.efficiencies(
        1.5 * relative, diameter_nm, nm, n_env=1.5
    )
    per_um = 0.1 * 1.5 / (1e-3 * diameter_nm)  # cross section of the spheres over the volume
    np.testing.assert_allclose(found["scattering"], per_um * scattering, rtol=1e-9)
    np.testing.assert_allclose(found["extinction"], per_um * extinction, rtol=1e-6)
    mu = np.cos(np.linspace(0, np.pi, len(found["phase"])))
    for i in range(0, nm.size, 10):
        x = np.pi * diameter_nm * 1.5 / nm[i]
        expected = miepython.i_unpolarized(relative[i], x, mu, norm="one")
        np.testing.assert_allclose(found["phase"][:, i], expected, rtol=1e-4)


def test_spheres_of_many_sizes() -> None:
    """Half of the volume in smaller ones than the median, the logarithm normal."""
    miepython = pytest.importorskip("miepython", reason="the oracle miepython is not installed")
    found = particles(
        '[[layer.pigment]]\nmaterial = "Fe2O3"\nvolume_fraction = 0.1\ndiameter_nm = 200\n'
        'spread = 0.3\nweighting = "volume"\ncrowding = "independent"\n'
    )
    t = np.linspace(-5, 5, 401)
    share = np.exp(-0.5 * t**2) / np.sum(np.exp(-0.5 * t**2))
    diameter_nm = 200 * np.exp(0.3 * t)
    for i in (0, 15, 30):
        nm = found["nm"][i]
        index = np.conj(nacre.Material("Fe2O3").index(nm)[()])
        extinction, scattering, _, _ = miepython.efficiencies(index, diameter_nm, nm, n_env=1.5)
        per_um = 0.1 * 1.5 * share / (1e-3 * diameter_nm)
        # particle_optics() promises 3e-4 (src/nacre/optics/particles.h).
        assert found["scattering"][i] == pytest.approx(np.sum(per_um * scattering), rel=3e-4)
        assert found["extinction"][i] == pytest.approx(np.sum(per_um * extinction), rel=3e-4)
