"""What is computed for each paint: the table [record] of a plan."""

from __future__ import annotations

from dataclasses import asdict, dataclass
from typing import Any

from nacre import Error, Model, Paint, _nacre, geometry_sets, model_names, scene_names

from .table import Table, is_number

SCENES = {"ball": "sphere", "panel": "curved-panel", "macro": "macro"}
"""The scenes of the thumbnails."""


@dataclass(frozen=True)
class PictureSettings:
    """A picture by the model that shows single flakes."""

    scene: str
    width: int
    height: int
    samples: int


@dataclass(frozen=True)
class SparkleSettings:
    """The virtual camera (docs/sparkle.md)."""

    lamps_deg: tuple[float, ...]
    field_mm: float
    pixel_um: float
    diffuse_samples: int


@dataclass(frozen=True)
class RglSettings:
    """A table in the format of the RGL database (docs/export.md)."""

    resolution: int
    incidences: int


@dataclass(frozen=True)
class Settings:
    """All that a record depends on besides its recipe and Nacre's version."""

    geometries: tuple[str, ...]
    """Sets by name, or names with commas; the first is the one of readings.csv."""
    model: str
    illuminant: str
    observer: str
    sparkle: SparkleSettings | None
    thumbnails: dict[str, PictureSettings]
    """By their name: ball, panel, macro."""
    solved: bool
    rgl: RglSettings | None
    reference: PictureSettings | None

    def to_dict(self) -> dict[str, Any]:
        """As JSON has it, with every default written out; the record's hash is taken over it."""
        return asdict(self)

    def readings_files(self) -> dict[str, str]:
        """The name of each file of readings and what it is read at."""
        names = {"readings.csv": self.geometries[0]}
        sets = geometry_sets()
        for i, geometry in enumerate(self.geometries[1:], start=2):
            names[f"readings-{geometry if geometry in sets else i}.csv"] = geometry
        return names

    def command(self, geometry: str) -> list[str]:
        """The arguments with which ``nacre`` gives the same readings of recipe.toml."""
        return [
            *("measure", "recipe.toml", "--format", "csv", "--geometry", geometry),
            *("--model", self.model, "--illuminant", self.illuminant, "--observer", self.observer),
        ]


def _size(table: Table, default: int) -> tuple[int, int]:
    size = table.take("size", default)
    sides = size if isinstance(size, list) and len(size) == 2 else [size, size]
    for side in sides:
        if not isinstance(side, int) or isinstance(side, bool) or not 16 <= side <= 4096:
            raise table.wrong("size", size, "pixels in [16, 4096], one number or [width, height]")
    return sides[0], sides[1]


def _picture(table: Table, scene: str, size: int, samples: int) -> PictureSettings:
    width, height = _size(table, size)
    picture = PictureSettings(scene, width, height, table.whole("samples", 1, 1 << 20, samples))
    table.done()
    return picture


def _thumbnails(table: Table | None) -> dict[str, PictureSettings]:
    found: dict[str, PictureSettings] = {}
    if table is None:
        return found
    for name, scene in SCENES.items():
        picture = table.table(name)
        if picture is not None:
            found[name] = _picture(picture, scene, size=128, samples=64)
    table.done()
    return found


def _sparkle(table: Table | None) -> SparkleSettings | None:
    if table is None:
        return None
    lamps = table.take("lamps_deg", [15, 45, 75])
    if not isinstance(lamps, list) or not 1 <= len(lamps) <= _nacre.SPARKLE_MAX_LAMPS:
        raise table.wrong("lamps_deg", lamps, f"a list of 1 to {_nacre.SPARKLE_MAX_LAMPS} angles")
    lo, hi = _nacre.SPARKLE_LAMP_RANGE_DEG
    for lamp in lamps:
        if not is_number(lamp) or not lo <= lamp <= hi:
            raise table.wrong("lamps_deg", lamp, f"an angle in [{lo:g}, {hi:g}]")
    settings = SparkleSettings(
        tuple(float(lamp) for lamp in lamps),
        table.number("field_mm", 0.5, 100, 4),
        table.number("pixel_um", 1, 1000, 25),
        table.whole("diffuse_samples", 0, 4096, 16),
    )
    if settings.diffuse_samples % 2:
        raise table.wrong("diffuse_samples", settings.diffuse_samples, "even")
    table.done()
    return settings


def _rgl(table: Table | None) -> RglSettings | None:
    if table is None:
        return None
    (res_lo, res_hi), (inc_lo, inc_hi) = _nacre.RGL_RESOLUTION_RANGE, _nacre.RGL_INCIDENT_RANGE
    settings = RglSettings(
        table.whole("resolution", res_lo, res_hi, 32), table.whole("incidences", inc_lo, inc_hi, 32)
    )
    table.done()
    return settings


def _reference(table: Table | None) -> PictureSettings | None:
    if table is None:
        return None
    scene = table.choice("scene", scene_names(), "sphere")
    return _picture(table, scene, size=256, samples=1024)


def read_settings(table: Table | None) -> Settings:
    """The table [record] of a plan; None: the defaults.

    Raises
    ------
    InputError
        Naming file, key, value and what is allowed.
    """
    table = table or Table({}, "")
    geometries = table.texts("geometries", ["byk-mac"])
    if not geometries:
        raise table.wrong("geometries", geometries, "a set or a list of sets")
    settings = Settings(
        tuple(geometries),
        table.text("model", model_names()[0]),
        table.text("illuminant", "D65"),
        str(table.take("observer", "10")),
        _sparkle(table.table("sparkle")),
        _thumbnails(table.table("thumbnails")),
        table.flag("solved"),
        _rgl(table.table("rgl")),
        _reference(table.table("reference")),
    )
    table.done()
    _check_names(table, settings)
    return settings


def _check_names(table: Table, settings: Settings) -> None:
    """Asks Nacre itself whether it knows the names, on a paint that costs nothing."""
    paint = Paint.from_dict({"ior": 1.5, "layer": [{"thickness_um": 1}]})
    try:
        Model(settings.model)
    except Error as error:
        raise table.error("model", f"= {settings.model!r}: {error}") from None
    for i, geometry in enumerate(settings.geometries):
        if geometry in settings.geometries[:i]:
            raise table.error("geometries", f"= {geometry!r}: is there twice")
        if geometry.endswith(".toml"):  # its contents would not be part of the hash
            raise table.wrong("geometries", geometry, 'a set by its name, or names as "45as15"')
        try:
            paint.measure(geometry, illuminant=settings.illuminant, observer=settings.observer)
        except Error as error:
            raise table.error("geometries, illuminant, observer", f"= {error}") from None
