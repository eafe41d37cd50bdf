#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Writes the coefficients of furiko_quotients_one.inc.

usage: make_jacobi_coefficients.py [folder]       (needs mpmath; the output depends on this file only)

  rates   2^-4 <= x < 2^4, 2^4 segments an octave, t = x - middle: h = AGM(1, sqrt x) to degree 10, the
          first coefficient in two words, the second in a head of 26 bits and a rest; then the nome of
          the parameter 1 - x, negative beyond x = 1, to degree 8. A bound of h's error is asserted.
  nome    q/y of the parameter y < 2^-4; half_log its ln(16 q/y)/2 = y/4 + 13/128 y^2 + y^3 R(y): R.
  logs    -ln(f)/2 in two words, f in the middle of 2^5 segments of 1 <= f < 2.
  sine    sin z = z + z^3 R(z^2), cos z = 1 - z^2/2 + z^4 R(z^2), |z| <= pi/4.
All polynomials interpolate at Chebyshev nodes.
"""
import pathlib
import sys

import mpmath as mp

from make_complete_coefficients import Interpolation, KINDS, literal, matrix, shifted, vector

mp.mp.prec = 300
DP = KINDS[1]
OCTAVES, SEGMENTS = 4, 16          # below and above 1; in each
RATE, NOME = 10, 8                 # degrees
LOGS = 32                          # logarithms
GOOD = mp.mpf(2)**-64              # relative error allowed to h


def mean(x):
    return mp.agm(1, mp.sqrt(x))


def nome(y):
    """of the parameter y, any below 1"""
    if y < 0:
        return -nome(y/(y - 1))
    return mp.exp(-mp.pi*mean(1 - y)/mean(y)) if y > 0 else mp.mpf(0)


def head(v):
    """the leading 26 bits"""
    e = mp.frexp(v)[1] - 26
    return mp.ldexp(int(mp.ldexp(v, -e)), e)


def literals(values):
    return [literal(DP, v) for v in values]


def row(lo, hi, rate, series):
    c = rate.coefficients(lo, hi, [mean(x) for x in rate.nodes(lo, hi)])
    q = series.coefficients(lo, hi, [nome(1 - x) for x in series.nodes(lo, hi)])
    first, second = DP.round(c[0]), head(c[1])
    # the interpolation, where it is worst, and what rounds on the way
    h, n = (hi - lo)/2, RATE + 1
    worst = max(abs(mp.polyval(c[::-1], h*z) - mean((lo + hi)/2 + h*z))
                for z in [mp.cos(mp.pi*j/n) for j in range(n + 1)])
    rounded = mp.ldexp(4*abs(c[2])*h**2 + 2*abs(c[1])*h*mp.ldexp(1, -26), -53)
    assert worst + rounded < GOOD*c[0], (lo, worst, rounded)
    return literals([first, c[0] - first, second, c[1] - second] + c[2:] + q)


def series(name, degree, hi, f):
    """f on [0, hi], a little more"""
    hi = hi*(1 + mp.ldexp(1, -20))
    line = Interpolation(degree)
    c = line.coefficients(0, hi, [f(x) for x in line.nodes(0, hi)])
    return vector(name, 0, literals(shifted(c, -hi/2)))


def half_log(y):
    return (mp.log(16*nome(y)/y)/2 - y/4 - mp.mpf(13)/128*y**2)/y**3


def logs(i):
    v = -mp.log(1 + (i + mp.mpf(1)/2)/LOGS)/2
    return literals([DP.round(v), v - DP.round(v)])


def write(folder):
    rate, line = Interpolation(RATE), Interpolation(NOME)
    rows = [row(*[mp.ldexp(1 + mp.mpf(s)/SEGMENTS, j) for s in (i, i + 1)], rate, line)
            for j in range(-OCTAVES, OCTAVES) for i in range(SEGMENTS)]
    text = ('! Written by tools/make_jacobi_coefficients.py: do not edit.\n'
            f'   integer, parameter :: octaves = {OCTAVES}, segment_bits = {SEGMENTS.bit_length() - 1}\n'
            + matrix('rates', RATE + NOME + 4, rows, 8)
            + series('nome_ratio', 9, mp.ldexp(1, -OCTAVES), lambda y: nome(y)/y)
            + series('half_log_nome', 8, mp.ldexp(1, -OCTAVES), half_log)
            + f'   integer, parameter :: log_bits = {LOGS.bit_length() - 1}\n'
            + matrix('half_logs', 2, [logs(i) for i in range(LOGS)], 1)
            + series('sine_series', 5, (mp.pi/4)**2, lambda w: (mp.sin(mp.sqrt(w))/mp.sqrt(w) - 1)/w)
            + series('cosine_series', 5, (mp.pi/4)**2, lambda w: (mp.cos(mp.sqrt(w)) - 1 + w/2)/w**2))
    pathlib.Path(folder, 'furiko_jacobi_coefficients_dp.inc').write_text(text)


if __name__ == '__main__':
    write(sys.argv[1] if len(sys.argv) > 1 else pathlib.Path(__file__).parent.parent/'src'/'functions')
