"""Nacre predicts the look of special-effect coatings from their composition.

>>> import nacre
>>> stack = nacre.film([("TiO2_anatase", 80)], substrate="mica", wavelengths_nm=[550])
>>> stack.R.shape
(1,)

Arrays: leading axes are broadcast, wavelengths come last. Lengths, angles and wavelengths carry
their unit in their name; directions point away from the surface, z being its normal.
"""

from . import _cpu  # isort: skip: before the extensions
from ._arrays import direction
from ._errors import DomainError, Error, InputError, SettingError, Stopped
from ._film import (
    WAVELENGTHS_NM,
    Chips,
    Film,
    Material,
    delta_e_2000,
    film,
    lab,
    material_names,
    srgb,
    xyz,
)
from ._fit import ConstructionMatch, FittedParameter, Match, fit
from ._measurement import Difference, Measurement, geometry_sets
from ._model import Model, model_names
from ._nacre import version
from ._paint import Paint, shipped_paints
from ._picture import Image, Picture, merge, read_image, render, scene_names
from ._pigment import DrawdownFit, Pigment, pigment
from ._sparkle import DiffuseReading, Estimate, LampReading, Sparkle
from ._threads import set_threads, threads
from ._uncertainty import UncertainNumber, Uncertainty
from ._values import Export, FittedMaterial, Parameter, Reference, Sample, ShaderMaterial, Solution

del _cpu
__version__: str = version()

__all__ = [
    "WAVELENGTHS_NM",
    "Chips",
    "ConstructionMatch",
    "Difference",
    "DiffuseReading",
    "DomainError",
    "DrawdownFit",
    "Error",
    "Estimate",
    "Export",
    "Film",
    "FittedMaterial",
    "FittedParameter",
    "Image",
    "InputError",
    "LampReading",
    "Match",
    "Material",
    "Measurement",
    "Model",
    "Paint",
    "Parameter",
    "Picture",
    "Pigment",
    "Reference",
    "Sample",
    "SettingError",
    "ShaderMaterial",
    "Solution",
    "Sparkle",
    "Stopped",
    "UncertainNumber",
    "Uncertainty",
    "__version__",
    "delta_e_2000",
    "direction",
    "film",
    "fit",
    "geometry_sets",
    "lab",
    "material_names",
    "merge",
    "model_names",
    "pigment",
    "read_image",
    "render",
    "scene_names",
    "set_threads",
    "shipped_paints",
    "srgb",
    "threads",
    "xyz",
]
