# SPDX-License-Identifier: MIT
"""The cascade by numba, RK4, in blocks whose inner loop can become vectors: TRANSIENT KEPT STEPS exact|fast"""
import math
import sys
import time

import numpy as np
from numba import njit, prange

B, W, BLOCK = 0.5, 2 / 3, 64
FAST = sys.argv[4] == "fast"


@njit(fastmath=FAST)
def rate(x, v, drive):
    return drive - B * v - math.sin(x)


@njit(fastmath=FAST)
def step(h, first, middle, last, drives, x, v):
    for i in range(x.size):
        a1 = rate(x[i], v[i], drives[i] * first)
        v2 = v[i] + h / 2 * a1
        a2 = rate(x[i] + h / 2 * v[i], v2, drives[i] * middle)
        v3 = v[i] + h / 2 * a2
        a3 = rate(x[i] + h / 2 * v2, v3, drives[i] * middle)
        v4 = v[i] + h * a3
        a4 = rate(x[i] + h * v3, v4, drives[i] * last)
        x[i] += h / 6 * (v[i] + 2 * (v2 + v3) + v4)
        v[i] += h / 6 * (a1 + 2 * (a2 + a3) + a4)


@njit(parallel=True, fastmath=FAST)
def section(drives, transient, kept, steps):
    points = np.empty((drives.size, kept, 2))
    wave = np.cos(np.pi * np.arange(2 * steps + 1) / steps)
    for block in prange((drives.size + BLOCK - 1) // BLOCK):
        mine = slice(block * BLOCK, min((block + 1) * BLOCK, drives.size))
        g = drives[mine]
        x, v = np.full(g.size, -np.pi / 2), np.zeros(g.size)
        for period in range(transient + kept):
            for j in range(0, 2 * steps, 2):
                step(2 * np.pi / W / steps, wave[j], wave[j + 1], wave[j + 2], g, x, v)
            for i in range(x.size):
                x[i] -= 2 * np.pi * round(x[i] / (2 * np.pi))
            if period >= transient:
                points[mine, period - transient, 0] = x
                points[mine, period - transient, 1] = v
    return points


transient, kept, steps = map(int, sys.argv[1:4])
drives = np.array(sys.stdin.read().split(), float)
section(drives[:BLOCK], 0, 1, steps)
start = time.perf_counter()
points = section(drives, transient, kept, steps)
print(time.perf_counter() - start, file=sys.stderr)
np.savetxt(sys.stdout, np.column_stack([np.repeat(drives, kept), points.reshape(-1, 2)]))
