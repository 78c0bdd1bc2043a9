"""The micro-flake model in Dr.Jit: single scattering in closed form, the rest from a table.

What stands here is src/nacre/bsdf/models/bound_microflake.h, for arrays of samples instead of lanes
of wavelengths; docs/microflake.md has the formulas. Local frame: z is the normal, both directions
point away from the surface.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any, Protocol

import drjit as dr
import mitsuba as mi
import numpy as np
from numpy.typing import NDArray

from ._bands import (
    Arrays,
    Bands,
    Float,
    Source,
    Table,
    Where,
    Wide,
    by_direction,
    columns,
    dr_array,
    single,
    texture,
)
from ._coat import CoatTilt

Vector = Any


@dataclass
class Ray:
    """A direction, and what evaluation needs of it (bsdf::Ray)."""

    outside: Vector
    sine2: Float
    x: Float
    """tan(theta / 2) outside: the coordinate of tables by direction."""
    inside: Vector
    """Refracted with the mean index."""
    tables: list[Wide]
    """The channels of DirectionTables."""


@dataclass
class Pair:
    """Two directions and what both together determine."""

    i: Ray
    o: Ray
    where: Where
    slope: Any
    """(h_x, h_y) / h_z of the half vector inside, at the mean index."""
    slope2: Float
    cosine: Float
    """w_i . h there."""
    slopes_per_solid_angle: Float
    """Area of slopes per solid angle of w_o inside."""


class Flakes(Protocol):
    """Which flakes scatter once: what takes the place of their mean (MeanFlakes in C++)."""

    averaged: Flakes | None
    """Their mean, which a table under a rough coat holds; None: they are it."""

    def start(self) -> None:
        """Before each pair of directions."""

    def factor(self, pair: Pair, layer: int, flake: int, depth: Wide) -> Wide | Float:
        """By which a species' light differs from its mean; depth: of the layer, both ways."""

    def rest_factor(self, pair: Pair, layer: int, depth: Wide) -> Wide | Float:
        """The same for what is no flake."""

    def multiple(self, pair: Pair, value: Wide) -> Wide:
        """Light scattered more than once, given that of the equation of transfer."""


class MeanFlakes:
    averaged: Flakes | None = None

    def start(self) -> None:
        pass

    def factor(self, pair: Pair, layer: int, flake: int, depth: Wide) -> Wide | Float:
        return 1

    def rest_factor(self, pair: Pair, layer: int, depth: Wide) -> Wide | Float:
        return 1

    def multiple(self, pair: Pair, value: Wide) -> Wide:
        return value


def mean_escape(depth: Wide) -> Wide:
    """(1 - exp(-x)) / x, which is the mean of exp(-x u) over u in [0, 1]."""
    small = depth < 1e-2
    safe = dr.select(small, 1, depth)
    return dr.select(small, 1 - depth * (0.5 - depth * (1 / 6)), (1 - dr.exp(-safe)) * dr.rcp(safe))


class DirectionTables:
    """All that depends on one direction and the wavelength, as channels of one texture."""

    def __init__(self, bands: Bands, source: Source) -> None:
        self.names = list(self.channels(source.base))
        self.table = Table(bands, source, lambda a: list(self.channels(a).values()))

    @staticmethod
    def channels(a: Arrays) -> dict[str, NDArray[Any]]:
        named = {
            f"extinction {n}": layer["extinction_per_um"] for n, layer in enumerate(a["layers"])
        }
        if a["coat_roughness"] > 0:
            named["masked"] = a["masked"]
        hot_spot = a["hot_spot"]
        if hot_spot is not None:
            for n, species in enumerate(hot_spot["species"]):
                named[f"coupling {n}"] = species["coupling"]
            for name in ("ground", "compensation"):
                if len(hot_spot[name]):
                    named[name] = hot_spot[name]
        # Of what is looked up together a power of two is fetched at once.
        while len(named) & (len(named) - 1):
            named[f"nothing {len(named)}"] = np.zeros_like(a["clearcoat_depth"])
        return named

    def of(self, ray: Ray, name: str) -> Wide:
        return ray.tables[self.names.index(name)]

    def has(self, name: str) -> bool:
        return name in self.names


@dataclass
class _Flake:
    half_density: Float
    alpha: Float
    reflectance: int  # channel


@dataclass
class _Pigment:
    g: Float
    scattering: int  # channel
    phase: int | None  # channel; None: Henyey and Greenstein's of g

    def henyey_greenstein(self, cosine: Any) -> Any:
        """In 1/sr, by the cosine of the angle by which light is turned."""
        g = self.g
        turn = dr.maximum(1 + g * g - 2 * g * cosine, 1e-6)
        return (1 - g * g) * 0.25 * dr.inv_pi / (turn * dr.sqrt(turn))


class Microflake:
    """The mean over all flakes."""

    def __init__(self, source: Source, bands: Bands) -> None:
        a = source.base
        self.bands = bands
        self.refracts = float(a["mean_ior"]) != 1
        self.mean_ior = source.number(lambda x: x["mean_ior"])
        self.rough = float(a["coat_roughness"]) > 0
        self.roughness = source.number(lambda x: x["coat_roughness"])
        self.coat = CoatTilt(self.rough, self.roughness, self.mean_ior)
        self.dispersive = bool(np.ptp(a["ior"]) > 0)
        self.directions = DirectionTables(bands, source)
        self.by_wavelength = Table(bands, source, self._by_wavelength)
        self._set_smooth(source)
        self._set_layers(source)
        if self.rough:
            masking = source.tensor(lambda x: columns(x["masking_over_cosine"]))
            self.masking = texture(1, masking)

    @staticmethod
    def _by_wavelength(a: Arrays) -> list[NDArray[Any]]:
        channels = [a["ior"], a["clearcoat_depth"]]
        if a["coat_roughness"] > 0:
            channels.append(a["diffuse_scale"])
        for layer in a["layers"]:
            channels += [pigment["scattering_per_um"] for pigment in layer["pigments"]]
        return channels

    # What is not closed

    def _set_smooth(self, source: Source) -> None:
        # Of each arrays: the table, the spectral basis, and what the values are multiplied by.
        terms: list[tuple[Arrays, Float]] = [(source.base, None)]
        for t in source.tangents:
            slope = t.delta / t.step
            dr.make_opaque(slope)  # as in Source.scalar()
            terms += [(t.plus, slope), (t.minus, -slope)]
        self.smooth: list[tuple[Any, tuple[int, ...], Any, Float]] = []
        for a, factor in terms:
            coefficients, basis = a["smooth"], self.bands.even(a["smooth_basis"])
            rank = coefficients.shape[-1]
            padded = 1 << (rank - 1).bit_length()  # which are fetched at once
            coefficients = np.pad(coefficients, [(0, 0)] * 3 + [(0, padded - rank)])
            table = texture(3, mi.TensorXf(single(coefficients)))
            if self.bands.spectral:
                spectra: Any = texture(
                    1, mi.TensorXf(single(np.pad(basis, [(0, padded - rank), (0, 0)]).T))
                )
            else:
                spectra = basis
            self.smooth.append((table, coefficients.shape, spectra, factor))
        self.first_single = source.base["smooth"].shape[-1] - int(source.base["single_rank"])

    def _tabulated(self, pair: Pair, active: Any) -> Wide:
        """Multiple scattering without Fresnel factors; under a rough coat all but the interface."""
        total: Wide = 0
        for table, shape, spectra, factor in self.smooth:
            value = self._smooth_value(pair, table, shape, spectra, active)
            total = value if factor is None else total + factor * value
        return dr.maximum(total, 0) * dr.rcp(pair.i.inside.z + pair.o.inside.z)

    def _tabulated_single(self, pair: Pair, active: Any) -> Wide:
        """Of it, under a rough coat, what was scattered once; without gradients."""
        table, shape, spectra, _ = self.smooth[0]
        value = self._smooth_value(pair, table, shape, spectra, active, self.first_single)
        return dr.maximum(value, 0) * dr.rcp(pair.i.inside.z + pair.o.inside.z)

    def _smooth_value(
        self,
        pair: Pair,
        table: Any,
        shape: tuple[int, ...],
        spectra: Any,
        active: Any,
        first: int = 0,
    ) -> Wide:
        """The sum of the terms from `first` on."""
        # bsdf::locate()
        i, o = pair.i, pair.o
        a = dr.minimum(dr.maximum(i.x, o.x), 1)
        b = dr.select(a > 0, dr.abs(i.x - o.x) / dr.select(a > 0, a, 1), 0)
        s_i, s_o = dr.sqrt(i.sine2), dr.sqrt(o.sine2)
        ux = s_i * o.outside.x + s_o * i.outside.x
        uy = s_i * o.outside.y + s_o * i.outside.y
        scale = 4 * i.sine2 * o.sine2
        q2 = dr.select(
            scale > 1e-14, dr.minimum((ux * ux + uy * uy) / dr.maximum(scale, 1e-14), 1), 0
        )
        # Not by a root's slope at zero, which is infinite: what follows is not differentiated.
        lines = [dr.sqrt(dr.sqrt(q2)), dr.sqrt(b), dr.sqrt(a)]
        n = [shape[2], shape[1], shape[0]]
        at = [
            dr.detach(dr.fma(line, (k - 1) / k, 0.5 / k)) for line, k in zip(lines, n, strict=True)
        ]
        coefficients = table.eval(dr_array(3)(*at), active)
        if not self.bands.spectral:
            rank = len(spectra)
            return self.bands.wide(
                [
                    sum(
                        (float(spectra[k][n]) * coefficients[k] for k in range(first, rank)),
                        start=mi.Float(0),
                    )
                    for n in range(len(self.bands.nm))
                ]
            )
        values = []
        for x in pair.where.coordinates:
            basis = spectra.eval(dr_array(1)(x), active)
            value = mi.Float(0)
            for c, weight in list(zip(coefficients, basis, strict=True))[first:]:
                value = dr.fma(c, weight, value)
            values.append(value)
        return self.bands.wide(values)

    # What is closed

    def _set_layers(self, source: Source) -> None:
        a = source.base
        self.layers: list[tuple[Float, list[_Flake], list[_Pigment]]] = []
        reflectances: list[tuple[int, int]] = []
        phases: list[tuple[int, int]] = []
        channel = 2 + self.rough
        for n, layer in enumerate(a["layers"]):
            flakes = []
            for f in range(len(layer["flakes"])):

                def of(arrays: Arrays, key: str, n: int = n, f: int = f) -> float:
                    return float(arrays["layers"][n]["flakes"][f][key])

                flakes.append(
                    _Flake(
                        0.5 * source.scalar(lambda x: of(x, "area_density_per_um")),
                        source.scalar(lambda x: of(x, "alpha")),
                        len(reflectances),
                    )
                )
                reflectances.append((n, f))
            pigments = []
            for k, pigment in enumerate(layer["pigments"]):

                def anisotropy(arrays: Arrays, n: int = n, k: int = k) -> float:
                    return float(arrays["layers"][n]["pigments"][k]["anisotropy"])

                pigments.append(_Pigment(source.number(anisotropy), channel, None))
                channel += 1
                if len(pigment["phase"]):
                    pigments[-1].phase = len(phases)
                    phases.append((n, k))

            def thickness_of(arrays: Arrays, n: int = n) -> float:
                return float(arrays["layers"][n]["thickness_um"])

            thickness = source.scalar(thickness_of)
            self.layers.append((thickness, flakes, pigments))

        def table(entries: list[tuple[int, int]], kind: str, key: str) -> Table | None:
            if not entries:
                return None
            return Table(
                self.bands, source, lambda x: [x["layers"][n][kind][k][key] for n, k in entries]
            )

        self.reflectance = table(reflectances, "flakes", "reflectance")
        self.phase = table(phases, "pigments", "phase")

    def ray(self, w: Vector, where: Where, active: Any) -> Ray:
        """w: unit, in the upper hemisphere."""
        sine2 = dr.minimum(w.x * w.x + w.y * w.y, 1)
        x = dr.sqrt(sine2) * dr.rcp(1 + w.z)
        rows = self.directions.table.rows
        tables = self.directions.table.look_up(x * (rows - 1), where, active)
        return Ray(w, sine2, x, self.refract_in(w, 1 / self.mean_ior), tables)

    def refract_in(self, w: Vector, inverse_ior: Float) -> Vector:
        if not self.refracts:
            return w
        x, y = w.x * inverse_ior, w.y * inverse_ior
        return mi.Vector3f(x, y, dr.sqrt(dr.maximum(1 - x * x - y * y, 0)))

    def pair(self, i: Ray, o: Ray, where: Where) -> Pair:
        h = i.inside + o.inside
        inverse = dr.rcp(h.z)
        slope = mi.Vector2f(h.x * inverse, h.y * inverse)
        slope2 = dr.dot(slope, slope)
        sec2 = 1 + slope2
        cosine = dr.minimum(0.5 * h.z * dr.sqrt(sec2), 1)
        return Pair(i, o, where, slope, slope2, cosine, 0.5 * inverse * sec2)

    def once(self, pair: Pair, flakes: Flakes, numbers: Sequence[Wide], active: Any) -> Wide:
        """Single scattering without Fresnel factors, under a rough coat with half vectors spread
        by it: BoundMicroflake::single()."""
        i, o = pair.i, pair.o
        if self.dispersive:
            inverse_ior = dr.rcp(numbers[0])
            mu_i = dr.sqrt(dr.maximum(1 - i.sine2 * inverse_ior * inverse_ior, 0))
            mu_o = dr.sqrt(dr.maximum(1 - o.sine2 * inverse_ior * inverse_ior, 0))
            hx = (i.outside.x + o.outside.x) * inverse_ior
            hy = (i.outside.y + o.outside.y) * inverse_ior
            hz = mu_i + mu_o
            between = (
                i.outside.x * o.outside.x + i.outside.y * o.outside.y
            ) * inverse_ior * inverse_ior + mu_i * mu_o
            tan2 = (hx * hx + hy * hy) / (hz * hz)
            cosine = dr.minimum(0.5 * hz * dr.sqrt(1 + tan2), 1)
        else:
            mu_i, mu_o = i.inside.z, o.inside.z
            between = dr.dot(i.inside, o.inside)
            tan2, cosine = pair.slope2, pair.cosine
        inverse_i, inverse_o = dr.rcp(mu_i), dr.rcp(mu_o)
        spread2 = self.coat.spread2(mu_i, mu_o) if self.coat.rough else 0
        sec2 = 1 + tan2
        sec3 = sec2 * dr.sqrt(sec2)
        reflectances = self._by_angle(self.reflectance, cosine, pair, active)
        turned = dr.safe_acos(-between) * dr.inv_pi if self.phase else None
        phases = self._by_angle(self.phase, turned, pair, active)
        total: Wide = self.bands.constant(0)
        depth = numbers[1] * (inverse_i + inverse_o)
        for n, (thickness, species, pigments) in enumerate(self.layers):
            name = f"extinction {n}"
            rate = self.directions.of(i, name) * inverse_i + self.directions.of(o, name) * inverse_o
            here = thickness * rate
            kernel: Wide = self.bands.constant(0)
            for f, flake in enumerate(species):
                alpha2 = flake.alpha * flake.alpha + spread2
                density = (
                    (flake.half_density * (0.5 * dr.inv_pi) / alpha2)
                    * sec3
                    * dr.exp(-dr.minimum(tan2 / alpha2, 80))
                )
                kernel += (
                    density * reflectances[flake.reflectance] * flakes.factor(pair, n, f, here)
                )
            rest = flakes.rest_factor(pair, n, here) if pigments else 1
            for pigment in pigments:
                phase = (
                    pigment.henyey_greenstein(-between)
                    if pigment.phase is None
                    else phases[pigment.phase]
                )
                kernel += phase * numbers[pigment.scattering] * rest
            total += kernel * dr.exp(-depth) * (thickness * mean_escape(here))
            depth += here
        return total * (inverse_i * inverse_o)

    def _by_angle(self, table: Table | None, place: Any, pair: Pair, active: Any) -> list[Wide]:
        """The channels of a table at a place from 0 to 1, under a dispersive binder another one at
        each wavelength."""
        if table is None:
            return []
        last, bands = table.rows - 1, self.bands
        if not self.dispersive:
            return table.look_up(place * last, pair.where, active)
        if bands.spectral:
            each = [
                table.look_up_at(place[k] * last, x, active)
                for k, x in enumerate(pair.where.coordinates)
            ]
            return [bands.wide([row[c] for row in each]) for c in range(table.count)]
        rows = [table.look_up(place[k] * last, pair.where, active) for k in range(len(bands.nm))]
        return [bands.wide([row[c][k] for k, row in enumerate(rows)]) for c in range(table.count)]

    def fresnel(self, cosine: Float, ior: Wide) -> Wide:
        """Reflectance of the smooth interface from outside, unpolarised."""
        inside = dr.sqrt(dr.maximum(1 - (1 - cosine * cosine) / (ior * ior), 0))
        s = (cosine - ior * inside) / (cosine + ior * inside)
        p = (ior * cosine - inside) / (ior * cosine + inside)
        return 0.5 * (s * s + p * p)

    def value(self, pair: Pair, flakes: Flakes, active: Any) -> Wide:
        """BRDF in 1/sr without the specular lobe of a smooth interface:
        BoundMicroflake::value()."""
        numbers = self.by_wavelength.look_up(mi.Float(0), pair.where, active)
        smooth = self._tabulated(pair, active)
        if self.rough:
            mean = smooth + self._rough_lobe(pair, numbers)
            if flakes.averaged is None:
                return mean
            single = dr.minimum(self._tabulated_single(pair, active), smooth)
            return mean + single * (self._rough_ratio(pair, flakes, numbers, active) - 1)
        ior = numbers[0]
        through = (1 - self.fresnel(pair.i.outside.z, ior)) * (
            1 - self.fresnel(pair.o.outside.z, ior)
        )
        once = self.once(pair, flakes, numbers, active)
        return (once + flakes.multiple(pair, smooth)) * through / (ior * ior)

    def _rough_ratio(
        self, pair: Pair, flakes: Flakes, numbers: Sequence[Wide], active: Any
    ) -> Wide:
        """Of the light that was scattered once, that of some flakes over that of all:
        BoundMicroflake::rough_ratio()."""
        assert flakes.averaged is not None
        some = self.once(pair, flakes, numbers, active)
        all_ = self.once(pair, flakes.averaged, numbers, active)
        return dr.select(all_ > 1e-30, some / dr.maximum(all_, 1e-30), 1)

    def specular(self, cosine: Float, where: Where, active: Any) -> Wide:
        """Reflectance of a smooth interface."""
        numbers = self.by_wavelength.look_up(mi.Float(0), where, active)
        return self.fresnel(cosine, numbers[0])

    def _rough_lobe(self, pair: Pair, numbers: Sequence[Wide]) -> Wide:
        """solver::RoughInterface::brdf."""
        i, o = pair.i, pair.o
        h = i.outside + o.outside
        tan2 = (h.x * h.x + h.y * h.y) / (h.z * h.z)
        sec2, a2 = 1 + tan2, self.roughness * self.roughness
        facets = dr.exp(-dr.minimum(tan2 / a2, 60)) * (dr.inv_pi / a2) * sec2 * sec2
        facets = dr.select(tan2 < 60 * a2, facets, 0)
        cosine = dr.minimum(0.5 * dr.norm(h), 1)
        diffuse = numbers[2] * self.directions.of(i, "masked") * self.directions.of(o, "masked")
        masking = self._masking(i) * self._masking(o)
        return diffuse + (0.25 * facets * masking) * self.fresnel(cosine, numbers[0])

    def _masking(self, ray: Ray) -> Float:
        return by_direction(self.masking, ray.x)[0]
