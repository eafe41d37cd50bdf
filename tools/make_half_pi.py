#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Writes furiko_two_over_pi.inc and furiko_half_pi_{sp,dp,qp}.inc beside the sources (mpmath, fixed output)."""
import os
import sys
import mpmath as mp

here = sys.argv[1] if len(sys.argv) > 1 else os.path.join(os.path.dirname(__file__), '..', 'src', 'integrals')
mp.mp.prec = 18000
count = 712          # 24 bits each: exponents of real128, its bits, and the guard
x = 2/mp.pi
digits = []
for _ in range(count):
    x *= 2**24
    d = int(mp.floor(x))
    digits.append(d)
    x -= d
with open(os.path.join(here, 'furiko_two_over_pi.inc'), 'w') as f:
    f.write('   ! 2/pi in base 2**24, written by generate_half_pi.py\n')
    f.write('   integer, parameter :: two_over_pi(%d) = [ &\n' % count)
    for i in range(0, count, 8):
        f.write('      ' + ', '.join('%d' % d for d in digits[i:i + 8]) + (', &\n' if i + 8 < count else ']\n'))
for kind, bits, show in (('sp', 12, 20), ('dp', 26, 30), ('qp', 49, 50)):
    x = mp.pi/2
    with open(os.path.join(here, 'furiko_half_pi_%s.inc' % kind), 'w') as f:
        f.write('   ! pi/2 in parts of %d bits, written by generate_half_pi.py\n' % bits)
        f.write('   real(wp), parameter :: half_pi(6) = [ &\n')
        for i in range(6):
            e = int(mp.floor(mp.log(x, 2))) + 1
            p = mp.floor(mp.ldexp(x, bits - e))
            p = mp.ldexp(p, e - bits)
            x -= p
            f.write('      ' + mp.nstr(p, show, min_fixed=1, max_fixed=0).replace('e', 'e') + '_wp' +
                    (', &\n' if i < 5 else ']\n'))
