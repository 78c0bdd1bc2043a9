"""Single flakes in Dr.Jit: the same hashed flakes as Nacre's, on the patch that a sample looks at.

What stands here is src/nacre/sparkle/flake_field.h, flake_plane.h, flake_view.h and
patch_outline.h. C++ collects the flakes of a patch in a list and asks it again and again; here each
pair of directions goes through the cells anew, as Dr.Jit has no memory for lists inside the
functions of a BSDF.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable
from dataclasses import dataclass
from typing import Any

import drjit as dr
import mitsuba as mi
import numpy as np

from ._bands import Arrays, Float, Source, Table, Wide, texture
from ._hot_spot import HotSpot
from ._microflake import MeanFlakes, Microflake, Pair, Ray, mean_escape, refract_out

GOLDEN = 0x9E3779B97F4A7C15
SHORT_GOLDEN = 0x9E3779B9
MAX_STRETCH = 1.5811388
"""kMaxStretch: flakes per area of a plane of cells over flakes per area of the surface."""
PROJECTION_BLEND = 0.1
LOBE_POWER = 0.92
MAX_EXPONENT = 14.0
MIN_COSINE = 0.1
SAMPLED_WIDENING = 1.1
BATCH = 8
"""Flakes of a cell that are looked at together; it has four on average."""


# Integers and masks. In scalar variants they are Python's, which neither wrap around nor know ~.


def u32(x: Any) -> Any:
    return x & 0xFFFFFFFF if mi.Float is float else x


def u64(x: Any) -> Any:
    return x & 0xFFFFFFFFFFFFFFFF if mi.Float is float else x


def no(mask: Any) -> Any:
    return not mask if mi.Float is float else ~mask


def mix_bits(x: Any) -> Any:
    """[steele-2014]"""
    x = u64((x ^ (x >> 30)) * mi.UInt64(0xBF58476D1CE4E5B9))
    x = u64((x ^ (x >> 27)) * mi.UInt64(0x94D049BB133111EB))
    return x ^ (x >> 31)


def mix_bits_32(x: Any) -> Any:
    """[wellons-2018]"""
    x = u32((x ^ (x >> 16)) * mi.UInt32(0x7FEB352D))
    x = u32((x ^ (x >> 15)) * mi.UInt32(0x846CA68B))
    return x ^ (x >> 16)


def hash_of_two(a: Any, b: Any) -> Any:
    """hash_of() of two integers of 32 bits, as 64."""
    golden = mi.UInt64(GOLDEN)
    h = mix_bits(u64((mi.UInt64(2) ^ mi.UInt64(a)) + golden))
    return mix_bits(u64((h ^ mi.UInt64(b)) + golden))


def first_bit(bits: Any) -> Any:
    """The number of the lowest bit that is set."""
    return (bits & -bits).bit_length() - 1 if mi.Float is float else dr.tzcnt(bits)


def unit_fraction(bits: Any) -> Float:
    return (mi.Float(bits >> 1) + 0.5) * 2.0**-31


def unit_float(bits: Any) -> Float:
    return mi.Float(bits >> 8) * 2.0**-24


def gaussian_slopes(place: Any, kind: Any) -> tuple[Float, Float]:
    """Of variance 1/2 each, by Box and Muller's transform of a flake's bits."""
    golden = mi.UInt32(SHORT_GOLDEN)
    u = unit_fraction(mix_bits_32(u32(place + u32(golden * kind))))
    turns = unit_fraction(mix_bits_32(kind ^ (place >> 7) ^ u32(place << 25)))
    r = dr.sqrt(dr.maximum(-dr.log(u), 0))
    sin, cos = dr.sincos(2 * dr.pi * turns)
    return r * cos, r * sin


@dataclass
class Footprint:
    """The piece of a surface that a sample looks at, in the millimetres of the rest space."""

    position_mm: Any
    normal: Any
    tangent: Any
    edge_1_mm: Any
    edge_2_mm: Any


class Outline:
    """A patch in its own plane, x along its tangent: PatchOutline."""

    def __init__(self, patch: Footprint, smallest_radius: float, largest_radius: float) -> None:
        self.tangent = patch.tangent
        self.bitangent = dr.cross(patch.normal, patch.tangent)
        self.reach = largest_radius
        e = [
            mi.Vector2f(dr.dot(edge, self.tangent), dr.dot(edge, self.bitangent))
            for edge in (patch.edge_1_mm, patch.edge_2_mm)
        ]
        size = [dr.norm(x) for x in e]
        self.is_point = size[0] + size[1] < 0.05 * smallest_radius
        # A needle gets some width, so that it has an area.
        longer_is_second = size[1] > size[0]
        longer = dr.select(longer_is_second, e[1], e[0])
        longer_size = dr.maximum(dr.select(longer_is_second, size[1], size[0]), 1e-20)
        width = 1e-3 * smallest_radius
        needle = dr.abs(self._area(e)) < width * longer_size
        across = mi.Vector2f(-longer.y, longer.x) * (width / longer_size)
        for n, is_shorter in ((0, longer_is_second), (1, no(longer_is_second))):
            e[n] = dr.select(needle & is_shorter, across, e[n])
        # Anticlockwise.
        swapped = self._area(e) < 0
        self.edge = [dr.select(swapped, e[1], e[0]), dr.select(swapped, e[0], e[1])]
        self.area = dr.maximum(self._area(self.edge), 1e-20)
        self.size = [dr.norm(x) for x in self.edge]
        self.along = []
        for n, otherwise in ((0, mi.Vector2f(0, -1)), (1, mi.Vector2f(1, 0))):
            zero = self.size[n] <= 0
            self.along.append(
                dr.select(zero, otherwise, self.edge[n] / dr.select(zero, 1, self.size[n]))
            )
        self.strip = []
        for a in self.along:
            normal = mi.Vector2f(-a.y, a.x)
            half = 0.5 * (
                dr.abs(dr.dot(normal, self.edge[0])) + dr.abs(dr.dot(normal, self.edge[1]))
            )
            self.strip.append((normal, half))

    @staticmethod
    def _area(e: list[Any]) -> Float:
        return e[0].x * e[1].y - e[0].y * e[1].x

    def touches(self, x: Float, y: Float, radius: Float) -> Any:
        touching = mi.Bool(True)
        for normal, half in self.strip:
            touching &= dr.abs(x * normal.x + y * normal.y) < half + radius
        return touching

    def rough_coverage(self, x: Float, y: Float, radius: Float) -> Float:
        """coverage() of a disc that touches the patch to a factor of order 1, at a tenth of the
        cost; never zero."""
        most = dr.minimum(dr.pi * radius * radius / self.area, 1)
        reach = dr.minimum(0.5 * (self.size[0] + self.size[1]) + 1e-3 * radius, 2 * radius)
        inside = (radius - dr.sqrt(x * x + y * y)) / reach
        return most * dr.clip(0.5 + inside, 0.1, 1)

    def coverage(self, x: Float, y: Float, radius: Float) -> Float:
        """The fraction of the patch that a disc about (x, y) covers."""
        distance = dr.sqrt(x * x + y * y)
        safe = dr.maximum(distance, 1e-20)
        width = mi.Float(1e-20)
        for e in self.edge:
            width += dr.abs(e.x * x + e.y * y) / safe
        of_point = dr.clip(0.5 + (radius - distance) / width, 0, 1)
        return dr.select(self.is_point, of_point, self._disc_overlap(x, y, radius) / self.area)

    def _disc_overlap(self, x: Float, y: Float, radius: Float) -> Float:
        """Area shared with a disc, by the angles under which its centre sees the sides."""
        radius2 = radius * radius
        a, b = 0.5 * (self.edge[0] + self.edge[1]), 0.5 * (self.edge[1] - self.edge[0])
        sides = [
            (-a, self.along[0], self.size[0]),
            (-b, self.along[1], self.size[1]),
            (a, -self.along[0], self.size[0]),
            (b, -self.along[1], self.size[1]),
        ]
        triangles, sectors, inside = mi.Float(0), mi.Float(0), mi.Bool(True)
        for start, along, size in sides:
            px, py = start.x - x, start.y - y
            distance = px * along.y - py * along.x
            t0 = px * along.x + py * along.y
            t1 = t0 + size
            chord = dr.sqrt(dr.maximum(radius2 - distance * distance, 0))
            c0, c1 = dr.clip(t0, -chord, chord), dr.clip(t1, -chord, chord)
            off = dr.select(distance == 0, 1e-30, distance)
            inside &= off > 0
            triangles += distance * (c1 - c0)
            sectors += dr.atan2(off * (c1 - c0), off * off + c0 * c1)
        full = dr.select(inside, 2 * dr.pi, 0)
        return dr.maximum(0.5 * (triangles + radius2 * (full - sectors)), 0)


@dataclass
class Axis:
    """Of a plane of cells: FlakePlane::Axis."""

    at: Float
    half: Float
    step: Any

    def cells(self, per_mm: float) -> tuple[Any, Any]:
        at = mi.Float64(self.at)
        return (
            mi.Int32(dr.floor((at - mi.Float64(self.half)) * per_mm)),
            mi.Int32(dr.floor((at + mi.Float64(self.half)) * per_mm)),
        )


@dataclass
class Plane:
    """A plane of cells as a patch sees it: FlakePlane."""

    side: Any
    kept: Float
    u: Axis
    v: Axis
    turn: Any

    @staticmethod
    def through(patch: Footprint, outline: Outline, axis: int, fraction: Float) -> Plane:
        n, t, b = patch.normal, outline.tangent, outline.bitangent
        across = dr.select(dr.abs(n[axis]) < 1e-6, 1e-6, n[axis])

        def make(i: int) -> Axis:
            shear = n[i] / across
            half = 0.5 * (dr.abs(patch.edge_1_mm[i]) + dr.abs(patch.edge_2_mm[i]))
            half += outline.reach * dr.sqrt(dr.maximum(1 - n[i] * n[i], 0))
            step = mi.Vector2f(t[i] - shear * t[axis], b[i] - shear * b[axis])
            return Axis(patch.position_mm[i], half, step)

        first = (axis + 1) % 3
        turn = dr.normalize(mi.Vector2f(t[first], b[first]))
        return Plane(
            mi.UInt32(2 * axis) + dr.select(n[axis] < 0, mi.UInt32(1), mi.UInt32(0)),
            fraction * dr.abs(1 / across) * (65536 / MAX_STRETCH),
            make(first),
            make((axis + 2) % 3),
            turn,
        )


def planes_of(patch: Footprint, outline: Outline) -> tuple[list[Plane], list[Any]]:
    """The three planes across the axes, and which of them give flakes: projections_of()."""
    n = patch.normal
    squares = [n[axis] * n[axis] for axis in range(3)]
    largest = dr.maximum(dr.maximum(squares[0], squares[1]), squares[2])
    weights = [dr.maximum(s - largest + PROJECTION_BLEND, 0) for s in squares]
    total = weights[0] + weights[1] + weights[2]
    planes = [Plane.through(patch, outline, axis, weights[axis] / total) for axis in range(3)]
    return planes, [w > 0 for w in weights]


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


class Field:
    """The flakes of one species in one layer: FlakeField with its DiffractionLobe."""

    def __init__(self, a: Arrays, species: Arrays) -> None:
        self.cell_mm = [float(x) for x in species["cell_mm"]]
        self.key = [int(x) for x in species["key"]]
        self.fraction = [float(x) for x in species["fraction"]]
        self.cumulative = [float(x) for x in species["cumulative"] if x < 1]
        self.full_cells = float(species["full_cells"])
        self.inverse_cover = float(species["inverse_cover"])
        self.typical_radius = float(species["typical_radius"])
        self.max_widening = float(species["max_widening"])
        self.alpha = float(species["alpha"])
        self.radius_um = float(species["radius_um"])
        diameters = species["diameter_um"].astype(np.float64)
        self.sizes = len(diameters)
        self.one_size = float(diameters[0]) if np.ptp(diameters) == 0 else None
        values = diameters.astype(np.float32)
        self.diameters = values.tolist() if mi.Float is float else mi.Float(values)
        self.smallest = 0.5e-3 * float(diameters[0])
        self.largest = 0.5e-3 * float(diameters[-1])
        # Both tables over the same coordinates, fetched at once.
        stack = np.stack([a["log_blur"], a["inverse_lobe_fraction"]], axis=-1)
        self.lobes = texture(2, mi.TensorXf(stack.astype(np.float32)))
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

    def answer_factor(self, levels: Levels, exponent: Float, scale: Float) -> Float:
        """FlakeView::answer_factor(), of a smooth coat."""
        radius = self.typical_radius * scale
        lobes = 1 / dr.maximum(1, self._tables(exponent, radius)[1])
        bend = (exponent - 1) * radius * radius * (1 / 3)
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
        for count in cells:
            t = dr.clip((faded - count / self.full_cells) / (faded - 1), 0, 1)
            weights.append(t * t)
        first = sum(w * f for w, f in zip(weights, self.fraction, strict=True))
        second = sum(w * w * f for w, f in zip(weights, self.fraction, strict=True))
        none = second <= 0
        all_ = cells[0] <= self.full_cells
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
            return Flake(place, kind, x, y, 0.5e-3 * diameter, c["weight"], slope, lobe_radius)

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
        facing = dr.abs(wi.x * m.x + wi.y * m.y + wi.z)
        scale = self.widening(sec2, facing * dr.rsqrt(sec2))
        radius = SAMPLED_WIDENING * flake.lobe_radius * scale
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


class Sparkle(MeanFlakes):
    """The flakes of a patch in place of the mean of all: BoundNacre::FlakesOfPatch.

    Whoever goes through the flakes for a pair of directions learns on the way how likely each is to
    be drawn, and draws one. Where `shown` is false, the mean is seen.
    """

    def __init__(
        self, model: SparkleModel, patch: Footprint, i: Ray, active: Any, shown: Any
    ) -> None:
        self.model = model
        self.patch = patch
        self.i = i
        self.shown = shown
        self.active = mi.Bool(active) & shown
        self.outlines = [Outline(patch, f.smallest, f.largest) for f in model.fields]
        self.levels = [
            f.levels(outline) for f, outline in zip(model.fields, self.outlines, strict=True)
        ]
        resolved = mi.Float(0)
        for share, levels in zip(model.shares, self.levels, strict=True):
            resolved = dr.fma(share, levels.resolved, resolved)
        self.resolved = dr.select(self.shown, resolved, 0)
        # Of the last pair of directions that was asked: sums over the flakes that were met.
        self.densities: list[Float] = []
        self.met: Any = None
        # A flake is drawn while the first pair is asked.
        self.random: Any = None

    def start(self, random: Any = None) -> None:
        """Before the value of a pair. random: 32 bits with which a flake is drawn; None: none."""
        self.densities = []
        self.random = random
        self.met = {"chances": mi.Float(0)}
        if random is not None:
            self.met |= {"slope": mi.Vector2f(0, 0), "radius": mi.Float(1e-3)}

    def _meet(self, s: int) -> Callable[[Flake, Any, Any], Any]:
        field, outline, share = self.model.fields[s], self.outlines[s], self.model.shares[s]

        def meet(f: Flake, mask: Any, met: Any) -> Any:
            chance = dr.select(mask, share * self._chance(outline, f), 0)
            total = met["chances"] + chance
            if self.random is None:
                return {"chances": total}
            # Each takes the place of those before with the probability of its part of the sum.
            bits = mix_bits_32(self.random ^ f.place ^ u32(f.kind * mi.UInt32(SHORT_GOLDEN)))
            take = mask & (unit_fraction(bits) * total < chance)
            return {
                "chances": total,
                "slope": dr.select(take, f.slope, met["slope"]),
                "radius": dr.select(take, field.drawn_radius(self.i.inside, f), met["radius"]),
            }

        return meet

    @staticmethod
    def _chance(outline: Outline, f: Flake) -> Float:
        return f.weight * outline.rough_coverage(f.x, f.y, f.radius_mm)

    def survey(self) -> None:
        """Meets the flakes without a pair of directions."""
        for s, field in enumerate(self.model.fields):
            self.met, _ = field.visit(
                self.patch,
                self.outlines[s],
                self.levels[s],
                self.active,
                self._meet(s),
                self.met,
                lambda f: mi.Bool(False),
                lambda f, mask, state: state,
                (),
            )

    def factor(self, pair: Pair, layer: int, flake: int, depth: Wide) -> Wide | Float:
        model = self.model
        s = model.first_species[layer] + flake
        field, outline, levels = model.fields[s], self.outlines[s], self.levels[s]
        alpha2 = field.alpha * field.alpha
        exponent = pair.slope2 / alpha2
        reaches = exponent < MAX_EXPONENT
        scale = field.widening(1 + pair.slope2, pair.cosine)
        part = dr.select(reaches, field.answer_factor(levels, exponent, scale), 0)
        density = dr.inv_pi / alpha2 * dr.exp(-dr.minimum(exponent, MAX_EXPONENT))
        widest = field.max_width * field.alpha
        hot_spot = model.hot_spot
        spread = hot_spot.spread(pair) if hot_spot else None
        couplings = hot_spot.couplings(pair) if hot_spot else []
        films = model.films[s]

        def distance2(f: Flake) -> tuple[Float, Float]:
            dx, dy = f.slope.x - pair.slope.x, f.slope.y - pair.slope.y
            return dx * dx + dy * dy, dr.minimum(f.lobe_radius * scale, widest)

        def accept(f: Flake) -> Any:
            d2, width = distance2(f)
            drawn = field.drawn_radius(self.i.inside, f)
            return d2 < dr.maximum(width * width, drawn * drawn)

        def answer(f: Flake, mask: Any, state: Any) -> Any:
            reflected, drawn = state
            d2, width = distance2(f)
            y = width / field.alpha
            blur = dr.exp(y * y * field._tables(exponent, y)[0])
            fraction = f.weight * field.inverse_cover
            fraction *= outline.coverage(f.x, f.y, f.radius_mm)
            fraction *= field.lobe(d2, width) * part / (density * blur)
            bits = hash_of_two(f.place, f.kind)
            u = unit_float(mi.UInt32(u64(bits) & 0xFFFFFFFF))
            log: Wide = -u * depth
            if hot_spot:
                log += hot_spot.gain(pair, layer, u, spread, couplings)
            light = fraction * dr.exp(log)
            if films is not None:
                light *= films.ratio(mi.UInt32(bits >> 32), pair)
            chance = self._chance(outline, f)
            chance *= field.lobe(d2, field.drawn_radius(self.i.inside, f))
            return (
                reflected + dr.select(mask & reaches, light, 0),
                drawn + dr.select(mask, chance, 0),
            )

        self.met, (reflected, drawn) = field.visit(
            self.patch,
            outline,
            levels,
            self.active,
            self._meet(s),
            self.met,
            accept,
            answer,
            (model.smooth.bands.constant(0), mi.Float(0)),
        )
        self.densities.append(model.shares[s] * drawn)
        background = 1 - levels.resolved * part
        mean = hot_spot.mean(pair, layer, depth) if hot_spot else 1
        return dr.select(self.shown, background * mean + reflected / mean_escape(depth), mean)

    def rest_factor(self, pair: Pair, layer: int, depth: Wide) -> Wide | Float:
        return self.model.mean.rest_factor(pair, layer, depth)

    def multiple(self, pair: Pair, value: Wide) -> Wide:
        return self.model.mean.multiple(pair, value)

    @property
    def any(self) -> Any:
        """Whether a flake was met."""
        return self.met["chances"] > 0

    def density(self, pair: Pair) -> Float:
        """Per solid angle outside, of draw(); after the value of this pair."""
        ratio = pair.o.outside.z / (self.model.smooth.mean_ior**2 * pair.o.inside.z)
        total = mi.Float(0)
        for density in self.densities:
            total = total + density
        slopes = dr.select(self.any, total / self.met["chances"], 0)
        return dr.detach(slopes * pair.slopes_per_solid_angle * ratio)

    def draw(self, u: Any) -> Any:
        """A direction from the lobe of the flake that was drawn."""
        # The inverse of 1 - (1 - r^2/w^2)^3.
        root = dr.power(dr.maximum(1 - u.x, 1e-12), 1 / 3)
        r = self.met["radius"] * dr.sqrt(dr.maximum(1 - root, 0))
        sin, cos = dr.sincos(2 * dr.pi * u.y)
        slope = self.met["slope"]
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

        self.table = Table(smooth.bands, source, rows)

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
        self.hot_spot = HotSpot(smooth, a) if a["hot_spot"] is not None else None
        self.mean = self.hot_spot or MeanFlakes()
        self.fields = [Field(a, species) for species in a["species"]]
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
        self.shares = [float(c) / total for c in cover]
        self.first_species = [0]
        for layer in a["layers"]:
            self.first_species.append(self.first_species[-1] + len(layer["flakes"]))
