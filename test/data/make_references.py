#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Write the reference values of the tests: python3 test/data/make_references.py

Needs mpmath (pip install mpmath==1.4.1), which computes with 150 digits; 40 are kept. An argument
is a number of its kind, printed so that reading gives it back; a value is hi + lo, hi the number
of the kind next to it and lo the rest, so that a test needs no wider kind to see a hundredth ulp.
"""
import pathlib
import random

import mpmath as mp

HERE = pathlib.Path(__file__).parent
KINDS = {"real32": (24, 9, -126), "real64": (53, 17, -1022), "real128": (113, 36, -16382)}
mp.mp.dps = 150


def rounded(x, bits):
    with mp.workprec(bits):
        return +x


def exact(x, figures):
    return mp.nstr(x, figures, min_fixed=1, max_fixed=0)


def columns(x, kind):
    bits, figures, _ = KINDS[kind]
    hi = rounded(x, bits)
    return exact(hi, figures), exact(x - hi, max(8, 41 - figures))


def arguments(kind, form):
    """m's regimes in the given form of the argument: (regime, number of the kind)."""
    bits, _, min_exponent = KINDS[kind]
    tiny, huge = mp.mpf(2) ** min_exponent, mp.mpf(2) ** -min_exponent
    rnd = random.Random(f"{kind} {form}")
    uniform = [mp.mpf(rnd.random()) + mp.mpf(rnd.random()) * mp.mpf(2) ** -53 for _ in range(60)]
    small = [mp.mpf(2) ** (min_exponent * u) for u in uniform]
    close = [mp.mpf(2) ** (-bits * u) for u in uniform]
    regimes = {
        "k": [("uniform", uniform), ("small", small), ("next-to-1", [1 - c for c in close]),
              ("negative", [-u for u in uniform[:20]]), ("special", [mp.mpf(0), tiny, mp.mpf("0.5")])],
        "m": [("uniform", uniform), ("small", small), ("next-to-1", [1 - c for c in close]),
              ("negative", [-u / (1 - u) for u in uniform]), ("huge", [-1 / s for s in small]),
              ("small-negative", [-s for s in small]), ("special", [mp.mpf(0), -huge, mp.mpf("0.25")])],
        "mc": [("uniform", uniform), ("small", small), ("next-to-1", [1 - c for c in close]),
               ("above-1", [1 / (1 - u) for u in uniform]), ("huge", [1 / s for s in small]),
               ("special", [mp.mpf(1), tiny, huge])],
    }
    for regime, values in regimes[form]:
        for x in values:
            x = rounded(x, bits)
            if x != 1 or form == "mc":
                yield regime, x


def complementary(form, x):
    return {"k": lambda: (1 - x) * (1 + x), "m": lambda: 1 - x, "mc": lambda: x}[form]()


def complete(mc):
    """K and E: mpmath's own for 0 <= m <= 1/2, Legendre's relation next to 1, DLMF 19.7.2 for m < 0."""
    if mc > 1:
        first, second = complete(1 / mc)
        return first / mp.sqrt(mc), second * mp.sqrt(mc)
    if mc > 0.5:
        return mp.ellipk(1 - mc), mp.ellipe(1 - mc)
    first = mp.pi / 2 / mp.agm(1, mp.sqrt(mc))
    k1, e1 = mp.ellipk(mc), mp.ellipe(mc)
    return first, (mp.pi / 2 + first * (k1 - e1)) / k1


def header(title):
    return (f"# {title}; mpmath {mp.__version__}, {mp.mp.dps} digits, 40 kept;"
            " written by make_references.py\n")


def write_complete():
    with open(HERE / "complete.dat", "w") as file:
        file.write(header("kind form regime x K_hi K_lo E_hi E_lo"))
        for kind in KINDS:
            for form in ("k", "m", "mc"):
                for regime, x in arguments(kind, form):
                    first, second = complete(complementary(form, x))
                    row = [kind, form, regime, exact(x, KINDS[kind][1])]
                    file.write(" ".join(row + [*columns(first, kind), *columns(second, kind)]) + "\n")


def write_table():
    with open(HERE / "table.dat", "w") as file:
        file.write(header("amplitude in degrees, T/T_h"))
        for degrees in range(180):
            ratio = 1 / mp.agm(1, mp.cos(mp.pi * degrees / 360))
            file.write(f"{degrees} {mp.nstr(ratio, 41, strip_zeros=False)}\n")


write_complete()
write_table()
