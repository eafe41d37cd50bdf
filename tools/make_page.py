#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Writes app/furiko_cli_page.inc, the page of `furiko animate` as Fortran, from app/page/: pendulum.html, in
which @name@ alone on a line stands for the file of that name. fpm has no way to bring a file along with a program.
Runs without arguments, with the folder to write to, or with --html, which prints the page."""

import pathlib
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
SOURCE = ROOT / "app/page"
WIDTH = 110
PIECE = 82  # bytes of a line of the page on a line of Fortran
PART = 150  # lines of the page in a procedure: compilers take long over long ones

HEAD = """\
   ! Written by tools/make_page.py from app/page/; edit those files.

   subroutine put_page(page, begin)
      type(output), intent(inout) :: page
      !> The line of the page that says its version and state
      character(len=*), intent(in) :: begin

"""


def lines_of(name):
    """The lines of a file, with those of the files that it names."""
    for line in (SOURCE / name).read_text(encoding="utf-8").splitlines():
        inner = line.strip("@")
        if line == f"@{inner}@" and inner != "begin":
            yield from lines_of(inner)
        else:
            # Compilers differ over backslashes.
            if "\\" in line or "\t" in line:
                sys.exit(f"{SOURCE / name}: a backslash or a tab: {line}")
            yield line


def pieces(line):
    """A line in pieces of so many bytes, as Fortran's lines are counted; no character is cut."""
    piece = ""
    for character in line.replace("'", "''"):
        if len((piece + character).encode()) > PIECE and not piece.endswith("'"):
            yield piece
            piece = ""
        piece += character
    yield piece


def statement(line):
    """The Fortran that writes one line of the page."""
    if line == "@begin@":
        return "      call page%put(begin)\n"
    return "      call page%put('" + "' // &\n         '".join(pieces(line)) + "')\n"


def main():
    lines = list(lines_of("pendulum.html"))
    if sys.argv[1:] == ["--html"]:
        sys.stdout.buffer.write(("\n".join(lines) + "\n").encode())
        return
    statements = [statement(line) for line in lines]
    first = next(i for i, line in enumerate(lines) if line == "@begin@")
    cuts = [0, first, first + 1, *range(first + 1 + PART, len(lines), PART), len(lines)]
    text, calls = "", ""
    for number, (start, end) in enumerate(zip(cuts, cuts[1:]), 1):
        if end == start + 1:
            calls += statements[start]
            continue
        calls += f"      call put_part_{number}(page)\n"
        text += (f"\n\n   subroutine put_part_{number}(page)\n      type(output), intent(inout) :: page\n\n"
                 + "".join(statements[start:end]) + f"   end subroutine put_part_{number}\n")
    text = HEAD + calls + "   end subroutine put_page\n" + text
    if max(len(line.encode()) for line in text.splitlines()) > WIDTH:
        sys.exit(f"{SOURCE}: a line is too long to stand in Fortran")
    folder = pathlib.Path(sys.argv[1]) if len(sys.argv) > 1 else ROOT / "app"
    (folder / "furiko_cli_page.inc").write_text(text, encoding="utf-8", newline="\n")


main()
