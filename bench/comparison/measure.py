#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""The table of doc/comparison.md, on standard output: python3 measure.py FOLDER [--check]. FOLDER is where `run` has put
what it built and installed; the reference is kept there. With --check, furiko's program is compared with the reference
and with the command line."""
import math
import os
import pathlib
import shlex
import subprocess
import sys
import tempfile
import time
from collections import namedtuple

HERE = pathlib.Path(__file__).parent.resolve()
FOLDER = pathlib.Path(sys.argv[1]).resolve()
FIRST, LAST, MEMBERS, TRANSIENT, KEPT = 1.06, 1.087, 400, 200, 50
DRIVES = [FIRST + (LAST - FIRST) * (i / (MEMBERS - 1)) for i in range(MEMBERS)]
# Members that forget a change of their start of this size are those whose points can be compared.
CHANGE = 1e-9
# SciPy's orbits one after another: a 20th of them, and the time times 20
PART = 20

# A row of the table, whose program has so many lines; `run` is a command line with places for {transient} and {kept}.
# Of the members every `part`th is computed, and the least of so many repeats counts.
Row = namedtuple("Row", "name lines compile run part repeats", defaults=(1, 5))
Answer = namedtuple("Answer", "points seconds wall")
CPP = "g++ {} -march=native -fopenmp '-DSTEPPER={}' {}.cpp -o odeint"
NEW = "python/bin/python"
SVML = "env LD_LIBRARY_PATH=svml/lib svml/bin/python"


def count_lines(file):
    """Lines that are not empty, not comments and not documentation"""
    lines = [line.strip() for line in (HERE / file).read_text().splitlines()]
    pragmas = ("#include", "#pragma")
    return sum(line.startswith(pragmas) or not (not line or line.startswith(("#", "//", "!", '"""'))) for line in lines)


def python(name, file, rest, with_python=NEW, part=1, repeats=2):
    return Row(name, count_lines(file), "true", f"{with_python} {HERE}/{file} {{transient}} {{kept}} {rest}", part, repeats)


def odeint(name, file, optimise, stepper, steps):
    return Row(name, count_lines(f"{file}.cpp"), CPP.format(optimise, stepper, HERE / file),
               f"./odeint {{transient}} {{kept}} {steps}")


def furiko(name, flags, rest):
    return Row(name, count_lines("furiko.f90"), f"gfortran {flags} -fopenmp library.F90 {HERE}/furiko.f90 -o furiko",
               f"./furiko {{transient}} {{kept}} {rest}")


COMMAND = Row("`furiko driven bifurcation`, order 8, 96 steps", 1, "true",
              f"./program driven bifurcation --vary drive --from {FIRST} --to {LAST} --points {MEMBERS} --angle -90 "
              "--transient {transient} --periods {kept} --format csv")
ORDER8 = furiko("furiko: order 8, 96 steps", "-O3 -march=native", "96 order8")
ROWS = [
    python("SciPy, one after another: DOP853, tolerance 1e-9", "scipy_one.py", "1e-9", part=PART, repeats=1),
    python("SciPy, all as one system: DOP853, tolerance 1e-9", "scipy_all.py", "1e-9"),
    python("numba, plain: RK4, 256 steps", "numba_plain.py", "256 exact"),
    python("the same, fastmath", "numba_plain.py", "256 fast"),
    python("numba 0.60 with SVML, blocks: RK4, 256 steps", "numba_blocks.py", "256 exact", SVML),
    python("the same, fastmath", "numba_blocks.py", "256 fast", SVML),
    python("the same, fastmath: order 8, 96 steps", "numba_order8.py", "96 fast", SVML),
    odeint("odeint, one after another: RK4, 256 steps", "odeint_one", "-O3", "runge_kutta4<state>()", 256),
    odeint("the same: Fehlberg 7(8), 64 steps", "odeint_one", "-O3", "runge_kutta_fehlberg78<state>()", 64),
    odeint("the same: Dormand-Prince 5(4), tolerance 1e-9", "odeint_one", "-O3",
           "make_controlled(1e-9, 1e-9, runge_kutta_dopri5<state>())", 1),
    odeint("odeint, blocks, -Ofast: RK4, 256 steps", "odeint_blocks", "-Ofast", "runge_kutta4<state>", 256),
    odeint("the same: Fehlberg 7(8), 64 steps", "odeint_blocks", "-Ofast", "runge_kutta_fehlberg78<state>", 64),
    furiko("furiko: RK4, 256 steps", "-O3 -march=native", "256 rk4"),
    furiko("furiko: order 8, 32 steps", "-O3 -march=native", "32 order8"),
    ORDER8,
    furiko("the same for any x86-64", "-O2", "96 order8"),
    COMMAND,
]


def numbers(lines):
    """Angle and rate of each row of text or CSV"""
    rows = (line.replace(",", " ").split() for line in lines)
    return [(float(row[1]), float(row[2])) for row in rows if row[0] != "drive"]


def run(row, drives, transient=TRANSIENT, kept=KEPT, threads=1, wait=600):
    """Points (angle, rate) of each member, seconds of the computation and of all"""
    command = shlex.split(row.run.format(transient=transient, kept=kept))
    environment = {**os.environ, **{name: str(threads) for name in ("OMP_NUM_THREADS", "NUMBA_NUM_THREADS", "THREADS")}}
    with tempfile.TemporaryFile("w+") as asked, tempfile.TemporaryFile("w+") as said, tempfile.TemporaryFile("w+") as told:
        asked.write("\n".join(map(repr, drives)))
        asked.seek(0)
        start = time.perf_counter()
        process = subprocess.run(["timeout", str(wait), *command], stdin=asked, stdout=said, stderr=told, cwd=FOLDER,
                                 env=environment)
        wall = time.perf_counter() - start
        said.seek(0)
        told.seek(0)
        if process.returncode != 0:
            raise subprocess.CalledProcessError(process.returncode, row.name, stderr=told.read())
        rows = numbers(said)
        points = [rows[i:i + kept] for i in range(0, len(rows), kept)]
        seconds = wall if row is COMMAND else float(told.read().split()[-1])
        return Answer(points, seconds, wall)


def reference(drives, transient, kept, change=0):
    """By reference.cpp, computed once"""
    kept_as = FOLDER / f"reference-{len(drives)}-{transient}-{kept}-{change}"
    if not kept_as.exists():
        text = subprocess.run([FOLDER / "reference", str(transient), str(kept), str(change)], text=True, check=True,
                              input="\n".join(map(repr, drives)), capture_output=True).stdout
        kept_as.write_text(text)
    rows = numbers(kept_as.read_text().splitlines())
    return [rows[i:i + kept] for i in range(0, len(rows), kept)]


def apart(some, others):
    """The largest distance of two lists of points, in angle or rate"""
    return max(max(abs(math.remainder(x[0] - y[0], 2 * math.pi)), abs(x[1] - y[1])) for x, y in zip(some, others))


def apart_most(some, others):
    """The same of many lists of points"""
    return max(map(apart, some, others))


def after_nan(row):
    """What becomes of the others where one member is NaN"""
    drives, bad = DRIVES[:40], 20
    whole = run(row, drives, 3, 3)
    try:
        spoilt = run(row, drives[:bad] + [math.nan] + drives[bad + 1:], 3, 3, wait=10 + 10 * whole.wall)
    except subprocess.CalledProcessError as error:
        return "never ends" if error.returncode == 124 else f"all is lost: {error.stderr.strip().splitlines()[-1]}"
    others = [i for i in range(len(drives)) if i != bad]
    if all(spoilt.points[i] == whole.points[i] for i in others):
        return "the others as without it" if math.isnan(spoilt.points[bad][-1][0]) else "a number; the others as without it"
    if any(math.isnan(x) for i in others for point in spoilt.points[i] for x in point):
        return "all are NaN"
    return f"the others change by {apart([spoilt.points[i][-1] for i in others], [whole.points[i][-1] for i in others]):.0e}"


def powers(x):
    return f"{x:.0e}".replace("e-0", "e-").replace("e+00", "")


def figures(x):
    return f"{x:.3g}" if x < 1000 else f"{x:.0f}"


def times(row):
    """Seconds of all but the computation, and of the computation on one core and on two"""
    start = time.perf_counter()
    subprocess.run(row.compile, shell=True, cwd=FOLDER, check=True)
    compiled = time.perf_counter() - start
    drives = DRIVES[::row.part]
    one, two = (min((run(row, drives, threads=threads) for _ in range(row.repeats)), key=lambda answer: answer.seconds)
                for threads in (1, 2))
    return [figures(compiled + one.wall - one.seconds), figures(one.seconds * row.part),
            "" if row is COMMAND else figures(two.seconds * row.part)]


def digits(row, first, section, forgets):
    """The errors of one period and of the section, and what a NaN does"""
    drives = DRIVES[::row.part]
    period = apart_most(run(row, drives, 0, 1).points, first[::row.part])
    members = [both for *both, forgetful in zip(run(row, drives).points, section[::row.part], forgets[::row.part]) if forgetful]
    return [powers(period), powers(apart_most(*zip(*members))), "" if row is COMMAND else after_nan(row)]


def references(drives):
    """The first point of the section, those after the transient, and which members forget their start"""
    section, changed = (reference(drives, TRANSIENT, KEPT, change) for change in (0, CHANGE))
    return reference(drives, 0, 1), section, [apart(one, other) < CHANGE for one, other in zip(section, changed)]


def check():
    """Whether some members of furiko's program agree with the reference and with the command line"""
    subprocess.run(ORDER8.compile, shell=True, cwd=FOLDER, check=True)
    first, section, forgets = references(DRIVES[::PART])
    for truth, transient, kept, bound in ((first, 0, 1, 2e-12), (section, TRANSIENT, KEPT, 1e-11)):
        points, shown = (run(which, DRIVES, transient, kept).points[::PART] for which in (ORDER8, COMMAND))
        for what, others in (("the reference", truth), ("the command line", shown)):
            error = apart_most(*zip(*(both for *both, forgetful in zip(points, others, forgets) if forgetful)))
            print(f"{sum(forgets)} members, {transient} periods and {kept}: {powers(error)} from {what}")
            if not error < bound:
                sys.exit(f"bench/comparison: more than {powers(bound)}")


def table():
    first, section, forgets = references(DRIVES)
    print(f"{sum(forgets)} of {MEMBERS} members forget a change of their start by {CHANGE:g} rad.\n")
    print("| | lines | ready (s) | one core (s) | two cores (s) | error, one period | error, section | beside a NaN |")
    print("|---|---|---|---|---|---|---|---|")
    for row in ROWS:
        if "svml" in row.run and not (FOLDER / "svml/ready").exists():
            continue
        print("|", " | ".join([row.name, str(row.lines), *times(row), *digits(row, first, section, forgets)]), "|", flush=True)


if __name__ == "__main__":
    check() if sys.argv[2:] == ["--check"] else table()
