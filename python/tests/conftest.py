"""What tests share. The extension is looked for where PYTHONPATH says, or installed."""

from __future__ import annotations

import csv
import io
import os
import subprocess
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import TYPE_CHECKING

import pytest

if TYPE_CHECKING:  # it wants packages that not all tests have
    from nacre.library import Plan

ROOT = Path(__file__).resolve().parents[2]
MARK = "skipped, for a reason: "  # src/nacre/testing/check_skips.py looks for it

Run = Callable[..., subprocess.CompletedProcess[str]]


@pytest.fixture(scope="session")
def paints() -> Path:
    return ROOT / "paints"


@pytest.fixture(scope="session")
def program_path() -> Path:
    """Of the command line."""
    program = Path(os.environ.get("NACRE_PROGRAM", ROOT / "build" / "nacre"))
    if not program.is_file():
        pytest.skip(f"there is no program {program.name} to compare with (NACRE_PROGRAM)")
    return program.absolute()


@pytest.fixture(scope="session")
def nacre_program(program_path: Path) -> Run:
    """Runs the command line, to compare with."""

    def run(*arguments: object, status: int = 0) -> subprocess.CompletedProcess[str]:
        process = subprocess.run(
            [program_path, *map(str, arguments)], capture_output=True, text=True, check=False
        )
        assert process.returncode == status, process.stderr
        return process

    return run


def plan_of(folder: Path, text: str) -> Plan:
    """Of a library, from a file that is written there."""
    from nacre.library import Plan

    (folder / "plan.toml").write_text(text, encoding="utf-8")
    return Plan(folder / "plan.toml")


def rows(text: str) -> list[dict[str, str]]:
    """Of a table that the command line printed."""
    table = list(csv.DictReader(io.StringIO(text)))
    assert table
    return table


@pytest.hookimpl(wrapper=True)
def pytest_terminal_summary(terminalreporter: pytest.TerminalReporter) -> Iterator[None]:
    """Says why tests were skipped, so that CTest's check hears of it."""
    yield
    for report in terminalreporter.stats.get("skipped", []):
        reason = report.longrepr[2].removeprefix("Skipped: ")
        terminalreporter.write_line(f"{MARK}{report.nodeid}: {reason}")
