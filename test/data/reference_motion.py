# SPDX-License-Identifier: MIT
"""The pendulum's references, in the manner of reference_integrals.py.

A motion is carried from its state at the time 0 by the addition theorems of sn, cn, dn, DLMF
22.8.1-3, so that no integral of the first kind is needed: only functions of the time that passed. The
phase and the times at which something happens are such integrals.
"""
import mpmath as mp
from flint import arb

from reference_integrals import NAN, reduced, rf, subnormal
from reference_jacobi import from_mean, jacobi_values, quarter_period, reduced_jacobi


# The functions, on balls.


def added(first, second, m):
    """sn, cn, dn of a sum."""
    (s, c, d), (s1, c1, d1) = first, second
    below = 1 - m * s * s * s1 * s1
    return ((s * c1 * d1 + s1 * c * d) / below, (c * c1 - s * d * s1 * d1) / below,
            (d * d1 - m * s * c * s1 * c1) / below)


def libration(omega, s, c, r, time):
    """Angle and rate; sn = s/k, cn = r/k, dn = c of the start."""
    k = (s * s + r * r).sqrt()
    m, mc = k * k, (c - r) * (c + r)
    sn, cn, dn = added((s / k, r / k, c), jacobi_values(omega * time, m, mc)[:3], m)
    return 2 * arb.atan2(k * sn, dn), 2 * k * omega * cn


def rotation(omega, s, c, r, time):
    """Angle and rate, r > 0: the modulus is 1/k; sn = s, cn = c, dn = r/k of the start."""
    k = (s * s + r * r).sqrt()
    m, mc = 1 / (k * k), (r - c) * (r + c) / (k * k)
    n, step = reduced_jacobi(k * omega * time, m, mc)
    sn, cn, dn = added((s, c, r / k), step, m)
    # start and step are each within half a turn of the half angle
    return 2 * (n * arb.pi() + arb.atan2(sn, cn)), 2 * k * omega * dn


def separatrix(omega, s, c, time):
    """Angle and rate through the bottom: the Gudermannian."""
    u = (s / c).asinh() + omega * time
    return 2 * u.sinh().atan(), 2 * omega / u.cosh()


def motion(form, length, gravity, angle, rate, time):
    """Angle and rate at a time, of a motion by its amplitude, by its release, or by its state."""
    omega = (gravity / length).sqrt()
    if form == "swinging":
        rate, angle = 2 * omega * (angle / 2).sin(), arb(0)
    turns, s, c = reduced(angle / 2)
    r = rate / (2 * omega)
    if rate < 0:
        s, r = -s, -r
    gap = c - r
    if gap > 0:
        value = libration(omega, s, c, r, time)
    elif gap < 0:
        value = rotation(omega, s, c, r, time)
    elif gap == 0:
        value = separatrix(omega, s, c, time)
    else:
        value = NAN, NAN
    x, v = (-value[0], -value[1]) if rate < 0 else value
    return [x + 2 * turns * arb.pi(), v]


def tension(form, length, gravity, angle, rate, time):
    """The rod's pull over the weight."""
    angle, rate = motion(form, length, gravity, angle, rate, time)
    return [angle.cos() + rate * rate * length / gravity]


class Start:
    """The state at the time 0, mirrored where needed so that the rate is not negative."""

    def __init__(self, form, length, gravity, angle, rate):
        self.omega = (gravity / length).sqrt()
        if form == "swinging":
            rate, angle = 2 * self.omega * (angle / 2).sin(), arb(0)
        self.sign = -1 if rate < 0 else 1
        self.turns, s, self.c = reduced(angle / 2)
        self.s, self.r = self.sign * s, self.sign * rate / (2 * self.omega)
        self.k = (self.s * self.s + self.r * self.r).sqrt()
        self.gap = (self.c - self.r) * (self.c + self.r)
        self.librates = bool(self.gap > 0)
        if self.librates:
            self.speed, self.cycle = self.omega, 4 * quarter_period(self.gap)
        else:
            self.speed = self.k * self.omega
            self.cycle = 2 * quarter_period(-self.gap / self.k**2)
        self.u = self.u_at(self.s, self.c, self.r)

    def u_at(self, s, c, r):
        """u = F on the way up, where the sine of half the angle is s, the cosine c: DLMF 19.25.5."""
        if self.librates:
            return s * rf(r * r, (self.k * c) ** 2, self.k**2)
        return s * rf(c * c, (r / self.k) ** 2, 1)

    def wait(self, u):
        """The time until u comes by, or in a libration a whole number of periods before."""
        way = u - self.u
        if self.librates:
            way -= (way / self.cycle).floor() * self.cycle
        return way / self.speed if way > 0 else NAN


def phase(form, length, gravity, angle, rate, time):
    """The part of the period since the bottom was passed as at the start."""
    start = Start(form, length, gravity, angle, rate)
    if start.gap.contains(0):
        return [NAN]
    periods = (start.u + start.speed * time) / start.cycle
    return [periods - periods.floor()]


def least(x, y):
    if x < y:
        return x
    return y if y < x else NAN


def time_to(form, length, gravity, angle, rate, target):
    """When an angle is reached first."""
    start = Start(form, length, gravity, angle, rate)
    turns, s, c = reduced(target / 2)
    s, turns = start.sign * s, start.sign * (turns - start.turns)
    r2 = c * c - start.gap
    u = start.u_at(s, c, r2.sqrt() if r2 > 0 else NAN)
    if start.gap.contains(0):
        return [NAN]
    if not start.librates:
        return [start.wait(u + turns * start.cycle)]
    if turns != 0:
        return [NAN]
    return [least(start.wait(u), start.wait(start.cycle / 2 - u))]


def slack(form, length, gravity, angle, rate):
    """The angle at which a string goes slack first, and when."""
    start = Start(form, length, gravity, angle, rate)
    s, c = ((1 + 4 * start.k**2) / 6).sqrt(), ((1 + 4 * start.gap) / 6).sqrt()
    half = arb.atan2(s, c)
    beyond = start.s - s
    if not (start.gap < arb("0.5") and start.gap > arb("-0.25")):
        return [NAN, NAN]
    if beyond.contains(0) or start.gap.contains(0):
        return [NAN, NAN]
    u = start.u_at(s, c, (c * c - start.gap).sqrt())
    side, turn = 1, 0
    if beyond > 0 and start.librates:
        side, u = -1, u + start.cycle / 2
    elif beyond > 0:
        turn, u = 1, u + start.cycle
    turns = start.turns + start.sign * turn
    return [2 * (turns * arb.pi() + start.sign * side * half), (u - start.u) / start.speed]


def excess(_, amplitude):
    """T/T_h - 1."""
    kc = (amplitude / 2).cos()
    return [1 / arb(1).agm(kc) - 1 if kc > 0 else NAN]


def amplitude(form, x):
    """The amplitude, from tan(theta0/2)^2 = m/mc."""
    if form == "excess" and x < arb(2) ** -16382:
        # of theta0^2/16 + 11 theta0^4/3072 + ... the second is less than a part x
        return [4 * x.sqrt() * (1 + arb(0, x.mid()))]
    m, mc = from_mean(1 / (x if form == "period" else 1 + x))
    return [2 * (m / mc).sqrt().atan()]


# The arguments.


def pendulum(dice):
    """Length and gravity as they will be rounded."""
    ways = [(1, mp.mpf("9.80665")), (1, 1), (dice.power(-7, 7), dice.power(-7, 7))]
    with mp.workprec(dice.bits):
        return [+mp.mpf(x) for x in dice.pick(*ways)]


def moment(dice, period):
    """A time within some periods, or up to a million of them, or next to a quarter of one."""
    way = dice.pick("within", "far", "quarters")
    if way == "within":
        return dice.uniform(-4, 4) * period
    if way == "far":
        return dice.sign() * dice.power(-10, mp.log(1e6, 2)) * period
    return dice.sign() * int(dice.power(0, mp.log(4e6, 2))) * period / 4 * dice.ulps()


def period_of(omega, k, gap):
    """Of a libration, or of two turns; the angle-independent part of it on the separatrix."""
    if gap == 0:
        return 4 / omega
    if gap > 0:
        return 2 * mp.pi / mp.agm(1, mp.sqrt(gap)) / omega
    return 2 * mp.pi / mp.agm(1, mp.sqrt(-gap) / k) / (k * omega)


def state(dice, regime, omega):
    """Angle and rate."""
    angle = dice.uniform(-mp.pi, mp.pi)
    if regime == "turned":
        angle += 2 * mp.pi * dice.pick(dice.integer(-5, 5), int(dice.power(3, 10)))
    with mp.workprec(dice.bits):
        angle = +angle
    top = 2 * omega * abs(mp.cos(angle / 2))
    if regime == "next-to-separatrix":
        return angle, dice.sign() * top * (1 + dice.sign() * dice.gap())
    if regime == "rotation":
        return angle, dice.sign() * (top + omega * dice.pick(dice.gap(), dice.power(-3, 7)))
    if regime == "separatrix":
        return mp.mpf(0), 2 * omega * dice.sign()
    if regime == "tiny":
        size = dice.power(mp.mpf(dice.lowest) * 2 / 3, -3)
        return size * dice.uniform(-1, 1), size * omega * dice.uniform(-1, 1)
    return angle, dice.uniform(-1.5, 1.5) * top


def swing(dice, regime):
    if regime == "towards-pi":
        return dice.sign() * (mp.pi - dice.power(3 - dice.bits, 0))
    if regime == "tiny":
        return dice.sign() * dice.power(mp.mpf(dice.lowest) * 2 / 3, -3)
    return dice.uniform(-mp.pi, mp.pi)


def motion_arguments(dice, regime, form):
    length, gravity = [mp.mpf(1), mp.mpf(4)] if regime == "separatrix" else pendulum(dice)
    omega = mp.sqrt(gravity / length)
    angle, rate = (swing(dice, regime), 0) if form != "started" else state(dice, regime, omega)
    with mp.workprec(dice.bits):
        angle, rate = +angle, +mp.mpf(rate)
    s, c, r = mp.sin(angle / 2), abs(mp.cos(angle / 2)), abs(rate) / (2 * omega)
    period = period_of(omega, mp.sqrt(s * s + r * r), (c - r) * (c + r))
    time = dice.uniform(-4, 4) * period if regime == "separatrix" else moment(dice, period)
    return [length, gravity, angle, rate, time]


def target_arguments(dice, regime, form):
    """A start, and an angle some way from it that the motion will reach."""
    length, gravity, angle, rate, _ = motion_arguments(dice, regime, form)
    omega = mp.sqrt(gravity / length)
    s, c, r = mp.sin(angle / 2), abs(mp.cos(angle / 2)), abs(rate) / (2 * omega)
    turns = mp.nint(angle / (2 * mp.pi))
    if c > r or regime == "next-to-separatrix":
        amplitude = 2 * mp.atan2(mp.sqrt(s * s + r * r), mp.sqrt(max(c * c - r * r, 0)))
        if form == "swinging":
            amplitude = angle
        size = dice.pick(dice.uniform(), 1 - dice.gap(), dice.power(-20, 0))
        target = 2 * mp.pi * turns * (form == "started") + dice.sign() * size * amplitude
    else:
        way = dice.pick(dice.uniform(0, 7), dice.uniform(0, 7), dice.power(3, 10))
        target = angle + mp.sign(rate) * way
    near = abs(target - (0 if form == "swinging" else angle))
    target = target if near > mp.mpf(2) ** (8 - dice.bits) * max(abs(angle), abs(target)) else angle / 3
    return [length, gravity, angle, rate, target]


def slack_arguments(dice, regime, form):
    """In a rotation from the top's energy to 5/4 of that, beyond which no string is slack."""
    if regime == "rotation":
        length, gravity = [mp.mpf(x) for x in pendulum(dice)]
        angle = dice.uniform(-mp.pi, mp.pi) + 2 * mp.pi * dice.pick(0, 0, dice.integer(-40, 40))
        k2 = 1 + dice.pick(dice.uniform(0, mp.mpf("0.25")), dice.gap() / 4)
        rate = dice.sign() * 2 * mp.sqrt(gravity / length * (k2 - mp.sin(angle / 2) ** 2))
        return [length, gravity, angle, rate]
    return motion_arguments(dice, regime, form)[:4]


def excess_arguments(dice, regime, _):
    if regime == "uniform":
        return [dice.uniform(-mp.pi, mp.pi)]
    if regime == "towards-pi":
        return [dice.sign() * (mp.pi - dice.power(2 - dice.bits, 0))]
    if regime == "subnormal":  # theta0^2/16
        return [dice.sign() * 4 * mp.sqrt(subnormal(dice))]
    return [dice.sign() * dice.power(mp.mpf(dice.lowest) / 2 + 4, -3)]


def amplitude_arguments(dice, regime, form):
    if regime == "tiny":
        x = dice.power(2 - dice.bits if form == "period" else dice.lowest, -3)
    elif regime == "subnormal":
        # a whole number of the last place there is
        x = int(dice.power(0, dice.bits - 1)) * mp.mpf(2) ** (dice.lowest - dice.bits + 1)
    elif regime == "long":
        x = dice.uniform(1, 2000 if dice.bits > 24 else 50)
    else:
        x = dice.uniform(0, 2)
    return [1 + x if form == "period" else x]


# The files.

SWINGS, EVERY = "swinging released", "swinging released started"
TOPICS = {
    "motion": ("motion_angle motion_rate", motion, motion_arguments, {
        "uniform": EVERY, "tiny": EVERY, "towards-pi": SWINGS, "turned": "started",
        "next-to-separatrix": "started", "rotation": "started", "separatrix": "started"}),
    "motion_tension": ("motion_tension", tension, motion_arguments, {
        "uniform": EVERY, "towards-pi": SWINGS, "turned": "started",
        "next-to-separatrix": "started", "rotation": "started", "separatrix": "started"}),
    "motion_phase": ("motion_phase", phase, motion_arguments, {
        "uniform": EVERY, "tiny": EVERY, "towards-pi": SWINGS, "turned": "started",
        "next-to-separatrix": "started", "rotation": "started"}),
    "motion_time": ("motion_time_to", time_to, target_arguments, {
        "uniform": EVERY, "tiny": EVERY, "towards-pi": SWINGS, "turned": "started",
        "next-to-separatrix": "started", "rotation": "started"}),
    "motion_slack": ("motion_slack_angle motion_slack_time", slack, slack_arguments, {
        "uniform": EVERY, "towards-pi": SWINGS, "next-to-separatrix": "started",
        "rotation": "started"}),
    "excess": ("period", excess, excess_arguments, {
        "uniform": "excess", "towards-pi": "excess", "tiny": "excess", "subnormal": "excess"}),
    "amplitude": ("amplitude_of", amplitude, amplitude_arguments, {
        "uniform": "excess period", "long": "excess period", "tiny": "excess period", "subnormal": "excess"}),
}
SHARES = {"motion": 4, "motion_tension": 32, "motion_phase": 32, "motion_time": 32, "motion_slack": 32}
