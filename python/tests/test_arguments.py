"""Wrong arguments of all public functions: errors name the argument as Python spells it."""

from __future__ import annotations

import inspect
import re
from collections.abc import Callable, Iterator
from functools import partial
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import nacre

NM = [450.0, 550.0, 650.0]
COAT = "coats[0].thickness_nm"
UP = [0.0, 0.0, 1.0]


def paint() -> nacre.Paint:
    return nacre.Paint("tio2-mica-80")


def reading() -> nacre.Measurement:
    return nacre.Measurement.from_spectra("45as15", NM, [[0.1, 0.2, 0.3]])


def enter_threads(count: int) -> None:
    with nacre.threads(count):
        pass


def plain(function: Any) -> Any:
    """Of a partial call."""
    return plain(function.func) if isinstance(function, partial) else function


def numeric_arguments() -> Iterator[tuple[str, str]]:
    """Of all public functions and methods: function and argument."""
    for name in nacre.__all__:
        thing = getattr(nacre, name)
        functions = [thing] if inspect.isfunction(thing) else []
        if inspect.isclass(thing):
            functions = [
                member
                for key, member in inspect.getmembers(thing)
                if not key.startswith("_") and callable(member)
            ]
        for function in functions:
            if not hasattr(function, "__annotations__"):
                continue
            for argument, kind in inspect.get_annotations(function).items():
                if argument != "return" and re.search(r"\b(int|float|ArrayLike)\b", str(kind)):
                    yield function.__qualname__, argument


def wrong_calls(folder: Path) -> list[tuple[str, Callable[..., object], dict[str, Any], list[Any]]]:
    """Of each function: the argument, the function, its other arguments, and wrong values."""
    p, m = paint(), reading()
    render = partial(nacre.render, "sphere", p)
    film = partial(nacre.film, [("TiO2_anatase", 80)])
    rgl, merl = partial(p.write, folder / "x.bsdf"), partial(p.write, folder / "x.binary")
    fit = partial(nacre.fit, m, p)
    drawdown = folder / "drawdown.csv"
    drawdown.write_text(
        "ground,thickness_um,volume_fraction,400,550,700\n"
        "black,0,0,0.05,0.05,0.05\nwhite,0,0,0.8,0.8,0.8\n"
        "black,50,0.1,0.3,0.3,0.3\nwhite,50,0.1,0.6,0.6,0.6\n"
    )
    picture = render(spp=1, size=(2, 2))
    tiny = {"spp": 1, "size": (4, 4)}
    at = {"theta_i_deg": 0, "theta_o_deg": 0, "phi_deg": 0, "wavelengths_nm": NM}
    both = {"wi": UP, "wo": UP, "wavelengths_nm": NM}
    inf, nan = np.inf, np.nan
    calls: list[tuple[Callable[..., object], dict[str, Any], dict[str, list[Any]]]] = [
        (
            p.brdf,
            both,
            {
                "wi": [[0, 0, 0], [0, nan, 1], [1, 0]],
                "wo": [[0, 0, 0]],
                "wavelengths_nm": [[-1.0], [nan]],
                "patch": [(0, 0, -1)],
                "model": ["nacer"],
                "part": ["half"],
            },
        ),
        (
            p.brdf_at,
            at,
            {
                "theta_i_deg": [91, -1, nan],
                "theta_o_deg": [91, -1, nan],
                "phi_deg": [inf, nan],
                "wavelengths_nm": [[-1.0]],
                "model": ["nacer"],
                "patch": [(0, 0, -1)],
            },
        ),
        (
            p.reference,
            at | {"samples": 100},
            {
                "theta_i_deg": [91],
                "theta_o_deg": [-1],
                "phi_deg": [inf],
                "wavelengths_nm": [[-1.0]],
                "samples": [0, -1],
                "seed": [-1],
                "part": ["half"],
            },
        ),
        (
            p.sample,
            {"wi": UP, "wavelengths_nm": NM},
            {
                "wi": [[0, 0, 0]],
                "u": [[2, 0, 0]],
                "wavelengths_nm": [None, [-1.0], [1e9], np.full(9, 500.0)],
            },
        ),
        (p.pdf, both, {"wi": [[0, 0, 0]], "wo": [[0, 0, 0]], "wavelengths_nm": [None, [-1.0]]}),
        (p.albedo, {"wi": UP}, {"wi": [[0, 0, 0]], "wavelengths_nm": [[-1.0]]}),
        (
            p.solve,
            {"wavelengths_nm": NM},
            {
                "wavelengths_nm": [[-1.0], np.linspace(400, 700, 5000)],
                "exit_nodes": [3, 500, -4, 10**12],
                "inner_nodes": [3, 500],
                "max_orders": [-1],
                "tolerance": [-1, nan],
            },
        ),
        (
            p.measure,
            {},
            {
                "wavelengths_nm": [[-1.0, -2.0], [500.0]],
                "aperture_deg": [(20, 0), (0, 20)],
                "illuminant": ["Q"],
                "observer": [3],
                "walks": [-1],
                "seed": [-1],
                "geometry": ["45as", []],
            },
        ),
        (p.measure, {"model": "walk"}, {"aperture_deg": [(1, 1)], "walks": [0]}),
        (
            p.uncertainty,
            {"deviations": {COAT: "5 %"}},
            {
                "wavelengths_nm": [[-1.0, -2.0]],
                "samples": [3, -1],
                "seed": [-1],
                "deviations": [{}, {COAT: -1}],
                "correlations": [{(COAT, "core.thickness_nm"): 3}],
                "illuminant": ["Q"],
                "observer": [3],
                "geometry": [[]],
            },
        ),
        (
            p.sparkle,
            {},
            {
                "lamps_deg": [[95], [15] * 17],
                "lamp_half_angle_deg": [-1, 5],
                "field_mm": [0, 1e9],
                "pixel_um": [0],
                "diffuse_samples": [-2, 3],
                "distance_mm": [0],
                "illuminance_lx": [0],
                "seed": [-1],
            },
        ),
        (
            p.sparkle,
            {"model": "special-effect", "field_mm": 1, "lamps_deg": [15], "diffuse_samples": 0},
            {"panel_mm": [0]},
        ),
        (
            rgl,
            {},
            {"resolution": [1, 10**9], "incidences": [1], "wavelengths_nm": [[-1.0]]},
        ),
        (merl, {}, {"cells": [(0, 9, 9), (9, 0, 9), (9, 9, 10**12)]}),
        (
            film,
            {},
            {"angles_deg": [91], "wavelengths_nm": [-1, nan], "polarization": ["x"]},
        ),
        (nacre.film, {}, {"layers": [[("TiO2_anatase", -1)]]}),
        (
            nacre.xyz,
            {"reflectance": [1, 1, 1]},
            {"wavelengths_nm": [[1.0], [400, 410, 700]]},
        ),
        (
            nacre.xyz,
            {"wavelengths_nm": NM, "reflectance": [1, 1, 1]},
            {"reflectance": [[1, 1]], "observer": [3]},
        ),
        (
            nacre.lab,
            {"wavelengths_nm": NM, "reflectance": [1, 1, 1]},
            {
                "illuminant": ["Q"],
                "observer": [3],
                "reflectance": [[1, 1]],
                "wavelengths_nm": [[400, 410, 700]],
            },
        ),
        (
            nacre.delta_e_2000,
            {"lab1": [0, 0, 0], "lab2": [0, 0, 0]},
            {"lab1": [[0]], "lab2": [[0]]},
        ),
        (nacre.srgb, {}, {"lab": [[0]]}),
        (nacre.Material("mica").index, {}, {"wavelengths_nm": [-1]}),
        (
            nacre.Measurement.from_spectra,
            {"geometry": "45as15", "wavelengths_nm": NM, "R": [[1, 1, 1]]},
            {"wavelengths_nm": [[400, 410, 700]], "R": [[1]], "illuminant": ["Q"], "observer": [3]},
        ),
        (m.difference, {"standard": m}, {"weights": [{"nothing": 1}, {"45as15": -1}]}),
        (
            fit,
            {"free": COAT},
            {
                "starts": [0, 10**9],
                "seed": [-1],
                "noise_dE": [0],
                "equal_dE": [0],
                "matched_dE": [0],
                "also": ["Q"],
                "weights": [{"nothing": 1}],
                "constructions": [0],
                "free": [None],
            },
        ),
        (
            render,
            tiny,
            {
                "spp": [0, 10**12],
                "size": [(0, 5), (5, 0), (10**9, 5), (10**5, 10**5), (10**12, 5)],
                "depth": [0],
                "seed": [-1],
                "footprint_pixels": [-1],
                "spectral_bins": [-1],
                "turntable": [("camera", inf)],
                "shard": [(0, 3), (4, 3)],
            },
        ),
        (nacre.render, {"scene": "sphere"} | tiny, {"paint": [None]}),
        (
            nacre.pigment,
            {"drawdown": drawdown},
            {"anisotropy": [-1, 1], "noise": [0], "geometry": ["x"]},
        ),
        (nacre.set_threads, {}, {"count": [-1, 10**9, 10**12]}),
        (enter_threads, {}, {"count": [-1, 10**9]}),
        (
            nacre.Material.sampled,
            {"name": "own", "wavelengths_nm": NM, "n": [1.5, 1.5, 1.5]},
            {
                "wavelengths_nm": [[500, 400, 300]],
                "n": [[-1, 1, 1], [1.5, 1.5], [nan, 1, 1]],
                "k": [-1, [1, 1]],
            },
        ),
        (
            nacre.Image(dict.fromkeys("RGB", np.ones((2, 2), np.float32)), {}).write,
            {"path": folder / "x.png"},
            {"exposure_stops": [1e9, nan]},
        ),
        (picture.write, {"path": folder / "x.png"}, {"exposure_stops": [1e9, nan]}),
        (picture.write_exr_and_png, {"exr": folder / "x.exr"}, {"exposure_stops": [1e9]}),
    ]
    return [
        (argument, function, others, values)
        for function, others, wrong in calls
        for argument, values in wrong.items()
    ]


def test_errors_name_the_argument(tmp_path: Path) -> None:
    wrong: list[str] = []
    for argument, function, others, values in wrong_calls(tmp_path):
        assert argument in inspect.signature(function).parameters
        for value in values:
            call = f"{function}({argument}={value})"
            try:
                function(**{**others, argument: value})
                wrong.append(f"{call}: nothing raised")
            except nacre.SettingError as error:
                text = str(error)
                if error.setting != argument or not text.startswith(argument) or "--" in text:
                    wrong.append(f"{call}: {error.setting!r}: {text}")
            except (nacre.Error, TypeError) as error:
                wrong.append(f"{call}: {type(error).__name__}: {error}")
    assert not wrong, "\n".join(wrong)


def test_no_numeric_argument_is_left_out(tmp_path: Path) -> None:
    tried = {(plain(f).__qualname__, argument) for argument, f, _, _ in wrong_calls(tmp_path)}
    # Which take any number, raise about a key of their own, or take numbers among other things.
    others = {
        ("direction", "theta_deg"),
        ("direction", "phi_deg"),
        ("Paint.with_values", "values"),
        ("PaintLight.sample", "rng"),
        ("threads", "count"),  # entered above
    }
    assert set(numeric_arguments()) - tried == others


def test_types_are_said() -> None:
    p, m = paint(), reading()
    at = {"theta_i_deg": 0, "theta_o_deg": 0, "phi_deg": 0}
    calls: list[tuple[str, Callable[..., Any], dict[str, Any]]] = [
        (
            "model: must be a Model",
            p.brdf_at,
            dict.fromkeys(("theta_i_deg", "theta_o_deg"), 0) | {"phi_deg": 0, "model": 3},
        ),
        ("model: must be a Model", nacre.render, {"scene": "sphere", "paint": p, "model": 3}),
        ("standard: must be a Measurement, a Paint", nacre.fit, {"standard": 3, "start": p}),
        ("start: must be a Paint", nacre.fit, {"standard": m, "start": 3}),
        ("paint: must be a Paint", nacre.render, {"scene": "sphere", "paint": 3}),
        ("standard: must be a Measurement", m.difference, {"standard": p}),
        ("geometry: must be text", p.measure, {"geometry": 3}),
        ("spp = 2.5: must be a whole", nacre.render, {"scene": "sphere", "paint": p, "spp": 2.5}),
        ("spp = 'x': must be a number", nacre.render, {"scene": "sphere", "paint": p, "spp": "x"}),
        ("name = 3: must be text", nacre.Model, {"name": 3}),
        ("part = 3: must be text", p.reference, at | {"part": 3}),
        ("tolerance = 'x': must be a number", p.solve, {"tolerance": "x"}),
    ]
    for text, function, arguments in calls:
        with pytest.raises(TypeError, match=text):
            function(**arguments)


def test_paths_and_names_stand_for_paints(tmp_path: Path) -> None:
    path = tmp_path / "panel.csv"
    p = paint()
    p.measure("45as15,45as45", wavelengths_nm=np.arange(400, 701, 20.0)).write(path)
    by_path = nacre.fit(path, "tio2-mica-80", COAT, starts=1)
    by_object = nacre.fit(nacre.Measurement.read(path), p, COAT, starts=1)
    assert by_path.parameters == by_object.parameters
    np.testing.assert_array_equal(
        nacre.render("sphere", "tio2-mica-80", spp=1, size=(4, 4)).rgb,
        nacre.render("sphere", p, spp=1, size=(4, 4)).rgb,
    )
    shard = tmp_path / "s1.h5"
    nacre.render("sphere", p, spp=1, size=(4, 4), shard=(1, 1)).write(shard)
    assert nacre.merge(shard).complete
    assert nacre.merge(str(shard)).complete


def test_paths_may_be_bytes(tmp_path: Path) -> None:
    p = paint()
    for name in ("p.toml", "p.three.js"):
        p.write(bytes(tmp_path / name))
        assert (tmp_path / name).is_file()
    assert nacre.Paint(bytes(tmp_path / "p.toml")).sha256 == p.sha256
    reading().write(bytes(tmp_path / "m.csv"))
    assert nacre.Measurement.read(bytes(tmp_path / "m.csv")).geometries == ["45as15"]


def test_pixels_that_are_no_numbers_are_told(tmp_path: Path) -> None:
    picture = nacre.Image(dict.fromkeys("RGB", np.full((4, 4), np.nan, np.float32)), {})
    with pytest.warns(UserWarning, match="100 % of the pixels are not a number"):
        picture.write(tmp_path / "nan.png")
    with pytest.raises(nacre.SettingError, match=r"exposure_stops = 1e\+09: .*in \[-50, 50\]"):
        picture.write(tmp_path / "nan.png", exposure_stops=1e9)
