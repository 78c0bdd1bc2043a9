"""Paints as materials of three.js: the numbers in the file, and its shader as a browser runs it."""

from __future__ import annotations

import html
import json
import re
import shutil
import subprocess
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import threejs_in_numpy
from numpy.typing import NDArray

import nacre
from nacre import _nacre

Array = NDArray[np.float64]
BROWSERS = ("chromium", "chromium-browser", "google-chrome", "chrome")
PAGE = Path(__file__).with_name("threejs_shader.html")


def directions(count: int) -> tuple[Array, Array]:
    """Pairs of them, half near the mirror direction."""
    rng = np.random.default_rng(7)

    def upwards() -> Array:
        return nacre.direction(
            np.degrees(np.arccos(rng.uniform(0.1, 1, count))), rng.uniform(0, 360, count)
        )

    wi, wo = upwards(), upwards()
    near = wi[::2] * [-1, -1, 1] + rng.normal(0, 0.1, (len(wi[::2]), 3))
    near[:, 2] = np.abs(near[:, 2]) + 0.01
    wo[::2] = near / np.linalg.norm(near, axis=-1, keepdims=True)
    return wi, wo


def shader_of(paint: nacre.Paint, model: str = "nacre") -> threejs_in_numpy.Shader:
    arrays = _nacre.appearance_arrays(paint._paint, nacre.Model(model)._model, False, None)
    return threejs_in_numpy.Shader(arrays)


@pytest.mark.parametrize(
    # With a hot spot and a ground, two species and dyes, many layers, a rough coat, Mie pigments.
    "name",
    ["red-gold", "ruby", "white-pearl", "satin-silver", "tinted-grey"],
)
@pytest.mark.parametrize("model", ["nacre", "microflake"])
def test_values_are_those_of_nacre(name: str, model: str, paints: Path) -> None:
    paint = nacre.Paint(paints / f"{name}.toml")
    wi, wo = directions(300)
    spectra = paint.brdf(wi, wo, nacre.WAVELENGTHS_NM, model=model, as_rendered=True)
    want = np.maximum(spectra @ threejs_in_numpy.film_weights(nacre.WAVELENGTHS_NM).T, 0)
    shader = _nacre.webgl_shader(paint._paint, nacre.Model(model)._model, None)
    got = np.maximum(shader.brdf(wi, wo), 0)
    # Sixteen wavelengths in place of 31.
    assert np.max(np.abs(got - want)) < 1e-2 * np.max(want)
    assert np.median(np.abs(got - want) / (want + 1e-3 * np.max(want))) < 5e-3
    twin = shader_of(paint, model).brdf(wi, wo)
    assert np.max(np.abs(got - twin)) < 1e-3 * np.max(want)


def test_the_file_says_how_far_it_is(paints: Path, tmp_path: Path) -> None:
    paint = nacre.Paint(paints / "red-gold.toml")
    file = tmp_path / "paint.three.js"
    error = paint.write(file)
    assert isinstance(error, nacre.ShaderMaterial)
    assert 0.05 < error.mean_delta_e_2000 < 1
    assert error.max_delta_e_2000 == max(error.delta_e_2000.values()) < 2
    about = re.search(r"^export const about = (.*?);$", file.read_text("utf-8"), re.S | re.M)
    assert about
    said = json.loads(about[1])["colour_differences"]
    assert said["by_angle"] == {k: round(v, 2) for k, v in error.delta_e_2000.items()}
    assert list(said["chips"]) == list(said["by_angle"])
    again = nacre.delta_e_2000(error.Lab[:, 0], error.Lab[:, 1])
    np.testing.assert_allclose(again, list(error.delta_e_2000.values()), rtol=1e-12)
    for chips in said["chips"].values():
        for chip in chips:
            assert f"background:{chip}" in error._repr_html_()
    # The hot spot is most of what it would miss.
    without = paint.write(file, model="microflake")
    assert isinstance(without, nacre.ShaderMaterial)
    assert without.mean_delta_e_2000 > 4 * error.mean_delta_e_2000


def test_what_a_shader_cannot_show_is_refused(paints: Path, tmp_path: Path) -> None:
    file = tmp_path / "paint.three.js"
    peel = (
        nacre.Paint(paints / "ruby.toml")
        .to_toml()
        .replace("[clearcoat]", "[clearcoat]\norange_peel = { wd = 0.002 }")
    )
    with pytest.raises(nacre.InputError, match="orange_peel"):
        nacre.Paint.from_toml(peel).write(file)
    lean = "lean = { tilt_deg = 4 }\n" + (paints / "ruby.toml").read_text()
    with pytest.raises(nacre.InputError, match=r"recipe: lean\.tilt_deg = 4: .* must be 0"):
        nacre.Paint.from_toml(lean).write(file)
    with pytest.raises(nacre.SettingError, match="wavelengths_nm"):
        nacre.Paint(paints / "ruby.toml").write(file, wavelengths_nm=[450, 550])
    assert not file.exists()
    # A clear layer, whose depth is 0.
    clear = nacre.Paint.from_toml(
        "ior = 1.5\n[[layer]]\nthickness_um = 10\n[substrate]\nreflectance = 0.5\n"
    )
    error = clear.write(file)
    assert isinstance(error, nacre.ShaderMaterial)
    assert error.max_delta_e_2000 < 1


SHOWN = ["red-gold", "white-pearl", "satin-silver", "tinted-grey"]


@pytest.fixture(scope="module")
def in_a_browser(paints: Path, tmp_path_factory: pytest.TempPathFactory) -> dict[str, Any]:
    """What a browser's graphics make of the modules of SHOWN, each in a context of its own; one
    browser for all, as its start takes ten times as long as a module."""
    browser = next(filter(None, map(shutil.which, BROWSERS)), None)
    if browser is None:
        pytest.skip(f"there is none of {', '.join(BROWSERS)} to run a shader in")
    folder = tmp_path_factory.mktemp("browser")
    modules = {}
    for name in SHOWN:
        nacre.Paint(paints / f"{name}.toml").write(folder / f"{name}.three.js")
        modules[name] = (folder / f"{name}.three.js").read_text(encoding="utf-8")
    page = PAGE.read_text(encoding="utf-8")
    page = page.replace("__PAIRS__", json.dumps(np.stack(directions(200), axis=1).tolist()))
    page = page.replace("__MODULES__", json.dumps(modules).replace("</", "<\\/"))
    (folder / "page.html").write_text(page, encoding="utf-8")
    seen = subprocess.run(
        [
            *(browser, "--headless", "--no-sandbox", "--use-gl=angle", "--use-angle=swiftshader"),
            *("--enable-unsafe-swiftshader", f"--user-data-dir={folder / 'profile'}"),
            *("--virtual-time-budget=20000", "--dump-dom", f"file://{folder / 'page.html'}"),
        ],
        capture_output=True,
        text=True,
        check=True,
    )
    text = re.search(r'<pre id="result">(.*?)</pre>', seen.stdout, re.DOTALL)
    assert text, seen.stderr
    found: dict[str, Any] = json.loads(html.unescape(text[1]))
    assert list(found) == SHOWN, seen.stderr
    return found


@pytest.mark.parametrize("name", SHOWN)
def test_a_browser_shows_the_same(name: str, paints: Path, in_a_browser: dict[str, Any]) -> None:
    paint = nacre.Paint(paints / f"{name}.toml")
    wi, wo = directions(200)
    found = in_a_browser[name]
    if "missing" in found:
        pytest.skip(f"the browser lacks {found['missing']}")
    assert found.get("error") == 0, found
    values = np.array(found["values"]).reshape(2, len(wi), 4)
    shader = shader_of(paint)
    want = shader.brdf(wi, wo)
    error = np.abs(values[0, :, :3] - want)
    # The browser may interpolate in half floats, and in steps of 1/256 of a texel.
    assert np.max(error) < 5e-3 * np.max(want)
    assert np.median(error / (want + 1e-3 * np.max(want))) < 4e-3
    albedo = (
        paint.albedo(wi, nacre.WAVELENGTHS_NM, model="nacre")
        @ threejs_in_numpy.film_weights(nacre.WAVELENGTHS_NM).T
    )
    np.testing.assert_allclose(values[1, :, :3], albedo, atol=2e-3)
    np.testing.assert_allclose(values[1, :, 3], shader.fresnel(wi[:, 2]), rtol=1e-4)
