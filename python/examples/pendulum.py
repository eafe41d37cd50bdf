# SPDX-License-Identifier: MIT
"""Three calculations with furiko, as cells for Jupyter, Spyder or VS Code, or at once: python pendulum.py [--plot]

Figures need matplotlib.
"""

# %% The period against the amplitude
import sys

import numpy as np

import furiko

degrees = np.array([1, 10, 30, 60, 90, 120, 150, 170, 179, 179.9])
amplitudes = np.radians(degrees)
ratios = furiko.period_ratio(amplitudes)
for angle, ratio in zip(degrees, ratios):
    print(f"{angle:6.1f} degrees: T/T_h = {ratio:.12f}")
# The small-angle series, 1 + a^2/16 + 11 a^4/3072, is good for small swings only.
series = 1 + amplitudes**2 / 16 + 11 * amplitudes**4 / 3072
assert np.all(np.abs(series / ratios - 1)[:3] < 1e-4)
assert series[-1] < ratios[-1] / 2.5
# How far may it swing to be 3 percent slow?
slow = np.degrees(furiko.amplitude_of_excess(0.03))
print(f"3 percent slow at {slow:.3f} degrees")
assert round(slow, 3) == 39.159

# %% The motion let go at 179.9 degrees
path = furiko.Pendulum(length=1.0).released(angle=np.radians(179.9))
times = np.linspace(0, path.period, 2001)
angles = path.angle(times)
near_top = np.mean(np.abs(angles) > np.radians(150))
print(f"the period is {path.period:.6f} s, of which {near_top:.0%} go by within 30 degrees of the top")
# Half a period later it is on the other side, and the energy is what it was.
assert abs(angles[1000] + angles[0]) < 1e-12
energies = path.rate(times) ** 2 / 2 - 9.80665 * np.cos(angles)
assert np.ptp(energies) < 1e-13 * abs(path.energy) * 100
# Runge-Kutta steps of the same pendulum, down to the bottom: 16 times less error for half the step
errors = []
for steps in (250, 500):
    state = furiko.pendulum_rk4(9.80665, path.period / 4 / steps, steps, angles[0], 0.0)
    errors.append(abs(state.angle))
    print(f"{steps} steps of RK4 err by {errors[-1]:.1e} rad after a quarter of the period")
assert 12 < errors[0] / errors[1] < 20

# %% The mutual inductance of two coaxial loops
# Maxwell: M/mu_0 = sqrt(a b) ((2/k - k) K - (2/k) E), k^2 = 4 a b/((a + b)^2 + d^2). The farther apart, the nearer to
# each other are its two terms; sqrt(a b) k^3 S, which is the same, loses nothing.
a, b = 0.1, 0.05
distances = np.array([0.0, 0.05, 0.2, 1.0, 10.0])
m = 4 * a * b / ((a + b) ** 2 + distances**2)
k = np.sqrt(m)
inductance = 4e-7 * np.pi * np.sqrt(a * b) * k**3 * furiko.ellips_m(m)
maxwell = 4e-7 * np.pi * np.sqrt(a * b) * ((2 / k - k) * furiko.ellipk_m(m) - 2 / k * furiko.ellipe_m(m))
# Neumann's integral by the trapezoidal rule, which for a periodic function errs by less than any power of the step
angle = np.linspace(0, 2 * np.pi, 400, endpoint=False)
apart = np.sqrt(a**2 + b**2 + distances[:, None] ** 2 - 2 * a * b * np.cos(angle))
neumann = 4e-7 * np.pi * a * b / 2 * np.sum(np.cos(angle) / apart, axis=1) * (angle[1] - angle[0])
for distance, mutual, by_k_and_e in zip(distances, inductance, maxwell):
    print(f"{distance:5.2f} m apart: {mutual:.10e} H; by K and E {by_k_and_e:.10e} H")
assert np.allclose(inductance[:3], neumann[:3], rtol=1e-13, atol=0)
# Two dipoles
assert np.isclose(inductance[-1], 2e-7 * np.pi**2 * (a * b) ** 2 / distances[-1] ** 3, rtol=1e-3, atol=0)

# %% Figures, where they are asked for
if "--plot" in sys.argv:
    import matplotlib.pyplot as plt

    figure, (left, right) = plt.subplots(1, 2, figsize=(10, 4))
    fine = np.linspace(0, 179.9, 500)
    left.plot(fine, furiko.period_ratio(np.radians(fine)))
    left.set(xlabel="amplitude / degrees", ylabel="T/T_h")
    right.plot(times, np.degrees(angles))
    right.set(xlabel="time / s", ylabel="angle / degrees")
    figure.savefig("pendulum.svg")
