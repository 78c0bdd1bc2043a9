"""The library that is committed, library/paints, holds what its plan says and what Nacre computes.

Where a test fails because Nacre, the plan or the paints have changed: ./dev library --shipped
"""

from __future__ import annotations

import shutil
import subprocess
import tomllib
from pathlib import Path

import numpy as np
import pytest
from conftest import ROOT, Run
from nacre.library import Catalogue, Plan, find, page
from nacre.library.folder import planned_ids
from nacre.library.record import read_record, record_folder, record_ids

import nacre

PLAN = ROOT / "library" / "paints.toml"
LIBRARY = ROOT / "library" / "paints"
MOST_BYTES = 3_000_000

ROUNDING = 1e-5
"""Relative. The committed numbers may be of another kind of processor, whose sums round otherwise;
the commands in the documentation are held to as many digits, and no change of the physics that is
worth a new library hides below."""
BLACK = 1e-12
"""Of a reflectance factor: the solver's own rounding, kBlackBrdf times its tolerance. Of what bare
opaque flakes reflect at 110 deg, 8e-9, it is more than the digits above."""


def test_it_has_every_paint_that_ships() -> None:
    shipped = {nacre.Paint(name).sha256: name for name in nacre.shipped_paints()}
    assert len(shipped) == len(list((ROOT / "paints").rglob("*.toml")))
    there = {row["recipe_sha256"] for row in Catalogue(LIBRARY).rows(["recipe_sha256"])}
    assert sorted(name for sha256, name in shipped.items() if sha256 not in there) == []
    assert there <= shipped.keys()


def test_it_is_the_library_of_its_plan() -> None:
    """The id of a record is a hash of its recipe, of what is computed and of Nacre's version."""
    planned = [record.id for record in Plan(PLAN).records()]
    assert planned_ids(LIBRARY) == planned
    assert record_ids(LIBRARY) == set(planned)
    given = (LIBRARY / "library.toml").read_text("utf-8")
    assert tomllib.loads(given) == tomllib.loads(PLAN.read_text("utf-8"))


@pytest.mark.parametrize("identity", sorted(record_ids(LIBRARY)))
def test_readings_are_what_the_program_measures(
    identity: str, nacre_program: Run, tmp_path: Path
) -> None:
    folder = record_folder(LIBRARY, identity)
    for file, command in read_record(LIBRARY, identity)["commands"].items():
        arguments = [folder / x if x == "recipe.toml" else x for x in command[1:]]
        (tmp_path / file).write_text(nacre_program(*arguments).stdout, "utf-8")
        now = nacre.Measurement.read(tmp_path / file)
        then = nacre.Measurement.read(folder / file)
        assert now.geometries == then.geometries
        np.testing.assert_allclose(now.R, then.R, rtol=ROUNDING, atol=BLACK)
        np.testing.assert_allclose(now.Lab, then.Lab, rtol=ROUNDING, atol=1e-3)


def test_no_file_was_changed_and_all_are_small() -> None:
    check = ["sha256sum", "--check", "--quiet", "checksums.sha256"]
    assert subprocess.run(check, cwd=LIBRARY, check=False).returncode == 0
    files = [file for file in LIBRARY.rglob("*") if file.is_file()]
    assert sum(file.stat().st_size for file in files) < MOST_BYTES


def test_its_page_is_up_to_date(tmp_path: Path) -> None:
    """Else: nacre-library page library/paints"""
    copy = tmp_path / "paints"
    shutil.copytree(LIBRARY, copy)
    page.write_page(copy)
    for file in sorted(copy.rglob("*")):
        if file.is_file():
            there = LIBRARY / file.relative_to(copy)
            assert file.read_bytes() == there.read_bytes(), there.relative_to(ROOT)


def test_it_is_searched(nacre_program: Run, tmp_path: Path) -> None:
    (match,) = find(LIBRARY, "ruby", 1)
    assert match.name == nacre.Paint("ruby").name
    assert match.mean_dE2000 < 1e-3
    standard = tmp_path / "standard.csv"
    nacre.Paint("glitter-100um").measure(wavelengths_nm=range(400, 701, 50)).write(standard)
    text = nacre_program(
        *("fit", standard, "--library", LIBRARY, "--constructions", "1", "--starts", "1")
    ).stdout
    assert "matches  clear / Al (from " in text
