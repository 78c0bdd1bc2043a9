"""The hot spot of large flakes: light that came in through a gap finds it again on its way out.

What stands here is src/nacre/bsdf/models/hot_spot.h.                       [kuusk-1985]
"""

from __future__ import annotations

import drjit as dr
import mitsuba as mi
import numpy as np

from ._bands import Arrays, Float, Source, Wide
from ._microflake import MeanFlakes, Microflake, Pair, mean_escape

NODES = 10
"""Of the quadrature over depth, densest at the top: relative error below 2e-3."""


MAX_GAIN = 40
"""Of what is exponentiated: kMaxGain of hot_spot.h."""


def overlap_integral(x: Float) -> Float:
    """Int_0^x O(xi) dxi, O the overlap of two discs; 4 / (3 pi) from x = 1 on."""
    x = dr.minimum(x, 1)
    chord2 = 1 - x * x
    chord = dr.sqrt(dr.maximum(chord2, 0))
    return (2 / dr.pi) * (x * dr.safe_acos(x) - chord + chord * chord2 * (1 / 3) + 2 / 3)


class HotSpot(MeanFlakes):
    """The mean of all flakes, with the hot spot."""

    def __init__(self, smooth: Microflake, source: Source) -> None:
        self.smooth = smooth
        self.species: list[tuple[int, Float]] = []
        for n, species in enumerate(source.base["hot_spot"]["species"]):

            def diameter(arrays: Arrays, n: int = n) -> float:
                return float(arrays["hot_spot"]["species"][n]["diameter_um"])

            self.species.append((int(species["layer"]), source.number(diameter)))
        # With their gradients.
        self.thickness = [thickness for thickness, _, _ in smooth.layers]
        self.top: list[Float] = [mi.Float(0)]
        for thickness in self.thickness:
            self.top.append(self.top[-1] + thickness)
        nodes, weights = np.polynomial.legendre.leggauss(NODES)
        s = 0.5 * (nodes + 1)
        # u = s^2, du = 2 s ds: light of a deep layer comes from its top.
        self.nodes = (s * s).tolist()
        self.weights = (weights * s).tolist()  # half the interval's weight, times 2 s

    def spread(self, pair: Pair) -> Float:
        """delta: how far apart both rays are after a step in height, over the step."""
        i, o = pair.i.inside, pair.o.inside
        x, y = i.x / i.z - o.x / o.z, i.y / i.z - o.y / o.z
        square, coat = x * x + y * y, self.smooth.coat
        apart = coat.separation(square, i.z, o.z) if coat.rough else dr.sqrt(square)
        return dr.clip(apart, 1e-4, 1e6)

    def couplings(self, pair: Pair) -> list[Wide]:
        of = self.smooth.directions.of
        return [
            of(pair.i, f"coupling {n}") * of(pair.o, f"coupling {n}")
            for n in range(len(self.species))
        ]

    def gain(self, pair: Pair, layer: int, u: Float, spread: Float, couplings: list[Wide]) -> Wide:
        """ln V + kappa z, at the fraction u = z / H of the layer's thickness."""
        total: Wide = self.smooth.bands.constant(0)
        for (own, diameter), coupling in zip(self.species, couplings, strict=True):
            if own > layer:
                break
            step = spread / diameter
            far = u * self.thickness[layer] + (self.top[layer] - self.top[own])
            shared = overlap_integral(far * step)
            if own < layer:
                near = dr.maximum(far - self.thickness[own], 0)
                shared -= overlap_integral(near * step)
            total += coupling * (shared / step)
        return total

    def mean(self, pair: Pair, layer: int, depth: Wide) -> Wide:
        """Of V, over that of exp(-kappa z), for a layer of this optical depth."""
        spread, couplings = self.spread(pair), self.couplings(pair)
        # What comes from below 24 optical depths is 6e-6 of the whole.
        reach = dr.minimum(1, 24 / dr.maximum(dr.min(depth), 1e-20))
        total: Wide = self.smooth.bands.constant(0)
        for node, weight in zip(self.nodes, self.weights, strict=True):
            u = reach * node
            gain = self.gain(pair, layer, u, spread, couplings)
            total += weight * dr.exp(dr.minimum(gain - depth * u, MAX_GAIN))
        return total * reach / mean_escape(depth)

    def factor(self, pair: Pair, layer: int, flake: int, depth: Wide) -> Wide | Float:
        return self.mean(pair, layer, depth)

    def rest_factor(self, pair: Pair, layer: int, depth: Wide) -> Wide | Float:
        return self.mean(pair, layer, depth)

    def multiple(self, pair: Pair, value: Wide) -> Wide:
        tables = self.smooth.directions
        if not tables.has("compensation"):
            return value
        compensation = tables.of(pair.i, "compensation") * tables.of(pair.o, "compensation")
        if not tables.has("ground"):
            return compensation * value
        once = tables.of(pair.i, "ground") * tables.of(pair.o, "ground")
        gain = self.gain(
            pair, len(self.thickness) - 1, mi.Float(1), self.spread(pair), self.couplings(pair)
        )
        return compensation * dr.maximum(value - once, 0) + dr.exp(dr.minimum(gain, MAX_GAIN)) * once
