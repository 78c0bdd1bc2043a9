"""The BSDF `nacre` of Mitsuba 3."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import drjit as dr
import mitsuba as mi
import numpy as np

from .. import _nacre
from .._errors import SettingError
from .._model import Model
from .._paint import Paint
from ._bands import Bands, Source, Tangent
from ._bits import SHORT_GOLDEN, no, u32
from ._flakes import Sparkle, SparkleModel
from ._microflake import DirectionTables, MeanFlakes, Microflake, Pair
from ._patch import Footprint
from ._sampling import Sampling

DEFAULT_BANDS = 16
FLAKES = 0.85
"""Of the probability of flakes' lobe, what goes to single flakes where all are resolved."""
STEP = 0.01
"""Of the differences by which tables are differentiated, relative to the parameter."""
STEP_FROM_ZERO = 0.1
"""The same of a parameter that is 0, in its own unit, or STEP of what it may be."""
NEXT_TO_ZERO = 0.01
"""Of that step, in place of 0 where some tables are only of numbers above it, ..."""
NEXT_STEP = 0.2
"""... and the step there, relative, as these go by roots of the number."""


def _paint_of(props: Any) -> Paint:
    if "toml" in props:
        return Paint.from_toml(str(props["toml"]))
    if "recipe" not in props:
        raise SettingError("recipe: is missing; it names the paint's file", setting="recipe")
    name = str(props["recipe"])
    found = Path(str(mi.file_resolver().resolve(name)))
    return Paint(found if found.exists() else Path(name))


def _whole(props: Any, name: str, otherwise: int) -> int:
    value = props.get(name, otherwise)
    number = isinstance(value, (int, float)) and not isinstance(value, bool)
    if not number or not float(value).is_integer():
        raise SettingError(f"{name} = {value}: must be a whole number", setting=name)
    return int(value)


def _switch(props: Any, name: str, otherwise: bool) -> bool:
    value = props.get(name, otherwise)
    if not isinstance(value, bool):
        raise SettingError(f"{name} = {value}: must be true or false", setting=name)
    return value


def _model_of(props: Any) -> Model:
    """One of the models that are available as arrays, with its switches."""
    names = _nacre.models_with_arrays()
    name = str(props.get("model", _nacre.default_picture_model()))
    if name not in names:
        raise SettingError(f"model = {name}: must be {' or '.join(names)}", setting="model")
    options: dict[str, bool | int] = {
        key: _switch(props, key, default) for key, default in _nacre.model_switches(name).items()
    }
    if Model(name)._model.shows_flakes():
        options["specimen"] = _whole(props, "specimen", 0)
    return Model(name, **options)


def random_bits(u: Any) -> Any:
    """32 bits of a number in [0, 1)."""
    if mi.Float is float:
        return u32(int(np.float32(u).view(np.uint32)) * SHORT_GOLDEN)
    return dr.reinterpret_array(mi.UInt32, u) * mi.UInt32(SHORT_GOLDEN)


class Camera:
    """Whose pixels decide how much of the paint a sample sees."""

    def __init__(self, sensor: Any, footprint: float) -> None:
        """footprint: sides of a sample's patch in pixels; 0: of its share of the pixel."""
        params = mi.traverse(sensor)
        if "x_fov" not in params:
            raise SettingError(
                "sensor: must be perspective or thinlens, to know what a pixel sees",
                setting="sensor",
            )
        to_world = params["to_world"].matrix
        width = int(sensor.film().size()[0])

        def column(n: int) -> Any:
            return mi.ScalarVector3f([float(dr.slice(to_world[row, n])) for row in range(3)])

        self.origin = mi.ScalarPoint3f(column(3))
        self.forward = dr.normalize(column(2))
        pixel = 2 * dr.tan(0.5 * dr.deg2rad(float(dr.slice(params["x_fov"])))) / width
        if footprint == 0:
            footprint = 1 / sensor.sampler().sample_count() ** 0.5
        self.right = dr.normalize(column(0)) * pixel * footprint
        self.up = dr.normalize(column(1)) * pixel * footprint
        radius = float(dr.slice(params["aperture_radius"])) if "aperture_radius" in params else 0.0
        self.aperture = radius


def _name_of(si: Any, active: Any) -> tuple[int, ...] | None:
    """Names a place and its ray within the function that is being recorded, where variables that
    are the same have one index; None outside of one, and where gradients flow."""
    if not dr.flag(dr.JitFlag.SymbolicScope) or dr.grad_enabled(si):
        return None
    vectors = (si.p, si.wi, si.sh_frame.n, si.sh_frame.s, si.wavelengths)
    scope = dr.detail.scope(dr.backend_v(mi.Float))
    return (scope, active.index, *(x.index for vector in vectors for x in vector))


def make_plugin() -> Any:
    """The class for the variant that is set."""

    class Nacre(mi.BSDF):  # type: ignore[misc]
        """A paint, from its recipe.

        Parameters
        ----------
        recipe, toml
            A file that Nacre reads, a recipe or a solved paint; or the text of a recipe.
        model
            ``nacre`` (the default), which shows single flakes where a camera is attached
            (:func:`nacre.mitsuba.attach`), else their mean; or ``microflake``.
        specimen
            Of a model that shows single flakes. Which panel of the batch: the same number shows the
            same flakes as in Nacre.
        hot_spot
            Of the model ``nacre``: light finds gaps between large flakes again on its way out.
            Other models' switches go by their names too.
        footprint
            Sides of the patch of flakes that a sample shows, in pixels; 0, the default: so that the
            samples share out the pixel.
        to_rest
            From the world to the space in which flakes lie still, the object before it was turned
            and moved. For spheres, rectangles and the like attach() finds it.
        unit_mm
            Of the world, in mm; 1 by default.
        bands
            In RGB variants: wavelengths over which spectra are integrated, 16 by default.
        differentiate
            Keys of the recipe, separated by commas, that appear as differentiable parameters.
        """

        def __init__(self, props: Any) -> None:
            mi.BSDF.__init__(self, props)
            self.paint = _paint_of(props)
            self.model = _model_of(props)
            self.footprint = float(props.get("footprint", 0.0))
            if not 0 <= self.footprint <= 1e4:
                raise SettingError(
                    f"footprint = {self.footprint}: must be in [0, 1e4] pixels",
                    setting="footprint",
                )
            self.unit_mm = float(props.get("unit_mm", 1.0))
            if not 1e-6 <= self.unit_mm <= 1e6:
                raise SettingError(
                    f"unit_mm = {self.unit_mm}: must be in [1e-6, 1e6]", setting="unit_mm"
                )
            self.own_rest = "to_rest" in props
            self.to_rest = props.get("to_rest", mi.ScalarTransform4f())
            if not hasattr(self.to_rest, "matrix"):
                raise SettingError(
                    f"to_rest = {self.to_rest}: must be a transformation", setting="to_rest"
                )
            self.bands = _whole(props, "bands", DEFAULT_BANDS)
            if not 1 <= self.bands <= 256:
                raise SettingError(f"bands = {self.bands}: must be in [1, 256]", setting="bands")
            self.camera: Camera | None = None
            self.last_asked: tuple[tuple[int, ...] | None, Any] = None, None
            keys = [k.strip() for k in str(props.get("differentiate", "")).split(",")]
            # The key of each number as it was written, by which the scene names it.
            self.names = {self.paint.whole_key(k): k for k in keys if k}
            if mi.Float is float:
                self.names = {}  # numbers of Python, which no scene can change
            self.parameters = {k: mi.Float(self.paint[k]) for k in self.names}
            self.solved: dict[tuple[Any, ...], Any] = {}
            self._build()
            glossy = mi.BSDFFlags.GlossyReflection | mi.BSDFFlags.FrontSide
            first = (
                mi.BSDFFlags.DeltaReflection | mi.BSDFFlags.FrontSide
                if not self.smooth.rough
                else glossy
            )
            self.m_components = [int(first), int(glossy)]
            self.m_flags = self.m_components[0] | self.m_components[1]

        # From the recipe to the arrays

        def _arrays(self, paint: Paint, *, mean: bool = True) -> Any:
            """mean: without what samples and single flakes need, which takes most of the time."""
            return _nacre.appearance_arrays(paint._paint, self.model._model, mean, None)

        def _build(self) -> None:
            paint, steps, values = self.paint, {}, []
            for key, value in self.parameters.items():
                at = float(dr.slice(dr.detach(value)))
                limits = paint.parameters[key]
                half = abs(at) * STEP or min(STEP_FROM_ZERO, STEP * limits.hi)
                low, high = max(at - half, limits.lo), min(at + half, limits.hi)
                if at == 0 and self._has_more_tables(paint, key, high):
                    at = NEXT_TO_ZERO * high
                    low, high = at * (1 - NEXT_STEP), at * (1 + NEXT_STEP)
                steps[key] = low, high
                values.append(at)
                paint = paint.with_values({key: at})
            # Gradients are often enabled after the scene was loaded, which changes no value: what
            # was solved for the last ones is kept.
            before, self.solved = self.solved, {}

            def solved(key: str = "", value: float = 0.0) -> Any:
                place = (*values, key, value)
                if place in before:
                    arrays = before[place]
                elif key:
                    arrays = self._arrays(paint.with_values({key: value}))
                else:
                    arrays = self._arrays(paint, mean=False)
                if self.parameters:
                    self.solved[place] = arrays
                return arrays

            base = solved()
            tangents = [
                Tangent(
                    self.parameters[key] - dr.detach(self.parameters[key]),
                    solved(key, high),
                    solved(key, low),
                    high - low,
                )
                for key, (low, high) in steps.items()
            ]
            source = Source(base, tangents)
            self.table_bands = Bands(base["wavelengths_nm"], self.bands)
            self.smooth = Microflake(source, self.table_bands)
            self.sampling = Sampling(base)
            flakes = self.model._model.shows_flakes()
            self.sparkle = SparkleModel(self.smooth, source) if flakes else None
            self.mean = self.sparkle.mean if self.sparkle else MeanFlakes()

        def _has_more_tables(self, paint: Paint, key: str, value: float) -> bool:
            """Whether the number makes light of a kind that there is none of where it is 0."""
            some, none = (self._arrays(paint.with_values({key: x})) for x in (value, 0.0))
            return list(DirectionTables.channels(some)) != list(DirectionTables.channels(none))

        def traverse(self, callback: Any) -> None:
            for key, value in self.parameters.items():
                callback.put(self.names[key], value, mi.ParamFlags.Differentiable)

        def parameters_changed(self, keys: Any = ()) -> None:
            if self.parameters:
                self._build()

        # Flakes

        def attach(self, camera: Camera, to_rest: Any) -> None:
            self.camera = camera
            if not self.own_rest:
                self.to_rest = to_rest

        @property
        def shows_flakes(self) -> bool:
            return (
                self.camera is not None
                and self.sparkle is not None
                and bool(self.sparkle.fields)
                and not self.parameters
            )

        def _flakes(self, si: Any, i: Any, active: Any) -> Any:
            if not self.shows_flakes:
                return self.mean
            camera, n = self.camera, si.sh_frame.n
            to_rest = mi.AffineTransform4f(self.to_rest)
            assert camera is not None
            assert self.sparkle is not None
            # Mitsuba's difference of points is a point, which moves with its shape.
            q = mi.Vector3f(si.p - mi.Point3f(camera.origin))
            depth = dr.dot(q, mi.Vector3f(camera.forward))
            q = q / dr.select(dr.abs(depth) > 1e-20, depth, 1e-20)
            facing = dr.dot(n, q)
            facing = dr.select(dr.abs(facing) > 1e-6, facing, -1e-6)

            def edge(step: Any) -> Any:
                """What a step from pixel to pixel is on the surface, in mm."""
                step = mi.Vector3f(step)
                moved = depth * (step - q * (dr.dot(n, step) / facing))
                return self.unit_mm * (to_rest @ moved)

            rest = to_rest @ si.p
            normal = dr.normalize(to_rest @ mi.Vector3f(n))
            tangent = to_rest @ si.sh_frame.s
            tangent = dr.normalize(tangent - normal * dr.dot(normal, tangent))
            patch = Footprint(
                self.unit_mm * mi.Vector3f(rest),
                normal,
                tangent,
                edge(camera.right),
                edge(camera.up),
            )
            # What is not seen by the camera itself gets the mean; twosided turns wi to the front.
            towards = si.to_local(-dr.normalize(q))
            towards = mi.Vector3f(towards.x, towards.y, dr.abs(towards.z))
            slack = 1e-5 + camera.aperture / dr.maximum(depth, 1e-20)
            seen = dr.norm(si.wi - towards) < slack
            return Sparkle(self.sparkle, patch, i, active, seen)

        # mi.BSDF

        def _chances(self, ctx: Any, i: Any, flakes: Any) -> tuple[Any, Any]:
            """Probabilities of the ways to draw, and apart from them that of a single flake."""
            chances = self.sampling.probabilities(
                i,
                ctx.is_enabled(mi.BSDFFlags.DeltaReflection, 0),
                ctx.is_enabled(mi.BSDFFlags.GlossyReflection, 1),
            )
            if not isinstance(flakes, Sparkle):
                return chances, mi.Float(0)
            # What flakes reflect one by one is no longer drawn from the lobe of all.
            one = chances[1] * FLAKES * dr.detach(flakes.resolved)
            one = dr.select(flakes.any, one, 0)
            return (chances[0], chances[1] - one, *chances[2:]), one

        def _density(self, ctx: Any, pair: Pair, flakes: Any) -> Any:
            """Of a direction that sample() draws; after the value of this pair."""
            chances, one = self._chances(ctx, pair.i, flakes)
            density = self.sampling.density(chances, pair.i, pair.o)
            if isinstance(flakes, Sparkle):
                density += one * flakes.density(pair)
            return dr.detach(density)

        def _ask(
            self,
            ctx: Any,
            si: Any,
            wo: Any,
            sample1: Any,
            sample2: Any,
            active: Any,
        ) -> tuple[Any, Any, Any, Any]:
            """Value times cosine and density of wo, a sample and its weight; each only if wo, or
            sample1, is not None."""
            smooth, bands = self.smooth, self.table_bands
            specular = ctx.is_enabled(mi.BSDFFlags.DeltaReflection, 0) and not smooth.rough
            rest = ctx.is_enabled(mi.BSDFFlags.GlossyReflection, 1)
            bs = mi.BSDFSample3f()
            black = bands.colour(bands.constant(0))
            if not rest and not specular:
                return black, mi.Float(0), bs, black
            asked = mi.Bool(active)
            active = asked & (si.wi.z > 0)
            where = bands.at(si)
            up = mi.Vector3f(0, 0, 1)
            i = smooth.ray(dr.select(active, si.wi, up), where, active)
            # Integrators ask for a value and then for a sample, by one call that Mitsuba makes two:
            # the cells that were found serve both.
            name = _name_of(si, asked) if rest else None
            (last, flakes), self.last_asked = self.last_asked, (None, None)
            if name is None or name != last:
                flakes = self._flakes(si, i, active) if rest else self.mean

            value, density = black, mi.Float(0)
            if wo is not None and rest:
                lit = active & (wo.z > 0)
                pair = smooth.pair(i, smooth.ray(dr.select(lit, wo, up), where, lit), where)
                flakes.start()
                f = smooth.value(pair, flakes, lit)
                value = bands.colour(dr.select(lit, dr.maximum(f, 0) * wo.z, 0))
                density = dr.select(lit, self._density(ctx, pair, flakes), 0)
            if sample1 is None:
                if isinstance(flakes, Sparkle):
                    self.last_asked = _name_of(si, asked), flakes
                return value, density, bs, black

            if isinstance(flakes, Sparkle):
                flakes.survey(random_bits(sample1))
            chances, one = self._chances(ctx, i, flakes)
            # In this order: the interface, lobes of all flakes, evenly, one flake.
            is_delta = mi.Bool(not smooth.rough) & (sample1 < chances[0])
            drawn = self.sampling.draw(chances, i, dr.minimum(sample1, 1 - one), sample2)
            if isinstance(flakes, Sparkle):
                drawn = dr.select(sample1 >= 1 - one, flakes.draw(sample2), drawn)
            drawn = dr.select(is_delta, mi.reflect(si.wi), dr.detach(drawn))
            active &= drawn.z > 0
            drawn = dr.select(active, drawn, up)
            pair = smooth.pair(i, smooth.ray(drawn, where, active), where)
            glossy = active & no(is_delta)
            flakes.start()
            f = smooth.value(pair, flakes, glossy)
            pdf = self._density(ctx, pair, flakes)
            glossy &= pdf > 0
            weight = dr.select(glossy, dr.maximum(f, 0) * (drawn.z / dr.maximum(pdf, 1e-30)), 0)
            reflected = smooth.specular(si.wi.z, where, active) / dr.maximum(chances[0], 1e-30)
            weight = dr.select(active & is_delta, reflected, weight)
            bs.pdf = dr.select(active, dr.select(is_delta, chances[0], pdf), 0)
            # Below the horizon where none leaves: blendbsdf and the like ask for its value again.
            bs.wo = dr.select(bs.pdf > 0, drawn, -up)
            bs.eta = 1.0
            bs.sampled_type = dr.select(
                is_delta,
                mi.UInt32(int(mi.BSDFFlags.DeltaReflection)),
                mi.UInt32(int(mi.BSDFFlags.GlossyReflection)),
            )
            bs.sampled_component = dr.select(is_delta, mi.UInt32(0), mi.UInt32(1))
            return value, density, bs, bands.colour(weight)

        def eval(self, ctx: Any, si: Any, wo: Any, active: Any = True) -> Any:
            return self._ask(ctx, si, wo, None, None, active)[0]

        def pdf(self, ctx: Any, si: Any, wo: Any, active: Any = True) -> Any:
            return self._ask(ctx, si, wo, None, None, active)[1]

        def eval_pdf(self, ctx: Any, si: Any, wo: Any, active: Any = True) -> Any:
            return self._ask(ctx, si, wo, None, None, active)[:2]

        def sample(self, ctx: Any, si: Any, sample1: Any, sample2: Any, active: Any = True) -> Any:
            return self._ask(ctx, si, None, sample1, sample2, active)[2:]

        def eval_pdf_sample(
            self, ctx: Any, si: Any, wo: Any, sample1: Any, sample2: Any, active: Any = True
        ) -> Any:
            return self._ask(ctx, si, wo, sample1, sample2, active)

        def to_string(self) -> str:
            return f"Nacre[recipe={self.paint.name}, model={self.model!r}]"

    return Nacre
