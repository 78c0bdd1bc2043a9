#!/usr/bin/env python3
"""Checks the citations in headers, sources and documentation against docs/references.bib.

A citation is a bracket that holds keys of the form name-name-year, with an optional place after a
comma, several being separated by semicolons: [walter-2007, eq. 21; heitz-deon-2014, section 3].

Fails on a key that is not in the bibliography, on an entry that is malformed or there twice, and
on an entry whose year is not the one in its key. Says which entries nobody cites.
"""

import argparse
import pathlib
import re
import sys

KEY = r"[a-z][a-z0-9]*(?:-[a-z0-9]+)*-(?:1[6-9]|20)[0-9]{2}(?:-[a-z0-9]+)*"
BRACKET = re.compile(r"\[([^\[\]]+)\](?!\()")  # not the text of a Markdown link
STARTS_WITH_KEY = re.compile(rf"\s*({KEY})\s*(?:,.*)?$", re.DOTALL)
COMMENT_MARKER = re.compile(r"\n\s*(?://[/!]?<?|#|\*)")
FOLDERS = ("src", "bench", "fuzz", "python", "web", "docs", "paints", "data", "studies", "scenes")
SUFFIXES = {".h", ".cpp", ".glsl", ".md", ".toml", ".py", ".ts"}
NOT_OURS = {"testdata", "node_modules"}
FIELDS = {  # what a reader needs to find the work
    "article": {"author", "title", "journal", "year"},
    "inproceedings": {"author", "title", "booktitle", "year"},
    "book": {"author", "title", "publisher", "year"},
    "phdthesis": {"author", "title", "school", "year"},
    "techreport": {"author", "title", "institution", "year"},
    "standard": {"title", "organization", "year"},
    "misc": {"title", "year"},
}


def citations(text):
    """Yields (line number, key) for every citation in a text."""
    # A bracket may run over a line break inside a comment: blank the comment markers, keeping the
    # length, so that positions still give lines.
    text = COMMENT_MARKER.sub(lambda m: "\n" + " " * (len(m.group()) - 1), text)
    for bracket in BRACKET.finditer(text):
        for part in bracket.group(1).split(";"):
            if match := STARTS_WITH_KEY.match(part):
                yield text.count("\n", 0, bracket.start()) + 1, match.group(1)


def parse_bibliography(text):
    """Returns ({key: (line, kind, {field: value})}, [problem...])."""
    entries, problems = {}, []
    position = 0
    while (match := re.compile(r"^[ \t]*@", re.MULTILINE).search(text, position)):
        line = text.count("\n", 0, match.end()) + 1
        head = re.compile(r"(\w+)\{\s*([^,\s]+)\s*,").match(text, match.end())
        if not head:
            problems.append((line, "an entry that does not start like @article{key,"))
            position = match.end()
            continue
        kind, key = head.group(1).lower(), head.group(2)
        depth, end = 1, head.end()
        while end < len(text) and depth:
            depth += {"{": 1, "}": -1}.get(text[end], 0)
            end += 1
        if depth:
            problems.append((line, f"{key}: braces do not close"))
        body = text[head.end() : end - 1]
        fields = {
            name.lower(): value
            for name, value in re.findall(
                r"(\w+)\s*=\s*(\{(?:[^{}]|\{(?:[^{}]|\{[^{}]*\})*\})*\}|\"[^\"]*\"|\d+)", body
            )
        }
        if key in entries:
            problems.append((line, f"{key}: already defined in line {entries[key][0]}"))
        if not re.fullmatch(KEY, key):
            problems.append((line, f"{key}: not of the form name-year"))
        if kind not in FIELDS:
            problems.append((line, f"{key}: @{kind} is none of {', '.join(sorted(FIELDS))}"))
        elif missing := sorted(FIELDS[kind] - fields.keys()):
            problems.append((line, f"{key}: lacks {', '.join(missing)}"))
        year = re.search(r"\d{4}", fields.get("year", ""))
        if year and year.group() not in key.split("-"):
            problems.append((line, f"{key}: the entry's year is {year.group()}"))
        entries[key] = (line, kind, fields)
        position = end
    return entries, problems


def main():
    here = pathlib.Path(__file__).resolve()
    root = here.parent.parent
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--root", type=pathlib.Path, default=root, help="the repository")
    arguments = parser.parse_args()
    root = arguments.root

    bibliography = root / "docs/references.bib"
    entries, problems = parse_bibliography(bibliography.read_text(encoding="utf-8"))
    messages = [f"{bibliography.relative_to(root)}:{line}: {text}" for line, text in problems]

    cited, files = {}, 0
    for folder in FOLDERS:
        for path in sorted((root / folder).rglob("*")):
            if path.suffix not in SUFFIXES or not path.is_file():
                continue
            if NOT_OURS.intersection(path.relative_to(root).parts) or path == here:
                continue
            files += 1
            for line, key in citations(path.read_text(encoding="utf-8")):
                cited.setdefault(key, []).append(f"{path.relative_to(root)}:{line}")
    for key, places in sorted(cited.items()):
        if key not in entries:
            messages += [f"{place}: [{key}] is not in docs/references.bib" for place in places]

    if not files or not cited:
        messages.append(f"{root}: no citation found in {files} files; looking in the wrong place?")
    for message in messages:
        print(message, file=sys.stderr)
    if messages:
        return 1
    uncited = sorted(entries.keys() - cited.keys())
    print(f"{files} files cite {len(cited)} of {len(entries)} works; every key is known.")
    if uncited:
        print("Cited nowhere: " + ", ".join(uncited))
    return 0


if __name__ == "__main__":
    sys.exit(main())
