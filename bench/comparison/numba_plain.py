# SPDX-License-Identifier: MIT
"""The cascade by numba as one writes it, RK4, threads share the members: TRANSIENT KEPT STEPS exact|fast"""
import math
import sys
import time

import numpy as np
from numba import njit, prange

B, W = 0.5, 2 / 3
FAST = sys.argv[4] == "fast"


@njit(fastmath=FAST)
def rate(x, v, drive):
    return drive - B * v - math.sin(x)


@njit(parallel=True, fastmath=FAST)
def section(drives, transient, kept, steps):
    points = np.empty((drives.size, kept, 2))
    wave = np.cos(np.pi * np.arange(2 * steps + 1) / steps)
    h = 2 * np.pi / W / steps
    for i in prange(drives.size):
        g, x, v = drives[i], -np.pi / 2, 0.0
        for period in range(transient + kept):
            for j in range(0, 2 * steps, 2):
                a1 = rate(x, v, g * wave[j])
                v2 = v + h / 2 * a1
                a2 = rate(x + h / 2 * v, v2, g * wave[j + 1])
                v3 = v + h / 2 * a2
                a3 = rate(x + h / 2 * v2, v3, g * wave[j + 1])
                v4 = v + h * a3
                a4 = rate(x + h * v3, v4, g * wave[j + 2])
                x += h / 6 * (v + 2 * (v2 + v3) + v4)
                v += h / 6 * (a1 + 2 * (a2 + a3) + a4)
            x -= 2 * np.pi * round(x / (2 * np.pi))
            if period >= transient:
                points[i, period - transient] = x, v
    return points


transient, kept, steps = map(int, sys.argv[1:4])
drives = np.array(sys.stdin.read().split(), float)
section(drives[:1], 0, 1, steps)
start = time.perf_counter()
points = section(drives, transient, kept, steps)
print(time.perf_counter() - start, file=sys.stderr)
np.savetxt(sys.stdout, np.column_stack([np.repeat(drives, kept), points.reshape(-1, 2)]))
