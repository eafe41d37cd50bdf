#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Write names.dat: every name of the catalogue with arguments and values: python3 test/data/make_names.py

Needs pip install mpmath==1.4.1. Two rows a name, so that a swap of names, of arguments or of forms is
seen; how exact the functions are is not the question here (make_references.py). Names, arguments and
the number of results are read from src/catalogue, the values are mpmath's, by definitions.
"""
import pathlib
import re

import mpmath as mp
from mpmath import ellipe, ellipf, ellipk, ellippi, sqrt

HERE = pathlib.Path(__file__).parent
mp.mp.dps = 60
VALUES = [
    dict(a=1.5, b=0.4, kc=0.55, k=0.6, m=0.3, mc=0.4, alpha=0.7, n=0.35, phi=0.9, u=0.8, q=0.1, K=2.0, ratio=1.2,
         amplitude=1.3, excess=0.25, z=0.55, x=0.45, y=1.7, p=0.85, s=0.75),
    dict(a=0.3, b=2.2, kc=1.4, k=0.8, m=-0.8, mc=1.6, alpha=1.1, n=-0.6, phi=1.2, u=1.1, q=0.3, K=1.75, ratio=2.2,
         amplitude=2.6, excess=1.5, z=-0.65, x=2.4, y=0.35, p=1.3, s=2.3),
]


def sides(m):
    """sn, cn, dn by letters of u with am u = phi, and u, for phi in (0, pi/2)"""
    return lambda phi: {"s": mp.sin(phi), "c": mp.cos(phi), "d": sqrt(1 - m*mp.sin(phi)**2), "n": mp.mpf(1)}


def quotient(letters, phi, m):
    side = sides(m)(phi)
    return side[letters[0]]/side[letters[1]]


def inverse(letters, x, m):
    """By bisection: every quotient is monotone on a quarter period"""
    low, high = mp.mpf(10)**-50, mp.pi/2 - mp.mpf(10)**-50
    falls = quotient(letters, low, m) > quotient(letters, high, m)
    for _ in range(190):
        mid = (low + high)/2
        if (quotient(letters, mid, m) > x) == falls:
            low = mid
        else:
            high = mid
    return ellipf(low, m)


def arc_inverse(s, m):
    """By bisection, within half a turn"""
    low, high = mp.mpf(0), mp.pi
    for _ in range(190):
        mid = (low + high)/2
        if ellipe(mid, m) < s:
            low = mid
        else:
            high = mid
    return low


def amplitude(u, m):
    return mp.asin(mp.ellipfun("sn", u, m=m))


def complement(kk):
    """mc of K, by bisection"""
    low, high = mp.mpf(-60), mp.mpf(5)
    for _ in range(210):
        mid = (low + high)/2
        if ellipk(1 - mp.exp(mid)) > kk:
            low = mid
        else:
            high = mid
    return mp.exp(low)


def parameter(kk):
    return 1 - complement(kk)


def nome(m):
    if m < 0:
        return -nome(m/(m - 1))
    return mp.exp(-mp.pi*ellipk(1 - m)/ellipk(m))


def heuman(phi, m):
    f, e = ellipf(phi, 1 - m), ellipe(phi, 1 - m)
    return 2/mp.pi*(ellipe(m)*f + ellipk(m)*(e - f))


def of_m(family, x, m):
    """Functions that have forms; x are the arguments before the modulus"""
    k, e = ellipk(m), ellipe(m)
    if re.fullmatch("jacobi_[scdn]{2}", family):
        return [quotient(family[-2:], amplitude(*x, m), m)]
    if re.fullmatch("jacobi_arc[scdn]{2}", family):
        return [inverse(family[-2:], *x, m)]
    return {
        "ellipk": lambda: [k],
        "ellipe": lambda: [e],
        "ellipke": lambda: [k, e],
        "ellipb": lambda: [(e - (1 - m)*k)/m],
        "ellipd": lambda: [(k - e)/m],
        "ellips": lambda: [((2 - m)*k - 2*e)/m**2],
        "ellippi": lambda: [ellippi(*x, m)],
        "ellipj": lambda: [(ellippi(*x, m) - k)/x[0]],
        "ellipf": lambda: [ellipf(*x, m)],
        "ellipeinc": lambda: [ellipe(*x, m)],
        "ellipeinc_inverse": lambda: [arc_inverse(*x, m)],
        "ellipdinc": lambda: [(ellipf(*x, m) - ellipe(*x, m))/m],
        "ellippiinc": lambda: [ellippi(*x, m)],
        "ellipjinc": lambda: [(ellippi(*x, m) - ellipf(x[1], m))/x[0]],
        "jacobi": lambda: [mp.ellipfun(name, *x, m=m) for name in ("sn", "cn", "dn")],
        "jacobi_am": lambda: [amplitude(*x, m)],
        "jacobi_epsilon": lambda: [ellipe(amplitude(*x, m), m)],
        "jacobi_zeta": lambda: [ellipe(*x, m) - e/k*ellipf(*x, m)],
        "heuman_lambda": lambda: [heuman(*x, m)],
        "nome": lambda: [nome(m)],
    }[family]()


def bulirsch_cel(kc, p, a, b):
    """By the definition"""
    def integrand(theta):
        c2, s2 = mp.cos(theta)**2, mp.sin(theta)**2
        return (a*c2 + b*s2)/((c2 + p*s2)*sqrt(c2 + kc**2*s2))
    return mp.quad(integrand, mp.linspace(0, mp.pi/2, 9))


def other(name, *x):
    half = mp.pi/2
    if match := re.fullmatch(r"theta(\d)(_prime)?", name):
        return mp.jtheta(int(match[1]), *x, 1 if match[2] else 0)
    return {
        "agm": mp.agm,
        "bulirsch_cel": bulirsch_cel,
        "carlson_rf": mp.elliprf,
        "carlson_rc": mp.elliprc,
        "carlson_rd": mp.elliprd,
        "carlson_rj": mp.elliprj,
        "carlson_rg": mp.elliprg,
        "parameter_from_nome": lambda q: mp.mfrom(q=q),
        "complementary_parameter_from_nome": lambda q: 1 - mp.mfrom(q=q),
        "parameter_from_ellipk": parameter,
        "complementary_parameter_from_ellipk": complement,
        "parameter_from_period_ratio": lambda ratio: parameter(half*ratio),
        "complementary_parameter_from_period_ratio": lambda ratio: complement(half*ratio),
        "period_ratio": lambda a: ellipk(mp.sin(a/2)**2)/half,
        "period_excess": lambda a: ellipk(mp.sin(a/2)**2)/half - 1,
        "amplitude_of_period": lambda ratio: 2*mp.asin(sqrt(parameter(half*ratio))),
        "amplitude_of_excess": lambda excess: 2*mp.asin(sqrt(parameter(half*(1 + excess)))),
        "amplitude_three_terms": lambda excess: 2*mp.asin(sqrt((sqrt(4 + 36*excess) - 2)*4/9)),
        "ellipse_perimeter": lambda a, b: 4*max(a, b)*ellipe(1 - (min(a, b)/max(a, b))**2),
    }[name](*x)


def m_of(form, x):
    return {"k": lambda: x**2, "m": lambda: x, "mc": lambda: 1 - x, "alpha": lambda: mp.sin(x)**2}[form]()


def row(name, symbols, values):
    family, _, form = name.rpartition("_")
    values = dict(values)
    if "carlson" in name:
        values.update(z=abs(values["z"]))
    if "heuman" in name:  # 0 <= m <= 1
        values.update(m=abs(values["m"]), mc=values["mc"]/2)
    if "three_terms" in name:  # excess <= 25/64
        values.update(excess=values["excess"]/5)
    if "_arc" in name:
        m = m_of(form, values[form])
        values["x"] = round(float(quotient(family[-2:], 0.4 + values["k"]/2, m)), 3)
    x = [mp.mpf(values[symbol]) for symbol in symbols]
    results = of_m(family, x[:-1], m_of(form, x[-1])) if symbols[-1] in ("k", "m", "mc", "alpha") else [other(name, *x)]
    texts = [repr(values[symbol]) for symbol in symbols] + [mp.nstr(mp.re(r), 40) for r in results]
    return f"{name} {len(symbols)} {len(results)} {' '.join(texts)}"


catalogue = (HERE / "../../src/catalogue/furiko_catalogue_entries.inc").read_text()
rows = []
for name, symbols in re.findall(r"catalogue_entry\('(\w+)', '([\w ]+)'", catalogue):
    rows += [row(name, symbols.split(), values) for values in VALUES]
(HERE / "names.dat").write_text("# Written by test/data/make_names.py: name, counts of arguments and results, these\n"
                                + "\n".join(rows) + "\n")
