#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Write special.dat.gz: make_special.py PROGRAM, the path of a `furiko` that is right

Every function of the catalogue at zeros, ones, halves, beyond its domain, at infinity, NaN and far out,
each argument against each, as the program answers in real64 to ten digits. The values are the
library's own, so the file keeps them as they are; what it gives in real128 by other kernels has to
agree before they are kept. That they are right is seen in the other tests.
"""
import gzip
import itertools
import pathlib
import subprocess
import sys

HERE = pathlib.Path(__file__).parent
FAR = str(2**100)  # exact in every kind
GRIDS = {
    1: ["-0.0", "0.0", "0.25", "0.5", "-0.5", "0.75", "1.0", "-1.0", "1.5", "2.0", "-3.0", "4.0", FAR, "-" + FAR,
        "inf", "-inf", "nan", "0.0078125"],
    2: ["-0.0", "0.0", "0.25", "0.5", "-0.5", "1.0", "-1.0", "2.0", "-3.0", FAR, "inf", "nan"],
    3: ["0.0", "0.5", "1.0", "-2.0", "3.0", "inf", "nan"],
    4: ["0.0", "0.5", "2.0", "-2.0", "inf", "nan"],
}


def answers(program, name, rows, kind):
    text = "".join(" ".join(row) + "\n" for row in rows)
    out = subprocess.run([program, "eval", name, "--kind", kind], input=text, capture_output=True, text=True, check=True)
    return [[float(word) for word in line.split()] for line in out.stdout.splitlines()]


def agree(a, b):
    return (a != a and b != b) or a == b or abs(a - b) <= 1e-14*abs(b)


program = sys.argv[1]
listed = subprocess.run([program, "eval", "--list"], capture_output=True, text=True, check=True).stdout
lines, differ = [], 0
for line in listed.splitlines():
    name, symbols, results = line[:41].strip(), line[42:54].split(), line[54:62].split()
    rows = list(itertools.product(GRIDS[len(symbols)], repeat=len(symbols)))
    single, quad = answers(program, name, rows, "real64"), answers(program, name, rows, "real128")
    lines.append(f"{name} {len(symbols)} {len(results)} {len(rows)}")
    for row, x, y in zip(rows, single, quad):
        if not all(map(agree, x, y)):
            differ += 1
            print(name, *row, x, y)
        lines.append(" ".join([*row, *(f"{v:.9e}" for v in x)]).replace("e+00", ""))
data = "\n".join(lines) + "\n"
(HERE / "special.dat.gz").write_bytes(gzip.compress(data.encode(), mtime=0))
print(len(lines), "rows,", differ, "of which real128 has otherwise")
