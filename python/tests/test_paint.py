"""Paints as values: opened, changed, evaluated, and what is wrong with them said."""

from __future__ import annotations

import gc
import os
import tomllib
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import nacre
from nacre import _toml

NM = [500.0, 600.0]


@pytest.fixture
def pearl(paints: Path) -> nacre.Paint:
    return nacre.Paint(paints / "tio2-mica-80.toml")


def test_shipped_paints_go_by_their_names(paints: Path) -> None:
    assert {"ruby", "pearl-blue"} <= set(nacre.shipped_paints())
    assert nacre.Paint("ruby").sha256 == nacre.Paint(paints / "ruby.toml").sha256
    with pytest.raises(nacre.InputError, match="did you mean 'ruby'"):
        nacre.Paint("rubi")


def test_a_shipped_paint_finds_the_spectrum_that_it_names(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)  # the file lies beside the recipe, not here
    primer = nacre.Paint("blue-tricoat").to_dict()["substrate"]["reflectance"]
    assert primer["wavelengths_nm"] == list(range(400, 701, 10))
    assert min(primer["values"]) > 0.3


def test_the_synthetic_primer_is_the_one_that_its_source_describes() -> None:
    """data/SOURCES.md: what the primer reads is read of a ground of that reflectance, too."""
    spectrum = nacre.Paint("blue-tricoat").to_dict()["substrate"]["reflectance"]
    parts = {
        "rutile-white": 0.08,
        "chalk": 0.2,
        "organic-blue-synthetic": 0.004,
        "carbon-black-coarse": 0.006,
    }
    pigment = [{"from": name, "volume_fraction": part} for name, part in parts.items()]
    primer = nacre.Paint.from_dict(
        {
            "ior": 1.5,
            "layer": [{"thickness_um": 45, "pigment": pigment}],
            "substrate": {"reflectance": 0.15},
        }
    )
    ground = nacre.Paint.from_dict(
        {"ior": 1.5, "layer": [{"thickness_um": 1}], "substrate": {"reflectance": spectrum}}
    )
    read, reread = (
        paint.measure(["45as45"], wavelengths_nm=range(400, 701, 10)).R
        for paint in (primer, ground)
    )
    # Half of the last of the file's four decimals: below a reflectance of 0.6 a reading changes by
    # less than its ground does.
    np.testing.assert_allclose(reread, read, rtol=0, atol=5e-5)


def test_numbers_that_are_hardly_meant_are_told(pearl: nacre.Paint) -> None:
    assert pearl.implausible == []
    pearl["coats[0].thickness_nm"] = 0.08
    (line,) = pearl.implausible
    assert "layer[0].flakes[0].coats[0].thickness_nm = 0.08 nm: thinner than 1 nm" in line


def test_one_sample_of_a_spreadsheet_is_opened_with_its_notes(tmp_path: Path) -> None:
    file = tmp_path / "panels.csv"
    file.write_text(
        "Probe;as45 R400;as45 R500;as45 R600\nRot;45,2;45;40\nBlau;20;30;31\n", encoding="utf-8"
    )
    paint = nacre.Paint(f"{file}#Rot")
    assert paint.measure().geometries == ["45as45"]
    (note,) = paint.notes
    assert "percent" in note
    with pytest.raises(nacre.InputError, match="holds 2 samples: 'Rot', 'Blau'"):
        nacre.Paint(file)


def test_every_recipe_survives_being_a_dictionary(paints: Path) -> None:
    files = sorted(paints.glob("*.toml"))
    assert len(files) > 5
    for file in files:
        paint = nacre.Paint(file)
        raw = tomllib.loads(file.read_text())
        assert nacre.Paint.from_dict(raw, folder=paints).sha256 == paint.sha256, file.name
        assert nacre.Paint.from_dict(paint.to_dict()).sha256 == paint.sha256, file.name
        assert nacre.Paint.from_toml(paint.to_toml()).sha256 == paint.sha256, file.name


@pytest.mark.parametrize(
    "table",
    [
        {"a": True, "b": -3, "c": 1e-9, "d": 'quote " \\ \n \x7f \x01 é', "with space": [1, 2.5]},
        {"t": {"u": {"v": 1}}, "list": [{"x": 1, "y": {"z": []}}, {"x": 2}], "last": "top"},
        {"empty": {}, "nested": [[1, 2], ["a"]], "inf": float("inf")},
    ],
)
def test_toml_is_read_back(table: dict[str, Any]) -> None:
    assert tomllib.loads(_toml.dumps(table)) == table


def test_what_is_no_toml() -> None:
    with pytest.raises(TypeError, match="binder: a recipe holds no NoneType"):
        nacre.Paint.from_dict({"binder": None})
    with pytest.raises(TypeError, match="are text"):
        nacre.Paint.from_dict({1: 2})  # type: ignore[dict-item]
    assert tomllib.loads(_toml.dumps({"a": np.array([1.5, 2]), "b": np.float64(3)})) == {
        "a": [1.5, 2.0],
        "b": 3.0,
    }


def test_a_new_value_is_another_paint(pearl: nacre.Paint) -> None:
    key = "coats[0].thickness_nm"
    before = pearl.brdf_at(45, 30, 180, NM)
    other = pearl.copy()
    other[key] = 95
    assert (pearl[key], other[key]) == (80, 95)
    assert f"layer[0].flakes[0].{key}" in other.parameters
    assert other.sha256 != pearl.sha256
    after = other.brdf_at(45, 30, 180, NM)
    assert not np.allclose(before, after, rtol=1e-2)
    np.testing.assert_array_equal(pearl.brdf_at(45, 30, 180, NM), before)
    np.testing.assert_array_equal(pearl.with_values({key: 95}).brdf_at(45, 30, 180, NM), after)
    with pytest.raises(nacre.DomainError, match=r"thickness_nm = -1: must be in \(0, 100000\] nm"):
        other[key] = -1
    with pytest.raises(nacre.DomainError, match="no"):
        other["coats[7].thickness_nm"]


def test_leading_axes_are_broadcast(pearl: nacre.Paint) -> None:
    wi = nacre.direction([20, 40])[:, None, :]
    wo = nacre.direction([0, 30, 50], 180)
    values = pearl.brdf(wi, wo, NM)
    assert values.shape == (2, 3, 2)
    for i in range(2):
        for o in range(3):
            np.testing.assert_array_equal(values[i, o], pearl.brdf(wi[i, 0], wo[o], NM))
    assert pearl.brdf(nacre.direction(10), nacre.direction(20), 550).shape == (1,)
    assert pearl.brdf_at(10, 20, np.zeros((0, 4)), NM).shape == (0, 4, 2)
    many = np.broadcast_to(wo, (50, 3, 3))  # so many that threads share them
    np.testing.assert_array_equal(pearl.brdf(wi[0], many, NM)[49], values[0])


def test_reciprocal_and_black_below_the_horizon(pearl: nacre.Paint) -> None:
    wi, wo = nacre.direction(25, 10), nacre.direction(60, 150)
    np.testing.assert_allclose(pearl.brdf(wi, wo, NM), pearl.brdf(wo, wi, NM), rtol=1e-6)
    assert not pearl.brdf(wi, [0, 0.1, -1], NM).any()
    assert not pearl.brdf([1, 0, 0], wo, NM).any()


def test_leaning_flakes_are_lit_from_the_azimuth_zero(paints: Path) -> None:
    text = "lean = { tilt_deg = 4 }\n" + (paints / "ruby.toml").read_text()
    leaning = nacre.Paint.from_toml(text)
    with pytest.raises(nacre.DomainError, match="wi: must have the azimuth 0"):
        leaning.brdf(nacre.direction(25, 10), nacre.direction(60, 150), NM)
    left, right = [
        leaning.brdf(nacre.direction(25), nacre.direction(40, phi), NM) for phi in (170, -170)
    ]
    np.testing.assert_allclose(left, right, rtol=1e-3)  # mirrored at the plane in which they lean


@pytest.mark.parametrize(
    ("wi", "message"),
    [
        ([0, 1], r"wi: has the shape \(2,\); its last axis must have 3 values"),
        ([0, 0, 0], "wi: a direction must be finite"),
        ([np.nan, 0, 1], "wi: a direction must be finite"),
        (np.ones((4, 3)), r"wi of leading axes \(4,\) and wo of \(2,\) cannot be broadcast"),
    ],
)
def test_wrong_directions(pearl: nacre.Paint, wi: Any, message: str) -> None:
    wo = np.ones((2, 3))
    for call in (pearl.brdf, pearl.pdf):
        with pytest.raises(nacre.DomainError, match=message):
            call(wi, wo, NM)


def test_wrong_settings(pearl: nacre.Paint) -> None:
    with pytest.raises(
        nacre.SettingError, match=r"model = nacer: is no model \(did you mean 'nacre'"
    ):
        pearl.brdf_at(0, 0, 0, NM, model="nacer")
    with pytest.raises(nacre.SettingError, match="hot_spots: the model nacre has no such option"):
        nacre.Model("nacre", hot_spots=True)
    with pytest.raises(nacre.SettingError, match="table") as raised:
        nacre.Model("microflake", table="no")
    assert "raw" in str(raised.value)
    with pytest.raises(nacre.SettingError, match="part = half: must be total"):
        pearl.brdf_at(0, 0, 0, NM, part="half")
    with pytest.raises(nacre.DomainError):
        pearl.brdf_at(95, 0, 0, NM)
    with pytest.raises(nacre.SettingError, match="illuminant = D64") as light:
        pearl.measure(illuminant="D64")
    assert light.value.setting == "illuminant"
    with pytest.raises(nacre.SettingError, match="9 wavelengths; 1 to 8"):
        pearl.sample([0, 0, 1], np.arange(9) * 10.0 + 500)
    with pytest.raises(nacre.DomainError, match=r"u: must be in \[0, 1\)"):
        pearl.sample([0, 0, 1], NM, u=[0, 1, 0])
    assert issubclass(nacre.SettingError, ValueError)
    assert issubclass(nacre.InputError, nacre.Error)


@pytest.mark.parametrize("model", ["microflake", "thin-film", "nacre"])
def test_samples_have_their_density_and_add_up_to_the_albedo(
    model: str, pearl: nacre.Paint
) -> None:
    n = 20000
    wi = nacre.direction(35, 20)
    sample = pearl.sample(np.broadcast_to(wi, (n, 3)), NM, rng=7, model=model)
    assert sample.valid.mean() > 0.5
    drawn = sample.valid & ~sample.specular
    density = pearl.pdf(wi, sample.wo[drawn], NM, model=model)
    np.testing.assert_allclose(density, sample.pdf[drawn], rtol=2e-3)
    brdf = pearl.brdf(wi, sample.wo[drawn], NM, model=model, as_rendered=True)
    cosine = sample.wo[drawn, 2:]
    # The scattering lobe's weight is f cos / pdf.
    np.testing.assert_allclose(brdf * cosine / density[:, None], sample.weight[drawn], rtol=2e-2)
    mean = sample.weight.mean(axis=0)
    error = sample.weight.std(axis=0) / np.sqrt(n)
    albedo = pearl.albedo(wi, NM, model=model)
    assert (np.abs(mean - albedo) < 4 * error + 0.01 * albedo).all()
    again = pearl.sample(np.broadcast_to(wi, (n, 3)), NM, rng=7, model=model)
    np.testing.assert_array_equal(again.wo, sample.wo)


def test_arrays_own_their_memory(pearl: nacre.Paint, paints: Path) -> None:
    values = pearl.brdf_at(45, 30, 180, NM)
    kept = values.copy()
    reading = pearl.measure(wavelengths_nm=[450, 550, 650])
    spectra = reading.R
    expected = spectra.copy()
    picture = nacre.render("sphere", nacre.Paint(paints / "red-gold.toml"), spp=1, size=(8, 8))
    rgb = picture.rgb
    assert not rgb.flags.writeable  # the picture's own
    pixels = rgb.copy()
    del reading, picture
    gc.collect()
    np.testing.assert_array_equal(values, kept)
    np.testing.assert_array_equal(spectra, expected)
    np.testing.assert_array_equal(rgb, pixels)
    assert values.flags.writeable
    assert values.dtype == np.float64


def test_solutions(pearl: nacre.Paint) -> None:
    solution = pearl.solve([550.0], exit_nodes=16, inner_nodes=8)
    assert solution.exit_nodes == 16
    np.testing.assert_array_equal(solution.wavelengths_nm, [550])
    assert any("nodes miss" in text for text in pearl.warnings) == (
        solution.unresolved_scattering > 0.02
    )
    with pytest.raises(nacre.SettingError, match=r"^exit_nodes = 7 is not a multiple of 4"):
        pearl.solve([550.0], exit_nodes=7)


def test_paints_without_a_recipe(paints: Path, tmp_path: Path, pearl: nacre.Paint) -> None:
    reading = pearl.measure(wavelengths_nm=[450, 550, 650])
    colours = nacre.Paint.from_bytes(reading.csv().encode(), "panel.csv")
    assert colours.kind == "measured_colours"
    with pytest.raises(nacre.InputError, match=r"panel\.csv: holds measured colours; a recipe is"):
        colours.to_toml()
    np.testing.assert_array_equal(colours.measure("45as45").Lab[0], reading.Lab[3])
    # What no file of its own may be named by.
    text = pearl.to_toml().replace('"mica"', '"mica.csv"')
    assert '"mica.csv"' in text
    with pytest.raises(nacre.InputError, match=r"mica\.csv"):
        nacre.Paint.from_toml(text)


def test_explicit_flakes_are_for_pictures(pearl: nacre.Paint) -> None:
    model = nacre.Model("nacre", flakes="explicit")
    with pytest.raises(nacre.SettingError, match="is for pictures, not for values"):
        pearl.brdf_at(0, 0, 0, NM, model=model)
    with pytest.raises(nacre.DomainError, match="flakes = no: must be one of hashed, explicit"):
        nacre.render("macro", pearl, model=nacre.Model("nacre", flakes="no"), spp=1, size=(4, 4))
    with pytest.raises(nacre.InputError, match="explicit flakes are at most 8e"):
        nacre.render("macro", pearl, model=model, spp=1, size=(4, 4))
    with pytest.raises(nacre.DomainError, match="flat panel"):
        nacre.render("sphere", pearl, model=model, spp=1, size=(4, 4))


def test_keys_mean_one_number(pearl: nacre.Paint) -> None:
    key = "coats[0].thickness_nm"
    assert key in pearl
    assert f"layer[0].flakes[0].{key}" in pearl
    assert "thickness_nm" not in pearl  # several
    assert "no" not in pearl
    assert 0 not in pearl
    for several in ("*thickness_nm", "thickness_nm"):
        with pytest.raises(nacre.DomainError, match="thickness_nm"):
            pearl[several]
    with pytest.raises(nacre.DomainError, match=r"\*thickness_nm: means 3 numbers, such as layer"):
        pearl["*thickness_nm"]
    assert pearl["*coats*thickness_nm"] == pearl[key]


def test_a_number_that_is_set_to_itself_changes_nothing(paints: Path) -> None:
    asked = 0
    for name in ("solid-red", "candy-red", "ruby"):
        paint = nacre.Paint(paints / f"{name}.toml")
        for key in paint:
            asked += key.endswith(".max")
            assert paint.with_values({key: paint[key]}).to_dict() == paint.to_dict(), key
    assert asked > 2


@pytest.mark.parametrize("model", [None, "nacre"])
def test_wavelengths_beyond_the_usual_are_solved_for(pearl: nacre.Paint, model: Any) -> None:
    """Within the 5e-3 of the tables, as all others."""
    wi, nm = [0.5, 0, 0.8], [380.0, 550.0, 720.0]
    got = pearl.albedo(wi, nm, model=model)
    alone = pearl.albedo(wi, [380.0], model=model)
    np.testing.assert_allclose(alone, got[:1], rtol=5e-3)
    np.testing.assert_allclose(got[1], pearl.albedo(wi, [550.0], model=model)[0], rtol=5e-3)
    # Samples are of the same solution.
    sample = pearl.sample(np.tile(wi, (20000, 1)), nm, rng=1, model=model)
    mean = np.where(sample.valid[:, None], sample.weight, 0).mean(axis=0)
    np.testing.assert_allclose(mean, got, rtol=0.03)
    assert abs(got[0] / pearl.albedo(wi, [400.0], model=model)[0] - 1) > 0.05


def test_solved_paints_have_no_other_wavelengths(pearl: nacre.Paint, tmp_path: Path) -> None:
    pearl.write(tmp_path / "pearl.h5", wavelengths_nm=[450, 550, 650])
    solved = nacre.Paint(tmp_path / "pearl.h5")
    assert solved.albedo([0, 0, 1], [450, 500]).shape == (2,)  # between them, as it is rendered
    for call in (solved.albedo, solved.sample):
        with pytest.raises(nacre.InputError, match="700 nm is not among them"):
            call([0, 0, 1], [550, 700])


def test_directions_of_any_length_and_no_wavelengths(pearl: nacre.Paint) -> None:
    wo = nacre.direction(20, 180)
    for scale in (1e200, 1e-200, 3.0):
        wi = np.multiply(scale, [0.5, 0, 0.8])
        np.testing.assert_allclose(
            pearl.brdf(wi, wo, NM), pearl.brdf([0.5, 0, 0.8], wo, NM), rtol=1e-9
        )
        np.testing.assert_allclose(pearl.albedo(wi, NM), pearl.albedo([0.5, 0, 0.8], NM), rtol=1e-5)
    assert pearl.brdf([[0, 0, 1]] * 4, wo, []).shape == (4, 0)
    assert pearl.brdf_at([10, 20], 0, 0, []).shape == (2, 0)
    assert pearl.albedo([0, 0, 1], []).shape == (0,)


@pytest.mark.parametrize("angle", [90, -10, np.nan])
def test_polar_angles_are_named_in_degrees(pearl: nacre.Paint, angle: float) -> None:
    for name in ("theta_i_deg", "theta_o_deg"):
        i, o = (angle, 0.0) if name == "theta_i_deg" else (0.0, angle)
        with pytest.raises(nacre.SettingError, match=rf"{name} = .*: must be in \[0, 90\) deg"):
            pearl.brdf_at(i, o, 0, NM)


@pytest.mark.parametrize("specimen", ["abc", "", True, -1, 1.7, "1abc", 2**53 + 1, 2**64])
def test_specimens_are_whole_numbers(specimen: Any) -> None:
    with pytest.raises(nacre.SettingError, match=r"must be a whole number in \[0, 90071") as raised:
        nacre.Model("nacre", specimen=specimen)
    assert raised.value.setting == "specimen"


def test_settings_are_named_as_python_spells_them(pearl: nacre.Paint) -> None:
    assert nacre.Model("nacre", specimen=2**53).options["specimen"] == str(2**53)
    assert nacre.Model("nacre", hot_spot=np.False_) == nacre.Model("nacre", hot_spot=False)  # type: ignore[arg-type]
    calls: list[tuple[str, str, Callable[[], object]]] = [
        ("hot_spot", "hot_spot = 1: must be on or off", lambda: nacre.Model("nacre", hot_spot=1)),
        ("table", "table = no: must be one of", lambda: nacre.Model("microflake", table="no")),
        (
            "constructions",
            "constructions = 0",
            lambda: nacre.fit(pearl, library=".", constructions=0),
        ),
        ("free", "free: belongs", lambda: nacre.fit(pearl, library=".", free="alpha")),
        ("path", "must end in", lambda: pearl.write("x.foo")),
        ("path", "holds no measured", lambda: nacre.Measurement.read("tio2-mica-80")),
        (
            "flakes",
            "for pictures",
            lambda: pearl.measure(model=nacre.Model("nacre", flakes="explicit")),
        ),
        (
            "resume",
            "belongs to shard",
            lambda: nacre.render("sphere", pearl, spp=1, size=(4, 4), resume="x.h5"),
        ),
    ]
    for setting, text, call in calls:
        with pytest.raises(nacre.SettingError, match=text) as raised:
            call()
        assert raised.value.setting == setting
        assert not str(raised.value).startswith("--")


@pytest.mark.parametrize("model", ["walk", "microflake", "thin-film"])
def test_models_without_single_flakes_have_no_sparkle(pearl: nacre.Paint, model: str) -> None:
    with pytest.raises(nacre.SettingError, match=f"model = {model}: .*no sparkle .*nacre") as got:
        pearl.sparkle(model=model, lamps_deg=[15], field_mm=1, diffuse_samples=0)
    assert got.value.setting == "model"


def test_sparkle_without_a_model_is_that_of_its_default(pearl: nacre.Paint) -> None:
    settings: dict[str, Any] = {"lamps_deg": [15], "field_mm": 3, "diffuse_samples": 0}
    by_default = pearl.sparkle(model=None, **settings).lamps[0].picture
    np.testing.assert_array_equal(by_default, pearl.sparkle(**settings).lamps[0].picture)
    assert by_default.max() > 0


def test_the_last_solutions_are_kept(pearl: nacre.Paint) -> None:
    """Each has its warning."""
    paint = pearl.copy()
    paint["coats[0].thickness_nm"] = 90
    for nm in range(12):
        paint.solve([500.0 + nm], exit_nodes=8, inner_nodes=4)
    assert len(paint.warnings) == 8
    paint.solve([500.0], exit_nodes=8, inner_nodes=4)
    assert len(paint.warnings) == 8


def test_paths_need_not_be_utf8(pearl: nacre.Paint, tmp_path: Path) -> None:
    def path(name: bytes) -> str:
        return os.fsdecode(os.fsencode(tmp_path) + b"/" + name)

    pearl.write(path(b"p\xff.toml"))
    paint = nacre.Paint(path(b"p\xff.toml"))
    assert paint.file == path(b"p\xff.toml")
    assert paint.sha256 == pearl.sha256
    assert isinstance(paint.name, str)
    reading = pearl.measure("45as15", wavelengths_nm=[450, 550, 650])
    reading.write(path(b"m\xff.csv"))
    assert isinstance(nacre.Measurement.read(path(b"m\xff.csv")).name, str)
    for call in (
        lambda: nacre.render(path(b"no\xff.toml")),
        lambda: nacre.pigment(path(b"no\xff.csv")),
        lambda: nacre.fit(reading, library=path(b"no\xff")),
    ):
        with pytest.raises(nacre.InputError, match="no"):
            call()
