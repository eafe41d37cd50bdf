#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Powers of ten in two words, by exact fractions: writes app/furiko_cli_powers_of_ten.inc, or into
the folder that is named."""
import pathlib
import sys
from fractions import Fraction

STEP, MOST = 27, 13


def words(x):
    hi = float(x)
    return hi, float(x - Fraction(hi))


def table(name, bounds, about, rows):
    """Lines of a Fortran array of word pairs"""
    lines = [f"   !> {about}", f"   type(words), parameter :: {name}({bounds}) = [ &"]
    lines += [f"      words({hi!r}_dp, {lo!r}_dp), &" for hi, lo in rows]
    return lines[:-1] + [lines[-1].replace("), &", ")]")]


def scaled_powers():
    """10**(STEP i) over the power of two below it, in words; and the exponents of those"""
    coarse, exponents = [], []
    for i in range(-MOST, MOST + 1):
        x = Fraction(10) ** (STEP * i)
        exponent = x.numerator.bit_length() - x.denominator.bit_length()
        exponent -= x < Fraction(2) ** exponent
        coarse.append(words(x / Fraction(2) ** exponent))
        exponents.append(exponent)
    return coarse, exponents


def main():
    folder = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else pathlib.Path(__file__).parent.parent / "app")
    coarse, exponents = scaled_powers()
    lines = ["   ! written by tools/make_powers_of_ten.py"]
    lines += table("fine", f"0:{STEP - 1}", "10**j, exactly", [words(Fraction(10) ** j) for j in range(STEP)])
    lines += ["", ""]
    lines += table("coarse", f"-{MOST}:{MOST}", f"10**({STEP}*i) over 2**binary(i), to 2**-107", coarse)
    lines += [f"   integer, parameter :: binary(-{MOST}:{MOST}) = [ &"]
    rows = [", ".join(map(str, exponents[i:i + 9])) for i in range(0, len(exponents), 9)]
    lines += [f"      {row}, &" for row in rows[:-1]] + [f"      {rows[-1]}]"]
    (folder / "furiko_cli_powers_of_ten.inc").write_text("\n".join(lines) + "\n", encoding="ascii")


if __name__ == "__main__":
    main()
