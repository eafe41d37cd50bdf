# SPDX-License-Identifier: MIT
"""The integrals' references: functions on FLINT's balls, random arguments, the files' contents."""
import random

import flint
import mpmath as mp
from flint import acb, arb

KINDS = {"real32": (24, 9, -126), "real64": (53, 17, -1022), "real128": (113, 36, -16382)}


# The functions, on balls. One that cannot be told with the present bits is NaN or a wide ball.

NAN = arb("nan")


def real(z):
    return z.real if z.imag.contains(0) else NAN


def rf(x, y, z):
    return real(acb.elliptic_rf(acb(x), acb(y), acb(z)))


def rd(x, y, z):
    return real(acb.elliptic_rd(acb(x), acb(y), acb(z)))


def rg(x, y, z):
    return real(acb.elliptic_rg(acb(x), acb(y), acb(z)))


def rc(x, y):
    """R_C, for y < 0 its principal value, DLMF 19.2.20."""
    if y < 0:
        return (x / (x - y)).sqrt() * rc(x - y, -y)
    return real(acb.elliptic_rc(acb(x), acb(y)))


def rj(x, y, z, p):
    """R_J, for p < 0 its principal value, DLMF 19.20.14, which takes x or y <= z."""
    if not (x >= 0 and y >= 0 and z >= 0):  # outside, or not to be told with the present bits
        return NAN
    if p < 0:
        q, p = -p, (z * (x + y - p) - x * y) / (z - p)
        rest = 3 * (x * y * z / (x * y + p * q)).sqrt() * rc(x * y + p * q, p * q)
        return ((p - z) * rj(x, y, z, p) - 3 * rf(x, y, z) + rest) / (q + z)
    return real(acb.elliptic_rj(acb(x), acb(y), acb(z), acb(p)))


def m_and_mc(form, x):
    if form == "k":
        return x * x, (1 - x) * (1 + x)
    if form == "alpha":
        return (x.sin() ** 2, x.cos() ** 2) if x.cos() > 0 else (NAN, NAN)
    return (x, 1 - x) if form == "m" else (1 - x, x)


def reduced(phi):
    """j, sin(r), cos(r) of phi = j pi + r, |r| < pi/2."""
    j = (phi / arb.pi() + 0.5).floor().unique_fmpz()
    if j is None:
        return 0, NAN, NAN
    r = phi - int(j) * arb.pi()
    return int(j), r.sin(), r.cos()


def complete(form, x):
    """K, E, B, D: DLMF 19.25.1, and E = B + mc D."""
    _, mc = m_and_mc(form, x)
    k, d = rf(0, mc, 1), rd(0, mc, 1) / 3
    return [k, k - d + mc * d, k - d, d]


def incomplete(form, phi, x):
    """F, E, D: DLMF 19.25.5, 19.25.13, and 19.2.10 beyond pi/2."""
    m, mc = m_and_mc(form, x)
    j, s, c = reduced(phi)
    f = s * rf(c * c, c * c + mc * s * s, 1)
    d = s**3 * rd(c * c, c * c + mc * s * s, 1) / 3
    if j != 0:
        k, _, _, quarter_d = complete(form, x)
        f, d = f + 2 * j * k, d + 2 * j * quarter_d
    return [f, f - m * d, d]


def middle(x):
    """An exact number of the ball; 0 where there is none."""
    return x.mid() if x.is_finite() else arb(0)


def first_guess(rest, e, m, mc):
    """psi in (0, pi/2) with E(psi) = rest: from the end where the integrand has its smallest value,
    ends (x/2) sqrt(4 + n x^2) within a tenth."""
    scale = mc.sqrt() if m < 0 else arb(1)
    a = (rest if m < 0 else e - rest) / scale
    least = 1 / mc if m < 0 else mc
    x = a * (2 / (least + (least**2 + a * a).sqrt())).sqrt()
    return x if m < 0 else arb.pi() / 2 - x


def incomplete_inverse(form, s, x):
    """phi with E(phi) = s: Newton's steps within a quarter period, then a proof by monotony."""
    m, mc = m_and_mc(form, x)
    if not mc > 0:
        return [NAN]
    e = complete(form, x)[1]
    turns = (s / (2 * e) + 0.5).floor().unique_fmpz()
    if turns is None:
        return [NAN]
    rest = s - 2 * int(turns) * e
    psi = middle(first_guess(abs(rest), e, m, mc))
    for _ in range(60):
        _, value, _ = incomplete(form, psi, x)
        change = middle((value - abs(rest)) / (psi.cos() ** 2 + mc * psi.sin() ** 2).sqrt())
        psi = (psi - change).mid()
        if abs(change) <= abs(psi) * arb(2) ** (20 - flint.ctx.prec):
            break
    phi = middle((psi if rest > 0 else -psi) + int(turns) * arb.pi())
    error = abs(phi) * arb(2) ** (-3 * flint.ctx.prec // 4)
    low, high = (phi - error).mid(), (phi + error).mid()
    if not (incomplete(form, low, x)[1] < s and incomplete(form, high, x)[1] > s):
        return [NAN]
    return [low.union(high)]


def third(n, s, c, mc):
    """Pi within a quarter period: DLMF 19.25.14."""
    x, y, p = c * c, c * c + mc * s * s, c * c + (1 - n) * s * s
    return s * rf(x, y, 1) + n * s**3 * rj(x, y, 1, p) / 3


def third_kind(form, n, x):
    return [third(n, arb(1), arb(0), m_and_mc(form, x)[1])]


def third_kind_incomplete(form, n, phi, x):
    _, mc = m_and_mc(form, x)
    j, s, c = reduced(phi)
    within = third(n, s, c, mc)
    return [within + 2 * j * third(n, arb(1), arb(0), mc) if j != 0 else within]


def associate(n, s, c, mc):
    """J = (Pi - F)/n within a quarter period."""
    return s**3 * rj(c * c, c * c + mc * s * s, 1, c * c + (1 - n) * s * s) / 3


def associate_complete(form, n, x):
    return [associate(n, arb(1), arb(0), m_and_mc(form, x)[1])]


def associate_incomplete(form, n, phi, x):
    _, mc = m_and_mc(form, x)
    j, s, c = reduced(phi)
    within = associate(n, s, c, mc)
    return [within + 2 * j * associate(n, arb(1), arb(0), mc) if j != 0 else within]


def second_associate(form, x):
    """S = (D - B)/m; next to m = 0 by its hypergeometric series, pi/16 F(3/2, 3/2; 3; m)."""
    m, _ = m_and_mc(form, x)
    if abs(m) < 0.25:
        return [arb.pi() / 16 * m.hypgeom_2f1(arb(1.5), arb(1.5), arb(3))]
    _, _, b, d = complete(form, x)
    return [(d - b) / m]


def bulirsch_cel(_, kc, p, a, b):
    """DLMF 19.25.2, and for kc = 0 or p = 0, where b = 0, what is left of it."""
    x = kc * kc
    if x == 0:
        return [a * rc(arb(1), p)]
    k = rf(0, x, 1)
    if p == 0:
        return [a * k]
    # the middle one first, as rj wants its largest last
    d = (rj(arb(0), x, arb(1), p) if x < 1 else rj(arb(0), arb(1), x, p)) / 3
    return [a * k + (b - p * a) * d]


def carlson(form, *arguments):
    if form == "rj":  # the largest of x, y, z last
        arguments = (*sorted(arguments[:3], key=lambda x: x.mid()), arguments[3])
    return [{"rf": rf, "rc": rc, "rd": rd, "rj": rj, "rg": rg}[form](*arguments)]


def period(_, amplitude):
    """T/T_h = 2 K / pi = 1 / agm(1, sqrt(mc))."""
    kc = (amplitude / 2).cos()
    return [2 / arb.pi() * rf(0, kc * kc, 1) if kc > 0 else NAN]


# The arguments: numbers that are then rounded to their kind.


class Dice:
    """Random numbers, the same in every run, on every machine."""

    def __init__(self, kind, seed):
        self.random = random.Random(f"{kind} {seed}")
        self.bits, _, self.lowest = KINDS[kind]

    def uniform(self, low=0, high=1):
        u = mp.mpf(self.random.random()) + mp.mpf(self.random.random()) * mp.mpf(2) ** -53
        return low + (high - low) * u

    def integer(self, low, high):
        return low + int(self.random.random() * (high - low + 1))

    def pick(self, *choices):
        return choices[self.integer(0, len(choices) - 1)]

    def sign(self):
        return self.pick(-1, 1)

    def power(self, low, high):
        """Log-uniform, 2^low to 2^high."""
        return mp.mpf(2) ** self.uniform(low, high)

    def tiny(self):
        return self.power(self.lowest, -1)

    def huge(self, limit=16384):
        return self.power(0, min(-self.lowest, limit))

    def ulps(self):
        """1 and a few ulp."""
        return 1 + self.integer(-4, 4) * mp.mpf(2) ** (1 - self.bits)

    def gap(self):
        """1/2 down to an ulp."""
        return self.power(-self.bits, -1)


def boundary(dice, form):
    """Next to 2^e (1 + i/16), as m or as 1 - m: where tables may have their seams."""
    def edge(low, high):
        return mp.mpf(2) ** dice.integer(low, high) * (1 + mp.mpf(dice.integer(0, 15)) / 16)

    if form == "mc":
        low, high = dice.pick((-20, 10), (-20, 10), (dice.lowest, -dice.lowest))
        return edge(low, high) * dice.ulps()
    m = dice.pick(edge(-12, -1), -edge(-12, 10), 1 - edge(-12, -1), 1 - edge(0, 10))
    return m * dice.ulps()


def modulus(dice, regime, form):
    """An argument of the form whose m is in the regime."""
    if regime == "uniform":
        u = dice.uniform()
        return {"k": 2 * u - 1, "m": u, "mc": u, "alpha": u * mp.pi / 2}[form]
    if regime == "towards-0":
        return 1 - dice.gap() if form == "mc" else dice.tiny()
    if regime == "towards-1":
        return dice.tiny() if form == "mc" else (mp.pi / 2 if form == "alpha" else 1) - dice.gap()
    if regime == "negative":
        return 1 + dice.uniform(0, 100) if form == "mc" else dice.uniform(-100, 0)
    if regime == "far-negative":
        return dice.huge() if form == "mc" else -dice.huge()
    return boundary(dice, form)


def any_modulus(dice, form):
    regimes = ["uniform", "towards-0", "towards-1"]
    return modulus(dice, dice.pick(*regimes, *([] if form == "k" else ["negative"])), form)


def negative_modulus(dice, form):
    return modulus(dice, dice.pick("negative", "far-negative"), form)


def modulus_above_1(dice, form, phi):
    """m between 1 and 1/sin(phi)^2, half of them next to that."""
    most = 1 / mp.sin(phi) ** 2
    m = most * (1 - dice.gap()) if dice.pick(True, False) else dice.uniform(1, most)
    return {"k": mp.sqrt(m), "m": m, "mc": 1 - m}[form]


def rounded_to(bits, x):
    with mp.workprec(bits):
        return +x


def edge_modulus(dice, form, phi):
    """m below 1/sin(phi)^2 by a part of it, down to half an ulp."""
    m = (1 - dice.power(-dice.bits - 1, -3)) / mp.sin(phi) ** 2
    return {"k": mp.sqrt(m), "m": m, "mc": 1 - m}[form]


def subnormal(dice):
    """A number below the normal ones, or just above."""
    return dice.power(dice.lowest - dice.bits + 1, dice.lowest + 1)


def edge_angle(dice):
    phi = dice.pick(quarter(dice), dice.power(-20, 0), mp.pi / 2 - dice.power(-20, -1))
    return rounded_to(dice.bits, phi)


def quarter(dice):
    return dice.uniform(0, mp.pi / 2)


def next_to_multiple(dice):
    """A few ulp to 1e-3 from a multiple of pi/2."""
    phi = dice.sign() * dice.integer(1, 8) * mp.pi / 2
    return dice.pick(phi * dice.ulps(), phi + dice.sign() * dice.power(-dice.bits, -10))


def huge_phi(dice):
    exponent = dice.pick(20, 20, 20, 50)  # 1e6, 1e15
    return dice.sign() * dice.power(5, exponent)


def complete_arguments(dice, regime, form):
    return [modulus(dice, regime, form)]


def incomplete_arguments(dice, regime, form):
    if regime == "uniform":
        return [quarter(dice), modulus(dice, "uniform", form)]
    if regime == "multiples":
        return [next_to_multiple(dice), modulus(dice, dice.pick("uniform", "towards-1"), form)]
    if regime == "any-phi":
        return [dice.uniform(-50, 50), any_modulus(dice, form)]
    if regime == "huge-phi":
        return [huge_phi(dice), any_modulus(dice, form)]
    if regime == "negative-m":
        return [dice.uniform(0, mp.pi), negative_modulus(dice, form)]
    if regime == "above-1":
        phi = dice.pick(quarter(dice), dice.power(-30, 0))
        return [phi, modulus_above_1(dice, form, phi)]
    if regime == "edge":
        phi = edge_angle(dice)
        return [phi, edge_modulus(dice, form, phi)]
    if regime == "subnormal":  # phi, or its cube
        phi = dice.sign() * dice.pick(subnormal(dice), mp.cbrt(subnormal(dice)))
        return [phi, any_modulus(dice, form)]
    if regime == "overflow":  # each period adds 2 K or so
        x = negative_modulus(dice, form) if form != "k" and dice.pick(True, False) else modulus(
            dice, "towards-1", form)
        return [dice.sign() * dice.power(-dice.lowest - 8, 1 - dice.lowest), x]
    return [dice.power(mp.mpf(dice.lowest) / 3 + 1, -4), modulus(dice, "towards-0", form)]


def quarter_arc(form, x):
    """E, as far as it makes arguments."""
    mc = m_and_mc(form, x)[1]
    return mp.sqrt(mc) * mp.ellipe(1 - 1 / mc) if mc > 1 else mp.ellipe(1 - mc)


def incomplete_inverse_arguments(dice, regime, form):
    if regime == "tiny":
        draw = dice.pick(any_modulus, any_modulus if form == "k" else negative_modulus)
        return [dice.sign() * dice.power(dice.lowest, -4), draw(dice, form)]
    if regime == "subnormal":
        return [dice.sign() * subnormal(dice), any_modulus(dice, form)]
    if regime == "overflow":  # E = 1, and each period adds pi
        return [dice.sign() * dice.power(1 - dice.lowest, 2 - dice.lowest), modulus(dice, "towards-1", form)]
    if regime == "any-s":
        return [dice.uniform(-50, 50), any_modulus(dice, form)]
    if regime == "huge-s":
        return [dice.sign() * dice.power(5, dice.pick(20, 50, -dice.lowest - 2)), any_modulus(dice, form)]
    x = modulus(dice, {"multiples": dice.pick("uniform", "towards-1"), "negative-m": dice.pick(
        "negative", "far-negative")}.get(regime, regime), form)
    e = quarter_arc(form, rounded_to(dice.bits, x))
    if regime == "multiples":
        s = dice.sign() * dice.integer(1, 8) * e
        return [dice.pick(s * dice.ulps(), s + dice.sign() * dice.power(-dice.bits, -10)), x]
    low = mp.mpf(dice.lowest) / 2 if regime == "negative-m" else -dice.bits
    part = dice.pick(dice.uniform(), 1 - dice.gap(), dice.power(low, -2) / e)
    return [dice.sign() * dice.pick(part, part, 1 + part) * e, x]


def principal_n(dice):
    return 1 + dice.pick(dice.gap(), dice.uniform(0, 3), dice.huge(33))


def negative_n(dice):
    return -dice.pick(dice.power(-10, 33), dice.power(-10, 33), dice.power(0, -mp.mpf(dice.lowest) / 3))


def next_to_m(dice, form, x):
    m = {"k": x * x, "m": x, "mc": 1 - x}[form]
    return m * (1 + dice.sign() * dice.gap())


def third_kind_arguments(dice, regime, form):
    x = modulus(dice, "uniform", form)
    if regime == "uniform":
        return [dice.uniform(), x]
    if regime == "negative-n":
        return [negative_n(dice), x]
    if regime == "towards-1":
        return [1 - dice.gap(), modulus(dice, "towards-1", form)]
    if regime == "principal":
        return [principal_n(dice), any_modulus(dice, form)]
    if regime == "near-m":
        return [next_to_m(dice, form, x), x]
    if regime == "spread":  # over the whole range
        n = dice.sign() * dice.power(-dice.lowest / 4, -dice.lowest)
        return [n, dice.pick(x, dice.tiny() if form == "mc" else 1 - dice.gap())]
    if regime == "subnormal":  # -(m/n) D or so
        n = dice.power(-dice.lowest - 20, -dice.lowest)
        return [n, dice.pick(x, dice.power(-20, 0) * x) if form != "mc" else 1 - dice.gap()]
    n = dice.pick(dice.uniform(-1, 1), negative_n(dice), principal_n(dice))
    return [n, negative_modulus(dice, form)]


def third_kind_incomplete_arguments(dice, regime, form):
    if regime in ("multiples", "any-phi"):
        phi = next_to_multiple(dice) if regime == "multiples" else dice.uniform(-50, 50)
        n = dice.pick(dice.uniform(), 1 - dice.gap(), negative_n(dice), principal_n(dice))
        return [n, phi, modulus(dice, dice.pick("uniform", "towards-1"), form)]
    if regime == "above-1":
        phi = quarter(dice)
        return [dice.uniform(-2, 2), phi, modulus_above_1(dice, form, phi)]
    if regime == "pole":  # n sin(phi)^2 next to 1
        phi = rounded_to(dice.bits, dice.pick(quarter(dice), dice.uniform(-40, 40), dice.power(-20, 0)))
        n = (1 + dice.sign() * dice.power(-dice.bits - 1, -6)) / mp.sin(phi) ** 2
        m = dice.pick(dice.uniform(), dice.uniform(-5, 1), -dice.power(-5, 20), dice.power(-20, 0))
        return [n, phi, {"k": mp.sqrt(abs(m)), "m": m, "mc": 1 - m}[form]]
    if regime == "edge":
        phi = edge_angle(dice)
        x = edge_modulus(dice, form, phi)
        n = dice.pick(dice.uniform(-3, 1), next_to_m(dice, form, x), -dice.power(0, 30))
        return [n, phi, x]
    if regime == "tiny":
        phi = dice.power(dice.lowest, -4)
        return [dice.sign() * dice.tiny(), phi, modulus(dice, "towards-0", form)]
    if regime == "subnormal":
        n = dice.sign() * dice.pick(dice.uniform(0, 2), dice.huge(), dice.tiny())
        return [n, dice.sign() * subnormal(dice), any_modulus(dice, form)]
    n, x = third_kind_arguments(dice, regime, form)
    return [n, quarter(dice), x]


def associate_incomplete_arguments(dice, regime, form):
    """As of Pi; J is about phi^3/3."""
    if regime == "tiny":
        return [dice.sign() * dice.tiny(), dice.power(mp.mpf(dice.lowest) / 3 + 1, -4),
                modulus(dice, "towards-0", form)]
    n, phi, x = third_kind_incomplete_arguments(dice, regime, form)
    return [n, mp.sign(phi) * mp.cbrt(abs(phi)) if regime == "subnormal" else phi, x]


def bulirsch_cel_arguments(dice, regime, _):
    kc, p, a, b = (dice.uniform() for _ in range(4))
    if regime == "uniform":
        p *= 2
    if regime == "opposite":
        a = -a
    if regime == "wide":
        kc, p, a, b = (dice.sign() * dice.power(-15, 15) for _ in range(4))
        p = abs(p)
    if regime == "principal":
        p = -dice.pick(dice.power(-10, 10), dice.uniform(0, 2))
        kc, a, b = dice.power(-10, 10), dice.sign() * a, dice.sign() * b
    if regime == "close":
        kc, p = 1 + dice.sign() * dice.gap(), dice.pick(1 + dice.sign() * dice.gap(), kc * (1 + dice.gap()))
    if regime == "zeros":
        kc, p, a, b = dice.pick((kc, p, a, 0), (kc, p, 0, b), (0, p, a, 0), (kc, 0, a, 0), (0, -p, a, 0),
                                (kc, -p, a, 0), (kc, -p, 0, b), (kc, -p, a, a))
    if regime == "cancelling":  # B/D to a rounding, or next to that
        kc, p = (rounded_to(dice.bits, dice.power(-8, 2)) for _ in range(2))
        p = dice.pick(p, p, -p)
        cosine, sine = (bulirsch_cel("", arb(kc), arb(p), arb(x), arb(1 - x))[0].mid() for x in (1, 0))
        a = rounded_to(dice.bits, a)
        b = -a * mp.mpf(tuple(map(int, cosine.man_exp()))) / mp.mpf(tuple(map(int, sine.man_exp())))
        b *= dice.pick(1, 1, 1 + dice.gap())
    if regime in ("spread", "subnormal", "overflow"):
        part = dice.pick(mp.mpf("0.99"), mp.mpf("0.3")) * dice.lowest
        kc, p, a, b = (dice.sign() * dice.power(part, -part) for _ in range(4))
    return [kc, p, a, b]


CARLSON = {"rf": 3, "rc": 2, "rd": 3, "rj": 4, "rg": 3}  # arguments of each


def extreme(dice, form, count):
    """Next to huge and to tiny; half of them all at one end, as far as the result is finite."""
    if dice.pick(True, False):
        return [dice.power(*dice.pick((0.93, 0.999), (-0.999, -0.93))) ** -dice.lowest
                for _ in range(count)]
    end = dice.sign() * (mp.mpf("0.66") if form in ("rd", "rj") else mp.mpf("0.99"))
    return [dice.power(end * mp.mpf("0.93"), end) ** -dice.lowest for _ in range(count)]


def carlson_arguments(dice, regime, form):
    count = CARLSON[form]
    if regime == "subnormal":  # some of the arguments, or all
        return [dice.pick(subnormal(dice), subnormal(dice), dice.uniform(), dice.tiny(), dice.huge())
                for _ in range(count)]
    if regime == "overflow":  # RD and RJ as the power -3/2
        return [dice.power(dice.lowest - dice.bits + 1, mp.mpf(2) / 3 * dice.lowest) for _ in range(count)]
    decades = mp.log(10, 2) * 30
    if regime == "extreme":
        return extreme(dice, form, count)
    if regime in ("spread", "spread-principal"):  # over the whole range
        part = dice.pick(mp.mpf("0.99"), mp.mpf("0.3")) * dice.lowest
        values = [dice.power(part, -part) for _ in range(count)]
        if dice.pick(True, False, False, False):
            values[0] = values[1] * dice.uniform() if form in ("rc", "rj") else mp.mpf(0)
        return values[:-1] + [-values[-1]] if regime == "spread-principal" else values
    if regime == "close":
        middle = dice.power(-10, 10)
        return [middle * (1 + dice.sign() * dice.gap()) for _ in range(count)]
    low, high = dice.pick((-3, 3), (-30, 30)) if regime in ("zeros", "principal") else (0, 0)
    values = [dice.power(low, high) for _ in range(count)]
    if regime == "uniform":
        values = [dice.uniform() for _ in range(count)]
    if regime == "wide":
        values = [dice.power(-decades, decades) for _ in range(count)]
    if regime == "zeros":  # x, y, z of rf, rj, rg, but x, y of rd and x of rc alone
        values[dice.integer(0, {"rc": 0, "rd": 1}.get(form, 2))] = mp.mpf(0)
    if regime == "principal":
        values[-1] = -values[-1]
    return values


def mean(_, a, b):
    """Arithmetic-geometric mean of two numbers of one sign."""
    return [-(-a).agm(-b) if a < 0 else a.agm(b)]


def mean_arguments(dice, regime, _):
    if regime == "spread":
        a, b = (dice.power(dice.lowest, -dice.lowest) for _ in range(2))
    elif regime == "subnormal":
        a, b = subnormal(dice), dice.pick(subnormal(dice), subnormal(dice), dice.uniform(), dice.huge())
    elif regime == "close":
        a = dice.power(-10, 10)
        b = a * (1 + dice.sign() * dice.gap())
    elif regime == "largest":
        a, b = (dice.power(-dice.lowest - 9, 1 - dice.lowest) for _ in range(2))
    else:
        a, b = dice.uniform(), dice.uniform()
    a, b = dice.pick((a, b), (b, a))
    sign = dice.pick(1, 1, -1)
    return [sign * a, sign * b]


def period_arguments(dice, regime, _):
    if regime == "uniform":
        return [dice.uniform(-mp.pi, mp.pi)]
    if regime == "towards-pi":
        return [dice.sign() * (mp.pi - dice.power(2 - dice.bits, 0))]
    return [dice.sign() * dice.power(dice.lowest, -3)]


# The files: families, function, arguments, and the forms in each regime.

EVERY, BOTH, ALL = "k m mc alpha", "m mc", "k m mc"
TOPICS = {
    "complete": ("ellipk ellipe ellipb ellipd", complete, complete_arguments, {
        "uniform": EVERY, "towards-0": EVERY, "towards-1": EVERY,
        "negative": BOTH, "far-negative": BOTH, "boundaries": BOTH}),
    "incomplete": ("ellipf ellipeinc ellipdinc", incomplete, incomplete_arguments, {
        "uniform": ALL, "multiples": ALL, "any-phi": ALL, "huge-phi": ALL,
        "negative-m": BOTH, "above-1": ALL, "tiny": ALL, "edge": ALL, "subnormal": ALL,
        "overflow": ALL}),
    "incomplete_inverse": ("ellipeinc_inverse", incomplete_inverse, incomplete_inverse_arguments, {
        "uniform": ALL, "towards-0": ALL, "towards-1": ALL, "multiples": ALL, "any-s": ALL, "huge-s": ALL,
        "negative-m": BOTH, "tiny": ALL, "subnormal": ALL, "overflow": ALL}),
    "third_kind": ("ellippi", third_kind, third_kind_arguments, {
        "uniform": ALL, "negative-n": ALL, "towards-1": ALL,
        "principal": ALL, "near-m": ALL, "negative-m": BOTH, "spread": ALL, "subnormal": ALL}),
    "third_kind_incomplete": (
        "ellippiinc", third_kind_incomplete, third_kind_incomplete_arguments, {
            "uniform": ALL, "negative-n": ALL, "towards-1": ALL, "principal": ALL, "near-m": ALL,
            "negative-m": BOTH, "multiples": ALL, "any-phi": ALL, "above-1": ALL, "tiny": ALL,
            "pole": ALL, "edge": ALL, "subnormal": ALL}),
    "ellips": ("ellips", second_associate, complete_arguments, {
        "uniform": ALL, "towards-0": ALL, "towards-1": ALL,
        "negative": BOTH, "far-negative": BOTH}),
    "ellipj": ("ellipj", associate_complete, third_kind_arguments, {
        "uniform": ALL, "negative-n": ALL, "towards-1": ALL,
        "principal": ALL, "near-m": ALL, "negative-m": BOTH, "spread": ALL, "subnormal": ALL}),
    "ellipj_incomplete": ("ellipjinc", associate_incomplete, associate_incomplete_arguments, {
        "uniform": ALL, "negative-n": ALL, "towards-1": ALL, "principal": ALL, "near-m": ALL,
        "negative-m": BOTH, "multiples": ALL, "any-phi": ALL, "above-1": ALL, "tiny": ALL,
        "pole": ALL, "edge": ALL, "subnormal": ALL}),
    "cel": ("bulirsch", bulirsch_cel, bulirsch_cel_arguments, {
        regime: "cel" for regime in ("uniform", "opposite", "wide", "principal", "close", "zeros", "cancelling",
                                     "spread", "subnormal", "overflow")}),
    "carlson": ("carlson", carlson, carlson_arguments, {
        "uniform": "rf rc rd rj rg", "wide": "rf rc rd rj rg", "extreme": "rf rc rd rj rg",
        "zeros": "rf rc rd rj rg", "principal": "rc rj", "close": "rf rc rd rj rg",
        "spread": "rf rc rd rj rg", "spread-principal": "rc rj", "subnormal": "rf rc rd rj rg",
        "overflow": "rd rj"}),
    "agm": ("function", mean, mean_arguments, {
        "uniform": "agm", "close": "agm", "spread": "agm", "largest": "agm", "subnormal": "agm"}),
    "period": ("period", period, period_arguments, {
        "uniform": "ratio", "towards-pi": "ratio", "tiny": "ratio"}),
}

# One point of so many: the long way round takes its time
RARE = {"edge": 4, "pole": 4, "spread": 4, "spread-principal": 4, "subnormal": 8, "overflow": 8, "cancelling": 4}
