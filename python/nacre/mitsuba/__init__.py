"""Nacre's paints in Mitsuba 3: importing this registers the BSDF `nacre`.

>>> import mitsuba as mi
>>> mi.set_variant("llvm_ad_spectral")
>>> import nacre.mitsuba
>>> scene = mi.load_dict({
...     "type": "scene",
...     "ball": {"type": "sphere", "bsdf": {"type": "nacre", "recipe": "paints/red-gold.toml"}},
...     ...
... })
>>> nacre.mitsuba.attach(scene)  # for single flakes
>>> mi.render(scene)

Needs Mitsuba 3.9 (``pip install nacre[mitsuba]``) and, for its LLVM variants, LLVM 19.
"""

from __future__ import annotations

import re
from collections.abc import Iterable
from typing import Any

from .._errors import Error, SettingError
from ._library import choose_llvm

choose_llvm()

try:
    import mitsuba as mi
except ImportError as error:
    raise ImportError(
        "nacre.mitsuba needs Mitsuba 3.9: pip install 'mitsuba>=3.9.1,<3.10'"
    ) from error

VERSIONS = ((3, 9, 1), (3, 10, 0))
_version = tuple(int(x) for x in re.findall(r"\d+", mi.__version__)[:3])
if not VERSIONS[0] <= _version < VERSIONS[1]:
    raise ImportError(
        f"nacre.mitsuba needs Mitsuba 3.9 from 3.9.1 on, and found {mi.__version__}: "
        "pip install 'mitsuba>=3.9.1,<3.10'"
    )


def _register(_before: str | None = None, variant: str | None = None) -> None:
    if not variant:
        return
    if "mono" in variant or "polarized" in variant:

        def refuse(_props: Any) -> Any:
            raise SettingError(
                f"variant {variant}: has no paints; they need one of spectra or RGB, as "
                "llvm_ad_spectral or llvm_ad_rgb, without polarisation"
            )

        mi.register_bsdf("nacre", refuse)
        return
    from ._plugin import make_plugin

    mi.register_bsdf("nacre", make_plugin())


def _paints_in(bsdf: Any) -> list[Any]:
    """It, or those that it wraps, as twosided, mask and bumpmap do."""
    if hasattr(bsdf, "attach"):
        return [bsdf]
    found: list[Any] = []

    class Children(mi.TraversalCallback):  # type: ignore[misc]
        def put(self, _name: str, value: Any, _flags: int) -> None:
            if isinstance(value, mi.BSDF):
                found.extend(_paints_in(value))

    bsdf.traverse(Children())
    return found


def attach(scene: Any, sensor: int | Any = 0, instanced: Iterable[Any] = ()) -> None:
    """Shows the single flakes of the paints in a scene, as a camera sees them.

    A sample shows the flakes on its share of a pixel, for which it must know how large a pixel is
    where it lies, and where the flakes lie that move with the object. Without this, and for light
    that the camera does not see directly, paints show the mean of their flakes.

    Parameters
    ----------
    scene
        As mi.load_dict() or mi.load_file() gives it.
    sensor
        The camera, or its number; perspective or thinlens. Its sampler's number of samples counts:
        after changing it, call this again.
    instanced
        BSDFs that lie on shapes of a shapegroup, which a scene does not tell: those objects of
        mi.load_dict() that its dictionary was given. Their flakes lie still in the world.

    Raises
    ------
    SettingError
        If no shape is painted, or one paint lies on several shapes that were moved differently:
        each then needs a BSDF of its own, or `to_rest`.
    """
    from ._plugin import Camera
    from ._rest import is_same_rest, rest_of

    chosen = scene.sensors()[sensor] if isinstance(sensor, int) else sensor
    places: dict[int, tuple[Any, Any]] = {}
    for shape in scene.shapes():
        rest = rest_of(shape)
        for bsdf in _paints_in(shape.bsdf()):
            known = places.get(id(bsdf))
            if known is not None and not bsdf.own_rest and not is_same_rest(known[1], rest):
                raise SettingError(
                    "one paint lies on several shapes that were moved differently: give each a "
                    "BSDF of its own, or the paint a to_rest"
                )
            places[id(bsdf)] = (bsdf, rest)
    for bsdf in instanced:
        for paint in _paints_in(bsdf):
            places.setdefault(id(paint), (paint, mi.ScalarTransform4f()))
    if not places:
        raise SettingError(
            "scene: no shape has the BSDF nacre (give what lies in a shapegroup, as instanced)"
        )
    for bsdf, rest in places.values():
        bsdf.attach(Camera(chosen, bsdf.footprint), rest)


mi.detail.add_variant_callback(_register)
_register(None, mi.variant())

__all__ = ["Error", "attach"]
