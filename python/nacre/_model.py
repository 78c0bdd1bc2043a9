from __future__ import annotations

from collections.abc import Callable
from functools import lru_cache
from typing import Any

import numpy as np

from . import _nacre
from ._errors import SettingError, naming


def model_names() -> list[str]:
    """The names of the appearance models, the default first."""
    return list(_nacre.model_names())


def _text(value: object) -> str:
    if isinstance(value, (bool, np.bool_)):
        return "on" if value else "off"
    return str(value)


class Model:
    """An appearance model and what is chosen about it.

    Parameters
    ----------
    name
        One of :func:`model_names`: ``microflake``, ``nacre``, ...
    **options
        Those of the command line with ``_`` for ``-``: ``Model("nacre", specimen=1,
        hot_spot=False)``. A switch is True or False, a choice its name.

    Raises
    ------
    SettingError
        If there is no such model, it has no such option, or a value is not allowed.
    """

    @naming(name="model")
    def __init__(self, name: str, **options: bool | int | str) -> None:
        self.name = name
        self.options = {key: _text(value) for key, value in sorted(options.items())}
        # flakes="explicit" is for pictures alone, and known to _render.
        here = {key: value for key, value in self.options.items() if key != "flakes"}
        self._model = _nacre.Model(name, here)

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Model) and (self.name, self.options) == (other.name, other.options)

    def __hash__(self) -> int:
        return hash((self.name, *self.options.items()))

    def __reduce__(self) -> tuple[Callable[..., Model], tuple[str, dict[str, str]]]:
        return _with_options, (self.name, self.options)

    def __repr__(self) -> str:
        options = "".join(f", {key}={value!r}" for key, value in self.options.items())
        return f"Model({self.name!r}{options})"


def _with_options(name: str, options: dict[str, str]) -> Model:
    return Model(name, **options)


ModelLike = Model | str | None
"""A model, the name of one with its default options, or None for the default one."""


@naming(model="name")
@lru_cache(maxsize=64)
def _named(model: str) -> Model:
    return Model(model)


def _chosen(model: Model | str) -> Model:
    if isinstance(model, str):
        return _named(model)
    if not isinstance(model, Model):
        raise TypeError(f"model: must be a Model or the name of one, not {type(model).__name__}")
    return model


def settings_of(model: ModelLike, what: str = "values") -> Any:
    """For the extension _nacre."""
    if model is None:
        return None
    chosen = _chosen(model)
    if chosen.options.get("flakes", "hashed") != "hashed":
        raise SettingError(
            f"flakes = {chosen.options['flakes']}: is for pictures, not for {what}",
            setting="flakes",
        )
    return chosen._model


def choice_of(model: ModelLike) -> tuple[str, dict[str, str]] | None:
    """For the extension _render."""
    if model is None:
        return None
    chosen = _chosen(model)
    return chosen.name, chosen.options
