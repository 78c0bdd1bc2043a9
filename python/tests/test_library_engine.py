"""Libraries made by Dask's workers, who are killed meanwhile. Runs are processes of their own."""

from __future__ import annotations

import os
import signal
import subprocess
import sys
import time
from pathlib import Path

import pyarrow as pa
import pytest
from distributed import Client, Future
from nacre.library import Catalogue
from nacre.library.engine import compute_with
from nacre.library.record import Outcome, failures, record_folder, record_ids
from nacre.library.sweep import Plan

PLAN = """
[library]
name = "Kills"
[[sweep]]
name = "silver"
base = "metallic-silver"
[sweep.vary]
"orientation.alpha" = { from = 0.1, to = 0.2, steps = 46 }
[[sweep]]
name = "prescribed"
base = "metallic-gray"
[sweep.vary]
"flakes[0].reflectance" = { from = 0.3, to = 0.9, steps = 2 }
"flakes[0].transmittance" = { from = 0.05, to = 0.6, steps = 2 }
"""
# Many, as some are made between a look into the folder and the kill. And one that is refused.
RECORDS = 49
INCOMPLETE = 4


def start(plan: Path, library: Path, *options: str) -> subprocess.Popen[str]:
    command = [sys.executable, "-m", "nacre.library", "run", str(plan), str(library), *options]
    return subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)


def finish(process: subprocess.Popen[str]) -> str:
    """What a run printed to stderr."""
    _, errors = process.communicate()
    assert process.returncode == INCOMPLETE, errors
    return errors


def workers_of(process: subprocess.Popen[str]) -> list[int]:
    """The process numbers of its workers."""
    found = []
    for thread in Path(f"/proc/{process.pid}/task").iterdir():
        for pid in (thread / "children").read_text().split():
            if b"spawn_main" in Path(f"/proc/{pid}/cmdline").read_bytes():
                found.append(int(pid))
    return found


def await_records(library: Path, count: int, process: subprocess.Popen[str]) -> None:
    while len(record_ids(library)) < count:
        assert process.poll() is None, "it ended too early"
        time.sleep(0.01)


def stamp(library: Path, identity: str) -> tuple[int, int]:
    """Which file it is and when it was written."""
    stat = (record_folder(library, identity) / "record.json").stat()
    return stat.st_ino, stat.st_mtime_ns


def rows(library: Path) -> pa.Table:
    """The catalogue, but for what depends on the clock."""
    table = Catalogue(library).table()
    assert table.num_rows == RECORDS
    assert [why["sweep"] for why in failures(library).values()] == ["prescribed"]
    assert not (library / ".work").exists()
    return table.drop_columns(["seconds"])


@pytest.fixture(scope="module")
def plan(tmp_path_factory: pytest.TempPathFactory) -> Path:
    file = tmp_path_factory.mktemp("engine") / "plan.toml"
    file.write_text(PLAN, encoding="utf-8")
    return file


@pytest.fixture(scope="module")
def by_one(plan: Path) -> pa.Table:
    """The library of one worker, made as on a cluster: a run that holds the scheduler, and a worker
    that is told of its file."""
    library, file = plan.parent / "one", plan.parent / "scheduler.json"
    process = start(plan, library, "--listen", str(file), "--interface", "lo")
    while not file.exists():
        assert process.poll() is None
        time.sleep(0.02)
    command = [sys.executable, "-m", "distributed.cli.dask_worker", "--scheduler-file", str(file)]
    command += ["--nthreads", "1", "--no-dashboard", "--local-directory", str(plan.parent)]
    worker = subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
    errors = finish(process)
    worker.communicate()  # it ends with the run
    assert not file.exists()
    # Silent in a pipe but for the summary: no bar.
    assert len(errors.splitlines()) == 2, errors
    assert f"{RECORDS + 1} records: 0 were there, {RECORDS} computed in" in errors
    return rows(library)


def test_a_worker_that_is_killed_loses_nothing(plan: Path, by_one: pa.Table) -> None:
    library = plan.parent / "four"
    process = start(plan, library, "--workers", "4")
    await_records(library, 1, process)
    os.kill(workers_of(process)[0], signal.SIGKILL)
    assert len(record_ids(library)) < RECORDS, "nothing was left to do"
    finish(process)
    assert rows(library).equals(by_one)


def test_a_result_that_is_lost_is_waited_for(
    plan: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """As a future says where the worker that had its result has died, until another has it."""
    monkeypatch.setattr(Future, "status", property(lambda _: "lost"))
    read = Plan(plan)
    records = list(read.records())[:2]
    outcomes: list[Outcome] = []
    # Any free port for its dashboard: others may run at the same time.
    address = "127.0.0.1:0"
    with Client(
        processes=False, n_workers=1, threads_per_worker=1, dashboard_address=address
    ) as client:
        compute_with(client, records, read.settings, tmp_path, outcomes.append)
    assert [outcome.error for outcome in outcomes] == ["", ""]
    assert record_ids(tmp_path) == {record.id for record in records}
    assert not failures(tmp_path)


def test_a_run_that_is_killed_goes_on(plan: Path, by_one: pa.Table) -> None:
    library = plan.parent / "two"
    process = start(plan, library, "--workers", "2")
    await_records(library, 1, process)
    process.kill()  # and Dask's scheduler, which is part of it
    process.communicate()  # until its workers, who print to the same pipe, have ended by themselves
    there = {i: stamp(library, i) for i in record_ids(library)}
    assert 0 < len(there) < RECORDS
    assert not (library / "catalogue.parquet").exists()
    errors = finish(start(plan, library, "--workers", "2"))
    assert f"{len(there)} were there, {RECORDS - len(there)} computed" in errors
    assert all(stamp(library, i) == before for i, before in there.items())
    assert rows(library).equals(by_one)


def test_nobody_answers(plan: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("DASK_DISTRIBUTED__COMM__TIMEOUTS__CONNECT", "100ms")
    process = start(plan, tmp_path, "--scheduler", "tcp://127.0.0.1:9")
    _, errors = process.communicate()
    assert process.returncode == 1
    assert errors.startswith("nacre-library: --scheduler tcp://127.0.0.1:9: no scheduler answers")


def test_the_scripts_for_slurm(plan: Path, tmp_path: Path) -> None:
    options = ["--slurm", "--dry-run", "--workers", "100", "--slurm-option=--partition=day"]
    process = start(plan, tmp_path, *options)
    out, errors = process.communicate()
    assert process.returncode == 0, errors
    run, workers = (Path(line).read_text("utf-8") for line in out.splitlines())
    for script in (run, workers):
        assert script.startswith("#!/bin/bash\n#SBATCH --job-name=nacre-")
        assert "#SBATCH --partition=day\n" in script
        subprocess.run(["bash", "-n"], input=script, text=True, check=True)
    assert "#SBATCH --array=0-99\n" in workers
    assert "--array" not in run
    assert f"-m nacre.library run {plan} {tmp_path} --listen {tmp_path}/slurm/scheduler.json" in run
    assert f"--scheduler-file {tmp_path}/slurm/scheduler.json --nthreads 1" in workers
