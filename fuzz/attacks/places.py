"""Machines that lack something, and outputs and inputs that are no good files."""

import os
import random
import resource
import shutil
import subprocess
import time
from collections.abc import Callable, Iterator

from .lab import HANG_S, PAINT, WRITERS, Lab, digest, references, remove_outputs, torn

def limited(lab: Lab, tries: int, what: int, values: Callable[[random.Random], int]
            ) -> Iterator[str]:
    undisturbed = references(lab)
    for number in range(tries):
        name = list(WRITERS)[number % len(WRITERS)]
        arguments, outputs = WRITERS[name]
        remove_outputs(lab)
        for output in outputs:
            if output != "out.png":
                lab.path(output).write_bytes(b"old")
        before = {o: digest(lab.path(o)) for o in outputs}
        value = values(lab.random)
        outcome = lab.run(arguments, {what: value})
        if b"error while loading shared libraries" in outcome.stderr:
            yield ""  # the program has not begun
            continue
        complaint = outcome.complaint() or torn(lab, before, undisturbed[name][1])
        if not complaint and outcome.status == 0:
            wrong = [o for o, new in undisturbed[name][1].items() if digest(lab.path(o)) != new]
            complaint = f"ended with 0, and {wrong} is not what it should be" if wrong else ""
        yield f"{name}, limit {value}: {complaint}" if complaint else ""


def full_disk(lab: Lab, tries: int) -> Iterator[str]:
    return limited(lab, tries, resource.RLIMIT_FSIZE, lambda rng: rng.choice([0, 1, 100, 1000]))


def few_descriptors(lab: Lab, tries: int) -> Iterator[str]:
    return limited(lab, tries, resource.RLIMIT_NOFILE, lambda rng: rng.randrange(3, 24))


def little_memory(lab: Lab, tries: int) -> Iterator[str]:
    return limited(lab, tries, resource.RLIMIT_AS, lambda rng: rng.randrange(80, 600) << 20)


def closed_streams(lab: Lab, tries: int) -> Iterator[str]:
    commands = [["info", PAINT], ["info", "nowhere.toml"], ["eval", PAINT, "--incident", "200",
                "--outgoing", "0"], ["measure", PAINT, "-o", "out-measured.csv"], ["nonsense"],
                ["--version"], ["--help"]]
    for command in commands:
        for stream in ("stdin", "stdout", "stderr"):
            for what in ("closed", "/dev/full"):
                redirect = {"stdin": "<", "stdout": ">", "stderr": "2>"}[stream]
                redirect += "&-" if what == "closed" else what
                usual = lab.run(command)
                shell = subprocess.run(
                    ["bash", "-c", f'exec "$0" "$@" {redirect}', str(lab.program), *command],
                    cwd=lab.folder, capture_output=True, timeout=HANG_S)
                writes = stream == "stdout" and usual.stdout
                expected = {3} if writes else {usual.status}
                if command[0].startswith("--"):
                    expected.add(0)  # nothing is lost
                status = shell.returncode
                yield ("" if status in expected else
                       f"{' '.join(command)} {redirect}: ended with {status}, not {expected}")


def output_is_input(lab: Lab, tries: int) -> Iterator[str]:
    measured = "measured.csv"
    lab.run(["measure", PAINT, "-o", measured])
    lab.run(WRITERS["solve"][0])
    os.replace(lab.path("out.h5"), lab.path("solved.h5"))
    lab.run(WRITERS["render"][0])
    os.replace(lab.path("out.exr"), lab.path("one.exr"))
    shutil.copy(lab.path(PAINT), lab.path("paint.toml"))
    shutil.copy(lab.path("paint.toml"), lab.path("foreign.png"))
    cases = [
        (["solve", "paint.toml", "-o", "{}"], "paint.toml"),
        (["measure", "paint.toml", "-o", "{}"], "paint.toml"),
        (["export", "paint.toml", "--cells", "8,8,16", "-o", "{}"], "paint.toml"),
        (["eval", "solved.h5", "--incident", "45", "--outgoing", "0", "-o", "{}"], "solved.h5"),
        (["diff", "one.exr", "one.exr", "-o", "{}"], "one.exr"),
        (["fit", measured, "--start", "paint.toml", "--free", "layer[0].thickness_um", "-o", "{}"],
         "paint.toml"),
        (["fit", measured, "--start", "paint.toml", "--free", "layer[0].thickness_um", "-o", "{}"],
         measured),
        (["panel", "paint.toml", "--quality", "low", "-o", "{}"], "paint.toml"),
        (["solve", "paint.toml", "-o", "new.h5", "--report", "{}"], "paint.toml"),
        (["render", "sphere", "--paint", "paint.toml", "--size", "2x2", "--spp", "1", "-o", "{}"],
         "paint.toml"),
        (["render", "sphere", "--paint", "paint.toml", "--size", "2x2", "--spp", "1", "-o",
          "foreign.exr"], "foreign.png"),
    ]
    os.link(lab.path("paint.toml"), lab.path("hard-link.toml"))
    os.symlink("paint.toml", lab.path("soft-link.toml"))
    for command, victim in cases:
        names = [victim]
        if victim == "paint.toml":
            names += ["./paint.toml", "hard-link.toml", "soft-link.toml"]
        for name in names:
            before = digest(lab.path(victim))
            outcome = lab.run([a.replace("{}", name) for a in command])
            complaint = outcome.complaint()
            if not complaint and digest(lab.path(victim)) != before:
                complaint = "replaced its input"
            elif not complaint and outcome.status == 0:
                complaint = "ended with 0"
            yield f"{' '.join(command)} with {name}: {complaint}" if complaint else ""


def unusual_places(lab: Lab, tries: int) -> Iterator[str]:
    """Outputs that cannot be written are refused at once, and nothing is replaced."""
    lab.path("folder").mkdir()
    for arguments, _ in WRITERS.values():
        for name in ("", "folder", "no-such-folder/x.h5", "dangling", PAINT + "/x"):
            command = arguments[:-1] + [name]
            lab.path("dangling").unlink(missing_ok=True)
            os.symlink("nowhere/at-all", lab.path("dangling"))
            outcome = lab.run(command)
            complaint = outcome.complaint() or ("ended with 0" if outcome.status == 0 else "")
            if not complaint and not lab.path("dangling").is_symlink():
                complaint = "replaced a link"
            yield f"{command}: {complaint}" if complaint else ""
    os.mkfifo(lab.path("fifo"))
    for name in ("fifo", "folder", "/dev/zero", "/dev/null", "dangling"):
        for command in (["info", name], ["solve", name, "-o", "x.h5"]):
            outcome = lab.run(command)
            complaint = outcome.complaint() or ("ended with 0" if outcome.status == 0 else "")
            yield f"{' '.join(command)}: {complaint}" if complaint else ""


def same_bytes(lab: Lab, tries: int) -> Iterator[str]:
    """The same input gives the same bytes, in another second and on any number of threads."""
    undisturbed = references(lab)
    time.sleep(1.1)
    for name, (arguments, outputs) in WRITERS.items():
        for threads in ("1", "2", "7"):
            remove_outputs(lab)
            outcome = lab.run([*arguments, "--threads", threads])
            wrong = [o for o in outputs if digest(lab.path(o)) != undisturbed[name][1][o]]
            yield (f"{name} with {threads} threads: other bytes in {wrong}, {outcome.stderr!r}"
                   if wrong else "")
