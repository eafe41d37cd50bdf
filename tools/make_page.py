#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Writes app/furiko_cli_page.inc, the page of `furiko animate` as Fortran, from app/page/pendulum.html:
fpm has no way to bring a file along with a program. Runs without arguments, or with the folder to
write to."""

import pathlib
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
TEMPLATE = ROOT / "app/page/pendulum.html"
WIDTH = 110

HEAD = """\
   ! Written by tools/make_page.py from app/page/pendulum.html; edit that.

   subroutine put_page(page)
      type(output), intent(inout) :: page

"""
TAIL = """\
   end subroutine put_page
"""


def statement(line):
    """The Fortran that writes one line of the page, on two lines where it is long."""
    # Compilers differ over backslashes and over what is not ASCII.
    if not line.isascii() or "\\" in line or "\t" in line:
        sys.exit(f"{TEMPLATE}: not plain ASCII without tabs and backslashes: {line}")
    if line == "@table@":
        return "      call put_table(page)\n"
    call = "      call page%put('" + line.replace("'", "''") + "')\n"
    if len(call) <= WIDTH + 1:
        return call
    cut = line.rfind(" ", 0, WIDTH - 30)
    first, rest = (part.replace("'", "''") for part in (line[:cut], line[cut:]))
    return f"      call page%put('{first}' // &\n         '{rest}')\n"


def main():
    folder = pathlib.Path(sys.argv[1]) if len(sys.argv) > 1 else ROOT / "app"
    lines = TEMPLATE.read_text(encoding="ascii").splitlines()
    text = HEAD + "".join(map(statement, lines)) + TAIL
    if max(map(len, text.splitlines())) > WIDTH:
        sys.exit(f"{TEMPLATE}: a line is too long to stand in Fortran")
    (folder / "furiko_cli_page.inc").write_text(text, encoding="ascii", newline="\n")


main()
