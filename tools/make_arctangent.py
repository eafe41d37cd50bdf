#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Write the arctangent's polynomial, src/arithmetic/furiko_arctangent_{sp,dp}.inc.

atan(q) = q + q w p(w), w = q^2, abs(q) <= tan(pi/8), p by Chebyshev interpolation.

usage: make_arctangent.py [FOLDER]
"""
import pathlib
import sys

from mpmath import mp, mpf

mp.dps = 60
FOLDER = pathlib.Path(__file__).resolve().parent.parent / "src" / "arithmetic"
# A little more than tan(pi/8)^2, for the rounding of quotients
LIMIT = mp.tan(mp.pi/8)**2*(1 + mpf(2)**-20)


def quotient(w):
    """(atan(q)/q - 1)/w as a power series"""
    return sum((-1)**(i + 1)*w**i/(2*i + 3) for i in range(90))


def coefficients(count):
    """Interpolate in the zeros of the Chebyshev polynomial; return powers of w, and the error"""
    nodes = [LIMIT*(1 + mp.cos(mp.pi*(2*i + 1)/(2*count)))/2 for i in range(count)]
    matrix = mp.matrix(count, count)
    for i, w in enumerate(nodes):
        for j in range(count):
            matrix[i, j] = w**j
    c = list(mp.lu_solve(matrix, mp.matrix([quotient(w) for w in nodes])))
    error = max(abs((mp.polyval(c[::-1], w) - quotient(w))*w)
                for w in (LIMIT*i/500 for i in range(1, 501)))
    return c, error


def number(x, digits):
    """A literal"""
    return mp.nstr(x, digits, min_fixed=-1, max_fixed=1).replace("e+0", "") + "_wp"


def main():
    folder = pathlib.Path(sys.argv[1]) if len(sys.argv) > 1 else FOLDER
    for kind, count, digits in (("sp", 5, 12), ("dp", 11, 21)):
        c, error = coefficients(count)
        print(kind, "error", mp.nstr(error, 3), "of the angle", file=sys.stderr)
        text = ["   !> (atan(q)/q - 1)/w, w = q^2, abs(q) <= tan(pi/8), written by make_arctangent.py",
                "   elemental function arctangent_quotient(w) result(p)",
                "      real(wp), intent(in) :: w",
                "      real(wp) :: p", "",
                "      p = " + " + w*( &\n         ".join(number(x, digits) for x in c)
                + ")"*(count - 1),
                "   end function arctangent_quotient"]
        (folder/f"furiko_arctangent_{kind}.inc").write_text("\n".join(text) + "\n")


if __name__ == "__main__":
    main()
