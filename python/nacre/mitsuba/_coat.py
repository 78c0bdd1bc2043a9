"""How a rough clear coat, of facets much smaller than a flake, turns light on its way to the flakes
and back.

What stands here is src/nacre/sparkle/coat_tilt.h.
"""

from __future__ import annotations

import drjit as dr

from ._bands import Float

MIN_SUM = 0.1


class CoatTilt:
    """Cosines are those inside a smooth coat."""

    def __init__(self, rough: bool, roughness: Float, ior: Float) -> None:
        self.rough = rough
        self.roughness2 = roughness * roughness
        self.beyond = 1 - 1 / (ior * ior)

    def _k(self, mu: Float) -> Float:
        return mu - dr.sqrt(dr.maximum(mu * mu - self.beyond, 0))

    def spread2(self, mu_i: Float, mu_o: Float) -> Float:
        """The square of the alpha by which half vectors are spread."""
        k_i, k_o = self._k(mu_i), self._k(mu_o)
        both = dr.maximum(mu_i + mu_o, MIN_SUM)
        return self.roughness2 * (k_i * k_i + k_o * k_o) / (both * both)

    def separation(self, square: Float, mu_i: Float, mu_o: Float) -> Float:
        """Mean distance between the tangents of the way in and the way out.

        square: of the distance under a smooth coat.
        """

        def of(mu: Float) -> Float:
            secant2 = 1 / dr.square(dr.maximum(mu, MIN_SUM))
            return dr.square(self._k(mu)) * secant2 * 0.25 * (1 + secant2 * secant2)

        variance = dr.maximum(self.roughness2 * (of(mu_i) + of(mu_o)), 1e-12)
        more = dr.pi / 2 - 1
        return dr.sqrt(square + variance * (1 + more / (1 + 0.5 * square / variance)))
