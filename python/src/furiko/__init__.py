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

from typing import TYPE_CHECKING, NoReturn

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


# SciPy's names, and what has their arguments and results here
_SCIPY = {
    "ellipk": ("m", "furiko.ellipk_m(m)"),
    "ellipkm1": ("p", "furiko.ellipk_mc(p)"),
    "ellipe": ("m", "furiko.ellipe_m(m)"),
    "ellipkinc": ("phi, m", "furiko.ellipf_m(phi, m)"),
    "ellipeinc": ("phi, m", "furiko.ellipeinc_m(phi, m)"),
    "ellipj": ("u, m", "furiko.jacobi_m(u, m), which gives sn, cn and dn; ph is furiko.jacobi_am_m(u, m)"),
    "elliprc": ("x, y", "furiko.carlson_rc(x, y)"),
    "elliprd": ("x, y, z", "furiko.carlson_rd(x, y, z)"),
    "elliprf": ("x, y, z", "furiko.carlson_rf(x, y, z)"),
    "elliprg": ("x, y, z", "furiko.carlson_rg(x, y, z)"),
    "elliprj": ("x, y, z, p", "furiko.carlson_rj(x, y, z, p)"),
}


if not TYPE_CHECKING:  # to type checkers every name would seem to be there

    def __getattr__(name: str) -> NoReturn:
        error = AttributeError(f"module 'furiko' has no attribute '{name}'")
        if name in _SCIPY:
            arguments, here = _SCIPY[name]
            error = AttributeError(f"{error}: SciPy's {name}({arguments}) is {here}")
            # With a name but no object, Python does not add a guess such as 'ellipj_k'.
            error.name = name
        raise error


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
