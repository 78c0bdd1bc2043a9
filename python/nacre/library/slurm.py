"""Runs as jobs of Slurm: the scripts, and their submission with sbatch.

A run is two jobs. One computes nothing: it holds Dask's scheduler, hands out the records and writes
the catalogue. The other is an array of workers, each a task with one processor; they find the
scheduler by the file that it writes into the library, and may start late, end early, be
preempted and come back.
"""

from __future__ import annotations

import hashlib
import shlex
import shutil
import subprocess
import sys
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

import nacre

from .record import write_whole


@dataclass(frozen=True)
class Job:
    """A job to be submitted."""

    name: str
    lines: Sequence[str]
    """of the shell, after the head of the script"""
    log: Path
    """%j, and in arrays %A and %a, stand for the numbers of job and task"""
    options: Sequence[str] = ()
    """of sbatch, as "--partition=day"; they come last, so that they win"""
    array: str = ""
    """tasks, as "0-99" or "0-99%10"; empty: one task"""

    def script(self) -> str:
        """The job's script."""
        head = [
            f"--job-name={self.name}",
            f"--output={self.log}",
            "--open-mode=append",
            "--ntasks=1",
            "--cpus-per-task=1",
            "--requeue",
            *([f"--array={self.array}"] if self.array else []),
            *self.options,
        ]
        lines = ["#!/bin/bash", *(f"#SBATCH {option}" for option in head), "set -eu", *self.lines]
        return "\n".join(lines) + "\n"


def submit(script: Path, *options: str) -> str:
    """Hands a script to sbatch, with options that only its submission knows, and returns the number
    of the job.

    Raises
    ------
    nacre.Error
        If there is no sbatch, or it refuses the job.
    """
    if shutil.which("sbatch") is None:
        raise nacre.Error(f"there is no sbatch here to submit {script} with")
    done = subprocess.run(
        ["sbatch", "--parsable", *options, str(script)], capture_output=True, text=True, check=False
    )
    if done.returncode != 0:
        raise nacre.Error(f"sbatch {script}: {done.stderr.strip()}")
    return done.stdout.strip().split(";")[0]


def command_line(*arguments: object) -> str:
    """A line of the shell."""
    return shlex.join(str(argument) for argument in arguments)


def write_run(
    plan: Path, library: Path, workers: int, options: Sequence[str], run_options: Sequence[str]
) -> list[Path]:
    """Writes the scripts of a run into LIBRARY/slurm: the one that hands out, and the workers.

    Parameters
    ----------
    workers
        Tasks of the array.
    options
        Of sbatch, for both jobs.
    run_options
        Of ``nacre-library run``.
    """
    library = library.absolute()
    folder = library / "slurm"
    folder.mkdir(parents=True, exist_ok=True)
    name = "nacre-" + hashlib.sha256(str(library).encode()).hexdigest()[:8]
    file = folder / "scheduler.json"
    run = Job(
        f"{name}-run",
        [
            "# What is left of an earlier run would lead workers astray.",
            command_line("rm", "-f", file),
            f"trap {shlex.quote(command_line('scancel', '--quiet', f'--jobname={name}'))} EXIT",
            command_line(
                *(sys.executable, "-m", "nacre.library", "run", plan.absolute(), library),
                *("--listen", file, *run_options),
            ),
        ],
        folder / "run-%j.log",
        options,
    )
    work = Job(
        name,
        [
            "# The scheduler may start later than its workers.",
            f"until test -s {shlex.quote(str(file))}; do sleep 2; done",
            "exec "
            + command_line(
                *(sys.executable, "-m", "distributed.cli.dask_worker", "--scheduler-file", file),
                *("--nthreads", 1, "--nworkers", 1, "--no-dashboard", "--memory-limit", 0),
                *("--death-timeout", 120),
            )
            + ' --local-directory "${TMPDIR:-/tmp}"',
        ],
        folder / "worker-%A.log",
        options,
        f"0-{workers - 1}",
    )
    scripts = [folder / "run.sh", folder / "workers.sh"]
    for script, job in zip(scripts, (run, work), strict=True):
        write_whole(script, job.script())
    return scripts
