#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""The table of speed in README.md, from doc/speed.md: python3 tools/make_readme_speed.py

doc/speed.md is written by `sh bench/run`, which calls this. A row here is a function in its main regime:
nanoseconds of a call with -O3, and how many times as fast as the fastest peer calls and arrays are.
`--check` writes nothing and fails where README.md says something else.
"""
import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).parent.parent
# What a row is called here and there
ROWS = [("K(m)", "K(m)"), ("E(m)", "E(m)"), ("D(m)", "D(m)"), ("Π(n, m)", "Pi(n, m)"), ("F(φ, m)", "F(phi, m)"),
        ("E(φ, m)", "E(phi, m)"), ("D(φ, m)", "D(phi, m)"), ("Π(n, φ, m)", "Pi(n, phi, m)"),
        ("R_C(x, y)", "RC(x, y)"), ("R_F(x, y, z)", "RF(x, y, z)"), ("R_D(x, y, z)", "RD(x, y, z)"),
        ("R_G(x, y, z)", "RG(x, y, z)"), ("R_J(x, y, z, p)", "RJ(x, y, z, p)"), ("sn, cn, dn of u to 6", "sn, cn, dn")]
FLAGS = ["-O2", "-O3", "-O3 -march=x86-64-v3", "-O3 -march=native"]
HEAD = ("| ns a call | furiko | fastest peer | times as fast, -O2 | -O3 | x86-64-v3 | native | arrays, -O2 | -O3 |"
        " x86-64-v3 | native |\n|---|---|---|---|---|---|---|---|---|---|---|\n")


def first_rows(text):
    """{function: {column: cell}} of the first regime of each function, in the first table of a section"""
    lines = [[cell.strip(" *") for cell in line.strip("|").split("|")]
             for line in text.partition("|")[2].partition("\n\n")[0].splitlines()]
    rows = {}
    for cells in lines[2:]:
        rows.setdefault(cells[0], dict(zip(lines[0], cells)))
    return rows


def fastest(row):
    return min(float(row[peer]) for peer in ("GSL", "Boost", "SciPy") if row.get(peer, "-") != "-")


def table(report):
    sections = {title: first_rows(text) for title, text in re.findall(r"^## ([^\n]*)\n(.*?)(?=^## |\Z)", report, re.M | re.S)}
    assert list(sections) == FLAGS, list(sections)
    text = HEAD
    for title, name in ROWS:
        rows = [sections[flags][name] for flags in FLAGS]
        calls = [row["/ furiko"] for row in rows]
        arrays = [row["fastest peer / array"] for row in rows]
        cells = [title, rows[1]["furiko"], f"{fastest(rows[1]):.1f}", *(f"{float(x):.1f}" for x in calls + arrays)]
        text += "| " + " | ".join(cells) + " |\n"
    return text


def main():
    report = (ROOT / "doc/speed.md").read_text()
    path = ROOT / "README.md"
    old = path.read_text()
    new, found = re.subn(re.escape(HEAD) + r"(\|.*\n)*", lambda _: table(report), old)
    assert found == 1, "README.md has no such table"
    if "--check" in sys.argv:
        sys.exit(old != new and "README.md: not what doc/speed.md says; run tools/make_readme_speed.py")
    path.write_text(new)


main()
