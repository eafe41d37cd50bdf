# SPDX-License-Identifier: MIT
"""The cascade by numba, order 8 with SciPy's coefficients, in blocks: TRANSIENT KEPT STEPS exact|fast"""
import math
import sys
import time

import numpy as np
from numba import njit, prange
from scipy.integrate._ivp import dop853_coefficients as dop853

B, W, BLOCK = 0.5, 2 / 3, 64
FAST = sys.argv[4] == "fast"
TO, AT = np.vstack([dop853.A[:12, :12], dop853.B]), dop853.C[:12]
STAGES = AT.size


@njit(fastmath=FAST)
def reach(stage, x, v, rates, speeds, y, w):
    y[:] = x
    w[:] = v
    for r in range(stage):
        if TO[stage, r] != 0:
            for i in range(x.size):
                y[i] += TO[stage, r] * speeds[r, i]
                w[i] += TO[stage, r] * rates[r, i]


@njit(fastmath=FAST)
def block(drives, transient, steps, points):
    h = 2 * np.pi / W / steps
    x, v = np.full(drives.size, -np.pi / 2), np.zeros(drives.size)
    y, w = np.empty(drives.size), np.empty(drives.size)
    rates, speeds = np.empty((STAGES, drives.size)), np.empty((STAGES, drives.size))
    for period in range(transient + points.shape[1]):
        for j in range(steps):
            for stage in range(STAGES):
                reach(stage, x, v, rates, speeds, y, w)
                wave = math.cos(2 * np.pi * (j + AT[stage]) / steps)
                for i in range(x.size):
                    speeds[stage, i] = h * w[i]
                    rates[stage, i] = h * (drives[i] * wave - B * w[i] - math.sin(y[i]))
            reach(STAGES, x, v, rates, speeds, y, w)
            x, v, y, w = y, w, x, v
        for i in range(x.size):
            x[i] -= 2 * np.pi * round(x[i] / (2 * np.pi))
        if period >= transient:
            points[:, period - transient, 0] = x
            points[:, period - transient, 1] = v


@njit(parallel=True)
def section(drives, transient, kept, steps):
    points = np.empty((drives.size, kept, 2))
    for i in prange((drives.size + BLOCK - 1) // BLOCK):
        block(drives[i * BLOCK:(i + 1) * BLOCK], transient, steps, points[i * BLOCK:(i + 1) * BLOCK])
    return points


transient, kept, steps = map(int, sys.argv[1:4])
drives = np.array(sys.stdin.read().split(), float)
section(drives[:BLOCK], 0, 1, steps)
start = time.perf_counter()
points = section(drives, transient, kept, steps)
print(time.perf_counter() - start, file=sys.stderr)
np.savetxt(sys.stdout, np.column_stack([np.repeat(drives, kept), points.reshape(-1, 2)]))
