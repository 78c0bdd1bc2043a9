"""Long renders on many machines: shards of a picture's samples, and the frames of an animation.

A render is cut into pieces, each a shard of a frame, which is a file of its own beside the picture.
Pieces are made by Dask's workers or by the tasks of a Slurm array, in any order; the pieces of a
frame are merged into the picture of one process, bit for bit. A piece that is there already, of a
run that was killed, is kept if it is a piece of this very picture.
"""

from __future__ import annotations

import argparse
import hashlib
import os
import sys
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import nacre

from . import engine, slurm
from .record import write_whole

ELSEWHERE = {
    "--noise": "pieces are shards of a number of samples: say it with --spp, as nacre render "
    "--noise finds it on a small picture",
    "--video": "make it of the frames: ffmpeg -framerate 24 -i x.%04d.png x.mp4",
    "--gamut": "nacre merge has it: render the pieces with --task, then nacre merge x.shards/*.h5 "
    "--gamut display-p3 -o x.exr",
}
"""Options of ``nacre render`` that pieces cannot have, and what to do."""

ABOUT = "Renders a picture in shards, or the frames of an animation, on many processors."
LAST_FRAME = 999_999


@dataclass(frozen=True)
class Piece:
    """What one task renders."""

    frame: int | None
    number: int
    """of the shard, from 1"""


@dataclass(frozen=True)
class Render:
    """A picture, or an animation of them, and how it is cut.

    Raises
    ------
    nacre.SettingError
        If settings do not go together or are out of range.
    """

    scene: str
    output: Path
    """.exr; of frame 7 of an animation: x.0007.exr"""
    paint: str = ""
    """a file or the name of a shipped paint; empty: the scene names its paints"""
    values: tuple[tuple[str, float], ...] = ()
    """numbers of that paint that are changed, by key or the end of a key"""
    model: str = ""
    """empty: the usual one"""
    model_options: tuple[tuple[str, str], ...] = ()
    spp: int = 64
    """of all shards together"""
    size: tuple[int, int] = (512, 512)
    seed: int = 0
    """frame i of an animation has seed + i"""
    depth: int = 8
    sparkle: bool = False
    spectral_bins: int = 0
    exposure: float = 0.0
    shards: int = 1
    """of each picture"""
    frames: tuple[int, int] | None = None
    """the first and the last"""
    turntable: str = ""
    step_deg: float | None = None
    """from frame to frame; None: all together are one turn"""

    def __post_init__(self) -> None:
        if self.output.suffix != ".exr":
            raise nacre.SettingError(f"output = {self.output}: must end in .exr")
        if not 1 <= self.shards <= self.spp:
            raise nacre.SettingError(
                f"shards = {self.shards}: must be in [1, {self.spp}], the samples of a pixel"
            )
        if (self.frames is None) != (not self.turntable):
            raise nacre.SettingError("frames and turntable go together: a range, and what turns")
        if self.frames is None and self.step_deg is not None:
            raise nacre.SettingError("step: belongs to frames")
        if self.frames is not None:
            first, last = self.frames
            if not 0 <= first <= last <= LAST_FRAME:
                raise nacre.SettingError(
                    f"frames = {first}:{last}: must be FIRST:LAST with 0 <= FIRST <= LAST <= "
                    f"{LAST_FRAME}"
                )

    @property
    def folder(self) -> Path:
        """Of the pieces, until they are merged."""
        return self.output.with_suffix(".shards")

    def pictures(self) -> Sequence[int | None]:
        """The frames; one None: a picture."""
        return [None] if self.frames is None else range(self.frames[0], self.frames[1] + 1)

    def pieces(self) -> list[Piece]:
        """The shards of each frame, frame by frame; task k of a Slurm array renders pieces()[k]."""
        return [Piece(f, i + 1) for f in self.pictures() for i in range(self.shards)]

    def picture_file(self, frame: int | None) -> Path:
        """The .exr of a frame."""
        return self.output if frame is None else self.output.with_suffix(f".{frame:04}.exr")

    def shard_file(self, piece: Piece) -> Path:
        """The .h5 of a piece."""
        frame = "" if piece.frame is None else f"{piece.frame:04}."
        return self.folder / f"{frame}{piece.number}-of-{self.shards}.h5"

    def angle_deg(self, frame: int) -> float:
        """By which a frame is turned."""
        assert self.frames is not None
        step = self.step_deg
        if step is None:
            step = 360.0 / (self.frames[1] - self.frames[0] + 1)
        return step * frame

    def render(self, piece: Piece, threads: int = 1) -> Path:
        """Renders a piece, unless it is there, and returns its file.

        Parameters
        ----------
        threads
            Of the whole process.
        """
        nacre.set_threads(threads)
        file = self.shard_file(piece)
        file.parent.mkdir(parents=True, exist_ok=True)
        model = nacre.Model(self.model, **dict(self.model_options)) if self.model else None
        turn = None if piece.frame is None else (self.turntable, self.angle_deg(piece.frame))
        picture = nacre.render(
            self.scene,
            nacre.Paint(self.paint).with_values(dict(self.values)) if self.paint else None,
            spp=self.spp,
            size=self.size,
            model=model,
            seed=self.seed + (piece.frame or 0),
            depth=self.depth,
            sparkle=self.sparkle,
            spectral_bins=self.spectral_bins,
            turntable=turn,
            shard=(piece.number, self.shards),
            resume=file,
        )
        picture.write(file)
        return file

    def merge(self, frame: int | None) -> Path:
        """Writes the .exr of a frame, and the .png beside it, from all its pieces."""
        shards = [self.shard_file(p) for p in self.pieces() if p.frame == frame]
        file = self.picture_file(frame)
        nacre.merge(shards).write_exr_and_png(file, exposure_stops=self.exposure)
        return file

    def tidy(self) -> None:
        """Deletes the pieces, once all pictures are there, and their folder if nothing is left."""
        for piece in self.pieces():
            self.shard_file(piece).unlink(missing_ok=True)
        if self.folder.is_dir() and not any(self.folder.iterdir()):
            self.folder.rmdir()

    def arguments(self) -> list[str]:
        """Of ``nacre-library render`` for this render."""
        options: dict[str, Any] = {
            "--paint": self.paint,
            "--model": self.model,
            "--spp": self.spp,
            "--size": "{}x{}".format(*self.size),
            "--seed": self.seed,
            "--depth": self.depth,
            "--spectral-bins": self.spectral_bins,
            "--exposure": self.exposure,
            "--shards": self.shards,
            "--turntable": self.turntable,
            "--step": self.step_deg,
            "--output": self.output,
        }
        if self.frames is not None:
            options["--frames"] = "{}:{}".format(*self.frames)
        given = [f"{key}={value}" for key, value in options.items() if value not in ("", None)]
        given += [f"--set={key}={value!r}" for key, value in self.values]
        given += [f"--model-option={key}={value}" for key, value in self.model_options]
        return ["render", self.scene, *given, *(["--sparkle"] if self.sparkle else [])]


def _render_piece(render: Render, piece: Piece) -> Path | nacre.Error:
    """A task of Dask, which would write what a task raises into the log of its worker."""
    try:
        return render.render(piece)
    except nacre.Error as error:
        return error


def _merge_frame(
    render: Render, frame: int | None, *shards: Path | nacre.Error
) -> Path | nacre.Error:
    """The task after those that write the shards."""
    for shard in shards:
        if isinstance(shard, nacre.Error):
            return shard
    try:
        return render.merge(frame)
    except nacre.Error as error:
        return error


def run(render: Render, client: Any, progress: bool = False) -> list[Path]:
    """Renders on the workers of a Dask cluster and returns the pictures.

    Workers come and go; a piece whose worker dies is given to another one. All must have the
    output's folder under its path.

    Parameters
    ----------
    client
        Of ``distributed``, as :func:`engine.local_cluster` gives it.
    progress
        Draws a bar if stderr is a terminal.

    Raises
    ------
    nacre.Error
        What a piece raised; the others are cancelled then, and what is done stays for the next run.
    """
    from distributed import as_completed

    pictures, shards = [], []
    for frame in render.pictures():
        pieces = [
            client.submit(_render_piece, render, piece, pure=False)
            for piece in render.pieces()
            if piece.frame == frame
        ]
        shards += pieces
        pictures.append(client.submit(_merge_frame, render, frame, *pieces, pure=False))
    try:
        with engine.progress_bar(len(shards) + len(pictures), progress, "piece") as bar:
            for future in as_completed([*shards, *pictures]):
                result = future.result()
                if isinstance(result, nacre.Error):
                    raise result
                bar.update()
    except BaseException:
        client.cancel([*shards, *pictures])
        raise
    return [future.result() for future in pictures]


def write_jobs(render: Render, options: Sequence[str]) -> list[Path]:
    """Writes the scripts of a render by Slurm: an array with a task for each piece, and the job
    that merges them.

    Parameters
    ----------
    options
        Of sbatch, for both jobs.
    """
    folder = render.folder
    folder.mkdir(parents=True, exist_ok=True)
    name = "nacre-" + hashlib.sha256(str(render.output).encode()).hexdigest()[:8]
    program = (sys.executable, "-m", "nacre.library", *render.arguments())
    work = slurm.Job(
        name,
        ["exec " + slurm.command_line(*program) + ' --task "$SLURM_ARRAY_TASK_ID"'],
        folder / "render-%A-%a.log",
        options,
        f"0-{len(render.pieces()) - 1}",
    )
    merge = slurm.Job(
        f"{name}-merge",
        ["exec " + slurm.command_line(*program, "--merge")],
        folder / "merge-%j.log",
        options,
    )
    scripts = [folder / "render.sh", folder / "merge.sh"]
    for script, job in zip(scripts, (work, merge), strict=True):
        write_whole(script, job.script())
    return scripts


def _submit(arguments: argparse.Namespace, render: Render) -> None:
    work, merge = write_jobs(render, arguments.slurm_option)
    if arguments.dry_run:
        print(f"{work}\n{merge}")
        return
    job = slurm.submit(work)
    print(f"job {job}: {work}")
    after = (f"--dependency=afterok:{job}", "--kill-on-invalid-dep=yes")
    print(f"job {slurm.submit(merge, *after)}: {merge}")


def _merge_all(render: Render) -> Iterator[Path]:
    for frame in render.pictures():
        yield render.merge(frame)
    render.tidy()


def main(arguments: argparse.Namespace) -> int:
    """Runs ``nacre-library render`` and returns its exit status."""
    render = _render_of(arguments)
    if arguments.slurm:
        _submit(arguments, render)
        return 0
    if arguments.task is not None:
        pieces = render.pieces()
        if not 0 <= arguments.task < len(pieces):
            raise nacre.SettingError(
                f"task = {arguments.task}: must be in [0, {len(pieces) - 1}], the pieces"
            )
        render.render(pieces[arguments.task], int(os.environ.get("SLURM_CPUS_PER_TASK", "1")))
        return 0
    if arguments.workers is not None and arguments.workers < 1:
        raise nacre.SettingError(f"workers = {arguments.workers}: must be at least 1")
    if arguments.merge:
        written = list(_merge_all(render))
    else:
        workers = arguments.workers or len(os.sched_getaffinity(0))
        cluster = (
            engine.remote_cluster(arguments.scheduler)
            if arguments.scheduler
            else engine.local_cluster(min(workers, len(render.pieces())))
        )
        with cluster as client:
            written = run(render, client, not arguments.quiet)
        render.tidy()
    if not arguments.quiet:
        for file in written:
            print(file)
    return 0


def _absolute(name: str) -> str:
    """A file's path, or the name of what ships."""
    return str(Path(name).absolute()) if name and Path(name).exists() else name


def _whole_numbers(option: str, text: str, separator: str) -> tuple[int, int]:
    try:
        first, second = map(int, text.split(separator))
    except ValueError:
        example = {":": "FIRST:LAST, as 0:35", "x": "WIDTHxHEIGHT, as 640x480"}[separator]
        raise nacre.SettingError(f"{option} = {text}: must be {example}") from None
    return first, second


def _pairs(option: str, texts: Sequence[str]) -> list[tuple[str, str]]:
    """Of an option that is given any number of times as KEY=VALUE."""
    pairs = []
    for text in texts:
        key, equals, value = text.partition("=")
        if not equals:
            raise nacre.SettingError(f"{option} = {text}: must be KEY=VALUE")
        pairs.append((key, value))
    return pairs


def _number(key: str, text: str) -> float:
    try:
        return float(text)
    except ValueError:
        raise nacre.SettingError(f"set = {key}={text}: must be a number") from None


class _Elsewhere(argparse.Action):
    """Refuses one of :data:`ELSEWHERE`."""

    def __call__(
        self,
        parser: argparse.ArgumentParser,
        namespace: argparse.Namespace,
        values: str | Sequence[Any] | None,
        option_string: str | None = None,
    ) -> None:
        raise nacre.SettingError(f"{option_string}: {ELSEWHERE[str(option_string)]}")


def _render_of(arguments: argparse.Namespace) -> Render:
    options = [(k.replace("-", "_"), v) for k, v in _pairs("model-option", arguments.model_option)]
    values = [(key, _number(key, text)) for key, text in _pairs("set", arguments.set)]
    if values and not arguments.paint:
        raise nacre.SettingError("set: belongs to --paint: it changes that recipe")
    if options and not arguments.model:
        raise nacre.SettingError("model-option: belongs to --model")
    return Render(
        scene=_absolute(arguments.scene),
        output=arguments.output.absolute(),
        paint=_absolute(arguments.paint),
        values=tuple(values),
        model=arguments.model,
        model_options=tuple(options),
        spp=arguments.spp,
        size=_whole_numbers("size", arguments.size, "x"),
        seed=arguments.seed,
        depth=arguments.depth,
        sparkle=arguments.sparkle,
        spectral_bins=arguments.spectral_bins,
        exposure=arguments.exposure,
        shards=arguments.shards,
        frames=_whole_numbers("frames", arguments.frames, ":") if arguments.frames else None,
        turntable=arguments.turntable,
        step_deg=arguments.step,
    )


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Of ``nacre-library render``."""
    parser.add_argument("scene", metavar="SCENE", help="a scene file, or a built-in scene")
    parser.add_argument("-o", "--output", type=Path, required=True, metavar="X.exr")
    parser.add_argument("--paint", default="", metavar="P", help="a file, or a shipped paint")
    parser.add_argument(
        "--set", action="append", default=[], metavar="KEY=VALUE", help="a number of that paint"
    )
    parser.add_argument("--shards", type=int, default=1, metavar="N", help="of each picture")
    parser.add_argument("--frames", default="", metavar="FIRST:LAST")
    parser.add_argument("--turntable", default="", choices=("", "shape", "camera", "light"))
    parser.add_argument("--step", type=float, metavar="DEG", help="from frame to frame")
    picture = parser.add_argument_group("the picture, as nacre render has it")
    picture.add_argument("--model", default="", metavar="NAME")
    picture.add_argument(
        "--model-option",
        action="append",
        default=[],
        metavar="KEY=VALUE",
        help="an option of the model, as specimen=2 or table=svd; any number",
    )
    picture.add_argument("--spp", type=int, default=64, metavar="N", help="of all shards together")
    picture.add_argument("--size", default="512x512", metavar="WxH")
    picture.add_argument("--seed", type=int, default=0, metavar="N")
    picture.add_argument("--depth", type=int, default=8, metavar="N")
    picture.add_argument("--sparkle", action="store_true")
    picture.add_argument("--spectral-bins", type=int, default=0, metavar="N")
    picture.add_argument("--exposure", type=float, default=0.0, metavar="STOPS", help="of the PNG")
    where = parser.add_argument_group("where").add_mutually_exclusive_group()
    where.add_argument("--workers", type=int, metavar="N", help="processes on this machine")
    where.add_argument(
        "--scheduler", default="", metavar="ADDRESS", help="of a Dask scheduler, or its file"
    )
    where.add_argument(
        "--slurm", action="store_true", help="write job scripts and submit them with sbatch"
    )
    where.add_argument("--task", type=int, metavar="K", help="render piece K only, from 0")
    where.add_argument("--merge", action="store_true", help="merge the pieces that are there")
    parser.add_argument(
        "--slurm-option",
        action="append",
        default=[],
        metavar="OPTION",
        help="of sbatch, as --slurm-option=--cpus-per-task=4; any number",
    )
    parser.add_argument(
        "--dry-run", action="store_true", help="with --slurm: write the scripts only"
    )
    parser.add_argument("--quiet", action="store_true", help="errors only")
    for option in ELSEWHERE:
        parser.add_argument(option, action=_Elsewhere, help=argparse.SUPPRESS)
