"""Pickled and copied: equal value for value, without the files that they came from."""

from __future__ import annotations

import copy
import multiprocessing
import pickle
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import nacre

NM = [450.0, 550.0, 650.0]


def again(value: Any) -> Any:
    return pickle.loads(pickle.dumps(value))


@pytest.fixture
def pearl() -> nacre.Paint:
    return nacre.Paint("tio2-mica-80")


def brdf_of(paint: nacre.Paint, model: nacre.Model) -> Any:
    return paint.brdf_at(45, [0, 30, 60], 180, NM, model=model)


def test_recipes(paints: Path, pearl: nacre.Paint) -> None:
    made = again(pearl)
    assert (made.name, made.kind, made.sha256) == (pearl.name, pearl.kind, pearl.sha256)
    assert made.file == pearl.file
    assert made.to_toml() == pearl.to_toml()  # bounds and uncertainty with it
    np.testing.assert_array_equal(made.brdf_at(45, 30, 180, NM), pearl.brdf_at(45, 30, 180, NM))
    changed = pearl.copy()
    changed["coats[0].thickness_nm"] = 90
    assert again(changed)["coats[0].thickness_nm"] == 90


def test_every_shipped_recipe() -> None:
    for name in nacre.shipped_paints():
        paint = nacre.Paint(name)
        assert again(paint).to_toml() == paint.to_toml(), name


def test_deep_copies_share_a_solution_until_one_is_changed(pearl: nacre.Paint) -> None:
    made = copy.deepcopy({"paint": pearl})["paint"]
    made["coats[0].thickness_nm"] = 90
    assert pearl["coats[0].thickness_nm"] != 90


@pytest.mark.parametrize("name", ["p.h5", "p.binary", "p.bsdf", "t.h5"])
def test_other_files_are_not_needed_again(name: str, pearl: nacre.Paint, tmp_path: Path) -> None:
    path = tmp_path / name
    options: dict[str, Any] = {"wavelengths_nm": NM} if name.endswith(("h5", "bsdf")) else {}
    if name == "t.h5":
        options["model"] = nacre.Model("microflake", table="svd")
    if name == "p.bsdf":
        options |= {"resolution": 8, "incidences": 8}
    if name == "p.binary":
        options |= {"cells": (8, 8, 8)}
    pearl.write(path, **options)
    paint = nacre.Paint(path)
    path.unlink()
    made = again(again(paint))
    assert (made.kind, made.file, made.name) == (paint.kind, paint.file, paint.name)
    nm = paint.wavelengths_nm
    np.testing.assert_array_equal(made.wavelengths_nm, nm)
    np.testing.assert_array_equal(
        made.brdf_at(45, [0, 30], 180, nm), paint.brdf_at(45, [0, 30], 180, nm)
    )


def test_measured_colours(tmp_path: Path) -> None:
    path = tmp_path / "panels.csv"
    path.write_text(
        "sample,geometry,L,a,b\none,45as15,50,1,2\none,45as45,40,1,2\ntwo,45as15,60,3,4\n"
    )
    paint = nacre.Paint(f"{path}#two")
    path.unlink()
    made = again(paint)
    assert made.notes == paint.notes
    assert made.measure().json() == paint.measure().json()


def test_measurements(pearl: nacre.Paint) -> None:
    for reading in (
        pearl.measure("45as15,45as25az90", wavelengths_nm=NM, illuminant="A", observer=2),
        pearl.measure("45as15", wavelengths_nm=NM, model="walk", walks=64),
    ):
        for made in (again(reading), copy.deepcopy(reading)):
            assert made.json() == reading.json()
            assert made.csv() == reading.csv()
            np.testing.assert_array_equal(made.R, reading.R)
            np.testing.assert_array_equal(made.Lab, reading.Lab)
            if reading.standard_error is not None:
                np.testing.assert_array_equal(made.standard_error, reading.standard_error)
    difference = reading.difference(reading)
    np.testing.assert_array_equal(again(difference).dE2000, difference.dE2000)


def test_a_match(pearl: nacre.Paint) -> None:
    key = "coats[0].thickness_nm"
    match = nacre.fit(pearl, pearl, key, starts=1)
    made = again(match)
    assert made.parameters == match.parameters
    assert made.uncertain_paint.to_toml() == match.uncertain_paint.to_toml()
    assert made.colours.json() == match.colours.json()


def test_models() -> None:
    for model in (nacre.Model("nacre", specimen=3, hot_spot=False), nacre.Model("microflake")):
        assert again(model) == model == copy.deepcopy(model)


def test_materials() -> None:
    own = nacre.Material.sampled("own", NM, [1.5, 1.6, 1.7], 0.1)
    for material in (nacre.Material(1.5 + 0.1j), nacre.Material("mica"), own):
        made = again(material)
        assert (made.name, made.source) == (material.name, material.source)
        np.testing.assert_array_equal(made.index(NM), material.index(NM))


def test_pictures(pearl: nacre.Paint, tmp_path: Path) -> None:
    picture = nacre.render(
        "sphere", pearl, spp=1, size=(8, 6), sparkle=True, spectral_bins=2, noise=False
    )
    made = again(picture)
    for name in ("rgb", "albedo", "normal", "alpha", "sparkle", "spectral", "bin_centres_nm"):
        np.testing.assert_array_equal(getattr(made, name), getattr(picture, name))
    assert (made.samples, made.seconds, made.noise) == (1, picture.seconds, picture.noise)
    assert made.image.metadata == picture.image.metadata
    shards = [
        again(nacre.render("sphere", pearl, spp=2, size=(8, 6), shard=(i, 2))) for i in (1, 2)
    ]
    for i, shard in enumerate(shards):
        assert shard.shard == (i + 1, 2)
        shard.write(tmp_path / f"{i}.h5")
    merged = nacre.merge([tmp_path / "0.h5", tmp_path / "1.h5"])
    whole = nacre.render("sphere", pearl, spp=2, size=(8, 6))
    np.testing.assert_array_equal(merged.rgb, whole.rgb)


def test_other_processes(pearl: nacre.Paint) -> None:
    model = nacre.Model("microflake")
    with multiprocessing.get_context("spawn").Pool(1) as pool:
        found = pool.apply(brdf_of, (pearl, model))
    np.testing.assert_array_equal(found, brdf_of(pearl, model))
