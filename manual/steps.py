#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""The tables of doc/steps.md, by manual/steps.f90: python3 manual/steps.py FOLDER [--check], the modules and objects being there"""
import pathlib
import re
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).parent.parent
PAGE = ROOT / "doc/steps.md"


def main():
    folder = pathlib.Path(sys.argv[1]).resolve()
    with tempfile.TemporaryDirectory() as scratch:
        subprocess.run(["gfortran", "-O2", f"-I{folder}", str(ROOT / "manual/steps.f90"), *map(str, folder.glob("furiko*.o")),
                        "-o", "steps"], cwd=scratch, check=True)
        tables = iter(subprocess.run([f"{scratch}/steps"], text=True, capture_output=True, check=True).stdout.split("\n\n"))
    old = PAGE.read_text()
    new, found = re.subn(r"(?<=^<!-- by manual/steps.f90 -->\n\n)(\|.*\n)*", lambda _: next(tables).strip() + "\n", old,
                         flags=re.M)
    assert found == 2, "doc/steps.md has not two places for tables"
    if "--check" in sys.argv:
        sys.exit(old != new and "doc/steps.md: not what manual/steps.f90 prints; run manual/steps.py")
    PAGE.write_text(new)


main()
