"""The cells of a species that touch a patch, and the flakes in them.

What stands here is FlakeField::look() in src/nacre/sparkle/flake_field.cpp, which lists flakes in
memory of its own. Dr.Jit has none inside the functions of a BSDF.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from typing import Any

import drjit as dr
import mitsuba as mi

from ._bands import Float
from ._bits import (
    SHORT_GOLDEN,
    first_bit,
    gaussian_slopes,
    mix_bits,
    mix_bits_32,
    u32,
    u64,
    unit_float,
    unit_fraction,
)
from ._field import Field, Flake, Levels
from ._patch import Axis, Footprint, Outline, Plane, planes_of

BATCH = 4
"""Flakes of a cell that are looked at together; it has up to four on average."""
KEPT = 16
"""Batches of a round, which are kept until their flakes are asked; these are a bit each of 64."""
ROUNDS = 3
"""Of batches that are kept from one pair of directions to the next."""
ABREAST = 2
"""Flakes that are considered together, as processors work on several chains of operations."""
NO_PLANE = 3

Place = tuple[Any, Any, Any, Any]
"""Where a batch is in a plane: level, column and row of the cell, from the first that the patch may
touch, and number of the first flake."""


@dataclass
class Batch:
    """What flakes of a cell have in common."""

    first: Any
    """Number of the first flake."""
    number: Any
    """Of flakes in the cell."""
    low_key: Any
    high_key: Any
    corner: Any
    """Of the cell, in the plane of the patch."""
    step_u: Any
    step_v: Any
    """2^-16 of the cell's sides there."""
    turn: Any
    kept: Float
    weight: Float
    """Of the level."""


@dataclass
class Round:
    """Batches of flakes that touch the patch, as many as are kept at a time."""

    plane: Any
    """Its number."""
    codes: list[Any]
    """Places."""
    weights: list[Float]
    """Of the flakes of each, in sum."""
    flakes: Any
    """That touch the patch: a bit each."""
    next_plane: Any
    next_place: Place
    """Where to look for more."""
    total: Float
    """Of the weights of all flakes, up to there."""


class Cells:
    """Those whose flakes may touch a patch, plane by plane and level by level."""

    def __init__(
        self, field: Field, patch: Footprint, outline: Outline, levels: Levels, active: Any
    ) -> None:
        self.field = field
        self.outline = outline
        self.levels = levels
        self.planes = planes_of(patch, outline, field.cell_mm[0])
        self.finest = len(field.cell_mm)
        level = mi.Int32(0)
        for n in range(self.finest - 1):
            level = dr.select((level == n) & (levels.weight[n] <= 0), n + 1, level)
        self.first_place: Place = level, mi.Int32(0), mi.Int32(0), mi.Int32(0)
        self.seen = active & (levels.resolved > 0)
        self.known: list[Round] = []

    # Choices

    def _plane(self, p: Any) -> Plane:
        """The plane of this number."""
        x, y, z = self.planes
        chosen: Plane = dr.select(p == 0, x, dr.select(p == 1, y, z))
        return chosen

    def _next_plane(self, p: Any) -> Any:
        """The number of the next plane that gives flakes, or NO_PLANE."""
        p = p + 1
        for n in range(NO_PLANE):
            p = dr.select((p == n) & (self.planes[n].fraction <= 0), n + 1, p)
        return p

    @staticmethod
    def _of(number: Any, values: Sequence[Any]) -> Any:
        """That of a level, or of a batch that was kept."""
        chosen = values[-1]
        for n in reversed(range(len(values) - 1)):
            chosen = dr.select(number == n, values[n], chosen)
        return chosen

    @staticmethod
    def _choice(u: Float, weights: Sequence[Float]) -> Any:
        """The number of a weight, by their parts of the sum; never of one that is 0 where any is
        not."""
        total = sum(weights, start=mi.Float(0))
        chosen, before = mi.Int32(0), mi.Float(0)
        for n, weight in enumerate(weights):
            chosen = dr.select((weight > 0) & (u * total >= before), n, chosen)
            before = before + weight
        return chosen

    # From batch to batch

    def _next_place(self, plane: Plane, at: Place, number: Any) -> Place:
        """After a batch of a cell of so many flakes; behind the last one the level is `finest`."""
        level, u, v, first = at
        shift = 2 * level  # sides double twice from level to level
        first = first + BATCH
        next_cell = first >= number
        first = dr.select(next_cell, 0, first)
        u = dr.select(next_cell, u + 1, u)
        next_row = u > (plane.u.last >> shift) - (plane.u.first >> shift)
        u = dr.select(next_row, 0, u)
        v = dr.select(next_row, v + 1, v)
        next_level = v > (plane.v.last >> shift) - (plane.v.first >> shift)
        v = dr.select(next_level, 0, v)
        return dr.select(next_level, level + 1, level), u, v, first

    @staticmethod
    def _code(at: Place) -> Any:
        """A place in 32 bits. A patch touches up to about a hundred cells of a level."""
        level, u, v, first = (mi.UInt32(x) for x in at)
        return u | (v << 10) | (first << 20) | (level << 26)

    @staticmethod
    def _place_of(code: Any) -> Place:
        fields = (code >> 26, code & 1023, (code >> 10) & 1023, (code >> 20) & 63)
        level, u, v, first = (mi.Int32(x) for x in fields)
        return level, u, v, first

    # Flakes of a batch

    def _enter(self, plane: Plane, at: Place) -> Batch:
        field = self.field
        level, u, v, first = at
        key = u64(self._of(level, [mi.UInt64(k) for k in field.key]) + plane.key)
        shift = 2 * level
        cell_u, cell_v = (plane.u.first >> shift) + u, (plane.v.first >> shift) + v
        key = mix_bits(key ^ (u64(mi.UInt64(_bits(cell_v)) << 32) | mi.UInt64(_bits(cell_u))))
        high_key = mi.UInt32(key >> 32)
        draw = unit_float(high_key)
        number = mi.Int32(0)
        for bound in field.cumulative:
            number = dr.select(draw >= bound, number + 1, number)
        finest = field.cell_mm[0]
        size = mi.Float(mi.Int32(1) << shift) * finest

        def corner(axis: Axis, cell: Any) -> Float:
            return axis.corner + mi.Float((cell << shift) - axis.first) * finest

        corner_u, corner_v = corner(plane.u, cell_u), corner(plane.v, cell_v)
        grain = size * 2.0**-16
        return Batch(
            first=first,
            number=number,
            low_key=mi.UInt32(u64(key) & 0xFFFFFFFF),
            high_key=high_key,
            corner=plane.u.step * corner_u + plane.v.step * corner_v,
            step_u=plane.u.step * grain,
            step_v=plane.v.step * grain,
            turn=plane.turn,
            kept=plane.kept,
            weight=self._of(level, self.levels.weight),
        )

    def _place(self, b: Batch, n: Any) -> tuple[Any, Any, Float, Float, Float]:
        """Bits, centre in the plane of the patch, and diameter of the flake n of a batch."""
        step = u32(mi.UInt32(b.first + (n + 1)) * mi.UInt32(SHORT_GOLDEN))
        place = mix_bits_32(u32(b.low_key + step))
        kind = mix_bits_32(u32(b.high_key + step))
        grains_u, grains_v = mi.Float(place & 0xFFFF), mi.Float(place >> 16)
        at = b.corner + b.step_u * grains_u + b.step_v * grains_v
        return place, kind, at.x, at.y, self.field.diameter(kind)

    def _flake(self, b: Batch, n: Any) -> Flake:
        place, kind, x, y, diameter = self._place(b, n)
        s, t = gaussian_slopes(place, kind)
        alpha, turn = self.field.alpha, b.turn
        slope = mi.Vector2f(alpha * (turn.x * s - turn.y * t), alpha * (turn.y * s + turn.x * t))
        lobe_radius = self.levels.widening * (self.field.radius_um / diameter)
        return Flake(place, kind, x, y, 0.5e-3 * diameter, b.weight, slope, lobe_radius)

    def _weight(self, f: Flake) -> Float:
        """What draw() takes a flake by: what it shares with the patch, roughly."""
        return f.weight * self.outline.rough_overlap(f.x, f.y, f.radius_mm)

    def _weights(self, b: Batch) -> list[Float]:
        """Of each flake of a batch; 0 of those that do not touch the patch.

        They do not wait for each other, as processors work on several chains of operations at a
        time.
        """
        weights = []
        for n in range(BATCH):
            _, kind, x, y, diameter = self._place(b, n)
            there = (b.first + n < b.number) & (mi.Float(kind & 0xFFFF) < b.kept)
            weight = b.weight * self.outline.rough_overlap(x, y, 0.5e-3 * diameter)
            weights.append(dr.select(there, weight, 0))
        return weights

    # Round after round

    def _start(self) -> Round:
        """Before the first round."""
        return Round(
            plane=mi.Int32(0),
            codes=[mi.UInt32(0) for _ in range(KEPT)],
            weights=[mi.Float(0) for _ in range(KEPT)],
            flakes=mi.UInt64(0),
            next_plane=dr.select(self.seen, self._next_plane(mi.Int32(-1)), NO_PLANE),
            next_place=self.first_place,
            total=mi.Float(0),
        )

    def _collect(self, before: Round, wanted: Any) -> Round:
        """The next batches, of one plane; none where they are not wanted."""
        plane = self._plane(before.next_plane)
        more = wanted & (before.next_plane < NO_PLANE)

        def look(at: Place, count: Any, kept: Round) -> Any:
            batch = self._enter(plane, at)
            weights = self._weights(batch)
            here = sum(weights, start=mi.Float(0))
            bits = mi.UInt32(0)
            for n, weight in enumerate(weights):
                bits |= dr.select(weight > 0, mi.UInt32(1 << n), mi.UInt32(0))
            code = self._code(at)
            kept = replace(
                kept,
                codes=[dr.select(count == n, code, c) for n, c in enumerate(kept.codes)],
                weights=[dr.select(count == n, here, w) for n, w in enumerate(kept.weights)],
                flakes=kept.flakes | (mi.UInt64(bits) << mi.UInt64(BATCH * count)),
                total=kept.total + here,
            )
            count = dr.select(bits != 0, count + 1, count)
            return self._next_place(plane, at, batch.number), count, kept

        kept: Round
        at, _, kept = dr.while_loop(
            (
                before.next_place,
                mi.UInt32(0),
                replace(
                    before,
                    plane=before.next_plane,
                    weights=[mi.Float(0) for _ in range(KEPT)],
                    flakes=mi.UInt64(0),
                ),
            ),
            lambda at, count, kept: more & (at[0] < self.finest) & (count < KEPT),
            look,
        )
        # Behind the last place of a plane, the first of the next one.
        done = at[0] >= self.finest
        places = [dr.select(done, a, b) for a, b in zip(self.first_place, at, strict=True)]
        next_plane = dr.select(done, self._next_plane(kept.next_plane), kept.next_plane)
        return replace(kept, next_plane=next_plane, next_place=tuple(places))

    def _each_round(self, use: Callable[[Round, Any], Any], state: Any) -> tuple[Any, Float]:
        """state = use(round, state) for all rounds, and the sum of the weights of all flakes.

        The first rounds, for most patches the only ones, are kept for who asks next.
        """

        def go_on(found: Round) -> Any:
            return (found.next_plane < NO_PLANE) | (found.flakes != 0)

        if self.known:
            known = self.known

            def next_round(found: Round, n: Any, state: Any) -> Any:
                state = use(found, state)
                n = n + 1
                found = self._collect(found, n >= ROUNDS)
                for k in range(1, ROUNDS):
                    found = dr.select(n == k, known[k], found)
                return found, n, state

            found, _, state = dr.while_loop(
                (known[0], mi.UInt32(0), state), lambda found, n, _: go_on(found), next_round
            )
            return state, found.total

        def next_of_all(found: Round, known: list[Round], n: Any, state: Any) -> Any:
            state = use(found, state)
            found = self._collect(found, mi.Bool(True))
            known = [dr.select(n == k, found, r) for k, r in enumerate(known)]
            return found, known, n + 1, state

        found, self.known, _, state = dr.while_loop(
            (self._start(), [self._start() for _ in range(ROUNDS)], mi.UInt32(0), state),
            lambda found, known, n, state: go_on(found),
            next_of_all,
        )
        return state, found.total

    # What others ask for

    def draw(self, random: Any) -> tuple[Flake, Float]:
        """One of the flakes that touch the patch, by what it shares with it; and the sum of what
        all share, of which each has its part as its probability.

        random: 32 bits
        """

        def choose(found: Round, drawn: Any) -> Any:
            """A batch of this round takes the place of those before with the probability of its
            part of the sum.                                                        [chao-1982]"""
            chosen, plane, last = drawn
            bits = mix_bits_32(u32(last + mi.UInt32(SHORT_GOLDEN)))
            here = sum(found.weights, start=mi.Float(0))
            n = self._choice(unit_float(bits), found.weights)
            take = unit_fraction(mix_bits_32(bits)) * found.total < here
            chosen = dr.select(take, self._of(n, found.codes), chosen)
            # Not before the first round.
            last = dr.select(found.flakes != 0, bits, last)
            return chosen, dr.select(take, found.plane, plane), last

        (chosen, plane, _), total = self._each_round(
            choose, (mi.UInt32(0), mi.Int32(0), mi.UInt32(random))
        )
        batch = self._enter(self._plane(plane), self._place_of(chosen))
        n = self._choice(unit_float(mix_bits_32(random)), self._weights(batch))
        return self._flake(batch, n), total

    def visit(
        self,
        accept: Callable[[Flake], Any],
        answer: Callable[[Flake, Float, Any], Any],
        answered: Any,
    ) -> tuple[Any, Float]:
        """Goes through the flakes that touch the patch (FlakeField::look()).

        answered = answer(flake, weight, answered) for those that accept(flake) lets pass; weight:
        by which draw() takes this flake. Returned with it is the sum of the weights of all.

        Samples that are worked on together wait for each other wherever they loop, and most cells
        have no flake that touches the patch, most flakes do not pass. So batches that have some are
        collected first, then the flakes that pass, and what is costly comes last.
        """

        def ask(found: Round, answered: Any) -> Any:
            plane = self._plane(found.plane)

            def flake_of(flakes: Any) -> Flake:
                """The first of them."""
                n = mi.UInt32(first_bit(flakes))
                place = self._place_of(self._of(n // BATCH, found.codes))
                return self._flake(self._enter(plane, place), mi.Int32(n % BATCH))

            def consider(flakes: Any, accepted: Any) -> Any:
                for _ in range(ABREAST):
                    others = flakes & (flakes - 1)
                    passes = accept(flake_of(flakes))
                    accepted = accepted | dr.select(passes, flakes ^ others, mi.UInt64(0))
                    flakes = others
                return flakes, accepted

            def take(flakes: Any, answered: Any) -> Any:
                flake = flake_of(flakes)
                return flakes & (flakes - 1), answer(flake, self._weight(flake), answered)

            def some(flakes: Any, state: Any) -> Any:
                return flakes != 0

            _, accepted = dr.while_loop((found.flakes, mi.UInt64(0)), some, consider)
            _, answered = dr.while_loop((accepted, answered), some, take)
            return answered

        return self._each_round(ask, answered)


def _bits(x: Any) -> Any:
    """The two's complement of an integer, in 32 bits."""
    return x & 0xFFFFFFFF if mi.Float is float else mi.UInt32(x)
