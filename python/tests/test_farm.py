"""The Open Job Description of farm/, checked and run by its own command line."""

from __future__ import annotations

import shutil
import subprocess
import sys
from pathlib import Path

import pytest
from conftest import ROOT, Run

TEMPLATE = ROOT / "farm" / "nacre-render.openjd.yaml"


def openjd(*arguments: object) -> subprocess.CompletedProcess[str]:
    return subprocess.run(
        [sys.executable, "-m", "openjd", *map(str, arguments)],
        capture_output=True,
        text=True,
        check=False,
    )


def test_the_template_passes_its_checks() -> None:
    checked = openjd("check", TEMPLATE)
    assert checked.returncode == 0, checked.stdout + checked.stderr


def run(folder: Path, program: Path, **parameters: object) -> subprocess.CompletedProcess[str]:
    given = {
        "Scene": folder / "a scene.toml",
        "Paint": folder / "paint.toml",
        "Output": folder / "pictures",
        "Nacre": program,
        "Samples": 6,
        "Size": "24x16",
        "Threads": 1,
        **parameters,
    }
    options = [word for key, value in given.items() for word in ("-p", f"{key}={value}")]
    return openjd("run", TEMPLATE, *options)


@pytest.fixture
def folder(nacre_program: Run, paints: Path, tmp_path: Path) -> Path:
    """With a scene and a paint."""
    nacre_program("scene", "curved-panel", "-o", tmp_path / "a scene.toml")
    shutil.copy(paints / "red-gold.toml", tmp_path / "paint.toml")
    return tmp_path


def test_frames_in_shards_are_those_of_one_process(
    folder: Path, nacre_program: Run, program_path: Path
) -> None:
    done = run(folder, program_path, Shards=3, Frames="0-2:2", Turntable="camera", StepDegrees=-7.5)
    assert done.returncode == 0, done.stdout + done.stderr
    pictures = folder / "pictures"
    assert sorted(file.name for file in pictures.iterdir()) == [
        "picture.0000.exr",
        "picture.0000.png",
        "picture.0002.exr",
        "picture.0002.png",
    ]
    nacre_program(
        *("render", folder / "a scene.toml", "--paint", folder / "paint.toml", "--spp", "6"),
        *("--size", "24x16", "--frames", "0:2", "--turntable", "camera", "--step=-7.5"),
        *("-o", folder / "one.exr"),
    )
    for file in pictures.iterdir():
        one = folder / file.name.replace("picture", "one")
        assert file.read_bytes() == one.read_bytes(), file.name


def test_a_shard_that_fails_ends_the_job(folder: Path, program_path: Path) -> None:
    done = run(folder, program_path, Shards=7)
    assert done.returncode != 0
    assert "--shard (of) = 7: must be a number in [1, 6]" in done.stdout
    assert not list((folder / "pictures").glob("*.exr"))
