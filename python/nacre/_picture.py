"""Pictures: rendered, read and written."""

from __future__ import annotations

import math
import os
import warnings
from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, DTypeLike, NDArray

from . import _nacre
from ._arrays import Floats, Floats32, Path
from ._errors import SettingError, naming
from ._model import ModelLike, choice_of
from ._paint import Paint, as_paint
from ._progress import Progress, reporter


@dataclass(frozen=True, eq=False)
class Image:
    """A picture of linear light by channels, as files hold it."""

    channels: dict[str, Floats32]
    """(H, W) by name: "R", "albedo.R", "S0.550,000000nm" """
    metadata: dict[str, str]

    @property
    def rgb(self) -> Floats32:
        """(H, W, 3) linear Rec. 709. Raises KeyError if there are no such channels."""
        return np.stack([self.channels[c] for c in "RGB"], axis=-1)

    def write(self, path: Path, *, exposure_stops: float = 0.0) -> None:
        """As .exr, every channel, or .png, tone-mapped; whole or not at all."""
        _require_stops(exposure_stops)
        if {"R", "G", "B"} <= self.channels.keys():
            _warn_of_numbers(path, lambda: self.rgb)
        _nacre.write_image(
            os.fsdecode(path), _contiguous(self.channels), self.metadata, exposure_stops
        )

    def _repr_png_(self) -> bytes:
        return _png(self.rgb)


def _require_stops(exposure_stops: float) -> None:
    lo, hi = _nacre.EXPOSURE_RANGE
    if not math.isfinite(exposure_stops) or not lo <= exposure_stops <= hi:
        raise SettingError(
            f"exposure_stops = {exposure_stops:g}: must be finite and in [{lo:g}, {hi:g}]",
            setting="exposure_stops",
        )


def _warn_of_numbers(path: Path, rgb: Callable[[], Floats32]) -> None:
    """A PNG cannot hold what is no number: it shows black."""
    if os.fsdecode(path).endswith(".png"):
        missing = np.isnan(rgb()).any(axis=-1).mean()
        if missing:
            warnings.warn(
                f"{os.fsdecode(path)}: {100 * missing:.3g} % of the pixels are not a number, and "
                "are shown as black",
                stacklevel=3,
            )


def _contiguous(channels: Mapping[str, ArrayLike]) -> dict[str, Floats32]:
    return {name: np.ascontiguousarray(c, dtype=np.float32) for name, c in channels.items()}


def _png(rgb: Floats32, exposure_stops: float = 0.0) -> bytes:
    channels = _contiguous({name: rgb[..., i] for i, name in enumerate("RGB")})
    return bytes(_nacre.encode_png(channels, exposure_stops))


def read_image(path: Path) -> Image:
    """Reads OpenEXR, Radiance HDR or PNG (decoded from sRGB).

    Raises
    ------
    InputError
        If the file is none of these, is damaged, or unfolds to too much.
    """
    return Image(*_nacre.read_image(os.fsdecode(path)))


class Picture:
    """A rendered picture; ``numpy.asarray(picture)`` is its ``rgb``."""

    def __init__(self, picture: Any) -> None:
        """From the extension; see :func:`render`."""
        self._picture = picture

    @property
    def rgb(self) -> Floats32:
        """(H, W, 3) linear Rec. 709, from the top left; 1 is the perfect diffuser in full light."""
        values: Floats32 = self._picture.rgb
        return values

    @property
    def albedo(self) -> Floats32:
        """(H, W, 3) of the first surface, for denoisers."""
        values: Floats32 = self._picture.albedo
        return values

    @property
    def normal(self) -> Floats32:
        """(H, W, 3) of the first surface."""
        values: Floats32 = self._picture.normal
        return values

    @property
    def alpha(self) -> Floats32:
        """(H, W) fraction of the samples that met a surface."""
        values: Floats32 = self._picture.alpha
        return values

    @property
    def sparkle(self) -> Floats32 | None:
        """(H, W, 3) light of single flakes less that of their mean, where asked for."""
        values: Floats32 | None = self._picture.sparkle
        return values

    @property
    def spectral(self) -> Floats32 | None:
        """(H, W, B) spectral radiance about each centre, where asked for."""
        values: Floats32 | None = self._picture.spectral
        return values

    @property
    def bin_centres_nm(self) -> Floats:
        """(B,)"""
        values: Floats = self._picture.bin_centres_nm
        return values

    @property
    def noise(self) -> float | None:
        """Standard error of a pixel's luminance, root mean square, over the mean luminance; where
        asked for, and not of a picture that was stopped."""
        value: float | None = self._picture.noise
        return value

    @property
    def samples(self) -> int:
        """Per pixel."""
        return int(self._picture.samples)

    @property
    def complete(self) -> bool:
        """False: stopped early or a shard, a valid picture of that many samples."""
        return bool(self._picture.complete)

    @property
    def shard(self) -> tuple[int, int] | None:
        """Number and count of a shard of a picture's samples; None: it is the whole."""
        value: tuple[int, int] | None = self._picture.shard
        return value

    @property
    def seconds(self) -> float:
        """Wall-clock time."""
        return float(self._picture.seconds)

    @property
    def image(self) -> Image:
        """A copy, channel by channel, with what a file says about it."""
        return Image(*self._picture.image())

    def __array__(self, dtype: DTypeLike | None = None, copy: bool | None = None) -> NDArray[Any]:
        if dtype is None or np.dtype(dtype) == self.rgb.dtype:
            return self.rgb.copy() if copy else self.rgb
        if copy is False:
            raise ValueError(f"another type than {self.rgb.dtype} needs a copy")
        return self.rgb.astype(dtype)

    def write(self, path: Path, *, exposure_stops: float = 0.0) -> None:
        """As .exr, with every channel, .png, tone-mapped, or, of a shard, .h5 for :func:`merge`;
        whole or not at all."""
        _require_stops(exposure_stops)
        self._picture.write(os.fsdecode(path), exposure_stops)

    def write_exr_and_png(self, exr: Path, *, exposure_stops: float = 0.0) -> None:
        """As .exr and as .png beside it, as the program does: neither is replaced before both are
        on the disk.

        Raises
        ------
        InputError
            If there is such a .png that Nacre did not write.
        """
        _require_stops(exposure_stops)
        self._picture.write_exr_and_png(os.fsdecode(exr), exposure_stops)

    def _repr_png_(self) -> bytes:
        return _png(self.rgb)


def scene_names() -> list[str]:
    """The built-in scenes."""
    from . import _render

    return list(_render.scene_names())


@naming(
    paint="slot",
    model="hot_spot = off",
    spp="samples per pixel",
    size=("width in pixels", "height in pixels", "width x height in pixels"),
    depth="max depth",
    footprint_pixels="footprint in pixels",
    spectral_bins=("spectral bins", "width x height x spectral bins"),
)
def render(
    scene: Path,
    paint: Paint | Path | None = None,
    *,
    spp: int = 64,
    size: tuple[int, int] = (512, 512),
    model: ModelLike = None,
    seed: int = 0,
    depth: int = 8,
    footprint_pixels: float = 0.0,
    sparkle: bool = False,
    noise: bool = True,
    spectral_bins: int = 0,
    turntable: tuple[str, float] | None = None,
    shard: tuple[int, int] | None = None,
    resume: Path | None = None,
    progress: Progress = False,
) -> Picture:
    """A picture of a painted scene by spectral path tracing; the same bits for any number of
    threads.

    Parameters
    ----------
    scene
        A scene file, or one of :func:`scene_names`.
    paint
        For the scene's materials that name no recipe; also by its path or shipped name.
    spp
        Samples per pixel.
    size
        Width and height in pixels.
    model
        Of all recipes, by default "nacre"; ``Model("nacre", flakes="explicit")`` follows light
        among discs.
    depth
        Surface reflections along a path.
    footprint_pixels
        Side of the patch that each sample shows; 0: chosen.
    sparkle
        Keeps the light of single flakes apart as well.
    noise
        Measures :attr:`Picture.noise` by rendering one pixel of 64 twice.
    spectral_bins
        Spectral channels over 400 to 700 nm.
    turntable
        What turns about the vertical, "shape", "camera" or "light", and by how many degrees; as
        ``nacre render --turntable``.
    shard
        ``(i, n)``: shard i of n of the samples only, i from 1 to n. :func:`merge` makes the picture
        of all n, bit for bit the one without shards.
    resume
        With ``shard``: a file that may hold this very shard already, which is then read and not
        rendered again.

    Raises
    ------
    InputError
        If the scene or a recipe is wrong.
    DomainError
        If a setting is out of range, a slot has no paint, or the model does not go on a shape.
    """
    from . import _render

    if resume is not None and shard is None:
        raise SettingError("resume: belongs to shard", setting="resume")
    if turntable is not None and not math.isfinite(turntable[1]):
        raise SettingError(f"turntable = {turntable}: must be finite", setting="turntable")
    width, height = size
    with reporter(progress, "render") as report:
        return Picture(
            _render.render(
                os.fsdecode(scene),
                None if paint is None else as_paint(paint, "paint")._paint,
                choice_of(model),
                width,
                height,
                spp,
                seed,
                depth,
                footprint_pixels,
                sparkle,
                noise,
                spectral_bins,
                turntable,
                shard,
                None if resume is None else os.fsdecode(resume),
                report,
            )
        )


def merge(shards: Path | Iterable[Path]) -> Picture:
    """The picture of all its shards, given by their files in any order, or by the file of its only
    one: bit for bit the one of a single process. Its ``seconds`` are those of all together.

    Raises
    ------
    InputError
        If a file holds no shard, or one of another picture; if a shard is missing or there twice.
    """
    from . import _render

    files = [shards] if isinstance(shards, (str, bytes, os.PathLike)) else shards
    return Picture(_render.merge([os.fsdecode(shard) for shard in files]))
