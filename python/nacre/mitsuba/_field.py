"""What the flakes of one species have in common: their statistics and their lobes.

What stands here is src/nacre/sparkle/flake_field.h, flake_view.h and diffraction_lobe.h.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import drjit as dr
import mitsuba as mi
import numpy as np

from ._bands import Arrays, Float, single, texture
from ._coat import CoatTilt
from ._patch import Outline

MAX_EXPONENT = 14.0
MIN_COSINE = 0.1
SAMPLED_WIDENING = 1.1
LOBE_POWER = 0.92
"""kLobePower: the fraction of a flake's light that its lobe holds."""


@dataclass
class Levels:
    """How the levels of density take part on a patch: FlakeField::level_weights()."""

    weight: list[Float]
    resolved: Float
    widening: Float


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


def added_radius2(spread2: Float) -> Float:
    """DiffractionLobe::spread_radius2()."""
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
        self.log_blur = texture(2, mi.TensorXf(single(a["log_blur"][..., np.newaxis])))
        inverse = a["inverse_lobe_fraction"]
        self.inverse_fraction = texture(2, mi.TensorXf(single(inverse[..., np.newaxis])))
        self.nodes = inverse.shape
        self.max_width = 4.0

    # DiffractionLobe

    def _place(self, exponent: Float, width: Float) -> Any:
        """In the textures; width over alpha."""
        widths, squares = self.nodes
        x = dr.minimum(exponent * ((squares - 1) / MAX_EXPONENT), squares - 1.001)
        y = dr.minimum(width * ((widths - 1) / self.max_width), widths - 1.001)
        return mi.Point2f(
            dr.fma(x, 1 / squares, 0.5 / squares), dr.fma(y, 1 / widths, 0.5 / widths)
        )

    def blur(self, exponent: Float, width: Float) -> Float:
        """DiffractionLobe::blur(), width over alpha."""
        return dr.exp(width * width * self.log_blur.eval(self._place(exponent, width))[0])

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

    def resolved_factor(
        self, levels: Levels, exponent: Float, scale: Float, spread2: Float | None
    ) -> Float:
        """FlakeView::resolved_factor(); spread2: None where diffraction alone spreads light."""
        radius = self.typical_radius * scale
        radius2 = radius * radius
        if spread2 is None:
            inverse = self.inverse_fraction.eval(self._place(exponent, radius))[0]
        else:
            relative = spread2 / (self.alpha * self.alpha)
            narrower = 1 / (1 + relative)
            power = dr.maximum(LOBE_POWER, 1 - 0.2 * dr.rsqrt(dr.maximum(relative / radius2, 1e-9)))
            place = self._place(exponent * narrower, radius * dr.sqrt(narrower))
            inverse = self.inverse_fraction.eval(place)[0]
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

    def drawn_radius(self, wi: Any, flake: Flake, levels: Levels) -> Float:
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
            wider = SAMPLED_WIDENING * levels.widening
            radius = dr.sqrt(radius * radius + wider * wider * added_radius2(spread2))
        return dr.minimum(radius, self.max_width * self.alpha)

    def diameter(self, kind: Any) -> Float:
        """In um."""
        if self.one_size is not None:
            return mi.Float(self.one_size)
        size = kind >> 24
        if mi.Float is float:
            return self.diameters[size]
        return dr.gather(mi.Float, self.diameters, size)
