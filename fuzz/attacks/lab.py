"""The program in a scratch folder, and what must hold of each run."""

import dataclasses
import hashlib
import pathlib
import random
import resource
import shutil
import signal
import subprocess
import sys
import time
from collections.abc import Callable, Iterator

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
STATUSES = range(5)  # docs/conventions.md, "Errors and exit status"
HANG_S = 120.0
# After a signal, a second on two cores; by the clock more, as the machine may do other things too.
ANSWER_CPU_S, ANSWER_S = 3.0, 20.0
MEMORY_BYTES = 4 << 30
PAINT = "paints/metallic-gray.toml"


@dataclasses.dataclass
class Outcome:
    status: int  # negative: ended by that signal
    stdout: bytes
    stderr: bytes
    hung: bool = False

    def complaint(self) -> str:
        """Why this is no way to end, or nothing."""
        if self.hung:
            return f"did not end within {HANG_S:.0f} s"
        if self.status < 0:
            return f"was ended by {signal.Signals(-self.status).name}"
        if self.status not in STATUSES:
            return f"ended with {self.status}: {self.stderr[-200:]!r}"
        if self.status not in (0, 4) and not self.stderr.strip():
            return f"ended with {self.status} without a word"
        return ""


class Lab:
    """The program and a scratch folder to run it in."""

    def __init__(self, program: pathlib.Path, folder: pathlib.Path, rng: random.Random) -> None:
        self.program, self.folder, self.random = program, folder, rng
        self.note = ""  # what an attack has to say besides its failures
        for name in ("paints", "scenes"):
            shutil.copytree(ROOT / name, folder / name)

    def path(self, name: str) -> pathlib.Path:
        return self.folder / name

    def start(self, arguments: list[str], limits: dict[int, int] | None = None, **how):
        def restrict() -> None:
            resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
            for what, value in {resource.RLIMIT_AS: MEMORY_BYTES, **(limits or {})}.items():
                resource.setrlimit(what, (value, value))
            if limits and resource.RLIMIT_FSIZE in limits:
                signal.signal(signal.SIGXFSZ, signal.SIG_IGN)

        return subprocess.Popen([self.program, *arguments], cwd=self.folder, preexec_fn=restrict,
                                **{"stdin": subprocess.DEVNULL, "stdout": subprocess.PIPE,
                                   "stderr": subprocess.PIPE, **how})

    def run(self, arguments: list[str], limits: dict[int, int] | None = None, **how) -> Outcome:
        process = self.start(arguments, limits, **how)
        try:
            out, err = process.communicate(timeout=HANG_S)
        except subprocess.TimeoutExpired:
            process.kill()
            process.communicate()
            return Outcome(0, b"", b"", hung=True)
        return Outcome(process.returncode, out or b"", err or b"")


# An attack yields, for each of its tries, what went wrong, or nothing.
Attack = Callable[[Lab, int], Iterator[str]]

# A command, and the files that it writes.
WRITERS: dict[str, tuple[list[str], list[str]]] = {
    "solve": (["solve", PAINT, "--wavelength", "450,550,650", "-o", "out.h5"], ["out.h5"]),
    "render": (["render", "sphere", "--paint", PAINT, "--size", "16x16", "--spp", "2", "-o",
                "out.exr"], ["out.exr", "out.png"]),
    "eval": (["eval", PAINT, "--incident", "45", "--outgoing", "0:80:10", "-o", "out.csv"],
             ["out.csv"]),
    "measure": (["measure", PAINT, "-o", "out-measured.csv"], ["out-measured.csv"]),
    "export": (["export", PAINT, "--cells", "8,8,16", "-o", "out.binary"],
               ["out.binary"]),
}


def digest(path: pathlib.Path) -> str:
    return hashlib.sha256(path.read_bytes()).hexdigest() if path.exists() else "nothing"


def partial_files(lab: Lab) -> list[str]:
    return [p.name for p in lab.folder.iterdir() if ".partial" in p.name]


def remove_outputs(lab: Lab) -> None:
    for _, outputs in WRITERS.values():
        for name in outputs:
            lab.path(name).unlink(missing_ok=True)


def references(lab: Lab) -> dict[str, tuple[float, dict[str, str]]]:
    """For each command, its time and the digests of what it writes when nobody disturbs it."""
    found = {}
    for name, (arguments, outputs) in WRITERS.items():
        remove_outputs(lab)
        start = time.monotonic()
        outcome = lab.run(arguments)
        seconds = time.monotonic() - start
        if outcome.status != 0:
            sys.exit(f"attack: '{' '.join(arguments)}' fails undisturbed: {outcome.stderr!r}")
        found[name] = seconds, {o: digest(lab.path(o)) for o in outputs}
    return found


def torn(lab: Lab, before: dict[str, str], after: dict[str, str]) -> str:
    """Which output is neither the old one nor the new one, or nothing."""
    for name, new in after.items():
        now = digest(lab.path(name))
        if now not in (before[name], new):
            size = lab.path(name).stat().st_size if lab.path(name).exists() else 0
            return f"left '{name}' neither old nor new ({size} bytes)"
    return ""
