#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Writes the coefficients of furiko_complete_segments.inc, one file each for real32 and real64.

usage: make_complete_coefficients.py [folder]       (needs mpmath; the output depends on this file only)

Those of the real32 kernel are real64 numbers: it computes in real64, and rounds once.
With x = mc, A = ln 4 + |ln x|/2, and 2^5 segments in each octave of x (2^4 for real32):
  near  2^-10 <= x < 2^6: f(x) = c0 + t (c1 + t (c2 + ...)), t = x - centre, one row per segment.
        The centre is chosen close to the middle, such that c0 and c1 happen to be machine numbers
        to a few more bits (Gal and Bachelis, ACM TOMS 17 (1991) 26-45); 1 - centre is one, too.
        For real32 it is the middle.
        A bound of the error, for every x and not for samples, is asserted for every row.
  far   K = A + x (A S - T),  D = A - 1 + x (A S - T),
        E = 1 + x (A/2 - 1/4 + x (A S - T)),  B = 1 + x (3/4 - A/2 + x (A S - T)), x < 2^-6:
        S and T polynomials in x (DLMF 19.12.1, 19.12.2); above 2^6 through 1/x.
        For real32 E = 1 + x (A S - T), B = 1 + x (A S - T).
  sine  sin(b)^2 = v - v^2/3 + v^3 R(v), v = b^2, abs(b) <= pi/4.
  log   ln(f)/2 = (f - 1)/2 - s ((f - 1)/2 - s^2 R(s^2)), s = (f - 1)/(f + 1), 1/2 <= f^2 <= 2.
All polynomials interpolate at Chebyshev nodes.
"""
import pathlib
import sys

import mpmath as mp

mp.mp.prec = 400
BELOW, ABOVE = 10, 6               # octaves below and above 1
GOOD = mp.mpf(2)**-8               # ulps of error of c0 + h c1 that end the search
FIRST = {'e': (0.5, 0.25), 'b': (-0.5, -0.75)}  # terms of A S - T of E and B that stand apart for real64


class Kind:
    """segments in an octave; centres tried for a row, at most; ulps of error allowed to a row, beyond
    the last rounding; the bits a high coefficient may lack; degrees; the grid of split numbers"""
    digits = 53

    def __init__(self, name, segments, trials, ulps, spare, near, far, log, sine, grid):
        self.name, self.segments, self.trials, self.ulps, self.spare = name, segments, trials, ulps, spare
        self.near, self.far, self.log, self.sine, self.grid = near, far, log, sine, grid

    def round(self, v):
        """the nearest number of this kind (exponent range ignored)"""
        if v == 0:
            return mp.mpf(0)
        e = mp.frexp(v)[1] - self.digits
        return mp.ldexp(mp.nint(mp.ldexp(v, -e)), e)


KINDS = [Kind('sp', 16, 1, 700, -4, 6, 4, 5, 6, None), Kind('dp', 32, 1024, 0.035, 13, 8, 6, 6, 6, 42)]


def ke(x):
    """K and E of mc = x by the arithmetic-geometric mean (DLMF 19.8.1, 19.8.6)"""
    a, b, s, p = mp.mpf(1), mp.sqrt(x), (1 - x)/2, mp.mpf(1)/2
    while abs(a - b) > mp.ldexp(a, -210):
        a, b, c = (a + b)/2, mp.sqrt(a*b), (a - b)/2
        p *= 2
        s += p*c*c
    k = mp.pi/(a + b)
    return k, k*(1 - s)


def integrals(x):
    k, e = ke(x)
    return {'k': k, 'e': e, 'b': (e - x*k)/(1 - x), 'd': (k - e)/(1 - x)}


def smooth(x):
    """S and T of the four far forms"""
    k1, e1 = ke(1 - x)             # of the complementary parameter
    a = mp.log(4) - mp.log(x)/2
    sk, se = 2/mp.pi*k1, 2/mp.pi*(k1 - e1)
    sb = (se - x*sk)/(1 - x)
    f = integrals(x)
    s = {'k': (sk - 1)/x, 'd': (sk - sb - 1)/x,
         'e': (se - x/2)/x**2, 'b': (sb + x/2)/x**2}
    t = {'k': a*s['k'] - (f['k'] - a)/x, 'd': a*s['d'] - (f['d'] - a + 1)/x,
         'e': a*s['e'] - (f['e'] - 1 - x*(a/2 - 0.25))/x**2,
         'b': a*s['b'] - (f['b'] - 1 - x*(0.75 - a/2))/x**2}
    return s, t


class Interpolation:
    """monomial coefficients about the middle of an interval, from values at the Chebyshev nodes"""
    def __init__(self, degree):
        n = degree + 1
        self.z = [mp.cos(mp.pi*(2*i + 1)/(2*n)) for i in range(n)]
        self.inverse = mp.matrix([[z**j for j in range(n)] for z in self.z])**-1

    def nodes(self, lo, hi):
        return [(lo + hi)/2 + (hi - lo)/2*z for z in self.z]

    def coefficients(self, lo, hi, values):
        c = self.inverse*mp.matrix(values)
        return [c[j]/((hi - lo)/2)**j for j in range(len(values))]


def shifted(c, d):
    """coefficients about a centre moved by d"""
    n = len(c)
    return [sum(mp.binomial(i, j)*c[i]*d**(i - j) for i in range(j, n)) for j in range(n)]


def row(kind, lo, hi, c):
    """centre and coefficients of one segment"""
    mid, h = (lo + hi)/2, (hi - lo)/2
    exponent = mp.frexp(mid)[1]
    step = mp.ldexp(int(mp.ldexp(1, max(6, kind.digits - 30) + min(exponent, 0))) | 1,
                    max(exponent, 0) - kind.digits)
    good = mp.ldexp(GOOD, mp.frexp(c[0])[1] - kind.digits)
    best, where = mp.inf, 0
    for i in range(min(kind.trials, int(h/step))):
        d = ((i + 1)//2 if i % 2 else -i//2)*step  # from the middle outwards
        c0, c1 = c[0] + d*(c[1] + d*(c[2] + d*c[3])), c[1] + d*(2*c[2] + 3*d*c[3])
        bad = abs(c0 - kind.round(c0)) + h*abs(c1 - kind.round(c1))
        if bad < best:
            best, where = bad, d
        if best < good:
            break
    c = shifted(c, where)
    return mid + where, c, [mp.ldexp(c[0], -kind.digits - kind.spare)/h**j for j in range(len(c))]


def error_bound(kind, row, centre, c, lo, hi, next_c):
    """ulps of error of c0 + t (c1 + ...), as the numbers in `row`, before the last rounding

    Truncation: f' of K, E, B, D is, but for its sign, completely monotone in x, so the largest
    f^(n+1)/(n+1)! is that at lo, below `next_c`, the divided difference of points below lo;
    Chebyshev nodes make it h^(n+1)/2^n in t. Rounding of the coefficients. Rounding of the sum:
    c_j t^j meets at most 3 j + 1 operations, that of t included.
    """
    h, n = (hi - lo)/2, kind.near
    reach = h + abs(centre - (lo + hi)/2)
    truncation = abs(next_c)*h**(n + 1)/2**n
    stored = sum(abs(kind.round(mp.mpf(s[:-3])) - a)*reach**j
                 for j, (s, a) in enumerate(zip(row[1:], c)))
    summed = sum((3*j + 1)*abs(c[j])*reach**j for j in range(1, n + 1))
    least = min(mp.polyval(c[::-1], x - centre) for x in (lo, hi))
    return (truncation + stored + mp.ldexp(summed, -kind.digits)) \
        / mp.ldexp(1, mp.frexp(least)[1] - kind.digits)


def literal(kind, v, enough=None):
    """shortest decimal that still gives the machine number, or is right to `enough`"""
    v = kind.round(v)
    if v == 0:
        return '0.0_wp'
    for n in range(2, 19):
        s = mp.nstr(v, n, min_fixed=-3, max_fixed=4).replace('+', '')
        back = kind.round(mp.mpf(s))
        if back == v or (enough is not None and abs(mp.mpf(s) - v) < enough):
            break
    if '.' not in s:
        s = s.replace('e', '.0e') if 'e' in s else s + '.0'
    return s + '_wp'


def wrapped(items):
    lines, line = [], '     '
    for i, s in enumerate(items):
        s += ',' if i < len(items) - 1 else ''
        if len(line) + len(s) > 96:
            lines.append(line + ' &')
            line = '     '
        line += ' ' + s
    return '\n'.join(lines + [line])


def vector(name, lower, items):
    return (f'   real(wp), parameter :: {name}({lower}:{lower + len(items) - 1}) = [ &\n'
            + wrapped(items) + ']\n')


def matrix(name, n, columns, parts):
    """in parts, for the standard allows 255 continuation lines only; variables that nobody can change, since
    gfortran would keep the parts of a parameter beside it, a second copy"""
    text, size = f'   real(wp), save, protected :: {name}(0:{n - 1}, 0:{len(columns) - 1})\n', len(columns)//parts
    for first in range(0, len(columns), size):
        items = [s for column in columns[first:first + size] for s in column]
        text += f'   data {name}(:, {first}:{first + size - 1}) / &\n' + wrapped(items) + '/\n'
    return text


def split(kind, v):
    """v whole, or in two parts whose first has its last digit on the grid"""
    if kind.grid is None:
        return [('', v)]
    hi = mp.ldexp(mp.nint(mp.ldexp(v, kind.grid)), -kind.grid)
    return [('_hi', hi), ('_lo', v - hi)]


def write(kind, folder):
    out = ['! Written by tools/make_complete_coefficients.py: do not edit.\n',
           f'   integer, parameter :: octaves_below = {BELOW}, octaves_above = {ABOVE}\n',
           f'   integer, parameter :: segment_bits = {kind.segments.bit_length() - 1}\n',
           f'   integer, parameter :: near_degree = {kind.near}\n']
    near, beyond = Interpolation(kind.near), Interpolation(kind.near + 1)
    rows = {f: [] for f in 'kebd'}
    for j in range(-BELOW, ABOVE):
        for i in range(kind.segments):
            lo, hi = [mp.ldexp(1 + mp.mpf(s)/kind.segments, j) for s in (i, i + 1)]
            below = lo - (hi - lo)/32
            values = [integrals(x) for x in near.nodes(lo, hi)]
            values_below = [integrals(x) for x in beyond.nodes(below, lo)]
            for f in 'kebd':
                next_c = beyond.coefficients(below, lo, [v[f] for v in values_below])[-1]
                c = near.coefficients(lo, hi, [v[f] for v in values])
                centre, c, enough = row(kind, lo, hi, c)
                rows[f].append([literal(kind, centre)]
                               + [literal(kind, a, None if n < 2 else e)
                                  for n, (a, e) in enumerate(zip(c, enough))])
                assert error_bound(kind, rows[f][-1], centre, c, lo, hi, next_c) < kind.ulps
    for f in 'kebd':
        out.append(matrix(f'near_{f}', kind.near + 2, rows[f], 8))
    far = Interpolation(kind.far)
    lo, hi = mp.mpf(0), mp.ldexp(1, -ABOVE)
    smooths = [smooth(x) for x in far.nodes(lo, hi)]
    for f in 'kebd':
        for which, name in enumerate(('s', 't')):
            values = [v[which][f] for v in smooths]
            if kind.grid is None and f in FIRST:
                values = [FIRST[f][which] + x*v for x, v in zip(far.nodes(lo, hi), values)]
            c = shifted(far.coefficients(lo, hi, values), -hi/2)
            out.append(vector(f'far_{f}_{name}', 0, [literal(kind, a) for a in c]))
    series = Interpolation(kind.log)
    h = (mp.sqrt(2) - 1)**4*(1 + mp.ldexp(1, -20))
    c = series.coefficients(0, h, [(mp.atanh(mp.sqrt(w))/mp.sqrt(w) - 1)/w
                                   for w in series.nodes(0, h)])
    out.append(vector('log_series', 0, [literal(kind, a) for a in shifted(c, -h/2)]))
    series = Interpolation(kind.sine)
    h = (mp.pi/4)**2*(1 + mp.ldexp(1, -20))
    c = series.coefficients(0, h, [(mp.sin(mp.sqrt(v))**2 - v + v**2/3)/v**3
                                      for v in series.nodes(0, h)])
    out.append(vector('sine_series', 0, [literal(kind, a) for a in shifted(c, -h/2)]))
    hi = kind.round(mp.pi/2)
    out.append(f'   real(wp), parameter :: half_pi_hi = {literal(kind, hi)}, '
               f'half_pi_lo = {literal(kind, mp.pi/2 - hi)}\n')
    out.append(f'   real(wp), parameter :: root_half = {literal(kind, mp.sqrt(0.5))}\n')
    for name, v in (('ln4', mp.log(4)), ('half_ln2', mp.log(2)/2)):
        for part, u in split(kind, v):
            out.append(f'   real(wp), parameter :: {name}{part} = {literal(kind, u)}\n')
    with open(f'{folder}/furiko_complete_coefficients_{kind.name}.inc', 'w') as file:
        file.write(''.join(out))


if __name__ == '__main__':
    for kind in KINDS:
        write(kind, sys.argv[1] if len(sys.argv) > 1 else pathlib.Path(__file__).parent.parent/'src'/'integrals')
