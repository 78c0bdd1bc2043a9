"""The flakes of one species, hashed from cells, and their lobes.

What stands here is src/nacre/sparkle/flake_field.h, flake_view.h and diffraction_lobe.h.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable
from dataclasses import dataclass
from typing import Any

import drjit as dr
import mitsuba as mi
import numpy as np

from ._bands import Arrays, Float, single, texture
from ._bits import (
    GOLDEN,
    SHORT_GOLDEN,
    first_bit,
    gaussian_slopes,
    mix_bits,
    mix_bits_32,
    no,
    u32,
    u64,
    unit_float,
)
from ._coat import CoatTilt
from ._patch import Footprint, Outline, planes_of

MAX_EXPONENT = 14.0
MIN_COSINE = 0.1
SAMPLED_WIDENING = 1.1
LOBE_POWER = 0.92
"""kLobePower: the fraction of a flake's light that its lobe holds."""
BATCH = 8
"""Flakes of a cell that are looked at together; it has four on average."""


@dataclass
class Levels:
    """How the levels of density take part on a patch: FlakeField::level_weights()."""

    weight: list[Float]
    resolved: Float
    widening: Float

    @property
    def background(self) -> Float:
        return 1 - self.resolved


@dataclass
class Flake:
    """One flake that touches the patch."""

    place: Any
    kind: Any
    x: Float
    y: Float
    radius_mm: Float
    weight: Float
    """Of its level."""
    slope: Any
    lobe_radius: Float
    widening: Float
    """Of the levels."""


def added_radius2(spread2: Float) -> Float:
    """DiffractionLobe::coat_radius2()."""
    return 18 / 5 * spread2


class Field:
    """The flakes of one species in one layer: FlakeField with its DiffractionLobe."""

    def __init__(self, a: Arrays, species: Arrays, coat: CoatTilt) -> None:
        self.coat = coat
        self.waviness2 = float(species["waviness"]) ** 2
        self.spreads = coat.rough or self.waviness2 > 0
        self.cell_mm = [float(x) for x in species["cell_mm"]]
        self.key = [int(x) for x in species["key"]]
        self.fraction = [float(x) for x in species["fraction"]]
        self.cumulative = [float(x) for x in species["cumulative"] if x < 1]
        self.full_cells = [float(x) for x in species["full_cells"]]
        self.inverse_cover = float(species["inverse_cover"])
        self.typical_radius = float(species["typical_radius"])
        self.max_widening = float(species["max_widening"])
        self.alpha = float(species["alpha"])
        self.radius_um = float(species["radius_um"])
        diameters = species["diameter_um"].astype(np.float64)
        self.sizes = len(diameters)
        self.one_size = float(diameters[0]) if np.ptp(diameters) == 0 else None
        values = single(diameters)
        self.diameters = values.tolist() if mi.Float is float else mi.Float(values)
        self.smallest = 0.5e-3 * float(diameters[0])
        self.largest = 0.5e-3 * float(diameters[-1])
        # Both tables over the same coordinates, fetched at once.
        stack = np.stack([a["log_blur"], a["inverse_lobe_fraction"]], axis=-1)
        self.lobes = texture(2, mi.TensorXf(single(stack)))
        self.nodes = stack.shape[:2]
        self.max_width = 4.0

    # DiffractionLobe

    def _tables(self, exponent: Float, width: Float) -> list[Float]:
        """ln of the blur over width^2, and the inverse of the lobes' fraction; width over alpha."""
        widths, squares = self.nodes
        x = dr.fma(
            dr.minimum(exponent * ((squares - 1) / MAX_EXPONENT), squares - 1.001),
            1 / squares,
            0.5 / squares,
        )
        y = dr.fma(
            dr.minimum(width * ((widths - 1) / self.max_width), widths - 1.001),
            1 / widths,
            0.5 / widths,
        )
        return list(self.lobes.eval(mi.Point2f(x, y)))

    @staticmethod
    def widening(sec2: Float, cosine: Float) -> Float:
        sec = dr.sqrt(sec2)
        return sec * dr.sqrt(sec) / dr.maximum(cosine, MIN_COSINE)

    @staticmethod
    def lobe(distance2: Float, width: Float) -> Float:
        """K, per unit area of slopes."""
        inverse = dr.rcp(width * width)
        t = dr.maximum(1 - distance2 * inverse, 0)
        return 3 * dr.inv_pi * inverse * t * t

    def spread2(self, mu_i: Float, mu_o: Float) -> Float:
        """The square of the alpha by which all but diffraction spreads the light of a flake."""
        of_coat = self.coat.spread2(mu_i, mu_o) if self.coat.rough else 0
        return of_coat + self.waviness2

    def answer_factor(
        self, levels: Levels, exponent: Float, scale: Float, spread2: Float | None
    ) -> Float:
        """FlakeView::answer_factor(); spread2: None where nothing but diffraction spreads light."""
        radius = self.typical_radius * scale
        radius2 = radius * radius
        if spread2 is None:
            inverse = self._tables(exponent, radius)[1]
        else:
            relative = spread2 / (self.alpha * self.alpha)
            narrower = 1 / (1 + relative)
            power = dr.maximum(LOBE_POWER, 1 - 0.2 * dr.rsqrt(dr.maximum(relative / radius2, 1e-9)))
            inverse = self._tables(exponent * narrower, radius * dr.sqrt(narrower))[1]
            inverse *= LOBE_POWER / power
            radius2 = radius2 + added_radius2(relative)
        lobes = 1 / dr.maximum(1, inverse)
        bend = (exponent - 1) * radius2 * (1 / 3)
        bound = dr.select(levels.resolved > 0, 1 / dr.maximum(levels.resolved, 1e-6), 1)
        ratio = dr.maximum(1 - bend, 0.25) / dr.maximum(
            1 - levels.widening * levels.widening * bend, 0.25
        )
        return dr.select(levels.widening == 1, lobes, dr.minimum(bound, lobes * dr.sqrt(ratio)))

    # FlakeField

    def levels(self, outline: Outline) -> Levels:
        faded = 2.3
        cells = [
            (1 + (outline.size[0] + 2 * self.largest) / side)
            * (1 + (outline.size[1] + 2 * self.largest) / side)
            for side in self.cell_mm
        ]
        weights = []
        for count, full in zip(cells, self.full_cells, strict=True):
            t = dr.clip((faded - count / full) / (faded - 1), 0, 1)
            weights.append(t * t)
        first = sum(w * f for w, f in zip(weights, self.fraction, strict=True))
        second = sum(w * w * f for w, f in zip(weights, self.fraction, strict=True))
        none = second <= 0
        all_ = cells[0] <= self.full_cells[0]
        deviation = dr.sqrt(second) / dr.maximum(first, 1e-30)
        safe = dr.maximum(deviation, 1e-30)
        widening = dr.clip(0.95 * deviation, 1, self.max_widening)
        resolved = dr.minimum(widening / safe, 1)
        scale = resolved / dr.maximum(first, 1e-30)
        return Levels(
            [dr.select(all_, 1, dr.select(none, 0, w * scale)) for w in weights],
            dr.select(all_, 1, dr.select(none, 0, resolved)),
            dr.select(all_ | none, 1, widening),
        )

    def visit(
        self,
        patch: Footprint,
        outline: Outline,
        levels: Levels,
        active: Any,
        meet: Callable[[Flake, Any, Any], Any],
        met: Any,
        accept: Callable[[Flake], Any],
        answer: Callable[[Flake, Any, Any], Any],
        answered: Any,
    ) -> tuple[Any, Any]:
        """Goes through the flakes that touch the patch (FlakeField::look()).

        met = meet(flake, mask, met) for each of them; answered = answer(flake, mask, answered) for
        those that accept(flake) lets pass. Returns both.

        One loop steps through planes, levels, rows and columns of cells, so that neighbouring
        samples need not wait for each other at the end of each. Of the flakes in a cell those that
        touch the patch are looked for first, as most do not, and what is costly is left to those
        few that are accepted.
        """
        planes, faces = planes_of(patch, outline)
        u_ranges = [plane.u.cells(1 / self.cell_mm[0]) for plane in planes]
        v_ranges = [plane.v.cells(1 / self.cell_mm[0]) for plane in planes]
        finest = len(self.cell_mm)

        def of_plane(p: Any, values: Iterable[Any]) -> Any:
            x, y, z = values
            return dr.select(p == 0, x, dr.select(p == 1, y, z))

        def of_level(level: Any, values: list[Any]) -> Any:
            chosen = values[-1]
            for n in reversed(range(len(values) - 1)):
                chosen = dr.select(level == n, values[n], chosen)
            return chosen

        def next_cell(p: Any, level: Any, u: Any, v: Any) -> tuple[Any, Any, Any, Any]:
            """The next one, which may be none: then p is 3. Before the first, level is `finest`."""
            shift = 2 * dr.minimum(level, finest - 1)
            u = u + 1
            next_row = u > (of_plane(p, (r[1] for r in u_ranges)) >> shift)
            v = dr.select(next_row, v + 1, v)
            last_row = v > (of_plane(p, (r[1] for r in v_ranges)) >> shift)
            next_level = (level >= finest) | (next_row & last_row)
            level = dr.select(next_level, level + 1, level)
            next_plane = level >= finest
            candidate = p
            for _ in range(3):
                further = (candidate == p) | ((candidate < 3) & no(self._face(candidate, faces)))
                candidate = dr.select(next_plane & further, candidate + 1, candidate)
            level = dr.select(next_plane, self._first_level(levels), level)
            shift = 2 * dr.minimum(level, finest - 1)
            first_u = of_plane(candidate, (r[0] for r in u_ranges)) >> shift
            first_v = of_plane(candidate, (r[0] for r in v_ranges)) >> shift
            v = dr.select(next_level, first_v, v)
            u = dr.select(next_row | next_level, first_u, u)
            return candidate, level, u, v

        def enter(p: Any, level: Any, u: Any, v: Any) -> dict[str, Any]:
            """What the flakes of a cell have in common."""
            key = of_level(level, [mi.UInt64(k) for k in self.key])
            side = of_plane(p, (plane.side for plane in planes))
            key = u64(key + u64(mi.UInt64(side) * mi.UInt64(GOLDEN)))
            low = mi.UInt64(self._bits(u))
            key = mix_bits(key ^ (u64(mi.UInt64(self._bits(v)) << 32) | low))
            high_key = mi.UInt32(key >> 32)
            draw = unit_float(high_key)
            number = mi.UInt32(0)
            for bound in self.cumulative:
                number += dr.select(draw >= bound, mi.UInt32(1), mi.UInt32(0))
            size = of_level(level, [mi.Float64(x) for x in self.cell_mm])
            at_u = of_plane(p, (plane.u.at for plane in planes))
            at_v = of_plane(p, (plane.v.at for plane in planes))
            corner_u = mi.Float(mi.Float64(u) * size - mi.Float64(at_u))
            corner_v = mi.Float(mi.Float64(v) * size - mi.Float64(at_v))
            # A point of the cell in the plane of the patch: the corner, and steps by grains.
            step_u = of_plane(p, (plane.u.step for plane in planes))
            step_v = of_plane(p, (plane.v.step for plane in planes))
            grain = mi.Float(size) * 2.0**-16
            return {
                "number": number,
                "low_key": mi.UInt32(u64(key) & 0xFFFFFFFF),
                "high_key": high_key,
                "corner": step_u * corner_u + step_v * corner_v,
                "step_u": step_u * grain,
                "step_v": step_v * grain,
                "turn": of_plane(p, (plane.turn for plane in planes)),
                "kept": of_plane(p, (plane.kept for plane in planes)),
                "weight": of_level(level, levels.weight),
            }

        def place_of(c: dict[str, Any], k: Any) -> tuple[Any, Any, Float, Float, Float]:
            step = u32(k * mi.UInt32(SHORT_GOLDEN))
            place = mix_bits_32(u32(c["low_key"] + step))
            kind = mix_bits_32(u32(c["high_key"] + step))
            grains_u, grains_v = mi.Float(place & 0xFFFF), mi.Float(place >> 16)
            at = c["corner"] + c["step_u"] * grains_u + c["step_v"] * grains_v
            return place, kind, at.x, at.y, self._diameter(kind)

        def flake_of(c: dict[str, Any], k: Any) -> Flake:
            place, kind, x, y, diameter = place_of(c, k)
            a, b = gaussian_slopes(place, kind)
            t = c["turn"]
            slope = mi.Vector2f(self.alpha * (t.x * a - t.y * b), self.alpha * (t.y * a + t.x * b))
            lobe_radius = levels.widening * (self.radius_um / diameter)
            return Flake(
                *(place, kind, x, y, 0.5e-3 * diameter, c["weight"], slope, lobe_radius),
                levels.widening,
            )

        def touching(c: dict[str, Any], k: Any) -> Any:
            """Which of the next flakes of the cell touch the patch, as bits. They do not wait for
            each other, as processors work on several chains of operations at a time."""
            bits = mi.UInt32(0)
            for n in range(BATCH):
                _, kind, x, y, diameter = place_of(c, k + (n + 1))
                there = (k + n < c["number"]) & (mi.Float(kind & 0xFFFF) < c["kept"])
                there &= outline.touches(x, y, 0.5e-3 * diameter)
                bits = bits | dr.select(there, mi.UInt32(1 << n), mi.UInt32(0))
            return bits

        def next_touching(c: Any, k: Any, bits: Any, met: Any, answered: Any) -> Any:
            flake = flake_of(c, k + 1 + first_bit(bits))
            bits = bits & (bits - 1)
            met = meet(flake, mi.Bool(True), met)
            # A loop that runs at most once skips its body where no sample needs it.
            _, answered = dr.while_loop(
                (mi.Bool(accept(flake)), answered),
                lambda found, answered: found,
                lambda found, answered: (mi.Bool(False), answer(flake, found, answered)),
            )
            return c, k, bits, met, answered

        def next_batch(c: Any, k: Any, met: Any, answered: Any) -> Any:
            c, k, _, met, answered = dr.while_loop(
                (c, k, touching(c, k), met, answered),
                lambda c, k, bits, met, answered: bits != 0,
                next_touching,
            )
            return c, k + BATCH, met, answered

        def next_of_cells(at: tuple[Any, ...], met: Any, answered: Any) -> Any:
            _, _, met, answered = dr.while_loop(
                (enter(*at), mi.UInt32(0), met, answered),
                lambda c, k, met, answered: k < c["number"],
                next_batch,
            )
            return next_cell(*at), met, answered

        at = next_cell(mi.Int32(-1), mi.Int32(finest), mi.Int32(0), mi.Int32(0))
        at = (dr.select(mi.Bool(active) & (levels.resolved > 0), at[0], 3), *at[1:])
        _, met, answered = dr.while_loop(
            (at, met, answered), lambda at, met, answered: at[0] < 3, next_of_cells
        )
        return met, answered

    def drawn_radius(self, wi: Any, flake: Flake) -> Float:
        """Of the lobe about a flake's slope from which half vectors are drawn for wi, inside: that
        which is evaluated, whose radius is that at the half vector instead, and a little more."""
        m = flake.slope
        sec2 = 1 + dr.dot(m, m)
        facing = wi.x * m.x + wi.y * m.y + wi.z
        scale = self.widening(sec2, dr.abs(facing) * dr.rsqrt(sec2))
        radius = SAMPLED_WIDENING * flake.lobe_radius * scale
        if self.spreads:
            # Towards where a flake of this slope mirrors wi.
            spread2 = self.spread2(wi.z, 2 * facing / sec2 - wi.z)
            wider = SAMPLED_WIDENING * flake.widening
            radius = dr.sqrt(radius * radius + wider * wider * added_radius2(spread2))
        return dr.minimum(radius, self.max_width * self.alpha)

    def _first_level(self, levels: Levels) -> Any:
        level = mi.Int32(0)
        for n in range(len(self.cell_mm) - 1):
            level = dr.select((level == n) & (levels.weight[n] <= 0), n + 1, level)
        return level

    @staticmethod
    def _face(p: Any, faces: list[Any]) -> Any:
        return ((p == 0) & faces[0]) | ((p == 1) & faces[1]) | ((p == 2) & faces[2])

    @staticmethod
    def _bits(x: Any) -> Any:
        """The two's complement of an integer, in 32 bits."""
        return x & 0xFFFFFFFF if mi.Float is float else mi.UInt32(x)

    def _radius_mm(self, kind: Any) -> Float:
        return 0.5e-3 * self._diameter(kind)

    def _diameter(self, kind: Any) -> Float:
        if self.one_size is not None:
            return mi.Float(self.one_size)
        size = kind >> 24
        if mi.Float is float:
            return self.diameters[size]
        return dr.gather(mi.Float, self.diameters, size)
