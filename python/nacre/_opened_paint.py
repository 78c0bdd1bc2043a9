"""What the parts of a paint share: its handle in the C++ library."""

from __future__ import annotations

from . import _nacre
from ._arrays import Floats


class OpenedPaint:
    """A paint that has been opened."""

    _paint: _nacre.Paint

    @property
    def wavelengths_nm(self) -> Floats:
        """(W,) at which values are given where none are asked for."""
        return self._paint.wavelengths_nm(None)
