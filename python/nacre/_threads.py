from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager

from . import _nacre
from ._errors import naming

_limit = 0


@naming(count="threads")
def set_threads(count: int) -> None:
    """At most so many threads work at once, of all calls together; 0: all the machine has.
    SettingError beyond [0, 4096]."""
    global _limit
    _nacre.set_threads(count)
    _limit = count


@contextmanager
def threads(count: int) -> Iterator[None]:
    """``with nacre.threads(2): ...``: :func:`set_threads` for a while."""
    before = _limit
    set_threads(count)
    try:
        yield
    finally:
        set_threads(before)
