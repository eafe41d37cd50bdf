#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Prints a program in Fortran 77, fixed form, that calls every function of tools/make_f77.py, in DOUBLE PRECISION and in
REAL, on the arguments of test/data/names.dat, and compares with the 40 digits there; check.f does the rest."""
import pathlib
import re
import sys

sys.path.insert(0, str(pathlib.Path(__file__).parents[2] / "tools"))
import make_f77  # noqa: E402


def statement(text):
    """On as many lines as it takes: columns 7 to 72, continued in column 6"""
    while text:
        yield text[:66]
        text = text[66:]


def literal(number, letter):
    digits = f"{float(number):.17g}" if letter == "D" else f"{float(number):.9g}"
    mantissa, _, exponent = digits.partition("e")
    return f"{mantissa if '.' in mantissa else mantissa + '.'}{letter}{exponent or 0}"


def lines():
    rows = {}
    for row in (make_f77.ROOT / "test/data/names.dat").read_text().splitlines():
        if not row.startswith("#"):
            name, count, _, *numbers = row.split()
            rows.setdefault(name, []).append((numbers[:int(count)], numbers[int(count):]))
    for taken in make_f77.functions().values():
        for function in taken:
            for prefix, letter in (("FK", "D"), ("FKS", "E")):
                check = "NEAR" if letter == "D" else "NEARS"
                short = function.short(prefix)
                for arguments, results in rows[function.name]:
                    given = ",".join(literal(number, letter) for number in arguments)
                    wanted = [literal(number, letter) for number in results]
                    if len(results) == 1:
                        yield f"CALL {check}('{short}',{short}({given}),{wanted[0]})"
                    else:
                        out = [f"{letter}R({i + 1})" for i in range(len(results))]
                        yield f"CALL {short}({given},{','.join(out)})"
                        yield from (f"CALL {check}('{short}',{x},{y})" for x, y in zip(out, wanted))


print("      SUBROUTINE NAMES")
print("      INCLUDE 'furiko_f77.inc'")
print("      DOUBLE PRECISION DR(3)\n      REAL ER(3)")
for line in lines():
    for number, part in enumerate(statement(line)):
        print(("      " if number == 0 else "     +") + part)
print("      END")
