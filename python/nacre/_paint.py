"""A paint: opened, changed; what it can be asked is in its parts."""

from __future__ import annotations

import os
import tomllib
from collections.abc import Callable, Iterator, Mapping
from typing import Any

from . import _html, _nacre, _toml
from ._arrays import Path
from ._errors import DomainError, InputError
from ._paint_files import PaintFiles
from ._paint_light import PaintLight
from ._values import Parameter


class Paint(PaintLight, PaintFiles):
    """A paint, from a file of any kind that Nacre reads: a recipe (.toml), a solved paint or a
    table (.h5), a measured BRDF (.bsdf, .binary), measured colours (.csv, .json, CGATS). Contents
    tell. One sample of several is named behind the file: ``Paint("panels.csv#Silver 2")``.

    The recipe is solved once, when values are first asked for; ``paint[key] = value`` makes it
    another paint, to be solved anew.

    Raises
    ------
    InputError
        Naming the file and what is wrong in it.
    """

    def __init__(self, path: Path) -> None:
        """From a file of any kind, or a shipped paint by its name (:func:`shipped_paints`)."""
        self._paint = _nacre.Paint.open(os.fsdecode(path))

    @classmethod
    def _of(cls, native: _nacre.Paint) -> Paint:
        paint = cls.__new__(cls)
        paint._paint = native
        return paint

    @classmethod
    def from_bytes(cls, data: bytes, name: str, folder: Path | None = None) -> Paint:
        """From the contents of a file of any kind.

        Parameters
        ----------
        name
            Of the file, for messages.
        folder
            Where the names of materials in a recipe start; without it, it may name no files.
        """
        return cls._of(
            _nacre.Paint.from_bytes(data, name, None if folder is None else os.fsdecode(folder))
        )

    @classmethod
    def from_toml(cls, text: str, folder: Path | None = None) -> Paint:
        """From the text of a recipe (docs/recipe.md). Raises InputError naming line and key."""
        return cls.from_bytes(text.encode(), "recipe", folder)

    @classmethod
    def from_dict(cls, recipe: Mapping[str, Any], folder: Path | None = None) -> Paint:
        """From a recipe as a dictionary, with the keys of its file, as :meth:`to_dict` gives it."""
        return cls.from_toml(_toml.dumps(recipe), folder)

    def copy(self) -> Paint:
        """The same paint, which shares its solution until one of both is changed."""
        return Paint._of(self._paint)

    __copy__ = copy

    def __deepcopy__(self, memo: object) -> Paint:
        return self.copy()

    def __reduce__(self) -> tuple[Callable[..., Paint], tuple[bytes, str, str]]:
        # By contents and not by path: in another process, or later, the file may be another.
        return _from_contents, self._paint.contents()

    # What it is

    @property
    def kind(self) -> str:
        """recipe, solved_paint, brdf_table, measured_brdf or measured_colours."""
        return str(self._paint.kind)

    @property
    def name(self) -> str:
        """The recipe's, or the file's without folder and extension."""
        return str(self._paint.name)

    @property
    def file(self) -> str:
        """Its path; "recipe" where it was a text or a dictionary."""
        return str(self._paint.file)

    @property
    def sha256(self) -> str:
        """Of what the recipe says, whatever its layout; empty without a recipe."""
        return str(self._paint.sha256)

    def to_dict(self) -> dict[str, Any]:
        """The recipe as a dictionary."""
        return tomllib.loads(self.to_toml())

    # Its numbers

    @property
    def parameters(self) -> dict[str, Parameter]:
        """The numbers of the recipe by their whole keys, with what each may be."""
        return {p[0]: Parameter(*p) for p in self._paint.parameters()}

    def __getitem__(self, key: str) -> float:
        """A number by its key, or the end of it: ``paint["coats[0].thickness_nm"]``.

        Raises
        ------
        DomainError
            If the recipe has no such number, or several keys end so.
        """
        return float(self._paint.value(key))

    def __setitem__(self, key: str, value: float) -> None:
        """Changes a number; DomainError names key, value and range."""
        self._paint = self._paint.with_value(key, value)

    def __iter__(self) -> Iterator[str]:
        return iter(self.parameters)

    def __contains__(self, key: object) -> bool:
        """Whether ``paint[key]`` is one number."""
        try:
            return isinstance(key, str) and bool(self.whole_key(key))
        except (DomainError, InputError):
            return False

    def whole_key(self, key: str) -> str:
        """The key of the number that the end of a key means.

        Raises
        ------
        DomainError
            If the recipe has no such number, or several keys end so.
        """
        return str(self._paint.whole_key(key))

    def with_values(self, values: Mapping[str, float]) -> Paint:
        """A copy with some numbers changed."""
        changed = self.copy()
        for key, value in values.items():
            changed[key] = value
        return changed

    def __repr__(self) -> str:
        return f"<Paint {self.name!r}: {self.kind}>"

    def _repr_html_(self) -> str:
        if self.kind in ("recipe", "solved_paint"):
            rows = [[p.key, p.value, p.unit] for p in self.parameters.values()]
            return _html.table([self.name, "", ""], rows)
        return _html.table([self.name], [[self.kind.replace("_", " ")]])


def as_paint(paint: Paint | Path, argument: str, instead: str = "a Paint") -> Paint:
    """The paint, or the one of that path or shipped name. Raises TypeError naming the argument."""
    if isinstance(paint, Paint):
        return paint
    if isinstance(paint, (str, bytes, os.PathLike)):
        return Paint(paint)
    raise TypeError(f"{argument}: must be {instead} or a path, not {type(paint).__name__}")


def _from_contents(data: bytes, name: str, sample: str) -> Paint:
    return Paint._of(_nacre.Paint.from_bytes(data, name, None, sample))


def shipped_paints() -> list[str]:
    """The names of the recipes that ship with Nacre, which :class:`Paint` opens."""
    return list(_nacre.shipped_paints())
