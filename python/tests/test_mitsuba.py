"""Paints in Mitsuba 3 against Nacre: values, flakes, sampling, scenes."""

from __future__ import annotations

import os
from collections.abc import Iterator, Sequence
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import nacre

pytest.importorskip("mitsuba", reason="Mitsuba is not installed here")

import mitsuba as mi
import nacre.mitsuba as plugin
from mitsuba_backends import BACKENDS
from mitsuba_surfaces import NODES, Array, bsdf, directions, disagreement, interaction, vectors
from nacre.mitsuba import _library, _plugin
from nacre.mitsuba._bands import single
from nacre.mitsuba._cells import BATCH, KEPT
from nacre.mitsuba._flakes import Sparkle
from nacre.mitsuba._patch import Footprint

dr = pytest.importorskip("drjit")


@pytest.fixture(autouse=True, params=BACKENDS)
def backend(request: pytest.FixtureRequest) -> Iterator[str]:
    backend = str(request.param)
    mi.set_variant(f"{backend}_ad_spectral")
    yield backend
    mi.set_variant(f"{backend}_ad_spectral")


WAVY = "effect-pigments/aluminium-corn-flake"
FLAT = {"waviness": 0.001, "orientation.alpha": 0.16}  # flakes that sparkle more than wavy ones


@pytest.mark.parametrize("name", ["red-gold", "ruby", "tinted-grey", "satin-silver", WAVY])
@pytest.mark.parametrize("model", ["nacre", "microflake"])
def test_values_are_those_of_nacre(paints: Path, name: str, model: str) -> None:
    recipe = paints / f"{name}.toml"
    wi, wo = directions(500)
    want = nacre.Paint(recipe).brdf(wi, wo, NODES, model=model, as_rendered=True) * wo[:, 2:]
    si = interaction(wi, NODES)
    value = bsdf(recipe, model=model).eval(mi.BSDFContext(), si, vectors(wo))
    # microflake solves for these wavelengths alone and keeps other terms of the spectral basis.
    assert disagreement(np.array(value).T, want) < (5e-4 if model == "nacre" else 5e-3)


def test_rgb_is_the_integral_over_the_spectrum(paints: Path, backend: str) -> None:
    mi.set_variant(f"{backend}_ad_rgb")
    wi, wo = directions(200)
    nm = np.linspace(400, 700, 31)
    paint = nacre.Paint(paints / "red-gold.toml")
    f = paint.brdf(wi, wo, nm, model="nacre") * wo[:, 2:]
    lit = vectors(wo)
    si = interaction(wi, [])

    def colours(bands: int) -> Array:
        surface = bsdf(paints / "red-gold.toml", bands=bands)
        return np.array(surface.eval(mi.BSDFContext(), si, lit)).T

    fine = colours(31)
    xyz = nacre.xyz(nm, f, observer="2") / 100
    rgb = xyz @ np.linalg.inv(
        [[0.4124564, 0.2126729, 0.0193339], [0.3575761, 0.7151522, 0.1191920],
         [0.1804375, 0.0721750, 0.9503041]]
    )  # fmt: skip
    # Which interpolates between wavelengths in another way.
    assert np.max(np.abs(fine - rgb)) < 5e-3 * np.max(rgb)
    assert np.max(np.abs(colours(16) - fine)) < 1e-2 * np.max(rgb)


def test_scalar_variants_give_the_same_values(paints: Path) -> None:
    mi.set_variant("scalar_spectral")
    surface = bsdf(paints / "ruby.toml")
    wi, wo = directions(4)
    want = nacre.Paint(paints / "ruby.toml").brdf(wi, wo, NODES, model="nacre") * wo[:, 2:]
    for n in range(4):
        si = mi.SurfaceInteraction3f()
        si.wi = mi.Vector3f(*map(float, wi[n]))
        si.wavelengths = mi.UnpolarizedSpectrum(*NODES)
        value = surface.eval(mi.BSDFContext(), si, mi.Vector3f(*map(float, wo[n])))
        assert disagreement(np.array(value), want[n]) < 5e-4


@pytest.mark.parametrize(
    ("name", "side", "contrast"),
    [
        ("ruby", 0.02, 0.3),
        ("tio2-mica-80", 0.5, 0.3),
        ("satin-silver", 0.02, 0.3),
        ("satin-silver", 0.4, 0.04),
        (WAVY, 0.02, 0.3),
        (WAVY, 0.5, 0.04),
    ],
)
def test_flakes_are_those_of_nacre(paints: Path, name: str, side: float, contrast: float) -> None:
    """One by one, and where they stand for others; under a rough coat, and wavy ones."""
    recipe, specimen = paints / f"{name}.toml", 3
    wi, wo = np.array([np.sin(0.3), 0, np.cos(0.3)]), np.array([-np.sin(0.33), 0.02, np.cos(0.33)])
    wo /= np.linalg.norm(wo)
    places = np.random.default_rng(1).uniform(-20, 20, (24, 2))
    model = nacre.Model("nacre", specimen=specimen)
    paint = nacre.Paint(recipe)
    want = np.array([paint.brdf(wi, wo, NODES, model=model, patch=(x, y, side)) for x, y in places])
    assert np.std(want[:, 0]) > contrast * np.mean(want[:, 0])  # it sparkles

    surface = bsdf(recipe, specimen=specimen)
    si = interaction(np.tile(wi, (len(places), 1)), NODES)
    where, smooth = surface.table_bands.at(si), surface.smooth
    flakes = flakes_of(surface, si, places, side)
    pair = smooth.pair(flakes.i, smooth.ray(mi.Vector3f(*map(float, wo)), where, True), where)
    flakes.start()
    got = np.array(smooth.value(pair, flakes, True)).T
    assert disagreement(got, want) < 1e-3


def flakes_of(surface: Any, si: Any, places: Array, side: float) -> Sparkle:
    """Those of squares on a panel."""
    x, y = (mi.Float(single(places[:, n])) for n in range(2))
    patch = Footprint(
        mi.Vector3f(x, y, 0),
        mi.Vector3f(0, 0, 1),
        mi.Vector3f(1, 0, 0),
        mi.Vector3f(side, 0, 0),
        mi.Vector3f(0, side, 0),
    )
    i = surface.smooth.ray(si.wi, surface.table_bands.at(si), True)
    return Sparkle(surface.sparkle, patch, i, True, True)


def test_flakes_are_drawn_by_what_they_share(paints: Path) -> None:
    """So many that they take several rounds."""
    surface, count = bsdf(paints / "metallic-silver.toml"), 1 << 18
    si = interaction(np.tile([0.0, 0.0, 1.0], (count, 1)), NODES)
    (cells,) = flakes_of(surface, si, np.full((count, 2), 3.0), 0.13).cells
    flake, total = cells.draw(mi.PCG32(size=count).next_uint32())
    weight = np.array(cells._weight(flake)) / np.array(total)
    _, first, drawn = np.unique(np.array(flake.place), return_index=True, return_counts=True)
    expected = count * weight[first]
    assert abs(expected.sum() - count) < 20  # few are so small that they are never drawn
    assert len(first) > 2 * BATCH * KEPT
    chi2 = np.sum((drawn - expected) ** 2 / expected)
    assert abs(chi2 - len(first)) < 4 * np.sqrt(2 * len(first))


def test_what_a_value_found_serves_the_sample(
    paints: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Where both are asked by one call, as integrators do, bit by bit the same."""
    scene, count = ball(paints / "ruby.toml", 300.0), 5000
    plugin.attach(scene)
    surface, rng = scene.shapes()[0].bsdf(), mi.PCG32(size=count)
    u = [rng.next_float32() for _ in range(7)]
    pixel = mi.Point2f(0.4 + 0.2 * u[0], 0.4 + 0.2 * u[1])
    ray, _ = scene.sensors()[0].sample_ray(0, 0.5, pixel, mi.Point2f(0.5, 0.5))
    si = scene.ray_intersect(ray)
    near = mi.reflect(si.wi) + 0.2 * mi.Vector3f(u[2] - 0.5, u[3] - 0.5, 0)
    wo = dr.normalize(near)
    random = u[4], mi.Point2f(u[5], u[6])
    dr.eval(si, wo, random)
    asked = mi.BSDFContext(), si

    value, sample = surface.eval_pdf(*asked, wo), surface.sample(*asked, *random)
    dr.eval(value)  # each by a kernel of its own, as integrators have none of all three
    dr.eval(sample)
    apart = (*value, *sample)
    searches = []
    find = type(surface)._flakes

    def counted(*given: Any) -> Any:
        searches.append(given)
        return find(*given)

    monkeypatch.setattr(type(surface), "_flakes", counted)
    together = si.bsdf().eval_pdf_sample(*asked, wo, *random)
    dr.eval(together)
    once = len(searches)
    monkeypatch.setattr(_plugin, "_name_of", lambda *_: None)
    si.bsdf().eval_pdf_sample(*asked, wo, *random)
    assert len(searches) == once + 2 * once
    for a, b in zip(apart, together, strict=True):
        for x, y in ((a.wo, b.wo), (a.pdf, b.pdf)) if hasattr(a, "wo") else ((a, b),):
            assert np.count_nonzero(np.array(x)) > 0.9 * count
            np.testing.assert_array_equal(np.array(x), np.array(y))


def ball(paint: Path | nacre.Paint, distance: float, **settings: Any) -> Any:
    settings |= (
        {"toml": paint.to_toml()} if isinstance(paint, nacre.Paint) else {"recipe": str(paint)}
    )
    return mi.load_dict(
        {
            "type": "scene",
            "integrator": {"type": "path", "max_depth": 3},
            "sensor": {
                "type": "perspective",
                "fov": 12,
                "to_world": mi.ScalarTransform4f().look_at(
                    [0, -distance, 0], [0, 0, 0], [0, 0, 1]
                ),
                "film": {"type": "hdrfilm", "width": 32, "height": 32, "rfilter": {"type": "box"}},
                "sampler": {"type": "independent", "sample_count": 64},
            },
            "ball": {"type": "sphere", "radius": 50.0, "bsdf": {"type": "nacre", **settings}},
            "sky": {"type": "constant", "radiance": {"type": "uniform", "value": 1.0}},
        }
    )  # fmt: skip


def test_scalar_variants_draw_the_same_flakes(paints: Path) -> None:
    def drawn(x: Any, y: Any, z: Any) -> Array:
        """A sample of a single flake, its density and weight, where a camera sees a ball."""
        scene = ball(paints / "ruby.toml", 900, footprint=0.01)
        plugin.attach(scene)
        (surface,) = (shape.bsdf() for shape in scene.shapes())
        ray = mi.Ray3f(mi.Point3f(0, -900, 0), dr.normalize(mi.Vector3f(x, y + 900, z)))
        ray.wavelengths = mi.UnpolarizedSpectrum(*NODES)
        si = scene.ray_intersect(ray)
        sample, weight = surface.sample(
            mi.BSDFContext(), si, mi.Float(0.93), mi.Point2f(0.3, 0.6), True
        )
        numbers = [*sample.wo, sample.pdf, *weight]
        dr.eval(numbers)
        return np.array([np.array(n).ravel() for n in numbers]).T

    x, z = np.random.default_rng(5).uniform(-20, 20, (2, 6))
    places = np.stack([x, -np.sqrt(50**2 - x * x - z * z), z])
    compiled = drawn(*(mi.Float(single(p)) for p in places))
    assert np.std(compiled[:, 3]) > 0.3 * np.mean(compiled[:, 3])  # they are not one lobe's
    mi.set_variant("scalar_spectral")
    scalar = np.concatenate([drawn(*map(float, place)) for place in places.T])
    assert disagreement(scalar, compiled) < 1e-3


def test_both_sides_of_a_wrapped_paint_show_its_flakes_and_instances_too(paints: Path) -> None:
    paint = {"type": "nacre", "recipe": str(paints / "red-gold.toml")}
    places = np.random.default_rng(4).uniform(-0.5, 0.5, (2, 12))

    def seen(panel: dict[str, Any], side: float, instanced: Sequence[Any] = ()) -> Array:
        """Values where a camera sees a panel, which mirrors a little beside it."""
        look_at = mi.ScalarTransform4f().look_at
        scene = mi.load_dict(
            {
                "type": "scene",
                "sensor": {
                    "type": "perspective",
                    "fov": 10,
                    "to_world": look_at([0, -30, 100 * side], [0, 0, 0], [1, 0, 0]),
                    "film": {"type": "hdrfilm", "width": 32, "height": 32},
                },
            }
            | panel
        )
        plugin.attach(scene, instanced=instanced)
        x, y = (mi.Float(single(p)) for p in places)
        ray = mi.Ray3f(
            mi.Point3f(0, -30, 100 * side), dr.normalize(mi.Vector3f(x, y + 30, -100 * side))
        )
        ray.wavelengths = mi.UnpolarizedSpectrum(*NODES)
        si = scene.ray_intersect(ray)
        mirrored = dr.normalize(mi.Vector3f(0, 0.37, side))
        value = si.bsdf().eval(mi.BSDFContext(), si, si.to_local(mirrored), True)
        return np.array(value).T

    def panel(bsdf: Any) -> dict[str, Any]:
        return {"panel": {"type": "rectangle", "bsdf": bsdf}}

    front = seen(panel(paint), 1)
    assert np.std(front[:, 3]) > 0.3 * np.mean(front[:, 3])  # it sparkles
    assert disagreement(seen(panel({"type": "twosided", "nested": paint}), -1), front) < 1e-3
    bsdf = mi.load_dict(paint)
    instances = {
        "group": {"type": "shapegroup", **panel(bsdf)},
        "instance": {"type": "instance", "group": {"type": "ref", "id": "group"}},
    }
    with pytest.raises(nacre.SettingError, match="as instanced"):
        seen(instances, 1)
    assert disagreement(seen(instances, 1, [bsdf]), front) < 1e-3


@pytest.mark.parametrize(
    ("name", "shown", "angle"),
    [
        ("metallic-silver", False, 0.2),
        ("metallic-silver", False, 1.1),
        ("metallic-silver", True, 0.2),
        ("metallic-silver", True, 1.1),
        ("satin-silver", True, 0.2),
        (WAVY, True, 1.1),
    ],
)
def test_samples_follow_their_density(paints: Path, name: str, shown: bool, angle: float) -> None:
    """By Mitsuba's own chi-square test; with single flakes at one place of a ball."""
    scene = ball(paints / f"{name}.toml", 200.0)
    surface = scene.shapes()[0].bsdf()
    if shown:
        plugin.attach(scene)
    n = np.array([np.sin(angle), -np.cos(angle), 0])  # as the camera sees it
    p = 50 * n
    to_camera = np.array([0, -200, 0]) - p
    to_camera /= np.linalg.norm(to_camera)

    def seen(count: int) -> Any:
        si = dr.zeros(mi.SurfaceInteraction3f, count)
        si.p = mi.Point3f(*map(float, p))
        si.sh_frame = mi.Frame3f(mi.Vector3f(*map(float, n)))
        si.wi = si.to_local(mi.Vector3f(*map(float, to_camera)))
        si.wavelengths = mi.UnpolarizedSpectrum(*NODES)
        return si

    context = mi.BSDFContext()
    context.component = 1  # all but the specular reflection

    def sample(u: Any) -> Any:
        bs, _ = surface.sample(context, seen(dr.width(u)), u[2], mi.Point2f(u[0], u[1]))
        return bs.wo, dr.select(bs.pdf > 0, 1.0, 0.0)

    def pdf(wo: Any) -> Any:
        return surface.pdf(context, seen(dr.width(wo)), wo)

    from mitsuba.chi2 import ChiSquareTest, SphericalDomain

    # Of 16 by 16 points in each cell the expected counts are those of 64 by 64 to a ninth of their
    # noise in the worst cell, and chi-square to 0.1 of a standard deviation of 35.
    test = ChiSquareTest(
        SphericalDomain(), sample, pdf, sample_dim=3, sample_count=200_000, res=51, ires=16
    )
    assert test.run(0.01, test_count=4), test.messages


def test_a_paint_blended_with_itself_is_the_same(paints: Path) -> None:
    """blendbsdf asks each of both for the value of what the other one drew, also where it drew
    nothing. Of a smooth interface it gets the share of its mirror direction wrong by itself."""
    paint = {"type": "nacre", "recipe": str(paints / "satin-silver.toml")}
    blend = {"type": "blendbsdf", "weight": 0.5, "a": paint, "b": paint}
    count, context = 100_000, mi.BSDFContext()
    si = interaction(np.tile([np.sin(0.5), 0, np.cos(0.5)], (count, 1)), NODES)
    u = mi.PCG32(size=count)
    draws = [u.next_float32() for _ in range(3)]
    drawn = draws[0], mi.Point2f(draws[1], draws[2])
    sample, weight = mi.load_dict(paint).sample(context, si, *drawn)
    failed = np.array(sample.pdf) == 0
    assert 0 < np.mean(failed) < 0.5
    assert np.all(np.array(sample.wo)[2][failed] < 0)
    assert np.all(np.array(weight)[:, failed] == 0)
    of_both = np.array(mi.load_dict(blend).sample(context, si, *drawn)[1])
    of_one = np.array(weight)
    error = np.hypot(of_one.std(axis=1), of_both.std(axis=1)) / np.sqrt(count)
    assert np.all(np.abs(of_both.mean(axis=1) - of_one.mean(axis=1)) < 4 * error)


@pytest.mark.parametrize("shown", [False, True], ids=["mean", "flakes"])
def test_weights_add_up_to_the_albedo(paints: Path, shown: bool) -> None:
    """A ball in an even sky of radiance 1 shows the directional albedo."""
    scene = ball(paints / "ruby.toml", 2000.0)  # far away: each pixel has thousands of flakes
    if shown:
        plugin.attach(scene)
    surface = scene.shapes()[0].bsdf()
    count, angle = 100_000, 0.5
    n = np.array([np.sin(angle), -np.cos(angle), 0])
    rng = np.random.default_rng(3)
    si = dr.zeros(mi.SurfaceInteraction3f, count)
    # Over a spot of 2 mm, so that flakes average out.
    at = 50 * n[:, None] + 2 * rng.uniform(-1, 1, (3, count)) * np.array([[0], [0], [1]])
    si.p = mi.Point3f(vectors(at.T))
    si.sh_frame = mi.Frame3f(mi.Vector3f(*map(float, n)))
    towards = mi.Vector3f(0, -2000, 0) - si.p
    si.wi = si.to_local(dr.normalize(towards))
    si.wavelengths = mi.UnpolarizedSpectrum(*NODES)
    u = mi.PCG32(size=count)
    draws = [u.next_float32() for _ in range(3)]
    _, weight = surface.sample(mi.BSDFContext(), si, draws[0], mi.Point2f(draws[1], draws[2]))
    w = np.array(weight).T
    albedo = nacre.Paint(paints / "ruby.toml").albedo(
        [[np.sin(angle), 0, np.cos(angle)]], NODES, model="nacre"
    )[0]
    error = w.std(axis=0) / np.sqrt(count)
    assert np.all(np.abs(w.mean(axis=0) - albedo) < 4 * error + 5e-3 * albedo)
    assert np.all(w.mean(axis=0) < 1)


@pytest.mark.parametrize(("name", "grainier"), [("metallic-silver", 1.5), ("satin-silver", 1.2)])
def test_pictures_with_and_without_flakes_have_one_mean(
    paints: Path, name: str, grainier: float
) -> None:
    scene = ball(nacre.Paint(paints / f"{name}.toml").with_values(FLAT), 90.0)
    mean = np.array(mi.render(scene, spp=64, seed=1))
    plugin.attach(scene)
    flakes = np.array(mi.render(scene, spp=64, seed=2))
    middle = np.s_[8:24, 8:24]
    a, b = mean[middle].reshape(-1, 3), flakes[middle].reshape(-1, 3)
    error = np.hypot(a.std(axis=0), b.std(axis=0)) / np.sqrt(len(a))
    assert np.all(np.abs(a.mean(axis=0) - b.mean(axis=0)) < 4 * error)
    assert b.std() > grainier * a.std()


@pytest.mark.parametrize("size", [1, 7, 16, 1000])
def test_kernels_do_not_depend_on_where_tables_lie(size: int) -> None:
    """Which they would by the alignment of memory, and every process would compile its own."""
    values = np.random.default_rng(size).uniform(-1, 1, (size, 3))
    kept = [single(values[:, ::2]) for _ in range(20)]
    for table in kept:
        assert table.ctypes.data % 64 == 0
        assert table.dtype == np.float32
        assert table.flags.c_contiguous
        np.testing.assert_array_equal(table, values[:, ::2].astype(np.float32))


def test_scenes_in_xml_find_the_recipe_beside_them(paints: Path, tmp_path: Path) -> None:
    (tmp_path / "ruby.toml").write_bytes((paints / "ruby.toml").read_bytes())
    (tmp_path / "scene.xml").write_text(
        """<scene version="3.0.0">
             <bsdf type="nacre" id="paint">
               <string name="recipe" value="ruby.toml"/>
               <string name="model" value="nacre"/>
               <integer name="specimen" value="1"/>
             </bsdf>
             <shape type="sphere"><ref id="paint"/></shape>
           </scene>"""
    )
    surface = mi.load_file(str(tmp_path / "scene.xml")).shapes()[0].bsdf()
    assert surface.model == nacre.Model("nacre", specimen=1, hot_spot=True)
    wi, wo = directions(20)
    si = interaction(wi, NODES)
    value = np.array(surface.eval(mi.BSDFContext(), si, vectors(wo)))
    same = bsdf(paints / "ruby.toml", specimen=1).eval(mi.BSDFContext(), si, vectors(wo))
    assert np.max(value) > 0
    np.testing.assert_array_equal(value, np.array(same))


def test_wrong_settings_are_named(paints: Path, tmp_path: Path) -> None:
    recipe = str(paints / "ruby.toml")
    wavy = tmp_path / "wavy.toml"
    mottled = tmp_path / "mottled.toml"
    text = (paints / "ruby.toml").read_text()
    wavy.write_text(text.replace("[clearcoat]", "[clearcoat]\norange_peel = { wd = 0.002 }"))
    leaning = tmp_path / "leaning.toml"
    leaning.write_text("lean = { tilt_deg = 4 }\n" + text)
    tint = "[clearcoat]\nthickness_spread_um = 3\nabsorption_per_mm = 5"
    mottled.write_text(text.replace("[clearcoat]", tint))
    for settings, text in (
        ({}, "recipe: is missing"),
        ({"recipe": recipe, "model": "thin-film"}, "model = thin-film"),
        ({"recipe": recipe, "footprint": -1.0}, "footprint"),
        ({"recipe": "no-such-file.toml"}, "no-such-file.toml"),
        ({"recipe": str(wavy)}, "orange_peel"),
        ({"recipe": str(leaning)}, "lean.tilt_deg = 4"),
        ({"recipe": str(mottled)}, "thickness_spread_um"),
        ({"recipe": recipe, "specimen": -1}, "specimen = -1: must be a whole number"),
        ({"recipe": recipe, "specimen": 1.7}, "specimen = 1.7: must be a whole number"),
        ({"recipe": recipe, "hot_spot": "no"}, "hot_spot = no: must be true or false"),
        ({"recipe": recipe, "bands": 2.5}, "bands = 2.5: must be a whole number"),
        ({"recipe": recipe, "to_rest": 3}, "to_rest = 3: must be a transformation"),
    ):
        with pytest.raises(Exception, match=text):
            mi.load_dict({"type": "nacre", **settings})
    scene = mi.load_dict({"type": "scene", "ball": {"type": "sphere"}})
    with pytest.raises(nacre.SettingError, match="no shape has"):
        plugin.attach(scene, sensor=None)


@pytest.mark.parametrize("kind", ["sphere", "cylinder", "disk"])
def test_one_paint_lies_still_in_one_place(paints: Path, kind: str) -> None:
    t = mi.ScalarTransform4f()
    turned, moved = t.rotate([0, 1, 0], 30), t.translate([3, 0, 0])

    def attach(first: Any, second: Any, **settings: Any) -> None:
        paint = mi.load_dict({"type": "nacre", "recipe": str(paints / "ruby.toml"), **settings})
        shapes = {
            name: {"type": kind, "to_world": to_world, "bsdf": paint}
            for name, to_world in (("first", first), ("second", second))
        }
        plugin.attach(mi.load_dict({"type": "scene", "camera": {"type": "perspective"}, **shapes}))

    for other in (turned, moved):
        with pytest.raises(nacre.SettingError, match="several shapes that were moved differently"):
            attach(t, other)
        attach(t, other, to_rest=t)
        attach(other, other.scale(2))


@pytest.mark.parametrize("variant", ["llvm_ad_mono", "scalar_spectral_polarized"])
def test_variants_without_paints_are_named(paints: Path, variant: str) -> None:
    mi.set_variant(variant)
    with pytest.raises(Exception, match=f"variant {variant}: has no paints"):
        mi.load_dict({"type": "nacre", "recipe": str(paints / "ruby.toml")})


def test_llvm_is_chosen_before_it_aborts(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    assert _library.version_of("/usr/lib/libLLVM.so.19.1") == 19
    assert _library.version_of("libLLVM-15.so.1") == 15
    assert _library.version_of("libm.so.6") is None
    old = os.environ.get(_library.ENVIRONMENT)
    monkeypatch.delenv(_library.ENVIRONMENT, raising=False)
    (tmp_path / "libLLVM-15.so.1").touch()
    with pytest.raises(nacre.Error, match="install LLVM 19"):
        _library.choose_llvm([str(tmp_path)])
    (tmp_path / "libLLVM.so.19.1").touch()
    _library.choose_llvm([str(tmp_path)])
    assert os.environ[_library.ENVIRONMENT].endswith("libLLVM.so.19.1")
    monkeypatch.setenv(_library.ENVIRONMENT, str(tmp_path / "libLLVM-15.so.1"))
    with pytest.raises(nacre.Error, match="aborts with LLVM 15"):
        _library.choose_llvm([str(tmp_path)])
    if old is not None:
        monkeypatch.setenv(_library.ENVIRONMENT, old)
