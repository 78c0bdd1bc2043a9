"""Records, the catalogue, searches and exports of a library, in one process."""

from __future__ import annotations

import csv
import dataclasses
import hashlib
import json
import random
import re
import subprocess
import tomllib
import zipfile
from pathlib import Path

import numpy as np
import pytest
from conftest import Run, plan_of
from nacre.library import Catalogue, Plan, cli, engine, find
from nacre.library.record import compute, failures, read_record, record_folder, record_ids

import nacre

PLAN = """
[library]
name = "Some paints"
description = "To be tested with"
authors = ["A. Painter"]

[record]
geometries = ["byk-mac", "15as15,45as25az90"]

[record.sparkle]
lamps_deg = [15]
field_mm = 1.5
diffuse_samples = 2

[record.thumbnails]
ball = { size = 16, samples = 1 }

[[sweep]]
name = "as they are"
base = ["solid-red", "candy-red"]

[[sweep]]
name = "pearls"
base = "tio2-mica-80"
method = "latin-hypercube"
count = 6
seed = 3
[sweep.set]
"layer[0].flakes[0].waviness" = 0.02
[sweep.vary]
"coats[0].thickness_nm" = { from = 50, to = 150 }
"coats[0].material" = ["TiO2_anatase", "SiO2"]

[[sweep]]
name = "prescribed"
base = "metallic-gray"
[sweep.vary]
"flakes[0].reflectance" = { from = 0.3, to = 0.9, steps = 2 }
"flakes[0].transmittance" = { from = 0.05, to = 0.6, steps = 2 }
"""
RECORDS, REFUSED = 12, 1  # of the last sweep one reflects and transmits more than there is


@pytest.fixture(scope="module")
def library(tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("library")
    (folder / "plan.toml").write_text(PLAN, encoding="utf-8")
    summary = engine.run(Plan(folder / "plan.toml"), folder / "made", workers=0)
    assert (summary.planned, summary.found) == (RECORDS, 0)
    assert (summary.computed, summary.failed) == (RECORDS - REFUSED, REFUSED)
    return folder / "made"


# Records


def test_ten_drawn_records_are_what_the_program_measures(library: Path, nacre_program: Run) -> None:
    for identity in random.Random(1).sample(sorted(record_ids(library)), 10):
        folder = record_folder(library, identity)
        for file, command in read_record(library, identity)["commands"].items():
            arguments = [folder / x if x == "recipe.toml" else x for x in command[1:]]
            assert nacre_program(*arguments).stdout == (folder / file).read_text("utf-8")


def test_a_record_says_what_it_holds(library: Path) -> None:
    catalogue = {row["id"]: row for row in Catalogue(library).rows()}
    for identity, row in catalogue.items():
        record = read_record(library, identity)
        folder = record_folder(library, identity)
        paint = nacre.Paint(folder / "recipe.toml")
        assert row["parameters"] == {k: p.value for k, p in paint.parameters.items()}
        assert row["recipe_sha256"] == paint.sha256
        assert row["name"] == paint.name
        reading = nacre.Measurement.read(folder / "readings.csv")
        assert row["geometries"] == [*reading.geometries, "15as15", "45as25az90"]
        assert np.array_equal(row["Lab"][:6], reading.Lab)
        assert np.array_equal(row["R"][:6], reading.R.astype(np.float32))
        assert np.array_equal(record["readings"]["R"][:6], reading.R)
        assert [row["L45"], row["a45"], row["b45"]] == reading.Lab[3].tolist()
        assert row["flop_index"] == reading.flop_index
        assert row["thumbnails"] == ["ball.png"]
        assert {file.name for file in folder.iterdir()} == set(row["files"])
        if row["sweep"] != "as they are":
            continue
        sparkle = paint.sparkle(lamps_deg=[15], field_mm=1.5, diffuse_samples=2)
        assert row["sparkle"][0]["sparkle"] == sparkle.lamps[0].sparkle.value
        assert sparkle.diffuse is not None
        assert row["graininess"] == sparkle.diffuse.graininess.value
    pearl = next(row for row in catalogue.values() if row["sweep"] == "pearls")
    assert list(pearl["swept"]) == ["layer[0].flakes[0].coats[0].thickness_nm"]
    assert pearl["swept_names"].keys() == {"layer[0].flakes[0].coats[0].material"}
    assert pearl["parameters"]["layer[0].flakes[0].waviness"] == 0.02


def test_what_fails_says_why_and_is_not_tried_again(
    library: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    (why,) = failures(library).values()
    assert why["swept"] == {
        "layer[0].flakes[0].reflectance": 0.9,
        "layer[0].flakes[0].transmittance": 0.6,
    }
    assert "reflectance + transmittance = 1.5" in why["error"]
    assert why["again"] is False
    folders = [record_folder(library, identity) for identity in record_ids(library)]
    before = {folder: (folder / "record.json").stat().st_mtime_ns for folder in folders}
    plan = str(library.parent / "plan.toml")
    status = cli.main(["run", plan, str(library), "--workers", "0"])
    assert status == cli.INCOMPLETE
    assert "11 were there, 0 computed" in capsys.readouterr().err
    for folder, written in before.items():
        assert (folder / "record.json").stat().st_mtime_ns == written
    assert cli.main(["status", str(library)]) == cli.INCOMPLETE
    out = capsys.readouterr().out
    assert "planned 12\ndone    11\nfailed  1\nmissing 0\n" in out
    assert "reflectance + transmittance" in out


def test_a_worker_with_another_version_is_noticed(tmp_path: Path) -> None:
    plan = plan_of(tmp_path, '[[sweep]]\nbase = "metallic-gray"\n')
    (record,) = plan.records()
    record = dataclasses.replace(record, version="0.0.1")
    outcome = compute(record, plan.settings, tmp_path)
    assert "Nacre 0.0.1 was asked for" in outcome.error
    (why,) = failures(tmp_path).values()
    assert why["again"] is True  # by a worker with the right one


def test_a_plan_that_shrinks_keeps_its_records_until_they_are_pruned(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    form = '[[sweep]]\nbase = "metallic-gray"\nvary = {"*alpha" = [%s]}\n'
    library = tmp_path / "made"
    assert engine.run(plan_of(tmp_path, form % "0.1, 0.2"), library, workers=0).computed == 2
    shrunk = plan_of(tmp_path, form % "0.2")
    assert engine.run(shrunk, library, workers=0).found == 1
    assert len(Catalogue(library)) == 1
    assert len(record_ids(library)) == 2
    engine.run(shrunk, library, workers=0, prune=True)
    assert len(record_ids(library)) == 1
    with engine.only_run(library), pytest.raises(nacre.Error, match="another run is at work"):
        engine.run(shrunk, library, workers=0)
    capsys.readouterr()
    assert cli.main(["plan", str(tmp_path / "plan.toml"), str(library)]) == cli.OK
    out = capsys.readouterr().out
    assert "sweep[0]        1     1       0      0" in out
    assert "measured here and now on up to 1 of each sweep's records" in out


# The catalogue


def test_checksums_are_those_of_all_files(library: Path) -> None:
    listed = set()
    for line in (library / "checksums.sha256").read_text("utf-8").splitlines():
        sha256, name = line.split("  ", 1)
        assert hashlib.sha256((library / name).read_bytes()).hexdigest() == sha256, name
        listed.add(name)
    there = {f.relative_to(library).as_posix() for f in library.rglob("*") if f.is_file()}
    there = {name for name in there if not name.startswith(("failed/", ".lock"))}
    assert listed == there - {"checksums.sha256"}


def test_other_programs_read_the_catalogue(library: Path) -> None:
    import duckdb
    import pandas

    file = library / "catalogue.parquet"
    frame = pandas.read_parquet(file)
    assert len(frame) == RECORDS - REFUSED
    assert list(frame.sweep.unique()) == ["as they are", "pearls", "prescribed"]
    found = duckdb.sql(
        f"select name, swept['layer[0].flakes[0].coats[0].thickness_nm'] from '{file}' "
        "where sweep = 'pearls' order by L45"
    )
    assert found is not None
    pearls = frame[frame.sweep == "pearls"].sort_values("L45")
    rows = found.fetchall()
    assert [name for name, _ in rows] == list(pearls.name)
    assert all(50 <= thickness <= 150 for _, thickness in rows)


def test_the_plan_licence_and_citation_are_there(library: Path) -> None:
    assert tomllib.loads((library / "library.toml").read_text("utf-8")) == tomllib.loads(PLAN)
    assert "CC0 1.0" in (library / "LICENSE").read_text("utf-8")
    citation = (library / "CITATION.cff").read_text("utf-8")
    assert 'title: "Some paints"' in citation
    assert '- name: "A. Painter"' in citation
    assert "license: CC0-1.0" in citation


def test_another_schema_is_refused(tmp_path: Path) -> None:
    import pyarrow as pa
    import pyarrow.parquet as pq

    table = pa.table({"id": ["a"]}).replace_schema_metadata({"nacre:library_schema": "99"})
    pq.write_table(table, tmp_path / "catalogue.parquet")
    with pytest.raises(nacre.InputError, match="schema version 99: this Nacre reads 1"):
        Catalogue(tmp_path)
    with pytest.raises(nacre.InputError, match="is no library"):
        Catalogue(tmp_path / "none")


# Finding


def test_a_paint_of_the_library_is_found(library: Path, tmp_path: Path) -> None:
    row = Catalogue(library).rows()[4]
    recipe = record_folder(library, row["id"]) / "recipe.toml"
    best = find(library, recipe, 3, sparkle_weight=1)
    assert (best[0].id, best[0].distance) == (row["id"], 0)
    assert len(best[0].dE2000) == 8
    assert [m.distance for m in best] == sorted(m.distance for m in best)
    assert len({m.construction for m in find(library, recipe, 9, each_construction=True)}) == len(
        {row["construction"] for row in Catalogue(library).rows()}
    )
    # A measured file with three of its angles, and a table of its sparkle.
    text = "geometry,L,a,b\n"
    for name, Lab in zip(row["geometries"], row["Lab"], strict=True):
        if name in ("45as15", "45as45", "45as110"):
            text += ",".join([name, *map(repr, Lab)]) + "\n"
    (tmp_path / "panel.csv").write_text(text, "utf-8")
    lamp = row["sparkle"][0]["sparkle"]
    (tmp_path / "sparkle.csv").write_text(
        f"geometry,sparkle,graininess\n15s,{lamp!r},\ndiffuse,,{row['graininess']!r}\n", "utf-8"
    )
    panel = tmp_path / "panel.csv"
    best = find(library, panel, 1, sparkle_weight=5, sparkle_file=str(tmp_path / "sparkle.csv"))
    assert best[0].id == row["id"]
    assert best[0].distance == pytest.approx(0, abs=1e-9)
    assert list(best[0].dE2000) == ["45as15", "45as45", "45as110"]
    with pytest.raises(nacre.InputError, match="has no sparkle"):
        find(library, panel, 1, sparkle_weight=5)
    (tmp_path / "far.csv").write_text("geometry,L,a,b\n75as15,1,1,1\n", "utf-8")
    with pytest.raises(nacre.InputError, match="none of the library's angles: 45as-15,"):
        find(library, tmp_path / "far.csv")


def test_find_prints_tables(library: Path, capsys: pytest.CaptureFixture[str]) -> None:
    for form in ("csv", "json", "text"):
        arguments = ["find", str(library), "candy-red", "--count", "2", "--format", form]
        assert cli.main(arguments) == cli.OK
        out = capsys.readouterr().out
        if form == "csv":
            rows = list(csv.DictReader(out.splitlines()))
        elif form == "json":
            rows = json.loads(out)
        else:
            assert re.match(r"Candy red +tinted clear / Al2O3\|Al +0\.00", out.splitlines()[1])
            continue
        assert [row["name"] for row in rows][:1] == ["Candy red"]
        assert float(rows[0]["mean_dE2000"]) == 0 < float(rows[1]["mean_dE2000"])
    assert cli.main(["find", str(library), "no such file"]) == cli.USAGE
    assert "no such file" in capsys.readouterr().err


# Exports


def test_exports(library: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    def export(name: str, *options: str) -> int:
        return cli.main(["export", str(library), str(tmp_path / name), *options])

    assert export("all.csv") == cli.OK
    table = list(csv.DictReader((tmp_path / "all.csv").read_text("utf-8").splitlines()))
    rows = Catalogue(library).rows()
    assert [row["id"] for row in table] == [row["id"] for row in rows]
    assert [float(row["a_45as45"]) for row in table] == [row["a45"] for row in rows]
    assert export("pearls.parquet", "--sweep", "pearls") == cli.OK
    import pyarrow.parquet as pq

    part = pq.read_table(tmp_path / "pearls.parquet")
    assert part.equals(Catalogue(library).table().slice(2, 6))

    assert export("two", "--id", rows[0]["id"][:6], "--id", rows[5]["id"]) == cli.OK
    assert [row["id"] for row in Catalogue(tmp_path / "two").rows()] == [
        rows[0]["id"],
        rows[5]["id"],
    ]
    check = ["sha256sum", "--check", "--quiet", "checksums.sha256"]
    assert subprocess.run(check, cwd=tmp_path / "two", check=False).returncode == 0
    assert export("two.zip", "--id", rows[0]["id"]) == cli.OK
    with zipfile.ZipFile(tmp_path / "two.zip") as zipped:
        assert f"two/records/{rows[0]['id'][:2]}/{rows[0]['id']}/recipe.toml" in zipped.namelist()
    capsys.readouterr()
    assert export("two") == cli.FAILED
    assert "is there already" in capsys.readouterr().err
    assert export("x.csv", "--sweep", "opals") == cli.USAGE
    assert "has no sweep opals; it has as they are, pearls," in capsys.readouterr().err
    assert not (tmp_path / "x.csv").exists()
