#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""The table of largest errors in README.md, from doc/accuracy.md: python3 tools/make_readme_accuracy.py

doc/accuracy.md is written by `./fpmw test -- report doc/accuracy.md`. A row here stands for several of
its families, over all their regimes; a number is rounded up. Some are in epsilon, as their title says.
`--check` writes nothing and fails where
README.md says something else.
"""
import math
import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).parent.parent
# What a row is called, its families, and whether arrays or scalars
ROWS = [
    ("K, E", "ellipk ellipe", False),
    ("B, D", "ellipb ellipd", False),
    ("S; Bulirsch's cel", "ellips bulirsch_cel", False),
    ("J, complete and incomplete", "ellipj", False),
    ("F, E(φ), D(φ); Π, complete and incomplete", "ellipf ellipeinc ellipdinc ellippi ellippiinc", False),
    ("the same in arrays", "ellipf ellipeinc ellipdinc ellippi ellippiinc", True),
    ("the inverse of E(φ), in ulp of φ or half ulp of s", "ellipeinc_inverse", False),
    ("Carlson's forms", "carlson carlson_rj", False),
    ("the same in arrays", "carlson carlson_rj", True),
    ("sn, cn, dn, the other nine, am and epsilon, next to their zeros too", "jacobi jacobi_epsilon", False),
    ("the same in arrays", "jacobi jacobi_epsilon", True),
    ("their inverses", "jacobi_arc", False),
    ("nome and its inverse, theta functions, zeta, lambda, inverses of K",
     "nome theta jacobi_zeta heuman_lambda parameter complementary", False),
    ("K, E and the nome of a modulus", "modulus", False),
    ("the arithmetic-geometric mean", "agm", False),
    ("T/T_h by the amplitude, and its excess over 1", "period period_excess", False),
    ("the amplitude by T/T_h, or by the excess", "amplitude_of_period amplitude_of_excess", False),
    ("the notes' own ways: series, AGM step by step, trapezoidal rule", "ellipk_series ellipe_series"
     " period_ratio_series amplitude_three_terms agm_steps ellipk_trapezoid ellipe_trapezoid", False),
    ("an ellipse's perimeter", "ellipse_perimeter", False),
    ("the same by its series", "ellipse_perimeter_series", False),
    ("sn, cn, dn of complex u, in ε of their absolute value", "complex", False),
    ("a motion's angle, rate and phase, in ε", "motion_angle motion_rate motion_phase", False),
    ("its tension, times to an angle and slack angle, in ε", "motion_tension motion_time_to motion_slack", False),
]
HEAD = "| largest error in ulp | real32 | real64 | real128 |\n|---|---|---|---|\n"


def families(report):
    """(family, (six numbers: scalar and array of each kind)) for each line of the first table."""
    for line in report.partition("\n## ")[0].splitlines():
        cells = [cell.strip() for cell in line.strip("|").split("|")]
        if len(cells) == 8 and re.fullmatch(r"[a-z]\w*", cells[0]) and cells[0] != "family":
            yield cells[0], [float(cell) for cell in cells[2:]]


def upwards(x):
    """Rounded up to two figures behind the point below 1, else one"""
    places = 2 if x <= 1 else 1
    return f"{math.ceil(x * 10**places - 1e-9) / 10**places:.{places}f}"


def table(report):
    measured = list(families(report))
    used = {name for _, names, _ in ROWS for name in names.split()}
    assert used == {name for name, _ in measured}, used ^ {name for name, _ in measured}
    text = HEAD
    for title, names, array in ROWS:
        rows = [numbers[array::2] for name, numbers in measured if name in names.split()]
        text += f"| {title} | " + " | ".join(upwards(max(column)) for column in zip(*rows)) + " |\n"
    return text


def main():
    report = (ROOT / "doc/accuracy.md").read_text()
    points = sum(int(n) for n in re.findall(r"^\| [a-z]\w* \| [\w-]* \| (\d+) \|", report, re.M))
    path = ROOT / "README.md"
    old = path.read_text()
    new, found = re.subn(re.escape(HEAD) + r"(\|.*\n)*", lambda _: table(report), old)
    assert found == 1, "README.md has no such table"
    new, found = re.subn(r"[\d,]+ values of\n?40-digit references", f"{points:,} values of\n40-digit references", new)
    assert found == 1, "README.md does not say how many values"
    if "--check" in sys.argv:
        sys.exit(old != new and "README.md: not what doc/accuracy.md says; run tools/make_readme_accuracy.py")
    path.write_text(new)


main()
