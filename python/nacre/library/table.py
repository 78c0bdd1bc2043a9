"""Reading the tables of a plan: every key is known, every value in its range."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

from nacre import InputError


class Table:
    """A table of a file, whose keys are taken one by one; :meth:`done` refuses what is left.

    All readers raise InputError naming file, key, value and what is allowed.
    """

    def __init__(self, values: Mapping[str, Any], file: str | Path, path: str = "") -> None:
        """From what tomllib read; ``path`` is the table's own, for messages."""
        self._values = dict(values)
        self._known: list[str] = []
        self.file = file
        self.path = path

    def key(self, name: str) -> str:
        """The whole path of a key."""
        plain = name.replace("_", "").replace("-", "").isalnum()
        name = name if plain else f'"{name}"'
        return f"{self.path}.{name}" if self.path else name

    def error(self, name: str, message: str) -> InputError:
        return InputError(f"{self.file}: {self.key(name)} {message}")

    def wrong(self, name: str, value: Any, allowed: str) -> InputError:
        return self.error(name, f"= {value!r}: must be {allowed}")

    def take(self, name: str, default: Any = None) -> Any:
        """The value as it stands; a key is known once it was asked for."""
        self._known.append(name)
        return self._values.pop(name, default)

    def required(self, name: str, allowed: str) -> Any:
        value = self.take(name)
        if value is None:
            raise self.error(name, f"is missing: {allowed}")
        return value

    def text(self, name: str, default: str = "") -> str:
        value = self.take(name, default)
        if not isinstance(value, str):
            raise self.wrong(name, value, "text")
        return value

    def choice(self, name: str, allowed: Sequence[str], default: str) -> str:
        value = self.text(name, default)
        if value not in allowed:
            raise self.wrong(name, value, "one of " + ", ".join(allowed))
        return value

    def flag(self, name: str, default: bool = False) -> bool:
        value = self.take(name, default)
        if not isinstance(value, bool):
            raise self.wrong(name, value, "true or false")
        return value

    def whole(self, name: str, lo: int, hi: int, default: int | None) -> int:
        value = self.take(name, default)
        if value is None:
            raise self.error(name, f"is missing: a whole number in [{lo}, {hi}]")
        if not isinstance(value, int) or isinstance(value, bool) or not lo <= value <= hi:
            raise self.wrong(name, value, f"a whole number in [{lo}, {hi}]")
        return value

    def number(self, name: str, lo: float, hi: float, default: float | None) -> float:
        value = self.take(name, default)
        if value is None:
            raise self.error(name, f"is missing: a number in [{lo:g}, {hi:g}]")
        if not is_number(value) or not lo <= value <= hi:
            raise self.wrong(name, value, f"a number in [{lo:g}, {hi:g}]")
        return float(value)

    def texts(self, name: str, default: Sequence[str] = ()) -> list[str]:
        """A list of texts; a text stands for a list of one."""
        value = self.take(name, list(default))
        if isinstance(value, str):
            return [value]
        if not isinstance(value, list) or not all(isinstance(x, str) for x in value):
            raise self.wrong(name, value, "a text or a list of texts")
        return value

    def table(self, name: str) -> Table | None:
        """A table within; None without it."""
        value = self.take(name)
        if value is None:
            return None
        if not isinstance(value, dict):
            raise self.wrong(name, value, "a table")
        return Table(value, self.file, self.key(name))

    def tables(self, name: str) -> list[Table]:
        """The tables of ``[[name]]``."""
        value = self.take(name, [])
        if not isinstance(value, list) or not all(isinstance(x, dict) for x in value):
            raise self.wrong(name, value, f"tables, each headed by [[{self.key(name)}]]")
        return [Table(x, self.file, f"{self.key(name)}[{i}]") for i, x in enumerate(value)]

    def items(self) -> list[tuple[str, Any]]:
        """All that is left, for tables whose keys are the user's own."""
        left = list(self._values.items())
        self._values.clear()
        return left

    def done(self) -> None:
        for name, value in self._values.items():
            known = ", ".join(self._known)
            raise self.error(name, f"= {value!r}: unknown key; allowed here: {known}")


def is_number(value: Any) -> bool:
    """Whether TOML's value is a finite number."""
    return isinstance(value, int | float) and not isinstance(value, bool) and math.isfinite(value)
