"""``nacre-library render``: shards and frames through Dask and Slurm."""

from __future__ import annotations

import os
import signal
import stat
from pathlib import Path

import pytest
from conftest import Run
from nacre.library import cli, engine
from nacre.library.render import Piece, Render, run

import nacre

PICTURE = ("--spp", "6", "--size", "24x16")


def same_files(one: Path, other: Path) -> None:
    for suffix in (".exr", ".png"):
        assert one.with_suffix(suffix).read_bytes() == other.with_suffix(suffix).read_bytes()


CHANGED = ("--set", "layer[0].thickness_um=12", "--set", "clearcoat.thickness_um=30")


@pytest.fixture
def whole(nacre_program: Run, tmp_path: Path) -> Path:
    """The picture of one process."""
    file = tmp_path / "whole.exr"
    nacre_program("render", "macro", "--paint", "ruby", *PICTURE, "--sparkle", "-o", file)
    return file


def test_shards_on_two_workers(
    nacre_program: Run, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    whole = tmp_path / "whole.exr"
    picture = ("render", "macro", "--paint", "ruby", *CHANGED, *PICTURE, "--sparkle")
    nacre_program(*picture, "-o", whole)
    file = tmp_path / "shards.exr"
    options = ("--shards", "3", "--workers", "2", "-o", str(file))
    assert cli.main([*picture, *options]) == 0
    assert capsys.readouterr().out == f"{file}\n"
    same_files(file, whole)
    assert not (tmp_path / "shards.shards").exists()


def test_a_worker_that_is_killed_loses_nothing(whole: Path, tmp_path: Path) -> None:
    from distributed import get_worker

    render = Render(
        "macro", tmp_path / "x.exr", "ruby", spp=6, size=(24, 16), sparkle=True, shards=6
    )
    with engine.local_cluster(2) as client:
        before = client.run(os.getpid)

        def kill_first() -> None:
            if get_worker().address == next(iter(before)):
                os.kill(os.getpid(), signal.SIGKILL)

        future = client.submit(
            kill_first, workers=[next(iter(before))], allow_other_workers=False, pure=False
        )
        assert run(render, client) == [tmp_path / "x.exr"]
        client.cancel([future])
        assert set(client.run(os.getpid).values()) != set(before.values())
    same_files(tmp_path / "x.exr", whole)


def test_frames_by_slurm(
    nacre_program: Run, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """By a sbatch that runs the scripts at once; slurm/render.sh has the real one."""
    (tmp_path / "bin").mkdir()
    sbatch = tmp_path / "bin" / "sbatch"
    sbatch.write_text(
        f"""#!/bin/bash
echo "$@" >> {tmp_path}/calls
script=${{@: -1}}
array=$(sed -n 's/#SBATCH --array=0-//p' "$script")
for ((i = 0; i <= ${{array:-0}}; i++)); do SLURM_ARRAY_TASK_ID=$i bash "$script" >&2 || exit 1; done
echo $(wc -l < {tmp_path}/calls)
"""
    )
    sbatch.chmod(sbatch.stat().st_mode | stat.S_IXUSR)
    monkeypatch.setenv("PATH", f"{tmp_path}/bin:{os.environ['PATH']}")
    turning = ("--frames", "3:4", "--turntable", "camera", "--step", "5", "--seed", "2")
    scene = ("render", "curved-panel", "--paint", "red-gold", *PICTURE)
    given = ("--shards", "2", "--slurm", "--slurm-option=--partition=day")
    assert cli.main([*scene, *turning, *given, "-o", str(tmp_path / "turn.exr")]) == 0
    calls = (tmp_path / "calls").read_text().splitlines()
    assert len(calls) == 2
    assert "--dependency=afterok:1" in calls[1]
    assert "#SBATCH --partition=day" in (tmp_path / "turn.shards" / "merge.sh").read_text()
    nacre_program(*scene, *turning, "-o", tmp_path / "one.exr")
    for frame in ("0003", "0004"):
        same_files(tmp_path / f"turn.{frame}.exr", tmp_path / f"one.{frame}.exr")
    assert not list((tmp_path / "turn.shards").glob("*.h5"))


def test_what_is_there_is_kept(tmp_path: Path) -> None:
    render = Render("macro", tmp_path / "x.exr", "ruby", spp=6, size=(8, 8), shards=2)
    piece = Piece(None, 1)
    file = render.render(piece)
    first = file.read_bytes()  # which holds the seconds that it took
    render.render(piece)
    assert file.read_bytes() == first
    file.write_bytes(first[:1000])
    render.render(piece)
    whole = nacre.render("macro", nacre.Paint("ruby"), spp=6, size=(8, 8), shard=(1, 2))
    found = nacre.render(
        "macro", nacre.Paint("ruby"), spp=6, size=(8, 8), shard=(1, 2), resume=file
    )
    assert (found.rgb == whole.rgb).all()
    # Another paint under the same name of the file.
    Render("macro", tmp_path / "x.exr", "red-gold", spp=6, size=(8, 8), shards=2).render(piece)
    with pytest.raises(nacre.InputError, match=r"nacre:recipe_sha256:paint = .*, but .* has "):
        nacre.merge([render.render(Piece(None, 2)), file])


@pytest.mark.parametrize(
    ("options", "message"),
    [
        (("--shards", "7"), "shards = 7: must be in [1, 6]"),
        (("--frames", "0:3"), "frames and turntable go together"),
        (("--turntable", "light"), "frames and turntable go together"),
        (("--step", "3"), "step: belongs to frames"),
        (("--frames", "3:0", "--turntable", "light"), "frames = 3:0: must be FIRST:LAST"),
        (("--frames", "3", "--turntable", "light"), "frames = 3: must be FIRST:LAST"),
        (("--size", "3"), "size = 3: must be WIDTHxHEIGHT"),
        (("-o", "x.png"), "x.png: must end in .exr"),
        (("--model-option", "specimen=1"), "belongs to --model"),
        (("--model", "nacre", "--model-option", "specimen"), "must be KEY=VALUE"),
        (("--set", "alpha"), "set = alpha: must be KEY=VALUE"),
        (("--set", "alpha=x"), "set = alpha=x: must be a number"),
        (("--set", "alpha=0.1", "--paint", ""), "set: belongs to --paint"),
        (("--set", "alphabet=1", "--task", "0"), "alphabet"),
        (("--noise", "0.01"), "--noise: pieces are shards of a number of samples"),
        (("--video", "x.mp4"), "--video: make it of the frames"),
        (("--gamut", "rec2020"), "--gamut: nacre merge has it"),
        (("--workers", "0"), "workers = 0: must be at least 1"),
        (("--task", "6"), "task = 6: must be in [0, 0]"),
        (("--paint", "no-such.toml", "--workers", "1"), "no-such.toml"),
    ],
)
def test_refusals(
    options: tuple[str, ...],
    message: str,
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
) -> None:
    monkeypatch.chdir(tmp_path)
    assert cli.main(["render", "macro", "--paint", "ruby", *PICTURE, "-o", "x.exr", *options]) == 2
    assert message in capsys.readouterr().err
    assert not list(tmp_path.rglob("*.exr"))
