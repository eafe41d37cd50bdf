# SPDX-License-Identifier: MIT
"""Elliptic integrals, Jacobi elliptic functions and the exact motion of the pendulum, by the Fortran library furiko.

The functions take numbers and arrays, which are broadcast as by NumPy's ufuncs. Their names tell the form of the
modulus: `_k` takes the modulus k, `_m` the parameter m = k^2, `_mc` the complementary parameter 1 - m, `_alpha` the
modular angle. Angles are in radians; n has DLMF's sign. Nothing raises an error for its value: where a function has
none the result is NaN, at a pole it is infinite.

>>> import furiko
>>> furiko.ellipk_m(0.25)
1.685750354812596
>>> furiko.Pendulum(length=0.25).released(angle=1.0).period
1.0697514696687809
"""

from . import _functions
from ._functions import *  # noqa: F403 - the names of the catalogue
from ._library import library as _library
from ._modulus import Modulus
from ._motion import Motion, Pendulum
from ._steps import Coordinates, State, forest_ruth, pendulum_forest_ruth, pendulum_rk4, pendulum_verlet, rk4, verlet
from ._version import __version__


def selftest() -> int:
    """How many of a hundred known values come out wrong in this build of the library: 0, or something is amiss."""
    return _library.furiko_selftest()


__all__ = [
    *_functions.__all__,
    "Coordinates",
    "Modulus",
    "Motion",
    "Pendulum",
    "State",
    "__version__",
    "forest_ruth",
    "pendulum_forest_ruth",
    "pendulum_rk4",
    "pendulum_verlet",
    "rk4",
    "selftest",
    "verlet",
]
