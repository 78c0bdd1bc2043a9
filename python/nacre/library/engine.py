"""The engine: the records of a plan computed by Dask's workers, on this machine or many.

What is done lies in the library's folder, which all machines share; nothing else is remembered.
So a run may be killed at any point, and the next one computes what is missing.
"""

from __future__ import annotations

import fcntl
import logging
import math
import os
import shutil
import signal
import threading
import time
from collections.abc import Callable, Iterator, Sequence
from contextlib import AbstractContextManager, contextmanager
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import nacre

from .catalogue import write_catalogue
from .folder import prepare
from .record import Outcome, compute, failures, record_failure, record_folder, record_ids
from .settings import Settings
from .sweep import Plan, PlannedRecord

TASK_SECONDS = 1.0
"""How long a task of several records is to take: short against a run, long against its overhead."""
MOST_IN_TASK = 64

Client = Any  # of distributed, which has no types


@dataclass(frozen=True)
class State:
    """What a library has of a plan."""

    planned: list[PlannedRecord]
    done: set[str]
    failed: dict[str, dict[str, Any]]
    """why, by id; without those that are done by now"""
    others: set[str]
    """records that the plan does not name"""

    def missing(self, retry: bool = False) -> list[PlannedRecord]:
        """What a run has to compute. What Nacre refused before is left out, unless ``retry``."""
        hopeless = {i for i, why in self.failed.items() if not (retry or why["again"])}
        return [r for r in self.planned if r.id not in self.done and r.id not in hopeless]


def state_of(plan: Plan, library: Path | None) -> State:
    """Compares a plan with the records that are there; None: there are none."""
    planned = list(plan.records())
    if library is None:
        return State(planned, set(), {}, set())
    ids = {record.id for record in planned}
    there = record_ids(library)
    failed = {i: why for i, why in failures(library).items() if i in ids and i not in there}
    return State(planned, there & ids, failed, there - ids)


@dataclass(frozen=True)
class Summary:
    """What a run did."""

    planned: int
    found: int
    """that were there before"""
    computed: int
    failed: int
    """those of earlier runs included"""
    seconds: float


Report = Callable[[Outcome], object]


@contextmanager
def _deaf_to_ctrl_c() -> Iterator[None]:
    """Processes that are started meanwhile ignore Ctrl-C, which a terminal sends to all: they end
    when the run does, and without a traceback each."""
    if threading.current_thread() is not threading.main_thread():
        yield  # handlers are the main thread's
        return
    before = signal.signal(signal.SIGINT, signal.SIG_IGN)
    try:
        yield
    finally:
        signal.signal(signal.SIGINT, before)


@contextmanager
def _client_of(cluster: Any) -> Iterator[Client]:
    """A client of a cluster whose scheduler is part of this process; ends both.

    A scheduler that ends while workers still hang up logs an error with a traceback for each, which
    tells nobody anything: it keeps silent from then on.
    """
    from distributed import Client

    log = logging.getLogger("distributed.scheduler")
    before = log.level
    try:
        with cluster, Client(cluster) as client:
            try:
                yield client
            finally:
                log.setLevel(logging.CRITICAL)
    finally:
        log.setLevel(before)


@contextmanager
def local_cluster(workers: int) -> Iterator[Client]:
    """A client of worker processes on this machine, each with one thread."""
    from distributed import LocalCluster

    with _deaf_to_ctrl_c():
        local = LocalCluster(
            n_workers=workers,
            threads_per_worker=1,
            processes=True,
            dashboard_address="127.0.0.1:0",
            memory_limit=0,
            silence_logs=logging.ERROR,
        )
    with _client_of(local) as client:
        yield client


@contextmanager
def remote_cluster(scheduler: str) -> Iterator[Client]:
    """A client of a scheduler that runs, by its address or the file that it wrote.

    Raises
    ------
    nacre.Error
        If nothing answers there.
    """
    from distributed import Client

    is_file = Path(scheduler).is_file()
    try:
        client = Client(scheduler_file=scheduler) if is_file else Client(scheduler)
    except (OSError, ValueError) as error:
        raise nacre.Error(f"--scheduler {scheduler}: no scheduler answers there: {error}") from None
    with client:
        yield client


@contextmanager
def listening_cluster(file: Path, interface: str = "") -> Iterator[Client]:
    """A client of a scheduler in this process that waits for workers from elsewhere.

    Parameters
    ----------
    file
        Is written, so that ``dask worker --scheduler-file`` finds the scheduler.
    interface
        Of the network, as "eth0"; empty: the one that leads out.
    """
    from distributed import LocalCluster
    from distributed.utils import get_ip

    network = {"interface": interface} if interface else {"host": get_ip()}
    cluster = LocalCluster(
        n_workers=0, dashboard_address="127.0.0.1:0", silence_logs=logging.ERROR, **network
    )
    with _client_of(cluster) as client:
        client.write_scheduler_file(str(file))
        try:
            yield client
        finally:
            file.unlink(missing_ok=True)
            client.retire_workers(close_workers=True)


def _cluster(
    scheduler: str, listen: Path | None, interface: str, workers: int | None, records: int
) -> AbstractContextManager[Client]:
    if scheduler:
        return remote_cluster(scheduler)
    if listen is not None:
        return listening_cluster(listen, interface)
    return local_cluster(min(workers or len(os.sched_getaffinity(0)), records))


def _compute_all(
    records: Sequence[PlannedRecord], settings: Settings, library: Path
) -> list[Outcome]:
    """What a worker is asked to do; what is there already is passed over."""
    return [compute(record, settings, library) for record in records]


def compute_with(
    client: Client,
    records: Sequence[PlannedRecord],
    settings: Settings,
    library: Path,
    report: Report,
) -> None:
    """Computes records on the workers of a cluster, which may come and go.

    Records go out in tasks of about a second each. A task whose worker dies is given to another
    one; where Dask gives up, its records are tried one by one, and one that kills its workers alone
    is written down as failed.
    """
    from distributed import as_completed

    waiting = list(reversed(records))
    alone: list[PlannedRecord] = []
    running: dict[Any, list[PlannedRecord]] = {}
    completed = as_completed([])
    spent, count = 0.0, 0
    workers, asked = 1, -math.inf

    def send() -> None:
        nonlocal workers, asked
        if time.monotonic() > asked + 1:  # the answer is long where workers are many
            workers = max(1, len(client.scheduler_info(n_workers=-1)["workers"]))
            asked = time.monotonic()
        while len(running) < 3 * workers and (waiting or alone):
            if alone:
                task = [alone.pop()]
            else:
                size = int(TASK_SECONDS * count / spent) if spent > 0 else 1
                size = min(size, MOST_IN_TASK, len(waiting) // (2 * workers))  # an even end
                task = [waiting.pop() for _ in range(max(1, size))]
            future = client.submit(_compute_all, task, settings, library, pure=False)
            running[future] = task
            completed.add(future)

    send()
    for future in completed:
        task = running.pop(future)
        try:
            # Its status may be "lost" by now: the worker that had the result has died since. Then
            # another one is asked, and this waits.
            outcomes = future.result()
        except Exception as error:  # of Dask; what a record raises is an outcome
            if len(task) > 1:
                alone += task
            else:
                report(record_failure(task[0], library, error, 0.0))
        else:
            for outcome in outcomes:
                spent, count = spent + outcome.seconds, count + 1
                report(outcome)
        future.release()
        send()


@contextmanager
def only_run(library: Path) -> Iterator[None]:
    """Only one run at a time may write into a library."""
    library.mkdir(parents=True, exist_ok=True)
    with open(library / ".lock", "w") as lock:
        try:
            fcntl.flock(lock, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except OSError:
            raise nacre.Error(f"{library}: another run is at work on this library") from None
        yield


def run(
    plan: Plan,
    library: str | Path,
    *,
    workers: int | None = None,
    scheduler: str = "",
    listen: Path | None = None,
    interface: str = "",
    retry: bool = False,
    prune: bool = False,
    progress: bool = False,
) -> Summary:
    """Computes what a library lacks of a plan and writes its catalogue.

    Parameters
    ----------
    library
        The folder. All workers must have it under this path.
    workers
        Processes on this machine; None: one for each processor; 0: this process alone, without
        Dask.
    scheduler
        Instead, the address of a Dask scheduler that runs, or its file.
    listen, interface
        Instead, see :func:`listening_cluster`.
    retry
        Tries once more what was refused in an earlier run.
    prune
        Deletes the records that the plan does not name.
    progress
        Draws a bar with an estimate if stderr is a terminal.

    Raises
    ------
    nacre.Error
        If another run is at work on the library, or no scheduler answers.
    """
    library = Path(library).absolute()
    start = time.monotonic()
    with only_run(library):
        shutil.rmtree(library / ".work", ignore_errors=True)  # of runs that were killed
        state = state_of(plan, library)
        prepare(library, plan, [record.id for record in state.planned])
        missing = state.missing(retry)
        failed = set(state.failed) - {record.id for record in missing}
        done = set(state.done)
        if prune:
            _prune(library, state.others)

        def report(outcome: Outcome) -> None:
            (failed if outcome.error else done).add(outcome.id)
            bar.update()
            if failed:
                bar.set_postfix(failed=len(failed), refresh=False)

        try:
            with progress_bar(len(missing), progress, "paint") as bar:
                if workers == 0 and not scheduler and listen is None:
                    for record in missing:
                        report(compute(record, plan.settings, library))
                elif missing:
                    with _cluster(scheduler, listen, interface, workers, len(missing)) as client:
                        compute_with(client, missing, plan.settings, library, report)
        finally:
            shutil.rmtree(library / ".work", ignore_errors=True)
            write_catalogue(library, (r.id for r in state.planned if r.id in done))
    return Summary(
        len(state.planned),
        len(state.done),
        len(done) - len(state.done),
        len(failed),
        time.monotonic() - start,
    )


def _prune(library: Path, ids: set[str]) -> None:
    for identity in ids:
        shutil.rmtree(record_folder(library, identity))


def progress_bar(total: int, progress: bool, unit: str) -> Any:
    """Of tqdm; drawn if it is asked for and stderr is a terminal."""
    from tqdm import tqdm

    # None: only where stderr is a terminal
    return tqdm(total=total, unit=unit, disable=None if progress else True, smoothing=0.05)
