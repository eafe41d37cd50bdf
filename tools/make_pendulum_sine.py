#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Write the sine of the pendulum's steps, src/integrators/furiko_pendulum_{sine,pi}_{sp,dp}.inc, and the
cosine of the driven pendulum's tangents, src/driven/furiko_driven_cosine_dp.inc.

sin(r) = r + r w p(w), cos(r) = 1 + w q(w), w = r^2, abs(r) <= pi/2 + 1/4, p, q by Chebyshev
interpolation; and pi in two parts, the first one short enough that n times it is exact for n < 2^20 (real64), 2^8 (real32).

usage: make_pendulum_sine.py [FOLDER]
"""
import pathlib
import sys

from mpmath import mp, mpf

mp.dps = 60
SOURCES = pathlib.Path(__file__).resolve().parent.parent / "src"
LIMIT = (mp.pi/2 + mpf(1)/4)**2


def sine_quotient(w):
    """(sin(r)/r - 1)/w as a power series"""
    return sum((-1)**(i + 1)*w**i/mp.factorial(2*i + 3) for i in range(25))


def cosine_quotient(w):
    """(cos(r) - 1)/w as a power series"""
    return sum((-1)**(i + 1)*w**i/mp.factorial(2*i + 2) for i in range(25))


def coefficients(quotient, count):
    """Interpolate in the zeros of the Chebyshev polynomial; return powers of w, and the error"""
    nodes = [LIMIT*(1 + mp.cos(mp.pi*(2*i + 1)/(2*count)))/2 for i in range(count)]
    matrix = mp.matrix(count, count)
    for i, w in enumerate(nodes):
        for j in range(count):
            matrix[i, j] = w**j
    c = list(mp.lu_solve(matrix, mp.matrix([quotient(w) for w in nodes])))
    error = max(abs((mp.polyval(c[::-1], w) - quotient(w))*w**1.5)
                for w in (LIMIT*i/2000 for i in range(1, 2001)))
    return c, error


def parts_of_pi(bits):
    """pi in two parts, the first one of `bits` bits"""
    unit = mpf(2)**(2 - bits)
    first = mp.floor(mp.pi/unit)*unit
    return [first, mp.pi - first]


def number(x, digits):
    """A literal"""
    return mp.nstr(x, digits, min_fixed=-1, max_fixed=1).replace("e+0", "") + "_wp"


def polynomial(name, meaning, c, digits):
    """The text of a function of w with these coefficients"""
    return [f"   !> {meaning}, w = r^2, abs(r) <= pi/2 + 1/4, written by make_pendulum_sine.py",
            f"   elemental function {name}(w) result(p)",
            "      real(wp), intent(in) :: w",
            "      real(wp) :: p", "",
            "      p = " + " + w*( &\n         ".join(number(x, digits) for x in c) + ")"*(len(c) - 1),
            f"   end function {name}"]


def main():
    def write(name, lines, home="integrators"):
        folder = pathlib.Path(sys.argv[1]) if len(sys.argv) > 1 else SOURCES / home
        (folder/name).write_text("\n".join(lines) + "\n")

    for kind, count, bits, digits in (("sp", 5, 16, 12), ("dp", 8, 33, 21)):
        c, error = coefficients(sine_quotient, count)
        print(kind, "error", mp.nstr(error, 3), file=sys.stderr)
        write(f"furiko_pendulum_pi_{kind}.inc",
              ["   ! pi in parts, written by make_pendulum_sine.py",
               "   real(wp), parameter :: pi(2) = [ &",
               ", &\n".join("      " + number(x, 30) for x in parts_of_pi(bits)) + "]"])
        write(f"furiko_pendulum_sine_{kind}.inc",
              polynomial("sine_quotient", "(sin(r)/r - 1)/w", c, digits))
    c, error = coefficients(cosine_quotient, 9)
    print("cosine error", mp.nstr(error, 3), file=sys.stderr)
    write("furiko_driven_cosine_dp.inc", polynomial("cosine_quotient", "(cos(r) - 1)/w", c, 21), "driven")


if __name__ == "__main__":
    main()
