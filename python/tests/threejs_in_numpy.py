"""The shader of three.js in numpy, from the arrays that Nacre hands to other renderers: what
src/nacre/exchange makes of a paint is held against it."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Any

import numpy as np
from nacre._arrays import Floats
from numpy.typing import NDArray

from nacre import _rgb

BANDS = 16  # four texels of four
ROWS = 257
NODES, WEIGHTS = (0.5 * x for x in np.polynomial.legendre.leggauss(10))
NODES += 0.5
DEPTHS = NODES**2  # over a layer's depth, densest at the top: u = s^2, du = 2 s ds
DEPTH_WEIGHTS = 2 * NODES * WEIGHTS
FARTHEST = 24.0  # optical depths, beyond which 6e-6 of the light comes from


def film_weights(nm: Floats) -> Floats:
    """As _rgb.weights(), (3, bands), but the perfect diffuser is exactly white, as in pictures."""
    white = np.linalg.inv(_rgb.XYZ_TO_SRGB).sum(axis=1)
    xyz = np.linalg.inv(_rgb.XYZ_TO_SRGB) @ _rgb.weights(nm)
    return np.asarray(_rgb.XYZ_TO_SRGB @ (xyz * (white / xyz.sum(axis=1))[:, None]))


@dataclass
class Flake:
    half_density_per_um: float
    alpha: float
    channel: int
    """of the table: reflectance by the cosine on the flake"""


@dataclass
class Pigment:
    g: float
    scattering_per_um: Floats
    """(BANDS,)"""
    channel: int | None
    """phase function by the angle; None: Henyey and Greenstein's of g"""


@dataclass
class Layer:
    thickness_um: float
    channel: int
    """extinction by tan(theta / 2)"""
    flakes: list[Flake] = field(default_factory=list)
    pigments: list[Pigment] = field(default_factory=list)
    top_um: float = 0.0


@dataclass
class Gaps:
    """Of a species of flakes, through which light that came in finds its way out."""

    layer: int
    diameter_um: float
    channel: int
    """coupling by tan(theta / 2)"""


class Pair:
    """Two directions (N, 3), outside and inside, and what both together determine."""

    def __init__(self, wi: Floats, wo: Floats, i: Floats, o: Floats) -> None:
        self.i, self.o = i, o
        self.xi, self.xo = (np.hypot(w[:, 0], w[:, 1]) / (1 + w[:, 2]) for w in (wi, wo))
        h = i + o
        self.slope2 = np.sum(h[:, :2] ** 2, axis=1) / h[:, 2] ** 2
        self.cosine = np.minimum(0.5 * h[:, 2] * np.sqrt(1 + self.slope2), 1)
        self.turned = np.sum(i * o, axis=1)
        apart = i[:, :2] / i[:, 2:] - o[:, :2] / o[:, 2:]
        self.spread = np.clip(np.hypot(*apart.T), 1e-4, 1e6)  # of both rays, by a step in height


def overlap_integral(x: Floats) -> Floats:
    """Over t from 0 to x of the overlap of two discs t diameters apart."""
    x = np.minimum(x, 1)
    chord = np.sqrt(1 - x * x)
    return np.asarray(2 / np.pi * (x * np.arccos(x) - chord + chord**3 / 3 + 2 / 3))


class Shader:
    """The numbers of the shader, and its arithmetic."""

    def __init__(self, a: dict[str, Any]) -> None:
        """a: _nacre.appearance_arrays()."""
        nm = np.asarray(a["wavelengths_nm"])
        bands_nm = np.linspace(nm[0], nm[-1], BANDS)
        self.rgb = film_weights(bands_nm)
        self.ior = float(a["mean_ior"])
        self.roughness = float(a["coat_roughness"])
        channels: list[Floats] = []

        def at_bands(values: NDArray[Any]) -> Floats:
            return _rgb.resample(values, nm, bands_nm)

        def channel(values: Floats) -> int:
            """Of functions (rows, BANDS) of a place from 0 to 1."""
            places = np.linspace(0, 1, len(values)) if len(values) > 1 else np.array([0.0])
            new = np.linspace(0, 1, ROWS)
            channels.append(np.stack([np.interp(new, places, band) for band in values.T], axis=-1))
            return len(channels) - 1

        self.clearcoat_depth = at_bands(a["clearcoat_depth"])
        self.layers: list[Layer] = []
        for layer in a["layers"]:
            one = Layer(float(layer["thickness_um"]), channel(at_bands(layer["extinction_per_um"])))
            for f in layer["flakes"]:
                density, alpha = 0.5 * float(f["area_density_per_um"]), float(f["alpha"])
                one.flakes.append(Flake(density, alpha, channel(at_bands(f["reflectance"]))))
            for p in layer["pigments"]:
                phase = channel(at_bands(p["phase"])) if len(p["phase"]) else None
                scattering = at_bands(p["scattering_per_um"])
                one.pigments.append(Pigment(float(p["anisotropy"]), scattering, phase))
            if self.layers:
                one.top_um = self.layers[-1].top_um + self.layers[-1].thickness_um
            self.layers.append(one)
        self.gaps: list[Gaps] = []
        self.ground: int | None = None  # light from below that met no flake
        # Of the other multiple scattering, so that no light is lost.
        self.compensation: int | None = None
        if a["hot_spot"] is not None:
            for s in a["hot_spot"]["species"]:
                coupling = channel(at_bands(s["coupling"]))
                self.gaps.append(Gaps(int(s["layer"]), float(s["diameter_um"]), coupling))
            if len(a["hot_spot"]["ground"]):
                self.ground = channel(at_bands(a["hot_spot"]["ground"]))
            if len(a["hot_spot"]["compensation"]):
                self.compensation = channel(at_bands(a["hot_spot"]["compensation"]))
        self.albedo = channel(np.pad(a["albedo"] @ film_weights(nm).T, ((0, 0), (0, BANDS - 3))))
        if self.roughness > 0:
            self.masked = channel(at_bands(a["masked"] * np.sqrt(a["diffuse_scale"])))
            self.masking = channel(np.tile(a["masking_over_cosine"][:, None], BANDS))

        table = np.concatenate(channels, axis=-1)
        smooth = a["smooth"].astype(np.float64) @ (a["smooth_basis"] @ film_weights(nm).T)
        self.table = table.astype(np.float16)  # (ROWS, channels x BANDS)
        self.smooth = np.pad(smooth, [(0, 0)] * 3 + [(0, 1)]).astype(np.float16)  # (a, b, q, 4)

    # The arithmetic, as in webgl_shader.glsl: directions (N, 3), spectra (N, BANDS)

    def row(self, channel: int, place: Floats) -> Floats:
        table = self.table[:, channel * BANDS : (channel + 1) * BANDS].astype(np.float64)
        y = np.clip(place, 0, 1) * (ROWS - 1)
        low = np.minimum(y.astype(int), ROWS - 2)
        part = (y - low)[:, None]
        return np.asarray(table[low] * (1 - part) + table[low + 1] * part)

    def multiple(self, wi: Floats, wo: Floats, pair: Pair) -> Floats:
        """(N, 3), times the cosines inside."""
        si, so = np.hypot(wi[:, 0], wi[:, 1]), np.hypot(wo[:, 0], wo[:, 1])
        a = np.minimum(np.maximum(pair.xi, pair.xo), 1)
        b = np.abs(pair.xi - pair.xo) / np.maximum(a, 1e-12)
        u = si[:, None] * wo[:, :2] + so[:, None] * wi[:, :2]
        scale = 4 * si**2 * so**2
        q2 = np.where(scale > 1e-14, np.sum(u * u, axis=1) / np.maximum(scale, 1e-14), 0)
        at = np.stack([np.sqrt(a), np.sqrt(b), np.minimum(q2, 1) ** 0.25], axis=-1)
        position = at * (np.array(self.smooth.shape[:3]) - 1)
        low = np.minimum(position.astype(int), np.array(self.smooth.shape[:3]) - 2)
        part = position - low
        total = np.zeros((len(wi), 3))
        for corner in np.ndindex(2, 2, 2):
            weight = np.prod(np.where(corner, part, 1 - part), axis=1)
            i, j, k = (low + corner).T
            total += weight[:, None] * self.smooth[i, j, k, :3].astype(np.float64)
        return total

    def refract(self, w: Floats) -> Floats:
        xy = w[:, :2] / self.ior
        return np.column_stack([xy, np.sqrt(1 - np.sum(xy * xy, axis=1))])

    def fresnel(self, cosine: Floats) -> Floats:
        n = self.ior
        inside = np.sqrt(np.maximum(1 - (1 - cosine**2) / (n * n), 0))
        s = (cosine - n * inside) / (cosine + n * inside)
        p = (inside - n * cosine) / (inside + n * cosine)
        return np.asarray(0.5 * (s * s + p * p))

    def gain(self, pair: Pair, layer: int, u: Floats) -> Floats:
        """(N, BANDS): ln of what gaps let through, at fractions u (N,) of a layer's thickness."""
        total = np.zeros((len(u), BANDS))
        for gaps in self.gaps:
            if gaps.layer > layer:
                break
            own = self.layers[gaps.layer]
            step = pair.spread / gaps.diameter_um
            far = u * self.layers[layer].thickness_um + self.layers[layer].top_um - own.top_um
            near = np.maximum(far - own.thickness_um, 0) if gaps.layer < layer else np.zeros(1)
            shared = (overlap_integral(far * step) - overlap_integral(near * step)) / step
            total += self.both(gaps.channel, pair) * shared[:, None]
        return total

    def both(self, channel: int, pair: Pair) -> Floats:
        return self.row(channel, pair.xi) * self.row(channel, pair.xo)

    def escape(self, pair: Pair, layer: int, depth: Floats) -> Floats:
        """Mean of the attenuation over a layer of this optical depth, both ways."""
        if not self.gaps:
            large = np.maximum(depth, 1e-2)
            small = 1 - depth * (0.5 - depth / 6)
            return np.asarray(np.where(depth < 1e-2, small, -np.expm1(-large) / large))
        reach = np.minimum(1, FARTHEST / np.maximum(depth.min(axis=1), 1e-20))
        total = np.zeros_like(depth)
        for node, weight in zip(DEPTHS, DEPTH_WEIGHTS, strict=True):
            u = reach * node
            total += weight * np.exp(self.gain(pair, layer, u) - depth * u[:, None])
        return np.asarray(total * reach[:, None])

    def once(self, pair: Pair) -> Floats:
        ri, ro = 1 / pair.i[:, 2:], 1 / pair.o[:, 2:]
        depth = self.clearcoat_depth * (ri + ro)
        total = np.zeros_like(depth)
        for n, layer in enumerate(self.layers):
            here = layer.thickness_um * (
                self.row(layer.channel, pair.xi) * ri + self.row(layer.channel, pair.xo) * ro
            )
            kernel = np.zeros_like(depth)
            for f in layer.flakes:
                lobe = np.exp(-np.minimum(pair.slope2 / f.alpha**2, 80)) * (1 + pair.slope2) ** 1.5
                lobe *= f.half_density_per_um / (2 * np.pi * f.alpha**2)
                kernel += lobe[:, None] * self.row(f.channel, pair.cosine)
            for p in layer.pigments:
                if p.channel is None:
                    turn = np.maximum(1 + p.g**2 + 2 * p.g * pair.turned, 1e-6)
                    phase = ((1 - p.g**2) / (4 * np.pi) * turn**-1.5)[:, None]
                else:
                    angle = np.arccos(np.clip(-pair.turned, -1, 1))
                    phase = self.row(p.channel, angle / np.pi)
                kernel += phase * p.scattering_per_um
            escape = self.escape(pair, n, here)
            total += kernel * np.exp(-depth) * layer.thickness_um * escape
            depth = depth + here
        return np.asarray((total * ri * ro) @ self.rgb.T)

    def other(self, wi: Floats, wo: Floats, pair: Pair) -> Floats:
        """Multiple scattering, (N, 3)."""
        value: Floats = self.multiple(wi, wo, pair) / (pair.i[:, 2:] + pair.o[:, 2:])
        if self.compensation is None:
            return value
        compensation = self.both(self.compensation, pair)
        value = value * (compensation @ self.rgb.T)
        if self.ground is not None:
            gain = self.gain(pair, len(self.layers) - 1, np.ones(len(wi)))
            value += ((np.exp(gain) - compensation) * self.both(self.ground, pair)) @ self.rgb.T
        return value

    def interface(self, wi: Floats, wo: Floats, pair: Pair) -> Floats:
        """A rough one."""
        h = wi + wo
        tan2 = np.sum(h[:, :2] ** 2, axis=1) / h[:, 2] ** 2
        sec2, a2 = 1 + tan2, self.roughness**2
        facets = np.exp(-np.minimum(tan2 / a2, 60)) / (np.pi * a2) * sec2 * sec2
        masking = self.both(self.masking, pair)[:, 0]
        lobe = (
            0.25 * facets * masking * self.fresnel(np.minimum(0.5 * np.linalg.norm(h, axis=1), 1))
        )
        masked = self.both(self.masked, pair) @ self.rgb.T
        return np.asarray(masked + lobe[:, None])

    def brdf(self, wi: Floats, wo: Floats) -> Floats:
        """(N, 3) in 1/sr, linear Rec. 709, without the mirror image in a smooth coat."""
        pair = Pair(wi, wo, self.refract(wi), self.refract(wo))
        value = self.other(wi, wo, pair)
        if self.roughness > 0:
            return np.maximum(value + self.interface(wi, wo, pair), 0)
        through = (1 - self.fresnel(wi[:, 2])) * (1 - self.fresnel(wo[:, 2])) / self.ior**2
        return np.maximum((value + self.once(pair)) * through[:, None], 0)
