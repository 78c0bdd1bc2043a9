"""How directions are drawn from the micro-flake model, in Dr.Jit.

In place of the tables of src/nacre/bsdf/models/microflake_sampling.cpp, lobes in closed form.
"""

from __future__ import annotations

from typing import Any

import drjit as dr
import mitsuba as mi
import numpy as np

from ._bands import Arrays, Float, by_direction, column_texture
from ._microflake import Ray, Vector


def refract_out(w: Vector, ior: float) -> Vector:
    """The direction outside of one inside; below the horizon beyond the critical angle."""
    if ior == 1:
        return w
    x, y = ior * w.x, ior * w.y
    z2 = 1 - x * x - y * y
    z = dr.select((w.z > 0) & (z2 > 0), dr.sqrt(dr.maximum(z2, 0)), -1)
    return mi.Vector3f(x, y, z)


class FlakeLobe:
    """Reflection off Beckmann flakes that are visible from wi (bsdf::FlakeLobe)."""

    def __init__(self, alpha: Float) -> None:
        self.alpha = alpha

    def sample(self, wi: Vector, u_sign: Float, u: Any) -> Vector:
        s = dr.sqrt(wi.x * wi.x + wi.y * wi.y)
        r = self.alpha * dr.sqrt(-dr.log(1 - u.x))
        sin, cos = dr.sincos(2 * dr.pi * u.y)
        x, y = r * cos, r * sin
        x = dr.select((x > 0) & (u_sign * wi.z < x * s), -x, x)
        safe = dr.select(s > 0, s, 1)
        ex, ey = dr.select(s > 0, wi.x / safe, 1), wi.y / safe
        m = dr.normalize(mi.Vector3f(-(x * ex - y * ey), -(x * ey + y * ex), 1))
        return 2 * dr.dot(wi, m) * m - wi

    def pdf(self, wi: Vector, wo: Vector) -> Float:
        h = wi + wo
        inverse = dr.rcp(h.z)
        tan2 = (h.x * h.x + h.y * h.y) * inverse * inverse
        tilt = (h.x * wi.x + h.y * wi.y) * inverse * dr.rcp(wi.z)
        exponent = dr.minimum(tan2 / (self.alpha * self.alpha), 80)
        return (
            dr.exp(-exponent)
            * (dr.inv_pi / (self.alpha * self.alpha))
            * dr.clip(1 + tilt, 0, 2)
            * (1 + tan2)
            * 0.5
            * inverse
        )


class Sampling:
    """The interface, flakes that are seen from wi, a lobe three times as rough, and evenly."""

    def __init__(self, a: Arrays) -> None:
        self.mean_ior = float(a["mean_ior"])
        self.rough = float(a["coat_roughness"])
        weights, alphas = [], []
        for layer in a["layers"]:
            for flake in layer["flakes"]:
                weights.append(flake["area_density_per_um"] * layer["thickness_um"])
                alphas.append(flake["alpha"])
        alpha = float(np.average(alphas, weights=weights)) if alphas else 0.3
        if self.rough > 0:
            alpha = float(np.hypot(alpha, 0.5 * self.rough))
        self.lobes = FlakeLobe(alpha), FlakeLobe(min(3 * alpha, 0.8))
        self.coat_lobe = FlakeLobe(self.rough)
        p = a["probability"].astype(np.float64)
        interface, table, diffuse, single = p.T
        narrow, wide = table * single * 0.9, table * (single * 0.1 + (1 - single) * 0.4)
        even = diffuse + table * (1 - single) * 0.6
        probabilities = np.stack([interface, narrow, wide, even], axis=-1)
        self.probability_table = column_texture(probabilities)

    def probabilities(self, ray: Ray, specular: bool, rest: bool) -> tuple[Float, ...]:
        """Of the interface, both lobes of flakes, and evenly; they add up to 1."""
        p = by_direction(self.probability_table, ray.x)
        interface, narrow, wide, even = (dr.detach(x) for x in p)
        if not rest:
            return (mi.Float(1), *(mi.Float(0),) * 3)
        if not specular and self.rough == 0:
            interface = mi.Float(0)
        scale = dr.rcp(interface + narrow + wide + even)
        return interface * scale, narrow * scale, wide * scale, even * scale

    def density(self, probabilities: tuple[Float, ...], i: Ray, o: Ray) -> Float:
        """Per solid angle outside, of draw() with these probabilities."""
        interface, narrow, wide, even = probabilities
        ratio = o.outside.z / (self.mean_ior * self.mean_ior * o.inside.z)
        flakes = narrow * self.lobes[0].pdf(i.inside, o.inside) + wide * self.lobes[1].pdf(
            i.inside, o.inside
        )
        density = flakes * ratio + even * dr.inv_pi * o.outside.z
        if self.rough > 0:
            density += interface * self.coat_lobe.pdf(i.outside, o.outside)
        return density

    def draw(self, probabilities: tuple[Float, ...], i: Ray, u: Float, u2: Any) -> Vector:
        """A direction outside, by all but a smooth interface; below the horizon where none leaves.

        u: uniform in [0, 1), which selects.
        """
        interface, narrow, wide, _ = probabilities
        sum_narrow = interface + narrow
        sum_wide = sum_narrow + wide
        is_narrow = u < sum_narrow
        lobe = FlakeLobe(dr.select(is_narrow, self.lobes[0].alpha, self.lobes[1].alpha))
        low = dr.select(is_narrow, interface, sum_narrow)
        span = dr.select(is_narrow, narrow, wide)
        inside = lobe.sample(i.inside, (u - low) / dr.maximum(span, 1e-12), u2)
        wo = dr.select(
            u < sum_wide,
            refract_out(inside, self.mean_ior),
            mi.warp.square_to_cosine_hemisphere(u2),
        )
        if self.rough > 0:
            facet = self.coat_lobe.sample(i.outside, u / dr.maximum(interface, 1e-12), u2)
            wo = dr.select(u < interface, facet, wo)
        return wo
