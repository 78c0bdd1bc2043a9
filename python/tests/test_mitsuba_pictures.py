"""Pictures of Mitsuba 3 against pictures of Nacre, and against what energy demands.

Both see the same shapes, lights and bands of wavelengths. The lights have the same radiance at all
wavelengths, so that no illuminant's scale comes between the two.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

import nacre

pytest.importorskip("mitsuba", reason="Mitsuba is not installed here")

import mitsuba as mi
import nacre.mitsuba as plugin
from mitsuba_backends import BACKENDS

Array = NDArray[np.float64]

PIXELS = 32
BLOCK = 8  # side of a region
BANDS = 6
WIDTH_NM = 300 / BANDS
CENTRES_NM = 400 + WIDTH_NM * (np.arange(BANDS) + 0.5)
SEEDS = 24

LOSSLESS = """
name = "Flakes that lose nothing, over white"
ior = 1.5

[clearcoat]
thickness_um = 20

[[layer]]
thickness_um = 10

[[layer.flakes]]
area_density_per_um = 0.1
diameter_um = 20
orientation = { distribution = "beckmann", alpha = 0.15 }
reflectance = 0.6
transmittance = 0.4

[substrate]
reflectance = 1.0
"""


@pytest.fixture(autouse=True, params=BACKENDS)
def _backend(request: pytest.FixtureRequest) -> None:
    mi.set_variant(f"{request.param}_ad_spectral")


@dataclass(frozen=True)
class Part:
    """Of a scene: tables of Nacre's file, and objects of Mitsuba's by their names."""

    toml: str
    mitsuba: dict[str, Any]


@dataclass(frozen=True)
class Camera:
    position_mm: tuple[float, float, float] = (0.0, -300.0, 150.0)
    up: tuple[float, float, float] = (0.0, 0.0, 1.0)
    fov_deg: float = 22.0

    def toml(self) -> str:
        return (
            f"[camera]\nposition_mm = {list(self.position_mm)}\ntarget_mm = [0, 0, 0]\n"
            f"up = {list(self.up)}\nvertical_fov_deg = {self.fov_deg}\n"
        )

    def mitsuba(self, film: dict[str, Any], spp: int) -> dict[str, Any]:
        at = mi.ScalarTransform4f().look_at(list(self.position_mm), [0, 0, 0], list(self.up))
        return {
            "type": "perspective",
            "fov": self.fov_deg,
            "fov_axis": "y",
            "to_world": at,
            "film": {"width": PIXELS, "height": PIXELS, "rfilter": {"type": "tent"}, **film},
            "sampler": {"type": "independent", "sample_count": spp},
        }


def sky(radiance: float) -> Part:
    return Part(
        f'[environment]\ntype = "constant"\nilluminant = "E"\nscale = {radiance}\n',
        {"sky": {"type": "constant", "radiance": {"type": "uniform", "value": radiance}}},
    )


def lamp(place_mm: tuple[float, float, float], side_mm: float, radiance: float) -> Part:
    at = mi.ScalarTransform4f().look_at(list(place_mm), [0, 0, 0], [0, 1, 0]).scale(side_mm / 2)
    emitter = {"type": "area", "radiance": {"type": "uniform", "value": radiance}}
    return Part(
        f'[[lights]]\ntype = "rectangle"\ncenter_mm = {list(place_mm)}\nwidth_mm = {side_mm}\n'
        f'height_mm = {side_mm}\nilluminant = "E"\nscale = {radiance}\n',
        {"lamp": {"type": "rectangle", "to_world": at, "emitter": emitter}},
    )


def sphere() -> Part:
    ball = {"type": "sphere", "radius": 50.0}
    return Part('[[shapes]]\ntype = "sphere"\nradius_mm = 50\nmaterial = "p"\n', {"shape": ball})


def panel(side_mm: float) -> Part:
    square = {
        "type": "rectangle",
        "to_world": mi.ScalarTransform4f().scale([side_mm / 2, side_mm / 2, 1]),
    }
    return Part(
        f'[[shapes]]\ntype = "flat-panel"\nwidth_mm = {side_mm}\nheight_mm = {side_mm}\n'
        'material = "p"\n',
        {"shape": square},
    )


def dune(folder: Path) -> Part:
    """A wavy square of 100 mm with the normals of the waves, as a Wavefront file."""
    n = 24
    x, y = np.meshgrid(np.linspace(-50, 50, n), np.linspace(-50, 50, n))
    z = 6 * np.sin(x / 12) * np.cos(y / 15)
    slope_x = 6 / 12 * np.cos(x / 12) * np.cos(y / 15)
    slope_y = -6 / 15 * np.sin(x / 12) * np.sin(y / 15)
    lines = [f"v {a:.6f} {b:.6f} {c:.6f}" for a, b, c in zip(x.flat, y.flat, z.flat, strict=True)]
    lines += [f"vn {-a:.6f} {-b:.6f} 1" for a, b in zip(slope_x.flat, slope_y.flat, strict=True)]
    for row in range(n - 1):
        for a in range(row * n + 1, row * n + n):
            for corners in ((a, a + 1, a + n + 1), (a, a + n + 1, a + n)):
                lines.append("f " + " ".join(f"{i}//{i}" for i in corners))
    file = folder / "dune.obj"
    file.write_text("\n".join(lines) + "\n", encoding="utf-8")
    return Part(
        '[[shapes]]\ntype = "mesh"\npath = "dune.obj"\nmaterial = "p"\n',
        {"shape": {"type": "obj", "filename": str(file)}},
    )


def in_nacre(file: Path, camera: Camera, *parts: Part, specimen: int = 0) -> Path:
    head = f"specimen = {specimen}\n{camera.toml()}[materials.p]\ntype = 'paint'\n"
    file.write_text(head + "".join(part.toml for part in parts), encoding="utf-8")
    return file


def in_mitsuba(paint: nacre.Paint, sensor: dict[str, Any], *parts: Part, **settings: Any) -> Any:
    scene: dict[str, Any] = {
        "type": "scene",
        "integrator": {"type": "path", "max_depth": 3},
        "sensor": sensor,
    }
    for part in parts:
        scene |= part.mitsuba
    scene["shape"]["bsdf"] = {"type": "nacre", "toml": paint.to_toml(), **settings}
    return mi.load_dict(scene)


def hat_at(band: int) -> tuple[list[float], list[float]]:
    """Wavelengths and weights of one of Nacre's bins: 1 at its centre, falling to 0 at those of its
    neighbours, and level beyond the outermost."""
    first, last = band == 0, band == BANDS - 1
    nm = CENTRES_NM[band]
    return (
        [400.0 if first else nm - WIDTH_NM, nm, 700.0 if last else nm + WIDTH_NM],
        [float(first), 1.0, float(last)],
    )


def film() -> dict[str, Any]:
    """Mitsuba's, with Nacre's bins."""
    bands: dict[str, Any] = {"type": "specfilm"}
    for n in range(BANDS):
        nm, weight = (", ".join(map(str, row)) for row in hat_at(n))
        bands[f"band{n}"] = {"type": "irregular", "wavelengths": nm, "values": weight}
    return bands


def spectral(scene: Any, spp: int) -> Callable[[int], Array]:
    """Mitsuba's pictures by their seeds, (H, W, BANDS)."""
    # Its bands are integrals, each of which is WIDTH_NM under radiance 1.
    return lambda seed: np.array(mi.render(scene, spp=spp, seed=seed)) / WIDTH_NM


def picture(scene: Path, paint: nacre.Paint, spp: int, seed: int, model: str) -> nacre.Picture:
    return nacre.render(
        scene,
        paint,
        spp=spp,
        size=(PIXELS, PIXELS),
        model=model,
        seed=seed,
        depth=2,
        noise=False,
        spectral_bins=BANDS,
    )


def bins(seen: nacre.Picture) -> Array:
    assert seen.spectral is not None
    return seen.spectral.astype(np.float64)


def estimate(render: Callable[[int], Array]) -> tuple[Array, Array]:
    """Means by region and band, and their standard errors, from pictures by independent seeds."""
    n = PIXELS // BLOCK
    each = np.array(
        [
            render(seed).reshape(n, BLOCK, n, BLOCK, -1).mean(axis=(1, 3)).reshape(n * n, -1)
            for seed in range(1, SEEDS + 1)
        ]
    )
    return each.mean(axis=0), each.std(axis=0, ddof=1) / np.sqrt(SEEDS)


def assert_equal(got: Array, want: Array, error: Array) -> None:
    """Estimates by region and band, within their standard errors.

    Those are estimates themselves, so that z follows Student's law: of 100 values one is beyond 3
    by chance every other time, more than three hardly ever. A bias of one error shows in the mean
    square.
    """
    assert np.median(error / want) < 3e-3  # or this could not tell
    z = (got - want) / error
    assert np.sum(np.abs(z) > 3) <= 0.03 * z.size, z
    assert np.max(np.abs(z)) < 5, z
    assert np.sqrt(np.mean(z**2)) < 1.35, z


@pytest.mark.parametrize(
    ("name", "recipe"), [("sphere", "red-gold"), ("mesh", "ruby"), ("panel", "satin-silver")]
)
def test_means_are_those_of_nacre(name: str, recipe: str, paints: Path, tmp_path: Path) -> None:
    """By region and wavelength, under a lamp and an even sky."""
    paint = nacre.Paint(paints / f"{recipe}.toml")
    shapes = {"sphere": sphere(), "mesh": dune(tmp_path), "panel": panel(80)}
    parts = [shapes[name], sky(0.5), lamp((-200, -100, 300), 120, 20)]
    scene = in_nacre(tmp_path / "scene.toml", Camera(), *parts)
    want, want_error = estimate(lambda seed: bins(picture(scene, paint, 32, seed, "microflake")))
    assert want.max() > 1.2 * want.min()  # there is something to see
    loaded = in_mitsuba(paint, Camera().mitsuba(film(), 32), *parts, model="microflake")
    got, got_error = estimate(spectral(loaded, 32))
    assert_equal(got, want, np.hypot(want_error, got_error))


def test_an_environment_lies_as_in_nacre(paints: Path, tmp_path: Path) -> None:
    """A grey sky with a bright spot, as an EXR file that both read.

    Of grey the two make light of other spectra and one colour: the paint is nearly grey as well,
    and the luminance is compared.
    """
    width, height = 256, 128
    azimuth = 2 * np.pi * (0.5 - (np.arange(width) + 0.5) / width)
    row = np.arange(height)
    # Mitsuba's first and last rows are the poles, Nacre's lie half a row from them.
    for name, polar in (("nacre", (row + 0.5) / height), ("mitsuba", row / (height - 1))):
        theta, phi = np.meshgrid(180 * polar, np.degrees(azimuth), indexing="ij")
        towards = nacre.direction(theta, phi)
        spot = np.exp(12 * (towards @ nacre.direction(50, 200) - 1))
        level = (0.3 + 0.2 * towards[..., 2] + 4 * spot).astype(np.float32)
        nacre.Image(dict.fromkeys("RGB", level), {}).write(tmp_path / f"{name}.exr")
    # The middle of the picture: Nacre's at this azimuth, Mitsuba's towards +z; Mitsuba's up is +y.
    turned = mi.ScalarTransform4f([[0, 0, 1, 0], [1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 0, 1]])
    outside = Part(
        '[environment]\ntype = "image"\npath = "nacre.exr"\nazimuth_deg = 0\n',
        {
            "sky": {
                "type": "envmap",
                "filename": str(tmp_path / "mitsuba.exr"),
                "to_world": turned,
            }
        },
    )
    paint = nacre.Paint(paints / "satin-silver.toml")
    scene = in_nacre(tmp_path / "scene.toml", Camera(), sphere(), outside)
    luminance = np.array([0.2126, 0.7152, 0.0722])
    want, want_error = estimate(
        lambda seed: picture(scene, paint, 32, seed, "microflake").rgb @ luminance
    )
    sensor = Camera().mitsuba({"type": "hdrfilm", "pixel_format": "luminance"}, 32)
    loaded = in_mitsuba(paint, sensor, sphere(), outside, model="microflake")
    got, got_error = estimate(lambda seed: np.array(mi.render(loaded, spp=32, seed=seed)))
    assert_equal(got, want, np.hypot(want_error, got_error))


@pytest.mark.parametrize(
    ("light", "scale"), [({"type": "d65"}, 0.9999), ({"type": "uniform", "value": 1.0}, 1.001)]
)
def test_white_is_as_bright_as_in_nacre(light: dict[str, Any], scale: float) -> None:
    """To a thousandth: Mitsuba's scales of D65, of the eye's sensitivity and of XYZ are rounded."""
    sensor = Camera().mitsuba({"type": "hdrfilm", "pixel_format": "luminance"}, 64)
    seen = {"type": "scene", "sensor": sensor, "sky": {"type": "constant", "radiance": light}}
    values = np.array(mi.render(mi.load_dict(seen | {"integrator": {"type": "path"}}), spp=256))
    error = values.std() / np.sqrt(values.size)
    assert error < 1e-4
    assert values.mean() == pytest.approx(scale, abs=1e-4 + 4 * error)


@pytest.mark.parametrize("shown", [False, True], ids=["mean", "flakes"])
def test_white_furnace(shown: bool) -> None:
    """A ball that loses no light cannot be seen where the same light comes from everywhere."""
    paint = nacre.Paint.from_toml(LOSSLESS)
    scene = in_mitsuba(paint, Camera().mitsuba(film(), 32), sphere(), sky(1))
    if shown:
        plugin.attach(scene)
    got, error = estimate(spectral(scene, 32))
    assert_equal(got, np.ones_like(got), error)


def test_a_furnace_shows_the_albedo(paints: Path) -> None:
    """A panel that loses some light, at one angle."""
    seen_from = nacre.direction(50)
    camera = Camera(position_mm=tuple(2000 * seen_from), fov_deg=1)
    paint = nacre.Paint(paints / "red-gold.toml")
    got, error = estimate(
        spectral(in_mitsuba(paint, camera.mitsuba(film(), 32), panel(200), sky(1)), 32)
    )
    # The integral of the BRDF: Paint.albedo() is a table that is right to 5e-3.
    node, weight = np.polynomial.legendre.leggauss(200)  # in the square of the cosine
    mu, phi = np.meshgrid(np.sqrt((node + 1) / 2), np.arange(0.5, 360), indexing="ij")
    wo = nacre.direction(np.degrees(np.arccos(mu)), phi)
    brdf = paint.brdf(seen_from, wo, nacre.WAVELENGTHS_NM, model="nacre", as_rendered=True)
    albedo = np.pi / 2 * weight @ brdf.mean(axis=1)
    albedo += nacre.film([], substrate=1.5, angles_deg=50).R  # at the clearcoat's surface
    fine = np.linspace(400, 700, 601)
    hats = np.array([np.interp(fine, *hat_at(n), left=0, right=0) for n in range(BANDS)])
    want = hats @ np.interp(fine, nacre.WAVELENGTHS_NM, albedo) / hats.sum(axis=1)
    mean, mean_error = got.mean(axis=0), np.sqrt(np.mean(error**2, axis=0) / len(error))
    assert np.all(mean_error < 2e-3 * want)
    assert np.all(np.abs(mean - want) < 4 * mean_error + 5e-4 * want)


def test_flakes_lie_and_sparkle_as_in_nacre(paints: Path, tmp_path: Path) -> None:
    """1.3 mm of a panel, pixel by pixel: how far pictures agree that have no noise.

    The products of pictures by different seeds are free of their noise. Mitsuba takes more samples,
    as the few that find a flake make its noise: four pictures of 256 samples differ from other four
    by 1.6 % (standard deviation of eight such sets), those of 2048 by less than 1 %.
    """
    seeds = 4
    camera = Camera(position_mm=(0, 0, 300), up=(0, 1, 0), fov_deg=0.25)
    parts = [panel(100), lamp((0, -212, 566), 84, 20)]
    flat = {
        "waviness": 0.001,
        "orientation.alpha": 0.16,
    }  # sparkles more than the wavy ones shipped
    paint = nacre.Paint(paints / "metallic-silver.toml").with_values(flat)
    scene = in_nacre(tmp_path / "scene.toml", camera, *parts, specimen=2)
    loaded = in_mitsuba(paint, camera.mitsuba(film(), 256), *parts, specimen=2)
    plugin.attach(loaded)

    def contrasts(render: Callable[[int], Array]) -> Array:
        """(seeds, pixels): without the rim, beyond which Mitsuba's film does not draw."""
        each = np.array([render(seed)[1:-1, 1:-1].mean(axis=-1) for seed in range(1, seeds + 1)])
        relative: Array = each.reshape(seeds, -1) / each.mean() - 1
        return relative

    def squared(each: Array) -> float:
        products = each @ each.T / each.shape[1]
        return float((products.sum() - np.trace(products)) / (seeds * (seeds - 1)))

    a = contrasts(lambda seed: bins(picture(scene, paint, 1024, seed, "nacre")))
    b = contrasts(spectral(loaded, 2048))
    want, got = squared(a), squared(b)
    assert want > 1  # it sparkles
    assert np.sqrt(got / want) == pytest.approx(1, abs=0.03)
    assert np.mean(a @ b.T) / a.shape[1] > 0.98 * np.sqrt(want * got)


@pytest.mark.parametrize("kind", ["rectangle", "sphere"])
def test_flakes_move_with_their_shape(kind: str, paints: Path) -> None:
    """Camera and lamp go along: the picture stays, but for the rounding of places."""
    t = mi.ScalarTransform4f()
    shapes = {
        "rectangle": {"type": "rectangle", "to_world": t.scale(20)},
        "sphere": {"type": "sphere", "radius": 50.0, "to_world": t.translate([0, 0, -50])},
    }
    red_gold = nacre.Paint(paints / "red-gold.toml")
    eye, light = Camera((0, 0, 300), (0, 1, 0), 0.3), lamp((0, -212, 566), 84, 20)

    def at(move: Any) -> Array:
        def moved(part: dict[str, Any]) -> dict[str, Any]:
            return {**part, "to_world": move @ part["to_world"]}

        shape = Part("", {"shape": moved(shapes[kind])})
        lamps = Part("", {"lamp": moved(light.mitsuba["lamp"])})
        sensor = moved(eye.mitsuba(film(), 64))
        scene = in_mitsuba(red_gold, sensor, shape, lamps, specimen=2)
        plugin.attach(scene)
        mean: Array = spectral(scene, 64)(1).mean(axis=-1)
        return mean

    here = at(t)
    assert here.std() > here.mean()  # it sparkles
    for move in (t.translate([7, 0, 0]), t.translate([3, -9, 20]).rotate([1, 0, 0], 90)):
        there = at(move)
        assert np.corrcoef(here.ravel(), there.ravel())[0, 1] > 0.99
        assert there.std() / there.mean() == pytest.approx(here.std() / here.mean(), rel=0.02)
