"""Which LLVM Dr.Jit compiles with, asked before it is too late to say anything."""

from __future__ import annotations

import os
import re
from collections.abc import Iterable, Iterator
from pathlib import Path

from .._errors import Error

ENVIRONMENT = "DRJIT_LIBLLVM_PATH"
ABORTS = (15, 16)
"""Versions with which Dr.Jit 1.5 ends the process: it asks them for a code generator that they
lack."""
RECOMMENDED = 19
ADVICE = (
    f"install LLVM {RECOMMENDED} (Debian, Ubuntu: apt-get install libllvm{RECOMMENDED}) "
    f"or let {ENVIRONMENT} name its library"
)

FOLDERS = ("/usr/lib/x86_64-linux-gnu", "/usr/lib64", "/usr/lib", "/usr/local/lib")


def version_of(library: str) -> int | None:
    """The major version of a library of LLVM by its name, or by that which a link leads to.

    >>> [version_of(name) for name in ("libLLVM.so.19.1", "libLLVM-15.so.1", "libm.so.6")]
    [19, 15, None]
    """
    for name in (Path(library).name, Path(os.path.realpath(library)).name):
        match = re.match(r"libLLVM(?:-(\d+)[.\d]*\.so|\.so\.(\d+)|-?(\d+)?\.dylib)", name)
        if match:
            found = next((group for group in match.groups() if group), None)
            if found:
                return int(found)
    return None


def installed(folders: Iterable[str] = FOLDERS) -> Iterator[tuple[int, str]]:
    """Version and path of the libraries that there are."""
    for folder in folders:
        for path in sorted(Path(folder).glob("libLLVM*.so*")):
            version = version_of(str(path))
            if version is not None:
                yield version, str(path)


def choose_llvm(folders: Iterable[str] = FOLDERS) -> None:
    """Sets the variable by which Dr.Jit finds LLVM, unless it is set.

    Raises
    ------
    Error
        If it names a version with which Dr.Jit aborts, or there are no others.
    """
    named = os.environ.get(ENVIRONMENT)
    if named:
        version = version_of(named)
        if version in ABORTS:
            raise Error(f"{ENVIRONMENT} = {named}: Dr.Jit aborts with LLVM {version}; {ADVICE}")
        return
    found = list(installed(folders))
    usable = [(v, path) for v, path in found if v not in ABORTS]
    if usable:
        # The one that is tested, else the newest.
        os.environ[ENVIRONMENT] = max(usable, key=lambda x: (x[0] == RECOMMENDED, x[0]))[1]
    elif found:
        versions = ", ".join(sorted({str(v) for v, _ in found}))
        raise Error(f"Dr.Jit aborts with the LLVM that is installed ({versions}); {ADVICE}")
    # None: Dr.Jit says so itself where it needs one; scalar variants and CUDA do not.
