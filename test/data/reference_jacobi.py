# SPDX-License-Identifier: MIT
"""The Jacobi functions' references, in the manner of reference_integrals.py.

u is reduced by twice the exact K; sn, cn, dn of what remains are quotients of theta functions, for
which FLINT takes the modular transformation that suits the nome. m < 0 and m > 1 go back to
0 < m < 1.
"""
import flint
import mpmath as mp
from flint import acb, arb

from reference_integrals import (
    ALL, BOTH, NAN, any_modulus, complete, huge_phi, incomplete, m_and_mc, modulus,
    negative_modulus, next_to_multiple, quarter, rd, reduced, rf, subnormal)


# The functions, on balls.


def quarter_period(mc):
    """K of 1 - mc: DLMF 19.8.5."""
    return arb.pi() / 2 / arb(1).agm(mc.sqrt())


def nearest(x):
    """An integer next to the middle of x; 0 where there is none."""
    n = (x.mid() + 0.5).floor().unique_fmpz() if x.is_finite() else None
    return 0 if n is None else int(n)


def is_tiny(x):
    """A theta function would lose the digits of x, while x^2 is nothing."""
    return abs(x) < arb(2) ** (-3 * flint.ctx.prec // 8)


def theta_quotients(u, m, mc):
    """sn, cn, dn, abs(u) <= K/2: DLMF 22.2.4-6."""
    if is_tiny(u):  # sn(u)/u = cn dn of something between, which is above 1 - u^2
        sn = u * arb(1).union(1 - u * u)
        return sn, (1 - sn * sn).sqrt(), (1 - m * sn * sn).sqrt()
    k, kc, quarter = m.sqrt(), mc.sqrt(), quarter_period(mc)
    theta = acb(u / (2 * quarter)).modular_theta(acb(0, quarter_period(m) / quarter))
    t1, t2, t3, t4 = (t.real for t in theta)
    return t1 / (k.sqrt() * t4), (kc / k).sqrt() * t2 / t4, kc.sqrt() * t3 / t4


def within_half_period(u, m, mc):
    """sn, cn, dn, abs(u) <= K: from the nearer of 0 and K, DLMF 22.4.3."""
    quarter = quarter_period(mc)
    gap = quarter - abs(u)
    if not gap.mid() < abs(u).mid():
        return theta_quotients(u, m, mc)
    sn, cn, dn = theta_quotients(gap, m, mc)
    kc = mc.sqrt()
    return (cn if u.mid() > 0 else -cn) / dn, kc * sn / dn, kc / dn


def reduced_jacobi(u, m, mc):
    """n and sn, cn, dn of u - 2nK, for m < 1: DLMF 22.17.6-8 where m < 0."""
    if m < 0:
        root = mc.sqrt()
        n, (sn, cn, dn) = reduced_jacobi(u * root, -m / mc, 1 / mc)
        return n, (sn / dn / root, cn / dn, 1 / dn)
    half_period = 2 * quarter_period(mc)
    n = nearest(u / half_period)
    return n, within_half_period(u - n * half_period, m, mc)


def jacobi_values(u, m, mc):
    """sn, cn, dn, am, and epsilon, the integral of dn^2 from 0 to u: DLMF 22.16.14.

    am is continuous in u; for m > 1 it stays within pi/2, DLMF 22.17.2-4.
    """
    if mc < 0:
        root = m.sqrt()
        sn, cn, dn, _, e = jacobi_values(u * root, 1 / m, -mc / m)
        return sn / root, dn, cn, arb.atan2(sn / root, dn), root * e + mc * u
    n, (sn, cn, dn) = reduced_jacobi(u, m, mc)
    am = n * arb.pi() + arb.atan2(sn, cn)
    e = u - 2 * n * quarter_period(mc) - m * sn**3 * rd(cn * cn, dn * dn, 1) / 3
    if n != 0:
        e += 2 * n * complete("mc", mc)[1]
    return (-sn, -cn, dn, am, e) if n % 2 else (sn, cn, dn, am, e)


def jacobi(form, u, x):
    return jacobi_values(u, *m_and_mc(form, x))


QUOTIENTS = "ns nc nd sc cs sd ds cd dc".split()


def jacobi_quotients(form, u, x):
    value = dict(zip("scd", jacobi(form, u, x)), n=arb(1))
    return [value[p] / value[q] for p, q in QUOTIENTS]


def jacobi_complex(form, x, y, parameter):
    """Real and imaginary parts of sn, cn, dn of x + iy: DLMF 22.8.1-3 and 22.6.12-14."""
    m, mc = m_and_mc(form, parameter)
    s, c, d, _, _ = jacobi_values(x, m, mc)
    s1, c1, d1, _, _ = jacobi_values(y, mc, m)
    below = c1 * c1 + m * s * s * s1 * s1
    parts = s * d1, c * d * s1 * c1, c * c1, -s * d * s1 * d1, d * c1 * d1, -m * s * c * s1
    return [part / below for part in parts]


def inverse(p, q, x, m, mc):
    """The u in (0, K) whose pq is x > 0: s RF(c^2, d^2, 1), homogeneous in p^2 = x^2 q^2."""
    x2 = x * x

    def balance(s, c, d, n):
        values = {"s": s, "c": c, "d": d, "n": n}
        return values[p] - x2 * values[q]

    s2, c2, d2, n2 = (-balance(0, 1, 1, 1), balance(1, 0, mc, 1), balance(1, -mc, 0, m),
                      balance(1, -1, -m, 0))
    if s2 < 0:
        s2, c2, d2, n2 = -s2, -c2, -d2, -n2
    return s2.sqrt() * rf(c2, d2, n2)


def jacobi_inverse(form, x, parameter):
    """Principal values of DLMF 22.15; odd functions, and those with a c above, for x < 0 too."""
    p, q, form = form[3], form[4], form[6:]
    m, mc = m_and_mc(form, parameter)
    value = inverse(p, q, abs(x), m, mc)
    if x < 0:
        value = {"s": -value, "c": 2 * quarter_period(mc) - value}.get(p, NAN)
    return [value]


def nome_of(m, mc):
    if m < 0:
        return -nome_of(-m / mc, 1 / mc)
    return (-arb.pi() * quarter_period(m) / quarter_period(mc)).exp()


def nome(form, x):
    return [nome_of(*m_and_mc(form, x))]


def thetas(z, q, derivative=0):
    """theta1 to theta4 in DLMF's z, for 0 < q < 1, or their derivatives by z."""
    tau = acb(0, -q.log() / arb.pi())
    theta = acb(z / arb.pi()).modular_theta(tau, derivative)
    return [t.real / arb.pi() ** derivative for t in theta]


def theta(form, z, q):
    """Folded to abs(r) <= pi/4, DLMF 20.2.11-14; f(r) = r f'(v), 0 < v < r, of an odd f."""
    which, derivative = int(form[5]) - 1, int(form.endswith("prime"))
    j = nearest(z / (arb.pi() / 2))
    r = z - j * arb.pi() / 2
    values = thetas(r, q, derivative)
    if is_tiny(r):
        odd = [r * slope for slope in thetas(r.union(0), q, derivative + 1)]
        values = [values[0], *odd[1:]] if derivative else [odd[0], *values[1:]]
    for _ in range(j % 4):
        t1, t2, t3, t4 = values
        values = [t2, -t1, t4, t3]
    return [values[which]]


def zeta(form, phi, x):
    """E(phi) - (E/K) F(phi), of period pi."""
    m, mc = m_and_mc(form, x)
    _, s, c = reduced(phi)
    d2 = c * c + mc * s * s
    k, _, _, d = complete(form, x)
    return [m * (d / k * s * rf(c * c, d2, 1) - s**3 * rd(c * c, d2, 1) / 3)]


def heuman_lambda(form, phi, x):
    """(2/pi) (E(m) F(phi|mc) - K(m) (F - E)(phi|mc)): A&S 17.4.39."""
    m, mc = m_and_mc(form, x)
    k, e, _, _ = complete(form, x)
    f, _, d = incomplete("mc", phi, m)
    return [2 / arb.pi() * (e * f - mc * k * d)]


def from_nome(q):
    """m and mc: DLMF 20.9.1-2; q < 0 changes theta3 and theta4 with each other."""
    _, t2, t3, t4 = thetas(arb(0), abs(q))
    if q < 0:
        return [-((t2 / t4) ** 4), (t3 / t4) ** 4]
    return [(t2 / t3) ** 4, (t4 / t3) ** 4]


def from_mean(y):
    """m and mc of agm(1, kc) = y: Newton's steps for log(kc), then a proof by monotony."""
    def excess(log_kc):
        return 1 / arb(1).agm(log_kc.exp()) - 1 / y

    log_kc = (4 / y).log() - arb.pi() / (2 * y) if y < 1 else (y * (1 + y.log())).log()
    step = arb(2) ** (-flint.ctx.prec // 3)
    for _ in range(40):
        slope = (excess(log_kc + step) - excess(log_kc)) / step
        change = (excess(log_kc) / slope).mid()
        log_kc = (log_kc - change).mid()
        if abs(change) < arb(2) ** (20 - flint.ctx.prec):
            break
    error = arb(2) ** (40 - flint.ctx.prec)
    low, high = log_kc - error, log_kc + error
    if not (excess(low) > 0 and excess(high) < 0):
        return [NAN, NAN]
    log_mc = 2 * low.union(high)
    return [-log_mc.expm1(), log_mc.exp()]


def parameters(form, x):
    if form == "nome":
        return from_nome(x)
    return from_mean(1 / x if form == "period_ratio" else arb.pi() / (2 * x))


# The arguments.


def real_quarter_period(form, x):
    """K; for m > 1 where sn has its first maximum."""
    m, mc = m_and_mc(form, x)
    return mp.pi / 2 / (mp.agm(1, mp.sqrt(mc)) if mc > 0 else mp.agm(mp.sqrt(m), mp.sqrt(-mc)))


def next_to_period(dice, quarter, most):
    """A number next to nK, or some ulp from it, n up to 2^most."""
    n = int(dice.power(0, most))
    with mp.workprec(dice.bits):
        u = n * quarter
    return u * (1 + dice.pick(0, 0, dice.integer(-4, 4)) * mp.mpf(2) ** -dice.bits)


def closest_to_period(dice, quarter, most):
    """A number as near to some nK as can be: K in units of an ulp has the convergent p/n."""
    n_most = dice.power(0, most)
    unit = mp.mpf(2) ** (mp.ceil(mp.log(n_most * quarter, 2)) - dice.bits)
    x = quarter / unit
    (p, n), (last_p, last_n) = (mp.floor(x), 1), (1, 0)
    while n <= n_most:
        x = 1 / (x - mp.floor(x))
        (p, n), (last_p, last_n) = (mp.floor(x) * p + last_p, mp.floor(x) * n + last_n), (p, n)
    return last_p * unit


def periods(dice, form, x, *ways):
    """u in one of the ways, for the modulus as it will be rounded; then the modulus."""
    with mp.workprec(dice.bits):
        x = +x
    quarter = real_quarter_period(form, x)
    way = dice.pick(*ways)
    if way == "within":
        return [dice.uniform(-4, 4) * quarter, x]
    if way == "far":  # as far as 1e6 K
        return [dice.sign() * dice.power(-10, 20) * min(quarter, 1), x]
    most = mp.log(6e5 if way == "multiples" else 1e15, 2)
    nearness = dice.pick(next_to_period, closest_to_period)
    return [dice.sign() * nearness(dice, quarter, most), x]


def above_1(dice, form):
    m = 1 + dice.pick(4 * dice.gap(), dice.uniform(0, 9), dice.power(0, -mp.mpf(dice.lowest) / 3))
    return {"k": dice.sign() * mp.sqrt(m), "m": m, "mc": 1 - m}[form]


def exactly_tiny(dice):
    choices = [mp.mpf(10) ** -n for n in (20, 37, 100, 300, 4900)]
    return dice.pick(*(mc for mc in choices if mc > mp.mpf(2) ** dice.lowest))


def jacobi_arguments(dice, regime, form):
    if regime == "any-u":
        return [dice.sign() * dice.power(-10, 20), any_modulus(dice, form)]
    if regime == "huge-u":
        return [dice.sign() * dice.power(20, 50), any_modulus(dice, form)]
    if regime == "tiny-u":
        return [dice.sign() * dice.power(dice.lowest, -10), any_modulus(dice, form)]
    if regime == "subnormal":
        return [dice.sign() * subnormal(dice), any_modulus(dice, form)]
    if regime == "uniform":
        return periods(dice, form, modulus(dice, regime, form), "within")
    if regime in ("multiples", "huge-multiples"):
        return periods(dice, form, any_modulus(dice, form), regime)
    if regime == "negative-m":
        x = negative_modulus(dice, form)
    elif regime == "above-1":
        x = above_1(dice, form)
    elif regime == "tiny-mc":
        x = exactly_tiny(dice)
    else:
        x = modulus(dice, regime, form)
    return periods(dice, form, x, "within", "far", "multiples")


def quotient_arguments(dice, regime, form):
    if regime in ("subnormal", "overflow"):  # u about 1/huge, or below
        least = dice.lowest - (2 if regime == "subnormal" else dice.bits - 1)
        return [dice.sign() * dice.power(least, least + dice.pick(1, 3)), any_modulus(dice, form)]
    return jacobi_arguments(dice, regime, form)


def modulus_of(form, m, mc):
    return {"k": mp.sqrt(abs(m)), "m": m, "mc": mc}[form]


def edge_arguments(dice, regime, form):
    """m just above 1 by each form, u of any exponent, and moduli of any exponent."""
    if regime == "just-above-1":
        gap = dice.power(dice.lowest, -4) if form == "mc" else 8 * dice.gap()
        return periods(dice, form, modulus_of(form, 1 + gap, -gap), "within", "far", "multiples")
    if regime == "any-exponent":
        x = dice.pick(any_modulus, above_1, any_modulus if form == "k" else negative_modulus)
        return [dice.sign() * dice.power(20, -dice.lowest), x(dice, form)]
    if regime == "overflow":  # am grows like u sqrt(-m), epsilon like -u m
        power = dice.uniform(1, -dice.lowest)
        rest = dice.uniform(-dice.lowest - power / 2, 40 - dice.lowest) - power / 2
        m = -mp.mpf(2) ** power
        return [dice.sign() * mp.mpf(2) ** min(rest, -dice.lowest), m if form == "m" else -m]
    m = dice.power(20, (-2 if form == "k" else -1) * dice.lowest)
    m *= 1 if form == "k" else dice.sign()
    return periods(dice, form, modulus_of(form, m, -m), "within", "multiples")


def complex_arguments(dice, regime, form):
    if regime in ("tiny-negative-m", "tiny-m"):
        x = dice.tiny() * (1 if regime == "tiny-m" else -1)
        u = [dice.uniform(-10, 10), dice.uniform(-4, 4) * real_quarter_period("mc", x)]
        return [*u, mp.sqrt(x) if form == "k" else x]
    where = {"negative-m": "negative", "poles": dice.pick("uniform", "towards-1")}
    u, x = periods(dice, form, modulus(dice, where.get(regime, regime), form), "within")
    m, _ = m_and_mc(form, x)
    quarter = real_quarter_period(form, x), real_quarter_period("mc", m)
    if regime != "poles":
        return [u, dice.uniform(-4, 4) * quarter[1], x]
    angle = dice.uniform(0, 2 * mp.pi)
    distance = dice.power(-dice.bits // 2, -2) * min(quarter)
    return [2 * dice.integer(-2, 2) * quarter[0] + distance * mp.cos(angle),
            (2 * dice.integer(-2, 1) + 1) * quarter[1] + distance * mp.sin(angle), x]


def range_ends(p, q, m, mc):
    """pq at 0 and at the real quarter period; 0 and infinity included."""
    bottom = {"s": 0, "c": 1, "d": 1, "n": 1}
    top = {"s": 1, "c": 0, "d": mc, "n": 1}
    if m > 1:
        top = {"s": 1 / m, "c": -mc / m, "d": 0, "n": 1}
    return [mp.sqrt(mp.mpf(value[p]) / value[q]) if value[q] else mp.inf
            for value in (bottom, top)]


def between(dice, low, high):
    if mp.inf not in (low, high):
        return dice.uniform(low, high)
    if 0 in (low, high):
        return mp.tan(quarter(dice))
    return 1 / dice.uniform(1 / low, 1 / high)


def next_to_end(dice, end, other):
    """A part of the way from an end to the other."""
    if end == 0:
        return dice.power(mp.mpf(dice.lowest) / 3, -1) * (1 if other == mp.inf else other)
    if end == mp.inf:
        return 1 / next_to_end(dice, mp.mpf(0), 1 / other if other else mp.inf)
    return end + (end if other == mp.inf else other - end) * dice.gap()


def at_the_edge(dice, form):
    """A modulus of any kind, those of far ends among them."""
    return dice.pick(any_modulus, negative_modulus if form != "k" else any_modulus, above_1)(dice, form)


def inside(dice, end, other):
    """Next to an end, down to the last number that is inside, or to the last of all numbers."""
    if end == 0:
        return dice.power(dice.lowest, -2)
    if end == mp.inf:
        return dice.power(2, -dice.lowest)
    return end * (1 + (1 if other > end else -1) * dice.power(-dice.bits - 1, -3))


def inverse_arguments(dice, regime, form):
    p, q, form = form[3], form[4], form[6:]
    if regime == "edge":
        x = at_the_edge(dice, form)
    elif regime == "negative-m":
        x = negative_modulus(dice, form)
    elif regime == "above-1":
        x = above_1(dice, form)
    else:
        x = any_modulus(dice, form) if regime == "ends" else modulus(dice, regime, form)
    with mp.workprec(dice.bits):
        x = +x
    ends = range_ends(p, q, *m_and_mc(form, x))
    if regime == "edge":
        value = inside(dice, *dice.pick(ends, ends[::-1]))
    elif regime == "ends" or dice.pick(True, False, False):
        value = next_to_end(dice, *dice.pick(ends, ends[::-1]))
    else:
        value = between(dice, *ends)
    return [dice.sign() * value if p == "s" or (p == "c" and m_and_mc(form, x)[0] <= 1) else value, x]


def nome_arguments(dice, regime, form):
    return [modulus(dice, regime, form)]


def theta_arguments(dice, regime, _):
    if regime == "towards-1":  # within some widths of a peak
        q = 1 - dice.gap()
        width = mp.sqrt(-mp.log(q))
        far = dice.pick(5, 20) * width
        return [dice.integer(-3, 3) * mp.pi / 2 + dice.uniform(-far, far), q]
    if regime == "tiny-q":
        return [dice.uniform(-4, 4), dice.tiny()]
    q = dice.uniform()
    if regime == "multiples":
        return [next_to_multiple(dice), q]
    if regime == "any-z":
        return [dice.pick(dice.uniform(-50, 50), huge_phi(dice)), q]
    if regime == "tiny-z":
        return [dice.sign() * dice.power(mp.mpf(dice.lowest) / 3, -4), q]
    return [dice.uniform(-4, 4), q]


def zeta_arguments(dice, regime, form):
    if regime == "any-phi":
        phi = dice.pick(dice.uniform(-50, 50), dice.uniform(-50, 50), huge_phi(dice))
        return [phi, modulus(dice, "uniform", form)]
    if regime == "multiples":
        return [next_to_multiple(dice), modulus(dice, dice.pick("uniform", "towards-1"), form)]
    if regime == "tiny-phi":
        phi = dice.sign() * dice.power(mp.mpf(dice.lowest) / 3, -4)
        return [phi, modulus(dice, dice.pick("uniform", "towards-0", "towards-1"), form)]
    if regime == "negative-m":
        return [quarter(dice), negative_modulus(dice, form)]
    return [quarter(dice), modulus(dice, regime, form)]


def nome_argument(dice, regime):
    """As far as m and mc are in the kind's range: mc = 16 exp(pi^2/log q) next to q = 1."""
    if regime == "towards-0":
        return dice.tiny()
    if regime == "towards-1":
        return mp.exp(-mp.pi**2 / dice.uniform(4, -dice.lowest * mp.log(2)))
    if regime == "negative-m":
        return -dice.pick(dice.uniform(), dice.tiny(), mp.exp(
            -mp.pi**2 / dice.uniform(4, -dice.lowest * mp.log(2))))
    return dice.uniform()


def parameter_arguments(dice, regime, form):
    """A nome, K, or K over pi/2."""
    if form == "nome":
        return [nome_argument(dice, regime)]
    if regime == "towards-0":
        ratio = 1 + dice.power(2 - dice.bits, -2)
    elif regime == "towards-1":
        ratio = dice.uniform(2, -dice.lowest * mp.log(2) / mp.pi)
    elif regime == "negative-m":
        ratio = dice.pick(dice.uniform(), 1 - dice.gap(), dice.power(mp.mpf(dice.lowest) / 2, 0))
    else:
        ratio = dice.uniform(1, 4)
    return [ratio if form == "period_ratio" else ratio * mp.pi / 2]


# The files.


def inverses_of(names):
    return " ".join(f"arc{name}_{form}" for name in names for form in ALL.split())


def inverse_regimes(names):
    every = inverses_of(names)
    both = " ".join(form for form in every.split() if not form.endswith("_k"))
    wide = inverses_of(name for name in names if name not in ("dn", "nd"))
    return {"uniform": every, "ends": every, "edge": every, "towards-0": wide, "towards-1": every,
            "negative-m": both}


THETAS = "theta1 theta2 theta3 theta4 theta1_prime theta2_prime theta3_prime theta4_prime"
ORIGINS = "nome ellipk period_ratio"
TOPICS = {
    "jacobi": (
        "jacobi_sn jacobi_cn jacobi_dn jacobi_am jacobi_epsilon", jacobi, jacobi_arguments, {
            "uniform": ALL, "multiples": ALL, "any-u": ALL, "huge-u": ALL, "huge-multiples": ALL,
            "tiny-u": ALL, "towards-0": ALL, "towards-1": ALL, "tiny-mc": "mc",
            "negative-m": BOTH, "above-1": ALL, "subnormal": ALL}),
    "jacobi_edges": (
        "jacobi_sn jacobi_cn jacobi_dn jacobi_am jacobi_epsilon", jacobi, edge_arguments, {
            "just-above-1": ALL, "any-exponent": ALL, "huge-modulus": ALL, "overflow": BOTH}),
    "jacobi_quotients": (
        " ".join(f"jacobi_{name}" for name in QUOTIENTS), jacobi_quotients, quotient_arguments, {
            "uniform": ALL, "multiples": ALL, "any-u": ALL, "towards-1": ALL, "tiny-mc": "mc",
            "negative-m": BOTH, "above-1": ALL, "subnormal": ALL, "overflow": ALL}),
    "jacobi_complex": (
        "complex_sn_re complex_sn_im complex_cn_re complex_cn_im complex_dn_re complex_dn_im",
        jacobi_complex, complex_arguments, {
            "uniform": ALL, "towards-1": ALL, "poles": ALL, "negative-m": BOTH,
            "tiny-negative-m": "m", "tiny-m": "k m"}),
    "jacobi_inverse": (
        "jacobi", jacobi_inverse, inverse_arguments,
        inverse_regimes(["sn", "cn", "dn"]) | {"above-1": inverses_of(["sn", "cn", "dn"])}),
    "jacobi_inverse_quotients": (
        "jacobi", jacobi_inverse, inverse_arguments, inverse_regimes(QUOTIENTS)),
    "nome": ("nome", nome, nome_arguments, {
        "uniform": ALL, "towards-0": ALL, "towards-1": ALL, "negative": BOTH,
        "far-negative": BOTH}),
    "parameter": (
        "parameter_from complementary_parameter_from", parameters, parameter_arguments, {
            "uniform": ORIGINS, "towards-0": ORIGINS, "towards-1": ORIGINS,
            "negative-m": ORIGINS}),
    "theta": ("theta", theta, theta_arguments, {
        "uniform": THETAS, "multiples": THETAS, "any-z": THETAS, "tiny-z": THETAS,
        "tiny-q": THETAS, "towards-1": THETAS}),
    "jacobi_zeta": ("jacobi_zeta", zeta, zeta_arguments, {
        "uniform": ALL, "multiples": ALL, "any-phi": ALL, "tiny-phi": ALL, "towards-0": ALL,
        "towards-1": ALL, "negative-m": BOTH}),
    "heuman_lambda": ("heuman_lambda", heuman_lambda, zeta_arguments, {
        "uniform": ALL, "multiples": ALL, "any-phi": ALL, "tiny-phi": ALL, "towards-0": ALL,
        "towards-1": ALL}),
}
# What part of the usual number of points a form has.
SHARES = {"jacobi_edges": 10, "jacobi_quotients": 20, "jacobi_complex": 8, "jacobi_inverse": 4,
          "jacobi_inverse_quotients": 20, "theta": 4}
# A huge u has many bits before the point.
FAR = {"jacobi_edges"}
