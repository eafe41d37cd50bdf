#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Write the reference values of the tests: python3 test/data/make_references.py

Needs pip install mpmath==1.4.1 python-flint==0.9.0. FLINT computes with balls: a value comes with
a proven bound on its error, and where that is too wide (1 - m, cos(phi) next to a multiple of
pi/2, n = -1e300), the point is computed anew with twice the bits. 42 digits are right, 40 kept.

A row: kind, form of the argument, regime, arguments, then hi and lo of each value. An argument is
a number of its kind, printed so that reading gives it back; a value is hi + lo, hi the number of
the kind next to it and lo the rest, so that a test needs no wider kind to see a hundredth ulp. Where
the value is beyond the largest number, which stands for infinity, both are that number.

    make_references.py              write all files (minutes)
    make_references.py NAME...      write these (complete, table, ...)
    make_references.py --check N    compute every N-th row anew and compare
"""
import gzip
import pathlib
import sys
import zlib

import flint
import mpmath as mp
from flint import arb

import reference_classics
import reference_integrals
import reference_jacobi
import reference_motion
from reference_integrals import KINDS, Dice

HERE = pathlib.Path(__file__).parent
TOPICS = (reference_integrals.TOPICS | reference_jacobi.TOPICS | reference_motion.TOPICS
          | reference_classics.TOPICS)
POINTS = {"real32": 400, "real64": 2000, "real128": 400}  # at least, in each regime of a function
# Of these, a form's share where it is not one over the number of forms.
SHARES = ({"carlson": 1, "agm": 16, "ellips": 6, "ellipj": 9, "ellipj_incomplete": 9, "cel": 4}
          | reference_jacobi.SHARES | reference_motion.SHARES | reference_classics.SHARES)
KEPT = 140  # bits of a value, 42 digits
mp.mp.dps = 150


def proven(topic, regime, form, arguments):
    """The values to KEPT bits and some more, or None where they are not finite real numbers."""
    function = TOPICS[topic][1]
    most = 65536 if topic in reference_jacobi.FAR or regime in ("subnormal", "overflow") else 8192
    for flint.ctx.prec in (256 << n for n in range(9) if 256 << n <= most):
        values = function(form, *map(arb, arguments))
        if all(value.is_finite() and value.rel_accuracy_bits() > KEPT + 20 for value in values):
            return [mp.mpf(tuple(map(int, v.mid().man_exp()))) for v in values]
    return None


def rounded(x, bits):
    with mp.workprec(bits):
        return +x


def exact(x, figures):
    return mp.nstr(x, figures, min_fixed=1, max_fixed=0)


def nearest(x, kind):
    """The number of the kind next to x, which may be subnormal."""
    bits, _, lowest = KINDS[kind]
    if abs(x) >= mp.mpf(2) ** lowest:
        return rounded(x, bits)
    unit = mp.mpf(2) ** (lowest - bits + 1)
    return mp.nint(x / unit) * unit


def huge(kind):
    bits, _, lowest = KINDS[kind]
    return (2 - mp.mpf(2) ** (1 - bits)) * mp.mpf(2) ** (1 - lowest)


def normal(x, kind):
    """Neither overflow nor underflow."""
    bits, _, lowest = KINDS[kind]
    return mp.mpf(2) ** lowest <= abs(x) < (2 - mp.mpf(2) ** -bits) * mp.mpf(2) ** (1 - lowest)


def overflows(x, kind):
    """For certain, whatever the last digits are."""
    return abs(x) > huge(kind) * (1 + mp.mpf(2) ** -18)


def columns(x, kind):
    bits, figures, _ = KINDS[kind]
    if overflows(x, kind):
        return 2 * (exact(mp.sign(x) * huge(kind), figures),)
    hi = nearest(x, kind)
    return exact(hi, figures), exact(rounded(x, KEPT) - hi, max(8, 42 - figures))


def wanted(values, kind, regime):
    """Normal numbers; as said where the regime is about others, and some of these are there."""
    if regime == "subnormal":
        return all(normal(x, kind) or abs(x) < 1 for x in values)
    if regime == "overflow":
        return (all(normal(x, kind) or abs(x) < 1 or overflows(x, kind) for x in values)
                and any(overflows(x, kind) for x in values))
    return all(normal(x, kind) for x in values)


def row(kind, form, regime, arguments, values):
    texts = [kind, form, regime, *(exact(x, KINDS[kind][1]) for x in arguments)]
    for value in values:
        texts += columns(value, kind)
    return " ".join(texts) + "\n"


def rows(topic, kind, regime, form, count):
    _, _, draw, _ = TOPICS[topic]
    dice = Dice(kind, f"{topic} {regime} {form}")
    seen = set()
    while len(seen) < count:
        arguments = tuple(nearest(x, kind) for x in draw(dice, regime, form))
        allowed = (regime in ("subnormal", "overflow") and all(abs(x) <= huge(kind) for x in arguments)
                   or all(x == 0 or normal(x, kind) for x in arguments))
        if arguments in seen or not allowed:
            continue
        values = proven(topic, regime, form, arguments)
        if values and wanted(values, kind, regime):
            yield row(kind, form, regime, arguments, values)
            seen.add(arguments)


def thinning(topic, regime):
    """Rare regimes have a part of the points; not the amplitude of the smallest excess, which takes no
    time."""
    if topic == "amplitude":
        return 1
    part = reference_integrals.RARE.get(regime, 1)
    # each of Carlson's forms has all points of a regime
    return 4 * part if topic == "carlson" and part == 8 else part


def lines(topic):
    families, _, _, regimes = TOPICS[topic]
    yield (f"# families: {families}; python-flint {flint.__version__}, balls, 40 digits;"
           " written by make_references.py\n")
    for kind in KINDS:
        for regime, forms in regimes.items():
            forms = forms.split()
            shares = SHARES.get(topic, len(forms)) * thinning(topic, regime)
            for form in forms:
                yield from rows(topic, kind, regime, form, -(-POINTS[kind] // shares))


def write(topic):
    """The same bytes in every run: no name, no time. "Filtered" suits digits, 7 % off."""
    packer = zlib.compressobj(9, zlib.DEFLATED, 31, 9, zlib.Z_FILTERED)
    text = "".join(lines(topic)).encode("ascii")
    (HERE / f"{topic}.dat.gz").write_bytes(packer.compress(text) + packer.flush())


def check(topic, step):
    """How many of every step-th rows come out otherwise."""
    wrong = 0
    with gzip.open(HERE / f"{topic}.dat.gz", "rt", encoding="ascii") as file:
        stored = file.readlines()[1::step]
    for line in stored:
        kind, form, regime, *texts = line.split()
        _, _, draw, _ = TOPICS[topic]
        count = len(draw(Dice(kind, ""), regime, form))
        arguments = [nearest(mp.mpf(text), kind) for text in texts[:count]]
        values = proven(topic, regime, form, arguments)
        if not values or row(kind, form, regime, arguments, values) != line:
            print("wrong:", topic, line, end="")
            wrong += 1
    print(f"{topic}: {len(stored)} rows computed anew, {wrong} wrong")
    return wrong


def table():
    """T/T_h of every degree, by mpmath."""
    text = (f"# amplitude in degrees, T/T_h; mpmath {mp.__version__}, {mp.mp.dps} digits, 40 kept;"
            " written by make_references.py\n")
    for degrees in range(180):
        ratio = 1 / mp.agm(1, mp.cos(mp.pi * degrees / 360))
        text += f"{degrees} {mp.nstr(ratio, 41, strip_zeros=False)}\n"
    return text


def main(words):
    if words[:1] == ["--check"]:
        wrong = sum(check(topic, int(words[1])) for topic in TOPICS)
        wrong += table() != (HERE / "table.dat").read_text()
        sys.exit(1 if wrong else 0)
    for name in words or [*TOPICS, "table"]:
        if name == "table":
            (HERE / "table.dat").write_text(table())
        else:
            write(name)


if __name__ == "__main__":
    main(sys.argv[1:])
