# SPDX-License-Identifier: MIT
"""The cascade by SciPy, one orbit after another, as DynamicalSystems.jl does it: TRANSIENT KEPT TOLERANCE"""
import os
import sys
import time
from multiprocessing import Pool

import numpy as np
from scipy.integrate import solve_ivp

B, W = 0.5, 2 / 3
PERIOD = 2 * np.pi / W
transient, kept, tolerance = int(sys.argv[1]), int(sys.argv[2]), float(sys.argv[3])


def rates(t, y, g):
    return [y[1], -B * y[1] - np.sin(y[0]) + g * np.cos(W * t)]


def section(g):
    y, points = [-np.pi / 2, 0.0], []
    for _ in range(transient + kept):
        y = solve_ivp(rates, (0, PERIOD), y, "DOP853", args=(g,), rtol=tolerance, atol=tolerance).y[:, -1]
        points.append(y)
    return points[transient:]


drives = np.array(sys.stdin.read().split(), float)
start = time.perf_counter()
with Pool(int(os.environ["THREADS"])) as pool:
    points = np.array(pool.map(section, drives, chunksize=1))
print(time.perf_counter() - start, file=sys.stderr)
points[:, :, 0] = np.remainder(points[:, :, 0] + np.pi, 2 * np.pi) - np.pi
np.savetxt(sys.stdout, np.column_stack([np.repeat(drives, kept), points.reshape(-1, 2)]))
