"""Refuses processors that the extensions were not compiled for, which would end the program."""

from __future__ import annotations

from pathlib import Path

from ._build import MARCH

# Beyond x86-64-v2; "abm" is how Linux calls lzcnt.
_V3 = {"avx", "avx2", "bmi1", "bmi2", "f16c", "fma", "abm", "movbe"}


def missing(march: str, cpuinfo: str) -> set[str]:
    """What a processor lacks, by what Linux says of it. Nothing where that does not tell."""
    if march != "x86-64-v3":
        return set()
    for line in cpuinfo.splitlines():
        name, _, value = line.partition(":")
        if name.strip() == "flags":
            return _V3 - set(value.split())
    return set()


def check() -> None:
    """Raises ImportError saying what the processor lacks."""
    info = Path("/proc/cpuinfo")
    lacking = missing(MARCH, info.read_text() if info.is_file() else "")
    if lacking:
        raise ImportError(
            f"nacre was compiled for {MARCH} processors, and this one lacks "
            f"{', '.join(sorted(lacking))}: install it from its sources (pip install . in a clone)"
        )


check()
