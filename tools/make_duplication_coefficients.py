#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Write the coefficients of one duplication at a time, in src/integrals: furiko_{rf,rj}_series.inc, the series of
R_F and R_J about equal arguments, exact; furiko_rc_{series,wide}_{sp,dp}.inc, R_C by interpolation; and
furiko_quarter_sine_{sp,dp}.inc in src/arithmetic, minimax polynomials.

R_F(A(1-X), A(1-Y), A(1-Z)), X+Y+Z = 0, is A^(-1/2) times the sum over (a, b) of fab E2^a E3^b with
fab = C(-1/2, a+b) C(a+b, b) (-1)^b/(2N+1), N = 2a+3b; R_J likewise with E2..E5 and 3/(2N+3)
(Carlson 1995; DLMF 19.19.7).

usage: make_duplication_coefficients.py [FOLDER]      (needs mpmath)
"""
import itertools
import math
import pathlib
import sys
from fractions import Fraction

from mpmath import mp, mpf

mp.dps = 60
SRC = pathlib.Path(__file__).resolve().parent.parent / "src"
ORDER_RF, ORDER_RJ = 15, 9
# A little more than (pi/4)^2, for the rounding of the quarters
LIMIT = (mp.pi/4)**2*(1 + mpf(2)**-12)
# A little more than 3 - sqrt(8)
BOUND = mpf("0.172")


def half_choose(k):
    """The binomial coefficient of -1/2 over k"""
    value = Fraction(1)
    for i in range(k):
        value *= (Fraction(-1, 2) - i)/(i + 1)
    return value


def series(letter, order, count, top):
    """Lines of parameters letter//exponents for all products of E2..E(count+1) up to the order"""
    lines = []
    for powers in itertools.product(range(order//2 + 1), repeat=count):
        n = sum((i + 2)*p for i, p in enumerate(powers))
        if not 0 < n <= order:
            continue
        k = sum(powers)
        value = half_choose(k)*math.factorial(k)*(-1)**sum(powers[1::2])*Fraction(top, 2*n + top)
        for p in powers:
            value /= math.factorial(p)
        name = letter + "".join(map(str, powers))
        lines.append(f"      real(wp), parameter :: {name} = {value.numerator}.0_wp/{value.denominator}.0_wp")
    return lines


def minimax(f, weight, count):
    """Remez: the polynomial of so many coefficients with the least largest weight*error up to LIMIT"""
    x = [LIMIT*(1 - mp.cos(mp.pi*i/count))/2 for i in range(count + 1)]
    grid = [LIMIT*(1 - mp.cos(mp.pi*i/(40*count)))/2 for i in range(40*count + 1)]
    for _ in range(12):
        matrix = mp.matrix(count + 1, count + 1)
        for i, w in enumerate(x):
            for j in range(count):
                matrix[i, j] = w**j
            matrix[i, count] = (-1)**i/weight(w)
        c = list(mp.lu_solve(matrix, mp.matrix([f(w) for w in x])))[:count]
        error = [weight(w)*(f(w) - mp.polyval(c[::-1], w)) for w in grid]
        tops = []
        for w, e in zip(grid, error):
            if tops and (tops[-1][1] > 0) == (e > 0):
                tops[-1] = max(tops[-1], (w, e), key=lambda top: abs(top[1]))
            else:
                tops.append((w, e))
        while len(tops) > count + 1:
            tops.remove(min(tops[0], tops[-1], key=lambda top: abs(top[1])))
        if len(tops) < count + 1:
            break
        x = [w for w, _ in tops]
    return c, max(abs(e) for e in error)


def quotient(first):
    """sum (-1)^k w^k/(2k + first)!"""
    return lambda w: sum((-w)**k/mp.factorial(2*k + first) for k in range(24))


def estrin(c):
    """p(w) in pairs, with w2 = w^2"""
    pairs = [f"({a} + w*({b}))" if b else f"({a})" for a, b in itertools.zip_longest(c[::2], c[1::2])]
    return " &\n         + w2*(".join(pairs) + ")"*(len(pairs) - 1)


def sine_and_cosine(kind, count, digits):
    """Functions p and q: sin r = r - r w p, cos r = 1 - w/2 + w^2 q, w = r^2"""
    lines = []
    for name, formula, first, power in (("sine", "(1 - sin(r)/r)/w", 3, 1),
                                        ("cosine", "(cos(r) - 1 + w/2)/w^2", 4, 2)):
        c, error = minimax(quotient(first), lambda w, n=power: (w + mpf(10)**-9)**n, count)
        print(kind, name, "error", mp.nstr(error, 3), file=sys.stderr)
        lines += [f"   !> {formula}, w = r^2, w2 = w^2, |r| <= pi/4",
                  f"   elemental function {name}_quotient(w, w2) result(p)",
                  "      real(wp), intent(in) :: w, w2",
                  "      real(wp) :: p",
                  "      p = " + estrin([mp.nstr(x, digits) + "_wp" for x in c]),
                  f"   end function {name}_quotient", "", ""]
    return lines[:-2]


def inverse_tangent(count, digits):
    """Lines: (R_C - 1)/v where R_C = 1 + v/3 + v^2/5 + ..., |v| <= BOUND, by Chebyshev interpolation"""
    nodes = [BOUND*mp.cos(mp.pi*(2*i + 1)/(2*count)) for i in range(count)]
    matrix = mp.matrix(count, count)
    for i, v in enumerate(nodes):
        for j in range(count):
            matrix[i, j] = v**j
    f = lambda v: sum(v**k/(2*k + 3) for k in range(90))
    c = list(mp.lu_solve(matrix, mp.matrix([f(v) for v in nodes])))
    error = max(abs(v*(mp.polyval(c[::-1], v) - f(v))) for v in (BOUND*i/300 for i in range(-300, 301)))
    print("atanh", count, "error", mp.nstr(error, 3), file=sys.stderr)
    return ["   !> (atanh(q)/q - 1)/w, w = q^2, w2 = w^2, |w| <= 0.172",
            "   elemental function inverse_tangent_quotient(w, w2) result(p)",
            "      real(wp), intent(in) :: w, w2",
            "      real(wp) :: p",
            "      p = " + estrin([mp.nstr(x, digits) + "_wp" for x in c]),
            "   end function inverse_tangent_quotient"]


def wide(count, digits):
    """Lines: R_C(1, 1 + a) - 1, a row for a >= 0 in powers of a - 1/2, one for a < 0 in those of a + 1/4, by
    Chebyshev interpolation"""
    f = lambda a: (mp.atan(mp.sqrt(a))/mp.sqrt(a) if a > 0 else mp.atanh(mp.sqrt(-a))/mp.sqrt(-a)) - 1
    numbers = []
    for centre, half in ((mpf(1)/2, mpf(1)/2), (-mpf(1)/4, mpf(1)/4)):
        nodes = [half*mp.cos(mp.pi*(2*i + 1)/(2*count)) for i in range(count)]
        matrix = mp.matrix(count, count)
        for i, b in enumerate(nodes):
            for j in range(count):
                matrix[i, j] = b**j
        c = list(mp.lu_solve(matrix, mp.matrix([f(centre + b) for b in nodes])))
        error = max(abs(mp.polyval(c[::-1], b) - f(centre + b)) for b in (half*(i + mpf(1)/3)/300
                                                                         for i in range(-300, 300)))
        print("R_C", count, "error", mp.nstr(error, 3), file=sys.stderr)
        numbers += [mp.nstr(x, digits) + "_wp" for x in c]
    heads = [numbers[0], numbers[count]]
    rest = numbers[1:count] + numbers[count + 1:]
    width = 2 if digits > 15 else 4
    rows = ", &\n         ".join(", ".join(rest[i:i + width]) for i in range(0, len(rest), width))
    return ["   !> R_C(1, 1 + a) - 1, -1/2 <= a <= 1: a polynomial for either sign, about the middle of its",
            "   !> range, four powers side by side",
            "   elemental function rc_excess(a) result(f)",
            "      real(wp), intent(in) :: a",
            "      real(wp) :: f",
            f"      real(wp), parameter :: c(4, {count//4}, 0:1) = reshape([ &",
            f"         {rows}], [4, {count//4}, 2])",
            f"      real(wp), parameter :: c0(0:1) = [{heads[0]}, {heads[1]}]",
            "      real(wp), parameter :: middle(0:1) = [0.5_wp, -0.25_wp]",
            "      real(wp) :: b, b4, p(4)",
            "      integer :: i, k",
            "      i = merge(1, 0, a < 0.0_wp)",
            "      b = a - middle(i)",
            "      b4 = (b*b)*(b*b)",
            f"      p = c(:, {count//4}, i)",
            f"      do k = {count//4 - 1}, 1, -1",
            "         p = c(:, k, i) + b4*p",
            "      end do",
            "      f = c0(i) + b*((p(1) + b*p(2)) + (b*b)*(p(3) + b*p(4)))",
            "   end function rc_excess"]


def main():
    note = "   ! Written by tools/make_duplication_coefficients.py: do not edit."
    files = {"furiko_rf_series.inc": ["      ! fab: of E2^a E3^b"] + series("f", ORDER_RF, 2, 1),
             "furiko_rj_series.inc": ["      ! jabcd: of E2^a E3^b E4^c E5^d"] + series("j", ORDER_RJ, 4, 3),
             "furiko_rc_series_sp.inc": inverse_tangent(7, 12),
             "furiko_rc_series_dp.inc": inverse_tangent(15, 21),
             "furiko_rc_wide_sp.inc": wide(13, 12),
             "furiko_rc_wide_dp.inc": wide(21, 21),
             "furiko_quarter_sine_sp.inc": sine_and_cosine("sp", 3, 12),
             "furiko_quarter_sine_dp.inc": sine_and_cosine("dp", 6, 21)}
    for name, lines in files.items():
        room = SRC / ("arithmetic" if "sine" in name else "integrals")
        folder = pathlib.Path(sys.argv[1]) if len(sys.argv) > 1 else room
        (folder/name).write_text("\n".join([note] + lines) + "\n")


if __name__ == "__main__":
    main()
