# SPDX-License-Identifier: MIT
"""One modulus, many arguments."""

from typing import Any, Optional

from numpy.typing import ArrayLike

from ._functions import JacobiValues
from ._library import library
from ._routine import Out, Outs, Routine
from ._value import Value, constant

_jacobi = Routine("modulus_jacobi", ("u",), JacobiValues, heads=1)
_am = Routine("modulus_am", ("u",), heads=1)
_epsilon = Routine("modulus_epsilon", ("u",), heads=1)


class Modulus(Value):
    """A modulus made ready for many arguments, in float64: its quarter period and theta series are computed once.

    Made from one of `k`, `m` = k^2, `mc` = 1 - m, `alpha` (the modular angle in radians, k = sin(alpha)) or
    `amplitude` (of a pendulum's swing in radians, k = sin(amplitude/2)), by keyword; any finite number, also m < 0
    and m > 1. It does not change: share it among threads.

    Accuracy: `jacobi`, `am` and `epsilon` 5 ulp, next to zeros too; `ellipk`, `ellipe` and `nome` 1 ulp.

    >>> p = Modulus(m=0.75)
    >>> p.ellipk
    2.1565156474996434
    >>> p.jacobi(1.0).sn
    0.7826328478392893
    """

    __slots__ = ()
    _bytes = library.furiko_modulus_size()

    def __init__(
        self,
        *,
        k: Optional[float] = None,
        m: Optional[float] = None,
        mc: Optional[float] = None,
        alpha: Optional[float] = None,
        amplitude: Optional[float] = None,
    ):
        forms = {"k": k, "m": m, "mc": mc, "alpha": alpha, "amplitude": amplitude}
        given = {form: number for form, number in forms.items() if number is not None}
        if len(given) != 1:
            raise TypeError("Modulus takes one of k, m, mc, alpha and amplitude")
        self._fill(f"modulus_from_{next(iter(given))}", "Modulus", **given)

    k = constant("modulus_k", "The modulus k; NaN for m < 0.")
    m = constant("modulus_m", "The parameter m = k^2.")
    mc = constant("modulus_mc", "The complementary parameter 1 - m.")
    ellipk = constant("modulus_ellipk", "The complete integral K(m); NaN for m > 1.")
    ellipe = constant("modulus_ellipe", "The complete integral E(m); NaN for m > 1.")
    quarter_period = constant("modulus_quarter_period", "The real quarter period: K(m), for m > 1 K(1/m)/k.")
    nome = constant("modulus_nome", "The nome exp(-pi K'/K), negative for m < 0; NaN for m > 1.")

    def complement(self) -> "Modulus":
        """The modulus of 1 - m"""
        other = Modulus.__new__(Modulus)
        other._value = type(self._value)()
        library.furiko_modulus_complement(self._value, other._value)
        return other

    def jacobi(self, u: ArrayLike, *, out: Outs = None) -> JacobiValues:
        """sn, cn and dn of u, a number or an array; `out` is a tuple of three arrays."""
        return _jacobi(out, u, head=(self._value,))

    def am(self, u: ArrayLike, *, out: Out = None) -> Any:
        """The amplitude of u, a number or an array, continuous in u."""
        return _am(out, u, head=(self._value,))

    def epsilon(self, u: ArrayLike, *, out: Out = None) -> Any:
        """Jacobi's epsilon of u, a number or an array: the integral of dn^2 from 0 to u."""
        return _epsilon(out, u, head=(self._value,))

    def __repr__(self) -> str:
        return f"Modulus(m={self.m!r}, mc={self.mc!r})"
