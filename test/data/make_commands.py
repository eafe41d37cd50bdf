#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""What the program should print for numbers as people type them, by mpmath with 60 digits:

   python3 test/data/make_commands.py >test/data/session-commands.txt

A session as of session.sh: "$ ", the command, then its answer. Numbers are drawn by a seed, and
each answer is the correctly rounded one: digits that are printed are to be right.
"""
import random

from mpmath import mp, mpf

mp.dps = 60
DICE = random.Random(2005)
GRAVITY = mpf("9.80665")


def significant(x, count):
    """x to so many digits, without an exponent where that lies from -5 to count - 1"""
    if x == 0:
        return "0." + "0" * (count - 1)
    sign, x = ("-", -x) if x < 0 else ("", x)
    power = int(mp.floor(mp.log10(x)))
    whole = int(mp.nint(x * mpf(10) ** (count - 1 - power)))
    if whole == 10**count:
        whole, power = 10 ** (count - 1), power + 1
    digits = str(whole)
    if -5 <= power < 0:
        return sign + "0." + "0" * (-power - 1) + digits
    if 0 <= power < count:
        return sign + (digits[: power + 1] + "." + digits[power + 1 :]).rstrip(".")
    return f"{sign}{digits[0]}.{digits[1:]}e{power}"


def places(x, count):
    whole = int(mp.nint(abs(x) * mpf(10) ** count))
    text = str(whole).rjust(count + 1, "0")
    return ("-" if x < 0 and whole else "") + text[:-count] + "." + text[-count:]


def decimal(low, high, count):
    """A number as typed, between two"""
    return f"{DICE.uniform(low, high):.{count}f}"


def ratio(amplitude):
    return 2 * mp.ellipk(mp.sin(amplitude / 2) ** 2) / mp.pi


def series(amplitude, terms):
    m = mp.sin(amplitude / 2) ** 2
    return mp.fsum((mp.binomial(2 * n, n) / mpf(4) ** n) ** 2 * m**n for n in range(terms))


def amplitude_of(slower):
    """The amplitude of an excess, by the modulus' complement: it may be next to 180 degrees"""
    start = mp.sqrt(16 * slower) if slower < 0.1 else None
    if start is None:
        kc = mp.findroot(lambda x: mp.ellipk(1 - x * x) * 2 / mp.pi - 1 - slower, mpf("0.5"), tol=1e-50) \
            if slower < 2 else mp.exp(mp.findroot(
                lambda x: mp.ellipk(1 - mp.exp(2 * x)) * 2 / mp.pi - 1 - slower,
                mp.log(4) - (1 + slower) * mp.pi / 2, tol=1e-50))
        return 2 * mp.acos(kc)
    return mp.findroot(lambda x: (ratio(x) - 1) / slower - 1, start, tol=1e-50)


def say(command, *lines):
    print("$ furiko " + command)
    for line in lines:
        print(line)


def periods():
    amplitudes = [decimal(0, 180, DICE.randint(1, 9)) for _ in range(60)]
    amplitudes += ["0.001", "1", "30", "60", "90", "120", "150", "179", "179.9", "179.999999999"]
    length, gravity = decimal(0.1, 3, 3), decimal(1, 20, 4)
    rows = []
    for word in amplitudes:
        amplitude = mp.radians(mpf(word))
        t = ratio(amplitude)
        period = 2 * mp.pi * mp.sqrt(mpf(length) / mpf(gravity)) * t
        rows.append(",".join([places(mpf(word), 12), significant(period, 15), places(t, 15),
                              significant(100 * (t - 1), 12), significant(series(amplitude, 3), 12)]))
    say(f"period {' '.join(amplitudes)} --terms 3 --length {length} --gravity {gravity} --format csv",
        "amplitude_deg,period_s,period_ratio,slower_percent,series", *rows)


def amplitudes():
    for word in [decimal(0.1, 60, 3) for _ in range(20)] + ["3", "0.001", "0.000001", "1000"]:
        slower = mpf(word) / 100
        amplitude = amplitude_of(slower)
        say(f"amplitude --slower {word}% --format csv | cut -d , -f 1,2", "amplitude_deg,amplitude_rad",
            significant(mp.degrees(amplitude), 12) + "," + significant(amplitude, 12))


def drifts():
    for word in [decimal(0.1, 179, 3) for _ in range(20)] + ["0.01", "179.999999"]:
        off, length = decimal(0.01, 2, 3), decimal(0.1, 3, 3)
        slower = ratio(mp.radians(mpf(word))) - 1
        swings = mpf(off) / slower
        time = swings * (1 + slower) * 2 * mp.pi * mp.sqrt(mpf(length) / GRAVITY)
        say(f"drift --amplitude {word} --off {off} --length {length} --format csv | tail -n 1",
            ",".join(significant(x, 12) for x in (mpf(word), 100 * slower, swings, time)))


def perimeters():
    axes = [(decimal(0.1, 100, 4), decimal(0.001, 100, 5)) for _ in range(20)]
    for a, b in axes + [("2", "1"), ("1e-5", "1"), ("1e300", "1e290"), ("1", "1")]:
        m = 1 - (mpf(b) / mpf(a)) ** 2
        say(f"perimeter {a} {b} --format csv | tail -n 1", significant(4 * mpf(a) * mp.ellipe(m), 16))


def arcs():
    for _ in range(20):
        a, b, start, end = decimal(0.1, 100, 4), decimal(0.1, 100, 5), decimal(-90, 90, 2), decimal(91, 900, 2)
        arc = mpf(b) * (mp.ellipe(mp.radians(mpf(end)), 1 - (mpf(a) / mpf(b)) ** 2)
                        - mp.ellipe(mp.radians(mpf(start)), 1 - (mpf(a) / mpf(b)) ** 2))
        say(f"arc {a} {b} --from {start} --to {end} --format csv | tail -n 1",
            ",".join([significant(mpf(start), 12), significant(mpf(end), 12), significant(arc, 12)]))


def times():
    for _ in range(30):
        release, at = decimal(5, 179, 2), decimal(-4.9, 4.9, 3)
        k = mp.sin(mp.radians(mpf(release)) / 2)
        omega = mp.sqrt(GRAVITY)
        s = mp.sin(mp.radians(mpf(at)) / 2) / k
        time = (mp.ellipk(k * k) - mp.ellipf(mp.asin(s), k * k)) / omega
        say(f"time --release {release} --at {at} --format csv | tail -n 1 | cut -d , -f 1,2",
            significant(mpf(at), 12) + "," + significant(time, 12))


def motions():
    for _ in range(6):
        amplitude, length, gravity = decimal(5, 179, 1), decimal(0.1, 3, 2), decimal(1, 20, 2)
        k = mp.sin(mp.radians(mpf(amplitude)) / 2)
        omega = mp.sqrt(mpf(gravity) / mpf(length))
        rows = []
        for i in range(40):
            t = mpf(i) * mpf("0.07")
            sn, cn = (mp.ellipfun(name, omega * t, k=k) for name in ("sn", "cn"))
            rows.append(",".join(places(x, 12) for x in (t, 2 * mp.asin(k * sn), 2 * k * omega * cn)))
        say(f"motion --amplitude {amplitude} --length {length} --gravity {gravity} --to 2.73 --step 0.07 "
            "--columns time,angle,rate --format csv", "time_s,angle_rad,rate_rad_s", *rows)


def main():
    for part in (periods, amplitudes, drifts, perimeters, arcs, times, motions):
        part()


if __name__ == "__main__":
    main()
