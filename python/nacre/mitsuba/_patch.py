"""The piece of a surface that a sample looks at, and the planes of cells behind it.

What stands here is src/nacre/sparkle/patch_outline.h and flake_plane.h.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import drjit as dr
import mitsuba as mi

from ._bands import Float
from ._bits import GOLDEN, no

MAX_STRETCH = 1.5811388
"""kMaxStretch: flakes per area of a plane of cells over flakes per area of the surface."""
PROJECTION_BLEND = 0.1


def smaller(a: Float, b: Float) -> Float:
    """dr.minimum() of what is no NaN: a third of the cost."""
    return dr.select(a < b, a, b)


def larger(a: Float, b: Float) -> Float:
    """dr.maximum() of what is no NaN."""
    return dr.select(a > b, a, b)


def within(x: Float, low: Float, high: Float) -> Float:
    """dr.clip() of what is no NaN."""
    return larger(smaller(x, high), low)


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

    def rough_overlap(self, x: Float, y: Float, radius: Float) -> Float:
        """Area shared with a disc, in mm^2: within a factor of two for most, at a tenth of the cost
        of coverage(). Positive where the disc touches both strips that cross in the patch, else 0.
        """
        area = mi.Float(1)
        for normal, half in self.strip:
            inside = half + radius - dr.abs(x * normal.x + y * normal.y)
            area *= within(inside, 0, 2 * smaller(half, radius))
        return area

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
            chord = dr.sqrt(larger(radius2 - distance * distance, 0))
            c0, c1 = within(t0, -chord, chord), within(t1, -chord, chord)
            off = dr.select(distance == 0, 1e-30, distance)
            inside &= off > 0
            triangles += distance * (c1 - c0)
            sectors += dr.atan2(off * (c1 - c0), off * off + c0 * c1)
        full = dr.select(inside, 2 * dr.pi, 0)
        return dr.maximum(0.5 * (triangles + radius2 * (full - sectors)), 0)


@dataclass
class Axis:
    """Of a plane of cells: FlakePlane::Axis."""

    first: Any
    """Of the cells of the finest level that the patch may touch."""
    last: Any
    corner: Float
    """Of the first, from the middle of the patch, in mm."""
    step: Any
    """In the plane of the patch, for one along the axis."""

    @staticmethod
    def through(at: Float, half: Float, step: Any, cell_mm: float) -> Axis:
        at = mi.Float64(at)
        first = mi.Int32(dr.floor((at - mi.Float64(half)) / cell_mm))
        last = mi.Int32(dr.floor((at + mi.Float64(half)) / cell_mm))
        return Axis(first, last, mi.Float(mi.Float64(first) * cell_mm - at), step)


@dataclass
class Plane:
    """A plane of cells as a patch sees it: FlakePlane."""

    key: Any
    """Of its cells, beside that of a level."""
    fraction: Float
    """Of the flakes; 0 where the plane gives none."""
    kept: Float
    u: Axis
    v: Axis
    turn: Any

    @staticmethod
    def through(
        patch: Footprint, outline: Outline, axis: int, fraction: Float, cell_mm: float
    ) -> Plane:
        n, t, b = patch.normal, outline.tangent, outline.bitangent
        across = dr.select(dr.abs(n[axis]) < 1e-6, 1e-6, n[axis])

        def make(i: int) -> Axis:
            shear = n[i] / across
            half = 0.5 * (dr.abs(patch.edge_1_mm[i]) + dr.abs(patch.edge_2_mm[i]))
            half += outline.reach * dr.sqrt(dr.maximum(1 - n[i] * n[i], 0))
            step = mi.Vector2f(t[i] - shear * t[axis], b[i] - shear * b[axis])
            return Axis.through(patch.position_mm[i], half, step, cell_mm)

        def side_key(side: int) -> Any:
            return mi.UInt64(side * GOLDEN % 2**64)

        first = (axis + 1) % 3
        turn = dr.normalize(mi.Vector2f(t[first], b[first]))
        return Plane(
            dr.select(n[axis] < 0, side_key(2 * axis + 1), side_key(2 * axis)),
            fraction,
            fraction * dr.abs(1 / across) * (65536 / MAX_STRETCH),
            make(first),
            make((axis + 2) % 3),
            turn,
        )


def planes_of(patch: Footprint, outline: Outline, cell_mm: float) -> list[Plane]:
    """The three planes across the axes, of which one to three give flakes: projections_of().

    cell_mm: side of the finest cells
    """
    n = patch.normal
    squares = [n[axis] * n[axis] for axis in range(3)]
    largest = dr.maximum(dr.maximum(squares[0], squares[1]), squares[2])
    weights = [dr.maximum(s - largest + PROJECTION_BLEND, 0) for s in squares]
    total = weights[0] + weights[1] + weights[2]
    return [
        Plane.through(patch, outline, axis, weights[axis] / total, cell_mm) for axis in range(3)
    ]
