#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Runs what the pages show: python3 manual/try.py PROGRAM FOLDER [PAGE ...]

A block ```sh run is a command line, in which `furiko` is PROGRAM; a block ```fortran run is a program, compiled with the
modules and objects in FOLDER. The next block ```text is what each prints, or for a program that does not compile what
gfortran says, of which the block has some lines.
"""
import os
import pathlib
import re
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).parent.parent


def shell(command, program, scratch):
    (scratch / "furiko").unlink(missing_ok=True)
    (scratch / "furiko").symlink_to(program)
    return subprocess.run(["bash", "-euc", command], cwd=scratch, text=True, capture_output=True,
                          env={**os.environ, "PATH": f"{scratch}:{os.environ['PATH']}"}).stdout


def fortran(source, folder, scratch):
    (scratch / "main.f90").write_text(source)
    objects = sorted(str(path) for path in folder.glob("furiko*.o"))
    made = subprocess.run(["gfortran", f"-I{folder}", "main.f90", *objects, "-o", "main"], cwd=scratch, text=True,
                          capture_output=True)
    return made.stderr.translate({0x2018: "'", 0x2019: "'"}) or subprocess.run(["./main"], cwd=scratch, text=True, capture_output=True).stdout


def same(said, shown):
    lines, wanted = ([line.split() for line in text.splitlines() if line.strip()] for text in (said, shown))
    return lines == wanted or ("Error:" in said and all(line in lines for line in wanted))


def main():
    program, folder = (pathlib.Path(word).resolve() for word in sys.argv[1:3])
    pages = [pathlib.Path(word) for word in sys.argv[3:]] or sorted([*ROOT.glob("README*.md"), *(ROOT / "doc").glob("*.md")])
    tried = 0
    for page in pages:
        blocks = re.findall(r"^```([^\n]*)\n(.*?)^```$", page.read_text(), re.M | re.S)
        for number, (kind, text) in enumerate(blocks):
            if kind not in ("sh run", "fortran run"):
                continue
            with tempfile.TemporaryDirectory() as name:
                scratch = pathlib.Path(name)
                said = shell(text, program, scratch) if kind == "sh run" else fortran(text, folder, scratch)
            shown = next(block for kind, block in blocks[number + 1:] if kind.startswith("text"))
            if not same(said, shown):
                sys.exit(f"{page}: {text}\nprints\n{said}\nthe page has\n{shown}")
            tried += 1
    print(f"{tried} commands and programs print what the pages show")


main()
