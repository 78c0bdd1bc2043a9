"""Plans: which paints a library holds.

A plan is a TOML file with a table [library], a table [record] and a [[sweep]] for each base recipe,
or several, whose numbers vary (docs/library.md).
"""

from __future__ import annotations

import copy
import hashlib
import json
import re
import tomllib
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from nacre import Error, InputError, Paint, Parameter, __version__, shipped_paints

from . import keys, sampling
from .construction import label
from .keys import Recipe
from .sampling import Axis, Choice, Point, Range
from .settings import Settings, read_settings
from .table import Table, is_number

SCHEMA = 1
"""The version of the format of a library; part of a record's hash."""

MOST_RECORDS = 10_000_000


@dataclass(frozen=True)
class PlannedRecord:
    """A paint of a plan, not computed yet."""

    id: str
    """32 hexadecimal digits: the hash of recipe, settings and version"""
    sweep: str
    base: str
    """name of the base recipe"""
    recipe: Recipe
    swept: dict[str, Any]
    """the values that vary, by whole key"""
    version: str = __version__
    """of the Nacre that planned it, and is to compute it"""

    @property
    def name(self) -> str:
        return str(self.recipe.get("name", ""))


@dataclass(frozen=True)
class Vary:
    """An axis of a sweep and the keys that it sets."""

    pattern: str
    axis: Axis


@dataclass(frozen=True)
class Sweep:
    """Base recipes and the points at which they are changed."""

    name: str
    bases: tuple[tuple[str, Recipe], ...]
    """name and complete recipe of each"""
    patterns: tuple[str, ...]
    """what varies, in the order of a point"""
    points: tuple[Point, ...]
    name_format: str

    def __len__(self) -> int:
        return len(self.bases) * len(self.points)


class Plan:
    """What a library is to hold.

    Attributes
    ----------
    name, description, authors
        For people, and for the citation.
    settings
        What is computed for each record.
    sweeps
        In the order of the file.
    text
        The file as it was read.
    """

    def __init__(self, file: str | Path) -> None:
        """Reads a plan and checks it, every range of every key included.

        Raises
        ------
        InputError
            Naming file, key, value and what is allowed.
        """
        self.file = Path(file)
        try:
            self.text = self.file.read_text(encoding="utf-8")
            values = tomllib.loads(self.text)
        except (OSError, UnicodeDecodeError, tomllib.TOMLDecodeError) as error:
            raise InputError(f"{file}: cannot be read as a plan: {error}") from None
        top = Table(values, file)
        about = top.table("library") or Table({}, file, "library")
        self.name = about.text("name", self.file.stem)
        self.description = about.text("description")
        self.authors = about.texts("authors")
        about.done()
        self.settings: Settings = read_settings(top.table("record") or Table({}, file, "record"))
        self._settings_dict = self.settings.to_dict()
        tables = top.tables("sweep")
        top.done()
        if not tables:
            raise InputError(f"{file}: has no [[sweep]]: it names no paint")
        self.sweeps = [_read_sweep(table, self.file.parent) for table in tables]
        names = [sweep.name for sweep in self.sweeps]
        for table, name in zip(tables, names, strict=True):
            if names.count(name) > 1:
                raise table.wrong("name", name, "another for each sweep")

    def __len__(self) -> int:
        """How many records are planned, those that are there twice counted twice."""
        return sum(len(sweep) for sweep in self.sweeps)

    def records(self) -> Iterator[PlannedRecord]:
        """The records in the order of the plan, each once: of two that are alike, the first."""
        seen: set[str] = set()
        for sweep in self.sweeps:
            for base, recipe in sweep.bases:
                for point in sweep.points:
                    record = self._record(sweep, base, recipe, point)
                    if record.id not in seen:
                        seen.add(record.id)
                        yield record

    def _record(self, sweep: Sweep, base: str, recipe: Recipe, point: Point) -> PlannedRecord:
        changed = copy.deepcopy(recipe)
        swept = apply(changed, zip(sweep.patterns, point, strict=True))
        changed["name"] = _name(sweep.name_format, base, swept)
        return PlannedRecord(self._hash(changed), sweep.name, base, changed, swept)

    def _hash(self, recipe: Recipe) -> str:
        content = {
            "schema": SCHEMA,
            "recipe": _floats(recipe),
            "settings": self._settings_dict,
            "version": __version__,
        }
        text = json.dumps(content, sort_keys=True, ensure_ascii=False, separators=(",", ":"))
        return hashlib.sha256(text.encode()).hexdigest()[:32]


def apply(recipe: Recipe, changes: Any) -> dict[str, Any]:
    """Sets values in a recipe, in place, by the patterns of their keys, and returns them by their
    whole keys. A pattern that matches nothing is itself the whole key of something to add.

    Raises
    ------
    ValueError
        If a pattern means several keys, or nothing can stand there.
    """
    done: dict[str, Any] = {}
    for pattern, value in changes:
        found = keys.matching(recipe, pattern)
        if not found and ("*" in pattern or "." not in pattern):
            known = ", ".join(keys.numbers(recipe))
            raise ValueError(
                f"{pattern}: is no value of this recipe; its numbers are {known}; to add a value "
                "write its whole path"
            )
        for key in found or [pattern]:
            keys.put(recipe, key, copy.deepcopy(value))  # of each recipe its own
            done[key] = value
    return done


def _floats(value: Any) -> Any:
    """The same with every number in floating point: 95 and 95.0 are one paint."""
    if isinstance(value, dict):
        return {key: _floats(inner) for key, inner in value.items()}
    if isinstance(value, list):
        return [_floats(inner) for inner in value]
    return float(value) if isinstance(value, int) and not isinstance(value, bool) else value


def _name(form: str, base: str, swept: dict[str, Any]) -> str:
    """What a record is called: it says what varies and not where in the plan it stands, so that a
    plan can grow and its records stay what they are."""
    if form:
        name = re.sub(r"\{([^{}]+)\}", lambda m: label(_by_end(swept, m[1], base)), form)
    else:
        parts = [f"{key.rsplit('.', 1)[-1]} {label(value)}" for key, value in swept.items()]
        name = ", ".join([base, *parts])
    return name if len(name) <= 200 else name[:197] + "..."


def _by_end(swept: dict[str, Any], end: str, base: str) -> Any:
    if end == "base":
        return base
    for key, value in swept.items():
        if key == end or key.endswith("." + end):
            return value
    raise ValueError(f"{{{end}}}: does not vary here; there are base, {', '.join(swept)}")


def _read_sweep(table: Table, folder: Path) -> Sweep:
    name = table.text("name", table.path)
    bases = _bases(table, folder)
    fixed = table.table("set")
    if fixed is not None:
        changes = fixed.items()
        for base, recipe in bases:
            _try(fixed, base, recipe, changes)
            apply(recipe, changes)
    method = table.choice("method", sampling.METHODS, "grid")
    vary = _vary(table.table("vary"), method)
    points = _points(table, method, vary)
    sweep = Sweep(
        name,
        tuple(bases),
        tuple(one.pattern for one in vary),
        tuple(points),
        table.text("name_format"),
    )
    table.done()
    if len(sweep) > MOST_RECORDS:
        raise table.error("count", f"= {len(sweep)} records: at most {MOST_RECORDS} in a sweep")
    for base, recipe in bases:
        _check_ends(table, base, recipe, vary)
        _check_first(table, sweep, base, recipe)
    return sweep


def _bases(table: Table, folder: Path) -> list[tuple[str, Recipe]]:
    """The base recipes, complete: files that they name are written into them."""
    inline = table.table("recipe")
    names = table.texts("base")
    if (inline is None) == (not names):
        raise table.error("base", "or a table recipe: one of both says where the sweep starts")
    found: list[tuple[str, Recipe]] = []
    try:
        if inline is not None:
            paint = Paint.from_dict(dict(inline.items()), folder)
            found.append((paint.name or table.path, _recipe(paint)))
        for name in names:
            path = folder / name
            if not path.is_file() and name not in shipped_paints():
                raise table.wrong("base", name, "a recipe's file or a paint that ships with Nacre")
            paint = Paint(path if path.is_file() else name)
            found.append((paint.name or Path(name).stem, _recipe(paint)))
    except InputError as error:
        if str(error).startswith(f"{table.file}:"):
            raise
        raise table.error("base" if names else "recipe", f": {error}") from None
    return found


def _recipe(paint: Paint) -> Recipe:
    recipe = paint.to_dict()
    for no_part_of_the_paint in ("fit", "uncertainty"):
        recipe.pop(no_part_of_the_paint, None)
    return recipe


def _vary(table: Table | None, method: str) -> list[Vary]:
    if table is None:
        return []
    return [Vary(pattern, _axis(table, pattern, value, method)) for pattern, value in table.items()]


def _axis(table: Table, pattern: str, value: Any, method: str) -> Axis:
    if isinstance(value, list):
        if not value:
            raise table.wrong(pattern, value, "a list of one value or more")
        return Choice(tuple(value))
    if not isinstance(value, dict) or method == "list":
        allowed = "a list of values"
        if method != "list":
            allowed += ", or a range { from = 1, to = 2 }"
        raise table.wrong(pattern, value, allowed)
    inner = Table(value, table.file, table.key(pattern))
    lo = inner.number("from", -1e300, 1e300, None)
    hi = inner.number("to", -1e300, 1e300, None)
    logarithmic = inner.choice("scale", ("linear", "log"), "linear") == "log"
    steps = inner.whole("steps", 2, 1_000_000, None) if method == "grid" else 0
    inner.done()
    if not lo < hi:
        raise inner.wrong("to", hi, f"above from = {lo:g}")
    if logarithmic and lo <= 0:
        raise inner.wrong("from", lo, "above 0 on a logarithmic scale")
    return Range(lo, hi, logarithmic, steps)


def _points(table: Table, method: str, vary: list[Vary]) -> list[Point]:
    axes = [one.axis for one in vary]
    drawn = method in ("latin-hypercube", "sobol")
    count = table.whole("count", 1, MOST_RECORDS, None) if drawn else 0
    seed = table.whole("seed", 0, 2**32 - 1, 0) if drawn else 0
    if not axes:
        if drawn:
            raise table.error("vary", f"is missing: method {method} draws from ranges")
        return [()]
    if method == "grid":
        return sampling.grid(axes)
    if method == "list":
        lists = [axis for axis in axes if isinstance(axis, Choice)]
        lengths = {one.pattern: len(axis.values) for one, axis in zip(vary, lists, strict=True)}
        if len(set(lengths.values())) > 1:
            raise table.error("vary", f"= {lengths}: lists of method list are equally long")
        return sampling.together(lists)
    draw = sampling.sobol if method == "sobol" else sampling.latin_hypercube
    return draw(axes, count, seed)


def _try(table: Table, base: str, recipe: Recipe, changes: list[tuple[str, Any]]) -> None:
    """Whether Nacre takes these values, each for itself. A number within its own range is let
    pass: what it does not go together with here may vary too."""
    known = Paint.from_dict(recipe).parameters
    for pattern, value in changes:
        try:
            changed = copy.deepcopy(recipe)
            found = apply(changed, [(pattern, value)])
            if not (is_number(value) and all(_is_inside(known.get(key), value) for key in found)):
                Paint.from_dict(changed)
        except (InputError, ValueError) as error:
            raise table.error(pattern, f"= {value!r}, in {base}: {error}") from None


def _is_inside(number: Parameter | None, value: float) -> bool:
    """Whether a value is allowed for sure; an end of a range may or may not belong to it."""
    return number is not None and number.lo < value < number.hi


def _check_ends(table: Table, base: str, recipe: Recipe, vary: list[Vary]) -> None:
    inside = Table({}, table.file, table.key("vary"))
    for one in vary:
        axis = one.axis
        ends = (axis.lo, axis.hi) if isinstance(axis, Range) else axis.values
        _try(inside, base, recipe, [(one.pattern, value) for value in ends])


def _check_first(table: Table, sweep: Sweep, base: str, recipe: Recipe) -> None:
    """What is wrong with the first record is wrong with the sweep, as a key that does not exist."""
    changed = copy.deepcopy(recipe)
    try:
        swept = apply(changed, zip(sweep.patterns, sweep.points[0], strict=True))
        _name(sweep.name_format, base, swept)
    except ValueError as error:
        raise table.error("name_format", f"= {sweep.name_format!r}: {error}") from None
    try:
        Paint.from_dict(changed)
    except Error as error:
        raise table.error("vary", f": the first record of {base}: {error}") from None
