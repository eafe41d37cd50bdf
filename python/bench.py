# SPDX-License-Identifier: MIT
"""What a call costs, beside scipy.special, as doc/python.md has it: python bench.py. Takes a minute; needs SciPy."""

import platform
import time
import timeit

import numpy as np
import scipy
from scipy import special

import furiko

LENGTHS = 1, 1_000, 1_000_000
# Of furiko, of SciPy, and how large each argument may be
CALLS = [
    ("ellipk_m(m)", "ellipk(m)", {"m": 1.0}),
    ("ellipk_mc(mc)", "ellipkm1(mc)", {"mc": 1.0}),
    ("ellipe_m(m)", "ellipe(m)", {"m": 1.0}),
    ("ellipf_m(phi, m)", "ellipkinc(phi, m)", {"phi": 1.5, "m": 1.0}),
    ("carlson_rf(x, y, z)", "elliprf(x, y, z)", {"x": 2.0, "y": 2.0, "z": 2.0}),
    ("jacobi_m(u, m)", "ellipj(u, m)", {"u": 6.0, "m": 1.0}),
    ("Modulus(m=0.7).jacobi(u)", "ellipj(u, 0.7)", {"u": 6.0}),
]


def seconds(call, names):
    """Of one call: the processor's time, the least of many short runs, for others use the machine, too"""
    timer = timeit.Timer(call, globals=names, timer=time.process_time)
    count = max(1, int(0.002 / min(timer.repeat(3, 1))))
    return min(timer.repeat(200 if count > 1 else 10, count)) / count


def told(time):
    """With a unit, to three figures"""
    for unit, size in (("ns", 1e-9), ("µs", 1e-6), ("ms", 1e-3)):
        if time < 999.5 * size:
            return f"{time / size:.3g} {unit}"
    return f"{time:.3g} s"


def main():
    random = np.random.default_rng(7)
    versions = f"Python {platform.python_version()}, NumPy {np.__version__}, SciPy {scipy.__version__}"
    print(f"{platform.machine()}, {versions}\n")
    print("| furiko | SciPy | a float | | 1,000 | | 1,000,000 | |")
    print("|---|---|---|---|---|---|---|---|")
    for ours, theirs, ranges in CALLS:
        row = [ours, theirs]
        for length in LENGTHS:
            arguments = {name: random.uniform(0, most, length) for name, most in ranges.items()}
            if length == 1:
                arguments = {name: float(array[0]) for name, array in arguments.items()}
            if "Modulus" in ours:
                names = {"call": furiko.Modulus(m=0.7).jacobi, **arguments}
                row.append(told(seconds("call(u)", names)))
            else:
                row.append(told(seconds(ours, {**vars(furiko), **arguments})))
            row.append(told(seconds(theirs, {**vars(special), **arguments})))
        print("| `" + "` | `".join(row[:2]) + "` | " + " | ".join(row[2:]) + " |")


if __name__ == "__main__":
    main()
