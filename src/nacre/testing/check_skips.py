#!/usr/bin/env python3
"""Fails if a test was not run and does not say why.

usage: check_skips.py FILE   what ctest --output-junit FILE has written

Tests in C++ give their reason by GTEST_SKIP() << "..."; main.cpp prints it behind the mark below.
Files of tests in Python run as one test each, and print a line with the mark for each that they
skipped (python/tests/conftest.py). A test that is disabled, or that another program skips, has no
reason.
"""
import sys
import xml.etree.ElementTree as ElementTree

MARK = "skipped, for a reason: "


def skips(path):
    """(name, reason or None) of each test that was not run, or not all of it, and how many tests
    there are."""
    cases = ElementTree.parse(path).getroot().findall(".//testcase")
    found = []
    for case in cases:
        lines = (case.findtext("system-out") or "").splitlines()
        reasons = [line[len(MARK):] for line in lines if line.startswith(MARK)]
        if case.get("status") not in ("run", "fail"):
            found.append((case.get("name"), reasons[0] if reasons else None))
        else:
            found += [(case.get("name"), reason) for reason in reasons]
    return found, len(cases)


def main():
    found, count = skips(sys.argv[1])
    for name, reason in found:
        print(f"{name} was not run: {reason or 'no reason given'}", file=sys.stderr)
    if count == 0:
        print(f"{sys.argv[1]} names no test", file=sys.stderr)
    return int(count == 0 or any(reason is None for _, reason in found))


if __name__ == "__main__":
    sys.exit(main())
