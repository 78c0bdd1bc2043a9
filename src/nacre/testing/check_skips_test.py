#!/usr/bin/env python3
"""Tests that no skipped test passes unless it gives a reason: main.cpp and check_skips.py.

usage: check_skips_test.py CTEST FOLDER   of the tests of skips.cpp
"""
import pathlib
import subprocess
import sys
import xml.etree.ElementTree as ElementTree

sys.dont_write_bytecode = True  # no folders in the sources
import check_skips

EXPECTED = {
    "SetUpFails.OfASuite": "fail",
    "SetUpExpects.OfASuite": "fail",
    "SetUpThrows.OfASuite": "fail",
    "Skips.WithoutAReason": "fail",
    "Skips.WithATraceAlone": "fail",
    "Skips.WithAReason": "notrun",
    "Skips.Always": "disabled",
    "Skips.No": "run",
}


def run(ctest, folder, *arguments):
    path = pathlib.Path(folder).resolve() / "tests.xml"
    path.unlink(missing_ok=True)
    status = subprocess.run([ctest, "--test-dir", folder, "--output-junit", path,
                             "--test-output-size-passed", "100000", *arguments],
                            stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL).returncode
    return path, status


def check(path):
    script = pathlib.Path(__file__).with_name("check_skips.py")
    return subprocess.run([sys.executable, script, path], stderr=subprocess.DEVNULL).returncode


def main():
    ctest, folder = sys.argv[1:]
    path, status = run(ctest, folder)
    found = {case.get("name"): case.get("status")
             for case in ElementTree.parse(path).getroot().findall(".//testcase")}
    assert found == EXPECTED, found
    assert status != 0
    reasons, _ = check_skips.skips(path)
    assert reasons == [("Skips.WithAReason", "deliberately"),
                       ("Skips.Always", None)], reasons
    assert check(path) == 1  # for the disabled one
    path, status = run(ctest, folder, "-R", "WithAReason|No")
    assert status == 0 and check(path) == 0
    path, _ = run(ctest, folder, "-R", "no such test")
    assert check(path) == 1


if __name__ == "__main__":
    main()
