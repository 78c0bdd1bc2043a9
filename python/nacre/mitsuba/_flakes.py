"""Single flakes in Dr.Jit: the same hashed flakes as Nacre's, on the patch that a sample looks at.

What stands here is BoundNacre in src/nacre/bsdf/models/nacre.h. C++ collects the flakes of a patch
in a list and asks it again and again; here each pair of directions goes through the flakes anew,
though not through all cells (_cells.py).
"""

from __future__ import annotations

from typing import Any

import drjit as dr
import mitsuba as mi

from ._bands import Arrays, Float, Source, Table, Wide
from ._bits import hash_of_two, mix_bits_32, u64, unit_float, unit_fraction
from ._cells import Cells
from ._field import MAX_EXPONENT, Field, Flake, added_radius2
from ._hot_spot import HotSpot
from ._microflake import MeanFlakes, Microflake, Pair, Ray, mean_escape
from ._patch import Footprint, Outline
from ._sampling import refract_out


class Sparkle(MeanFlakes):
    """The flakes of a patch in place of the mean of all: BoundNacre::FlakesOfPatch.

    Whoever goes through the flakes for a pair of directions learns on the way how likely each is to
    be drawn. Where `shown` is false, the mean is seen.
    """

    def __init__(
        self, model: SparkleModel, patch: Footprint, i: Ray, active: Any, shown: Any
    ) -> None:
        self.model = model
        self.averaged = model.mean
        self.i = i
        self.shown = shown
        self.active = mi.Bool(active) & shown
        self.outlines = [Outline(patch, f.smallest, f.largest) for f in model.fields]
        self.levels = [
            f.levels(outline) for f, outline in zip(model.fields, self.outlines, strict=True)
        ]
        self.cells = [
            Cells(field, patch, outline, levels, self.active)
            for field, outline, levels in zip(model.fields, self.outlines, self.levels, strict=True)
        ]
        resolved = mi.Float(0)
        for fraction, levels in zip(model.fractions, self.levels, strict=True):
            resolved = dr.fma(fraction, levels.resolved, resolved)
        self.resolved = dr.select(self.shown, resolved, 0)
        # By which draw() takes flakes, in sum; after survey(), or the value of any pair.
        self.total = mi.Float(0)

    def start(self) -> None:
        # Of the pair of directions that is asked, the sum over flakes of weight times density.
        self.density_sum = mi.Float(0)
        self.total = mi.Float(0)

    def survey(self, random: Any) -> None:
        """Draws a flake.

        random: 32 bits
        """
        self.total, slope, radius = mi.Float(0), mi.Vector2f(0), mi.Float(1e-3)
        for s, field in enumerate(self.model.fields):
            flake, total = self.cells[s].draw(random)
            weight = self.model.fractions[s] * total
            self.total = self.total + weight
            # As in Cells.draw().
            random = mix_bits_32(random ^ mi.UInt32(s + 1))
            take = unit_fraction(random) * self.total < weight
            slope = dr.select(take, flake.slope, slope)
            own = field.drawn_radius(self.i.inside, flake, self.levels[s])
            radius = dr.select(take, own, radius)
        self.slope, self.radius = slope, radius

    def factor(self, pair: Pair, layer: int, flake: int, depth: Wide) -> Wide | Float:
        model = self.model
        s = model.first_species[layer] + flake
        field, outline, levels = model.fields[s], self.outlines[s], self.levels[s]
        alpha2 = field.alpha * field.alpha
        exponent = pair.slope2 / alpha2
        reaches = exponent < MAX_EXPONENT
        scale = field.widening(1 + pair.slope2, pair.cosine)
        spread2 = field.spread2(pair.i.inside.z, pair.o.inside.z) if field.spreads else None
        added2 = 0 if spread2 is None else levels.widening**2 * added_radius2(spread2)
        part = dr.select(reaches, field.resolved_factor(levels, exponent, scale, spread2), 0)
        beckmann = dr.inv_pi / alpha2 * dr.exp(-dr.minimum(exponent, MAX_EXPONENT))
        widest = field.max_width * field.alpha
        hot_spot = model.hot_spot
        spread = hot_spot.spread(pair) if hot_spot else None
        couplings = hot_spot.couplings(pair) if hot_spot else []
        films = model.films[s]

        def distance2(f: Flake) -> tuple[Float, Float]:
            dx, dy = f.slope.x - pair.slope.x, f.slope.y - pair.slope.y
            own = f.lobe_radius * scale
            width = own if spread2 is None else dr.sqrt(own * own + added2)
            return dx * dx + dy * dy, dr.minimum(width, widest)

        def accept(f: Flake) -> Any:
            d2, width = distance2(f)
            drawn = field.drawn_radius(self.i.inside, f, levels)
            return d2 < dr.maximum(width * width, drawn * drawn)

        def answer(f: Flake, weight: Float, state: Any) -> Any:
            reflected, density = state
            d2, width = distance2(f)
            fraction = f.weight * field.inverse_cover
            fraction *= outline.coverage(f.x, f.y, f.radius_mm)
            blurred = beckmann * field.blur(exponent, width / field.alpha)
            fraction *= field.lobe(d2, width) * part / blurred
            bits = hash_of_two(f.place, f.kind)
            u = unit_float(mi.UInt32(u64(bits) & 0xFFFFFFFF))
            log: Wide = -u * depth
            if hot_spot:
                log += hot_spot.gain(pair, layer, u, spread, couplings)
            light = fraction * dr.exp(log)
            if films is not None:
                light *= films.ratio(mi.UInt32(bits >> 32), pair)
            lobe = field.lobe(d2, field.drawn_radius(self.i.inside, f, levels))
            return reflected + dr.select(reaches, light, 0), density + weight * lobe

        (reflected, density), total = self.cells[s].visit(
            accept,
            answer,
            (model.smooth.bands.constant(0), mi.Float(0)),
        )
        self.density_sum = dr.fma(model.fractions[s], density, self.density_sum)
        self.total = dr.fma(model.fractions[s], total, self.total)
        background = 1 - levels.resolved * part
        mean = hot_spot.mean(pair, layer, depth) if hot_spot else 1
        return dr.select(self.shown, background * mean + reflected / mean_escape(depth), mean)

    def rest_factor(self, pair: Pair, layer: int, depth: Wide) -> Wide | Float:
        return self.model.mean.rest_factor(pair, layer, depth)

    def multiple(self, pair: Pair, value: Wide) -> Wide:
        return self.model.mean.multiple(pair, value)

    @property
    def any(self) -> Any:
        """Whether a flake touches the patch."""
        return self.total > 0

    def density(self, pair: Pair) -> Float:
        """Per solid angle outside, of draw(); after the value of this pair."""
        ratio = pair.o.outside.z / (self.model.smooth.mean_ior**2 * pair.o.inside.z)
        slopes = self.density_sum / dr.select(self.any, self.total, 1)
        return dr.detach(slopes * pair.slopes_per_solid_angle * ratio)

    def draw(self, u: Any) -> Any:
        """A direction from the lobe of the flake that survey() drew."""
        # The inverse of 1 - (1 - r^2/w^2)^3.
        root = dr.power(dr.maximum(1 - u.x, 1e-12), 1 / 3)
        r = self.radius * dr.sqrt(dr.maximum(1 - root, 0))
        sin, cos = dr.sincos(2 * dr.pi * u.y)
        slope = self.slope
        m = dr.normalize(mi.Vector3f(slope.x + r * cos, slope.y + r * sin, 1))
        inside = 2 * dr.dot(self.i.inside, m) * m - self.i.inside
        return refract_out(inside, self.model.smooth.mean_ior)


class Films:
    """The colours of single flakes whose films vary, over their mean: bsdf::FlakeFilms."""

    def __init__(self, smooth: Microflake, source: Source, species: int) -> None:
        own = source.base["species"][species]
        self.sets, self.cosines = own["film_ratio"].shape[:2]
        self.min_cosine = float(own["film_min_cosine"])

        def rows(a: Arrays) -> list[Any]:
            ratio = a["species"][species]["film_ratio"]
            return [ratio.reshape(-1, ratio.shape[-1])]

        # Without derivatives, as flakes are not shown where there are any.
        self.table = Table(smooth.bands, Source(source.base), rows)

    def ratio(self, film: Any, pair: Pair) -> Wide:
        """film: the flake's 32 bits."""
        index = mi.UInt32(u64(mi.UInt64(film) * mi.UInt64(self.sets)) >> 32)
        last = self.cosines - 1
        x = dr.clip((pair.cosine - self.min_cosine) * (last / (1 - self.min_cosine)), 0, last)
        return self.table.look_up(mi.Float(index) * self.cosines + x, pair.where)[0]


class SparkleModel:
    """What single flakes of a paint need beside its mean."""

    def __init__(self, smooth: Microflake, source: Source) -> None:
        a = source.base
        self.smooth = smooth
        self.hot_spot = HotSpot(smooth, source) if a["hot_spot"] is not None else None
        self.mean = self.hot_spot or MeanFlakes()
        self.fields = [Field(a, species, smooth.coat) for species in a["species"]]
        self.films = [
            Films(smooth, source, n) if len(species["film_ratio"]) else None
            for n, species in enumerate(a["species"])
        ]
        # Of the singly scattered light, roughly.
        cover = [
            layer["thickness_um"] * flake["area_density_per_um"] * flake["reflectance"][-1].mean()
            for layer in a["layers"]
            for flake in layer["flakes"]
        ]
        total = max(float(sum(cover)), 1e-30)
        self.fractions = [float(c) / total for c in cover]
        self.first_species = [0]
        for layer in a["layers"]:
            self.first_species.append(self.first_species[-1] + len(layer["flakes"]))
