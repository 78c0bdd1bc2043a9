"""What `progress` may be: False, True for a bar, or a function of the fraction done."""

from __future__ import annotations

import sys
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from typing import Any

Progress = bool | Callable[[float], object]
"""False: silent. True: a bar, by tqdm where it is installed. A function is called several times a
second with the fraction done, in [0, 1], from the calling thread; where it returns False (or
NumPy's) the work stops the next time that it asks whether to go on, and raises Stopped unless it
has something to hand over; work that ends before that is returned."""


class _Line:
    """A percentage that is redrawn in place, where there is no tqdm."""

    def __init__(self, label: str) -> None:
        self._label = label

    def update(self, fraction: float) -> None:
        sys.stderr.write(f"\r{self._label} {100 * fraction:3.0f} %")

    def close(self) -> None:
        sys.stderr.write("\n")


class _Tqdm:
    def __init__(self, label: str, bar: Any) -> None:
        self._bar = bar(
            total=1.0, desc=label, bar_format="{desc}: {percentage:3.0f}% |{bar}| {elapsed}"
        )

    def update(self, fraction: float) -> None:
        self._bar.n = fraction
        self._bar.refresh()

    def close(self) -> None:
        self._bar.close()


@contextmanager
def reporter(progress: Progress, label: str) -> Iterator[Callable[[float], object] | None]:
    """The function that the extensions call, or None."""
    if callable(progress):
        yield progress
    elif not progress:
        yield None
    else:
        bar: _Line | _Tqdm
        try:
            from tqdm.auto import tqdm
        except ImportError:
            bar = _Line(label)
        else:
            bar = _Tqdm(label, tqdm)
        try:
            yield bar.update
        finally:
            bar.close()
