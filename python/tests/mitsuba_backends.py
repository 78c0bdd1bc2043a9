"""Where Mitsuba's tests run: on the processor, and on the graphics card where there is one."""

from __future__ import annotations

import drjit as dr
import nacre.mitsuba  # noqa: F401, as it chooses an LLVM before Dr.Jit looks for one

BACKENDS = ["llvm", *(["cuda"] if dr.has_backend(dr.JitBackend.CUDA) else [])]
"""Beginnings of variants' names."""
