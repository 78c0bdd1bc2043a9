"""The exceptions of Nacre. Their texts are those that the command line prints."""

from __future__ import annotations

import inspect
import re
from collections.abc import Callable
from functools import wraps
from numbers import Integral, Real
from typing import Any, ParamSpec, TypeVar

_P = ParamSpec("_P")
_R = TypeVar("_R")


class Error(RuntimeError):
    """Something failed while running; the base of all that Nacre raises on purpose."""


class DomainError(Error, ValueError):
    """An argument is outside its valid range."""


class SettingError(DomainError):
    """A setting is out of range, or does not fit the paint that it is for."""

    setting: str = ""
    """The name of the setting, as Python spells it, with which the text begins."""

    def __init__(self, *args: object, setting: str = "") -> None:
        super().__init__(*args)
        self.setting = setting


class InputError(Error, ValueError):
    """A file, or a text, is wrong: names file, line, key, value and the allowed range."""


class Stopped(Error):
    """The work was stopped in its middle by its progress callback."""


def _python_spelling(text: str) -> str:
    """Options of the command line as keywords: "--no-hot-spot" is "hot_spot = off"."""

    def keyword(option: re.Match[str]) -> str:
        name = option[1].replace("-", "_")
        return f"{name.removeprefix('no_')} = off" if name.startswith("no_") else name

    return re.sub(r"(?<!\S)--([a-z][a-z-]*)", keyword, text)


def _refused(name: str, annotation: str, value: Any) -> Exception | None:
    """What is wrong with an argument that the extensions do not take."""
    if annotation.startswith("tuple[") and isinstance(value, tuple):
        kind = annotation.removeprefix("tuple[").split(",")[0]
        return next(filter(None, (_refused(name, kind, item) for item in value)), None)
    kind = annotation.split(" ")[0]
    if annotation in ("str", "str | None") and not isinstance(value, (str, type(None))):
        return TypeError(f"{name} = {value!r}: must be text")
    if kind not in ("int", "float") or (value is None and annotation.endswith("None")):
        return None
    if not isinstance(value, Real):
        return TypeError(f"{name} = {value!r}: must be a number")
    if kind == "float":
        return None
    if not isinstance(value, Integral):
        return TypeError(f"{name} = {value!r}: must be a whole number")
    if not 0 <= int(value) < 2**31:
        # Of negative numbers the extensions refuse those that have no meaning.
        what = "must not be negative" if int(value) < 0 else "is too large"
        return SettingError(f"{name} = {value}: {what}", setting=name)
    return None


def _named(
    error: DomainError, words: dict[str, tuple[str, ...]], arguments: list[str]
) -> DomainError | None:
    """The error as one about an argument; None if it is that already, or about none."""
    text, setting = str(error), error.setting if isinstance(error, SettingError) else ""
    for argument in arguments:
        if text.startswith((f"{argument}: ", f"{argument} = ", f"{argument} of ")):
            return None if setting == argument else SettingError(text, setting=argument)
    for argument, others in words.items():
        if setting in others:
            return SettingError(argument + text.removeprefix(setting), setting=argument)
        if any(word[1:] in text if word[0] == "*" else text.startswith(word) for word in others):
            return SettingError(f"{argument}: {text}", setting=argument)
    return None


def naming(**called: str | tuple[str, ...]) -> Callable[[Callable[_P, _R]], Callable[_P, _R]]:
    """For functions: what they raise about an argument is a SettingError that begins with its name.

    The library calls most settings as Python does, some by words of its own, and spells options as
    the command line does.

    Parameters
    ----------
    called
        By argument, what begins the library's messages about it, or, after a `*`, is in them.
    """
    words = {name: (w,) if isinstance(w, str) else w for name, w in called.items()}

    def decorate(function: Callable[_P, _R]) -> Callable[_P, _R]:
        signature = inspect.signature(function)
        arguments = list(signature.parameters)

        @wraps(function)
        def call(*args: _P.args, **kwargs: _P.kwargs) -> _R:
            better: Exception | None = None
            try:
                return function(*args, **kwargs)
            except (DomainError, InputError) as error:
                plain = _python_spelling(str(error))
                if plain != str(error):
                    error.args = (plain,)
                if isinstance(error, DomainError):
                    better = _named(error, words, arguments)
                elif ": must be in " in plain:  # the paint's file is not to blame
                    about = plain.removeprefix(
                        f"{getattr(args[0] if args else None, 'file', '')}: "
                    )
                    if about != plain:
                        better = _named(DomainError(about), words, [])
                if better is None:
                    raise
                raise better.with_traceback(error.__traceback__) from None
            except TypeError as error:
                if "incompatible function arguments" not in str(error):
                    raise
                for name, value in signature.bind(*args, **kwargs).arguments.items():
                    better = _refused(name, str(signature.parameters[name].annotation), value)
                    if better is not None:
                        raise better.with_traceback(error.__traceback__) from None
                raise

        return call

    return decorate
