# SPDX-License-Identifier: MIT
"""References of the notes' own ways and of ellipses, in the manner of reference_integrals.py."""
import mpmath as mp
from flint import arb

from reference_integrals import (
    ALL, any_modulus, complete, m_and_mc, modulus, negative_modulus, subnormal)


# The functions, on balls.


def whole(x):
    """A number of terms, of subintervals or of a step."""
    return int(x.unique_fmpz())


def series(m, terms):
    """2K/pi and 2E/pi by so many terms: DLMF 19.5.1-2."""
    first, second, term = arb(0), arb(0), arb(1)
    for n in range(terms):
        first += term
        second += -term / (2 * n - 1)
        term *= m * (arb(2 * n + 1) / (2 * n + 2)) ** 2
    return first, second


def trapezoid(mc, count):
    """K and E by the trapezoidal rule."""
    first, second = (1 + 1 / mc.sqrt()) / 2, (1 + mc.sqrt()) / 2
    for i in range(1, count):
        t = i * arb.pi() / (2 * count)
        delta = (t.cos() ** 2 + mc * t.sin() ** 2).sqrt()
        first, second = first + 1 / delta, second + delta
    return first * arb.pi() / (2 * count), second * arb.pi() / (2 * count)


def three_terms(excess):
    """The amplitude whose k^2 solves 9 k^4/64 + k^2/4 = excess."""
    k2 = 8 * excess / (1 + (1 + 9 * excess).sqrt())
    return 2 * k2.sqrt().asin()


def perimeter(a, b):
    """4 a E, a the longer semiaxis."""
    if a < b:
        a, b = b, a
    return 4 * a * complete("mc", (b / a) ** 2)[1]


def classic(form, *arguments):
    """A function by its name."""
    kind, way, *rest = form.split("_")
    which = 0 if kind == "ellipk" else 1
    if form == "amplitude_three_terms":
        return [three_terms(*arguments)]
    if form == "ellipse_perimeter":
        return [perimeter(*arguments)]
    if form == "ellipse_perimeter_series":
        a, b, terms = arguments
        a, b = (b, a) if a < b else (a, b)
        return [2 * arb.pi() * a * series(1 - (b / a) ** 2, whole(terms))[1]]
    if form == "period_ratio_series":
        return [series((arguments[0] / 2).sin() ** 2, whole(arguments[1]))[0]]
    m, mc = m_and_mc(rest[0], arguments[0])
    if way == "series":
        return [arb.pi() / 2 * series(m, whole(arguments[1]))[which]]
    return [trapezoid(mc, whole(arguments[1]))[which]]


def steps(form, x, step):
    """a, b, c, K and E so far: DLMF 19.8.1-6."""
    m, mc = m_and_mc(form, x)
    a, b = arb(1), mc.sqrt()
    c = x if form == "k" else m.sqrt()
    rest = 1 - m / 2
    for n in range(whole(step)):
        a, b = (a + b) / 2, (a * b).sqrt()
        c = c * c / (4 * a)
        rest -= 2**n * c * c
    k = arb.pi() / (2 * a)
    return [a, b, c, k, k * rest]


# The arguments.


def count(dice, regime):
    """Of terms or subintervals: more than none."""
    return mp.mpf(dice.integer(1, 12) if regime != "many" else int(dice.power(3, 8)))


def classic_arguments(dice, regime, form):
    if form == "amplitude_three_terms":  # below 120 degrees
        excess = dice.uniform(0, mp.mpf("0.26")) if regime == "few" else dice.power(dice.lowest / 2, -2)
        return [excess]
    if form.startswith("ellipse_perimeter"):
        a, b = semiaxes(dice, regime)
        return [a, b, count(dice, regime)] if form.endswith("series") else [a, b]
    if form == "period_ratio_series":
        amplitude = dice.pick(dice.uniform(-mp.pi, mp.pi), dice.uniform(-20, 20), dice.power(-40, 0))
        return [amplitude, count(dice, regime)]
    _, way, modulus_form = form.split("_")
    x = modulus(dice, dice.pick("uniform", "uniform", "towards-0", "towards-1"), modulus_form)
    if way == "trapezoid" and modulus_form != "k":
        x = dice.pick(x, any_modulus(dice, modulus_form), negative_modulus(dice, modulus_form))
    elif modulus_form == "m":  # the series, from -1 on
        x = dice.sign() * x
    return [x, count(dice, regime)]


def semiaxes(dice, regime):
    if regime == "subnormal":
        return subnormal(dice), dice.pick(subnormal(dice), dice.uniform())
    if regime == "overflow":
        return dice.power(-dice.lowest - 1, 1 - dice.lowest), dice.huge()
    if regime == "spread":
        return dice.tiny(), dice.huge()
    a = dice.power(-10, 10)
    return a, a * dice.pick(dice.uniform(), dice.power(-dice.bits, 0), 1 + dice.sign() * dice.gap())


def step_arguments(dice, regime, form):
    """As far as c falls quadratically, and where it does not yet."""
    return [modulus(dice, regime, form), mp.mpf(dice.integer(0, 8))]


# The files.

SERIES = "ellipk_series_k ellipk_series_m ellipe_series_k ellipe_series_m period_ratio_series"
RULES = " ".join(f"{kind}_trapezoid_{form}" for kind in ("ellipk", "ellipe") for form in ALL.split())
REST = "amplitude_three_terms ellipse_perimeter_series"
TOPICS = {
    "classics": ("function", classic, classic_arguments, {
        "few": f"{SERIES} {RULES} {REST}", "many": f"{SERIES} {RULES} {REST}",
        "uniform": "ellipse_perimeter", "spread": "ellipse_perimeter", "subnormal": "ellipse_perimeter",
        "overflow": "ellipse_perimeter"}),
    "agm_steps": (
        "agm_steps_a agm_steps_b agm_steps_c agm_steps_kn agm_steps_en", steps, step_arguments, {
            "uniform": ALL, "towards-0": ALL, "towards-1": ALL}),
}
SHARES = {"classics": 40, "agm_steps": 64}
