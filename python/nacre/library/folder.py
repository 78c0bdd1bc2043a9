"""What stands at the top of a library's folder: the plan, the licence and the citation."""

from __future__ import annotations

import json
from pathlib import Path

import nacre

from .record import write_whole
from .sweep import SCHEMA, Plan

LIBRARY, LICENSE, CITATION = "library.toml", "LICENSE", "CITATION.cff"
PLANNED = "planned.txt"
"""The ids of the plan's records in its order, a line each."""

_LICENSE_TEXT = """\
The data of this library are dedicated to the public domain under CC0 1.0 Universal:
https://creativecommons.org/publicdomain/zero/1.0/legalcode

To the extent possible under law, the authors of this library have waived all copyright and related
or neighbouring rights to it. They offer it as it is and give no warranties of any kind.
"""


def _citation(plan: Plan) -> str:
    """CITATION.cff 1.2.0; JSON's strings are YAML's."""

    def text(value: str) -> str:
        return json.dumps(value, ensure_ascii=False)

    lines = [
        "cff-version: 1.2.0",
        'message: "If you use this library of paints, please cite it."',
        "type: dataset",
        f"title: {text(plan.name)}",
        "authors:",
        *(f"  - name: {text(author)}" for author in plan.authors or ["The Nacre authors"]),
        "license: CC0-1.0",
    ]
    if plan.description:
        lines.append(f"abstract: {text(plan.description)}")
    lines += [
        "references:",
        "  - type: software",
        '    title: "Nacre"',
        f"    version: {text(nacre.__version__)}",
        "    authors:",
        '      - name: "The Nacre authors"',
    ]
    return "\n".join(lines) + "\n"


def prepare(library: Path, plan: Plan, ids: list[str]) -> None:
    """Writes library.toml, planned.txt, LICENSE and CITATION.cff, each whole or not at all."""
    head = (
        f"# Written by nacre-library {nacre.__version__}; format {SCHEMA}, see docs/library.md.\n"
        f"# The plan as it was given, from {plan.file.name}:\n\n"
    )
    write_whole(library / LIBRARY, head + plan.text)
    write_whole(library / PLANNED, "".join(f"{identity}\n" for identity in ids))
    write_whole(library / LICENSE, _LICENSE_TEXT)
    write_whole(library / CITATION, _citation(plan))


def planned_ids(library: Path) -> list[str]:
    """The ids of what a library is to hold, in the plan's order.

    Raises
    ------
    nacre.InputError
        If the folder is no library.
    """
    file = library / PLANNED
    if not file.is_file():
        raise nacre.InputError(f"{library}: is no library: it has no {PLANNED}")
    return file.read_text(encoding="utf-8").split()
