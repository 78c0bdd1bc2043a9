"""Tables of a paint in Dr.Jit's types, looked up at the wavelengths that Mitsuba asks for.

Spectral variants ask for a few wavelengths of their own in each sample, between which tables are
interpolated linearly, as Nacre does. RGB variants want integrals over the spectrum: they are sums
over fixed bands, each the paint at one wavelength with three weights.
"""

from __future__ import annotations

import sys
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Any

import drjit as dr
import mitsuba as mi
import numpy as np
from numpy.typing import NDArray

from .. import _rgb
from .._errors import SettingError

Float = Any  # mi.Float of the variant at hand
ALIGNMENT = 64
"""In bytes, of Dr.Jit's arrays."""
Wide = Any
"""A value at each wavelength: mi.UnpolarizedSpectrum, or in RGB variants an array over the
bands."""


def array_type() -> Any:
    """An array of any number of mi.Float."""
    if mi.Float is float:
        return dr.scalar.ArrayXf
    return sys.modules[mi.Float.__module__].ArrayXf


def single(values: NDArray[Any]) -> NDArray[np.float32]:
    """Numbers in single precision, aligned as Dr.Jit aligns its own.

    Dr.Jit works on NumPy's memory as it lies, and a kernel says how what it reads is aligned. Of
    tables that lie now so, now so, it would compile another kernel in every process, and find none
    of those that it keeps on disk.
    """
    size = values.size * 4
    memory = np.empty(size + ALIGNMENT, dtype=np.uint8)
    start = -memory.ctypes.data % ALIGNMENT
    aligned = memory[start : start + size].view(np.float32).reshape(values.shape)
    aligned[...] = values
    return aligned


def even_wavelengths(nm: NDArray[np.float64]) -> NDArray[np.float64]:
    """An even grid that holds all of these: themselves, or whole nanometres."""
    steps = np.diff(nm)
    if len(nm) < 3 or np.allclose(steps, steps[0], rtol=1e-9):
        return nm
    if not np.array_equal(nm, np.round(nm)):
        raise SettingError(
            "wavelengths of the solved paint: must be in equal steps, or whole nanometres"
        )
    return np.arange(nm[0], nm[-1] + 1)


Arrays = dict[str, Any]
"""What _nacre.appearance_arrays() gives (src/nacre/bsdf/models/nacre_arrays.h)."""


@dataclass
class Tangent:
    """How the arrays change with a parameter of the recipe."""

    delta: Float
    """Zero, with the parameter's gradient."""
    plus: Arrays
    minus: Arrays
    step: float
    """Between the parameter of `plus` and that of `minus`."""


@dataclass
class Source:
    """The arrays of a paint, and their derivatives by parameters."""

    base: Arrays
    tangents: Sequence[Tangent] = ()

    def tensor(self, build: Callable[[Arrays], NDArray[Any]]) -> Any:
        value = mi.TensorXf(single(build(self.base)))
        for t in self.tangents:
            slope = (build(t.plus) - build(t.minus)) / t.step
            value += mi.TensorXf(single(slope)) * t.delta
        return value

    def number(self, build: Callable[[Arrays], float]) -> Float:
        """As scalar(), but where there are no derivatives Python's, in double precision."""
        return self.scalar(build) if self.tangents else float(build(self.base))

    def scalar(self, build: Callable[[Arrays], float]) -> Float:
        value = mi.Float(build(self.base))
        for t in self.tangents:
            value += t.delta * ((build(t.plus) - build(t.minus)) / t.step)
        if self.tangents:
            dr.make_opaque(value)  # as it changes from step to step, for which kernels are kept
        return value


@dataclass
class Where:
    """Wavelengths as coordinates of textures; of no use to fixed bands."""

    coordinates: list[Float]


class Bands:
    """The wavelengths of one BSDF, and how they become Mitsuba's colours."""

    def __init__(self, paint_nm: NDArray[np.float64], count: int) -> None:
        """count: of fixed bands, for RGB variants."""
        self.paint_nm = np.asarray(paint_nm, dtype=np.float64)
        self.spectral = bool(mi.is_spectral)
        if self.spectral:
            self.nm = even_wavelengths(self.paint_nm)
        else:
            self.nm = np.linspace(self.paint_nm[0], self.paint_nm[-1], min(count, len(paint_nm)))
            self.rgb = _rgb.weights(self.nm)

    def at(self, si: Any) -> Where:
        if not self.spectral:
            return Where([])
        first, n = float(self.nm[0]), len(self.nm)
        step = float(self.nm[-1] - self.nm[0]) / max(n - 1, 1)
        if n == 1:
            return Where([mi.Float(0.5)] * len(si.wavelengths))
        scale, offset = 1 / (step * n), (0.5 - first / step) / n
        return Where([dr.fma(w, scale, offset) for w in si.wavelengths])

    def wide(self, values: Sequence[Float]) -> Wide:
        if self.spectral:
            return mi.UnpolarizedSpectrum(*values)
        return array_type()(list(values))

    def constant(self, value: float) -> Wide:
        return self.wide([mi.Float(value)] * (len(self.nm) if not self.spectral else 4))

    def colour(self, value: Wide) -> Any:
        """What Mitsuba takes for a spectrum."""
        if self.spectral:
            return value
        rgb = [
            sum((float(w) * value[n] for n, w in enumerate(row)), start=mi.Float(0))
            for row in self.rgb
        ]
        return mi.Color3f(*rgb)

    def even(self, values: NDArray[Any]) -> NDArray[np.float64]:
        """(..., paint's wavelengths) -> (..., those of the tables)."""
        return _rgb.resample(values, self.paint_nm, self.nm)


def texture(dimension: int, data: Any) -> Any:
    """Of a tensor: linear between the middles of its texels, constant beyond the ends."""
    kind = {1: mi.Texture1f, 2: mi.Texture2f, 3: mi.Texture3f}[dimension]
    return kind(
        data,
        use_accel=False,  # which would round fractions to 8 bits
        migrate=False,
        filter_mode=dr.FilterMode.Linear,
        wrap_mode=dr.WrapMode.Clamp,
    )


def columns(values: Any) -> NDArray[Any]:
    """Functions of a direction (D,) or (D, channels), as the data of a texture."""
    array = np.asarray(values)
    return array.reshape(len(array), -1)


def column_texture(values: Any) -> Any:
    """Of functions of a direction, even in tan(theta / 2) from 0 to 1."""
    return texture(1, mi.TensorXf(single(columns(values))))


def by_direction(table: Any, x: Float) -> list[Float]:
    """The channels of column_texture() at x = tan(theta / 2)."""
    n = table.shape[0]
    return list(table.eval(dr_array(1)(dr.fma(x, (n - 1) / n, 0.5 / n))))


class Table:
    """Functions of one coordinate and the wavelength, as channels of one texture."""

    def __init__(
        self, bands: Bands, source: Source, channels: Callable[[Arrays], Sequence[NDArray[Any]]]
    ) -> None:
        """channels: (rows, W) each, or (W,), at the paint's wavelengths."""
        self.bands = bands
        self.count = len(channels(source.base))
        self.rows = 1

        def data(arrays: Arrays) -> NDArray[np.float64]:
            at = [np.atleast_2d(bands.even(c)) for c in channels(arrays)]
            self.rows = max(len(c) for c in at)
            at = [np.broadcast_to(c, (self.rows, len(bands.nm))) for c in at]
            # (rows, W, channels), or in bands (rows, channels x W)
            return np.stack(at, axis=-1) if bands.spectral else np.concatenate(at, axis=-1)

        self.texture = texture(2 if bands.spectral else 1, source.tensor(data))

    def coordinate(self, position: Float) -> Float:
        """Of a place among the rows, 0 to rows - 1."""
        return dr.fma(position, 1 / self.rows, 0.5 / self.rows)

    def look_up(self, position: Float, where: Where, active: Any = True) -> list[Wide]:
        """The channels at a place among the rows."""
        y = self.coordinate(position)
        if not self.bands.spectral:
            values = self.texture.eval(dr_array(1)(y), active)
            n = len(self.bands.nm)
            return [self.bands.wide(values[c * n : (c + 1) * n]) for c in range(self.count)]
        each = [self.look_up_at(position, x, active) for x in where.coordinates]
        return [self.bands.wide([v[c] for v in each]) for c in range(self.count)]

    def look_up_at(self, position: Float, wavelength: Float, active: Any = True) -> list[Float]:
        """Of spectral variants, at one wavelength."""
        at = mi.Point2f(wavelength, self.coordinate(position))
        return list(self.texture.eval(at, active))


def dr_array(size: int) -> Any:
    """The array type in which textures of this dimension are asked."""
    if mi.Float is float:
        return getattr(dr.scalar, f"Array{size}f")
    return getattr(sys.modules[mi.Float.__module__], f"Array{size}f")
