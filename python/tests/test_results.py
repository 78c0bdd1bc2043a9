"""Results as tables of other packages, and as notebooks show them."""

from __future__ import annotations

import builtins
from pathlib import Path
from typing import Any
from xml.etree import ElementTree

import numpy as np
import pytest

import nacre
from nacre import _html, _rgb


@pytest.fixture(scope="module")
def reading(paints: Path) -> nacre.Measurement:
    return nacre.Paint(paints / "tio2-mica-80.toml").measure(wavelengths_nm=range(400, 701, 20))


def test_pandas(reading: nacre.Measurement) -> None:
    pytest.importorskip("pandas", reason="pandas is not installed")
    table = reading.to_pandas()
    assert list(table.index) == reading.geometries
    np.testing.assert_array_equal(table[["L", "a", "b"]], reading.Lab)
    np.testing.assert_array_equal(table["R560"], reading.R[:, 8])
    differences = reading.difference(reading).to_pandas()
    assert (differences["dE2000"] == 0).all()


def test_pandas_of_sparkle(paints: Path) -> None:
    pytest.importorskip("pandas", reason="pandas is not installed")
    sparkle = nacre.Paint(paints / "glitter-100um.toml").sparkle(
        lamps_deg=[15], field_mm=3, pixel_um=60, diffuse_samples=2
    )
    table = sparkle.to_pandas()
    assert list(table.index) == ["15s", "diffuse"]
    assert table.loc["15s", "spots_per_cm2"] == sparkle.lamps[0].spots_per_cm2.value
    assert "graininess" in sparkle._repr_html_()


def test_xarray(reading: nacre.Measurement) -> None:
    pytest.importorskip("xarray", reason="xarray is not installed")
    data = reading.to_xarray()
    np.testing.assert_array_equal(
        data["R"].sel(geometry="45as45", wavelength_nm=500), reading.R[3, 5]
    )
    np.testing.assert_array_equal(data["Lab"].sel(lab="L"), reading.Lab[:, 0])
    assert data.attrs["illuminant"] == "D65"


def test_colour(reading: nacre.Measurement) -> None:
    pytest.importorskip("colour", reason="colour-science is not installed")
    spectra = reading.to_colour()
    assert spectra.labels == reading.geometries
    np.testing.assert_array_equal(spectra.values.T, reading.R)
    np.testing.assert_array_equal(spectra.wavelengths, reading.wavelengths_nm)


def test_a_package_that_is_missing_is_named(
    reading: nacre.Measurement, monkeypatch: pytest.MonkeyPatch
) -> None:
    genuine = builtins.__import__

    def without(name: str, *rest: Any) -> Any:
        if name in ("pandas", "xarray", "colour"):
            raise ImportError(name)
        return genuine(name, *rest)

    import importlib

    monkeypatch.setattr(importlib, "import_module", without)
    for call, package in (
        (reading.to_pandas, "pandas"),
        (reading.to_xarray, "xarray"),
        (reading.to_colour, "colour-science"),
    ):
        with pytest.raises(ImportError, match=f"pip install {package}"):
            call()


def test_html(reading: nacre.Measurement, paints: Path) -> None:
    film = nacre.film([("TiO2_anatase", 100)], angles_deg=[0, 60])
    paint = nacre.Paint(paints / "tio2-mica-80.toml")
    for thing in (reading, film, paint, reading.difference(reading)):
        html = thing._repr_html_()
        root = ElementTree.fromstring(f"<p>{html}</p>")
        if thing is reading:
            chips = [e for e in root.iter("div") if "background:#" in e.get("style", "")]
            assert len(chips) == len(reading.geometries)
            titles = [e.text for e in root.iter("title")]
            assert titles == [*reading.geometries, "lamp at 45°"]
            assert len(list(root.iter("polyline"))) == len(titles)
    assert "coats[0].thickness_nm" in paint._repr_html_()
    assert reading.srgb.min() >= 0
    assert reading.srgb.max() <= 1


def test_html_of_films_without_colours() -> None:
    """Curves where there are any."""
    for nm in ([550.0], [400.0, 410, 450], np.arange(1000.0, 1101, 10)):
        film = nacre.film([("1.9", 100)], angles_deg=[0, 60], wavelengths_nm=nm)
        root = ElementTree.fromstring(f"<p>{film._repr_html_()}</p>")
        assert len(list(root.iter("polyline"))) == (0 if len(nm) == 1 else 2)
    assert nacre.Chips([], []).css == []
    assert "background" not in nacre.Chips([], [])._repr_html_()


def test_films_keep_copies_of_what_was_asked() -> None:
    nm, angles = np.array([400.0, 500, 600]), np.array([0.0, 30])
    film = nacre.film([("1.9", 100)], angles_deg=angles, wavelengths_nm=nm)
    nm[0], angles[0] = 1, 80
    assert film.wavelengths_nm[0] == 400
    assert film.angles_deg[0] == 0


def test_results_may_be_compared(reading: nacre.Measurement) -> None:
    """By what they are, as arrays have no one truth."""
    image = nacre.Image({"R": np.zeros((2, 2), np.float32)}, {})
    for result in (nacre.film([("1.9", 100)]), reading.difference(reading), image):
        assert result == result
        assert result in [None, result]
        assert len({result, result}) == 1
    assert nacre.film([("1.9", 100)]) != nacre.film([("1.9", 100)])


def test_exposures_are_finite(tmp_path: Path) -> None:
    image = nacre.Image({c: np.ones((2, 2), np.float32) for c in "RGB"}, {})
    for stops in (np.nan, np.inf):
        with pytest.raises(nacre.SettingError, match=r"exposure_stops = .*: must be finite"):
            image.write(tmp_path / "x.png", exposure_stops=stops)


def test_html_of_materials() -> None:
    for name, first_nm in (("Al", "400"), ("TiO2_rutile", "500")):  # which begins at 430 nm
        shown = ElementTree.fromstring(f"<p>{nacre.Material(name)._repr_html_()}</p>")
        assert [e.text for e in shown.iter("title")] == ["n", "k"]
        assert next(shown.iter("text")).text == first_nm


def test_colours_side_by_side_are_dimmed_alike() -> None:
    lab = np.array([[[50.0, 20, -10], [40, 0, 0]], [[150, 0, 0], [75, 0, 0]]])
    shown = _rgb.shown_alike(lab)
    np.testing.assert_allclose(shown[0], nacre.srgb(lab[0]), atol=1e-4)
    # Of the second pair the brighter one is white, and light keeps its ratio.
    np.testing.assert_allclose(shown[1, 0], 1, atol=1e-6)
    luminance = ((lab[1, :, 0] + 16) / 116) ** 3
    linear = ((shown[1, 1] + 0.055) / 1.055) ** 2.4
    np.testing.assert_allclose(linear, luminance[1] / luminance[0], rtol=1e-6)


def test_ticks_are_round_and_within() -> None:
    for low, high in ((400.0, 700.0), (0.0, 0.0031), (-15.0, 110.0), (0.0, 12345.0), (0.0, 1e-12)):
        found = _html.ticks(low, high)
        assert 2 <= len(found) <= 6
        assert all(low <= t * (1 + 1e-12) and t * (1 - 1e-12) <= high for t in found)
    assert _html.ticks(400, 700) == [400, 500, 600, 700]
    assert _html.ticks(-15, 110) == [0, 50, 100]


def test_html_escapes_what_files_say() -> None:
    text = 'name = "<script>"\nior = 1.5\n[[layer]]\nthickness_um = 10\n'
    html = nacre.Paint.from_toml(text)._repr_html_()
    assert "<script>" not in html
    assert "&lt;script&gt;" in html


def test_spectra_of_ones_own() -> None:
    nm = np.arange(400.0, 701, 10)
    grey = np.full((2, nm.size), 0.18)
    reading = nacre.Measurement.from_spectra(["45as15", "45as110"], nm, grey, name="card")
    np.testing.assert_allclose(reading.XYZ[:, 1], 18, rtol=1e-12)
    np.testing.assert_allclose(reading.Lab[:, 1:], 0, atol=1e-9)
    assert reading.name == "card"
    assert reading.flop_index is None
    with pytest.raises(nacre.DomainError, match=r"R: must have the shape \(2, 31\)"):
        nacre.Measurement.from_spectra(["45as15", "45as110"], nm, grey[:1])
    # Colours alone have no spectra.
    colours = "geometry,L,a,b\n45as15,50,1,2\n45as45,40,1,2\n"
    alone = nacre.Paint.from_bytes(colours.encode(), "panel.csv").measure()
    assert alone.R.shape == (2, 0)
    with pytest.raises(nacre.SettingError, match="no spectra"):
        alone.to_colour()
    shown = ElementTree.fromstring(f"<p>{alone._repr_html_()}</p>")
    assert [e.text for e in shown.iter("title")] == ["lamp at 45°"]
