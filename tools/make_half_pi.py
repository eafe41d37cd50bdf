#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Writes furiko_two_over_pi.inc and furiko_{half_pi,log_two}_{sp,dp,qp}.inc beside the sources (mpmath, fixed
output)."""
import os
import sys
import mpmath as mp

here = sys.argv[1] if len(sys.argv) > 1 else os.path.join(os.path.dirname(__file__), '..', 'src', 'arithmetic')
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
    f.write('   ! 2/pi in base 2**24, written by make_half_pi.py\n')
    f.write('   integer, parameter :: two_over_pi(%d) = [ &\n' % count)
    for i in range(0, count, 8):
        f.write('      ' + ', '.join('%d' % d for d in digits[i:i + 8]) + (', &\n' if i + 8 < count else ']\n'))
for name, title, number in (('half_pi', 'pi/2', mp.pi/2), ('log_two', 'ln 2', mp.log(2))):
    for kind, bits, show in (('sp', 12, 20), ('dp', 26, 30), ('qp', 49, 50)):
        x = number
        with open(os.path.join(here, 'furiko_%s_%s.inc' % (name, kind)), 'w') as f:
            f.write('   ! %s in parts of %d bits, written by make_half_pi.py\n' % (title, bits))
            f.write('   real(wp), parameter :: %s(6) = [ &\n' % name)
            for i in range(6):
                e = int(mp.floor(mp.log(x, 2))) + 1
                p = mp.floor(mp.ldexp(x, bits - e))
                p = mp.ldexp(p, e - bits)
                x -= p
                f.write('      ' + mp.nstr(p, show, min_fixed=1, max_fixed=0).replace('e', 'e') + '_wp' +
                        (', &\n' if i < 5 else ']\n'))
