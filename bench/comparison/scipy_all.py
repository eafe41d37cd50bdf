# SPDX-License-Identifier: MIT
"""The cascade by SciPy, all members as one system: TRANSIENT KEPT TOLERANCE"""
import sys
import time

import numpy as np
from scipy.integrate import solve_ivp

B, W = 0.5, 2 / 3
PERIOD = 2 * np.pi / W
transient, kept, tolerance = int(sys.argv[1]), int(sys.argv[2]), float(sys.argv[3])


def rates(t, y):
    x, v = y.reshape(2, -1)
    return np.concatenate([v, -B * v - np.sin(x) + drives * np.cos(W * t)])


drives = np.array(sys.stdin.read().split(), float)
start = time.perf_counter()
y, points = np.repeat([-np.pi / 2, 0.0], drives.size), []
for _ in range(transient + kept):
    y = solve_ivp(rates, (0, PERIOD), y, "DOP853", rtol=tolerance, atol=tolerance).y[:, -1]
    points.append(y.reshape(2, -1).T)
print(time.perf_counter() - start, file=sys.stderr)
points = np.array(points[transient:]).transpose(1, 0, 2)
points[:, :, 0] = np.remainder(points[:, :, 0] + np.pi, 2 * np.pi) - np.pi
np.savetxt(sys.stdout, np.column_stack([np.repeat(drives, kept), points.reshape(-1, 2)]))
