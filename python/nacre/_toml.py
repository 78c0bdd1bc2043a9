"""Recipes as dictionaries: what tomllib reads, written again."""

from __future__ import annotations

import json
import math
from collections.abc import Mapping, Sequence
from typing import Any


def _key(key: str) -> str:
    plain = key.isascii() and key.replace("_", "").replace("-", "").isalnum()
    return key if plain else json.dumps(key, ensure_ascii=False)


def _value(value: Any, key: str) -> str:
    if isinstance(value, bool):
        return "true" if value else "false"
    if isinstance(value, str):
        return json.dumps(value, ensure_ascii=False).replace("\x7f", "\\u007f")
    if isinstance(value, Mapping):
        return "{" + ", ".join(f"{_key(k)} = {_value(v, k)}" for k, v in value.items()) + "}"
    if hasattr(value, "tolist"):  # numpy
        return _value(value.tolist(), key)
    if isinstance(value, int):
        return str(value)
    if isinstance(value, float):
        if math.isfinite(value):
            return repr(value)
        return str(value)  # nan, inf: TOML has them, and the reader refuses them by name
    if isinstance(value, Sequence):
        return "[" + ", ".join(_value(v, key) for v in value) + "]"
    raise TypeError(f"{key}: a recipe holds no {type(value).__name__}")


def _is_list_of_tables(value: Any) -> bool:
    return (
        isinstance(value, Sequence)
        and len(value) > 0
        and all(isinstance(item, Mapping) for item in value)
    )


def _lines(table: Mapping[str, Any], path: str) -> list[str]:
    lines: list[str] = []
    tables: list[str] = []
    for key, value in table.items():
        if not isinstance(key, str):
            raise TypeError(f"{key!r}: the keys of a recipe are text")
        inner = f"{path}.{_key(key)}" if path else _key(key)
        if isinstance(value, Mapping):
            tables += ["", f"[{inner}]", *_lines(value, inner)]
        elif _is_list_of_tables(value):
            for item in value:
                tables += ["", f"[[{inner}]]", *_lines(item, inner)]
        else:
            lines.append(f"{_key(key)} = {_value(value, key)}")
    return lines + tables


def dumps(table: Mapping[str, Any]) -> str:
    """The table as TOML, which tomllib.loads() reads back to an equal one."""
    return "\n".join(_lines(table, "")) + "\n"
