"""Random bits of flakes, in Dr.Jit's integers.

In scalar variants these are Python's integers and masks, which neither wrap around nor know ~.
"""

from __future__ import annotations

from typing import Any

import drjit as dr
import mitsuba as mi

from ._bands import Float

GOLDEN = 0x9E3779B97F4A7C15
SHORT_GOLDEN = 0x9E3779B9


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
