"""The data of a library's page, and how the page is written. web/library tests it in a browser."""

from __future__ import annotations

import json
import re
import shutil
import tomllib
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import synthetic_library
from nacre.library import Catalogue, cli, page
from nacre.library.record import read_record, record_folder

import nacre

RECORDS = 50


@pytest.fixture(scope="module")
def original(tmp_path_factory: pytest.TempPathFactory) -> Path:
    library = tmp_path_factory.mktemp("library") / "of paints"
    synthetic_library.make(library, RECORDS)
    return library


@pytest.fixture
def library(original: Path, tmp_path: Path) -> Path:
    copy = tmp_path / "of paints"
    shutil.copytree(original, copy)
    return copy


def part(library: Path, name: str) -> Any:
    text = (library / "page" / "data" / f"{name}.js").read_text(encoding="utf-8")
    call = re.fullmatch(r'nacreLibrary\("([a-z0-9-]+)",(.*)\);\n', text, re.S)
    assert call is not None
    assert call[1] == name
    return json.loads(call[2])


def contents(folder: Path) -> dict[str, bytes]:
    return {
        file.relative_to(folder).as_posix(): file.read_bytes()
        for file in folder.rglob("*")
        if file.is_file()
    }


def test_the_data_are_those_of_the_records(library: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    # Small files, so that there are several of either kind and the last ones are not full.
    monkeypatch.setattr(page, "_RECORDS_PER_FILE", 4)
    monkeypatch.setattr(page, "_RECORDS_PER_GALLERY_FILE", 16)
    written = page.write_page(library)
    assert written.records == RECORDS
    whole = part(library, "library")
    assert whole["records"] == RECORDS
    assert whole["title"] == "Synthetic paints"
    assert whole["geometries"] == synthetic_library.GEOMETRIES
    assert whole["wavelengths_nm"] == synthetic_library.WAVELENGTHS_NM.tolist()
    assert (whole["illuminant"], whole["observer"]) == ("D65", "10")
    assert whole["sparkle_lamp_deg"] == 15
    assert whole["gallery_files"] == 4

    gallery = [part(library, f"gallery-{n:04}") for n in range(4)]
    ids = [identity for some in gallery for identity in some["id"]]
    assert ids == [row["id"] for row in Catalogue(library).rows(["id"])]
    for index, identity in enumerate(ids):
        record = read_record(library, identity)
        readings = record["readings"]
        row = {name: column[index % 16] for name, column in gallery[index // 16].items()}
        assert row["name"] == record["name"]
        assert whole["sweeps"][row["sweep"]] == record["sweep"]
        assert whole["constructions"][row["construction"]] == record["construction"]
        assert [whole["pigments"][i] for i in row["pigments"]] == record["pigments"]
        np.testing.assert_allclose(
            np.reshape(row["Lab"], (-1, 3)), readings["Lab"], rtol=0, atol=5.001e-5
        )
        for name in ("flop_index", "colour_travel", "graininess"):
            assert row[name] == pytest.approx(record[name], abs=5.001e-5)
        (at_15,) = (lamp["sparkle"] for lamp in record["sparkle"] if lamp["lamp_deg"] == 15)
        assert row["sparkle"] == pytest.approx(at_15, abs=5.001e-5)
        assert row["thumbnails"] == [name for name in record["files"] if name.endswith(".png")]

        details = part(library, f"records-{index // 4:04}")[index % 4]
        assert details["id"] == identity
        assert details["Lab"] == readings["Lab"]
        np.testing.assert_allclose(details["R"], readings["R"], rtol=3e-7, atol=5.001e-7)
        for name in ("flop_index", "colour_travel", "graininess", "swept", "warnings"):
            assert details[name] == record[name]
        folder = record_folder(library, identity)
        text = (folder / "recipe.toml").read_text()
        assert details["recipe_text"] == text
        assert details["recipe"] == tomllib.loads(text)
        files = {file["name"]: file["bytes"] for file in details["files"]}
        assert files == {file.name: file.stat().st_size for file in folder.iterdir()}


def test_the_page_is_what_the_package_ships(
    library: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    assert cli.main(["page", str(library)]) == 0
    assert f"index.html: {RECORDS} paints" in capsys.readouterr().out
    shipped = Path(page.__file__).with_name("page")
    assert (library / "index.html").read_bytes() == (shipped / "index.html").read_bytes()
    for name in ("app.js", "app.css"):
        assert (library / "page" / name).read_bytes() == (shipped / name).read_bytes()
    size = sum(file.stat().st_size for file in shipped.iterdir())
    assert size < 200_000


def test_written_again_it_is_the_same(library: Path) -> None:
    page.write_page(library)
    before = contents(library)
    (library / "page" / "data" / "gallery-0099.js").write_text("of a larger library")
    page.write_page(library)
    assert contents(library) == before
    assert not [file.name for file in library.iterdir() if file.name.startswith(".")]


def test_a_page_that_cannot_be_written_leaves_the_old_one(library: Path) -> None:
    page.write_page(library)
    before = contents(library / "page")
    identity = Catalogue(library).rows(["id"])[-1]["id"]
    (record_folder(library, identity) / "recipe.toml").unlink()
    with pytest.raises(nacre.InputError, match=f"{identity} is in the catalogue, but"):
        page.write_page(library)
    assert contents(library / "page") == before
    assert not (library / ".page").exists()


def test_a_library_without_a_plan_is_called_like_its_folder(library: Path) -> None:
    (library / "library.toml").unlink()
    page.write_page(library)
    assert part(library, "library")["title"] == "of paints"


def test_what_is_no_library_is_refused(tmp_path: Path) -> None:
    with pytest.raises(nacre.InputError, match="is no library"):
        page.write_page(tmp_path)
    synthetic_library.make(tmp_path / "empty", 0)
    with pytest.raises(nacre.InputError, match="has no records to show"):
        page.write_page(tmp_path / "empty")
