# SPDX-License-Identifier: MIT
# Written by tools/make_python.py.
"""The functions of the catalogue, each with what it is, its range, special values and accuracy."""

from typing import Any, NamedTuple

from numpy.typing import ArrayLike

from ._routine import Out, Outs, Routine

__all__ = [
    "EllipkeValues",
    "JacobiValues",
    "agm",
    "ellipk_k",
    "ellipk_m",
    "ellipk_mc",
    "ellipk_alpha",
    "ellipe_k",
    "ellipe_m",
    "ellipe_mc",
    "ellipe_alpha",
    "ellipb_k",
    "ellipb_m",
    "ellipb_mc",
    "ellipb_alpha",
    "ellipd_k",
    "ellipd_m",
    "ellipd_mc",
    "ellipd_alpha",
    "ellipke_k",
    "ellipke_m",
    "ellipke_mc",
    "ellipke_alpha",
    "ellips_k",
    "ellips_m",
    "ellips_mc",
    "ellipf_k",
    "ellipf_m",
    "ellipf_mc",
    "ellipeinc_k",
    "ellipeinc_m",
    "ellipeinc_mc",
    "ellipdinc_k",
    "ellipdinc_m",
    "ellipdinc_mc",
    "ellippi_k",
    "ellippi_m",
    "ellippi_mc",
    "ellippiinc_k",
    "ellippiinc_m",
    "ellippiinc_mc",
    "ellipj_k",
    "ellipj_m",
    "ellipj_mc",
    "ellipjinc_k",
    "ellipjinc_m",
    "ellipjinc_mc",
    "bulirsch_cel",
    "carlson_rf",
    "carlson_rc",
    "carlson_rd",
    "carlson_rj",
    "carlson_rg",
    "nome_k",
    "nome_m",
    "nome_mc",
    "parameter_from_nome",
    "complementary_parameter_from_nome",
    "theta1",
    "theta2",
    "theta3",
    "theta4",
    "theta1_prime",
    "theta2_prime",
    "theta3_prime",
    "theta4_prime",
    "jacobi_k",
    "jacobi_m",
    "jacobi_mc",
    "jacobi_am_k",
    "jacobi_am_m",
    "jacobi_am_mc",
    "jacobi_sn_k",
    "jacobi_sn_m",
    "jacobi_sn_mc",
    "jacobi_cn_k",
    "jacobi_cn_m",
    "jacobi_cn_mc",
    "jacobi_dn_k",
    "jacobi_dn_m",
    "jacobi_dn_mc",
    "jacobi_ns_k",
    "jacobi_ns_m",
    "jacobi_ns_mc",
    "jacobi_nc_k",
    "jacobi_nc_m",
    "jacobi_nc_mc",
    "jacobi_nd_k",
    "jacobi_nd_m",
    "jacobi_nd_mc",
    "jacobi_sc_k",
    "jacobi_sc_m",
    "jacobi_sc_mc",
    "jacobi_cs_k",
    "jacobi_cs_m",
    "jacobi_cs_mc",
    "jacobi_sd_k",
    "jacobi_sd_m",
    "jacobi_sd_mc",
    "jacobi_ds_k",
    "jacobi_ds_m",
    "jacobi_ds_mc",
    "jacobi_cd_k",
    "jacobi_cd_m",
    "jacobi_cd_mc",
    "jacobi_dc_k",
    "jacobi_dc_m",
    "jacobi_dc_mc",
    "jacobi_epsilon_k",
    "jacobi_epsilon_m",
    "jacobi_epsilon_mc",
    "jacobi_arcsn_k",
    "jacobi_arcsn_m",
    "jacobi_arcsn_mc",
    "jacobi_arccn_k",
    "jacobi_arccn_m",
    "jacobi_arccn_mc",
    "jacobi_arcdn_k",
    "jacobi_arcdn_m",
    "jacobi_arcdn_mc",
    "jacobi_arcns_k",
    "jacobi_arcns_m",
    "jacobi_arcns_mc",
    "jacobi_arcnc_k",
    "jacobi_arcnc_m",
    "jacobi_arcnc_mc",
    "jacobi_arcnd_k",
    "jacobi_arcnd_m",
    "jacobi_arcnd_mc",
    "jacobi_arcsc_k",
    "jacobi_arcsc_m",
    "jacobi_arcsc_mc",
    "jacobi_arccs_k",
    "jacobi_arccs_m",
    "jacobi_arccs_mc",
    "jacobi_arcsd_k",
    "jacobi_arcsd_m",
    "jacobi_arcsd_mc",
    "jacobi_arcds_k",
    "jacobi_arcds_m",
    "jacobi_arcds_mc",
    "jacobi_arccd_k",
    "jacobi_arccd_m",
    "jacobi_arccd_mc",
    "jacobi_arcdc_k",
    "jacobi_arcdc_m",
    "jacobi_arcdc_mc",
    "parameter_from_ellipk",
    "complementary_parameter_from_ellipk",
    "parameter_from_period_ratio",
    "complementary_parameter_from_period_ratio",
    "ellipeinc_inverse_k",
    "ellipeinc_inverse_m",
    "ellipeinc_inverse_mc",
    "jacobi_zeta_k",
    "jacobi_zeta_m",
    "jacobi_zeta_mc",
    "heuman_lambda_k",
    "heuman_lambda_m",
    "heuman_lambda_mc",
    "period_ratio",
    "period_excess",
    "amplitude_of_period",
    "amplitude_of_excess",
    "amplitude_three_terms",
    "ellipse_perimeter",
]


class EllipkeValues(NamedTuple):
    """K and E together."""

    K: Any
    E: Any


class JacobiValues(NamedTuple):
    """The Jacobi elliptic functions sn, cn and dn."""

    sn: Any
    cn: Any
    dn: Any


_agm = Routine("agm", ("a", "b"), None)


def agm(a: ArrayLike, b: ArrayLike, *, out: Out = None) -> Any:
    r"""Arithmetic-geometric mean M(a, b): the common limit of

    .. math:: a_{n+1} = (a_n + b_n)/2, \quad b_{n+1} = \sqrt{a_n b_n}, \quad a_0 = a,\ b_0 = b.

    Arguments: a and b of one sign, any magnitude; M is symmetric and homogeneous, M(-a, -b) = -M(a,
    b), and neither overflows nor underflows before its arguments do.

    Special cases: M(a, a) = a; M(a, 0) = 0; M(a, Inf) = Inf for a > 0; M(0, Inf), arguments of
    opposite sign and NaN give NaN.

    Accuracy: 1 ulp.

    Source: DLMF 19.8.1, https://dlmf.nist.gov/19.8.i

    Parameters
    ----------
    a : array_like
        first number
    b : array_like
        second number
    out : ndarray, optional
        where the result goes

    Returns
    -------
    float or ndarray
        M
    """
    if type(a) is float and type(b) is float and out is None:
        return _agm.one(a, b)
    return _agm(out, a, b)


_ellipk_k = Routine("ellipk_k", ("k",), None)


def ellipk_k(k: ArrayLike, *, out: Out = None) -> Any:
    r"""Complete elliptic integral of the first kind, of the modulus k, `abs(k) <= 1`, m = k^2.

    .. math:: K(m) = \int_0^{\pi/2} \frac{d\theta}{\sqrt{1 - m \sin^2\theta}}

    K = pi/2 at m = 0, +Inf at m = 1, 0 at m = -Inf; NaN outside, NaN in gives NaN out. Of an angle
    it is finite at the `pi/2` of the kind. Correctly rounded in float32, 0.5001 ulp of an angle;
    error at most 0.55 ulp (float64).

    Definition: DLMF 19.2.8.

    Parameters
    ----------
    k : array_like
        modulus, m = k^2
    out : ndarray, optional
        where the result goes

    Returns
    -------
    float or ndarray
        K
    """
    if type(k) is float and out is None:
        return _ellipk_k.one(k)
    return _ellipk_k(out, k)


_ellipk_m = Routine("ellipk_m", ("m",), None)


def ellipk_m(m: ArrayLike, *, out: Out = None) -> Any:
    r"""Complete elliptic integral of the first kind, of the parameter m = k^2, `m <= 1`.

    .. math:: K(m) = \int_0^{\pi/2} \frac{d\theta}{\sqrt{1 - m \sin^2\theta}}

    K = pi/2 at m = 0, +Inf at m = 1, 0 at m = -Inf; NaN outside, NaN in gives NaN out. Of an angle
    it is finite at the `pi/2` of the kind. Correctly rounded in float32, 0.5001 ulp of an angle;
    error at most 0.55 ulp (float64).

    Definition: DLMF 19.2.8.

    Parameters
    ----------
    m : array_like
        parameter, m = k^2
    out : ndarray, optional
        where the result goes

    Returns
    -------
    float or ndarray
        K
    """
    if type(m) is float and out is None:
        return _ellipk_m.one(m)
    return _ellipk_m(out, m)


_ellipk_mc = Routine("ellipk_mc", ("mc",), None)


def ellipk_mc(mc: ArrayLike, *, out: Out = None) -> Any:
    r"""Complete elliptic integral of the first kind, of the complementary parameter mc = 1 - m, `mc >=
    0`.

    .. math:: K(m) = \int_0^{\pi/2} \frac{d\theta}{\sqrt{1 - m \sin^2\theta}}

    K = pi/2 at m = 0, +Inf at m = 1, 0 at m = -Inf; NaN outside, NaN in gives NaN out. Of an angle
    it is finite at the `pi/2` of the kind. Correctly rounded in float32, 0.5001 ulp of an angle;
    error at most 0.55 ulp (float64).

    Definition: DLMF 19.2.8.

    Parameters
    ----------
    mc : array_like
        complementary parameter 1 - m
    out : ndarray, optional
        where the result goes

    Returns
    -------
    float or ndarray
        K
    """
    if type(mc) is float and out is None:
        return _ellipk_mc.one(mc)
    return _ellipk_mc(out, mc)


_ellipk_alpha = Routine("ellipk_alpha", ("alpha",), None)


def ellipk_alpha(alpha: ArrayLike, *, out: Out = None) -> Any:
    r"""Complete elliptic integral of the first kind, of the modular angle alpha in radians, k =
    sin(alpha), `abs(alpha) <= pi/2`.

    .. math:: K(m) = \int_0^{\pi/2} \frac{d\theta}{\sqrt{1 - m \sin^2\theta}}

    K = pi/2 at m = 0, +Inf at m = 1, 0 at m = -Inf; NaN outside, NaN in gives NaN out. Of an angle
    it is finite at the `pi/2` of the kind. Correctly rounded in float32, 0.5001 ulp of an angle;
    error at most 0.55 ulp (float64).

    Definition: DLMF 19.2.8.

    Parameters
    ----------
    alpha : array_like
        modular angle in radians, k = sin(alpha)
    out : ndarray, optional
        where the result goes

    Returns
    -------
    float or ndarray
        K
    """
    if type(alpha) is float and out is None:
        return _ellipk_alpha.one(alpha)
    return _ellipk_alpha(out, alpha)


_ellipe_k = Routine("ellipe_k", ("k",), None)


def ellipe_k(k: ArrayLike, *, out: Out = None) -> Any:
    r"""Complete elliptic integral of the second kind, of the modulus k, `abs(k) <= 1`, m = k^2.

    .. math:: E(m) = \int_0^{\pi/2} \sqrt{1 - m \sin^2\theta}\,d\theta

    E = pi/2 at m = 0, 1 at m = 1, +Inf at m = -Inf; NaN outside, NaN in gives NaN out. Of an angle
    it is finite at the `pi/2` of the kind. Correctly rounded in float32, 0.5001 ulp of an angle;
    error at most 0.55 ulp (float64).

    Definition: DLMF 19.2.8.

    Parameters
    ----------
    k : array_like
        modulus, m = k^2
    out : ndarray, optional
        where the result goes

    Returns
    -------
    float or ndarray
        E
    """
    if type(k) is float and out is None:
        return _ellipe_k.one(k)
    return _ellipe_k(out, k)


_ellipe_m = Routine("ellipe_m", ("m",), None)


def ellipe_m(m: ArrayLike, *, out: Out = None) -> Any:
    r"""Complete elliptic integral of the second kind, of the parameter m = k^2, `m <= 1`.

    .. math:: E(m) = \int_0^{\pi/2} \sqrt{1 - m \sin^2\theta}\,d\theta

    E = pi/2 at m = 0, 1 at m = 1, +Inf at m = -Inf; NaN outside, NaN in gives NaN out. Of an angle
    it is finite at the `pi/2` of the kind. Correctly rounded in float32, 0.5001 ulp of an angle;
    error at most 0.55 ulp (float64).

    Definition: DLMF 19.2.8.

    Parameters
    ----------
    m : array_like
        parameter, m = k^2
    out : ndarray, optional
        where the result goes

    Returns
    -------
    float or ndarray
        E
    """
    if type(m) is float and out is None:
        return _ellipe_m.one(m)
    return _ellipe_m(out, m)


_ellipe_mc = Routine("ellipe_mc", ("mc",), None)


def ellipe_mc(mc: ArrayLike, *, out: Out = None) -> Any:
    r"""Complete elliptic integral of the second kind, of the complementary parameter mc = 1 - m, `mc >=
    0`.

    .. math:: E(m) = \int_0^{\pi/2} \sqrt{1 - m \sin^2\theta}\,d\theta

    E = pi/2 at m = 0, 1 at m = 1, +Inf at m = -Inf; NaN outside, NaN in gives NaN out. Of an angle
    it is finite at the `pi/2` of the kind. Correctly rounded in float32, 0.5001 ulp of an angle;
    error at most 0.55 ulp (float64).

    Definition: DLMF 19.2.8.

    Parameters
    ----------
    mc : array_like
        complementary parameter 1 - m
    out : ndarray, optional
        where the result goes

    Returns
    -------
    float or ndarray
        E
    """
    if type(mc) is float and out is None:
        return _ellipe_mc.one(mc)
    return _ellipe_mc(out, mc)


_ellipe_alpha = Routine("ellipe_alpha", ("alpha",), None)


def ellipe_alpha(alpha: ArrayLike, *, out: Out = None) -> Any:
    r"""Complete elliptic integral of the second kind, of the modular angle alpha in radians, k =
    sin(alpha), `abs(alpha) <= pi/2`.

    .. math:: E(m) = \int_0^{\pi/2} \sqrt{1 - m \sin^2\theta}\,d\theta

    E = pi/2 at m = 0, 1 at m = 1, +Inf at m = -Inf; NaN outside, NaN in gives NaN out. Of an angle
    it is finite at the `pi/2` of the kind. Correctly rounded in float32, 0.5001 ulp of an angle;
    error at most 0.55 ulp (float64).

    Definition: DLMF 19.2.8.

    Parameters
    ----------
    alpha : array_like
        modular angle in radians, k = sin(alpha)
    out : ndarray, optional
        where the result goes

    Returns
    -------
    float or ndarray
        E
    """
    if type(alpha) is float and out is None:
        return _ellipe_alpha.one(alpha)
    return _ellipe_alpha(out, alpha)


_ellipb_k = Routine("ellipb_k", ("k",), None)


def ellipb_k(k: ArrayLike, *, out: Out = None) -> Any:
    r"""Associated complete elliptic integral B = (E - mc K)/m, of the modulus k, `abs(k) <= 1`, m =
    k^2.

    .. math:: B(m) = \int_0^{\pi/2} \frac{\cos^2\theta\,d\theta}{\sqrt{1 - m \sin^2\theta}}

    B = pi/4 at m = 0, 1 at m = 1, 0 at m = -Inf; NaN outside, NaN in gives NaN out. Of an angle it
    is finite at the `pi/2` of the kind. Correctly rounded in float32, 0.5001 ulp of an angle; error
    at most 0.6 ulp (float64).

    Definition: Fukushima, Math. Comp. 80 (2011) 1725, eq. (1).

    Parameters
    ----------
    k : array_like
        modulus, m = k^2
    out : ndarray, optional
        where the result goes

    Returns
    -------
    float or ndarray
        B
    """
    if type(k) is float and out is None:
        return _ellipb_k.one(k)
    return _ellipb_k(out, k)


_ellipb_m = Routine("ellipb_m", ("m",), None)


def ellipb_m(m: ArrayLike, *, out: Out = None) -> Any:
    r"""Associated complete elliptic integral B = (E - mc K)/m, of the parameter m = k^2, `m <= 1`.

    .. math:: B(m) = \int_0^{\pi/2} \frac{\cos^2\theta\,d\theta}{\sqrt{1 - m \sin^2\theta}}

    B = pi/4 at m = 0, 1 at m = 1, 0 at m = -Inf; NaN outside, NaN in gives NaN out. Of an angle it
    is finite at the `pi/2` of the kind. Correctly rounded in float32, 0.5001 ulp of an angle; error
    at most 0.6 ulp (float64).

    Definition: Fukushima, Math. Comp. 80 (2011) 1725, eq. (1).

    Parameters
    ----------
    m : array_like
        parameter, m = k^2
    out : ndarray, optional
        where the result goes

    Returns
    -------
    float or ndarray
        B
    """
    if type(m) is float and out is None:
        return _ellipb_m.one(m)
    return _ellipb_m(out, m)


_ellipb_mc = Routine("ellipb_mc", ("mc",), None)


def ellipb_mc(mc: ArrayLike, *, out: Out = None) -> Any:
    r"""Associated complete elliptic integral B = (E - mc K)/m, of the complementary parameter mc = 1 -
    m, `mc >= 0`.

    .. math:: B(m) = \int_0^{\pi/2} \frac{\cos^2\theta\,d\theta}{\sqrt{1 - m \sin^2\theta}}

    B = pi/4 at m = 0, 1 at m = 1, 0 at m = -Inf; NaN outside, NaN in gives NaN out. Of an angle it
    is finite at the `pi/2` of the kind. Correctly rounded in float32, 0.5001 ulp of an angle; error
    at most 0.6 ulp (float64).

    Definition: Fukushima, Math. Comp. 80 (2011) 1725, eq. (1).

    Parameters
    ----------
    mc : array_like
        complementary parameter 1 - m
    out : ndarray, optional
        where the result goes

    Returns
    -------
    float or ndarray
        B
    """
    if type(mc) is float and out is None:
        return _ellipb_mc.one(mc)
    return _ellipb_mc(out, mc)


_ellipb_alpha = Routine("ellipb_alpha", ("alpha",), None)


def ellipb_alpha(alpha: ArrayLike, *, out: Out = None) -> Any:
    r"""Associated complete elliptic integral B = (E - mc K)/m, of the modular angle alpha in radians, k
    = sin(alpha), `abs(alpha) <= pi/2`.

    .. math:: B(m) = \int_0^{\pi/2} \frac{\cos^2\theta\,d\theta}{\sqrt{1 - m \sin^2\theta}}

    B = pi/4 at m = 0, 1 at m = 1, 0 at m = -Inf; NaN outside, NaN in gives NaN out. Of an angle it
    is finite at the `pi/2` of the kind. Correctly rounded in float32, 0.5001 ulp of an angle; error
    at most 0.6 ulp (float64).

    Definition: Fukushima, Math. Comp. 80 (2011) 1725, eq. (1).

    Parameters
    ----------
    alpha : array_like
        modular angle in radians, k = sin(alpha)
    out : ndarray, optional
        where the result goes

    Returns
    -------
    float or ndarray
        B
    """
    if type(alpha) is float and out is None:
        return _ellipb_alpha.one(alpha)
    return _ellipb_alpha(out, alpha)


_ellipd_k = Routine("ellipd_k", ("k",), None)


def ellipd_k(k: ArrayLike, *, out: Out = None) -> Any:
    r"""Complete elliptic integral D = (K - E)/m, of the modulus k, `abs(k) <= 1`, m = k^2.

    .. math:: D(m) = \int_0^{\pi/2} \frac{\sin^2\theta\,d\theta}{\sqrt{1 - m \sin^2\theta}}

    D = pi/4 at m = 0, +Inf at m = 1, 0 at m = -Inf; NaN outside, NaN in gives NaN out. Of an angle
    it is finite at the `pi/2` of the kind. Correctly rounded in float32, 0.5001 ulp of an angle;
    error at most 0.6 ulp (float64).

    Definition: DLMF 19.2.8.

    Parameters
    ----------
    k : array_like
        modulus, m = k^2
    out : ndarray, optional
        where the result goes

    Returns
    -------
    float or ndarray
        D
    """
    if type(k) is float and out is None:
        return _ellipd_k.one(k)
    return _ellipd_k(out, k)


_ellipd_m = Routine("ellipd_m", ("m",), None)


def ellipd_m(m: ArrayLike, *, out: Out = None) -> Any:
    r"""Complete elliptic integral D = (K - E)/m, of the parameter m = k^2, `m <= 1`.

    .. math:: D(m) = \int_0^{\pi/2} \frac{\sin^2\theta\,d\theta}{\sqrt{1 - m \sin^2\theta}}

    D = pi/4 at m = 0, +Inf at m = 1, 0 at m = -Inf; NaN outside, NaN in gives NaN out. Of an angle
    it is finite at the `pi/2` of the kind. Correctly rounded in float32, 0.5001 ulp of an angle;
    error at most 0.6 ulp (float64).

    Definition: DLMF 19.2.8.

    Parameters
    ----------
    m : array_like
        parameter, m = k^2
    out : ndarray, optional
        where the result goes

    Returns
    -------
    float or ndarray
        D
    """
    if type(m) is float and out is None:
        return _ellipd_m.one(m)
    return _ellipd_m(out, m)


_ellipd_mc = Routine("ellipd_mc", ("mc",), None)


def ellipd_mc(mc: ArrayLike, *, out: Out = None) -> Any:
    r"""Complete elliptic integral D = (K - E)/m, of the complementary parameter mc = 1 - m, `mc >= 0`.

    .. math:: D(m) = \int_0^{\pi/2} \frac{\sin^2\theta\,d\theta}{\sqrt{1 - m \sin^2\theta}}

    D = pi/4 at m = 0, +Inf at m = 1, 0 at m = -Inf; NaN outside, NaN in gives NaN out. Of an angle
    it is finite at the `pi/2` of the kind. Correctly rounded in float32, 0.5001 ulp of an angle;
    error at most 0.6 ulp (float64).

    Definition: DLMF 19.2.8.

    Parameters
    ----------
    mc : array_like
        complementary parameter 1 - m
    out : ndarray, optional
        where the result goes

    Returns
    -------
    float or ndarray
        D
    """
    if type(mc) is float and out is None:
        return _ellipd_mc.one(mc)
    return _ellipd_mc(out, mc)


_ellipd_alpha = Routine("ellipd_alpha", ("alpha",), None)


def ellipd_alpha(alpha: ArrayLike, *, out: Out = None) -> Any:
    r"""Complete elliptic integral D = (K - E)/m, of the modular angle alpha in radians, k = sin(alpha),
    `abs(alpha) <= pi/2`.

    .. math:: D(m) = \int_0^{\pi/2} \frac{\sin^2\theta\,d\theta}{\sqrt{1 - m \sin^2\theta}}

    D = pi/4 at m = 0, +Inf at m = 1, 0 at m = -Inf; NaN outside, NaN in gives NaN out. Of an angle
    it is finite at the `pi/2` of the kind. Correctly rounded in float32, 0.5001 ulp of an angle;
    error at most 0.6 ulp (float64).

    Definition: DLMF 19.2.8.

    Parameters
    ----------
    alpha : array_like
        modular angle in radians, k = sin(alpha)
    out : ndarray, optional
        where the result goes

    Returns
    -------
    float or ndarray
        D
    """
    if type(alpha) is float and out is None:
        return _ellipd_alpha.one(alpha)
    return _ellipd_alpha(out, alpha)


_ellipke_k = Routine("ellipke_k", ("k",), EllipkeValues)


def ellipke_k(k: ArrayLike, *, out: Outs = None) -> EllipkeValues:
    r"""K and E together, ellipk_k and ellipe_k, of the modulus k, `abs(k) <= 1`, m = k^2.

    .. math:: K(m) = \int_0^{\pi/2} \frac{d\theta}{\sqrt{1 - m \sin^2\theta}}

    K = pi/2 at m = 0, +Inf at m = 1, 0 at m = -Inf; NaN outside, NaN in gives NaN out. Of an angle
    it is finite at the `pi/2` of the kind. Correctly rounded in float32, 0.5001 ulp of an angle;
    error at most 0.55 ulp (float64).

    Definition: DLMF 19.2.8.

    Parameters
    ----------
    k : array_like
        modulus, m = k^2
    out : tuple of ndarray, optional
        where the result goes

    Returns
    -------
    EllipkeValues
        K, E: each a float, or an array
    """
    if type(k) is float and out is None:
        return _ellipke_k.one(k)
    return _ellipke_k(out, k)


_ellipke_m = Routine("ellipke_m", ("m",), EllipkeValues)


def ellipke_m(m: ArrayLike, *, out: Outs = None) -> EllipkeValues:
    r"""K and E together, of the parameter m = k^2, `m <= 1`.

    .. math:: K(m) = \int_0^{\pi/2} \frac{d\theta}{\sqrt{1 - m \sin^2\theta}}

    K = pi/2 at m = 0, +Inf at m = 1, 0 at m = -Inf; NaN outside, NaN in gives NaN out. Of an angle
    it is finite at the `pi/2` of the kind. Correctly rounded in float32, 0.5001 ulp of an angle;
    error at most 0.55 ulp (float64).

    Definition: DLMF 19.2.8.

    Parameters
    ----------
    m : array_like
        parameter, m = k^2
    out : tuple of ndarray, optional
        where the result goes

    Returns
    -------
    EllipkeValues
        K, E: each a float, or an array
    """
    if type(m) is float and out is None:
        return _ellipke_m.one(m)
    return _ellipke_m(out, m)


_ellipke_mc = Routine("ellipke_mc", ("mc",), EllipkeValues)


def ellipke_mc(mc: ArrayLike, *, out: Outs = None) -> EllipkeValues:
    r"""K and E together, of the complementary parameter mc = 1 - m, `mc >= 0`.

    .. math:: K(m) = \int_0^{\pi/2} \frac{d\theta}{\sqrt{1 - m \sin^2\theta}}

    K = pi/2 at m = 0, +Inf at m = 1, 0 at m = -Inf; NaN outside, NaN in gives NaN out. Of an angle
    it is finite at the `pi/2` of the kind. Correctly rounded in float32, 0.5001 ulp of an angle;
    error at most 0.55 ulp (float64).

    Definition: DLMF 19.2.8.

    Parameters
    ----------
    mc : array_like
        complementary parameter 1 - m
    out : tuple of ndarray, optional
        where the result goes

    Returns
    -------
    EllipkeValues
        K, E: each a float, or an array
    """
    if type(mc) is float and out is None:
        return _ellipke_mc.one(mc)
    return _ellipke_mc(out, mc)


_ellipke_alpha = Routine("ellipke_alpha", ("alpha",), EllipkeValues)


def ellipke_alpha(alpha: ArrayLike, *, out: Outs = None) -> EllipkeValues:
    r"""K and E together, of the modular angle alpha in radians, k = sin(alpha), `abs(alpha) <= pi/2`.

    .. math:: K(m) = \int_0^{\pi/2} \frac{d\theta}{\sqrt{1 - m \sin^2\theta}}

    K = pi/2 at m = 0, +Inf at m = 1, 0 at m = -Inf; NaN outside, NaN in gives NaN out. Of an angle
    it is finite at the `pi/2` of the kind. Correctly rounded in float32, 0.5001 ulp of an angle;
    error at most 0.55 ulp (float64).

    Definition: DLMF 19.2.8.

    Parameters
    ----------
    alpha : array_like
        modular angle in radians, k = sin(alpha)
    out : tuple of ndarray, optional
        where the result goes

    Returns
    -------
    EllipkeValues
        K, E: each a float, or an array
    """
    if type(alpha) is float and out is None:
        return _ellipke_alpha.one(alpha)
    return _ellipke_alpha(out, alpha)


_ellips_k = Routine("ellips_k", ("k",), None)


def ellips_k(k: ArrayLike, *, out: Out = None) -> Any:
    r"""Complete elliptic integral S = (D - B)/m, of the modulus k, `abs(k) <= 1`, m = k^2.

    .. math:: S(m) = \frac{D(m) - B(m)}{m} = \frac{(2 - m) K(m) - 2 E(m)}{m^2} = \int_0^{\pi/2}
       \frac{\sin^2\theta\,\cos^2\theta\,d\theta}{(1 - m \sin^2\theta)^{3/2}}

    What mutual inductances and the fields of loops are made of, without the cancelling of K and E.

    S(k=0) = pi/16, S(k=+-1) = +Inf, S(m=-Inf) = 0; NaN outside, NaN in gives NaN out.

    Accuracy: 1.75 ulp.

    Definition: Fukushima, J. Comput. Appl. Math. 235 (2011) 4140.

    Parameters
    ----------
    k : array_like
        modulus, m = k^2
    out : ndarray, optional
        where the result goes

    Returns
    -------
    float or ndarray
        S
    """
    if type(k) is float and out is None:
        return _ellips_k.one(k)
    return _ellips_k(out, k)


_ellips_m = Routine("ellips_m", ("m",), None)


def ellips_m(m: ArrayLike, *, out: Out = None) -> Any:
    r"""Complete elliptic integral S = (D - B)/m, of the parameter m = k^2, `m <= 1`.

    .. math:: S(m) = \frac{D(m) - B(m)}{m} = \frac{(2 - m) K(m) - 2 E(m)}{m^2} = \int_0^{\pi/2}
       \frac{\sin^2\theta\,\cos^2\theta\,d\theta}{(1 - m \sin^2\theta)^{3/2}}

    What mutual inductances and the fields of loops are made of, without the cancelling of K and E.

    S(k=0) = pi/16, S(k=+-1) = +Inf, S(m=-Inf) = 0; NaN outside, NaN in gives NaN out.

    Accuracy: 1.75 ulp.

    Definition: Fukushima, J. Comput. Appl. Math. 235 (2011) 4140.

    Parameters
    ----------
    m : array_like
        parameter, m = k^2
    out : ndarray, optional
        where the result goes

    Returns
    -------
    float or ndarray
        S
    """
    if type(m) is float and out is None:
        return _ellips_m.one(m)
    return _ellips_m(out, m)


_ellips_mc = Routine("ellips_mc", ("mc",), None)


def ellips_mc(mc: ArrayLike, *, out: Out = None) -> Any:
    r"""Complete elliptic integral S = (D - B)/m, of the complementary parameter mc = 1 - m, `mc >= 0`.

    .. math:: S(m) = \frac{D(m) - B(m)}{m} = \frac{(2 - m) K(m) - 2 E(m)}{m^2} = \int_0^{\pi/2}
       \frac{\sin^2\theta\,\cos^2\theta\,d\theta}{(1 - m \sin^2\theta)^{3/2}}

    What mutual inductances and the fields of loops are made of, without the cancelling of K and E.

    S(k=0) = pi/16, S(k=+-1) = +Inf, S(m=-Inf) = 0; NaN outside, NaN in gives NaN out.

    Accuracy: 1.75 ulp.

    Definition: Fukushima, J. Comput. Appl. Math. 235 (2011) 4140.

    Parameters
    ----------
    mc : array_like
        complementary parameter 1 - m
    out : ndarray, optional
        where the result goes

    Returns
    -------
    float or ndarray
        S
    """
    if type(mc) is float and out is None:
        return _ellips_mc.one(mc)
    return _ellips_mc(out, mc)


_ellipf_k = Routine("ellipf_k", ("phi", "k"), None)


def ellipf_k(phi: ArrayLike, k: ArrayLike, *, out: Out = None) -> Any:
    r"""Legendre's incomplete integral of the first kind, of the angle phi in radians and the modulus k,
    m = k^2.

    .. math:: F(\phi|m) = \int_0^\phi \frac{d\theta}{\sqrt{1 - m\sin^2\theta}}

    Any real phi (quasi-periodic); m <= 1, or m > 1 as long as m sin(phi)**2 <= 1. Outside: NaN.

    Special cases: phi = 0: 0; m = 1 and |phi| > pi/2: Inf with the sign of phi. Within 4 ulp beyond
    m sin(phi)**2 = 1 the value is the one there. What overflows is Inf.

    Accuracy: 3 ulp.

    Parameters
    ----------
    phi : array_like
        angle in radians
    k : array_like
        modulus, m = k^2
    out : ndarray, optional
        where the result goes

    Returns
    -------
    float or ndarray
        F
    """
    if type(phi) is float and type(k) is float and out is None:
        return _ellipf_k.one(phi, k)
    return _ellipf_k(out, phi, k)


_ellipf_m = Routine("ellipf_m", ("phi", "m"), None)


def ellipf_m(phi: ArrayLike, m: ArrayLike, *, out: Out = None) -> Any:
    r"""Legendre's incomplete integral of the first kind, of the parameter m = k^2.

    .. math:: F(\phi|m) = \int_0^\phi \frac{d\theta}{\sqrt{1 - m\sin^2\theta}}

    Any real phi (quasi-periodic); m <= 1, or m > 1 as long as m sin(phi)**2 <= 1. Outside: NaN.

    Special cases: phi = 0: 0; m = 1 and |phi| > pi/2: Inf with the sign of phi. Within 4 ulp beyond
    m sin(phi)**2 = 1 the value is the one there. What overflows is Inf.

    Accuracy: 3 ulp.

    Parameters
    ----------
    phi : array_like
        angle in radians
    m : array_like
        parameter, m = k^2
    out : ndarray, optional
        where the result goes

    Returns
    -------
    float or ndarray
        F
    """
    if type(phi) is float and type(m) is float and out is None:
        return _ellipf_m.one(phi, m)
    return _ellipf_m(out, phi, m)


_ellipf_mc = Routine("ellipf_mc", ("phi", "mc"), None)


def ellipf_mc(phi: ArrayLike, mc: ArrayLike, *, out: Out = None) -> Any:
    r"""Legendre's incomplete integral of the first kind, of the complementary parameter mc = 1 - m.

    .. math:: F(\phi|m) = \int_0^\phi \frac{d\theta}{\sqrt{1 - m\sin^2\theta}}

    Any real phi (quasi-periodic); m <= 1, or m > 1 as long as m sin(phi)**2 <= 1. Outside: NaN.

    Special cases: phi = 0: 0; m = 1 and |phi| > pi/2: Inf with the sign of phi. Within 4 ulp beyond
    m sin(phi)**2 = 1 the value is the one there. What overflows is Inf.

    Accuracy: 3 ulp.

    Parameters
    ----------
    phi : array_like
        angle in radians
    mc : array_like
        complementary parameter 1 - m
    out : ndarray, optional
        where the result goes

    Returns
    -------
    float or ndarray
        F
    """
    if type(phi) is float and type(mc) is float and out is None:
        return _ellipf_mc.one(phi, mc)
    return _ellipf_mc(out, phi, mc)


_ellipeinc_k = Routine("ellipeinc_k", ("phi", "k"), None)


def ellipeinc_k(phi: ArrayLike, k: ArrayLike, *, out: Out = None) -> Any:
    r"""Legendre's incomplete integral of the second kind, of the angle phi in radians and the modulus
    k, m = k^2.

    .. math:: E(\phi|m) = \int_0^\phi \sqrt{1 - m\sin^2\theta}\,d\theta

    Any real phi (quasi-periodic); m <= 1, or m > 1 as long as m sin(phi)**2 <= 1. Outside: NaN.

    Special cases: phi = 0: 0; m = 1: sin(phi) and 2 for each half turn. Within 4 ulp beyond m
    sin(phi)**2 = 1 the value is the one there. What overflows is Inf.

    Accuracy: 3 ulp.

    Parameters
    ----------
    phi : array_like
        angle in radians
    k : array_like
        modulus, m = k^2
    out : ndarray, optional
        where the result goes

    Returns
    -------
    float or ndarray
        E
    """
    if type(phi) is float and type(k) is float and out is None:
        return _ellipeinc_k.one(phi, k)
    return _ellipeinc_k(out, phi, k)


_ellipeinc_m = Routine("ellipeinc_m", ("phi", "m"), None)


def ellipeinc_m(phi: ArrayLike, m: ArrayLike, *, out: Out = None) -> Any:
    r"""Legendre's incomplete integral of the second kind, of the parameter m = k^2.

    .. math:: E(\phi|m) = \int_0^\phi \sqrt{1 - m\sin^2\theta}\,d\theta

    Any real phi (quasi-periodic); m <= 1, or m > 1 as long as m sin(phi)**2 <= 1. Outside: NaN.

    Special cases: phi = 0: 0; m = 1: sin(phi) and 2 for each half turn. Within 4 ulp beyond m
    sin(phi)**2 = 1 the value is the one there. What overflows is Inf.

    Accuracy: 3 ulp.

    Parameters
    ----------
    phi : array_like
        angle in radians
    m : array_like
        parameter, m = k^2
    out : ndarray, optional
        where the result goes

    Returns
    -------
    float or ndarray
        E
    """
    if type(phi) is float and type(m) is float and out is None:
        return _ellipeinc_m.one(phi, m)
    return _ellipeinc_m(out, phi, m)


_ellipeinc_mc = Routine("ellipeinc_mc", ("phi", "mc"), None)


def ellipeinc_mc(phi: ArrayLike, mc: ArrayLike, *, out: Out = None) -> Any:
    r"""Legendre's incomplete integral of the second kind, of the complementary parameter mc = 1 - m.

    .. math:: E(\phi|m) = \int_0^\phi \sqrt{1 - m\sin^2\theta}\,d\theta

    Any real phi (quasi-periodic); m <= 1, or m > 1 as long as m sin(phi)**2 <= 1. Outside: NaN.

    Special cases: phi = 0: 0; m = 1: sin(phi) and 2 for each half turn. Within 4 ulp beyond m
    sin(phi)**2 = 1 the value is the one there. What overflows is Inf.

    Accuracy: 3 ulp.

    Parameters
    ----------
    phi : array_like
        angle in radians
    mc : array_like
        complementary parameter 1 - m
    out : ndarray, optional
        where the result goes

    Returns
    -------
    float or ndarray
        E
    """
    if type(phi) is float and type(mc) is float and out is None:
        return _ellipeinc_mc.one(phi, mc)
    return _ellipeinc_mc(out, phi, mc)


_ellipdinc_k = Routine("ellipdinc_k", ("phi", "k"), None)


def ellipdinc_k(phi: ArrayLike, k: ArrayLike, *, out: Out = None) -> Any:
    r"""Legendre's incomplete integral D = (F - E)/m, of the angle phi in radians and the modulus k, m =
    k^2.

    .. math:: D(\phi|m) = \int_0^\phi \frac{\sin^2\theta\,d\theta}{\sqrt{1 - m\sin^2\theta}}

    Any real phi (quasi-periodic); m <= 1, or m > 1 as long as m sin(phi)**2 <= 1. Outside: NaN.

    Special cases: phi = 0: 0; m = 1 and |phi| > pi/2: Inf with the sign of phi. Within 4 ulp beyond
    m sin(phi)**2 = 1 the value is the one there. What overflows is Inf.

    Accuracy: 3 ulp.

    Parameters
    ----------
    phi : array_like
        angle in radians
    k : array_like
        modulus, m = k^2
    out : ndarray, optional
        where the result goes

    Returns
    -------
    float or ndarray
        D
    """
    if type(phi) is float and type(k) is float and out is None:
        return _ellipdinc_k.one(phi, k)
    return _ellipdinc_k(out, phi, k)


_ellipdinc_m = Routine("ellipdinc_m", ("phi", "m"), None)


def ellipdinc_m(phi: ArrayLike, m: ArrayLike, *, out: Out = None) -> Any:
    r"""Legendre's incomplete integral D = (F - E)/m, of the parameter m = k^2.

    .. math:: D(\phi|m) = \int_0^\phi \frac{\sin^2\theta\,d\theta}{\sqrt{1 - m\sin^2\theta}}

    Any real phi (quasi-periodic); m <= 1, or m > 1 as long as m sin(phi)**2 <= 1. Outside: NaN.

    Special cases: phi = 0: 0; m = 1 and |phi| > pi/2: Inf with the sign of phi. Within 4 ulp beyond
    m sin(phi)**2 = 1 the value is the one there. What overflows is Inf.

    Accuracy: 3 ulp.

    Parameters
    ----------
    phi : array_like
        angle in radians
    m : array_like
        parameter, m = k^2
    out : ndarray, optional
        where the result goes

    Returns
    -------
    float or ndarray
        D
    """
    if type(phi) is float and type(m) is float and out is None:
        return _ellipdinc_m.one(phi, m)
    return _ellipdinc_m(out, phi, m)


_ellipdinc_mc = Routine("ellipdinc_mc", ("phi", "mc"), None)


def ellipdinc_mc(phi: ArrayLike, mc: ArrayLike, *, out: Out = None) -> Any:
    r"""Legendre's incomplete integral D = (F - E)/m, of the complementary parameter mc = 1 - m.

    .. math:: D(\phi|m) = \int_0^\phi \frac{\sin^2\theta\,d\theta}{\sqrt{1 - m\sin^2\theta}}

    Any real phi (quasi-periodic); m <= 1, or m > 1 as long as m sin(phi)**2 <= 1. Outside: NaN.

    Special cases: phi = 0: 0; m = 1 and |phi| > pi/2: Inf with the sign of phi. Within 4 ulp beyond
    m sin(phi)**2 = 1 the value is the one there. What overflows is Inf.

    Accuracy: 3 ulp.

    Parameters
    ----------
    phi : array_like
        angle in radians
    mc : array_like
        complementary parameter 1 - m
    out : ndarray, optional
        where the result goes

    Returns
    -------
    float or ndarray
        D
    """
    if type(phi) is float and type(mc) is float and out is None:
        return _ellipdinc_mc.one(phi, mc)
    return _ellipdinc_mc(out, phi, mc)


_ellippi_k = Routine("ellippi_k", ("n", "k"), None)


def ellippi_k(n: ArrayLike, k: ArrayLike, *, out: Out = None) -> Any:
    r"""Complete elliptic integral of the third kind, of the characteristic n and the modulus k, m =
    k^2.

    .. math:: \Pi(n|m) = \int_0^{\pi/2} \frac{d\theta}{(1 - n\sin^2\theta)\sqrt{1 - m\sin^2\theta}}

    n as in DLMF and Wolfram (GSL has the opposite sign), any real; for n > 1 the Cauchy principal
    value; m <= 1.

    Special cases: n = 1 or m = 1: +Inf (-Inf if n > 1); n or m infinite: 0; m > 1: NaN.

    Accuracy: 4 ulp.

    Parameters
    ----------
    n : array_like
        characteristic, in DLMF's sign
    k : array_like
        modulus, m = k^2
    out : ndarray, optional
        where the result goes

    Returns
    -------
    float or ndarray
        Pi
    """
    if type(n) is float and type(k) is float and out is None:
        return _ellippi_k.one(n, k)
    return _ellippi_k(out, n, k)


_ellippi_m = Routine("ellippi_m", ("n", "m"), None)


def ellippi_m(n: ArrayLike, m: ArrayLike, *, out: Out = None) -> Any:
    r"""Complete elliptic integral of the third kind, of the parameter m = k^2.

    .. math:: \Pi(n|m) = \int_0^{\pi/2} \frac{d\theta}{(1 - n\sin^2\theta)\sqrt{1 - m\sin^2\theta}}

    n as in DLMF and Wolfram (GSL has the opposite sign), any real; for n > 1 the Cauchy principal
    value; m <= 1.

    Special cases: n = 1 or m = 1: +Inf (-Inf if n > 1); n or m infinite: 0; m > 1: NaN.

    Accuracy: 4 ulp.

    Parameters
    ----------
    n : array_like
        characteristic, in DLMF's sign
    m : array_like
        parameter, m = k^2
    out : ndarray, optional
        where the result goes

    Returns
    -------
    float or ndarray
        Pi
    """
    if type(n) is float and type(m) is float and out is None:
        return _ellippi_m.one(n, m)
    return _ellippi_m(out, n, m)


_ellippi_mc = Routine("ellippi_mc", ("n", "mc"), None)


def ellippi_mc(n: ArrayLike, mc: ArrayLike, *, out: Out = None) -> Any:
    r"""Complete elliptic integral of the third kind, of the complementary parameter mc = 1 - m.

    .. math:: \Pi(n|m) = \int_0^{\pi/2} \frac{d\theta}{(1 - n\sin^2\theta)\sqrt{1 - m\sin^2\theta}}

    n as in DLMF and Wolfram (GSL has the opposite sign), any real; for n > 1 the Cauchy principal
    value; m <= 1.

    Special cases: n = 1 or m = 1: +Inf (-Inf if n > 1); n or m infinite: 0; m > 1: NaN.

    Accuracy: 4 ulp.

    Parameters
    ----------
    n : array_like
        characteristic, in DLMF's sign
    mc : array_like
        complementary parameter 1 - m
    out : ndarray, optional
        where the result goes

    Returns
    -------
    float or ndarray
        Pi
    """
    if type(n) is float and type(mc) is float and out is None:
        return _ellippi_mc.one(n, mc)
    return _ellippi_mc(out, n, mc)


_ellippiinc_k = Routine("ellippiinc_k", ("n", "phi", "k"), None)


def ellippiinc_k(n: ArrayLike, phi: ArrayLike, k: ArrayLike, *, out: Out = None) -> Any:
    r"""Legendre's incomplete integral of the third kind, of the characteristic n, the angle phi in
    radians and the modulus k, m = k^2.

    .. math:: \Pi(n;\phi|m) = \int_0^\phi \frac{d\theta}{(1 - n\sin^2\theta)\sqrt{1 -
       m\sin^2\theta}}

    n as in DLMF and Wolfram (GSL has the opposite sign), any real; beyond a pole of the integrand
    the Cauchy principal value. Any real phi (quasi-periodic); m <= 1, or m > 1 as long as m
    sin(phi)**2 <= 1. Outside: NaN.

    Special cases: phi = 0: 0; |phi| > pi/2 and n = 1 or m = 1: Inf. Within 4 ulp beyond m
    sin(phi)**2 = 1 the value is the one there. What overflows is Inf.

    Accuracy: 4 ulp, next to n sin(phi)**2 = 1 too.

    Parameters
    ----------
    n : array_like
        characteristic, in DLMF's sign
    phi : array_like
        angle in radians
    k : array_like
        modulus, m = k^2
    out : ndarray, optional
        where the result goes

    Returns
    -------
    float or ndarray
        Pi
    """
    if type(n) is float and type(phi) is float and type(k) is float and out is None:
        return _ellippiinc_k.one(n, phi, k)
    return _ellippiinc_k(out, n, phi, k)


_ellippiinc_m = Routine("ellippiinc_m", ("n", "phi", "m"), None)


def ellippiinc_m(n: ArrayLike, phi: ArrayLike, m: ArrayLike, *, out: Out = None) -> Any:
    r"""Legendre's incomplete integral of the third kind, of the parameter m = k^2.

    .. math:: \Pi(n;\phi|m) = \int_0^\phi \frac{d\theta}{(1 - n\sin^2\theta)\sqrt{1 -
       m\sin^2\theta}}

    n as in DLMF and Wolfram (GSL has the opposite sign), any real; beyond a pole of the integrand
    the Cauchy principal value. Any real phi (quasi-periodic); m <= 1, or m > 1 as long as m
    sin(phi)**2 <= 1. Outside: NaN.

    Special cases: phi = 0: 0; |phi| > pi/2 and n = 1 or m = 1: Inf. Within 4 ulp beyond m
    sin(phi)**2 = 1 the value is the one there. What overflows is Inf.

    Accuracy: 4 ulp, next to n sin(phi)**2 = 1 too.

    Parameters
    ----------
    n : array_like
        characteristic, in DLMF's sign
    phi : array_like
        angle in radians
    m : array_like
        parameter, m = k^2
    out : ndarray, optional
        where the result goes

    Returns
    -------
    float or ndarray
        Pi
    """
    if type(n) is float and type(phi) is float and type(m) is float and out is None:
        return _ellippiinc_m.one(n, phi, m)
    return _ellippiinc_m(out, n, phi, m)


_ellippiinc_mc = Routine("ellippiinc_mc", ("n", "phi", "mc"), None)


def ellippiinc_mc(n: ArrayLike, phi: ArrayLike, mc: ArrayLike, *, out: Out = None) -> Any:
    r"""Legendre's incomplete integral of the third kind, of the complementary parameter mc = 1 - m.

    .. math:: \Pi(n;\phi|m) = \int_0^\phi \frac{d\theta}{(1 - n\sin^2\theta)\sqrt{1 -
       m\sin^2\theta}}

    n as in DLMF and Wolfram (GSL has the opposite sign), any real; beyond a pole of the integrand
    the Cauchy principal value. Any real phi (quasi-periodic); m <= 1, or m > 1 as long as m
    sin(phi)**2 <= 1. Outside: NaN.

    Special cases: phi = 0: 0; |phi| > pi/2 and n = 1 or m = 1: Inf. Within 4 ulp beyond m
    sin(phi)**2 = 1 the value is the one there. What overflows is Inf.

    Accuracy: 4 ulp, next to n sin(phi)**2 = 1 too.

    Parameters
    ----------
    n : array_like
        characteristic, in DLMF's sign
    phi : array_like
        angle in radians
    mc : array_like
        complementary parameter 1 - m
    out : ndarray, optional
        where the result goes

    Returns
    -------
    float or ndarray
        Pi
    """
    if type(n) is float and type(phi) is float and type(mc) is float and out is None:
        return _ellippiinc_mc.one(n, phi, mc)
    return _ellippiinc_mc(out, n, phi, mc)


_ellipj_k = Routine("ellipj_k", ("n", "k"), None)


def ellipj_k(n: ArrayLike, k: ArrayLike, *, out: Out = None) -> Any:
    r"""Associate complete integral J = (Pi - K)/n, of the characteristic n and the modulus k, m = k^2.

    .. math:: J(n|m) = \int_0^{\pi/2} \frac{\sin^2\theta\,d\theta}{(1 - n\sin^2\theta)\sqrt{1 -
       m\sin^2\theta}}

    n as in DLMF and Wolfram (GSL has the opposite sign), any real; for n > 1 the Cauchy principal
    value; m <= 1. J(0|m) = D(m). Not the `ellipj` of SciPy and MATLAB, which is jacobi_m here.

    Special cases: n = 1 or m = 1: +Inf (-Inf if n > 1); n or m infinite: 0; m > 1: NaN.

    Accuracy: 4 ulp.

    Definition: Fukushima, J. Comput. Appl. Math. 236 (2012) 1961.

    Parameters
    ----------
    n : array_like
        characteristic, in DLMF's sign
    k : array_like
        modulus, m = k^2
    out : ndarray, optional
        where the result goes

    Returns
    -------
    float or ndarray
        J
    """
    if type(n) is float and type(k) is float and out is None:
        return _ellipj_k.one(n, k)
    return _ellipj_k(out, n, k)


_ellipj_m = Routine("ellipj_m", ("n", "m"), None)


def ellipj_m(n: ArrayLike, m: ArrayLike, *, out: Out = None) -> Any:
    r"""Associate complete integral J = (Pi - K)/n, of the parameter m = k^2.

    .. math:: J(n|m) = \int_0^{\pi/2} \frac{\sin^2\theta\,d\theta}{(1 - n\sin^2\theta)\sqrt{1 -
       m\sin^2\theta}}

    n as in DLMF and Wolfram (GSL has the opposite sign), any real; for n > 1 the Cauchy principal
    value; m <= 1. J(0|m) = D(m). Not the `ellipj` of SciPy and MATLAB, which is jacobi_m here.

    Special cases: n = 1 or m = 1: +Inf (-Inf if n > 1); n or m infinite: 0; m > 1: NaN.

    Accuracy: 4 ulp.

    Definition: Fukushima, J. Comput. Appl. Math. 236 (2012) 1961.

    Parameters
    ----------
    n : array_like
        characteristic, in DLMF's sign
    m : array_like
        parameter, m = k^2
    out : ndarray, optional
        where the result goes

    Returns
    -------
    float or ndarray
        J
    """
    if type(n) is float and type(m) is float and out is None:
        return _ellipj_m.one(n, m)
    return _ellipj_m(out, n, m)


_ellipj_mc = Routine("ellipj_mc", ("n", "mc"), None)


def ellipj_mc(n: ArrayLike, mc: ArrayLike, *, out: Out = None) -> Any:
    r"""Associate complete integral J = (Pi - K)/n, of the complementary parameter mc = 1 - m.

    .. math:: J(n|m) = \int_0^{\pi/2} \frac{\sin^2\theta\,d\theta}{(1 - n\sin^2\theta)\sqrt{1 -
       m\sin^2\theta}}

    n as in DLMF and Wolfram (GSL has the opposite sign), any real; for n > 1 the Cauchy principal
    value; m <= 1. J(0|m) = D(m). Not the `ellipj` of SciPy and MATLAB, which is jacobi_m here.

    Special cases: n = 1 or m = 1: +Inf (-Inf if n > 1); n or m infinite: 0; m > 1: NaN.

    Accuracy: 4 ulp.

    Definition: Fukushima, J. Comput. Appl. Math. 236 (2012) 1961.

    Parameters
    ----------
    n : array_like
        characteristic, in DLMF's sign
    mc : array_like
        complementary parameter 1 - m
    out : ndarray, optional
        where the result goes

    Returns
    -------
    float or ndarray
        J
    """
    if type(n) is float and type(mc) is float and out is None:
        return _ellipj_mc.one(n, mc)
    return _ellipj_mc(out, n, mc)


_ellipjinc_k = Routine("ellipjinc_k", ("n", "phi", "k"), None)


def ellipjinc_k(n: ArrayLike, phi: ArrayLike, k: ArrayLike, *, out: Out = None) -> Any:
    r"""Associate incomplete integral J = (Pi - F)/n, of the characteristic n, the angle phi in radians
    and the modulus k, m = k^2.

    .. math:: J(n;\phi|m) = \int_0^\phi \frac{\sin^2\theta\,d\theta}{(1 - n\sin^2\theta)\sqrt{1 -
       m\sin^2\theta}}

    n as in DLMF and Wolfram (GSL has the opposite sign), any real; beyond a pole of the integrand
    the Cauchy principal value. Any real phi (quasi-periodic); m <= 1, or m > 1 as long as m
    sin(phi)**2 <= 1. Outside: NaN. J(0, phi|m) = D(phi|m); for small phi it is phi**3/3.

    Special cases: phi = 0: 0; |phi| > pi/2 and n = 1 or m = 1: Inf. Within 4 ulp beyond m
    sin(phi)**2 = 1 the value is the one there. What overflows is Inf.

    Accuracy: 4 ulp, next to n sin(phi)**2 = 1 too. Definition and method: as of ellipj_k; next to a
    pole or an edge, where terms cancel and far out in long numbers.

    Parameters
    ----------
    n : array_like
        characteristic, in DLMF's sign
    phi : array_like
        angle in radians
    k : array_like
        modulus, m = k^2
    out : ndarray, optional
        where the result goes

    Returns
    -------
    float or ndarray
        J
    """
    if type(n) is float and type(phi) is float and type(k) is float and out is None:
        return _ellipjinc_k.one(n, phi, k)
    return _ellipjinc_k(out, n, phi, k)


_ellipjinc_m = Routine("ellipjinc_m", ("n", "phi", "m"), None)


def ellipjinc_m(n: ArrayLike, phi: ArrayLike, m: ArrayLike, *, out: Out = None) -> Any:
    r"""Associate incomplete integral J = (Pi - F)/n, of the parameter m = k^2.

    .. math:: J(n;\phi|m) = \int_0^\phi \frac{\sin^2\theta\,d\theta}{(1 - n\sin^2\theta)\sqrt{1 -
       m\sin^2\theta}}

    n as in DLMF and Wolfram (GSL has the opposite sign), any real; beyond a pole of the integrand
    the Cauchy principal value. Any real phi (quasi-periodic); m <= 1, or m > 1 as long as m
    sin(phi)**2 <= 1. Outside: NaN. J(0, phi|m) = D(phi|m); for small phi it is phi**3/3.

    Special cases: phi = 0: 0; |phi| > pi/2 and n = 1 or m = 1: Inf. Within 4 ulp beyond m
    sin(phi)**2 = 1 the value is the one there. What overflows is Inf.

    Accuracy: 4 ulp, next to n sin(phi)**2 = 1 too. Definition and method: as of ellipj_k; next to a
    pole or an edge, where terms cancel and far out in long numbers.

    Parameters
    ----------
    n : array_like
        characteristic, in DLMF's sign
    phi : array_like
        angle in radians
    m : array_like
        parameter, m = k^2
    out : ndarray, optional
        where the result goes

    Returns
    -------
    float or ndarray
        J
    """
    if type(n) is float and type(phi) is float and type(m) is float and out is None:
        return _ellipjinc_m.one(n, phi, m)
    return _ellipjinc_m(out, n, phi, m)


_ellipjinc_mc = Routine("ellipjinc_mc", ("n", "phi", "mc"), None)


def ellipjinc_mc(n: ArrayLike, phi: ArrayLike, mc: ArrayLike, *, out: Out = None) -> Any:
    r"""Associate incomplete integral J = (Pi - F)/n, of the complementary parameter mc = 1 - m.

    .. math:: J(n;\phi|m) = \int_0^\phi \frac{\sin^2\theta\,d\theta}{(1 - n\sin^2\theta)\sqrt{1 -
       m\sin^2\theta}}

    n as in DLMF and Wolfram (GSL has the opposite sign), any real; beyond a pole of the integrand
    the Cauchy principal value. Any real phi (quasi-periodic); m <= 1, or m > 1 as long as m
    sin(phi)**2 <= 1. Outside: NaN. J(0, phi|m) = D(phi|m); for small phi it is phi**3/3.

    Special cases: phi = 0: 0; |phi| > pi/2 and n = 1 or m = 1: Inf. Within 4 ulp beyond m
    sin(phi)**2 = 1 the value is the one there. What overflows is Inf.

    Accuracy: 4 ulp, next to n sin(phi)**2 = 1 too. Definition and method: as of ellipj_k; next to a
    pole or an edge, where terms cancel and far out in long numbers.

    Parameters
    ----------
    n : array_like
        characteristic, in DLMF's sign
    phi : array_like
        angle in radians
    mc : array_like
        complementary parameter 1 - m
    out : ndarray, optional
        where the result goes

    Returns
    -------
    float or ndarray
        J
    """
    if type(n) is float and type(phi) is float and type(mc) is float and out is None:
        return _ellipjinc_mc.one(n, phi, mc)
    return _ellipjinc_mc(out, n, phi, mc)


_bulirsch_cel = Routine("bulirsch_cel", ("kc", "p", "a", "b"), None)


def bulirsch_cel(kc: ArrayLike, p: ArrayLike, a: ArrayLike, b: ArrayLike, *, out: Out = None) -> Any:
    r"""Bulirsch's general complete elliptic integral; kc is the complementary modulus, kc^2 = 1 - m.

    .. math:: \mathrm{cel}(k_c, p, a, b) = \int_0^{\pi/2} \frac{a\cos^2\theta + b\sin^2\theta}
       {(\cos^2\theta + p\sin^2\theta)\sqrt{\cos^2\theta + k_c^2\sin^2\theta}}\,d\theta

    Any real kc (its sign does not matter), p, a, b; for p < 0 the Cauchy principal value. K =
    cel(kc, 1, 1, 1), E = cel(kc, 1, 1, kc^2), B = cel(kc, 1, 1, 0), D = cel(kc, 1, 0, 1), Pi(n|m) =
    cel(kc, 1 - n, 1, 1).

    Special cases: a = b = 0: 0; kc = 0 or p = 0: b's infinity (its opposite if p < 0), of b = 0 the
    limit, a R_C(1, p) or a K, which at kc = p = 0 is a's infinity; kc or p infinite: 0; a or b
    infinite: the infinity of its part. NaN where two such limits contradict each other, and of NaN.

    Accuracy: 1 ulp of the integral itself, also where the parts of a and b nearly cancel. Far from
    1, and where next to nothing is left, a tenth of a millisecond; else a microsecond. What
    overflows is Inf.

    Source: Bulirsch, Numer. Math. 13 (1969) 305; DLMF 19.2.11.

    Parameters
    ----------
    kc : array_like
        complementary modulus
    p : array_like
        1 - n
    a : array_like
        weight of the squared cosine
    b : array_like
        weight of the squared sine
    out : ndarray, optional
        where the result goes

    Returns
    -------
    float or ndarray
        f
    """
    if type(kc) is float and type(p) is float and type(a) is float and type(b) is float and out is None:
        return _bulirsch_cel.one(kc, p, a, b)
    return _bulirsch_cel(out, kc, p, a, b)


_carlson_rf = Routine("carlson_rf", ("x", "y", "z"), None)


def carlson_rf(x: ArrayLike, y: ArrayLike, z: ArrayLike, *, out: Out = None) -> Any:
    r"""Carlson's integral of the first kind.

    .. math:: R_F(x,y,z) = \frac12 \int_0^\infty \frac{dt}{\sqrt{(t+x)(t+y)(t+z)}}

    x, y, z >= 0, symmetric. Outside: NaN.

    Special cases (DLMF 19.20(i)): two zeros: +Inf; an infinite argument: 0; R_F(x,x,x) = 1/sqrt(x).

    Accuracy: 3 ulp.

    Parameters
    ----------
    x : array_like
        number
    y : array_like
        number
    z : array_like
        number
    out : ndarray, optional
        where the result goes

    Returns
    -------
    float or ndarray
        RF
    """
    if type(x) is float and type(y) is float and type(z) is float and out is None:
        return _carlson_rf.one(x, y, z)
    return _carlson_rf(out, x, y, z)


_carlson_rc = Routine("carlson_rc", ("x", "y"), None)


def carlson_rc(x: ArrayLike, y: ArrayLike, *, out: Out = None) -> Any:
    r"""Carlson's degenerate integral R_C(x,y) = R_F(x,y,y).

    x >= 0, y /= 0; for y < 0 the Cauchy principal value, DLMF 19.2.20. Outside: NaN.

    Special cases (DLMF 19.6(iv)): R_C(x,0) = +Inf; R_C(0,y) = 0 for y < 0; an infinite argument: 0.

    Accuracy: 3 ulp.

    Parameters
    ----------
    x : array_like
        number
    y : array_like
        number
    out : ndarray, optional
        where the result goes

    Returns
    -------
    float or ndarray
        RC
    """
    if type(x) is float and type(y) is float and out is None:
        return _carlson_rc.one(x, y)
    return _carlson_rc(out, x, y)


_carlson_rd = Routine("carlson_rd", ("x", "y", "z"), None)


def carlson_rd(x: ArrayLike, y: ArrayLike, z: ArrayLike, *, out: Out = None) -> Any:
    r"""Carlson's integral of the second kind, R_D(x,y,z) = R_J(x,y,z,z).

    .. math:: R_D(x,y,z) = \frac32 \int_0^\infty \frac{dt}{(t+z)\sqrt{(t+x)(t+y)(t+z)}}

    x, y, z >= 0, symmetric in x and y. Outside: NaN.

    Special cases (DLMF 19.20(iv)): z = 0 or x = y = 0: +Inf; an infinite argument: 0; R_D(x,x,x) =
    x**(-3/2).

    Accuracy: 3 ulp.

    Parameters
    ----------
    x : array_like
        number
    y : array_like
        number
    z : array_like
        number
    out : ndarray, optional
        where the result goes

    Returns
    -------
    float or ndarray
        RD
    """
    if type(x) is float and type(y) is float and type(z) is float and out is None:
        return _carlson_rd.one(x, y, z)
    return _carlson_rd(out, x, y, z)


_carlson_rj = Routine("carlson_rj", ("x", "y", "z", "p"), None)


def carlson_rj(x: ArrayLike, y: ArrayLike, z: ArrayLike, p: ArrayLike, *, out: Out = None) -> Any:
    r"""Carlson's integral of the third kind.

    .. math:: R_J(x,y,z,p) = \frac32 \int_0^\infty \frac{dt}{(t+p)\sqrt{(t+x)(t+y)(t+z)}}

    x, y, z >= 0, symmetric in them; for p < 0 the Cauchy principal value, DLMF 19.20.14. Outside:
    NaN.

    Special cases (DLMF 19.20(iii)): p = 0: +Inf; two of x, y, z zero: Inf with the sign of p; an
    infinite argument: 0; R_J(x,x,x,x) = x**(-3/2).

    Accuracy: 4 ulp, also of principal values next to their zeros.

    Parameters
    ----------
    x : array_like
        number
    y : array_like
        number
    z : array_like
        number
    p : array_like
        number
    out : ndarray, optional
        where the result goes

    Returns
    -------
    float or ndarray
        RJ
    """
    if type(x) is float and type(y) is float and type(z) is float and type(p) is float and out is None:
        return _carlson_rj.one(x, y, z, p)
    return _carlson_rj(out, x, y, z, p)


_carlson_rg = Routine("carlson_rg", ("x", "y", "z"), None)


def carlson_rg(x: ArrayLike, y: ArrayLike, z: ArrayLike, *, out: Out = None) -> Any:
    r"""Carlson's symmetric integral of the second kind, DLMF 19.16.3.

    .. math:: R_G(x,y,z) = \frac14 \int_0^\infty \frac{t}{\sqrt{(t+x)(t+y)(t+z)}}
       \left(\frac{x}{t+x}+\frac{y}{t+y}+\frac{z}{t+z}\right) dt

    x, y, z >= 0, symmetric. Outside: NaN.

    Special cases (DLMF 19.20(ii)): R_G(0,0,z) = sqrt(z)/2; R_G(x,x,x) = sqrt(x); an infinite
    argument: +Inf.

    Accuracy: 3 ulp.

    Parameters
    ----------
    x : array_like
        number
    y : array_like
        number
    z : array_like
        number
    out : ndarray, optional
        where the result goes

    Returns
    -------
    float or ndarray
        RG
    """
    if type(x) is float and type(y) is float and type(z) is float and out is None:
        return _carlson_rg.one(x, y, z)
    return _carlson_rg(out, x, y, z)


_nome_k = Routine("nome_k", ("k",), None)


def nome_k(k: ArrayLike, *, out: Out = None) -> Any:
    r"""Jacobi's nome of the modulus k, `abs(k) <= 1`, m = k^2; of the sign of m.

    .. math:: q = \exp\left(-\pi \frac{K(1 - m)}{K(m)}\right), \quad q(m) = -q(m/(m-1))

    Special cases: q(m=0) = 0, q(m=1) = 1, q(m=-1) = -exp(-pi), q(m=-Inf) = -1; NaN outside, NaN in
    gives NaN out.

    Accuracy: 1 ulp, also as q -> 0 (q ~ m/16, down to the smallest number).

    Parameters
    ----------
    k : array_like
        modulus, m = k^2
    out : ndarray, optional
        where the result goes

    Returns
    -------
    float or ndarray
        q
    """
    if type(k) is float and out is None:
        return _nome_k.one(k)
    return _nome_k(out, k)


_nome_m = Routine("nome_m", ("m",), None)


def nome_m(m: ArrayLike, *, out: Out = None) -> Any:
    r"""Jacobi's nome, of the parameter m = k^2, `m <= 1`.

    .. math:: q = \exp\left(-\pi \frac{K(1 - m)}{K(m)}\right), \quad q(m) = -q(m/(m-1))

    Special cases: q(m=0) = 0, q(m=1) = 1, q(m=-1) = -exp(-pi), q(m=-Inf) = -1; NaN outside, NaN in
    gives NaN out.

    Accuracy: 1 ulp, also as q -> 0 (q ~ m/16, down to the smallest number).

    Parameters
    ----------
    m : array_like
        parameter, m = k^2
    out : ndarray, optional
        where the result goes

    Returns
    -------
    float or ndarray
        q
    """
    if type(m) is float and out is None:
        return _nome_m.one(m)
    return _nome_m(out, m)


_nome_mc = Routine("nome_mc", ("mc",), None)


def nome_mc(mc: ArrayLike, *, out: Out = None) -> Any:
    r"""Jacobi's nome, of the complementary parameter mc = 1 - m, `mc >= 0`.

    .. math:: q = \exp\left(-\pi \frac{K(1 - m)}{K(m)}\right), \quad q(m) = -q(m/(m-1))

    Special cases: q(m=0) = 0, q(m=1) = 1, q(m=-1) = -exp(-pi), q(m=-Inf) = -1; NaN outside, NaN in
    gives NaN out.

    Accuracy: 1 ulp, also as q -> 0 (q ~ m/16, down to the smallest number).

    Parameters
    ----------
    mc : array_like
        complementary parameter 1 - m
    out : ndarray, optional
        where the result goes

    Returns
    -------
    float or ndarray
        q
    """
    if type(mc) is float and out is None:
        return _nome_mc.one(mc)
    return _nome_mc(out, mc)


_parameter_from_nome = Routine("parameter_from_nome", ("q",), None)


def parameter_from_nome(q: ArrayLike, *, out: Out = None) -> Any:
    r"""The parameter m of Jacobi's nome q, `abs(q) <= 1`: the inverse of nome_m.

    .. math:: m = \left(\frac{\theta_2(0,q)}{\theta_3(0,q)}\right)^4

    Special cases: m(q=0) = 0, m(q=1) = 1, m(q=-1) = -Inf; NaN outside, NaN in gives NaN out. Near q
    = -1 it grows beyond the range, where pi^2/log(-q) passes the logarithm of the largest number.

    Accuracy: 1 ulp of the exact inverse of q as given, which near q = -1 means little: m's relative
    error is that of q times (pi/log(-q))^2.

    Parameters
    ----------
    q : array_like
        nome
    out : ndarray, optional
        where the result goes

    Returns
    -------
    float or ndarray
        m
    """
    if type(q) is float and out is None:
        return _parameter_from_nome.one(q)
    return _parameter_from_nome(out, q)


_complementary_parameter_from_nome = Routine("complementary_parameter_from_nome", ("q",), None)


def complementary_parameter_from_nome(q: ArrayLike, *, out: Out = None) -> Any:
    r"""The complementary parameter mc = 1 - m of Jacobi's nome q, `abs(q) <= 1`: the inverse of
    nome_mc.

    .. math:: 1 - m = \left(\frac{\theta_4(0,q)}{\theta_3(0,q)}\right)^4

    Special cases: mc(q=0) = 1, mc(q=1) = 0, mc(q=-1) = +Inf; NaN outside, NaN in gives NaN out.
    Near q = 1 it is 16 exp(pi^2/log(q)): below the smallest number, so 0, from q = 0.9869 (float32:
    0.9117; real128: 0.99914) on.

    Accuracy: 1 ulp of the exact inverse of q as given: a relative error of q counts (pi/log(q))^2
    times.

    Parameters
    ----------
    q : array_like
        nome
    out : ndarray, optional
        where the result goes

    Returns
    -------
    float or ndarray
        mc
    """
    if type(q) is float and out is None:
        return _complementary_parameter_from_nome.one(q)
    return _complementary_parameter_from_nome(out, q)


_theta1 = Routine("theta1", ("z", "q"), None)


def theta1(z: ArrayLike, q: ArrayLike, *, out: Out = None) -> Any:
    r"""Jacobi's theta function theta_1 of the angle z in radians and the nome q, DLMF 20.2.1.

    .. math:: \theta_1(z,q) = 2 \sum_{n=0}^\infty (-1)^n q^{(n+1/2)^2} \sin((2n+1)z)

    Any real z in radians, 0 <= q < 1. Outside: NaN.

    Accuracy: 1 ulp of what z and q say, next to zeros too, and down to the smallest number as q ->
    1.

    Parameters
    ----------
    z : array_like
        number
    q : array_like
        nome
    out : ndarray, optional
        where the result goes

    Returns
    -------
    float or ndarray
        theta1
    """
    if type(z) is float and type(q) is float and out is None:
        return _theta1.one(z, q)
    return _theta1(out, z, q)


_theta2 = Routine("theta2", ("z", "q"), None)


def theta2(z: ArrayLike, q: ArrayLike, *, out: Out = None) -> Any:
    r"""Jacobi's theta function theta_2 of the angle z in radians and the nome q, DLMF 20.2.2.

    .. math:: \theta_2(z,q) = 2 \sum_{n=0}^\infty q^{(n+1/2)^2} \cos((2n+1)z)

    Any real z in radians, 0 <= q < 1. Outside: NaN.

    Accuracy: 1 ulp of what z and q say, next to zeros too, and down to the smallest number as q ->
    1.

    Parameters
    ----------
    z : array_like
        number
    q : array_like
        nome
    out : ndarray, optional
        where the result goes

    Returns
    -------
    float or ndarray
        theta2
    """
    if type(z) is float and type(q) is float and out is None:
        return _theta2.one(z, q)
    return _theta2(out, z, q)


_theta3 = Routine("theta3", ("z", "q"), None)


def theta3(z: ArrayLike, q: ArrayLike, *, out: Out = None) -> Any:
    r"""Jacobi's theta function theta_3 of the angle z in radians and the nome q, DLMF 20.2.3.

    .. math:: \theta_3(z,q) = 1 + 2 \sum_{n=1}^\infty q^{n^2} \cos(2nz)

    Any real z in radians, 0 <= q < 1. Outside: NaN.

    Accuracy: 1 ulp of what z and q say, next to zeros too, and down to the smallest number as q ->
    1.

    Parameters
    ----------
    z : array_like
        number
    q : array_like
        nome
    out : ndarray, optional
        where the result goes

    Returns
    -------
    float or ndarray
        theta3
    """
    if type(z) is float and type(q) is float and out is None:
        return _theta3.one(z, q)
    return _theta3(out, z, q)


_theta4 = Routine("theta4", ("z", "q"), None)


def theta4(z: ArrayLike, q: ArrayLike, *, out: Out = None) -> Any:
    r"""Jacobi's theta function theta_4 of the angle z in radians and the nome q, DLMF 20.2.4.

    .. math:: \theta_4(z,q) = 1 + 2 \sum_{n=1}^\infty (-1)^n q^{n^2} \cos(2nz)

    Any real z in radians, 0 <= q < 1. Outside: NaN.

    Accuracy: 1 ulp of what z and q say, next to zeros too, and down to the smallest number as q ->
    1.

    Parameters
    ----------
    z : array_like
        number
    q : array_like
        nome
    out : ndarray, optional
        where the result goes

    Returns
    -------
    float or ndarray
        theta4
    """
    if type(z) is float and type(q) is float and out is None:
        return _theta4.one(z, q)
    return _theta4(out, z, q)


_theta1_prime = Routine("theta1_prime", ("z", "q"), None)


def theta1_prime(z: ArrayLike, q: ArrayLike, *, out: Out = None) -> Any:
    r"""Derivative of theta1 with respect to z.

    .. math:: \theta_1(z,q) = 2 \sum_{n=0}^\infty (-1)^n q^{(n+1/2)^2} \sin((2n+1)z)

    Any real z in radians, 0 <= q < 1. Outside: NaN.

    Accuracy: 1 ulp of what z and q say, next to zeros too, and down to the smallest number as q ->
    1.

    Parameters
    ----------
    z : array_like
        number
    q : array_like
        nome
    out : ndarray, optional
        where the result goes

    Returns
    -------
    float or ndarray
        theta1'
    """
    if type(z) is float and type(q) is float and out is None:
        return _theta1_prime.one(z, q)
    return _theta1_prime(out, z, q)


_theta2_prime = Routine("theta2_prime", ("z", "q"), None)


def theta2_prime(z: ArrayLike, q: ArrayLike, *, out: Out = None) -> Any:
    r"""Derivative of theta2 with respect to z.

    .. math:: \theta_2(z,q) = 2 \sum_{n=0}^\infty q^{(n+1/2)^2} \cos((2n+1)z)

    Any real z in radians, 0 <= q < 1. Outside: NaN.

    Accuracy: 1 ulp of what z and q say, next to zeros too, and down to the smallest number as q ->
    1.

    Parameters
    ----------
    z : array_like
        number
    q : array_like
        nome
    out : ndarray, optional
        where the result goes

    Returns
    -------
    float or ndarray
        theta2'
    """
    if type(z) is float and type(q) is float and out is None:
        return _theta2_prime.one(z, q)
    return _theta2_prime(out, z, q)


_theta3_prime = Routine("theta3_prime", ("z", "q"), None)


def theta3_prime(z: ArrayLike, q: ArrayLike, *, out: Out = None) -> Any:
    r"""Derivative of theta3 with respect to z.

    .. math:: \theta_3(z,q) = 1 + 2 \sum_{n=1}^\infty q^{n^2} \cos(2nz)

    Any real z in radians, 0 <= q < 1. Outside: NaN.

    Accuracy: 1 ulp of what z and q say, next to zeros too, and down to the smallest number as q ->
    1.

    Parameters
    ----------
    z : array_like
        number
    q : array_like
        nome
    out : ndarray, optional
        where the result goes

    Returns
    -------
    float or ndarray
        theta3'
    """
    if type(z) is float and type(q) is float and out is None:
        return _theta3_prime.one(z, q)
    return _theta3_prime(out, z, q)


_theta4_prime = Routine("theta4_prime", ("z", "q"), None)


def theta4_prime(z: ArrayLike, q: ArrayLike, *, out: Out = None) -> Any:
    r"""Derivative of theta4 with respect to z.

    .. math:: \theta_4(z,q) = 1 + 2 \sum_{n=1}^\infty (-1)^n q^{n^2} \cos(2nz)

    Any real z in radians, 0 <= q < 1. Outside: NaN.

    Accuracy: 1 ulp of what z and q say, next to zeros too, and down to the smallest number as q ->
    1.

    Parameters
    ----------
    z : array_like
        number
    q : array_like
        nome
    out : ndarray, optional
        where the result goes

    Returns
    -------
    float or ndarray
        theta4'
    """
    if type(z) is float and type(q) is float and out is None:
        return _theta4_prime.one(z, q)
    return _theta4_prime(out, z, q)


_jacobi_k = Routine("jacobi_k", ("u", "k"), JacobiValues)


def jacobi_k(u: ArrayLike, k: ArrayLike, *, out: Outs = None) -> JacobiValues:
    r"""The Jacobi elliptic functions sn, cn and dn of u and the modulus k, m = k^2.

    .. math:: u = \int_0^{\operatorname{am} u} \frac{d\theta}{\sqrt{1 - m\sin^2\theta}}, \quad
       \operatorname{sn} u = \sin\operatorname{am} u, \quad \operatorname{cn} u =
       \cos\operatorname{am} u, \quad \operatorname{dn} u = \sqrt{1 - m\operatorname{sn}^2 u}

    Any finite u and m, negative m and m > 1 included.

    Special cases: m = 1: tanh, sech, sech; NaN for infinite u (m < 1) or k, and for NaN.

    Accuracy: 6 ulp of each function, next to its zeros too; 5 ulp of many u of one modulus. Far u,
    above about 2**(2 digits) quarter periods, take as many digits of K as they have, and their time
    (0.1 ms in float64).

    Definition: DLMF 22.2, 22.17 for m < 0 and m > 1.

    Parameters
    ----------
    u : array_like
        argument
    k : array_like
        modulus, m = k^2
    out : tuple of ndarray, optional
        where the result goes

    Returns
    -------
    JacobiValues
        sn, cn, dn: each a float, or an array
    """
    if type(u) is float and type(k) is float and out is None:
        return _jacobi_k.one(u, k)
    return _jacobi_k(out, u, k)


_jacobi_m = Routine("jacobi_m", ("u", "m"), JacobiValues)


def jacobi_m(u: ArrayLike, m: ArrayLike, *, out: Outs = None) -> JacobiValues:
    r"""The Jacobi elliptic functions sn, cn and dn, of the parameter m = k^2.

    .. math:: u = \int_0^{\operatorname{am} u} \frac{d\theta}{\sqrt{1 - m\sin^2\theta}}, \quad
       \operatorname{sn} u = \sin\operatorname{am} u, \quad \operatorname{cn} u =
       \cos\operatorname{am} u, \quad \operatorname{dn} u = \sqrt{1 - m\operatorname{sn}^2 u}

    Any finite u and m, negative m and m > 1 included.

    Special cases: m = 1: tanh, sech, sech; NaN for infinite u (m < 1) or k, and for NaN.

    Accuracy: 6 ulp of each function, next to its zeros too; 5 ulp of many u of one modulus. Far u,
    above about 2**(2 digits) quarter periods, take as many digits of K as they have, and their time
    (0.1 ms in float64).

    Definition: DLMF 22.2, 22.17 for m < 0 and m > 1.

    Parameters
    ----------
    u : array_like
        argument
    m : array_like
        parameter, m = k^2
    out : tuple of ndarray, optional
        where the result goes

    Returns
    -------
    JacobiValues
        sn, cn, dn: each a float, or an array
    """
    if type(u) is float and type(m) is float and out is None:
        return _jacobi_m.one(u, m)
    return _jacobi_m(out, u, m)


_jacobi_mc = Routine("jacobi_mc", ("u", "mc"), JacobiValues)


def jacobi_mc(u: ArrayLike, mc: ArrayLike, *, out: Outs = None) -> JacobiValues:
    r"""The Jacobi elliptic functions sn, cn and dn, of the complementary parameter mc = 1 - m.

    .. math:: u = \int_0^{\operatorname{am} u} \frac{d\theta}{\sqrt{1 - m\sin^2\theta}}, \quad
       \operatorname{sn} u = \sin\operatorname{am} u, \quad \operatorname{cn} u =
       \cos\operatorname{am} u, \quad \operatorname{dn} u = \sqrt{1 - m\operatorname{sn}^2 u}

    Any finite u and m, negative m and m > 1 included.

    Special cases: m = 1: tanh, sech, sech; NaN for infinite u (m < 1) or k, and for NaN.

    Accuracy: 6 ulp of each function, next to its zeros too; 5 ulp of many u of one modulus. Far u,
    above about 2**(2 digits) quarter periods, take as many digits of K as they have, and their time
    (0.1 ms in float64).

    Definition: DLMF 22.2, 22.17 for m < 0 and m > 1.

    Parameters
    ----------
    u : array_like
        argument
    mc : array_like
        complementary parameter 1 - m
    out : tuple of ndarray, optional
        where the result goes

    Returns
    -------
    JacobiValues
        sn, cn, dn: each a float, or an array
    """
    if type(u) is float and type(mc) is float and out is None:
        return _jacobi_mc.one(u, mc)
    return _jacobi_mc(out, u, mc)


_jacobi_am_k = Routine("jacobi_am_k", ("u", "k"), None)


def jacobi_am_k(u: ArrayLike, k: ArrayLike, *, out: Out = None) -> Any:
    r"""Jacobi's amplitude of u and the modulus k, m = k^2.

    Any finite u and m. Continuous in u, am(u + 2K) = am u + pi; for m > 1 it swings between
    -asin(1/k) and asin(1/k).

    Special cases: am(+-0) = +-0; m = 1: asin(tanh(u)); NaN for infinite k and NaN, for infinite u
    but where m = 1.

    Accuracy: 6 ulp.

    Definition: DLMF 22.16.1

    Parameters
    ----------
    u : array_like
        argument
    k : array_like
        modulus, m = k^2
    out : ndarray, optional
        where the result goes

    Returns
    -------
    float or ndarray
        am
    """
    if type(u) is float and type(k) is float and out is None:
        return _jacobi_am_k.one(u, k)
    return _jacobi_am_k(out, u, k)


_jacobi_am_m = Routine("jacobi_am_m", ("u", "m"), None)


def jacobi_am_m(u: ArrayLike, m: ArrayLike, *, out: Out = None) -> Any:
    r"""Jacobi's amplitude, of the parameter m = k^2.

    Any finite u and m. Continuous in u, am(u + 2K) = am u + pi; for m > 1 it swings between
    -asin(1/k) and asin(1/k).

    Special cases: am(+-0) = +-0; m = 1: asin(tanh(u)); NaN for infinite k and NaN, for infinite u
    but where m = 1.

    Accuracy: 6 ulp.

    Definition: DLMF 22.16.1

    Parameters
    ----------
    u : array_like
        argument
    m : array_like
        parameter, m = k^2
    out : ndarray, optional
        where the result goes

    Returns
    -------
    float or ndarray
        am
    """
    if type(u) is float and type(m) is float and out is None:
        return _jacobi_am_m.one(u, m)
    return _jacobi_am_m(out, u, m)


_jacobi_am_mc = Routine("jacobi_am_mc", ("u", "mc"), None)


def jacobi_am_mc(u: ArrayLike, mc: ArrayLike, *, out: Out = None) -> Any:
    r"""Jacobi's amplitude, of the complementary parameter mc = 1 - m.

    Any finite u and m. Continuous in u, am(u + 2K) = am u + pi; for m > 1 it swings between
    -asin(1/k) and asin(1/k).

    Special cases: am(+-0) = +-0; m = 1: asin(tanh(u)); NaN for infinite k and NaN, for infinite u
    but where m = 1.

    Accuracy: 6 ulp.

    Definition: DLMF 22.16.1

    Parameters
    ----------
    u : array_like
        argument
    mc : array_like
        complementary parameter 1 - m
    out : ndarray, optional
        where the result goes

    Returns
    -------
    float or ndarray
        am
    """
    if type(u) is float and type(mc) is float and out is None:
        return _jacobi_am_mc.one(u, mc)
    return _jacobi_am_mc(out, u, mc)


_jacobi_sn_k = Routine("jacobi_sn_k", ("u", "k"), None)


def jacobi_sn_k(u: ArrayLike, k: ArrayLike, *, out: Out = None) -> Any:
    r"""Jacobi's sn, DLMF 22.2.4, of u and the modulus k, m = k^2.

    .. math:: u = \int_0^{\operatorname{am} u} \frac{d\theta}{\sqrt{1 - m\sin^2\theta}}, \quad
       \operatorname{sn} u = \sin\operatorname{am} u, \quad \operatorname{cn} u =
       \cos\operatorname{am} u, \quad \operatorname{dn} u = \sqrt{1 - m\operatorname{sn}^2 u}

    Any finite u and m, negative m and m > 1 included.

    Special cases: m = 1: tanh, sech, sech; NaN for infinite u (m < 1) or k, and for NaN.

    Accuracy: 6 ulp of each function, next to its zeros too; 5 ulp of many u of one modulus. Far u,
    above about 2**(2 digits) quarter periods, take as many digits of K as they have, and their time
    (0.1 ms in float64).

    Definition: DLMF 22.2, 22.17 for m < 0 and m > 1.

    Parameters
    ----------
    u : array_like
        argument
    k : array_like
        modulus, m = k^2
    out : ndarray, optional
        where the result goes

    Returns
    -------
    float or ndarray
        sn
    """
    if type(u) is float and type(k) is float and out is None:
        return _jacobi_sn_k.one(u, k)
    return _jacobi_sn_k(out, u, k)


_jacobi_sn_m = Routine("jacobi_sn_m", ("u", "m"), None)


def jacobi_sn_m(u: ArrayLike, m: ArrayLike, *, out: Out = None) -> Any:
    r"""Jacobi's sn, of the parameter m = k^2.

    .. math:: u = \int_0^{\operatorname{am} u} \frac{d\theta}{\sqrt{1 - m\sin^2\theta}}, \quad
       \operatorname{sn} u = \sin\operatorname{am} u, \quad \operatorname{cn} u =
       \cos\operatorname{am} u, \quad \operatorname{dn} u = \sqrt{1 - m\operatorname{sn}^2 u}

    Any finite u and m, negative m and m > 1 included.

    Special cases: m = 1: tanh, sech, sech; NaN for infinite u (m < 1) or k, and for NaN.

    Accuracy: 6 ulp of each function, next to its zeros too; 5 ulp of many u of one modulus. Far u,
    above about 2**(2 digits) quarter periods, take as many digits of K as they have, and their time
    (0.1 ms in float64).

    Definition: DLMF 22.2, 22.17 for m < 0 and m > 1.

    Parameters
    ----------
    u : array_like
        argument
    m : array_like
        parameter, m = k^2
    out : ndarray, optional
        where the result goes

    Returns
    -------
    float or ndarray
        sn
    """
    if type(u) is float and type(m) is float and out is None:
        return _jacobi_sn_m.one(u, m)
    return _jacobi_sn_m(out, u, m)


_jacobi_sn_mc = Routine("jacobi_sn_mc", ("u", "mc"), None)


def jacobi_sn_mc(u: ArrayLike, mc: ArrayLike, *, out: Out = None) -> Any:
    r"""Jacobi's sn, of the complementary parameter mc = 1 - m.

    .. math:: u = \int_0^{\operatorname{am} u} \frac{d\theta}{\sqrt{1 - m\sin^2\theta}}, \quad
       \operatorname{sn} u = \sin\operatorname{am} u, \quad \operatorname{cn} u =
       \cos\operatorname{am} u, \quad \operatorname{dn} u = \sqrt{1 - m\operatorname{sn}^2 u}

    Any finite u and m, negative m and m > 1 included.

    Special cases: m = 1: tanh, sech, sech; NaN for infinite u (m < 1) or k, and for NaN.

    Accuracy: 6 ulp of each function, next to its zeros too; 5 ulp of many u of one modulus. Far u,
    above about 2**(2 digits) quarter periods, take as many digits of K as they have, and their time
    (0.1 ms in float64).

    Definition: DLMF 22.2, 22.17 for m < 0 and m > 1.

    Parameters
    ----------
    u : array_like
        argument
    mc : array_like
        complementary parameter 1 - m
    out : ndarray, optional
        where the result goes

    Returns
    -------
    float or ndarray
        sn
    """
    if type(u) is float and type(mc) is float and out is None:
        return _jacobi_sn_mc.one(u, mc)
    return _jacobi_sn_mc(out, u, mc)


_jacobi_cn_k = Routine("jacobi_cn_k", ("u", "k"), None)


def jacobi_cn_k(u: ArrayLike, k: ArrayLike, *, out: Out = None) -> Any:
    r"""Jacobi's cn, DLMF 22.2.5, of u and the modulus k, m = k^2.

    .. math:: u = \int_0^{\operatorname{am} u} \frac{d\theta}{\sqrt{1 - m\sin^2\theta}}, \quad
       \operatorname{sn} u = \sin\operatorname{am} u, \quad \operatorname{cn} u =
       \cos\operatorname{am} u, \quad \operatorname{dn} u = \sqrt{1 - m\operatorname{sn}^2 u}

    Any finite u and m, negative m and m > 1 included.

    Special cases: m = 1: tanh, sech, sech; NaN for infinite u (m < 1) or k, and for NaN.

    Accuracy: 6 ulp of each function, next to its zeros too; 5 ulp of many u of one modulus. Far u,
    above about 2**(2 digits) quarter periods, take as many digits of K as they have, and their time
    (0.1 ms in float64).

    Definition: DLMF 22.2, 22.17 for m < 0 and m > 1.

    Parameters
    ----------
    u : array_like
        argument
    k : array_like
        modulus, m = k^2
    out : ndarray, optional
        where the result goes

    Returns
    -------
    float or ndarray
        cn
    """
    if type(u) is float and type(k) is float and out is None:
        return _jacobi_cn_k.one(u, k)
    return _jacobi_cn_k(out, u, k)


_jacobi_cn_m = Routine("jacobi_cn_m", ("u", "m"), None)


def jacobi_cn_m(u: ArrayLike, m: ArrayLike, *, out: Out = None) -> Any:
    r"""Jacobi's cn, of the parameter m = k^2.

    .. math:: u = \int_0^{\operatorname{am} u} \frac{d\theta}{\sqrt{1 - m\sin^2\theta}}, \quad
       \operatorname{sn} u = \sin\operatorname{am} u, \quad \operatorname{cn} u =
       \cos\operatorname{am} u, \quad \operatorname{dn} u = \sqrt{1 - m\operatorname{sn}^2 u}

    Any finite u and m, negative m and m > 1 included.

    Special cases: m = 1: tanh, sech, sech; NaN for infinite u (m < 1) or k, and for NaN.

    Accuracy: 6 ulp of each function, next to its zeros too; 5 ulp of many u of one modulus. Far u,
    above about 2**(2 digits) quarter periods, take as many digits of K as they have, and their time
    (0.1 ms in float64).

    Definition: DLMF 22.2, 22.17 for m < 0 and m > 1.

    Parameters
    ----------
    u : array_like
        argument
    m : array_like
        parameter, m = k^2
    out : ndarray, optional
        where the result goes

    Returns
    -------
    float or ndarray
        cn
    """
    if type(u) is float and type(m) is float and out is None:
        return _jacobi_cn_m.one(u, m)
    return _jacobi_cn_m(out, u, m)


_jacobi_cn_mc = Routine("jacobi_cn_mc", ("u", "mc"), None)


def jacobi_cn_mc(u: ArrayLike, mc: ArrayLike, *, out: Out = None) -> Any:
    r"""Jacobi's cn, of the complementary parameter mc = 1 - m.

    .. math:: u = \int_0^{\operatorname{am} u} \frac{d\theta}{\sqrt{1 - m\sin^2\theta}}, \quad
       \operatorname{sn} u = \sin\operatorname{am} u, \quad \operatorname{cn} u =
       \cos\operatorname{am} u, \quad \operatorname{dn} u = \sqrt{1 - m\operatorname{sn}^2 u}

    Any finite u and m, negative m and m > 1 included.

    Special cases: m = 1: tanh, sech, sech; NaN for infinite u (m < 1) or k, and for NaN.

    Accuracy: 6 ulp of each function, next to its zeros too; 5 ulp of many u of one modulus. Far u,
    above about 2**(2 digits) quarter periods, take as many digits of K as they have, and their time
    (0.1 ms in float64).

    Definition: DLMF 22.2, 22.17 for m < 0 and m > 1.

    Parameters
    ----------
    u : array_like
        argument
    mc : array_like
        complementary parameter 1 - m
    out : ndarray, optional
        where the result goes

    Returns
    -------
    float or ndarray
        cn
    """
    if type(u) is float and type(mc) is float and out is None:
        return _jacobi_cn_mc.one(u, mc)
    return _jacobi_cn_mc(out, u, mc)


_jacobi_dn_k = Routine("jacobi_dn_k", ("u", "k"), None)


def jacobi_dn_k(u: ArrayLike, k: ArrayLike, *, out: Out = None) -> Any:
    r"""Jacobi's dn, DLMF 22.2.6, of u and the modulus k, m = k^2.

    .. math:: u = \int_0^{\operatorname{am} u} \frac{d\theta}{\sqrt{1 - m\sin^2\theta}}, \quad
       \operatorname{sn} u = \sin\operatorname{am} u, \quad \operatorname{cn} u =
       \cos\operatorname{am} u, \quad \operatorname{dn} u = \sqrt{1 - m\operatorname{sn}^2 u}

    Any finite u and m, negative m and m > 1 included.

    Special cases: m = 1: tanh, sech, sech; NaN for infinite u (m < 1) or k, and for NaN.

    Accuracy: 6 ulp of each function, next to its zeros too; 5 ulp of many u of one modulus. Far u,
    above about 2**(2 digits) quarter periods, take as many digits of K as they have, and their time
    (0.1 ms in float64).

    Definition: DLMF 22.2, 22.17 for m < 0 and m > 1.

    Parameters
    ----------
    u : array_like
        argument
    k : array_like
        modulus, m = k^2
    out : ndarray, optional
        where the result goes

    Returns
    -------
    float or ndarray
        dn
    """
    if type(u) is float and type(k) is float and out is None:
        return _jacobi_dn_k.one(u, k)
    return _jacobi_dn_k(out, u, k)


_jacobi_dn_m = Routine("jacobi_dn_m", ("u", "m"), None)


def jacobi_dn_m(u: ArrayLike, m: ArrayLike, *, out: Out = None) -> Any:
    r"""Jacobi's dn, of the parameter m = k^2.

    .. math:: u = \int_0^{\operatorname{am} u} \frac{d\theta}{\sqrt{1 - m\sin^2\theta}}, \quad
       \operatorname{sn} u = \sin\operatorname{am} u, \quad \operatorname{cn} u =
       \cos\operatorname{am} u, \quad \operatorname{dn} u = \sqrt{1 - m\operatorname{sn}^2 u}

    Any finite u and m, negative m and m > 1 included.

    Special cases: m = 1: tanh, sech, sech; NaN for infinite u (m < 1) or k, and for NaN.

    Accuracy: 6 ulp of each function, next to its zeros too; 5 ulp of many u of one modulus. Far u,
    above about 2**(2 digits) quarter periods, take as many digits of K as they have, and their time
    (0.1 ms in float64).

    Definition: DLMF 22.2, 22.17 for m < 0 and m > 1.

    Parameters
    ----------
    u : array_like
        argument
    m : array_like
        parameter, m = k^2
    out : ndarray, optional
        where the result goes

    Returns
    -------
    float or ndarray
        dn
    """
    if type(u) is float and type(m) is float and out is None:
        return _jacobi_dn_m.one(u, m)
    return _jacobi_dn_m(out, u, m)


_jacobi_dn_mc = Routine("jacobi_dn_mc", ("u", "mc"), None)


def jacobi_dn_mc(u: ArrayLike, mc: ArrayLike, *, out: Out = None) -> Any:
    r"""Jacobi's dn, of the complementary parameter mc = 1 - m.

    .. math:: u = \int_0^{\operatorname{am} u} \frac{d\theta}{\sqrt{1 - m\sin^2\theta}}, \quad
       \operatorname{sn} u = \sin\operatorname{am} u, \quad \operatorname{cn} u =
       \cos\operatorname{am} u, \quad \operatorname{dn} u = \sqrt{1 - m\operatorname{sn}^2 u}

    Any finite u and m, negative m and m > 1 included.

    Special cases: m = 1: tanh, sech, sech; NaN for infinite u (m < 1) or k, and for NaN.

    Accuracy: 6 ulp of each function, next to its zeros too; 5 ulp of many u of one modulus. Far u,
    above about 2**(2 digits) quarter periods, take as many digits of K as they have, and their time
    (0.1 ms in float64).

    Definition: DLMF 22.2, 22.17 for m < 0 and m > 1.

    Parameters
    ----------
    u : array_like
        argument
    mc : array_like
        complementary parameter 1 - m
    out : ndarray, optional
        where the result goes

    Returns
    -------
    float or ndarray
        dn
    """
    if type(u) is float and type(mc) is float and out is None:
        return _jacobi_dn_mc.one(u, mc)
    return _jacobi_dn_mc(out, u, mc)


_jacobi_ns_k = Routine("jacobi_ns_k", ("u", "k"), None)


def jacobi_ns_k(u: ArrayLike, k: ArrayLike, *, out: Out = None) -> Any:
    r"""Jacobi's ns = 1/sn, of u and the modulus k, m = k^2.

    .. math:: u = \int_0^{\operatorname{am} u} \frac{d\theta}{\sqrt{1 - m\sin^2\theta}}, \quad
       \operatorname{sn} u = \sin\operatorname{am} u, \quad \operatorname{cn} u =
       \cos\operatorname{am} u, \quad \operatorname{dn} u = \sqrt{1 - m\operatorname{sn}^2 u}

    Any finite u and m, negative m and m > 1 included.

    Special cases: m = 1: tanh, sech, sech; NaN for infinite u (m < 1) or k, and for NaN.

    Accuracy: 6 ulp of each function, next to its zeros too; 5 ulp of many u of one modulus. Far u,
    above about 2**(2 digits) quarter periods, take as many digits of K as they have, and their time
    (0.1 ms in float64).

    Definition: DLMF 22.2, 22.17 for m < 0 and m > 1.

    Parameters
    ----------
    u : array_like
        argument
    k : array_like
        modulus, m = k^2
    out : ndarray, optional
        where the result goes

    Returns
    -------
    float or ndarray
        ns
    """
    if type(u) is float and type(k) is float and out is None:
        return _jacobi_ns_k.one(u, k)
    return _jacobi_ns_k(out, u, k)


_jacobi_ns_m = Routine("jacobi_ns_m", ("u", "m"), None)


def jacobi_ns_m(u: ArrayLike, m: ArrayLike, *, out: Out = None) -> Any:
    r"""Jacobi's ns = 1/sn, of the parameter m = k^2.

    .. math:: u = \int_0^{\operatorname{am} u} \frac{d\theta}{\sqrt{1 - m\sin^2\theta}}, \quad
       \operatorname{sn} u = \sin\operatorname{am} u, \quad \operatorname{cn} u =
       \cos\operatorname{am} u, \quad \operatorname{dn} u = \sqrt{1 - m\operatorname{sn}^2 u}

    Any finite u and m, negative m and m > 1 included.

    Special cases: m = 1: tanh, sech, sech; NaN for infinite u (m < 1) or k, and for NaN.

    Accuracy: 6 ulp of each function, next to its zeros too; 5 ulp of many u of one modulus. Far u,
    above about 2**(2 digits) quarter periods, take as many digits of K as they have, and their time
    (0.1 ms in float64).

    Definition: DLMF 22.2, 22.17 for m < 0 and m > 1.

    Parameters
    ----------
    u : array_like
        argument
    m : array_like
        parameter, m = k^2
    out : ndarray, optional
        where the result goes

    Returns
    -------
    float or ndarray
        ns
    """
    if type(u) is float and type(m) is float and out is None:
        return _jacobi_ns_m.one(u, m)
    return _jacobi_ns_m(out, u, m)


_jacobi_ns_mc = Routine("jacobi_ns_mc", ("u", "mc"), None)


def jacobi_ns_mc(u: ArrayLike, mc: ArrayLike, *, out: Out = None) -> Any:
    r"""Jacobi's ns = 1/sn, of the complementary parameter mc = 1 - m.

    .. math:: u = \int_0^{\operatorname{am} u} \frac{d\theta}{\sqrt{1 - m\sin^2\theta}}, \quad
       \operatorname{sn} u = \sin\operatorname{am} u, \quad \operatorname{cn} u =
       \cos\operatorname{am} u, \quad \operatorname{dn} u = \sqrt{1 - m\operatorname{sn}^2 u}

    Any finite u and m, negative m and m > 1 included.

    Special cases: m = 1: tanh, sech, sech; NaN for infinite u (m < 1) or k, and for NaN.

    Accuracy: 6 ulp of each function, next to its zeros too; 5 ulp of many u of one modulus. Far u,
    above about 2**(2 digits) quarter periods, take as many digits of K as they have, and their time
    (0.1 ms in float64).

    Definition: DLMF 22.2, 22.17 for m < 0 and m > 1.

    Parameters
    ----------
    u : array_like
        argument
    mc : array_like
        complementary parameter 1 - m
    out : ndarray, optional
        where the result goes

    Returns
    -------
    float or ndarray
        ns
    """
    if type(u) is float and type(mc) is float and out is None:
        return _jacobi_ns_mc.one(u, mc)
    return _jacobi_ns_mc(out, u, mc)


_jacobi_nc_k = Routine("jacobi_nc_k", ("u", "k"), None)


def jacobi_nc_k(u: ArrayLike, k: ArrayLike, *, out: Out = None) -> Any:
    r"""Jacobi's nc = 1/cn, of u and the modulus k, m = k^2.

    .. math:: u = \int_0^{\operatorname{am} u} \frac{d\theta}{\sqrt{1 - m\sin^2\theta}}, \quad
       \operatorname{sn} u = \sin\operatorname{am} u, \quad \operatorname{cn} u =
       \cos\operatorname{am} u, \quad \operatorname{dn} u = \sqrt{1 - m\operatorname{sn}^2 u}

    Any finite u and m, negative m and m > 1 included.

    Special cases: m = 1: tanh, sech, sech; NaN for infinite u (m < 1) or k, and for NaN.

    Accuracy: 6 ulp of each function, next to its zeros too; 5 ulp of many u of one modulus. Far u,
    above about 2**(2 digits) quarter periods, take as many digits of K as they have, and their time
    (0.1 ms in float64).

    Definition: DLMF 22.2, 22.17 for m < 0 and m > 1.

    Parameters
    ----------
    u : array_like
        argument
    k : array_like
        modulus, m = k^2
    out : ndarray, optional
        where the result goes

    Returns
    -------
    float or ndarray
        nc
    """
    if type(u) is float and type(k) is float and out is None:
        return _jacobi_nc_k.one(u, k)
    return _jacobi_nc_k(out, u, k)


_jacobi_nc_m = Routine("jacobi_nc_m", ("u", "m"), None)


def jacobi_nc_m(u: ArrayLike, m: ArrayLike, *, out: Out = None) -> Any:
    r"""Jacobi's nc = 1/cn, of the parameter m = k^2.

    .. math:: u = \int_0^{\operatorname{am} u} \frac{d\theta}{\sqrt{1 - m\sin^2\theta}}, \quad
       \operatorname{sn} u = \sin\operatorname{am} u, \quad \operatorname{cn} u =
       \cos\operatorname{am} u, \quad \operatorname{dn} u = \sqrt{1 - m\operatorname{sn}^2 u}

    Any finite u and m, negative m and m > 1 included.

    Special cases: m = 1: tanh, sech, sech; NaN for infinite u (m < 1) or k, and for NaN.

    Accuracy: 6 ulp of each function, next to its zeros too; 5 ulp of many u of one modulus. Far u,
    above about 2**(2 digits) quarter periods, take as many digits of K as they have, and their time
    (0.1 ms in float64).

    Definition: DLMF 22.2, 22.17 for m < 0 and m > 1.

    Parameters
    ----------
    u : array_like
        argument
    m : array_like
        parameter, m = k^2
    out : ndarray, optional
        where the result goes

    Returns
    -------
    float or ndarray
        nc
    """
    if type(u) is float and type(m) is float and out is None:
        return _jacobi_nc_m.one(u, m)
    return _jacobi_nc_m(out, u, m)


_jacobi_nc_mc = Routine("jacobi_nc_mc", ("u", "mc"), None)


def jacobi_nc_mc(u: ArrayLike, mc: ArrayLike, *, out: Out = None) -> Any:
    r"""Jacobi's nc = 1/cn, of the complementary parameter mc = 1 - m.

    .. math:: u = \int_0^{\operatorname{am} u} \frac{d\theta}{\sqrt{1 - m\sin^2\theta}}, \quad
       \operatorname{sn} u = \sin\operatorname{am} u, \quad \operatorname{cn} u =
       \cos\operatorname{am} u, \quad \operatorname{dn} u = \sqrt{1 - m\operatorname{sn}^2 u}

    Any finite u and m, negative m and m > 1 included.

    Special cases: m = 1: tanh, sech, sech; NaN for infinite u (m < 1) or k, and for NaN.

    Accuracy: 6 ulp of each function, next to its zeros too; 5 ulp of many u of one modulus. Far u,
    above about 2**(2 digits) quarter periods, take as many digits of K as they have, and their time
    (0.1 ms in float64).

    Definition: DLMF 22.2, 22.17 for m < 0 and m > 1.

    Parameters
    ----------
    u : array_like
        argument
    mc : array_like
        complementary parameter 1 - m
    out : ndarray, optional
        where the result goes

    Returns
    -------
    float or ndarray
        nc
    """
    if type(u) is float and type(mc) is float and out is None:
        return _jacobi_nc_mc.one(u, mc)
    return _jacobi_nc_mc(out, u, mc)


_jacobi_nd_k = Routine("jacobi_nd_k", ("u", "k"), None)


def jacobi_nd_k(u: ArrayLike, k: ArrayLike, *, out: Out = None) -> Any:
    r"""Jacobi's nd = 1/dn, of u and the modulus k, m = k^2.

    .. math:: u = \int_0^{\operatorname{am} u} \frac{d\theta}{\sqrt{1 - m\sin^2\theta}}, \quad
       \operatorname{sn} u = \sin\operatorname{am} u, \quad \operatorname{cn} u =
       \cos\operatorname{am} u, \quad \operatorname{dn} u = \sqrt{1 - m\operatorname{sn}^2 u}

    Any finite u and m, negative m and m > 1 included.

    Special cases: m = 1: tanh, sech, sech; NaN for infinite u (m < 1) or k, and for NaN.

    Accuracy: 6 ulp of each function, next to its zeros too; 5 ulp of many u of one modulus. Far u,
    above about 2**(2 digits) quarter periods, take as many digits of K as they have, and their time
    (0.1 ms in float64).

    Definition: DLMF 22.2, 22.17 for m < 0 and m > 1.

    Parameters
    ----------
    u : array_like
        argument
    k : array_like
        modulus, m = k^2
    out : ndarray, optional
        where the result goes

    Returns
    -------
    float or ndarray
        nd
    """
    if type(u) is float and type(k) is float and out is None:
        return _jacobi_nd_k.one(u, k)
    return _jacobi_nd_k(out, u, k)


_jacobi_nd_m = Routine("jacobi_nd_m", ("u", "m"), None)


def jacobi_nd_m(u: ArrayLike, m: ArrayLike, *, out: Out = None) -> Any:
    r"""Jacobi's nd = 1/dn, of the parameter m = k^2.

    .. math:: u = \int_0^{\operatorname{am} u} \frac{d\theta}{\sqrt{1 - m\sin^2\theta}}, \quad
       \operatorname{sn} u = \sin\operatorname{am} u, \quad \operatorname{cn} u =
       \cos\operatorname{am} u, \quad \operatorname{dn} u = \sqrt{1 - m\operatorname{sn}^2 u}

    Any finite u and m, negative m and m > 1 included.

    Special cases: m = 1: tanh, sech, sech; NaN for infinite u (m < 1) or k, and for NaN.

    Accuracy: 6 ulp of each function, next to its zeros too; 5 ulp of many u of one modulus. Far u,
    above about 2**(2 digits) quarter periods, take as many digits of K as they have, and their time
    (0.1 ms in float64).

    Definition: DLMF 22.2, 22.17 for m < 0 and m > 1.

    Parameters
    ----------
    u : array_like
        argument
    m : array_like
        parameter, m = k^2
    out : ndarray, optional
        where the result goes

    Returns
    -------
    float or ndarray
        nd
    """
    if type(u) is float and type(m) is float and out is None:
        return _jacobi_nd_m.one(u, m)
    return _jacobi_nd_m(out, u, m)


_jacobi_nd_mc = Routine("jacobi_nd_mc", ("u", "mc"), None)


def jacobi_nd_mc(u: ArrayLike, mc: ArrayLike, *, out: Out = None) -> Any:
    r"""Jacobi's nd = 1/dn, of the complementary parameter mc = 1 - m.

    .. math:: u = \int_0^{\operatorname{am} u} \frac{d\theta}{\sqrt{1 - m\sin^2\theta}}, \quad
       \operatorname{sn} u = \sin\operatorname{am} u, \quad \operatorname{cn} u =
       \cos\operatorname{am} u, \quad \operatorname{dn} u = \sqrt{1 - m\operatorname{sn}^2 u}

    Any finite u and m, negative m and m > 1 included.

    Special cases: m = 1: tanh, sech, sech; NaN for infinite u (m < 1) or k, and for NaN.

    Accuracy: 6 ulp of each function, next to its zeros too; 5 ulp of many u of one modulus. Far u,
    above about 2**(2 digits) quarter periods, take as many digits of K as they have, and their time
    (0.1 ms in float64).

    Definition: DLMF 22.2, 22.17 for m < 0 and m > 1.

    Parameters
    ----------
    u : array_like
        argument
    mc : array_like
        complementary parameter 1 - m
    out : ndarray, optional
        where the result goes

    Returns
    -------
    float or ndarray
        nd
    """
    if type(u) is float and type(mc) is float and out is None:
        return _jacobi_nd_mc.one(u, mc)
    return _jacobi_nd_mc(out, u, mc)


_jacobi_sc_k = Routine("jacobi_sc_k", ("u", "k"), None)


def jacobi_sc_k(u: ArrayLike, k: ArrayLike, *, out: Out = None) -> Any:
    r"""Jacobi's sc = sn/cn, of u and the modulus k, m = k^2.

    .. math:: u = \int_0^{\operatorname{am} u} \frac{d\theta}{\sqrt{1 - m\sin^2\theta}}, \quad
       \operatorname{sn} u = \sin\operatorname{am} u, \quad \operatorname{cn} u =
       \cos\operatorname{am} u, \quad \operatorname{dn} u = \sqrt{1 - m\operatorname{sn}^2 u}

    Any finite u and m, negative m and m > 1 included.

    Special cases: m = 1: tanh, sech, sech; NaN for infinite u (m < 1) or k, and for NaN.

    Accuracy: 6 ulp of each function, next to its zeros too; 5 ulp of many u of one modulus. Far u,
    above about 2**(2 digits) quarter periods, take as many digits of K as they have, and their time
    (0.1 ms in float64).

    Definition: DLMF 22.2, 22.17 for m < 0 and m > 1.

    Parameters
    ----------
    u : array_like
        argument
    k : array_like
        modulus, m = k^2
    out : ndarray, optional
        where the result goes

    Returns
    -------
    float or ndarray
        sc
    """
    if type(u) is float and type(k) is float and out is None:
        return _jacobi_sc_k.one(u, k)
    return _jacobi_sc_k(out, u, k)


_jacobi_sc_m = Routine("jacobi_sc_m", ("u", "m"), None)


def jacobi_sc_m(u: ArrayLike, m: ArrayLike, *, out: Out = None) -> Any:
    r"""Jacobi's sc = sn/cn, of the parameter m = k^2.

    .. math:: u = \int_0^{\operatorname{am} u} \frac{d\theta}{\sqrt{1 - m\sin^2\theta}}, \quad
       \operatorname{sn} u = \sin\operatorname{am} u, \quad \operatorname{cn} u =
       \cos\operatorname{am} u, \quad \operatorname{dn} u = \sqrt{1 - m\operatorname{sn}^2 u}

    Any finite u and m, negative m and m > 1 included.

    Special cases: m = 1: tanh, sech, sech; NaN for infinite u (m < 1) or k, and for NaN.

    Accuracy: 6 ulp of each function, next to its zeros too; 5 ulp of many u of one modulus. Far u,
    above about 2**(2 digits) quarter periods, take as many digits of K as they have, and their time
    (0.1 ms in float64).

    Definition: DLMF 22.2, 22.17 for m < 0 and m > 1.

    Parameters
    ----------
    u : array_like
        argument
    m : array_like
        parameter, m = k^2
    out : ndarray, optional
        where the result goes

    Returns
    -------
    float or ndarray
        sc
    """
    if type(u) is float and type(m) is float and out is None:
        return _jacobi_sc_m.one(u, m)
    return _jacobi_sc_m(out, u, m)


_jacobi_sc_mc = Routine("jacobi_sc_mc", ("u", "mc"), None)


def jacobi_sc_mc(u: ArrayLike, mc: ArrayLike, *, out: Out = None) -> Any:
    r"""Jacobi's sc = sn/cn, of the complementary parameter mc = 1 - m.

    .. math:: u = \int_0^{\operatorname{am} u} \frac{d\theta}{\sqrt{1 - m\sin^2\theta}}, \quad
       \operatorname{sn} u = \sin\operatorname{am} u, \quad \operatorname{cn} u =
       \cos\operatorname{am} u, \quad \operatorname{dn} u = \sqrt{1 - m\operatorname{sn}^2 u}

    Any finite u and m, negative m and m > 1 included.

    Special cases: m = 1: tanh, sech, sech; NaN for infinite u (m < 1) or k, and for NaN.

    Accuracy: 6 ulp of each function, next to its zeros too; 5 ulp of many u of one modulus. Far u,
    above about 2**(2 digits) quarter periods, take as many digits of K as they have, and their time
    (0.1 ms in float64).

    Definition: DLMF 22.2, 22.17 for m < 0 and m > 1.

    Parameters
    ----------
    u : array_like
        argument
    mc : array_like
        complementary parameter 1 - m
    out : ndarray, optional
        where the result goes

    Returns
    -------
    float or ndarray
        sc
    """
    if type(u) is float and type(mc) is float and out is None:
        return _jacobi_sc_mc.one(u, mc)
    return _jacobi_sc_mc(out, u, mc)


_jacobi_cs_k = Routine("jacobi_cs_k", ("u", "k"), None)


def jacobi_cs_k(u: ArrayLike, k: ArrayLike, *, out: Out = None) -> Any:
    r"""Jacobi's cs = cn/sn, of u and the modulus k, m = k^2.

    .. math:: u = \int_0^{\operatorname{am} u} \frac{d\theta}{\sqrt{1 - m\sin^2\theta}}, \quad
       \operatorname{sn} u = \sin\operatorname{am} u, \quad \operatorname{cn} u =
       \cos\operatorname{am} u, \quad \operatorname{dn} u = \sqrt{1 - m\operatorname{sn}^2 u}

    Any finite u and m, negative m and m > 1 included.

    Special cases: m = 1: tanh, sech, sech; NaN for infinite u (m < 1) or k, and for NaN.

    Accuracy: 6 ulp of each function, next to its zeros too; 5 ulp of many u of one modulus. Far u,
    above about 2**(2 digits) quarter periods, take as many digits of K as they have, and their time
    (0.1 ms in float64).

    Definition: DLMF 22.2, 22.17 for m < 0 and m > 1.

    Parameters
    ----------
    u : array_like
        argument
    k : array_like
        modulus, m = k^2
    out : ndarray, optional
        where the result goes

    Returns
    -------
    float or ndarray
        cs
    """
    if type(u) is float and type(k) is float and out is None:
        return _jacobi_cs_k.one(u, k)
    return _jacobi_cs_k(out, u, k)


_jacobi_cs_m = Routine("jacobi_cs_m", ("u", "m"), None)


def jacobi_cs_m(u: ArrayLike, m: ArrayLike, *, out: Out = None) -> Any:
    r"""Jacobi's cs = cn/sn, of the parameter m = k^2.

    .. math:: u = \int_0^{\operatorname{am} u} \frac{d\theta}{\sqrt{1 - m\sin^2\theta}}, \quad
       \operatorname{sn} u = \sin\operatorname{am} u, \quad \operatorname{cn} u =
       \cos\operatorname{am} u, \quad \operatorname{dn} u = \sqrt{1 - m\operatorname{sn}^2 u}

    Any finite u and m, negative m and m > 1 included.

    Special cases: m = 1: tanh, sech, sech; NaN for infinite u (m < 1) or k, and for NaN.

    Accuracy: 6 ulp of each function, next to its zeros too; 5 ulp of many u of one modulus. Far u,
    above about 2**(2 digits) quarter periods, take as many digits of K as they have, and their time
    (0.1 ms in float64).

    Definition: DLMF 22.2, 22.17 for m < 0 and m > 1.

    Parameters
    ----------
    u : array_like
        argument
    m : array_like
        parameter, m = k^2
    out : ndarray, optional
        where the result goes

    Returns
    -------
    float or ndarray
        cs
    """
    if type(u) is float and type(m) is float and out is None:
        return _jacobi_cs_m.one(u, m)
    return _jacobi_cs_m(out, u, m)


_jacobi_cs_mc = Routine("jacobi_cs_mc", ("u", "mc"), None)


def jacobi_cs_mc(u: ArrayLike, mc: ArrayLike, *, out: Out = None) -> Any:
    r"""Jacobi's cs = cn/sn, of the complementary parameter mc = 1 - m.

    .. math:: u = \int_0^{\operatorname{am} u} \frac{d\theta}{\sqrt{1 - m\sin^2\theta}}, \quad
       \operatorname{sn} u = \sin\operatorname{am} u, \quad \operatorname{cn} u =
       \cos\operatorname{am} u, \quad \operatorname{dn} u = \sqrt{1 - m\operatorname{sn}^2 u}

    Any finite u and m, negative m and m > 1 included.

    Special cases: m = 1: tanh, sech, sech; NaN for infinite u (m < 1) or k, and for NaN.

    Accuracy: 6 ulp of each function, next to its zeros too; 5 ulp of many u of one modulus. Far u,
    above about 2**(2 digits) quarter periods, take as many digits of K as they have, and their time
    (0.1 ms in float64).

    Definition: DLMF 22.2, 22.17 for m < 0 and m > 1.

    Parameters
    ----------
    u : array_like
        argument
    mc : array_like
        complementary parameter 1 - m
    out : ndarray, optional
        where the result goes

    Returns
    -------
    float or ndarray
        cs
    """
    if type(u) is float and type(mc) is float and out is None:
        return _jacobi_cs_mc.one(u, mc)
    return _jacobi_cs_mc(out, u, mc)


_jacobi_sd_k = Routine("jacobi_sd_k", ("u", "k"), None)


def jacobi_sd_k(u: ArrayLike, k: ArrayLike, *, out: Out = None) -> Any:
    r"""Jacobi's sd = sn/dn, of u and the modulus k, m = k^2.

    .. math:: u = \int_0^{\operatorname{am} u} \frac{d\theta}{\sqrt{1 - m\sin^2\theta}}, \quad
       \operatorname{sn} u = \sin\operatorname{am} u, \quad \operatorname{cn} u =
       \cos\operatorname{am} u, \quad \operatorname{dn} u = \sqrt{1 - m\operatorname{sn}^2 u}

    Any finite u and m, negative m and m > 1 included.

    Special cases: m = 1: tanh, sech, sech; NaN for infinite u (m < 1) or k, and for NaN.

    Accuracy: 6 ulp of each function, next to its zeros too; 5 ulp of many u of one modulus. Far u,
    above about 2**(2 digits) quarter periods, take as many digits of K as they have, and their time
    (0.1 ms in float64).

    Definition: DLMF 22.2, 22.17 for m < 0 and m > 1.

    Parameters
    ----------
    u : array_like
        argument
    k : array_like
        modulus, m = k^2
    out : ndarray, optional
        where the result goes

    Returns
    -------
    float or ndarray
        sd
    """
    if type(u) is float and type(k) is float and out is None:
        return _jacobi_sd_k.one(u, k)
    return _jacobi_sd_k(out, u, k)


_jacobi_sd_m = Routine("jacobi_sd_m", ("u", "m"), None)


def jacobi_sd_m(u: ArrayLike, m: ArrayLike, *, out: Out = None) -> Any:
    r"""Jacobi's sd = sn/dn, of the parameter m = k^2.

    .. math:: u = \int_0^{\operatorname{am} u} \frac{d\theta}{\sqrt{1 - m\sin^2\theta}}, \quad
       \operatorname{sn} u = \sin\operatorname{am} u, \quad \operatorname{cn} u =
       \cos\operatorname{am} u, \quad \operatorname{dn} u = \sqrt{1 - m\operatorname{sn}^2 u}

    Any finite u and m, negative m and m > 1 included.

    Special cases: m = 1: tanh, sech, sech; NaN for infinite u (m < 1) or k, and for NaN.

    Accuracy: 6 ulp of each function, next to its zeros too; 5 ulp of many u of one modulus. Far u,
    above about 2**(2 digits) quarter periods, take as many digits of K as they have, and their time
    (0.1 ms in float64).

    Definition: DLMF 22.2, 22.17 for m < 0 and m > 1.

    Parameters
    ----------
    u : array_like
        argument
    m : array_like
        parameter, m = k^2
    out : ndarray, optional
        where the result goes

    Returns
    -------
    float or ndarray
        sd
    """
    if type(u) is float and type(m) is float and out is None:
        return _jacobi_sd_m.one(u, m)
    return _jacobi_sd_m(out, u, m)


_jacobi_sd_mc = Routine("jacobi_sd_mc", ("u", "mc"), None)


def jacobi_sd_mc(u: ArrayLike, mc: ArrayLike, *, out: Out = None) -> Any:
    r"""Jacobi's sd = sn/dn, of the complementary parameter mc = 1 - m.

    .. math:: u = \int_0^{\operatorname{am} u} \frac{d\theta}{\sqrt{1 - m\sin^2\theta}}, \quad
       \operatorname{sn} u = \sin\operatorname{am} u, \quad \operatorname{cn} u =
       \cos\operatorname{am} u, \quad \operatorname{dn} u = \sqrt{1 - m\operatorname{sn}^2 u}

    Any finite u and m, negative m and m > 1 included.

    Special cases: m = 1: tanh, sech, sech; NaN for infinite u (m < 1) or k, and for NaN.

    Accuracy: 6 ulp of each function, next to its zeros too; 5 ulp of many u of one modulus. Far u,
    above about 2**(2 digits) quarter periods, take as many digits of K as they have, and their time
    (0.1 ms in float64).

    Definition: DLMF 22.2, 22.17 for m < 0 and m > 1.

    Parameters
    ----------
    u : array_like
        argument
    mc : array_like
        complementary parameter 1 - m
    out : ndarray, optional
        where the result goes

    Returns
    -------
    float or ndarray
        sd
    """
    if type(u) is float and type(mc) is float and out is None:
        return _jacobi_sd_mc.one(u, mc)
    return _jacobi_sd_mc(out, u, mc)


_jacobi_ds_k = Routine("jacobi_ds_k", ("u", "k"), None)


def jacobi_ds_k(u: ArrayLike, k: ArrayLike, *, out: Out = None) -> Any:
    r"""Jacobi's ds = dn/sn, of u and the modulus k, m = k^2.

    .. math:: u = \int_0^{\operatorname{am} u} \frac{d\theta}{\sqrt{1 - m\sin^2\theta}}, \quad
       \operatorname{sn} u = \sin\operatorname{am} u, \quad \operatorname{cn} u =
       \cos\operatorname{am} u, \quad \operatorname{dn} u = \sqrt{1 - m\operatorname{sn}^2 u}

    Any finite u and m, negative m and m > 1 included.

    Special cases: m = 1: tanh, sech, sech; NaN for infinite u (m < 1) or k, and for NaN.

    Accuracy: 6 ulp of each function, next to its zeros too; 5 ulp of many u of one modulus. Far u,
    above about 2**(2 digits) quarter periods, take as many digits of K as they have, and their time
    (0.1 ms in float64).

    Definition: DLMF 22.2, 22.17 for m < 0 and m > 1.

    Parameters
    ----------
    u : array_like
        argument
    k : array_like
        modulus, m = k^2
    out : ndarray, optional
        where the result goes

    Returns
    -------
    float or ndarray
        ds
    """
    if type(u) is float and type(k) is float and out is None:
        return _jacobi_ds_k.one(u, k)
    return _jacobi_ds_k(out, u, k)


_jacobi_ds_m = Routine("jacobi_ds_m", ("u", "m"), None)


def jacobi_ds_m(u: ArrayLike, m: ArrayLike, *, out: Out = None) -> Any:
    r"""Jacobi's ds = dn/sn, of the parameter m = k^2.

    .. math:: u = \int_0^{\operatorname{am} u} \frac{d\theta}{\sqrt{1 - m\sin^2\theta}}, \quad
       \operatorname{sn} u = \sin\operatorname{am} u, \quad \operatorname{cn} u =
       \cos\operatorname{am} u, \quad \operatorname{dn} u = \sqrt{1 - m\operatorname{sn}^2 u}

    Any finite u and m, negative m and m > 1 included.

    Special cases: m = 1: tanh, sech, sech; NaN for infinite u (m < 1) or k, and for NaN.

    Accuracy: 6 ulp of each function, next to its zeros too; 5 ulp of many u of one modulus. Far u,
    above about 2**(2 digits) quarter periods, take as many digits of K as they have, and their time
    (0.1 ms in float64).

    Definition: DLMF 22.2, 22.17 for m < 0 and m > 1.

    Parameters
    ----------
    u : array_like
        argument
    m : array_like
        parameter, m = k^2
    out : ndarray, optional
        where the result goes

    Returns
    -------
    float or ndarray
        ds
    """
    if type(u) is float and type(m) is float and out is None:
        return _jacobi_ds_m.one(u, m)
    return _jacobi_ds_m(out, u, m)


_jacobi_ds_mc = Routine("jacobi_ds_mc", ("u", "mc"), None)


def jacobi_ds_mc(u: ArrayLike, mc: ArrayLike, *, out: Out = None) -> Any:
    r"""Jacobi's ds = dn/sn, of the complementary parameter mc = 1 - m.

    .. math:: u = \int_0^{\operatorname{am} u} \frac{d\theta}{\sqrt{1 - m\sin^2\theta}}, \quad
       \operatorname{sn} u = \sin\operatorname{am} u, \quad \operatorname{cn} u =
       \cos\operatorname{am} u, \quad \operatorname{dn} u = \sqrt{1 - m\operatorname{sn}^2 u}

    Any finite u and m, negative m and m > 1 included.

    Special cases: m = 1: tanh, sech, sech; NaN for infinite u (m < 1) or k, and for NaN.

    Accuracy: 6 ulp of each function, next to its zeros too; 5 ulp of many u of one modulus. Far u,
    above about 2**(2 digits) quarter periods, take as many digits of K as they have, and their time
    (0.1 ms in float64).

    Definition: DLMF 22.2, 22.17 for m < 0 and m > 1.

    Parameters
    ----------
    u : array_like
        argument
    mc : array_like
        complementary parameter 1 - m
    out : ndarray, optional
        where the result goes

    Returns
    -------
    float or ndarray
        ds
    """
    if type(u) is float and type(mc) is float and out is None:
        return _jacobi_ds_mc.one(u, mc)
    return _jacobi_ds_mc(out, u, mc)


_jacobi_cd_k = Routine("jacobi_cd_k", ("u", "k"), None)


def jacobi_cd_k(u: ArrayLike, k: ArrayLike, *, out: Out = None) -> Any:
    r"""Jacobi's cd = cn/dn, of u and the modulus k, m = k^2.

    .. math:: u = \int_0^{\operatorname{am} u} \frac{d\theta}{\sqrt{1 - m\sin^2\theta}}, \quad
       \operatorname{sn} u = \sin\operatorname{am} u, \quad \operatorname{cn} u =
       \cos\operatorname{am} u, \quad \operatorname{dn} u = \sqrt{1 - m\operatorname{sn}^2 u}

    Any finite u and m, negative m and m > 1 included.

    Special cases: m = 1: tanh, sech, sech; NaN for infinite u (m < 1) or k, and for NaN.

    Accuracy: 6 ulp of each function, next to its zeros too; 5 ulp of many u of one modulus. Far u,
    above about 2**(2 digits) quarter periods, take as many digits of K as they have, and their time
    (0.1 ms in float64).

    Definition: DLMF 22.2, 22.17 for m < 0 and m > 1.

    Parameters
    ----------
    u : array_like
        argument
    k : array_like
        modulus, m = k^2
    out : ndarray, optional
        where the result goes

    Returns
    -------
    float or ndarray
        cd
    """
    if type(u) is float and type(k) is float and out is None:
        return _jacobi_cd_k.one(u, k)
    return _jacobi_cd_k(out, u, k)


_jacobi_cd_m = Routine("jacobi_cd_m", ("u", "m"), None)


def jacobi_cd_m(u: ArrayLike, m: ArrayLike, *, out: Out = None) -> Any:
    r"""Jacobi's cd = cn/dn, of the parameter m = k^2.

    .. math:: u = \int_0^{\operatorname{am} u} \frac{d\theta}{\sqrt{1 - m\sin^2\theta}}, \quad
       \operatorname{sn} u = \sin\operatorname{am} u, \quad \operatorname{cn} u =
       \cos\operatorname{am} u, \quad \operatorname{dn} u = \sqrt{1 - m\operatorname{sn}^2 u}

    Any finite u and m, negative m and m > 1 included.

    Special cases: m = 1: tanh, sech, sech; NaN for infinite u (m < 1) or k, and for NaN.

    Accuracy: 6 ulp of each function, next to its zeros too; 5 ulp of many u of one modulus. Far u,
    above about 2**(2 digits) quarter periods, take as many digits of K as they have, and their time
    (0.1 ms in float64).

    Definition: DLMF 22.2, 22.17 for m < 0 and m > 1.

    Parameters
    ----------
    u : array_like
        argument
    m : array_like
        parameter, m = k^2
    out : ndarray, optional
        where the result goes

    Returns
    -------
    float or ndarray
        cd
    """
    if type(u) is float and type(m) is float and out is None:
        return _jacobi_cd_m.one(u, m)
    return _jacobi_cd_m(out, u, m)


_jacobi_cd_mc = Routine("jacobi_cd_mc", ("u", "mc"), None)


def jacobi_cd_mc(u: ArrayLike, mc: ArrayLike, *, out: Out = None) -> Any:
    r"""Jacobi's cd = cn/dn, of the complementary parameter mc = 1 - m.

    .. math:: u = \int_0^{\operatorname{am} u} \frac{d\theta}{\sqrt{1 - m\sin^2\theta}}, \quad
       \operatorname{sn} u = \sin\operatorname{am} u, \quad \operatorname{cn} u =
       \cos\operatorname{am} u, \quad \operatorname{dn} u = \sqrt{1 - m\operatorname{sn}^2 u}

    Any finite u and m, negative m and m > 1 included.

    Special cases: m = 1: tanh, sech, sech; NaN for infinite u (m < 1) or k, and for NaN.

    Accuracy: 6 ulp of each function, next to its zeros too; 5 ulp of many u of one modulus. Far u,
    above about 2**(2 digits) quarter periods, take as many digits of K as they have, and their time
    (0.1 ms in float64).

    Definition: DLMF 22.2, 22.17 for m < 0 and m > 1.

    Parameters
    ----------
    u : array_like
        argument
    mc : array_like
        complementary parameter 1 - m
    out : ndarray, optional
        where the result goes

    Returns
    -------
    float or ndarray
        cd
    """
    if type(u) is float and type(mc) is float and out is None:
        return _jacobi_cd_mc.one(u, mc)
    return _jacobi_cd_mc(out, u, mc)


_jacobi_dc_k = Routine("jacobi_dc_k", ("u", "k"), None)


def jacobi_dc_k(u: ArrayLike, k: ArrayLike, *, out: Out = None) -> Any:
    r"""Jacobi's dc = dn/cn, of u and the modulus k, m = k^2.

    .. math:: u = \int_0^{\operatorname{am} u} \frac{d\theta}{\sqrt{1 - m\sin^2\theta}}, \quad
       \operatorname{sn} u = \sin\operatorname{am} u, \quad \operatorname{cn} u =
       \cos\operatorname{am} u, \quad \operatorname{dn} u = \sqrt{1 - m\operatorname{sn}^2 u}

    Any finite u and m, negative m and m > 1 included.

    Special cases: m = 1: tanh, sech, sech; NaN for infinite u (m < 1) or k, and for NaN.

    Accuracy: 6 ulp of each function, next to its zeros too; 5 ulp of many u of one modulus. Far u,
    above about 2**(2 digits) quarter periods, take as many digits of K as they have, and their time
    (0.1 ms in float64).

    Definition: DLMF 22.2, 22.17 for m < 0 and m > 1.

    Parameters
    ----------
    u : array_like
        argument
    k : array_like
        modulus, m = k^2
    out : ndarray, optional
        where the result goes

    Returns
    -------
    float or ndarray
        dc
    """
    if type(u) is float and type(k) is float and out is None:
        return _jacobi_dc_k.one(u, k)
    return _jacobi_dc_k(out, u, k)


_jacobi_dc_m = Routine("jacobi_dc_m", ("u", "m"), None)


def jacobi_dc_m(u: ArrayLike, m: ArrayLike, *, out: Out = None) -> Any:
    r"""Jacobi's dc = dn/cn, of the parameter m = k^2.

    .. math:: u = \int_0^{\operatorname{am} u} \frac{d\theta}{\sqrt{1 - m\sin^2\theta}}, \quad
       \operatorname{sn} u = \sin\operatorname{am} u, \quad \operatorname{cn} u =
       \cos\operatorname{am} u, \quad \operatorname{dn} u = \sqrt{1 - m\operatorname{sn}^2 u}

    Any finite u and m, negative m and m > 1 included.

    Special cases: m = 1: tanh, sech, sech; NaN for infinite u (m < 1) or k, and for NaN.

    Accuracy: 6 ulp of each function, next to its zeros too; 5 ulp of many u of one modulus. Far u,
    above about 2**(2 digits) quarter periods, take as many digits of K as they have, and their time
    (0.1 ms in float64).

    Definition: DLMF 22.2, 22.17 for m < 0 and m > 1.

    Parameters
    ----------
    u : array_like
        argument
    m : array_like
        parameter, m = k^2
    out : ndarray, optional
        where the result goes

    Returns
    -------
    float or ndarray
        dc
    """
    if type(u) is float and type(m) is float and out is None:
        return _jacobi_dc_m.one(u, m)
    return _jacobi_dc_m(out, u, m)


_jacobi_dc_mc = Routine("jacobi_dc_mc", ("u", "mc"), None)


def jacobi_dc_mc(u: ArrayLike, mc: ArrayLike, *, out: Out = None) -> Any:
    r"""Jacobi's dc = dn/cn, of the complementary parameter mc = 1 - m.

    .. math:: u = \int_0^{\operatorname{am} u} \frac{d\theta}{\sqrt{1 - m\sin^2\theta}}, \quad
       \operatorname{sn} u = \sin\operatorname{am} u, \quad \operatorname{cn} u =
       \cos\operatorname{am} u, \quad \operatorname{dn} u = \sqrt{1 - m\operatorname{sn}^2 u}

    Any finite u and m, negative m and m > 1 included.

    Special cases: m = 1: tanh, sech, sech; NaN for infinite u (m < 1) or k, and for NaN.

    Accuracy: 6 ulp of each function, next to its zeros too; 5 ulp of many u of one modulus. Far u,
    above about 2**(2 digits) quarter periods, take as many digits of K as they have, and their time
    (0.1 ms in float64).

    Definition: DLMF 22.2, 22.17 for m < 0 and m > 1.

    Parameters
    ----------
    u : array_like
        argument
    mc : array_like
        complementary parameter 1 - m
    out : ndarray, optional
        where the result goes

    Returns
    -------
    float or ndarray
        dc
    """
    if type(u) is float and type(mc) is float and out is None:
        return _jacobi_dc_mc.one(u, mc)
    return _jacobi_dc_mc(out, u, mc)


_jacobi_epsilon_k = Routine("jacobi_epsilon_k", ("u", "k"), None)


def jacobi_epsilon_k(u: ArrayLike, k: ArrayLike, *, out: Out = None) -> Any:
    r"""Jacobi's epsilon of u and the modulus k, m = k^2:

    .. math:: \mathcal{E}(u, k) = \int_0^u \mathrm{dn}^2(t, k)\,dt = E(\mathrm{am}\,u, k),

    the last for abs(k) <= 1. Any m, m > 1 included.

    Special cases: 0 at u = 0, u for k = 0, tanh(u) for abs(k) = 1; NaN for infinite u and for NaN.

    Accuracy: 5 ulp.

    Source: DLMF 22.16.14, 22.16.31

    Parameters
    ----------
    u : array_like
        argument
    k : array_like
        modulus, m = k^2
    out : ndarray, optional
        where the result goes

    Returns
    -------
    float or ndarray
        epsilon
    """
    if type(u) is float and type(k) is float and out is None:
        return _jacobi_epsilon_k.one(u, k)
    return _jacobi_epsilon_k(out, u, k)


_jacobi_epsilon_m = Routine("jacobi_epsilon_m", ("u", "m"), None)


def jacobi_epsilon_m(u: ArrayLike, m: ArrayLike, *, out: Out = None) -> Any:
    r"""Jacobi's epsilon, of the parameter m = k^2.

    .. math:: \mathcal{E}(u, k) = \int_0^u \mathrm{dn}^2(t, k)\,dt = E(\mathrm{am}\,u, k),

    the last for abs(k) <= 1. Any m, m > 1 included.

    Special cases: 0 at u = 0, u for k = 0, tanh(u) for abs(k) = 1; NaN for infinite u and for NaN.

    Accuracy: 5 ulp.

    Source: DLMF 22.16.14, 22.16.31

    Parameters
    ----------
    u : array_like
        argument
    m : array_like
        parameter, m = k^2
    out : ndarray, optional
        where the result goes

    Returns
    -------
    float or ndarray
        epsilon
    """
    if type(u) is float and type(m) is float and out is None:
        return _jacobi_epsilon_m.one(u, m)
    return _jacobi_epsilon_m(out, u, m)


_jacobi_epsilon_mc = Routine("jacobi_epsilon_mc", ("u", "mc"), None)


def jacobi_epsilon_mc(u: ArrayLike, mc: ArrayLike, *, out: Out = None) -> Any:
    r"""Jacobi's epsilon, of the complementary parameter mc = 1 - m.

    .. math:: \mathcal{E}(u, k) = \int_0^u \mathrm{dn}^2(t, k)\,dt = E(\mathrm{am}\,u, k),

    the last for abs(k) <= 1. Any m, m > 1 included.

    Special cases: 0 at u = 0, u for k = 0, tanh(u) for abs(k) = 1; NaN for infinite u and for NaN.

    Accuracy: 5 ulp.

    Source: DLMF 22.16.14, 22.16.31

    Parameters
    ----------
    u : array_like
        argument
    mc : array_like
        complementary parameter 1 - m
    out : ndarray, optional
        where the result goes

    Returns
    -------
    float or ndarray
        epsilon
    """
    if type(u) is float and type(mc) is float and out is None:
        return _jacobi_epsilon_mc.one(u, mc)
    return _jacobi_epsilon_mc(out, u, mc)


_jacobi_arcsn_k = Routine("jacobi_arcsn_k", ("x", "k"), None)


def jacobi_arcsn_k(x: ArrayLike, k: ArrayLike, *, out: Out = None) -> Any:
    r"""The u with sn(u|m) = x, principal value, of x and the modulus k, m = k^2.

    -1 <= x <= 1; then -K <= u <= K. Outside: NaN. For m > 1 the x that a real u gives, K being the
    quarter period K(1/m)/sqrt(m) and dn the function that changes its sign there. An edge that no
    floating-point number is, as 1/k, is met within 4 epsilon of it: there u is the quarter period.

    Special cases: arcsn(+-0) = +-0; m = 1: Inf with the sign of x at x = +-1. NaN for infinite m.

    Accuracy: 1 ulp.

    Parameters
    ----------
    x : array_like
        number
    k : array_like
        modulus, m = k^2
    out : ndarray, optional
        where the result goes

    Returns
    -------
    float or ndarray
        u
    """
    if type(x) is float and type(k) is float and out is None:
        return _jacobi_arcsn_k.one(x, k)
    return _jacobi_arcsn_k(out, x, k)


_jacobi_arcsn_m = Routine("jacobi_arcsn_m", ("x", "m"), None)


def jacobi_arcsn_m(x: ArrayLike, m: ArrayLike, *, out: Out = None) -> Any:
    r"""The u with sn(u|m) = x, of the parameter m = k^2.

    -1 <= x <= 1; then -K <= u <= K. Outside: NaN. For m > 1 the x that a real u gives, K being the
    quarter period K(1/m)/sqrt(m) and dn the function that changes its sign there. An edge that no
    floating-point number is, as 1/k, is met within 4 epsilon of it: there u is the quarter period.

    Special cases: arcsn(+-0) = +-0; m = 1: Inf with the sign of x at x = +-1. NaN for infinite m.

    Accuracy: 1 ulp.

    Parameters
    ----------
    x : array_like
        number
    m : array_like
        parameter, m = k^2
    out : ndarray, optional
        where the result goes

    Returns
    -------
    float or ndarray
        u
    """
    if type(x) is float and type(m) is float and out is None:
        return _jacobi_arcsn_m.one(x, m)
    return _jacobi_arcsn_m(out, x, m)


_jacobi_arcsn_mc = Routine("jacobi_arcsn_mc", ("x", "mc"), None)


def jacobi_arcsn_mc(x: ArrayLike, mc: ArrayLike, *, out: Out = None) -> Any:
    r"""The u with sn(u|m) = x, of the complementary parameter mc = 1 - m.

    -1 <= x <= 1; then -K <= u <= K. Outside: NaN. For m > 1 the x that a real u gives, K being the
    quarter period K(1/m)/sqrt(m) and dn the function that changes its sign there. An edge that no
    floating-point number is, as 1/k, is met within 4 epsilon of it: there u is the quarter period.

    Special cases: arcsn(+-0) = +-0; m = 1: Inf with the sign of x at x = +-1. NaN for infinite m.

    Accuracy: 1 ulp.

    Parameters
    ----------
    x : array_like
        number
    mc : array_like
        complementary parameter 1 - m
    out : ndarray, optional
        where the result goes

    Returns
    -------
    float or ndarray
        u
    """
    if type(x) is float and type(mc) is float and out is None:
        return _jacobi_arcsn_mc.one(x, mc)
    return _jacobi_arcsn_mc(out, x, mc)


_jacobi_arccn_k = Routine("jacobi_arccn_k", ("x", "k"), None)


def jacobi_arccn_k(x: ArrayLike, k: ArrayLike, *, out: Out = None) -> Any:
    r"""The u with cn(u|m) = x, principal value, of x and the modulus k, m = k^2.

    -1 <= x <= 1; then 0 <= u <= 2K. Outside: NaN. m > 1: as jacobi_arcsn_m.

    Accuracy: 1 ulp.

    Parameters
    ----------
    x : array_like
        number
    k : array_like
        modulus, m = k^2
    out : ndarray, optional
        where the result goes

    Returns
    -------
    float or ndarray
        u
    """
    if type(x) is float and type(k) is float and out is None:
        return _jacobi_arccn_k.one(x, k)
    return _jacobi_arccn_k(out, x, k)


_jacobi_arccn_m = Routine("jacobi_arccn_m", ("x", "m"), None)


def jacobi_arccn_m(x: ArrayLike, m: ArrayLike, *, out: Out = None) -> Any:
    r"""The u with cn(u|m) = x, of the parameter m = k^2.

    -1 <= x <= 1; then 0 <= u <= 2K. Outside: NaN. m > 1: as jacobi_arcsn_m.

    Accuracy: 1 ulp.

    Parameters
    ----------
    x : array_like
        number
    m : array_like
        parameter, m = k^2
    out : ndarray, optional
        where the result goes

    Returns
    -------
    float or ndarray
        u
    """
    if type(x) is float and type(m) is float and out is None:
        return _jacobi_arccn_m.one(x, m)
    return _jacobi_arccn_m(out, x, m)


_jacobi_arccn_mc = Routine("jacobi_arccn_mc", ("x", "mc"), None)


def jacobi_arccn_mc(x: ArrayLike, mc: ArrayLike, *, out: Out = None) -> Any:
    r"""The u with cn(u|m) = x, of the complementary parameter mc = 1 - m.

    -1 <= x <= 1; then 0 <= u <= 2K. Outside: NaN. m > 1: as jacobi_arcsn_m.

    Accuracy: 1 ulp.

    Parameters
    ----------
    x : array_like
        number
    mc : array_like
        complementary parameter 1 - m
    out : ndarray, optional
        where the result goes

    Returns
    -------
    float or ndarray
        u
    """
    if type(x) is float and type(mc) is float and out is None:
        return _jacobi_arccn_mc.one(x, mc)
    return _jacobi_arccn_mc(out, x, mc)


_jacobi_arcdn_k = Routine("jacobi_arcdn_k", ("x", "k"), None)


def jacobi_arcdn_k(x: ArrayLike, k: ArrayLike, *, out: Out = None) -> Any:
    r"""The u with dn(u|m) = x, principal value, of x and the modulus k, m = k^2.

    sqrt(1-m) <= x <= 1 (1 <= x <= sqrt(1-m) for m < 0); then 0 <= u <= K. Outside: NaN. m > 1: as
    jacobi_arcsn_m.

    Accuracy: 1 ulp.

    Parameters
    ----------
    x : array_like
        number
    k : array_like
        modulus, m = k^2
    out : ndarray, optional
        where the result goes

    Returns
    -------
    float or ndarray
        u
    """
    if type(x) is float and type(k) is float and out is None:
        return _jacobi_arcdn_k.one(x, k)
    return _jacobi_arcdn_k(out, x, k)


_jacobi_arcdn_m = Routine("jacobi_arcdn_m", ("x", "m"), None)


def jacobi_arcdn_m(x: ArrayLike, m: ArrayLike, *, out: Out = None) -> Any:
    r"""The u with dn(u|m) = x, of the parameter m = k^2.

    sqrt(1-m) <= x <= 1 (1 <= x <= sqrt(1-m) for m < 0); then 0 <= u <= K. Outside: NaN. m > 1: as
    jacobi_arcsn_m.

    Accuracy: 1 ulp.

    Parameters
    ----------
    x : array_like
        number
    m : array_like
        parameter, m = k^2
    out : ndarray, optional
        where the result goes

    Returns
    -------
    float or ndarray
        u
    """
    if type(x) is float and type(m) is float and out is None:
        return _jacobi_arcdn_m.one(x, m)
    return _jacobi_arcdn_m(out, x, m)


_jacobi_arcdn_mc = Routine("jacobi_arcdn_mc", ("x", "mc"), None)


def jacobi_arcdn_mc(x: ArrayLike, mc: ArrayLike, *, out: Out = None) -> Any:
    r"""The u with dn(u|m) = x, of the complementary parameter mc = 1 - m.

    sqrt(1-m) <= x <= 1 (1 <= x <= sqrt(1-m) for m < 0); then 0 <= u <= K. Outside: NaN. m > 1: as
    jacobi_arcsn_m.

    Accuracy: 1 ulp.

    Parameters
    ----------
    x : array_like
        number
    mc : array_like
        complementary parameter 1 - m
    out : ndarray, optional
        where the result goes

    Returns
    -------
    float or ndarray
        u
    """
    if type(x) is float and type(mc) is float and out is None:
        return _jacobi_arcdn_mc.one(x, mc)
    return _jacobi_arcdn_mc(out, x, mc)


_jacobi_arcns_k = Routine("jacobi_arcns_k", ("x", "k"), None)


def jacobi_arcns_k(x: ArrayLike, k: ArrayLike, *, out: Out = None) -> Any:
    r"""The u with ns(u|m) = x, principal value, of x and the modulus k, m = k^2.

    abs(x) >= 1; then -K <= u <= K. Outside: NaN. m > 1: as jacobi_arcsn_m.

    Accuracy: 1 ulp.

    Parameters
    ----------
    x : array_like
        number
    k : array_like
        modulus, m = k^2
    out : ndarray, optional
        where the result goes

    Returns
    -------
    float or ndarray
        u
    """
    if type(x) is float and type(k) is float and out is None:
        return _jacobi_arcns_k.one(x, k)
    return _jacobi_arcns_k(out, x, k)


_jacobi_arcns_m = Routine("jacobi_arcns_m", ("x", "m"), None)


def jacobi_arcns_m(x: ArrayLike, m: ArrayLike, *, out: Out = None) -> Any:
    r"""The u with ns(u|m) = x, of the parameter m = k^2.

    abs(x) >= 1; then -K <= u <= K. Outside: NaN. m > 1: as jacobi_arcsn_m.

    Accuracy: 1 ulp.

    Parameters
    ----------
    x : array_like
        number
    m : array_like
        parameter, m = k^2
    out : ndarray, optional
        where the result goes

    Returns
    -------
    float or ndarray
        u
    """
    if type(x) is float and type(m) is float and out is None:
        return _jacobi_arcns_m.one(x, m)
    return _jacobi_arcns_m(out, x, m)


_jacobi_arcns_mc = Routine("jacobi_arcns_mc", ("x", "mc"), None)


def jacobi_arcns_mc(x: ArrayLike, mc: ArrayLike, *, out: Out = None) -> Any:
    r"""The u with ns(u|m) = x, of the complementary parameter mc = 1 - m.

    abs(x) >= 1; then -K <= u <= K. Outside: NaN. m > 1: as jacobi_arcsn_m.

    Accuracy: 1 ulp.

    Parameters
    ----------
    x : array_like
        number
    mc : array_like
        complementary parameter 1 - m
    out : ndarray, optional
        where the result goes

    Returns
    -------
    float or ndarray
        u
    """
    if type(x) is float and type(mc) is float and out is None:
        return _jacobi_arcns_mc.one(x, mc)
    return _jacobi_arcns_mc(out, x, mc)


_jacobi_arcnc_k = Routine("jacobi_arcnc_k", ("x", "k"), None)


def jacobi_arcnc_k(x: ArrayLike, k: ArrayLike, *, out: Out = None) -> Any:
    r"""The u with nc(u|m) = x, principal value, of x and the modulus k, m = k^2.

    abs(x) >= 1; then 0 <= u <= 2K. Outside: NaN. m > 1: as jacobi_arcsn_m.

    Accuracy: 1 ulp.

    Parameters
    ----------
    x : array_like
        number
    k : array_like
        modulus, m = k^2
    out : ndarray, optional
        where the result goes

    Returns
    -------
    float or ndarray
        u
    """
    if type(x) is float and type(k) is float and out is None:
        return _jacobi_arcnc_k.one(x, k)
    return _jacobi_arcnc_k(out, x, k)


_jacobi_arcnc_m = Routine("jacobi_arcnc_m", ("x", "m"), None)


def jacobi_arcnc_m(x: ArrayLike, m: ArrayLike, *, out: Out = None) -> Any:
    r"""The u with nc(u|m) = x, of the parameter m = k^2.

    abs(x) >= 1; then 0 <= u <= 2K. Outside: NaN. m > 1: as jacobi_arcsn_m.

    Accuracy: 1 ulp.

    Parameters
    ----------
    x : array_like
        number
    m : array_like
        parameter, m = k^2
    out : ndarray, optional
        where the result goes

    Returns
    -------
    float or ndarray
        u
    """
    if type(x) is float and type(m) is float and out is None:
        return _jacobi_arcnc_m.one(x, m)
    return _jacobi_arcnc_m(out, x, m)


_jacobi_arcnc_mc = Routine("jacobi_arcnc_mc", ("x", "mc"), None)


def jacobi_arcnc_mc(x: ArrayLike, mc: ArrayLike, *, out: Out = None) -> Any:
    r"""The u with nc(u|m) = x, of the complementary parameter mc = 1 - m.

    abs(x) >= 1; then 0 <= u <= 2K. Outside: NaN. m > 1: as jacobi_arcsn_m.

    Accuracy: 1 ulp.

    Parameters
    ----------
    x : array_like
        number
    mc : array_like
        complementary parameter 1 - m
    out : ndarray, optional
        where the result goes

    Returns
    -------
    float or ndarray
        u
    """
    if type(x) is float and type(mc) is float and out is None:
        return _jacobi_arcnc_mc.one(x, mc)
    return _jacobi_arcnc_mc(out, x, mc)


_jacobi_arcnd_k = Routine("jacobi_arcnd_k", ("x", "k"), None)


def jacobi_arcnd_k(x: ArrayLike, k: ArrayLike, *, out: Out = None) -> Any:
    r"""The u with nd(u|m) = x, principal value, of x and the modulus k, m = k^2.

    1 <= x <= 1/sqrt(1-m) (1/sqrt(1-m) <= x <= 1 for m < 0); then 0 <= u <= K. Outside: NaN. m > 1:
    as jacobi_arcsn_m.

    Accuracy: 1 ulp.

    Parameters
    ----------
    x : array_like
        number
    k : array_like
        modulus, m = k^2
    out : ndarray, optional
        where the result goes

    Returns
    -------
    float or ndarray
        u
    """
    if type(x) is float and type(k) is float and out is None:
        return _jacobi_arcnd_k.one(x, k)
    return _jacobi_arcnd_k(out, x, k)


_jacobi_arcnd_m = Routine("jacobi_arcnd_m", ("x", "m"), None)


def jacobi_arcnd_m(x: ArrayLike, m: ArrayLike, *, out: Out = None) -> Any:
    r"""The u with nd(u|m) = x, of the parameter m = k^2.

    1 <= x <= 1/sqrt(1-m) (1/sqrt(1-m) <= x <= 1 for m < 0); then 0 <= u <= K. Outside: NaN. m > 1:
    as jacobi_arcsn_m.

    Accuracy: 1 ulp.

    Parameters
    ----------
    x : array_like
        number
    m : array_like
        parameter, m = k^2
    out : ndarray, optional
        where the result goes

    Returns
    -------
    float or ndarray
        u
    """
    if type(x) is float and type(m) is float and out is None:
        return _jacobi_arcnd_m.one(x, m)
    return _jacobi_arcnd_m(out, x, m)


_jacobi_arcnd_mc = Routine("jacobi_arcnd_mc", ("x", "mc"), None)


def jacobi_arcnd_mc(x: ArrayLike, mc: ArrayLike, *, out: Out = None) -> Any:
    r"""The u with nd(u|m) = x, of the complementary parameter mc = 1 - m.

    1 <= x <= 1/sqrt(1-m) (1/sqrt(1-m) <= x <= 1 for m < 0); then 0 <= u <= K. Outside: NaN. m > 1:
    as jacobi_arcsn_m.

    Accuracy: 1 ulp.

    Parameters
    ----------
    x : array_like
        number
    mc : array_like
        complementary parameter 1 - m
    out : ndarray, optional
        where the result goes

    Returns
    -------
    float or ndarray
        u
    """
    if type(x) is float and type(mc) is float and out is None:
        return _jacobi_arcnd_mc.one(x, mc)
    return _jacobi_arcnd_mc(out, x, mc)


_jacobi_arcsc_k = Routine("jacobi_arcsc_k", ("x", "k"), None)


def jacobi_arcsc_k(x: ArrayLike, k: ArrayLike, *, out: Out = None) -> Any:
    r"""The u with sc(u|m) = x, principal value, of x and the modulus k, m = k^2.

    any x; then -K <= u <= K. Outside: NaN. m > 1: as jacobi_arcsn_m.

    Accuracy: 1 ulp.

    Parameters
    ----------
    x : array_like
        number
    k : array_like
        modulus, m = k^2
    out : ndarray, optional
        where the result goes

    Returns
    -------
    float or ndarray
        u
    """
    if type(x) is float and type(k) is float and out is None:
        return _jacobi_arcsc_k.one(x, k)
    return _jacobi_arcsc_k(out, x, k)


_jacobi_arcsc_m = Routine("jacobi_arcsc_m", ("x", "m"), None)


def jacobi_arcsc_m(x: ArrayLike, m: ArrayLike, *, out: Out = None) -> Any:
    r"""The u with sc(u|m) = x, of the parameter m = k^2.

    any x; then -K <= u <= K. Outside: NaN. m > 1: as jacobi_arcsn_m.

    Accuracy: 1 ulp.

    Parameters
    ----------
    x : array_like
        number
    m : array_like
        parameter, m = k^2
    out : ndarray, optional
        where the result goes

    Returns
    -------
    float or ndarray
        u
    """
    if type(x) is float and type(m) is float and out is None:
        return _jacobi_arcsc_m.one(x, m)
    return _jacobi_arcsc_m(out, x, m)


_jacobi_arcsc_mc = Routine("jacobi_arcsc_mc", ("x", "mc"), None)


def jacobi_arcsc_mc(x: ArrayLike, mc: ArrayLike, *, out: Out = None) -> Any:
    r"""The u with sc(u|m) = x, of the complementary parameter mc = 1 - m.

    any x; then -K <= u <= K. Outside: NaN. m > 1: as jacobi_arcsn_m.

    Accuracy: 1 ulp.

    Parameters
    ----------
    x : array_like
        number
    mc : array_like
        complementary parameter 1 - m
    out : ndarray, optional
        where the result goes

    Returns
    -------
    float or ndarray
        u
    """
    if type(x) is float and type(mc) is float and out is None:
        return _jacobi_arcsc_mc.one(x, mc)
    return _jacobi_arcsc_mc(out, x, mc)


_jacobi_arccs_k = Routine("jacobi_arccs_k", ("x", "k"), None)


def jacobi_arccs_k(x: ArrayLike, k: ArrayLike, *, out: Out = None) -> Any:
    r"""The u with cs(u|m) = x, principal value, of x and the modulus k, m = k^2.

    any x; then 0 <= u <= 2K, as the arc cotangent. Outside: NaN. m > 1: as jacobi_arcsn_m.

    Accuracy: 1 ulp.

    Parameters
    ----------
    x : array_like
        number
    k : array_like
        modulus, m = k^2
    out : ndarray, optional
        where the result goes

    Returns
    -------
    float or ndarray
        u
    """
    if type(x) is float and type(k) is float and out is None:
        return _jacobi_arccs_k.one(x, k)
    return _jacobi_arccs_k(out, x, k)


_jacobi_arccs_m = Routine("jacobi_arccs_m", ("x", "m"), None)


def jacobi_arccs_m(x: ArrayLike, m: ArrayLike, *, out: Out = None) -> Any:
    r"""The u with cs(u|m) = x, of the parameter m = k^2.

    any x; then 0 <= u <= 2K, as the arc cotangent. Outside: NaN. m > 1: as jacobi_arcsn_m.

    Accuracy: 1 ulp.

    Parameters
    ----------
    x : array_like
        number
    m : array_like
        parameter, m = k^2
    out : ndarray, optional
        where the result goes

    Returns
    -------
    float or ndarray
        u
    """
    if type(x) is float and type(m) is float and out is None:
        return _jacobi_arccs_m.one(x, m)
    return _jacobi_arccs_m(out, x, m)


_jacobi_arccs_mc = Routine("jacobi_arccs_mc", ("x", "mc"), None)


def jacobi_arccs_mc(x: ArrayLike, mc: ArrayLike, *, out: Out = None) -> Any:
    r"""The u with cs(u|m) = x, of the complementary parameter mc = 1 - m.

    any x; then 0 <= u <= 2K, as the arc cotangent. Outside: NaN. m > 1: as jacobi_arcsn_m.

    Accuracy: 1 ulp.

    Parameters
    ----------
    x : array_like
        number
    mc : array_like
        complementary parameter 1 - m
    out : ndarray, optional
        where the result goes

    Returns
    -------
    float or ndarray
        u
    """
    if type(x) is float and type(mc) is float and out is None:
        return _jacobi_arccs_mc.one(x, mc)
    return _jacobi_arccs_mc(out, x, mc)


_jacobi_arcsd_k = Routine("jacobi_arcsd_k", ("x", "k"), None)


def jacobi_arcsd_k(x: ArrayLike, k: ArrayLike, *, out: Out = None) -> Any:
    r"""The u with sd(u|m) = x, principal value, of x and the modulus k, m = k^2.

    abs(x) <= 1/sqrt(1-m); then -K <= u <= K. Outside: NaN. m > 1: as jacobi_arcsn_m.

    Accuracy: 1 ulp.

    Parameters
    ----------
    x : array_like
        number
    k : array_like
        modulus, m = k^2
    out : ndarray, optional
        where the result goes

    Returns
    -------
    float or ndarray
        u
    """
    if type(x) is float and type(k) is float and out is None:
        return _jacobi_arcsd_k.one(x, k)
    return _jacobi_arcsd_k(out, x, k)


_jacobi_arcsd_m = Routine("jacobi_arcsd_m", ("x", "m"), None)


def jacobi_arcsd_m(x: ArrayLike, m: ArrayLike, *, out: Out = None) -> Any:
    r"""The u with sd(u|m) = x, of the parameter m = k^2.

    abs(x) <= 1/sqrt(1-m); then -K <= u <= K. Outside: NaN. m > 1: as jacobi_arcsn_m.

    Accuracy: 1 ulp.

    Parameters
    ----------
    x : array_like
        number
    m : array_like
        parameter, m = k^2
    out : ndarray, optional
        where the result goes

    Returns
    -------
    float or ndarray
        u
    """
    if type(x) is float and type(m) is float and out is None:
        return _jacobi_arcsd_m.one(x, m)
    return _jacobi_arcsd_m(out, x, m)


_jacobi_arcsd_mc = Routine("jacobi_arcsd_mc", ("x", "mc"), None)


def jacobi_arcsd_mc(x: ArrayLike, mc: ArrayLike, *, out: Out = None) -> Any:
    r"""The u with sd(u|m) = x, of the complementary parameter mc = 1 - m.

    abs(x) <= 1/sqrt(1-m); then -K <= u <= K. Outside: NaN. m > 1: as jacobi_arcsn_m.

    Accuracy: 1 ulp.

    Parameters
    ----------
    x : array_like
        number
    mc : array_like
        complementary parameter 1 - m
    out : ndarray, optional
        where the result goes

    Returns
    -------
    float or ndarray
        u
    """
    if type(x) is float and type(mc) is float and out is None:
        return _jacobi_arcsd_mc.one(x, mc)
    return _jacobi_arcsd_mc(out, x, mc)


_jacobi_arcds_k = Routine("jacobi_arcds_k", ("x", "k"), None)


def jacobi_arcds_k(x: ArrayLike, k: ArrayLike, *, out: Out = None) -> Any:
    r"""The u with ds(u|m) = x, principal value, of x and the modulus k, m = k^2.

    abs(x) >= sqrt(1-m); then -K <= u <= K. Outside: NaN. m > 1: as jacobi_arcsn_m.

    Accuracy: 1 ulp.

    Parameters
    ----------
    x : array_like
        number
    k : array_like
        modulus, m = k^2
    out : ndarray, optional
        where the result goes

    Returns
    -------
    float or ndarray
        u
    """
    if type(x) is float and type(k) is float and out is None:
        return _jacobi_arcds_k.one(x, k)
    return _jacobi_arcds_k(out, x, k)


_jacobi_arcds_m = Routine("jacobi_arcds_m", ("x", "m"), None)


def jacobi_arcds_m(x: ArrayLike, m: ArrayLike, *, out: Out = None) -> Any:
    r"""The u with ds(u|m) = x, of the parameter m = k^2.

    abs(x) >= sqrt(1-m); then -K <= u <= K. Outside: NaN. m > 1: as jacobi_arcsn_m.

    Accuracy: 1 ulp.

    Parameters
    ----------
    x : array_like
        number
    m : array_like
        parameter, m = k^2
    out : ndarray, optional
        where the result goes

    Returns
    -------
    float or ndarray
        u
    """
    if type(x) is float and type(m) is float and out is None:
        return _jacobi_arcds_m.one(x, m)
    return _jacobi_arcds_m(out, x, m)


_jacobi_arcds_mc = Routine("jacobi_arcds_mc", ("x", "mc"), None)


def jacobi_arcds_mc(x: ArrayLike, mc: ArrayLike, *, out: Out = None) -> Any:
    r"""The u with ds(u|m) = x, of the complementary parameter mc = 1 - m.

    abs(x) >= sqrt(1-m); then -K <= u <= K. Outside: NaN. m > 1: as jacobi_arcsn_m.

    Accuracy: 1 ulp.

    Parameters
    ----------
    x : array_like
        number
    mc : array_like
        complementary parameter 1 - m
    out : ndarray, optional
        where the result goes

    Returns
    -------
    float or ndarray
        u
    """
    if type(x) is float and type(mc) is float and out is None:
        return _jacobi_arcds_mc.one(x, mc)
    return _jacobi_arcds_mc(out, x, mc)


_jacobi_arccd_k = Routine("jacobi_arccd_k", ("x", "k"), None)


def jacobi_arccd_k(x: ArrayLike, k: ArrayLike, *, out: Out = None) -> Any:
    r"""The u with cd(u|m) = x, principal value, of x and the modulus k, m = k^2.

    -1 <= x <= 1; then 0 <= u <= 2K. Outside: NaN. m > 1: as jacobi_arcsn_m.

    Accuracy: 1 ulp.

    Parameters
    ----------
    x : array_like
        number
    k : array_like
        modulus, m = k^2
    out : ndarray, optional
        where the result goes

    Returns
    -------
    float or ndarray
        u
    """
    if type(x) is float and type(k) is float and out is None:
        return _jacobi_arccd_k.one(x, k)
    return _jacobi_arccd_k(out, x, k)


_jacobi_arccd_m = Routine("jacobi_arccd_m", ("x", "m"), None)


def jacobi_arccd_m(x: ArrayLike, m: ArrayLike, *, out: Out = None) -> Any:
    r"""The u with cd(u|m) = x, of the parameter m = k^2.

    -1 <= x <= 1; then 0 <= u <= 2K. Outside: NaN. m > 1: as jacobi_arcsn_m.

    Accuracy: 1 ulp.

    Parameters
    ----------
    x : array_like
        number
    m : array_like
        parameter, m = k^2
    out : ndarray, optional
        where the result goes

    Returns
    -------
    float or ndarray
        u
    """
    if type(x) is float and type(m) is float and out is None:
        return _jacobi_arccd_m.one(x, m)
    return _jacobi_arccd_m(out, x, m)


_jacobi_arccd_mc = Routine("jacobi_arccd_mc", ("x", "mc"), None)


def jacobi_arccd_mc(x: ArrayLike, mc: ArrayLike, *, out: Out = None) -> Any:
    r"""The u with cd(u|m) = x, of the complementary parameter mc = 1 - m.

    -1 <= x <= 1; then 0 <= u <= 2K. Outside: NaN. m > 1: as jacobi_arcsn_m.

    Accuracy: 1 ulp.

    Parameters
    ----------
    x : array_like
        number
    mc : array_like
        complementary parameter 1 - m
    out : ndarray, optional
        where the result goes

    Returns
    -------
    float or ndarray
        u
    """
    if type(x) is float and type(mc) is float and out is None:
        return _jacobi_arccd_mc.one(x, mc)
    return _jacobi_arccd_mc(out, x, mc)


_jacobi_arcdc_k = Routine("jacobi_arcdc_k", ("x", "k"), None)


def jacobi_arcdc_k(x: ArrayLike, k: ArrayLike, *, out: Out = None) -> Any:
    r"""The u with dc(u|m) = x, principal value, of x and the modulus k, m = k^2.

    abs(x) >= 1; then 0 <= u <= 2K. Outside: NaN. m > 1: as jacobi_arcsn_m.

    Accuracy: 1 ulp.

    Parameters
    ----------
    x : array_like
        number
    k : array_like
        modulus, m = k^2
    out : ndarray, optional
        where the result goes

    Returns
    -------
    float or ndarray
        u
    """
    if type(x) is float and type(k) is float and out is None:
        return _jacobi_arcdc_k.one(x, k)
    return _jacobi_arcdc_k(out, x, k)


_jacobi_arcdc_m = Routine("jacobi_arcdc_m", ("x", "m"), None)


def jacobi_arcdc_m(x: ArrayLike, m: ArrayLike, *, out: Out = None) -> Any:
    r"""The u with dc(u|m) = x, of the parameter m = k^2.

    abs(x) >= 1; then 0 <= u <= 2K. Outside: NaN. m > 1: as jacobi_arcsn_m.

    Accuracy: 1 ulp.

    Parameters
    ----------
    x : array_like
        number
    m : array_like
        parameter, m = k^2
    out : ndarray, optional
        where the result goes

    Returns
    -------
    float or ndarray
        u
    """
    if type(x) is float and type(m) is float and out is None:
        return _jacobi_arcdc_m.one(x, m)
    return _jacobi_arcdc_m(out, x, m)


_jacobi_arcdc_mc = Routine("jacobi_arcdc_mc", ("x", "mc"), None)


def jacobi_arcdc_mc(x: ArrayLike, mc: ArrayLike, *, out: Out = None) -> Any:
    r"""The u with dc(u|m) = x, of the complementary parameter mc = 1 - m.

    abs(x) >= 1; then 0 <= u <= 2K. Outside: NaN. m > 1: as jacobi_arcsn_m.

    Accuracy: 1 ulp.

    Parameters
    ----------
    x : array_like
        number
    mc : array_like
        complementary parameter 1 - m
    out : ndarray, optional
        where the result goes

    Returns
    -------
    float or ndarray
        u
    """
    if type(x) is float and type(mc) is float and out is None:
        return _jacobi_arcdc_mc.one(x, mc)
    return _jacobi_arcdc_mc(out, x, mc)


_parameter_from_ellipk = Routine("parameter_from_ellipk", ("big_k",), None)


def parameter_from_ellipk(big_k: ArrayLike, *, out: Out = None) -> Any:
    r"""The parameter m with K(m) = k: the inverse of ellipk_m.

    Any k >= 0.

    Special cases: m(k=0) = -Inf, m(k=Inf) = 1; NaN for k < 0 and NaN. (pi/2 is not a floating-point
    number: at `acos(-1.0)/2` m is tiny, never 0.)

    Accuracy: 1 ulp of the exact inverse of k as given: m's relative error is that of k times k/(m
    dk/dm), much next to m = 0.

    Parameters
    ----------
    big_k : array_like
        K, complete integral of the first kind
    out : ndarray, optional
        where the result goes

    Returns
    -------
    float or ndarray
        m
    """
    if type(big_k) is float and out is None:
        return _parameter_from_ellipk.one(big_k)
    return _parameter_from_ellipk(out, big_k)


_complementary_parameter_from_ellipk = Routine("complementary_parameter_from_ellipk", ("big_k",), None)


def complementary_parameter_from_ellipk(big_k: ArrayLike, *, out: Out = None) -> Any:
    r"""The complementary parameter mc = 1 - m with K(m) = k: the inverse of ellipk_mc.

    Any k >= 0.

    Special cases: mc(k=0) = Inf, mc(k=Inf) = 0; NaN for k < 0 and NaN. For large k it is 16 exp(-2
    k), and 0 once that is below the smallest number.

    Accuracy: 1 ulp of the exact inverse of k as given: for large k a relative error of k counts 2 k
    times.

    Parameters
    ----------
    big_k : array_like
        K, complete integral of the first kind
    out : ndarray, optional
        where the result goes

    Returns
    -------
    float or ndarray
        mc
    """
    if type(big_k) is float and out is None:
        return _complementary_parameter_from_ellipk.one(big_k)
    return _complementary_parameter_from_ellipk(out, big_k)


_parameter_from_period_ratio = Routine("parameter_from_period_ratio", ("ratio",), None)


def parameter_from_period_ratio(ratio: ArrayLike, *, out: Out = None) -> Any:
    r"""The parameter m of a pendulum of this period ratio T/T_h: m = sin(theta_0/2)^2, K(m) = (pi/2)
    ratio.

    Any ratio >= 0; a pendulum's is at least 1.

    Special cases: m(1) = 0, m(0) = -Inf, m(Inf) = 1; NaN for ratio < 0 and NaN.

    Accuracy: 1 ulp of the exact inverse of the given ratio, next to 1 too (m ~ 4 (ratio - 1)).

    Parameters
    ----------
    ratio : array_like
        T/T_h, period over that of small swings
    out : ndarray, optional
        where the result goes

    Returns
    -------
    float or ndarray
        m
    """
    if type(ratio) is float and out is None:
        return _parameter_from_period_ratio.one(ratio)
    return _parameter_from_period_ratio(out, ratio)


_complementary_parameter_from_period_ratio = Routine("complementary_parameter_from_period_ratio", ("ratio",), None)


def complementary_parameter_from_period_ratio(ratio: ArrayLike, *, out: Out = None) -> Any:
    r"""The complementary parameter mc = 1 - m of this period ratio T/T_h: mc = cos(theta_0/2)^2, K(m) =
    (pi/2) ratio.

    Any ratio >= 0; a pendulum's is at least 1.

    Special cases: mc(1) = 1, mc(0) = Inf, mc(Inf) = 0; NaN for ratio < 0 and NaN. For a large ratio
    it is 16 exp(-pi ratio).

    Accuracy: 1 ulp of the exact inverse of the given ratio: for large ones a relative error counts
    pi ratio times.

    Parameters
    ----------
    ratio : array_like
        T/T_h, period over that of small swings
    out : ndarray, optional
        where the result goes

    Returns
    -------
    float or ndarray
        mc
    """
    if type(ratio) is float and out is None:
        return _complementary_parameter_from_period_ratio.one(ratio)
    return _complementary_parameter_from_period_ratio(out, ratio)


_ellipeinc_inverse_k = Routine("ellipeinc_inverse_k", ("s", "k"), None)


def ellipeinc_inverse_k(s: ArrayLike, k: ArrayLike, *, out: Out = None) -> Any:
    r"""The angle phi with E(phi|m) = s: the inverse of ellipeinc_k, of s and the modulus k, m = k^2.

    .. math:: \int_0^\phi \sqrt{1 - m\sin^2\theta}\,d\theta = s

    (sin(phi), sqrt(1 - m) cos(phi)) is where an arc of length s ends on the ellipse of half axes 1
    and sqrt(1 - m). Any s, quasi-periodic: 2 E(m) more are pi more. m <= 1; NaN for m > 1, where E
    ends.

    Special cases: phi(+-0) = +-0; m = 1: asin(s) for abs(s) <= 1, and pi for each 2 of s, as
    ellipeinc_m has it; +-0 at m = -Inf, +-Inf for infinite s, NaN for both; what overflows is Inf.

    Accuracy: 0.7 ulp of phi, or of what half an ulp of s is in phi where that is more: next to m =
    1 and phi = pi/2, where phi changes by ds/sqrt(1 - m sin(phi)^2), and behind many turns for m <
    0.

    Parameters
    ----------
    s : array_like
        E(phi), incomplete integral of the second kind
    k : array_like
        modulus, m = k^2
    out : ndarray, optional
        where the result goes

    Returns
    -------
    float or ndarray
        phi
    """
    if type(s) is float and type(k) is float and out is None:
        return _ellipeinc_inverse_k.one(s, k)
    return _ellipeinc_inverse_k(out, s, k)


_ellipeinc_inverse_m = Routine("ellipeinc_inverse_m", ("s", "m"), None)


def ellipeinc_inverse_m(s: ArrayLike, m: ArrayLike, *, out: Out = None) -> Any:
    r"""The angle phi with E(phi|m) = s, of the parameter m = k^2.

    .. math:: \int_0^\phi \sqrt{1 - m\sin^2\theta}\,d\theta = s

    (sin(phi), sqrt(1 - m) cos(phi)) is where an arc of length s ends on the ellipse of half axes 1
    and sqrt(1 - m). Any s, quasi-periodic: 2 E(m) more are pi more. m <= 1; NaN for m > 1, where E
    ends.

    Special cases: phi(+-0) = +-0; m = 1: asin(s) for abs(s) <= 1, and pi for each 2 of s, as
    ellipeinc_m has it; +-0 at m = -Inf, +-Inf for infinite s, NaN for both; what overflows is Inf.

    Accuracy: 0.7 ulp of phi, or of what half an ulp of s is in phi where that is more: next to m =
    1 and phi = pi/2, where phi changes by ds/sqrt(1 - m sin(phi)^2), and behind many turns for m <
    0.

    Parameters
    ----------
    s : array_like
        E(phi), incomplete integral of the second kind
    m : array_like
        parameter, m = k^2
    out : ndarray, optional
        where the result goes

    Returns
    -------
    float or ndarray
        phi
    """
    if type(s) is float and type(m) is float and out is None:
        return _ellipeinc_inverse_m.one(s, m)
    return _ellipeinc_inverse_m(out, s, m)


_ellipeinc_inverse_mc = Routine("ellipeinc_inverse_mc", ("s", "mc"), None)


def ellipeinc_inverse_mc(s: ArrayLike, mc: ArrayLike, *, out: Out = None) -> Any:
    r"""The angle phi with E(phi|m) = s, of the complementary parameter mc = 1 - m.

    .. math:: \int_0^\phi \sqrt{1 - m\sin^2\theta}\,d\theta = s

    (sin(phi), sqrt(1 - m) cos(phi)) is where an arc of length s ends on the ellipse of half axes 1
    and sqrt(1 - m). Any s, quasi-periodic: 2 E(m) more are pi more. m <= 1; NaN for m > 1, where E
    ends.

    Special cases: phi(+-0) = +-0; m = 1: asin(s) for abs(s) <= 1, and pi for each 2 of s, as
    ellipeinc_m has it; +-0 at m = -Inf, +-Inf for infinite s, NaN for both; what overflows is Inf.

    Accuracy: 0.7 ulp of phi, or of what half an ulp of s is in phi where that is more: next to m =
    1 and phi = pi/2, where phi changes by ds/sqrt(1 - m sin(phi)^2), and behind many turns for m <
    0.

    Parameters
    ----------
    s : array_like
        E(phi), incomplete integral of the second kind
    mc : array_like
        complementary parameter 1 - m
    out : ndarray, optional
        where the result goes

    Returns
    -------
    float or ndarray
        phi
    """
    if type(s) is float and type(mc) is float and out is None:
        return _ellipeinc_inverse_mc.one(s, mc)
    return _ellipeinc_inverse_mc(out, s, mc)


_jacobi_zeta_k = Routine("jacobi_zeta_k", ("phi", "k"), None)


def jacobi_zeta_k(phi: ArrayLike, k: ArrayLike, *, out: Out = None) -> Any:
    r"""Jacobi's zeta function of the amplitude phi in radians and the modulus k, m = k^2.

    .. math:: Z(\phi|m) = E(\phi|m) - \frac{E(m)}{K(m)} F(\phi|m)

    Any real phi (odd, of period pi); m <= 1. Outside: NaN. (Of the argument u, DLMF 22.16.32, it is
    this at the amplitude am(u|m).)

    Special cases: 0 at phi = 0 and at m = 0; m = 1: sin(phi) times the sign of cos(phi); m = -Inf:
    an infinity.

    Accuracy: 1 ulp, next to the zeros too.

    Parameters
    ----------
    phi : array_like
        angle in radians
    k : array_like
        modulus, m = k^2
    out : ndarray, optional
        where the result goes

    Returns
    -------
    float or ndarray
        Z
    """
    if type(phi) is float and type(k) is float and out is None:
        return _jacobi_zeta_k.one(phi, k)
    return _jacobi_zeta_k(out, phi, k)


_jacobi_zeta_m = Routine("jacobi_zeta_m", ("phi", "m"), None)


def jacobi_zeta_m(phi: ArrayLike, m: ArrayLike, *, out: Out = None) -> Any:
    r"""Jacobi's zeta function, of the parameter m = k^2.

    .. math:: Z(\phi|m) = E(\phi|m) - \frac{E(m)}{K(m)} F(\phi|m)

    Any real phi (odd, of period pi); m <= 1. Outside: NaN. (Of the argument u, DLMF 22.16.32, it is
    this at the amplitude am(u|m).)

    Special cases: 0 at phi = 0 and at m = 0; m = 1: sin(phi) times the sign of cos(phi); m = -Inf:
    an infinity.

    Accuracy: 1 ulp, next to the zeros too.

    Parameters
    ----------
    phi : array_like
        angle in radians
    m : array_like
        parameter, m = k^2
    out : ndarray, optional
        where the result goes

    Returns
    -------
    float or ndarray
        Z
    """
    if type(phi) is float and type(m) is float and out is None:
        return _jacobi_zeta_m.one(phi, m)
    return _jacobi_zeta_m(out, phi, m)


_jacobi_zeta_mc = Routine("jacobi_zeta_mc", ("phi", "mc"), None)


def jacobi_zeta_mc(phi: ArrayLike, mc: ArrayLike, *, out: Out = None) -> Any:
    r"""Jacobi's zeta function, of the complementary parameter mc = 1 - m.

    .. math:: Z(\phi|m) = E(\phi|m) - \frac{E(m)}{K(m)} F(\phi|m)

    Any real phi (odd, of period pi); m <= 1. Outside: NaN. (Of the argument u, DLMF 22.16.32, it is
    this at the amplitude am(u|m).)

    Special cases: 0 at phi = 0 and at m = 0; m = 1: sin(phi) times the sign of cos(phi); m = -Inf:
    an infinity.

    Accuracy: 1 ulp, next to the zeros too.

    Parameters
    ----------
    phi : array_like
        angle in radians
    mc : array_like
        complementary parameter 1 - m
    out : ndarray, optional
        where the result goes

    Returns
    -------
    float or ndarray
        Z
    """
    if type(phi) is float and type(mc) is float and out is None:
        return _jacobi_zeta_mc.one(phi, mc)
    return _jacobi_zeta_mc(out, phi, mc)


_heuman_lambda_k = Routine("heuman_lambda_k", ("phi", "k"), None)


def heuman_lambda_k(phi: ArrayLike, k: ArrayLike, *, out: Out = None) -> Any:
    r"""Heuman's lambda function of the amplitude phi in radians and the modulus k, m = k^2.

    .. math:: \Lambda_0(\phi|m) = \frac{F(\phi|1-m)}{K(1-m)} + \frac{2}{\pi} K(m) Z(\phi|1-m)

    Any real phi (quasi-periodic: 2 more for each half turn); 0 <= m <= 1. Outside: NaN.

    Special cases: m = 0: sin(phi) and 2 for each half turn; m = 1: 2 phi/pi.

    Accuracy: 1 ulp.

    Parameters
    ----------
    phi : array_like
        angle in radians
    k : array_like
        modulus, m = k^2
    out : ndarray, optional
        where the result goes

    Returns
    -------
    float or ndarray
        Lambda
    """
    if type(phi) is float and type(k) is float and out is None:
        return _heuman_lambda_k.one(phi, k)
    return _heuman_lambda_k(out, phi, k)


_heuman_lambda_m = Routine("heuman_lambda_m", ("phi", "m"), None)


def heuman_lambda_m(phi: ArrayLike, m: ArrayLike, *, out: Out = None) -> Any:
    r"""Heuman's lambda function, of the parameter m = k^2.

    .. math:: \Lambda_0(\phi|m) = \frac{F(\phi|1-m)}{K(1-m)} + \frac{2}{\pi} K(m) Z(\phi|1-m)

    Any real phi (quasi-periodic: 2 more for each half turn); 0 <= m <= 1. Outside: NaN.

    Special cases: m = 0: sin(phi) and 2 for each half turn; m = 1: 2 phi/pi.

    Accuracy: 1 ulp.

    Parameters
    ----------
    phi : array_like
        angle in radians
    m : array_like
        parameter, m = k^2
    out : ndarray, optional
        where the result goes

    Returns
    -------
    float or ndarray
        Lambda
    """
    if type(phi) is float and type(m) is float and out is None:
        return _heuman_lambda_m.one(phi, m)
    return _heuman_lambda_m(out, phi, m)


_heuman_lambda_mc = Routine("heuman_lambda_mc", ("phi", "mc"), None)


def heuman_lambda_mc(phi: ArrayLike, mc: ArrayLike, *, out: Out = None) -> Any:
    r"""Heuman's lambda function, of the complementary parameter mc = 1 - m.

    .. math:: \Lambda_0(\phi|m) = \frac{F(\phi|1-m)}{K(1-m)} + \frac{2}{\pi} K(m) Z(\phi|1-m)

    Any real phi (quasi-periodic: 2 more for each half turn); 0 <= m <= 1. Outside: NaN.

    Special cases: m = 0: sin(phi) and 2 for each half turn; m = 1: 2 phi/pi.

    Accuracy: 1 ulp.

    Parameters
    ----------
    phi : array_like
        angle in radians
    mc : array_like
        complementary parameter 1 - m
    out : ndarray, optional
        where the result goes

    Returns
    -------
    float or ndarray
        Lambda
    """
    if type(phi) is float and type(mc) is float and out is None:
        return _heuman_lambda_mc.one(phi, mc)
    return _heuman_lambda_mc(out, phi, mc)


_period_ratio = Routine("period_ratio", ("amplitude",), None)


def period_ratio(amplitude: ArrayLike, *, out: Out = None) -> Any:
    r"""The period T of a pendulum over that of its small swings, T_h = 2 pi sqrt(l/g):

    .. math:: T/T_h = \frac{2}{\pi} K(\sin\tfrac{\theta_0}{2}).

    Argument: the amplitude theta_0 in radians, of either sign. No digit is lost next to the top:
    half of it is K's modular angle.

    Special cases: 1 at 0; NaN beyond acos(-1.0) and for NaN. (pi itself is no real number of any
    kind: the period at acos(-1.0) is long, and never infinite.)

    Accuracy: 0.51 ulp.

    Source: DLMF 22.19.1-3

    Parameters
    ----------
    amplitude : array_like
        of the swing, in radians
    out : ndarray, optional
        where the result goes

    Returns
    -------
    float or ndarray
        T/T_h
    """
    if type(amplitude) is float and out is None:
        return _period_ratio.one(amplitude)
    return _period_ratio(out, amplitude)


_period_excess = Routine("period_excess", ("amplitude",), None)


def period_excess(amplitude: ArrayLike, *, out: Out = None) -> Any:
    r"""By how much a pendulum's period exceeds that of small swings: T/T_h - 1, with all digits for
    small amplitudes, too (theta_0^2/16 + ...),.

    .. math:: T/T_h - 1 = \theta_3(0, q)^2 - 1 = s (2 + s), \quad s = 2 q + 2 q^4 + 2 q^9 + \ldots

    Argument: the amplitude theta_0 in radians, of either sign. A clock regulated for small swings
    that swings so far loses this part of the time: after `f/period_excess(theta_0)` swings it is f
    swings off.

    Special cases: 0 at 0; NaN beyond acos(-1.0) and for NaN.

    Accuracy: 0.51 ulp.

    Source: DLMF 20.9.2, 19.8.5

    Parameters
    ----------
    amplitude : array_like
        of the swing, in radians
    out : ndarray, optional
        where the result goes

    Returns
    -------
    float or ndarray
        excess
    """
    if type(amplitude) is float and out is None:
        return _period_excess.one(amplitude)
    return _period_excess(out, amplitude)


_amplitude_of_period = Routine("amplitude_of_period", ("ratio",), None)


def amplitude_of_period(ratio: ArrayLike, *, out: Out = None) -> Any:
    r"""The amplitude of a pendulum of this period ratio T/T_h: in radians, the inverse of period_ratio.

    Special cases: 0 for 1, acos(-1.0) for infinity; NaN below 1 and for NaN. For a ratio next to 1
    see amplitude_of_excess.

    Accuracy: 2 ulp of the exact inverse at the given ratio (next to 1 the amplitude is 4 sqrt(T/T_h
    - 1)).

    Parameters
    ----------
    ratio : array_like
        T/T_h, period over that of small swings
    out : ndarray, optional
        where the result goes

    Returns
    -------
    float or ndarray
        theta_0
    """
    if type(ratio) is float and out is None:
        return _amplitude_of_period.one(ratio)
    return _amplitude_of_period(out, ratio)


_amplitude_of_excess = Routine("amplitude_of_excess", ("excess",), None)


def amplitude_of_excess(excess: ArrayLike, *, out: Out = None) -> Any:
    r"""The amplitude of a pendulum of this excess T/T_h - 1: in radians, the inverse of period_excess.

    Argument: T/T_h - 1, as 0.03 for a pendulum that is 3 percent slow.

    Special cases: 0 for 0, acos(-1.0) for infinity; NaN below 0 and for NaN.

    Accuracy: 2 ulp, down to the smallest excess.

    Source: DLMF 22.19.1-3

    Parameters
    ----------
    excess : array_like
        T/T_h - 1
    out : ndarray, optional
        where the result goes

    Returns
    -------
    float or ndarray
        theta_0
    """
    if type(excess) is float and out is None:
        return _amplitude_of_excess.one(excess)
    return _amplitude_of_excess(out, excess)


_amplitude_three_terms = Routine("amplitude_three_terms", ("excess",), None)


def amplitude_three_terms(excess: ArrayLike, *, out: Out = None) -> Any:
    r"""The amplitude of a pendulum of this excess by three terms: in radians, where three terms of the
    series make the period longer by the part `excess` than that of small swings; k^2 solves the
    quadratic 9 k^4/64 + k^2/4 = excess. The exact one is amplitude_of_excess.

    Argument: 0 <= excess <= 25/64, the value at 180 degrees; NaN outside.

    Accuracy: 3 ulp below 120 degrees.

    Parameters
    ----------
    excess : array_like
        T/T_h - 1
    out : ndarray, optional
        where the result goes

    Returns
    -------
    float or ndarray
        theta_0
    """
    if type(excess) is float and out is None:
        return _amplitude_three_terms.one(excess)
    return _amplitude_three_terms(out, excess)


_ellipse_perimeter = Routine("ellipse_perimeter", ("a", "b"), None)


def ellipse_perimeter(a: ArrayLike, b: ArrayLike, *, out: Out = None) -> Any:
    r"""The perimeter of an ellipse of semiaxes a and b, in any order:

    .. math:: L = 4 a E(m), \quad m = (a^2 - b^2)/a^2, \quad a \ge b.

    Arguments: a, b >= 0 of any magnitude; NaN outside, and for NaN. Nothing overflows but L.

    Special cases: a = b: 2 pi a, correctly rounded; b = 0: 4 a; a or b infinite: Inf.

    Accuracy: 0.51 ulp.

    Parameters
    ----------
    a : array_like
        semiaxis
    b : array_like
        semiaxis
    out : ndarray, optional
        where the result goes

    Returns
    -------
    float or ndarray
        L
    """
    if type(a) is float and type(b) is float and out is None:
        return _ellipse_perimeter.one(a, b)
    return _ellipse_perimeter(out, a, b)
