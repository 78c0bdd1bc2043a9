"""Python equals the command line: the same numbers to the last bit, the same texts."""

from __future__ import annotations

import json
import os
from pathlib import Path

import numpy as np
import pytest
from conftest import Run, rows
from nacre.library import Plan, engine

import nacre


@pytest.mark.parametrize(
    ("paint", "model", "options"),
    [
        ("tio2-mica-80", nacre.Model("microflake"), []),
        ("tio2-mica-80", nacre.Model("nacre", specimen=3), ["--specimen", "3"]),
        ("tio2-mica-80", nacre.Model("nacre", hot_spot=False), ["--no-hot-spot"]),
        ("tio2-mica-80", nacre.Model("thin-film", colour="table"), ["--colour", "table"]),
        ("tio2-mica-80", nacre.Model("special-effect"), []),
    ],
)
def test_values(
    paint: str, model: nacre.Model, options: list[str], nacre_program: Run, paints: Path
) -> None:
    file = paints / f"{paint}.toml"
    process = nacre_program(
        *("eval", file, "--model", model.name, *options),
        *("--incident", "45", "--outgoing", "0:60:15,180", "--outgoing", "30,77"),
        *("--wavelength", "450,550,650"),
    )
    table = rows(process.stdout)
    theta_o = [float(row["theta_o"]) for row in table[::3]]
    phi = [float(row["phi_o"]) for row in table[::3]]
    values = nacre.Paint(file).brdf_at(45, theta_o, phi, [450, 550, 650], model=model)
    assert values.shape == (6, 3)
    assert [f"{v:.9g}" for v in values.ravel()] == [row["brdf"] for row in table]


def test_values_on_a_patch_and_parts(nacre_program: Run, paints: Path) -> None:
    file = paints / "tio2-mica-80.toml"
    look = ["--incident", "30", "--outgoing", "25,180", "--wavelength", "500,600"]
    paint = nacre.Paint(file)
    flakes = nacre_program(
        *("eval", file, "--model", "nacre", "--at", "1,2", "--footprint", "0.05", *look)
    )
    on_patch = paint.brdf_at(30, 25, 180, [500, 600], model="nacre", patch=(1, 2, 0.05))
    assert [f"{v:.9g}" for v in on_patch] == [row["brdf"] for row in rows(flakes.stdout)]
    mean = paint.brdf_at(30, 25, 180, [500, 600], model="nacre")
    assert not np.allclose(on_patch, mean, rtol=1e-3)
    for part in ("single", "multiple"):
        process = nacre_program("eval", file, "--part", part, *look)
        values = paint.brdf_at(30, 25, 180, [500, 600], part=part)
        assert [f"{v:.9g}" for v in values] == [row["brdf"] for row in rows(process.stdout)]


def test_reference(nacre_program: Run, paints: Path) -> None:
    file = paints / "tio2-mica-80.toml"
    process = nacre_program(
        *("reference", file, "--incident", "15,0", "--incident", "45", "--outgoing", "20,180"),
        *("--outgoing", "60,90", "--wavelength", "450,650", "--samples", "2000", "--seed", "3"),
    )
    table = rows(process.stdout)
    paint = nacre.Paint(file)
    values = paint.reference([15, 45], [20, 60], [180, 90], [450, 650], samples=2000, seed=3)
    assert values.brdf.shape == values.standard_error.shape == (2, 2, 2)
    assert [f"{v:.9g}" for v in values.brdf.ravel()] == [row["brdf"] for row in table]
    assert [f"{v:.3g}" for v in values.standard_error.ravel()] == [row["stderr"] for row in table]
    solved = paint.brdf_at(15, [20, 60], [180, 90], [450, 650])
    z = (values.brdf[0] - solved) / values.standard_error[0]
    assert np.abs(z).max() < 5


def test_errors_of_the_reference(nacre_program: Run, paints: Path, tmp_path: Path) -> None:
    file = tmp_path / "narrow.toml"
    text = (paints / "tio2-mica-80.toml").read_text(encoding="utf-8")
    file.write_text(text.replace('"TiO2_anatase"', '"ZnO"'), encoding="utf-8")
    look = ("--incident", "45", "--outgoing", "20", "--wavelength", "420")
    process = nacre_program("reference", file, *look, "--samples", "10", status=2)
    with pytest.raises(nacre.InputError) as raised:
        nacre.Paint(file).reference(45, 20, 0, [420], samples=10)
    assert f"nacre: {raised.value}\n" == process.stderr
    paint = nacre.Paint(paints / "tio2-mica-80.toml")
    for wrong, named in (
        ({"theta_i_deg": 90}, "theta_i_deg = 90"),
        ({"theta_o_deg": [10, -1]}, "theta_o_deg = -1"),
        ({"phi_deg": np.inf}, "phi_deg"),
        ({"wavelengths_nm": [-5]}, "wavelength"),
        ({"samples": 1}, "samples = 1"),
        ({"part": "half"}, "part = half"),
    ):
        arguments = {"theta_i_deg": 45, "theta_o_deg": 20, "phi_deg": 0, "samples": 10}
        with pytest.raises(nacre.DomainError, match=named):
            paint.reference(**(arguments | wrong))
    with pytest.raises(nacre.Stopped):
        paint.reference(45, 20, 0, samples=10**7, progress=lambda _: False)


def test_directions_are_the_angles(paints: Path) -> None:
    paint = nacre.Paint(paints / "tio2-mica-80.toml")
    theta_o, phi = np.array([0.0, 20, 20, 70]), np.array([0.0, 180, 90, 45])
    by_angles = paint.brdf_at(40, theta_o, phi, [500, 600])
    wi, wo = nacre.direction(40, 13), nacre.direction(theta_o, phi + 13)
    # Whatever their lengths, also where squares would underflow or overflow.
    for long_i, long_o in ((1, 7), (1e-160, 1e-160), (1e153, 1e153), (1e-150, 1e150)):
        by_directions = paint.brdf(long_i * wi, long_o * wo, [500, 600])
        np.testing.assert_allclose(by_directions, by_angles, rtol=1e-12)


def test_film(nacre_program: Run) -> None:
    process = nacre_program(
        *("film", "--ambient", "1.5", "--layer", "TiO2_anatase:80", "--layer", "3.18+3.33i:20"),
        *("--substrate", "mica", "--angle", "0,30,60,90", "--polarization", "p"),
    )
    film = nacre.film(
        [("TiO2_anatase", 80), (3.18 + 3.33j, 20)],
        ambient=1.5,
        substrate="mica",
        angles_deg=[0, 30, 60, 90],
        polarization="p",
    )
    table = rows(process.stdout)
    assert film.R.shape == film.T.shape == (4, 31)
    assert [f"{v:.12g}" for v in film.R.T.ravel()] == [row["R"] for row in table]
    assert [f"{v:.12g}" for v in film.T.T.ravel()] == [row["T"] for row in table]


@pytest.mark.parametrize(
    ("options", "settings"),
    [
        ([], {}),
        (["--geometry", "ma-t12", "--illuminant", "A", "--observer", "2"],
         {"geometry": "ma-t12", "illuminant": "A", "observer": 2}),
        (["--geometry", "45as15,45to30,90", "--model", "nacre"],
         {"geometry": ["45as15", "45to30,90"], "model": "nacre"}),
    ],
)  # fmt: skip
def test_readings(
    options: list[str], settings: dict[str, object], nacre_program: Run, paints: Path
) -> None:
    file = paints / "metallic-silver.toml"
    grid = ["--wavelength", "400:700:20"]
    process = nacre_program("measure", file, *options, *grid)
    nm = np.arange(400.0, 701, 20)
    reading = nacre.Paint(file).measure(**settings, wavelengths_nm=nm)  # type: ignore[arg-type]
    assert reading.csv() == process.stdout
    # Written out in full, so that numbers can be compared to the last bit.
    table = rows(process.stdout)
    assert [row["geometry"] for row in table] == reading.geometries
    for i, name in enumerate("Lab"):
        np.testing.assert_array_equal([float(row[name]) for row in table], reading.Lab[:, i])
    for i, wavelength in enumerate(nm):
        column = [float(row[f"R{wavelength:g}"]) for row in table]
        np.testing.assert_array_equal(column, reading.R[:, i])


def test_readings_as_files_and_their_difference(
    nacre_program: Run, paints: Path, tmp_path: Path
) -> None:
    first = nacre.Paint(paints / "tio2-mica-80.toml").measure(wavelengths_nm=range(400, 701, 20))
    second = nacre.Paint(paints / "red-gold.toml").measure(wavelengths_nm=range(400, 701, 20))
    first.write(tmp_path / "a.csv")
    second.write(tmp_path / "b.json")
    for file, reading in (("a.csv", first), ("b.json", second)):
        again = nacre.Measurement.read(tmp_path / file)
        np.testing.assert_array_equal(again.R, reading.R)
        np.testing.assert_array_equal(again.Lab, reading.Lab)
    process = nacre_program("measure", tmp_path / "a.csv", "--versus", tmp_path / "b.json")
    difference = first.difference(second)
    table = rows(process.stdout)
    np.testing.assert_array_equal([float(r["dE2000"]) for r in table], difference.dE2000)
    np.testing.assert_array_equal([float(r["dH"]) for r in table], difference.dH)
    with pytest.raises(nacre.SettingError, match=r"must end in \.csv or \.json"):
        first.write(tmp_path / "a.txt")


def test_files_of_paints(nacre_program: Run, paints: Path, tmp_path: Path) -> None:
    paint = nacre.Paint(paints / "tio2-mica-80.toml")
    nm = [450.0, 550, 650]
    grid = ["--wavelength", "450,550,650"]
    nacre_program("solve", paint.file, "-o", tmp_path / "program.h5", *grid)
    paint.write(tmp_path / "python.h5", wavelengths_nm=nm)
    assert (tmp_path / "python.h5").read_bytes() == (tmp_path / "program.h5").read_bytes()
    solved = nacre.Paint(tmp_path / "python.h5")
    assert solved.kind == "solved_paint"
    assert solved.sha256 == paint.sha256
    np.testing.assert_array_equal(solved.wavelengths_nm, nm)

    small = ["--resolution", "8", "--incidences", "4"]
    nacre_program("export", paint.file, "-o", tmp_path / "program.bsdf", *small, *grid)
    error = paint.write(tmp_path / "python.bsdf", resolution=8, incidences=4, wavelengths_nm=nm)
    assert (tmp_path / "python.bsdf").read_bytes() == (tmp_path / "program.bsdf").read_bytes()
    assert isinstance(error, nacre.Export)
    assert 0 < error.error_of_flux < error.error_over_peak
    nacre_program(
        "export", paint.file, "-o", tmp_path / "program.binary", "--cells", "6,5,4", *grid
    )
    paint.write(tmp_path / "python.binary", cells=(6, 5, 4), wavelengths_nm=nm)
    assert (tmp_path / "python.binary").read_bytes() == (tmp_path / "program.binary").read_bytes()
    assert nacre.Paint(tmp_path / "python.binary").kind == "measured_brdf"
    nacre_program("export", paint.file, "-o", tmp_path / "program.gltf", *grid)
    assert isinstance(
        paint.write(tmp_path / "python.gltf", wavelengths_nm=nm), nacre.FittedMaterial
    )
    assert (tmp_path / "python.gltf").read_bytes() == (tmp_path / "program.gltf").read_bytes()
    nacre_program("export", paint.file, "-o", tmp_path / "program.three.js")
    assert isinstance(paint.write(tmp_path / "python.three.js"), nacre.ShaderMaterial)
    modules = [tmp_path / f"{by}.three.js" for by in ("python", "program")]
    assert modules[0].read_bytes() == modules[1].read_bytes()
    with pytest.raises(nacre.SettingError, match=r"must end in \.toml, \.h5"):
        paint.write(tmp_path / "python.xml")


def test_shards_of_a_picture(nacre_program: Run, paints: Path, tmp_path: Path) -> None:
    file = paints / "flip-flop.toml"

    def shard(number: int) -> nacre.Picture:
        return nacre.render(
            "panel", nacre.Paint(file), spp=3, size=(10, 6), sparkle=True, shard=(number, 2)
        )

    shard(1).write(tmp_path / "1.h5")
    options = ("--paint", file, "--spp", "3", "--size", "10x6", "--sparkle")
    nacre_program("render", "panel", *options, "--shard", "2/2", "-o", tmp_path / "2.h5")
    nacre_program("render", "panel", *options, "-o", tmp_path / "whole.exr")
    merged = nacre.merge([tmp_path / "2.h5", tmp_path / "1.h5"])
    whole = nacre.read_image(tmp_path / "whole.exr")
    assert merged.image.metadata == whole.metadata
    assert merged.image.channels.keys() == whole.channels.keys()
    for name, pixels in whole.channels.items():
        np.testing.assert_array_equal(merged.image.channels[name], pixels)
    assert (merged.shard, merged.samples, merged.complete) == (None, 3, True)
    # A shard is a picture as well, of fewer samples.
    second = shard(2)
    assert (second.shard, second.samples, second.complete) == ((2, 2), 2, False)
    assert second.rgb.shape == (6, 10, 3)
    scene_sha256 = whole.metadata["nacre:scene_sha256"]
    assert second.image.metadata["nacre:scene_sha256"] == scene_sha256
    with pytest.raises(nacre.InputError, match="shards are missing: 1/2"):
        nacre.merge([tmp_path / "2.h5"])
    with pytest.raises(nacre.DomainError, match="shard = 3/2"):
        shard(3)


def test_picture(nacre_program: Run, paints: Path, tmp_path: Path) -> None:
    file = paints / "flip-flop.toml"
    nacre_program(
        *("render", "panel", "--paint", file, "--model", "nacre", "--specimen", "2", "--seed", "5"),
        *("--spp", "2", "--size", "20x12", "--spectral-bins", "3", "--sparkle"),
        *("--depth", "3", "--footprint", "0.5", "--no-hot-spot", "-o", tmp_path / "program.exr"),
    )
    picture = nacre.render(
        "panel",
        nacre.Paint(file),
        model=nacre.Model("nacre", specimen=2, hot_spot=False),
        seed=5,
        spp=2,
        size=(20, 12),
        spectral_bins=3,
        sparkle=True,
        depth=3,
        footprint_pixels=0.5,
    )
    expected = nacre.read_image(tmp_path / "program.exr")
    image = picture.image
    assert image.channels.keys() == expected.channels.keys()
    for name, pixels in expected.channels.items():
        np.testing.assert_array_equal(image.channels[name], pixels)
    assert image.metadata == expected.metadata
    assert image.metadata["nacre:depth"] == "3"
    assert image.metadata["nacre:footprint_pixels"] == "0.5"
    assert image.metadata["nacre:model_settings:paint"] == "nacre specimen=2 hot_spot=false"
    assert np.asarray(picture).shape == (12, 20, 3)
    assert picture.spectral is not None
    assert picture.spectral.shape == (12, 20, 3)
    picture.write(tmp_path / "python.exr")
    np.testing.assert_array_equal(nacre.read_image(tmp_path / "python.exr").rgb, picture.rgb)
    picture.write(tmp_path / "python.png")
    assert (tmp_path / "python.png").read_bytes()[1:4] == b"PNG"
    assert picture._repr_png_()[1:4] == b"PNG"


def test_sparkle(nacre_program: Run, paints: Path) -> None:
    file = paints / "glitter-100um.toml"
    process = nacre_program(
        *("sparkle", file, "--lamp", "15,45", "--field", "3", "--pixel", "50", "--seed", "2"),
        *("--diffuse-samples", "8"),
    )
    sparkle = nacre.Paint(file).sparkle(
        lamps_deg=[15, 45], field_mm=3, pixel_um=50, diffuse_samples=8, seed=2
    )
    table = rows(process.stdout)
    assert sparkle.diffuse is not None
    assert len(table) == 3
    for row, lamp in zip(table, sparkle.lamps, strict=False):
        assert row["Y"] == f"{lamp.Y:.6g}"
        assert row["spots_per_cm2"] == f"{lamp.spots_per_cm2.value:.6g}"
        assert row["pixel_contrast_se"] == f"{lamp.pixel_contrast.standard_error:.6g}"
        assert lamp.picture.shape == (60, 60, 3)
    assert table[2]["graininess"] == f"{sparkle.diffuse.graininess.value:.6g}"


def test_fit(nacre_program: Run, paints: Path, tmp_path: Path) -> None:
    key = "coats[0].thickness_nm"
    nm = range(400, 701, 40)
    standard = nacre.Paint(paints / "tio2-mica-110.toml").measure(wavelengths_nm=nm)
    standard.write(tmp_path / "standard.csv")
    start = nacre.Paint(paints / "tio2-mica-80.toml").with_values({key: 100})
    start.write(tmp_path / "start.toml")
    process = nacre_program(
        *("fit", tmp_path / "standard.csv", "--start", tmp_path / "start.toml", "--free", key),
        *("--starts", "1", "--format", "json"),
    )
    match = nacre.fit(standard, start, key, starts=1)
    (found,) = match.parameters.values()
    (expected,) = json.loads(process.stdout)["numbers"]
    assert found.value == expected["value"]
    assert found.value == pytest.approx(110, abs=0.1)
    assert match.paint[key] == found.value
    assert start[key] == 100
    np.testing.assert_array_equal(match.standard.Lab, standard.Lab)
    assert match.colours.difference(match.standard).max_dE2000 < 0.1


def test_fit_from_a_library(nacre_program: Run, tmp_path: Path) -> None:
    (tmp_path / "plan.toml").write_text(
        """
        [[sweep]]
        base = "tio2-mica-80"
        vary = { "coats[0].thickness_nm" = [70, 105] }
        [[sweep]]
        name = "solid"
        base = "solid-red"
        """
    )
    library = tmp_path / "made"
    engine.run(Plan(tmp_path / "plan.toml"), library, workers=0)
    standard = nacre.Paint("tio2-mica-110").measure(wavelengths_nm=range(400, 701, 40))
    standard.write(tmp_path / "standard.csv")
    process = nacre_program(
        *("fit", tmp_path / "standard.csv", "--library", library, "--starts", "1"),
        *("--format", "json", "-o", tmp_path / "found.toml"),
    )
    expected = json.loads(process.stdout)
    match = nacre.fit(standard, library=library, starts=1)
    assert match.matched
    assert [
        {
            "construction": one.construction,
            "record": one.record,
            "name": one.name,
            "nearest_mean_delta_e_2000": one.nearest_mean_dE2000,
            "mean_delta_e_2000": one.match.difference.mean_dE2000,
            "matched": one.match.matched,
            "recipe_sha256": one.match.paint.sha256,
        }
        for one in match.constructions
    ] == expected["constructions"]
    assert [one.match.matched for one in match.constructions] == [True, False]
    assert match.paint is match.constructions[0].match.paint
    assert nacre.Paint(tmp_path / "found.toml").sha256 == match.paint.sha256
    (found,) = match.parameters.values()
    assert found.value == expected["numbers"][0]["value"] == pytest.approx(110, abs=0.1)
    for wrong, message in (
        ({}, "start or library"),
        ({"library": library, "start": match.paint}, "start or library"),
        ({"library": library, "free": "ior"}, "free: belongs to start"),
        ({"library": library, "constructions": 0}, "constructions = 0: must be at least 1"),
    ):
        with pytest.raises(nacre.SettingError, match=message):
            nacre.fit(standard, **wrong)  # type: ignore[arg-type]
    with pytest.raises(nacre.InputError, match="has no records"):
        nacre.fit(standard, library=tmp_path / "none")


@pytest.mark.parametrize(
    "text",
    [
        "ior = 1.5\n[[layer]]\nthickness_um = -3\n",
        "ior = 1.5\nthick = 3\n",
        "ior = ",
        "ior = 1.5\n[[layer]]\nthickness_um = 3\n[[layer.flakes]]\nvolume_fraction = 2\n",
        "binder = 'no\x07such'\n",
    ],
)
def test_texts_of_errors(text: str, nacre_program: Run, tmp_path: Path) -> None:
    file = tmp_path / "wrong.toml"
    file.write_text(text)
    process = nacre_program("info", file, status=2)
    with pytest.raises(nacre.InputError) as raised:
        nacre.Paint(file)
    assert f"nacre: {raised.value}\n" == process.stderr
    assert os.fspath(file) in str(raised.value)
