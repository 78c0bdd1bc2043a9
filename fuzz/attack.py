#!/usr/bin/env python3
"""Attacks the program as accidents and strangers do, and counts what did not hold.

    fuzz/attack.py PROGRAM [--tries N] [--seed S] [--markdown]

Each attack makes some number of tries and says for each whether a promise of docs/conventions.md
was kept: the program ends by itself with one of its exit statuses, says why unless all went well,
leaves every file whole, either the old or the new one, and gives the same bytes for the same input.
fuzz/run.sh looks for memory errors inside of the readers; this looks at the program from outside.

Exit status: 0 if all held, 1 if not; each failure is printed with what repeats it.
"""
import argparse
import pathlib
import random
import signal
import sys
import tempfile
import time

from attacks import inputs, places, signals
from attacks.lab import Attack, Lab

# What each is called in the report, and how many of N tries it makes.
ATTACKS: list[tuple[str, Attack, float]] = [
    ("damaged files of twelve kinds", inputs.damaged_files, 1.0),
    ("small files that are large to read", inputs.hostile_texts, 0),
    ("recipes at the ends of the allowed ranges", inputs.extreme_recipes, 0.1),
    ("SIGKILL at a random moment", signals.sigkill, 0.1),
    ("SIGINT or SIGTERM at a random moment", signals.interrupts, 0.05),
    ("SIGINT or SIGTERM during long work", signals.slow_interrupts, 0.08),
    ("a disk that fills up", places.full_disk, 0.02),
    ("3 to 23 file descriptors", places.few_descriptors, 0.05),
    ("80 to 600 MB of memory", places.little_memory, 0.05),
    ("closed or full standard streams", places.closed_streams, 0),
    ("an output that is an input or a foreign file", places.output_is_input, 0),
    ("outputs and inputs that are no files", places.unusual_places, 0),
    ("the same input again, on 1, 2 and 7 threads", places.same_bytes, 0),
]


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("program", type=pathlib.Path)
    parser.add_argument("--tries", type=int, default=1000, help="of the largest attack")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--only", default="", help="attacks whose name contains this")
    parser.add_argument("--markdown", action="store_true", help="print the table of the docs")
    options = parser.parse_args()
    # A shell's background jobs ignore SIGINT, and so would the program, until it has its own handler.
    signal.signal(signal.SIGINT, signal.default_int_handler)
    rows, failures = [], 0
    for name, attack, share in ATTACKS:
        if options.only not in name:
            continue
        with tempfile.TemporaryDirectory() as folder:
            lab = Lab(options.program.resolve(), pathlib.Path(folder), random.Random(options.seed))
            start, tries, wrong = time.monotonic(), 0, 0
            for complaint in attack(lab, max(5, round(share * options.tries))):
                tries += 1
                if complaint:
                    wrong += 1
                    print(f"{name}: {complaint}", file=sys.stderr)
            seconds = time.monotonic() - start
        name += lab.note
        print(f"{name}: {tries} tries, {wrong} failures, {seconds:.0f} s", file=sys.stderr)
        rows.append((name, tries, wrong))
        failures += wrong
    if options.markdown:
        print("| Attack | Tries | Failures |\n|---|--:|--:|")
        for row in rows:
            print("| {} | {} | {} |".format(*row))
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
