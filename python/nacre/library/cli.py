"""The command line: ``nacre-library plan|run|status|find|export|page|render``."""

from __future__ import annotations

import argparse
import csv
import importlib.util
import json
import math
import os
import signal
import sys
from collections.abc import Callable, Sequence
from dataclasses import asdict
from pathlib import Path
from types import FrameType

import nacre

from . import engine, slurm
from .catalogue import write_catalogue
from .estimate import measure_cost, shown_size, shown_time, spread
from .export import export
from .find import as_row, find
from .folder import planned_ids
from .record import failures, record_ids
from .sweep import Plan

OK, FAILED, USAGE, INCOMPLETE = 0, 1, 2, 4
"""Exit statuses: as those of ``nacre``; INCOMPLETE: done, and some records failed."""

Command = Callable[[argparse.Namespace], int]


def _plan(arguments: argparse.Namespace) -> int:
    plan = Plan(arguments.plan)
    state = engine.state_of(plan, arguments.library)
    missing = {record.id for record in state.missing()}
    rows = [["sweep", "records", "done", "failed", "to do", "s each", "bytes each"]]
    seconds = size = 0.0
    for sweep in plan.sweeps:
        records = [record for record in state.planned if record.sweep == sweep.name]
        ids = {record.id for record in records}
        row = [
            sweep.name,
            str(len(ids)),
            *(str(len(ids & x)) for x in (state.done, set(state.failed))),
        ]
        row += [str(len(ids & missing)), "", ""]
        if arguments.measure and records:
            cost = measure_cost(spread(records, arguments.measure), plan.settings)
            seconds += cost.seconds * len(ids & missing)
            size += cost.bytes * len(ids & missing)
            row[-2:] = [f"{cost.seconds:.3g}", f"{cost.bytes:.0f}"]
        rows.append(row)
    print(f"{plan.name}: {len(state.planned)} records")
    _print_table(rows)
    if arguments.measure:
        workers = arguments.workers
        print(
            f"to do: about {shown_time(seconds)} of one processor, {shown_time(seconds / workers)} "
            f"on {workers}, and {shown_size(size)}; measured here and now on up to "
            f"{arguments.measure} of each sweep's records"
        )
    return OK


def _print_table(rows: Sequence[Sequence[str]], left: int = 1) -> None:
    """So many columns to the left, the others to the right."""
    widths = [max(map(len, column)) for column in zip(*rows, strict=True)]
    for row in rows:
        cells = zip(row, widths, strict=True)
        text = [c.ljust(w) if n < left else c.rjust(w) for n, (c, w) in enumerate(cells)]
        print("  ".join(text))


def _submit(arguments: argparse.Namespace) -> int:
    """Writes the scripts of a run and hands them to Slurm."""
    plan = Plan(arguments.plan)  # what is wrong with it is said here and not in a log
    options = [name for name in ("--retry", "--prune") if getattr(arguments, name[2:])]
    if arguments.interface:
        options += ["--interface", arguments.interface]
    scripts = slurm.write_run(
        plan.file,
        arguments.library,
        arguments.workers or 1,
        arguments.slurm_option,
        options,
    )
    for script in scripts:
        print(script if arguments.dry_run else f"job {slurm.submit(script)}: {script}")
    return OK


def _run(arguments: argparse.Namespace) -> int:
    if arguments.slurm:
        return _submit(arguments)
    summary = engine.run(
        Plan(arguments.plan),
        arguments.library,
        workers=arguments.workers,
        scheduler=arguments.scheduler,
        listen=arguments.listen,
        interface=arguments.interface,
        retry=arguments.retry,
        prune=arguments.prune,
        progress=not arguments.quiet,
    )
    if not arguments.quiet:
        print(
            f"{summary.planned} records: {summary.found} were there, {summary.computed} computed "
            f"in {summary.seconds:.0f} s, {summary.failed} failed",
            file=sys.stderr,
        )
        if summary.failed:
            print(f"why: {arguments.library}/failed/*.json", file=sys.stderr)
    return INCOMPLETE if summary.failed else OK


def _status(arguments: argparse.Namespace) -> int:
    planned = planned_ids(arguments.library)
    there = record_ids(arguments.library)
    done = [identity for identity in planned if identity in there]
    failed = {i: why for i, why in failures(arguments.library).items() if i not in there}
    failed = {i: failed[i] for i in planned if i in failed}
    print(f"planned {len(planned)}")
    print(f"done    {len(done)}")
    print(f"failed  {len(failed)}")
    print(f"missing {len(planned) - len(done) - len(failed)}")
    print(f"others  {len(there) - len(done)}")
    for identity, why in failed.items():
        print(f"{identity} {why['name']}: {why['error']}")
    return OK if len(done) == len(planned) else INCOMPLETE


def _catalogue(arguments: argparse.Namespace) -> int:
    there = record_ids(arguments.library)
    ids = [identity for identity in planned_ids(arguments.library) if identity in there]
    print(f"{write_catalogue(arguments.library, ids)} records")
    return OK


def _find(arguments: argparse.Namespace) -> int:
    if not 0 <= arguments.sparkle < math.inf:
        raise nacre.SettingError(f"--sparkle {arguments.sparkle}: must be a number >= 0")
    matches = find(
        arguments.library,
        arguments.standard,
        arguments.count,
        sparkle_weight=arguments.sparkle,
        sparkle_file=arguments.standard_sparkle,
        each_construction=arguments.each_construction,
    )
    form = arguments.format or ("text" if sys.stdout.isatty() else "csv")
    if form == "json":
        print(json.dumps([asdict(match) for match in matches], indent=1, default=str))
    elif form == "csv":
        rows = [as_row(match) for match in matches]
        writer = csv.DictWriter(sys.stdout, list(rows[0]), restval="", lineterminator="\n")
        writer.writeheader()
        writer.writerows(rows)
    else:
        table = [["paint", "construction", "dE2000", "largest", "id"]]
        for match in matches:
            numbers = (f"{match.mean_dE2000:.2f}", f"{match.max_dE2000:.2f}")
            table.append([match.name, match.construction, *numbers, match.id[:12]])
        _print_table(table, left=2)
    return OK


def _export(arguments: argparse.Namespace) -> int:
    count = export(arguments.library, arguments.to, arguments.sweep, arguments.id)
    print(f"{arguments.to}: {count} records", file=sys.stderr)
    return OK


def _whole(text: str) -> int:
    value = int(text)
    if value < 1:
        raise ValueError
    return value


def _workers(text: str) -> int:
    return 0 if text == "0" else _whole(text)


def parser() -> argparse.ArgumentParser:
    """Of all subcommands."""
    top = argparse.ArgumentParser(
        prog="nacre-library", description="A library of paints: planned, computed, searched."
    )
    commands = top.add_subparsers(dest="command", required=True, metavar="COMMAND")

    def add(name: str, function: Command, about: str) -> argparse.ArgumentParser:
        sub = commands.add_parser(name, help=about, description=about)
        sub.set_defaults(function=function)
        return sub

    sub = add("plan", _plan, "Checks a plan and says how much there is to do.")
    sub.add_argument("plan", type=Path, metavar="PLAN.toml")
    sub.add_argument("library", type=Path, nargs="?", metavar="LIBRARY")
    sub.add_argument(
        "--measure",
        type=int,
        default=1,
        choices=range(101),
        metavar="N",
        help="how many records of each sweep tell what one costs; 0: none (default 1)",
    )
    sub.add_argument("--workers", type=_whole, default=len(os.sched_getaffinity(0)), metavar="N")

    sub = add("run", _run, "Computes what a library lacks of a plan.")
    sub.add_argument("plan", type=Path, metavar="PLAN.toml")
    sub.add_argument("library", type=Path, metavar="LIBRARY")
    sub.add_argument(
        "--workers",
        type=_workers,
        metavar="N",
        help="processes on this machine, or tasks of Slurm (default: one for each processor); "
        "0: this process alone",
    )
    where = sub.add_mutually_exclusive_group()
    where.add_argument(
        "--scheduler", default="", metavar="ADDRESS", help="of a Dask scheduler, or its file"
    )
    where.add_argument(
        "--listen",
        type=Path,
        metavar="FILE",
        help="wait for workers from elsewhere: writes the file for dask worker --scheduler-file",
    )
    where.add_argument(
        "--slurm", action="store_true", help="write job scripts and submit them with sbatch"
    )
    sub.add_argument("--interface", default="", metavar="NAME", help="of the network, for --listen")
    sub.add_argument(
        "--slurm-option",
        action="append",
        default=[],
        metavar="OPTION",
        help="of sbatch, as --slurm-option=--partition=day; any number",
    )
    sub.add_argument("--dry-run", action="store_true", help="with --slurm: write the scripts only")
    sub.add_argument("--retry", action="store_true", help="try again what was refused before")
    sub.add_argument("--prune", action="store_true", help="delete records that are not planned")
    sub.add_argument("--quiet", action="store_true", help="errors only")

    sub = add("status", _status, "Says what a library has, lacks, and why.")
    sub.add_argument("library", type=Path, metavar="LIBRARY")

    sub = add("catalogue", _catalogue, "Writes the catalogue and the checksums anew.")
    sub.add_argument("library", type=Path, metavar="LIBRARY")

    sub = add("find", _find, "Finds the records that read most like a standard.")
    sub.add_argument("library", type=Path, metavar="LIBRARY")
    sub.add_argument("standard", metavar="STANDARD", help="measured colours, or a paint")
    sub.add_argument("--count", type=_whole, default=10, metavar="N")
    sub.add_argument(
        "--each-construction", action="store_true", help="the best of each construction alone"
    )
    sub.add_argument(
        "--sparkle",
        type=float,
        default=0.0,
        metavar="WEIGHT",
        help="what a ratio of two in sparkle adds to Delta E 2000",
    )
    sub.add_argument(
        "--standard-sparkle", default="", metavar="FILE.csv", help="what nacre sparkle wrote"
    )
    sub.add_argument("--format", choices=("text", "csv", "json"), help="default: text on terminals")

    sub = add("export", _export, "Writes a part of a library, or its catalogue as a table.")
    sub.add_argument("library", type=Path, metavar="LIBRARY")
    sub.add_argument("to", type=Path, metavar="OUT", help=".csv, .parquet, .zip or a new folder")
    sub.add_argument("--sweep", action="append", default=[], metavar="NAME")
    sub.add_argument("--id", action="append", default=[], metavar="ID", help="or how it begins")

    for name in ("page", "render"):
        module = f"nacre.library.{name}"
        if importlib.util.find_spec(module) is not None:
            extra = importlib.import_module(module)
            extra.add_arguments(add(name, extra.main, extra.ABOUT))
    return top


def _interrupt(number: int, frame: FrameType | None) -> None:
    raise KeyboardInterrupt


def main(arguments: Sequence[str] | None = None) -> int:
    """Runs ``nacre-library`` and returns its exit status."""
    signal.signal(signal.SIGTERM, _interrupt)  # a job that is cancelled leaves a catalogue too
    try:
        chosen = parser().parse_args(arguments)
        return int(chosen.function(chosen))
    except nacre.Error as error:
        print(f"nacre-library: {error}", file=sys.stderr)
        return USAGE if isinstance(error, nacre.InputError | nacre.DomainError) else FAILED
    except OSError as error:
        print(f"nacre-library: {error}", file=sys.stderr)
        return FAILED
    except KeyboardInterrupt:
        print("nacre-library: stopped; the same command goes on", file=sys.stderr)
        return 130
