#!/usr/bin/env python3
"""Does what the documentation says one can do, and checks that it happens.

Every fenced block of README.md, CONTRIBUTING.md and docs/**/*.md is one of

    ```sh                   run in a scratch folder, must succeed
    ```sh ci                each line must be a step of .ci/run, which runs it,
                            perhaps with more options
    ```text output          what the sh block before printed to stdout; numbers to 5 digits
    ```toml recipe=NAME     written to NAME in the scratch folder, must be a valid recipe
    ```toml refused         must be refused with status 2 and the message of the next block,
    ```text message         of which '...' stands for anything
    ```toml                 must be valid TOML
    ```console              shown only: what needs another machine, or changes this one
    any other language      shown only

Blocks of one document share a scratch folder with copies of paints/, scenes/, studies/ and library/paints and find the
program as `nacre`. Links to files of the repository must lead somewhere, and docs/paints.md and
docs/effect-pigments.md must show every recipe of paints/.
"""

import argparse
import dataclasses
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import time
import tomllib

ROOT = pathlib.Path(__file__).resolve().parent.parent
HANG_SECONDS = 600  # only to end a command that would never end
NUMBER = re.compile(r"[-+]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?")
SHOWN_ONLY = {"console", "text", "cpp", "cmake", "python", "bibtex", "mermaid", "js", "json", ""}


@dataclasses.dataclass
class Block:
    path: pathlib.Path
    line: int
    language: str
    role: str
    text: str

    @property
    def place(self):
        return f"{self.path.relative_to(ROOT)}:{self.line}"


class Failure(Exception):
    pass


def fenced_blocks(path):
    blocks, opened = [], None
    for number, line in enumerate(path.read_text(encoding="utf-8").splitlines(), 1):
        fence = re.match(r"\s*```(.*)$", line)
        if opened is None and fence:
            language, _, role = fence.group(1).strip().partition(" ")
            opened = Block(path, number, language, role.strip(), "")
        elif opened is not None and fence:
            blocks.append(opened)
            opened = None
        elif opened is not None:
            opened.text += line + "\n"
    if opened is not None:
        raise Failure(f"{opened.place}: this block is not closed")
    return blocks


def broken_links(path):
    text = re.sub(r"```.*?```", "", path.read_text(encoding="utf-8"), flags=re.DOTALL)
    for target in re.findall(r"\]\(([^)\s]+)\)", text) + re.findall(r'src="([^"]+)"', text):
        if re.match(r"[a-z]+:", target) or target.startswith("#"):
            continue
        if not (path.parent / target.split("#")[0]).exists():
            yield f"{path.relative_to(ROOT)}: the link {target} leads nowhere"


def run(script, scratch, environment):
    return subprocess.run(
        ["bash", "-euo", "pipefail", "-c", script],
        cwd=scratch,
        env=environment,
        stdin=subprocess.DEVNULL,
        capture_output=True,
        text=True,
        timeout=HANG_SECONDS,
    )


def same_output(expected, actual):
    """Words must be equal, numbers to 5 digits: the last ones depend on processor and library."""
    if NUMBER.sub("#", expected).split() != NUMBER.sub("#", actual).split():
        return False
    return all(
        abs(float(a) - float(b)) <= 1e-5 * max(abs(float(a)), abs(float(b)))
        for a, b in zip(NUMBER.findall(expected), NUMBER.findall(actual), strict=True)
    )


def matches_message(expected, actual):
    pattern = r".*?".join(re.escape(part.strip()) for part in expected.split("..."))
    pattern = re.sub(r"(\\\s|\\\n)+", r"\\s+", pattern)
    return re.search(pattern, actual, flags=re.DOTALL) is not None


def check_recipe(block, name, scratch, environment, wanted_status):
    (scratch / name).write_text(block.text, encoding="utf-8")
    process = run(f"nacre info '{name}'", scratch, environment)
    if process.returncode != wanted_status:
        raise Failure(
            f"{block.place}: status {process.returncode}, not {wanted_status}\n{process.stderr}"
        )
    return process


def check_document(path, environment, ci_steps):
    """Checks one document; returns how many blocks were tried."""
    blocks, tried, previous = fenced_blocks(path), 0, None
    with tempfile.TemporaryDirectory(prefix="nacre-docs-") as folder:
        scratch = pathlib.Path(folder)
        for shared in ("paints", "scenes", "studies", "data/drawdowns", "library/paints"):
            shutil.copytree(ROOT / shared, scratch / shared)
        for block in blocks:
            kind = (block.language, block.role.split("=")[0])
            if kind == ("sh", ""):
                start = time.monotonic()
                previous = run(block.text, scratch, environment)
                if previous.returncode != 0:
                    raise Failure(
                        f"{block.place}: status {previous.returncode} from\n{block.text}"
                        f"{previous.stdout}{previous.stderr}"
                    )
                print(f"{block.place}: ok, {time.monotonic() - start:.1f} s")
            elif kind == ("sh", "ci"):
                for line in filter(None, (l.split("#")[0].strip() for l in block.text.split("\n"))):
                    if not any(step == line or step.startswith(line + " ") for step in ci_steps):
                        raise Failure(f"{block.place}: '{line}' is no step of .ci/run")
            elif kind == ("text", "output"):
                if previous is None or not same_output(block.text, previous.stdout):
                    raise Failure(
                        f"{block.place}: the command above prints\n{previous and previous.stdout}"
                    )
            elif kind == ("toml", "recipe"):
                check_recipe(block, block.role.partition("=")[2], scratch, environment, 0)
            elif kind == ("toml", "refused"):
                previous = check_recipe(block, "paint.toml", scratch, environment, 2)
            elif kind == ("text", "message"):
                if previous is None or not matches_message(block.text, previous.stderr):
                    raise Failure(
                        f"{block.place}: the message is\n{previous and previous.stderr}"
                    )
            elif kind == ("toml", ""):
                try:
                    tomllib.loads(block.text)
                except tomllib.TOMLDecodeError as error:
                    raise Failure(f"{block.place}: {error}") from error
            elif block.role or block.language not in SHOWN_ONLY:
                raise Failure(f"{block.place}: what is a block '{block.language} {block.role}'?")
            else:
                continue
            tried += 1
    return tried


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--program", type=pathlib.Path, required=True, help="the built nacre")
    parser.add_argument("documents", nargs="*", type=pathlib.Path, help="default: all")
    arguments = parser.parse_args()
    if not arguments.program.is_file():
        parser.error(f"there is no program {arguments.program}; ./dev build makes it")

    documents = [path.resolve() for path in arguments.documents] or [
        ROOT / "README.md",
        ROOT / "CONTRIBUTING.md",
        *sorted((ROOT / "docs").rglob("*.md")),
    ]
    ci_steps = {
        line.strip().removeprefix("step").split("#")[0].strip()
        for line in (ROOT / ".ci/run").read_text(encoding="utf-8").splitlines()
        if line.strip().startswith("step ")
    }
    environment = dict(os.environ)
    environment["PATH"] = f"{arguments.program.resolve().parent}:{environment['PATH']}"

    failures, tried = [], 0
    for path in documents:
        failures += broken_links(path)
        try:
            tried += check_document(path, environment, ci_steps)
        except (Failure, subprocess.TimeoutExpired) as failure:
            failures.append(str(failure))
    for page, folder in (("paints.md", "paints"), ("effect-pigments.md", "paints/effect-pigments")):
        gallery = (ROOT / "docs" / page).read_text(encoding="utf-8")
        for paint in sorted((ROOT / folder).glob("*.toml")):
            if f"(../{folder}/{paint.name})" not in gallery:
                failures.append(f"docs/{page}: {paint.name} is missing")
    if not tried:
        failures.append("no block was tried; is this the right folder?")
    for failure in failures:
        print(failure, file=sys.stderr)
    print(f"{len(documents)} documents, {tried} blocks tried, {len(failures)} failures.")
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
