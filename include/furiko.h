/* SPDX-License-Identifier: MIT */
/* Written by tools/make_c_interface.py. */
/**
 * @file furiko.h
 * Elliptic integrals, Jacobi elliptic functions and the exact pendulum, for C and C++.
 *
 * The names are those of the Fortran library behind `furiko_`, so is what they promise: accuracy, ranges and
 * special cases are in doc/functions.md, doc/integrals.md and doc/pendulum.md. The argument's form is in the
 * name: `_k` takes the modulus k, `_m` the parameter m = k^2, `_mc` the complementary parameter 1 - m, `_alpha`
 * the modular angle. Angles are in radians; n has DLMF's sign.
 *
 * `furiko_ellipf_m` is double, `furiko_ellipf_mf` float, `furiko_ellipf_m_v` and `furiko_ellipf_m_vf` take arrays
 * of `count` numbers, which may be 0. Arrays of results overlap no other array. Several results go through pointers,
 * none of which is NULL.
 *
 * Nothing is allocated (but by the integrators of any system), nothing kept between calls: all functions may be
 * called by many threads at once. There are no error codes: where a function has no value, the result is NaN, at a
 * pole it is infinite.
 */
#ifndef FURIKO_H
#define FURIKO_H

#include <stddef.h>

#define FURIKO_VERSION_MAJOR 0
#define FURIKO_VERSION_MINOR 3
#define FURIKO_VERSION_PATCH 0
/** As furiko_version() of a library that belongs to this header */
#define FURIKO_VERSION (10000*FURIKO_VERSION_MAJOR + 100*FURIKO_VERSION_MINOR + FURIKO_VERSION_PATCH)

#ifdef __cplusplus
extern "C" {
#endif

/** The library's version: 10000*major + 100*minor + patch. */
int furiko_version(void);

/** How many of a hundred known values come out wrong in this build: 0, or something is amiss with the compiler that
 * furiko was built by, with its flags or with the processor's rounding. Takes less than a millisecond. */
int furiko_selftest(void);

/* ---- Arithmetic-geometric mean ---- */

/** Arithmetic-geometric mean M(a, b).
 *
 * @param a first number
 * @param b second number
 * @{ */
double furiko_agm(double a, double b);
float furiko_agmf(float a, float b);
void furiko_agm_v(size_t count, const double a[], const double b[], double mean[]);
void furiko_agm_vf(size_t count, const float a[], const float b[], float mean[]);
/** @} */

/* ---- Complete integrals K, E, B, D ---- */

/** Complete elliptic integral of the first kind.
 *
 * @param k modulus, m = k^2
 * @{ */
double furiko_ellipk_k(double k);
float furiko_ellipk_kf(float k);
void furiko_ellipk_k_v(size_t count, const double k[], double big_k[]);
void furiko_ellipk_k_vf(size_t count, const float k[], float big_k[]);
/** @} */

/** Complete elliptic integral of the first kind.
 *
 * @param m parameter, m = k^2
 * @{ */
double furiko_ellipk_m(double m);
float furiko_ellipk_mf(float m);
void furiko_ellipk_m_v(size_t count, const double m[], double big_k[]);
void furiko_ellipk_m_vf(size_t count, const float m[], float big_k[]);
/** @} */

/** Complete elliptic integral of the first kind.
 *
 * @param mc complementary parameter 1 - m
 * @{ */
double furiko_ellipk_mc(double mc);
float furiko_ellipk_mcf(float mc);
void furiko_ellipk_mc_v(size_t count, const double mc[], double big_k[]);
void furiko_ellipk_mc_vf(size_t count, const float mc[], float big_k[]);
/** @} */

/** Complete elliptic integral of the first kind.
 *
 * @param alpha modular angle in radians, k = sin(alpha)
 * @{ */
double furiko_ellipk_alpha(double alpha);
float furiko_ellipk_alphaf(float alpha);
void furiko_ellipk_alpha_v(size_t count, const double alpha[], double big_k[]);
void furiko_ellipk_alpha_vf(size_t count, const float alpha[], float big_k[]);
/** @} */

/** Complete elliptic integral of the second kind.
 *
 * @param k modulus, m = k^2
 * @{ */
double furiko_ellipe_k(double k);
float furiko_ellipe_kf(float k);
void furiko_ellipe_k_v(size_t count, const double k[], double e[]);
void furiko_ellipe_k_vf(size_t count, const float k[], float e[]);
/** @} */

/** Complete elliptic integral of the second kind.
 *
 * @param m parameter, m = k^2
 * @{ */
double furiko_ellipe_m(double m);
float furiko_ellipe_mf(float m);
void furiko_ellipe_m_v(size_t count, const double m[], double e[]);
void furiko_ellipe_m_vf(size_t count, const float m[], float e[]);
/** @} */

/** Complete elliptic integral of the second kind.
 *
 * @param mc complementary parameter 1 - m
 * @{ */
double furiko_ellipe_mc(double mc);
float furiko_ellipe_mcf(float mc);
void furiko_ellipe_mc_v(size_t count, const double mc[], double e[]);
void furiko_ellipe_mc_vf(size_t count, const float mc[], float e[]);
/** @} */

/** Complete elliptic integral of the second kind.
 *
 * @param alpha modular angle in radians, k = sin(alpha)
 * @{ */
double furiko_ellipe_alpha(double alpha);
float furiko_ellipe_alphaf(float alpha);
void furiko_ellipe_alpha_v(size_t count, const double alpha[], double e[]);
void furiko_ellipe_alpha_vf(size_t count, const float alpha[], float e[]);
/** @} */

/** Associated complete elliptic integral B = (E - mc K)/m.
 *
 * @param k modulus, m = k^2
 * @{ */
double furiko_ellipb_k(double k);
float furiko_ellipb_kf(float k);
void furiko_ellipb_k_v(size_t count, const double k[], double b[]);
void furiko_ellipb_k_vf(size_t count, const float k[], float b[]);
/** @} */

/** Associated complete elliptic integral B = (E - mc K)/m.
 *
 * @param m parameter, m = k^2
 * @{ */
double furiko_ellipb_m(double m);
float furiko_ellipb_mf(float m);
void furiko_ellipb_m_v(size_t count, const double m[], double b[]);
void furiko_ellipb_m_vf(size_t count, const float m[], float b[]);
/** @} */

/** Associated complete elliptic integral B = (E - mc K)/m.
 *
 * @param mc complementary parameter 1 - m
 * @{ */
double furiko_ellipb_mc(double mc);
float furiko_ellipb_mcf(float mc);
void furiko_ellipb_mc_v(size_t count, const double mc[], double b[]);
void furiko_ellipb_mc_vf(size_t count, const float mc[], float b[]);
/** @} */

/** Associated complete elliptic integral B = (E - mc K)/m.
 *
 * @param alpha modular angle in radians, k = sin(alpha)
 * @{ */
double furiko_ellipb_alpha(double alpha);
float furiko_ellipb_alphaf(float alpha);
void furiko_ellipb_alpha_v(size_t count, const double alpha[], double b[]);
void furiko_ellipb_alpha_vf(size_t count, const float alpha[], float b[]);
/** @} */

/** Complete elliptic integral D = (K - E)/m.
 *
 * @param k modulus, m = k^2
 * @{ */
double furiko_ellipd_k(double k);
float furiko_ellipd_kf(float k);
void furiko_ellipd_k_v(size_t count, const double k[], double d[]);
void furiko_ellipd_k_vf(size_t count, const float k[], float d[]);
/** @} */

/** Complete elliptic integral D = (K - E)/m.
 *
 * @param m parameter, m = k^2
 * @{ */
double furiko_ellipd_m(double m);
float furiko_ellipd_mf(float m);
void furiko_ellipd_m_v(size_t count, const double m[], double d[]);
void furiko_ellipd_m_vf(size_t count, const float m[], float d[]);
/** @} */

/** Complete elliptic integral D = (K - E)/m.
 *
 * @param mc complementary parameter 1 - m
 * @{ */
double furiko_ellipd_mc(double mc);
float furiko_ellipd_mcf(float mc);
void furiko_ellipd_mc_v(size_t count, const double mc[], double d[]);
void furiko_ellipd_mc_vf(size_t count, const float mc[], float d[]);
/** @} */

/** Complete elliptic integral D = (K - E)/m.
 *
 * @param alpha modular angle in radians, k = sin(alpha)
 * @{ */
double furiko_ellipd_alpha(double alpha);
float furiko_ellipd_alphaf(float alpha);
void furiko_ellipd_alpha_v(size_t count, const double alpha[], double d[]);
void furiko_ellipd_alpha_vf(size_t count, const float alpha[], float d[]);
/** @} */

/** K and E together.
 *
 * @param k modulus, m = k^2
 * @{ */
void furiko_ellipke_k(double k, double *big_k, double *e);
void furiko_ellipke_kf(float k, float *big_k, float *e);
void furiko_ellipke_k_v(size_t count, const double k[], double big_k[], double e[]);
void furiko_ellipke_k_vf(size_t count, const float k[], float big_k[], float e[]);
/** @} */

/** K and E together.
 *
 * @param m parameter, m = k^2
 * @{ */
void furiko_ellipke_m(double m, double *big_k, double *e);
void furiko_ellipke_mf(float m, float *big_k, float *e);
void furiko_ellipke_m_v(size_t count, const double m[], double big_k[], double e[]);
void furiko_ellipke_m_vf(size_t count, const float m[], float big_k[], float e[]);
/** @} */

/** K and E together.
 *
 * @param mc complementary parameter 1 - m
 * @{ */
void furiko_ellipke_mc(double mc, double *big_k, double *e);
void furiko_ellipke_mcf(float mc, float *big_k, float *e);
void furiko_ellipke_mc_v(size_t count, const double mc[], double big_k[], double e[]);
void furiko_ellipke_mc_vf(size_t count, const float mc[], float big_k[], float e[]);
/** @} */

/** K and E together.
 *
 * @param alpha modular angle in radians, k = sin(alpha)
 * @{ */
void furiko_ellipke_alpha(double alpha, double *big_k, double *e);
void furiko_ellipke_alphaf(float alpha, float *big_k, float *e);
void furiko_ellipke_alpha_v(size_t count, const double alpha[], double big_k[], double e[]);
void furiko_ellipke_alpha_vf(size_t count, const float alpha[], float big_k[], float e[]);
/** @} */

/* ---- The complete integral S ---- */

/** Complete elliptic integral S = (D - B)/m.
 *
 * @param k modulus, m = k^2
 * @{ */
double furiko_ellips_k(double k);
float furiko_ellips_kf(float k);
void furiko_ellips_k_v(size_t count, const double k[], double s[]);
void furiko_ellips_k_vf(size_t count, const float k[], float s[]);
/** @} */

/** Complete elliptic integral S = (D - B)/m.
 *
 * @param m parameter, m = k^2
 * @{ */
double furiko_ellips_m(double m);
float furiko_ellips_mf(float m);
void furiko_ellips_m_v(size_t count, const double m[], double s[]);
void furiko_ellips_m_vf(size_t count, const float m[], float s[]);
/** @} */

/** Complete elliptic integral S = (D - B)/m.
 *
 * @param mc complementary parameter 1 - m
 * @{ */
double furiko_ellips_mc(double mc);
float furiko_ellips_mcf(float mc);
void furiko_ellips_mc_v(size_t count, const double mc[], double s[]);
void furiko_ellips_mc_vf(size_t count, const float mc[], float s[]);
/** @} */

/* ---- Incomplete integrals F, E, D ---- */

/** Legendre's incomplete integral of the first kind.
 *
 * @param phi angle in radians
 * @param k modulus, m = k^2
 * @{ */
double furiko_ellipf_k(double phi, double k);
float furiko_ellipf_kf(float phi, float k);
void furiko_ellipf_k_v(size_t count, const double phi[], const double k[], double f[]);
void furiko_ellipf_k_vf(size_t count, const float phi[], const float k[], float f[]);
/** @} */

/** Legendre's incomplete integral of the first kind.
 *
 * @param phi angle in radians
 * @param m parameter, m = k^2
 * @{ */
double furiko_ellipf_m(double phi, double m);
float furiko_ellipf_mf(float phi, float m);
void furiko_ellipf_m_v(size_t count, const double phi[], const double m[], double f[]);
void furiko_ellipf_m_vf(size_t count, const float phi[], const float m[], float f[]);
/** @} */

/** Legendre's incomplete integral of the first kind.
 *
 * @param phi angle in radians
 * @param mc complementary parameter 1 - m
 * @{ */
double furiko_ellipf_mc(double phi, double mc);
float furiko_ellipf_mcf(float phi, float mc);
void furiko_ellipf_mc_v(size_t count, const double phi[], const double mc[], double f[]);
void furiko_ellipf_mc_vf(size_t count, const float phi[], const float mc[], float f[]);
/** @} */

/** Legendre's incomplete integral of the second kind.
 *
 * @param phi angle in radians
 * @param k modulus, m = k^2
 * @{ */
double furiko_ellipeinc_k(double phi, double k);
float furiko_ellipeinc_kf(float phi, float k);
void furiko_ellipeinc_k_v(size_t count, const double phi[], const double k[], double e[]);
void furiko_ellipeinc_k_vf(size_t count, const float phi[], const float k[], float e[]);
/** @} */

/** Legendre's incomplete integral of the second kind.
 *
 * @param phi angle in radians
 * @param m parameter, m = k^2
 * @{ */
double furiko_ellipeinc_m(double phi, double m);
float furiko_ellipeinc_mf(float phi, float m);
void furiko_ellipeinc_m_v(size_t count, const double phi[], const double m[], double e[]);
void furiko_ellipeinc_m_vf(size_t count, const float phi[], const float m[], float e[]);
/** @} */

/** Legendre's incomplete integral of the second kind.
 *
 * @param phi angle in radians
 * @param mc complementary parameter 1 - m
 * @{ */
double furiko_ellipeinc_mc(double phi, double mc);
float furiko_ellipeinc_mcf(float phi, float mc);
void furiko_ellipeinc_mc_v(size_t count, const double phi[], const double mc[], double e[]);
void furiko_ellipeinc_mc_vf(size_t count, const float phi[], const float mc[], float e[]);
/** @} */

/** Legendre's incomplete integral D = (F - E)/m.
 *
 * @param phi angle in radians
 * @param k modulus, m = k^2
 * @{ */
double furiko_ellipdinc_k(double phi, double k);
float furiko_ellipdinc_kf(float phi, float k);
void furiko_ellipdinc_k_v(size_t count, const double phi[], const double k[], double d[]);
void furiko_ellipdinc_k_vf(size_t count, const float phi[], const float k[], float d[]);
/** @} */

/** Legendre's incomplete integral D = (F - E)/m.
 *
 * @param phi angle in radians
 * @param m parameter, m = k^2
 * @{ */
double furiko_ellipdinc_m(double phi, double m);
float furiko_ellipdinc_mf(float phi, float m);
void furiko_ellipdinc_m_v(size_t count, const double phi[], const double m[], double d[]);
void furiko_ellipdinc_m_vf(size_t count, const float phi[], const float m[], float d[]);
/** @} */

/** Legendre's incomplete integral D = (F - E)/m.
 *
 * @param phi angle in radians
 * @param mc complementary parameter 1 - m
 * @{ */
double furiko_ellipdinc_mc(double phi, double mc);
float furiko_ellipdinc_mcf(float phi, float mc);
void furiko_ellipdinc_mc_v(size_t count, const double phi[], const double mc[], double d[]);
void furiko_ellipdinc_mc_vf(size_t count, const float phi[], const float mc[], float d[]);
/** @} */

/* ---- The third kind ---- */

/** Complete elliptic integral of the third kind.
 *
 * @param n characteristic, in DLMF's sign
 * @param k modulus, m = k^2
 * @{ */
double furiko_ellippi_k(double n, double k);
float furiko_ellippi_kf(float n, float k);
void furiko_ellippi_k_v(size_t count, const double n[], const double k[], double pi[]);
void furiko_ellippi_k_vf(size_t count, const float n[], const float k[], float pi[]);
/** @} */

/** Complete elliptic integral of the third kind.
 *
 * @param n characteristic, in DLMF's sign
 * @param m parameter, m = k^2
 * @{ */
double furiko_ellippi_m(double n, double m);
float furiko_ellippi_mf(float n, float m);
void furiko_ellippi_m_v(size_t count, const double n[], const double m[], double pi[]);
void furiko_ellippi_m_vf(size_t count, const float n[], const float m[], float pi[]);
/** @} */

/** Complete elliptic integral of the third kind.
 *
 * @param n characteristic, in DLMF's sign
 * @param mc complementary parameter 1 - m
 * @{ */
double furiko_ellippi_mc(double n, double mc);
float furiko_ellippi_mcf(float n, float mc);
void furiko_ellippi_mc_v(size_t count, const double n[], const double mc[], double pi[]);
void furiko_ellippi_mc_vf(size_t count, const float n[], const float mc[], float pi[]);
/** @} */

/** Legendre's incomplete integral of the third kind.
 *
 * @param n characteristic, in DLMF's sign
 * @param phi angle in radians
 * @param k modulus, m = k^2
 * @{ */
double furiko_ellippiinc_k(double n, double phi, double k);
float furiko_ellippiinc_kf(float n, float phi, float k);
void furiko_ellippiinc_k_v(size_t count, const double n[], const double phi[], const double k[], double pi[]);
void furiko_ellippiinc_k_vf(size_t count, const float n[], const float phi[], const float k[], float pi[]);
/** @} */

/** Legendre's incomplete integral of the third kind.
 *
 * @param n characteristic, in DLMF's sign
 * @param phi angle in radians
 * @param m parameter, m = k^2
 * @{ */
double furiko_ellippiinc_m(double n, double phi, double m);
float furiko_ellippiinc_mf(float n, float phi, float m);
void furiko_ellippiinc_m_v(size_t count, const double n[], const double phi[], const double m[], double pi[]);
void furiko_ellippiinc_m_vf(size_t count, const float n[], const float phi[], const float m[], float pi[]);
/** @} */

/** Legendre's incomplete integral of the third kind.
 *
 * @param n characteristic, in DLMF's sign
 * @param phi angle in radians
 * @param mc complementary parameter 1 - m
 * @{ */
double furiko_ellippiinc_mc(double n, double phi, double mc);
float furiko_ellippiinc_mcf(float n, float phi, float mc);
void furiko_ellippiinc_mc_v(size_t count, const double n[], const double phi[], const double mc[],
        double pi[]);
void furiko_ellippiinc_mc_vf(size_t count, const float n[], const float phi[], const float mc[], float pi[]);
/** @} */

/* ---- The associate integral of the third kind ---- */

/** Associate complete integral J = (Pi - K)/n.
 *
 * @param n characteristic, in DLMF's sign
 * @param k modulus, m = k^2
 * @{ */
double furiko_ellipj_k(double n, double k);
float furiko_ellipj_kf(float n, float k);
void furiko_ellipj_k_v(size_t count, const double n[], const double k[], double j[]);
void furiko_ellipj_k_vf(size_t count, const float n[], const float k[], float j[]);
/** @} */

/** Associate complete integral J = (Pi - K)/n.
 *
 * @param n characteristic, in DLMF's sign
 * @param m parameter, m = k^2
 * @{ */
double furiko_ellipj_m(double n, double m);
float furiko_ellipj_mf(float n, float m);
void furiko_ellipj_m_v(size_t count, const double n[], const double m[], double j[]);
void furiko_ellipj_m_vf(size_t count, const float n[], const float m[], float j[]);
/** @} */

/** Associate complete integral J = (Pi - K)/n.
 *
 * @param n characteristic, in DLMF's sign
 * @param mc complementary parameter 1 - m
 * @{ */
double furiko_ellipj_mc(double n, double mc);
float furiko_ellipj_mcf(float n, float mc);
void furiko_ellipj_mc_v(size_t count, const double n[], const double mc[], double j[]);
void furiko_ellipj_mc_vf(size_t count, const float n[], const float mc[], float j[]);
/** @} */

/** Associate incomplete integral J = (Pi - F)/n.
 *
 * @param n characteristic, in DLMF's sign
 * @param phi angle in radians
 * @param k modulus, m = k^2
 * @{ */
double furiko_ellipjinc_k(double n, double phi, double k);
float furiko_ellipjinc_kf(float n, float phi, float k);
void furiko_ellipjinc_k_v(size_t count, const double n[], const double phi[], const double k[], double j[]);
void furiko_ellipjinc_k_vf(size_t count, const float n[], const float phi[], const float k[], float j[]);
/** @} */

/** Associate incomplete integral J = (Pi - F)/n.
 *
 * @param n characteristic, in DLMF's sign
 * @param phi angle in radians
 * @param m parameter, m = k^2
 * @{ */
double furiko_ellipjinc_m(double n, double phi, double m);
float furiko_ellipjinc_mf(float n, float phi, float m);
void furiko_ellipjinc_m_v(size_t count, const double n[], const double phi[], const double m[], double j[]);
void furiko_ellipjinc_m_vf(size_t count, const float n[], const float phi[], const float m[], float j[]);
/** @} */

/** Associate incomplete integral J = (Pi - F)/n.
 *
 * @param n characteristic, in DLMF's sign
 * @param phi angle in radians
 * @param mc complementary parameter 1 - m
 * @{ */
double furiko_ellipjinc_mc(double n, double phi, double mc);
float furiko_ellipjinc_mcf(float n, float phi, float mc);
void furiko_ellipjinc_mc_v(size_t count, const double n[], const double phi[], const double mc[], double j[]);
void furiko_ellipjinc_mc_vf(size_t count, const float n[], const float phi[], const float mc[], float j[]);
/** @} */

/* ---- Bulirsch's cel ---- */

/** Bulirsch's general complete elliptic integral.
 *
 * @param kc complementary modulus
 * @param p 1 - n
 * @param a weight of the squared cosine
 * @param b weight of the squared sine
 * @{ */
double furiko_bulirsch_cel(double kc, double p, double a, double b);
float furiko_bulirsch_celf(float kc, float p, float a, float b);
void furiko_bulirsch_cel_v(size_t count, const double kc[], const double p[], const double a[],
        const double b[], double f[]);
void furiko_bulirsch_cel_vf(size_t count, const float kc[], const float p[], const float a[],
        const float b[], float f[]);
/** @} */

/* ---- Carlson's integrals ---- */

/** Carlson's integral of the first kind.
 *
 * @param x number
 * @param y number
 * @param z number
 * @{ */
double furiko_carlson_rf(double x, double y, double z);
float furiko_carlson_rff(float x, float y, float z);
void furiko_carlson_rf_v(size_t count, const double x[], const double y[], const double z[], double rf[]);
void furiko_carlson_rf_vf(size_t count, const float x[], const float y[], const float z[], float rf[]);
/** @} */

/** Carlson's degenerate integral R_C(x,y) = R_F(x,y,y).
 *
 * @param x number
 * @param y number
 * @{ */
double furiko_carlson_rc(double x, double y);
float furiko_carlson_rcf(float x, float y);
void furiko_carlson_rc_v(size_t count, const double x[], const double y[], double rc[]);
void furiko_carlson_rc_vf(size_t count, const float x[], const float y[], float rc[]);
/** @} */

/** Carlson's integral of the second kind, R_D(x,y,z) = R_J(x,y,z,z).
 *
 * @param x number
 * @param y number
 * @param z number
 * @{ */
double furiko_carlson_rd(double x, double y, double z);
float furiko_carlson_rdf(float x, float y, float z);
void furiko_carlson_rd_v(size_t count, const double x[], const double y[], const double z[], double rd[]);
void furiko_carlson_rd_vf(size_t count, const float x[], const float y[], const float z[], float rd[]);
/** @} */

/** Carlson's integral of the third kind.
 *
 * @param x number
 * @param y number
 * @param z number
 * @param p number
 * @{ */
double furiko_carlson_rj(double x, double y, double z, double p);
float furiko_carlson_rjf(float x, float y, float z, float p);
void furiko_carlson_rj_v(size_t count, const double x[], const double y[], const double z[],
        const double p[], double rj[]);
void furiko_carlson_rj_vf(size_t count, const float x[], const float y[], const float z[], const float p[],
        float rj[]);
/** @} */

/** Carlson's symmetric integral of the second kind.
 *
 * @param x number
 * @param y number
 * @param z number
 * @{ */
double furiko_carlson_rg(double x, double y, double z);
float furiko_carlson_rgf(float x, float y, float z);
void furiko_carlson_rg_v(size_t count, const double x[], const double y[], const double z[], double rg[]);
void furiko_carlson_rg_vf(size_t count, const float x[], const float y[], const float z[], float rg[]);
/** @} */

/* ---- The nome ---- */

/** Jacobi's nome.
 *
 * @param k modulus, m = k^2
 * @{ */
double furiko_nome_k(double k);
float furiko_nome_kf(float k);
void furiko_nome_k_v(size_t count, const double k[], double q[]);
void furiko_nome_k_vf(size_t count, const float k[], float q[]);
/** @} */

/** Jacobi's nome.
 *
 * @param m parameter, m = k^2
 * @{ */
double furiko_nome_m(double m);
float furiko_nome_mf(float m);
void furiko_nome_m_v(size_t count, const double m[], double q[]);
void furiko_nome_m_vf(size_t count, const float m[], float q[]);
/** @} */

/** Jacobi's nome.
 *
 * @param mc complementary parameter 1 - m
 * @{ */
double furiko_nome_mc(double mc);
float furiko_nome_mcf(float mc);
void furiko_nome_mc_v(size_t count, const double mc[], double q[]);
void furiko_nome_mc_vf(size_t count, const float mc[], float q[]);
/** @} */

/** The parameter m of Jacobi's nome q.
 *
 * @param q nome
 * @{ */
double furiko_parameter_from_nome(double q);
float furiko_parameter_from_nomef(float q);
void furiko_parameter_from_nome_v(size_t count, const double q[], double m[]);
void furiko_parameter_from_nome_vf(size_t count, const float q[], float m[]);
/** @} */

/** The complementary parameter mc = 1 - m of Jacobi's nome q.
 *
 * @param q nome
 * @{ */
double furiko_complementary_parameter_from_nome(double q);
float furiko_complementary_parameter_from_nomef(float q);
void furiko_complementary_parameter_from_nome_v(size_t count, const double q[], double mc[]);
void furiko_complementary_parameter_from_nome_vf(size_t count, const float q[], float mc[]);
/** @} */

/* ---- Theta functions ---- */

/** Jacobi's theta function theta_1.
 *
 * @param z number
 * @param q nome
 * @{ */
double furiko_theta1(double z, double q);
float furiko_theta1f(float z, float q);
void furiko_theta1_v(size_t count, const double z[], const double q[], double theta1[]);
void furiko_theta1_vf(size_t count, const float z[], const float q[], float theta1[]);
/** @} */

/** Jacobi's theta function theta_2.
 *
 * @param z number
 * @param q nome
 * @{ */
double furiko_theta2(double z, double q);
float furiko_theta2f(float z, float q);
void furiko_theta2_v(size_t count, const double z[], const double q[], double theta2[]);
void furiko_theta2_vf(size_t count, const float z[], const float q[], float theta2[]);
/** @} */

/** Jacobi's theta function theta_3.
 *
 * @param z number
 * @param q nome
 * @{ */
double furiko_theta3(double z, double q);
float furiko_theta3f(float z, float q);
void furiko_theta3_v(size_t count, const double z[], const double q[], double theta3[]);
void furiko_theta3_vf(size_t count, const float z[], const float q[], float theta3[]);
/** @} */

/** Jacobi's theta function theta_4.
 *
 * @param z number
 * @param q nome
 * @{ */
double furiko_theta4(double z, double q);
float furiko_theta4f(float z, float q);
void furiko_theta4_v(size_t count, const double z[], const double q[], double theta4[]);
void furiko_theta4_vf(size_t count, const float z[], const float q[], float theta4[]);
/** @} */

/** Derivative of theta1 with respect to z.
 *
 * @param z number
 * @param q nome
 * @{ */
double furiko_theta1_prime(double z, double q);
float furiko_theta1_primef(float z, float q);
void furiko_theta1_prime_v(size_t count, const double z[], const double q[], double theta1_prime[]);
void furiko_theta1_prime_vf(size_t count, const float z[], const float q[], float theta1_prime[]);
/** @} */

/** Derivative of theta2 with respect to z.
 *
 * @param z number
 * @param q nome
 * @{ */
double furiko_theta2_prime(double z, double q);
float furiko_theta2_primef(float z, float q);
void furiko_theta2_prime_v(size_t count, const double z[], const double q[], double theta2_prime[]);
void furiko_theta2_prime_vf(size_t count, const float z[], const float q[], float theta2_prime[]);
/** @} */

/** Derivative of theta3 with respect to z.
 *
 * @param z number
 * @param q nome
 * @{ */
double furiko_theta3_prime(double z, double q);
float furiko_theta3_primef(float z, float q);
void furiko_theta3_prime_v(size_t count, const double z[], const double q[], double theta3_prime[]);
void furiko_theta3_prime_vf(size_t count, const float z[], const float q[], float theta3_prime[]);
/** @} */

/** Derivative of theta4 with respect to z.
 *
 * @param z number
 * @param q nome
 * @{ */
double furiko_theta4_prime(double z, double q);
float furiko_theta4_primef(float z, float q);
void furiko_theta4_prime_v(size_t count, const double z[], const double q[], double theta4_prime[]);
void furiko_theta4_prime_vf(size_t count, const float z[], const float q[], float theta4_prime[]);
/** @} */

/* ---- Jacobi elliptic functions ---- */

/** The Jacobi elliptic functions sn, cn and dn.
 *
 * @param u argument
 * @param k modulus, m = k^2
 * @{ */
void furiko_jacobi_k(double u, double k, double *sn, double *cn, double *dn);
void furiko_jacobi_kf(float u, float k, float *sn, float *cn, float *dn);
void furiko_jacobi_k_v(size_t count, const double u[], const double k[], double sn[], double cn[],
        double dn[]);
void furiko_jacobi_k_vf(size_t count, const float u[], const float k[], float sn[], float cn[], float dn[]);
/** @} */

/** The Jacobi elliptic functions sn, cn and dn.
 *
 * @param u argument
 * @param m parameter, m = k^2
 * @{ */
void furiko_jacobi_m(double u, double m, double *sn, double *cn, double *dn);
void furiko_jacobi_mf(float u, float m, float *sn, float *cn, float *dn);
void furiko_jacobi_m_v(size_t count, const double u[], const double m[], double sn[], double cn[],
        double dn[]);
void furiko_jacobi_m_vf(size_t count, const float u[], const float m[], float sn[], float cn[], float dn[]);
/** @} */

/** The Jacobi elliptic functions sn, cn and dn.
 *
 * @param u argument
 * @param mc complementary parameter 1 - m
 * @{ */
void furiko_jacobi_mc(double u, double mc, double *sn, double *cn, double *dn);
void furiko_jacobi_mcf(float u, float mc, float *sn, float *cn, float *dn);
void furiko_jacobi_mc_v(size_t count, const double u[], const double mc[], double sn[], double cn[],
        double dn[]);
void furiko_jacobi_mc_vf(size_t count, const float u[], const float mc[], float sn[], float cn[], float dn[]);
/** @} */

/** Jacobi's amplitude.
 *
 * @param u argument
 * @param k modulus, m = k^2
 * @{ */
double furiko_jacobi_am_k(double u, double k);
float furiko_jacobi_am_kf(float u, float k);
void furiko_jacobi_am_k_v(size_t count, const double u[], const double k[], double am[]);
void furiko_jacobi_am_k_vf(size_t count, const float u[], const float k[], float am[]);
/** @} */

/** Jacobi's amplitude.
 *
 * @param u argument
 * @param m parameter, m = k^2
 * @{ */
double furiko_jacobi_am_m(double u, double m);
float furiko_jacobi_am_mf(float u, float m);
void furiko_jacobi_am_m_v(size_t count, const double u[], const double m[], double am[]);
void furiko_jacobi_am_m_vf(size_t count, const float u[], const float m[], float am[]);
/** @} */

/** Jacobi's amplitude.
 *
 * @param u argument
 * @param mc complementary parameter 1 - m
 * @{ */
double furiko_jacobi_am_mc(double u, double mc);
float furiko_jacobi_am_mcf(float u, float mc);
void furiko_jacobi_am_mc_v(size_t count, const double u[], const double mc[], double am[]);
void furiko_jacobi_am_mc_vf(size_t count, const float u[], const float mc[], float am[]);
/** @} */

/** Jacobi's sn.
 *
 * @param u argument
 * @param k modulus, m = k^2
 * @{ */
double furiko_jacobi_sn_k(double u, double k);
float furiko_jacobi_sn_kf(float u, float k);
void furiko_jacobi_sn_k_v(size_t count, const double u[], const double k[], double sn[]);
void furiko_jacobi_sn_k_vf(size_t count, const float u[], const float k[], float sn[]);
/** @} */

/** Jacobi's sn.
 *
 * @param u argument
 * @param m parameter, m = k^2
 * @{ */
double furiko_jacobi_sn_m(double u, double m);
float furiko_jacobi_sn_mf(float u, float m);
void furiko_jacobi_sn_m_v(size_t count, const double u[], const double m[], double sn[]);
void furiko_jacobi_sn_m_vf(size_t count, const float u[], const float m[], float sn[]);
/** @} */

/** Jacobi's sn.
 *
 * @param u argument
 * @param mc complementary parameter 1 - m
 * @{ */
double furiko_jacobi_sn_mc(double u, double mc);
float furiko_jacobi_sn_mcf(float u, float mc);
void furiko_jacobi_sn_mc_v(size_t count, const double u[], const double mc[], double sn[]);
void furiko_jacobi_sn_mc_vf(size_t count, const float u[], const float mc[], float sn[]);
/** @} */

/** Jacobi's cn.
 *
 * @param u argument
 * @param k modulus, m = k^2
 * @{ */
double furiko_jacobi_cn_k(double u, double k);
float furiko_jacobi_cn_kf(float u, float k);
void furiko_jacobi_cn_k_v(size_t count, const double u[], const double k[], double cn[]);
void furiko_jacobi_cn_k_vf(size_t count, const float u[], const float k[], float cn[]);
/** @} */

/** Jacobi's cn.
 *
 * @param u argument
 * @param m parameter, m = k^2
 * @{ */
double furiko_jacobi_cn_m(double u, double m);
float furiko_jacobi_cn_mf(float u, float m);
void furiko_jacobi_cn_m_v(size_t count, const double u[], const double m[], double cn[]);
void furiko_jacobi_cn_m_vf(size_t count, const float u[], const float m[], float cn[]);
/** @} */

/** Jacobi's cn.
 *
 * @param u argument
 * @param mc complementary parameter 1 - m
 * @{ */
double furiko_jacobi_cn_mc(double u, double mc);
float furiko_jacobi_cn_mcf(float u, float mc);
void furiko_jacobi_cn_mc_v(size_t count, const double u[], const double mc[], double cn[]);
void furiko_jacobi_cn_mc_vf(size_t count, const float u[], const float mc[], float cn[]);
/** @} */

/** Jacobi's dn.
 *
 * @param u argument
 * @param k modulus, m = k^2
 * @{ */
double furiko_jacobi_dn_k(double u, double k);
float furiko_jacobi_dn_kf(float u, float k);
void furiko_jacobi_dn_k_v(size_t count, const double u[], const double k[], double dn[]);
void furiko_jacobi_dn_k_vf(size_t count, const float u[], const float k[], float dn[]);
/** @} */

/** Jacobi's dn.
 *
 * @param u argument
 * @param m parameter, m = k^2
 * @{ */
double furiko_jacobi_dn_m(double u, double m);
float furiko_jacobi_dn_mf(float u, float m);
void furiko_jacobi_dn_m_v(size_t count, const double u[], const double m[], double dn[]);
void furiko_jacobi_dn_m_vf(size_t count, const float u[], const float m[], float dn[]);
/** @} */

/** Jacobi's dn.
 *
 * @param u argument
 * @param mc complementary parameter 1 - m
 * @{ */
double furiko_jacobi_dn_mc(double u, double mc);
float furiko_jacobi_dn_mcf(float u, float mc);
void furiko_jacobi_dn_mc_v(size_t count, const double u[], const double mc[], double dn[]);
void furiko_jacobi_dn_mc_vf(size_t count, const float u[], const float mc[], float dn[]);
/** @} */

/** Jacobi's ns = 1/sn.
 *
 * @param u argument
 * @param k modulus, m = k^2
 * @{ */
double furiko_jacobi_ns_k(double u, double k);
float furiko_jacobi_ns_kf(float u, float k);
void furiko_jacobi_ns_k_v(size_t count, const double u[], const double k[], double ns[]);
void furiko_jacobi_ns_k_vf(size_t count, const float u[], const float k[], float ns[]);
/** @} */

/** Jacobi's ns = 1/sn.
 *
 * @param u argument
 * @param m parameter, m = k^2
 * @{ */
double furiko_jacobi_ns_m(double u, double m);
float furiko_jacobi_ns_mf(float u, float m);
void furiko_jacobi_ns_m_v(size_t count, const double u[], const double m[], double ns[]);
void furiko_jacobi_ns_m_vf(size_t count, const float u[], const float m[], float ns[]);
/** @} */

/** Jacobi's ns = 1/sn.
 *
 * @param u argument
 * @param mc complementary parameter 1 - m
 * @{ */
double furiko_jacobi_ns_mc(double u, double mc);
float furiko_jacobi_ns_mcf(float u, float mc);
void furiko_jacobi_ns_mc_v(size_t count, const double u[], const double mc[], double ns[]);
void furiko_jacobi_ns_mc_vf(size_t count, const float u[], const float mc[], float ns[]);
/** @} */

/** Jacobi's nc = 1/cn.
 *
 * @param u argument
 * @param k modulus, m = k^2
 * @{ */
double furiko_jacobi_nc_k(double u, double k);
float furiko_jacobi_nc_kf(float u, float k);
void furiko_jacobi_nc_k_v(size_t count, const double u[], const double k[], double nc[]);
void furiko_jacobi_nc_k_vf(size_t count, const float u[], const float k[], float nc[]);
/** @} */

/** Jacobi's nc = 1/cn.
 *
 * @param u argument
 * @param m parameter, m = k^2
 * @{ */
double furiko_jacobi_nc_m(double u, double m);
float furiko_jacobi_nc_mf(float u, float m);
void furiko_jacobi_nc_m_v(size_t count, const double u[], const double m[], double nc[]);
void furiko_jacobi_nc_m_vf(size_t count, const float u[], const float m[], float nc[]);
/** @} */

/** Jacobi's nc = 1/cn.
 *
 * @param u argument
 * @param mc complementary parameter 1 - m
 * @{ */
double furiko_jacobi_nc_mc(double u, double mc);
float furiko_jacobi_nc_mcf(float u, float mc);
void furiko_jacobi_nc_mc_v(size_t count, const double u[], const double mc[], double nc[]);
void furiko_jacobi_nc_mc_vf(size_t count, const float u[], const float mc[], float nc[]);
/** @} */

/** Jacobi's nd = 1/dn.
 *
 * @param u argument
 * @param k modulus, m = k^2
 * @{ */
double furiko_jacobi_nd_k(double u, double k);
float furiko_jacobi_nd_kf(float u, float k);
void furiko_jacobi_nd_k_v(size_t count, const double u[], const double k[], double nd[]);
void furiko_jacobi_nd_k_vf(size_t count, const float u[], const float k[], float nd[]);
/** @} */

/** Jacobi's nd = 1/dn.
 *
 * @param u argument
 * @param m parameter, m = k^2
 * @{ */
double furiko_jacobi_nd_m(double u, double m);
float furiko_jacobi_nd_mf(float u, float m);
void furiko_jacobi_nd_m_v(size_t count, const double u[], const double m[], double nd[]);
void furiko_jacobi_nd_m_vf(size_t count, const float u[], const float m[], float nd[]);
/** @} */

/** Jacobi's nd = 1/dn.
 *
 * @param u argument
 * @param mc complementary parameter 1 - m
 * @{ */
double furiko_jacobi_nd_mc(double u, double mc);
float furiko_jacobi_nd_mcf(float u, float mc);
void furiko_jacobi_nd_mc_v(size_t count, const double u[], const double mc[], double nd[]);
void furiko_jacobi_nd_mc_vf(size_t count, const float u[], const float mc[], float nd[]);
/** @} */

/** Jacobi's sc = sn/cn.
 *
 * @param u argument
 * @param k modulus, m = k^2
 * @{ */
double furiko_jacobi_sc_k(double u, double k);
float furiko_jacobi_sc_kf(float u, float k);
void furiko_jacobi_sc_k_v(size_t count, const double u[], const double k[], double sc[]);
void furiko_jacobi_sc_k_vf(size_t count, const float u[], const float k[], float sc[]);
/** @} */

/** Jacobi's sc = sn/cn.
 *
 * @param u argument
 * @param m parameter, m = k^2
 * @{ */
double furiko_jacobi_sc_m(double u, double m);
float furiko_jacobi_sc_mf(float u, float m);
void furiko_jacobi_sc_m_v(size_t count, const double u[], const double m[], double sc[]);
void furiko_jacobi_sc_m_vf(size_t count, const float u[], const float m[], float sc[]);
/** @} */

/** Jacobi's sc = sn/cn.
 *
 * @param u argument
 * @param mc complementary parameter 1 - m
 * @{ */
double furiko_jacobi_sc_mc(double u, double mc);
float furiko_jacobi_sc_mcf(float u, float mc);
void furiko_jacobi_sc_mc_v(size_t count, const double u[], const double mc[], double sc[]);
void furiko_jacobi_sc_mc_vf(size_t count, const float u[], const float mc[], float sc[]);
/** @} */

/** Jacobi's cs = cn/sn.
 *
 * @param u argument
 * @param k modulus, m = k^2
 * @{ */
double furiko_jacobi_cs_k(double u, double k);
float furiko_jacobi_cs_kf(float u, float k);
void furiko_jacobi_cs_k_v(size_t count, const double u[], const double k[], double cs[]);
void furiko_jacobi_cs_k_vf(size_t count, const float u[], const float k[], float cs[]);
/** @} */

/** Jacobi's cs = cn/sn.
 *
 * @param u argument
 * @param m parameter, m = k^2
 * @{ */
double furiko_jacobi_cs_m(double u, double m);
float furiko_jacobi_cs_mf(float u, float m);
void furiko_jacobi_cs_m_v(size_t count, const double u[], const double m[], double cs[]);
void furiko_jacobi_cs_m_vf(size_t count, const float u[], const float m[], float cs[]);
/** @} */

/** Jacobi's cs = cn/sn.
 *
 * @param u argument
 * @param mc complementary parameter 1 - m
 * @{ */
double furiko_jacobi_cs_mc(double u, double mc);
float furiko_jacobi_cs_mcf(float u, float mc);
void furiko_jacobi_cs_mc_v(size_t count, const double u[], const double mc[], double cs[]);
void furiko_jacobi_cs_mc_vf(size_t count, const float u[], const float mc[], float cs[]);
/** @} */

/** Jacobi's sd = sn/dn.
 *
 * @param u argument
 * @param k modulus, m = k^2
 * @{ */
double furiko_jacobi_sd_k(double u, double k);
float furiko_jacobi_sd_kf(float u, float k);
void furiko_jacobi_sd_k_v(size_t count, const double u[], const double k[], double sd[]);
void furiko_jacobi_sd_k_vf(size_t count, const float u[], const float k[], float sd[]);
/** @} */

/** Jacobi's sd = sn/dn.
 *
 * @param u argument
 * @param m parameter, m = k^2
 * @{ */
double furiko_jacobi_sd_m(double u, double m);
float furiko_jacobi_sd_mf(float u, float m);
void furiko_jacobi_sd_m_v(size_t count, const double u[], const double m[], double sd[]);
void furiko_jacobi_sd_m_vf(size_t count, const float u[], const float m[], float sd[]);
/** @} */

/** Jacobi's sd = sn/dn.
 *
 * @param u argument
 * @param mc complementary parameter 1 - m
 * @{ */
double furiko_jacobi_sd_mc(double u, double mc);
float furiko_jacobi_sd_mcf(float u, float mc);
void furiko_jacobi_sd_mc_v(size_t count, const double u[], const double mc[], double sd[]);
void furiko_jacobi_sd_mc_vf(size_t count, const float u[], const float mc[], float sd[]);
/** @} */

/** Jacobi's ds = dn/sn.
 *
 * @param u argument
 * @param k modulus, m = k^2
 * @{ */
double furiko_jacobi_ds_k(double u, double k);
float furiko_jacobi_ds_kf(float u, float k);
void furiko_jacobi_ds_k_v(size_t count, const double u[], const double k[], double ds[]);
void furiko_jacobi_ds_k_vf(size_t count, const float u[], const float k[], float ds[]);
/** @} */

/** Jacobi's ds = dn/sn.
 *
 * @param u argument
 * @param m parameter, m = k^2
 * @{ */
double furiko_jacobi_ds_m(double u, double m);
float furiko_jacobi_ds_mf(float u, float m);
void furiko_jacobi_ds_m_v(size_t count, const double u[], const double m[], double ds[]);
void furiko_jacobi_ds_m_vf(size_t count, const float u[], const float m[], float ds[]);
/** @} */

/** Jacobi's ds = dn/sn.
 *
 * @param u argument
 * @param mc complementary parameter 1 - m
 * @{ */
double furiko_jacobi_ds_mc(double u, double mc);
float furiko_jacobi_ds_mcf(float u, float mc);
void furiko_jacobi_ds_mc_v(size_t count, const double u[], const double mc[], double ds[]);
void furiko_jacobi_ds_mc_vf(size_t count, const float u[], const float mc[], float ds[]);
/** @} */

/** Jacobi's cd = cn/dn.
 *
 * @param u argument
 * @param k modulus, m = k^2
 * @{ */
double furiko_jacobi_cd_k(double u, double k);
float furiko_jacobi_cd_kf(float u, float k);
void furiko_jacobi_cd_k_v(size_t count, const double u[], const double k[], double cd[]);
void furiko_jacobi_cd_k_vf(size_t count, const float u[], const float k[], float cd[]);
/** @} */

/** Jacobi's cd = cn/dn.
 *
 * @param u argument
 * @param m parameter, m = k^2
 * @{ */
double furiko_jacobi_cd_m(double u, double m);
float furiko_jacobi_cd_mf(float u, float m);
void furiko_jacobi_cd_m_v(size_t count, const double u[], const double m[], double cd[]);
void furiko_jacobi_cd_m_vf(size_t count, const float u[], const float m[], float cd[]);
/** @} */

/** Jacobi's cd = cn/dn.
 *
 * @param u argument
 * @param mc complementary parameter 1 - m
 * @{ */
double furiko_jacobi_cd_mc(double u, double mc);
float furiko_jacobi_cd_mcf(float u, float mc);
void furiko_jacobi_cd_mc_v(size_t count, const double u[], const double mc[], double cd[]);
void furiko_jacobi_cd_mc_vf(size_t count, const float u[], const float mc[], float cd[]);
/** @} */

/** Jacobi's dc = dn/cn.
 *
 * @param u argument
 * @param k modulus, m = k^2
 * @{ */
double furiko_jacobi_dc_k(double u, double k);
float furiko_jacobi_dc_kf(float u, float k);
void furiko_jacobi_dc_k_v(size_t count, const double u[], const double k[], double dc[]);
void furiko_jacobi_dc_k_vf(size_t count, const float u[], const float k[], float dc[]);
/** @} */

/** Jacobi's dc = dn/cn.
 *
 * @param u argument
 * @param m parameter, m = k^2
 * @{ */
double furiko_jacobi_dc_m(double u, double m);
float furiko_jacobi_dc_mf(float u, float m);
void furiko_jacobi_dc_m_v(size_t count, const double u[], const double m[], double dc[]);
void furiko_jacobi_dc_m_vf(size_t count, const float u[], const float m[], float dc[]);
/** @} */

/** Jacobi's dc = dn/cn.
 *
 * @param u argument
 * @param mc complementary parameter 1 - m
 * @{ */
double furiko_jacobi_dc_mc(double u, double mc);
float furiko_jacobi_dc_mcf(float u, float mc);
void furiko_jacobi_dc_mc_v(size_t count, const double u[], const double mc[], double dc[]);
void furiko_jacobi_dc_mc_vf(size_t count, const float u[], const float mc[], float dc[]);
/** @} */

/* ---- Jacobi's epsilon ---- */

/** Jacobi's epsilon.
 *
 * @param u argument
 * @param k modulus, m = k^2
 * @{ */
double furiko_jacobi_epsilon_k(double u, double k);
float furiko_jacobi_epsilon_kf(float u, float k);
void furiko_jacobi_epsilon_k_v(size_t count, const double u[], const double k[], double epsilon[]);
void furiko_jacobi_epsilon_k_vf(size_t count, const float u[], const float k[], float epsilon[]);
/** @} */

/** Jacobi's epsilon.
 *
 * @param u argument
 * @param m parameter, m = k^2
 * @{ */
double furiko_jacobi_epsilon_m(double u, double m);
float furiko_jacobi_epsilon_mf(float u, float m);
void furiko_jacobi_epsilon_m_v(size_t count, const double u[], const double m[], double epsilon[]);
void furiko_jacobi_epsilon_m_vf(size_t count, const float u[], const float m[], float epsilon[]);
/** @} */

/** Jacobi's epsilon.
 *
 * @param u argument
 * @param mc complementary parameter 1 - m
 * @{ */
double furiko_jacobi_epsilon_mc(double u, double mc);
float furiko_jacobi_epsilon_mcf(float u, float mc);
void furiko_jacobi_epsilon_mc_v(size_t count, const double u[], const double mc[], double epsilon[]);
void furiko_jacobi_epsilon_mc_vf(size_t count, const float u[], const float mc[], float epsilon[]);
/** @} */

/* ---- Inverses of Jacobi's functions ---- */

/** The u with sn(u|m) = x.
 *
 * @param x number
 * @param k modulus, m = k^2
 * @{ */
double furiko_jacobi_arcsn_k(double x, double k);
float furiko_jacobi_arcsn_kf(float x, float k);
void furiko_jacobi_arcsn_k_v(size_t count, const double x[], const double k[], double u[]);
void furiko_jacobi_arcsn_k_vf(size_t count, const float x[], const float k[], float u[]);
/** @} */

/** The u with sn(u|m) = x.
 *
 * @param x number
 * @param m parameter, m = k^2
 * @{ */
double furiko_jacobi_arcsn_m(double x, double m);
float furiko_jacobi_arcsn_mf(float x, float m);
void furiko_jacobi_arcsn_m_v(size_t count, const double x[], const double m[], double u[]);
void furiko_jacobi_arcsn_m_vf(size_t count, const float x[], const float m[], float u[]);
/** @} */

/** The u with sn(u|m) = x.
 *
 * @param x number
 * @param mc complementary parameter 1 - m
 * @{ */
double furiko_jacobi_arcsn_mc(double x, double mc);
float furiko_jacobi_arcsn_mcf(float x, float mc);
void furiko_jacobi_arcsn_mc_v(size_t count, const double x[], const double mc[], double u[]);
void furiko_jacobi_arcsn_mc_vf(size_t count, const float x[], const float mc[], float u[]);
/** @} */

/** The u with cn(u|m) = x.
 *
 * @param x number
 * @param k modulus, m = k^2
 * @{ */
double furiko_jacobi_arccn_k(double x, double k);
float furiko_jacobi_arccn_kf(float x, float k);
void furiko_jacobi_arccn_k_v(size_t count, const double x[], const double k[], double u[]);
void furiko_jacobi_arccn_k_vf(size_t count, const float x[], const float k[], float u[]);
/** @} */

/** The u with cn(u|m) = x.
 *
 * @param x number
 * @param m parameter, m = k^2
 * @{ */
double furiko_jacobi_arccn_m(double x, double m);
float furiko_jacobi_arccn_mf(float x, float m);
void furiko_jacobi_arccn_m_v(size_t count, const double x[], const double m[], double u[]);
void furiko_jacobi_arccn_m_vf(size_t count, const float x[], const float m[], float u[]);
/** @} */

/** The u with cn(u|m) = x.
 *
 * @param x number
 * @param mc complementary parameter 1 - m
 * @{ */
double furiko_jacobi_arccn_mc(double x, double mc);
float furiko_jacobi_arccn_mcf(float x, float mc);
void furiko_jacobi_arccn_mc_v(size_t count, const double x[], const double mc[], double u[]);
void furiko_jacobi_arccn_mc_vf(size_t count, const float x[], const float mc[], float u[]);
/** @} */

/** The u with dn(u|m) = x.
 *
 * @param x number
 * @param k modulus, m = k^2
 * @{ */
double furiko_jacobi_arcdn_k(double x, double k);
float furiko_jacobi_arcdn_kf(float x, float k);
void furiko_jacobi_arcdn_k_v(size_t count, const double x[], const double k[], double u[]);
void furiko_jacobi_arcdn_k_vf(size_t count, const float x[], const float k[], float u[]);
/** @} */

/** The u with dn(u|m) = x.
 *
 * @param x number
 * @param m parameter, m = k^2
 * @{ */
double furiko_jacobi_arcdn_m(double x, double m);
float furiko_jacobi_arcdn_mf(float x, float m);
void furiko_jacobi_arcdn_m_v(size_t count, const double x[], const double m[], double u[]);
void furiko_jacobi_arcdn_m_vf(size_t count, const float x[], const float m[], float u[]);
/** @} */

/** The u with dn(u|m) = x.
 *
 * @param x number
 * @param mc complementary parameter 1 - m
 * @{ */
double furiko_jacobi_arcdn_mc(double x, double mc);
float furiko_jacobi_arcdn_mcf(float x, float mc);
void furiko_jacobi_arcdn_mc_v(size_t count, const double x[], const double mc[], double u[]);
void furiko_jacobi_arcdn_mc_vf(size_t count, const float x[], const float mc[], float u[]);
/** @} */

/** The u with ns(u|m) = x.
 *
 * @param x number
 * @param k modulus, m = k^2
 * @{ */
double furiko_jacobi_arcns_k(double x, double k);
float furiko_jacobi_arcns_kf(float x, float k);
void furiko_jacobi_arcns_k_v(size_t count, const double x[], const double k[], double u[]);
void furiko_jacobi_arcns_k_vf(size_t count, const float x[], const float k[], float u[]);
/** @} */

/** The u with ns(u|m) = x.
 *
 * @param x number
 * @param m parameter, m = k^2
 * @{ */
double furiko_jacobi_arcns_m(double x, double m);
float furiko_jacobi_arcns_mf(float x, float m);
void furiko_jacobi_arcns_m_v(size_t count, const double x[], const double m[], double u[]);
void furiko_jacobi_arcns_m_vf(size_t count, const float x[], const float m[], float u[]);
/** @} */

/** The u with ns(u|m) = x.
 *
 * @param x number
 * @param mc complementary parameter 1 - m
 * @{ */
double furiko_jacobi_arcns_mc(double x, double mc);
float furiko_jacobi_arcns_mcf(float x, float mc);
void furiko_jacobi_arcns_mc_v(size_t count, const double x[], const double mc[], double u[]);
void furiko_jacobi_arcns_mc_vf(size_t count, const float x[], const float mc[], float u[]);
/** @} */

/** The u with nc(u|m) = x.
 *
 * @param x number
 * @param k modulus, m = k^2
 * @{ */
double furiko_jacobi_arcnc_k(double x, double k);
float furiko_jacobi_arcnc_kf(float x, float k);
void furiko_jacobi_arcnc_k_v(size_t count, const double x[], const double k[], double u[]);
void furiko_jacobi_arcnc_k_vf(size_t count, const float x[], const float k[], float u[]);
/** @} */

/** The u with nc(u|m) = x.
 *
 * @param x number
 * @param m parameter, m = k^2
 * @{ */
double furiko_jacobi_arcnc_m(double x, double m);
float furiko_jacobi_arcnc_mf(float x, float m);
void furiko_jacobi_arcnc_m_v(size_t count, const double x[], const double m[], double u[]);
void furiko_jacobi_arcnc_m_vf(size_t count, const float x[], const float m[], float u[]);
/** @} */

/** The u with nc(u|m) = x.
 *
 * @param x number
 * @param mc complementary parameter 1 - m
 * @{ */
double furiko_jacobi_arcnc_mc(double x, double mc);
float furiko_jacobi_arcnc_mcf(float x, float mc);
void furiko_jacobi_arcnc_mc_v(size_t count, const double x[], const double mc[], double u[]);
void furiko_jacobi_arcnc_mc_vf(size_t count, const float x[], const float mc[], float u[]);
/** @} */

/** The u with nd(u|m) = x.
 *
 * @param x number
 * @param k modulus, m = k^2
 * @{ */
double furiko_jacobi_arcnd_k(double x, double k);
float furiko_jacobi_arcnd_kf(float x, float k);
void furiko_jacobi_arcnd_k_v(size_t count, const double x[], const double k[], double u[]);
void furiko_jacobi_arcnd_k_vf(size_t count, const float x[], const float k[], float u[]);
/** @} */

/** The u with nd(u|m) = x.
 *
 * @param x number
 * @param m parameter, m = k^2
 * @{ */
double furiko_jacobi_arcnd_m(double x, double m);
float furiko_jacobi_arcnd_mf(float x, float m);
void furiko_jacobi_arcnd_m_v(size_t count, const double x[], const double m[], double u[]);
void furiko_jacobi_arcnd_m_vf(size_t count, const float x[], const float m[], float u[]);
/** @} */

/** The u with nd(u|m) = x.
 *
 * @param x number
 * @param mc complementary parameter 1 - m
 * @{ */
double furiko_jacobi_arcnd_mc(double x, double mc);
float furiko_jacobi_arcnd_mcf(float x, float mc);
void furiko_jacobi_arcnd_mc_v(size_t count, const double x[], const double mc[], double u[]);
void furiko_jacobi_arcnd_mc_vf(size_t count, const float x[], const float mc[], float u[]);
/** @} */

/** The u with sc(u|m) = x.
 *
 * @param x number
 * @param k modulus, m = k^2
 * @{ */
double furiko_jacobi_arcsc_k(double x, double k);
float furiko_jacobi_arcsc_kf(float x, float k);
void furiko_jacobi_arcsc_k_v(size_t count, const double x[], const double k[], double u[]);
void furiko_jacobi_arcsc_k_vf(size_t count, const float x[], const float k[], float u[]);
/** @} */

/** The u with sc(u|m) = x.
 *
 * @param x number
 * @param m parameter, m = k^2
 * @{ */
double furiko_jacobi_arcsc_m(double x, double m);
float furiko_jacobi_arcsc_mf(float x, float m);
void furiko_jacobi_arcsc_m_v(size_t count, const double x[], const double m[], double u[]);
void furiko_jacobi_arcsc_m_vf(size_t count, const float x[], const float m[], float u[]);
/** @} */

/** The u with sc(u|m) = x.
 *
 * @param x number
 * @param mc complementary parameter 1 - m
 * @{ */
double furiko_jacobi_arcsc_mc(double x, double mc);
float furiko_jacobi_arcsc_mcf(float x, float mc);
void furiko_jacobi_arcsc_mc_v(size_t count, const double x[], const double mc[], double u[]);
void furiko_jacobi_arcsc_mc_vf(size_t count, const float x[], const float mc[], float u[]);
/** @} */

/** The u with cs(u|m) = x.
 *
 * @param x number
 * @param k modulus, m = k^2
 * @{ */
double furiko_jacobi_arccs_k(double x, double k);
float furiko_jacobi_arccs_kf(float x, float k);
void furiko_jacobi_arccs_k_v(size_t count, const double x[], const double k[], double u[]);
void furiko_jacobi_arccs_k_vf(size_t count, const float x[], const float k[], float u[]);
/** @} */

/** The u with cs(u|m) = x.
 *
 * @param x number
 * @param m parameter, m = k^2
 * @{ */
double furiko_jacobi_arccs_m(double x, double m);
float furiko_jacobi_arccs_mf(float x, float m);
void furiko_jacobi_arccs_m_v(size_t count, const double x[], const double m[], double u[]);
void furiko_jacobi_arccs_m_vf(size_t count, const float x[], const float m[], float u[]);
/** @} */

/** The u with cs(u|m) = x.
 *
 * @param x number
 * @param mc complementary parameter 1 - m
 * @{ */
double furiko_jacobi_arccs_mc(double x, double mc);
float furiko_jacobi_arccs_mcf(float x, float mc);
void furiko_jacobi_arccs_mc_v(size_t count, const double x[], const double mc[], double u[]);
void furiko_jacobi_arccs_mc_vf(size_t count, const float x[], const float mc[], float u[]);
/** @} */

/** The u with sd(u|m) = x.
 *
 * @param x number
 * @param k modulus, m = k^2
 * @{ */
double furiko_jacobi_arcsd_k(double x, double k);
float furiko_jacobi_arcsd_kf(float x, float k);
void furiko_jacobi_arcsd_k_v(size_t count, const double x[], const double k[], double u[]);
void furiko_jacobi_arcsd_k_vf(size_t count, const float x[], const float k[], float u[]);
/** @} */

/** The u with sd(u|m) = x.
 *
 * @param x number
 * @param m parameter, m = k^2
 * @{ */
double furiko_jacobi_arcsd_m(double x, double m);
float furiko_jacobi_arcsd_mf(float x, float m);
void furiko_jacobi_arcsd_m_v(size_t count, const double x[], const double m[], double u[]);
void furiko_jacobi_arcsd_m_vf(size_t count, const float x[], const float m[], float u[]);
/** @} */

/** The u with sd(u|m) = x.
 *
 * @param x number
 * @param mc complementary parameter 1 - m
 * @{ */
double furiko_jacobi_arcsd_mc(double x, double mc);
float furiko_jacobi_arcsd_mcf(float x, float mc);
void furiko_jacobi_arcsd_mc_v(size_t count, const double x[], const double mc[], double u[]);
void furiko_jacobi_arcsd_mc_vf(size_t count, const float x[], const float mc[], float u[]);
/** @} */

/** The u with ds(u|m) = x.
 *
 * @param x number
 * @param k modulus, m = k^2
 * @{ */
double furiko_jacobi_arcds_k(double x, double k);
float furiko_jacobi_arcds_kf(float x, float k);
void furiko_jacobi_arcds_k_v(size_t count, const double x[], const double k[], double u[]);
void furiko_jacobi_arcds_k_vf(size_t count, const float x[], const float k[], float u[]);
/** @} */

/** The u with ds(u|m) = x.
 *
 * @param x number
 * @param m parameter, m = k^2
 * @{ */
double furiko_jacobi_arcds_m(double x, double m);
float furiko_jacobi_arcds_mf(float x, float m);
void furiko_jacobi_arcds_m_v(size_t count, const double x[], const double m[], double u[]);
void furiko_jacobi_arcds_m_vf(size_t count, const float x[], const float m[], float u[]);
/** @} */

/** The u with ds(u|m) = x.
 *
 * @param x number
 * @param mc complementary parameter 1 - m
 * @{ */
double furiko_jacobi_arcds_mc(double x, double mc);
float furiko_jacobi_arcds_mcf(float x, float mc);
void furiko_jacobi_arcds_mc_v(size_t count, const double x[], const double mc[], double u[]);
void furiko_jacobi_arcds_mc_vf(size_t count, const float x[], const float mc[], float u[]);
/** @} */

/** The u with cd(u|m) = x.
 *
 * @param x number
 * @param k modulus, m = k^2
 * @{ */
double furiko_jacobi_arccd_k(double x, double k);
float furiko_jacobi_arccd_kf(float x, float k);
void furiko_jacobi_arccd_k_v(size_t count, const double x[], const double k[], double u[]);
void furiko_jacobi_arccd_k_vf(size_t count, const float x[], const float k[], float u[]);
/** @} */

/** The u with cd(u|m) = x.
 *
 * @param x number
 * @param m parameter, m = k^2
 * @{ */
double furiko_jacobi_arccd_m(double x, double m);
float furiko_jacobi_arccd_mf(float x, float m);
void furiko_jacobi_arccd_m_v(size_t count, const double x[], const double m[], double u[]);
void furiko_jacobi_arccd_m_vf(size_t count, const float x[], const float m[], float u[]);
/** @} */

/** The u with cd(u|m) = x.
 *
 * @param x number
 * @param mc complementary parameter 1 - m
 * @{ */
double furiko_jacobi_arccd_mc(double x, double mc);
float furiko_jacobi_arccd_mcf(float x, float mc);
void furiko_jacobi_arccd_mc_v(size_t count, const double x[], const double mc[], double u[]);
void furiko_jacobi_arccd_mc_vf(size_t count, const float x[], const float mc[], float u[]);
/** @} */

/** The u with dc(u|m) = x.
 *
 * @param x number
 * @param k modulus, m = k^2
 * @{ */
double furiko_jacobi_arcdc_k(double x, double k);
float furiko_jacobi_arcdc_kf(float x, float k);
void furiko_jacobi_arcdc_k_v(size_t count, const double x[], const double k[], double u[]);
void furiko_jacobi_arcdc_k_vf(size_t count, const float x[], const float k[], float u[]);
/** @} */

/** The u with dc(u|m) = x.
 *
 * @param x number
 * @param m parameter, m = k^2
 * @{ */
double furiko_jacobi_arcdc_m(double x, double m);
float furiko_jacobi_arcdc_mf(float x, float m);
void furiko_jacobi_arcdc_m_v(size_t count, const double x[], const double m[], double u[]);
void furiko_jacobi_arcdc_m_vf(size_t count, const float x[], const float m[], float u[]);
/** @} */

/** The u with dc(u|m) = x.
 *
 * @param x number
 * @param mc complementary parameter 1 - m
 * @{ */
double furiko_jacobi_arcdc_mc(double x, double mc);
float furiko_jacobi_arcdc_mcf(float x, float mc);
void furiko_jacobi_arcdc_mc_v(size_t count, const double x[], const double mc[], double u[]);
void furiko_jacobi_arcdc_mc_vf(size_t count, const float x[], const float mc[], float u[]);
/** @} */

/* ---- Inverses of K and of the period ---- */

/** The parameter m with K(m) = k.
 *
 * @param big_k K, complete integral of the first kind
 * @{ */
double furiko_parameter_from_ellipk(double big_k);
float furiko_parameter_from_ellipkf(float big_k);
void furiko_parameter_from_ellipk_v(size_t count, const double big_k[], double m[]);
void furiko_parameter_from_ellipk_vf(size_t count, const float big_k[], float m[]);
/** @} */

/** The complementary parameter mc = 1 - m with K(m) = k.
 *
 * @param big_k K, complete integral of the first kind
 * @{ */
double furiko_complementary_parameter_from_ellipk(double big_k);
float furiko_complementary_parameter_from_ellipkf(float big_k);
void furiko_complementary_parameter_from_ellipk_v(size_t count, const double big_k[], double mc[]);
void furiko_complementary_parameter_from_ellipk_vf(size_t count, const float big_k[], float mc[]);
/** @} */

/** The parameter m of a pendulum of this period ratio T/T_h.
 *
 * @param ratio T/T_h, period over that of small swings
 * @{ */
double furiko_parameter_from_period_ratio(double ratio);
float furiko_parameter_from_period_ratiof(float ratio);
void furiko_parameter_from_period_ratio_v(size_t count, const double ratio[], double m[]);
void furiko_parameter_from_period_ratio_vf(size_t count, const float ratio[], float m[]);
/** @} */

/** The complementary parameter mc = 1 - m of this period ratio T/T_h.
 *
 * @param ratio T/T_h, period over that of small swings
 * @{ */
double furiko_complementary_parameter_from_period_ratio(double ratio);
float furiko_complementary_parameter_from_period_ratiof(float ratio);
void furiko_complementary_parameter_from_period_ratio_v(size_t count, const double ratio[], double mc[]);
void furiko_complementary_parameter_from_period_ratio_vf(size_t count, const float ratio[], float mc[]);
/** @} */

/* ---- The inverse of E(phi) ---- */

/** The angle phi with E(phi|m) = s.
 *
 * @param s E(phi), incomplete integral of the second kind
 * @param k modulus, m = k^2
 * @{ */
double furiko_ellipeinc_inverse_k(double s, double k);
float furiko_ellipeinc_inverse_kf(float s, float k);
void furiko_ellipeinc_inverse_k_v(size_t count, const double s[], const double k[], double phi[]);
void furiko_ellipeinc_inverse_k_vf(size_t count, const float s[], const float k[], float phi[]);
/** @} */

/** The angle phi with E(phi|m) = s.
 *
 * @param s E(phi), incomplete integral of the second kind
 * @param m parameter, m = k^2
 * @{ */
double furiko_ellipeinc_inverse_m(double s, double m);
float furiko_ellipeinc_inverse_mf(float s, float m);
void furiko_ellipeinc_inverse_m_v(size_t count, const double s[], const double m[], double phi[]);
void furiko_ellipeinc_inverse_m_vf(size_t count, const float s[], const float m[], float phi[]);
/** @} */

/** The angle phi with E(phi|m) = s.
 *
 * @param s E(phi), incomplete integral of the second kind
 * @param mc complementary parameter 1 - m
 * @{ */
double furiko_ellipeinc_inverse_mc(double s, double mc);
float furiko_ellipeinc_inverse_mcf(float s, float mc);
void furiko_ellipeinc_inverse_mc_v(size_t count, const double s[], const double mc[], double phi[]);
void furiko_ellipeinc_inverse_mc_vf(size_t count, const float s[], const float mc[], float phi[]);
/** @} */

/* ---- Jacobi's zeta, Heuman's lambda ---- */

/** Jacobi's zeta function.
 *
 * @param phi angle in radians
 * @param k modulus, m = k^2
 * @{ */
double furiko_jacobi_zeta_k(double phi, double k);
float furiko_jacobi_zeta_kf(float phi, float k);
void furiko_jacobi_zeta_k_v(size_t count, const double phi[], const double k[], double z[]);
void furiko_jacobi_zeta_k_vf(size_t count, const float phi[], const float k[], float z[]);
/** @} */

/** Jacobi's zeta function.
 *
 * @param phi angle in radians
 * @param m parameter, m = k^2
 * @{ */
double furiko_jacobi_zeta_m(double phi, double m);
float furiko_jacobi_zeta_mf(float phi, float m);
void furiko_jacobi_zeta_m_v(size_t count, const double phi[], const double m[], double z[]);
void furiko_jacobi_zeta_m_vf(size_t count, const float phi[], const float m[], float z[]);
/** @} */

/** Jacobi's zeta function.
 *
 * @param phi angle in radians
 * @param mc complementary parameter 1 - m
 * @{ */
double furiko_jacobi_zeta_mc(double phi, double mc);
float furiko_jacobi_zeta_mcf(float phi, float mc);
void furiko_jacobi_zeta_mc_v(size_t count, const double phi[], const double mc[], double z[]);
void furiko_jacobi_zeta_mc_vf(size_t count, const float phi[], const float mc[], float z[]);
/** @} */

/** Heuman's lambda function.
 *
 * @param phi angle in radians
 * @param k modulus, m = k^2
 * @{ */
double furiko_heuman_lambda_k(double phi, double k);
float furiko_heuman_lambda_kf(float phi, float k);
void furiko_heuman_lambda_k_v(size_t count, const double phi[], const double k[], double lambda[]);
void furiko_heuman_lambda_k_vf(size_t count, const float phi[], const float k[], float lambda[]);
/** @} */

/** Heuman's lambda function.
 *
 * @param phi angle in radians
 * @param m parameter, m = k^2
 * @{ */
double furiko_heuman_lambda_m(double phi, double m);
float furiko_heuman_lambda_mf(float phi, float m);
void furiko_heuman_lambda_m_v(size_t count, const double phi[], const double m[], double lambda[]);
void furiko_heuman_lambda_m_vf(size_t count, const float phi[], const float m[], float lambda[]);
/** @} */

/** Heuman's lambda function.
 *
 * @param phi angle in radians
 * @param mc complementary parameter 1 - m
 * @{ */
double furiko_heuman_lambda_mc(double phi, double mc);
float furiko_heuman_lambda_mcf(float phi, float mc);
void furiko_heuman_lambda_mc_v(size_t count, const double phi[], const double mc[], double lambda[]);
void furiko_heuman_lambda_mc_vf(size_t count, const float phi[], const float mc[], float lambda[]);
/** @} */

/* ---- The pendulum's period ---- */

/** The period T of a pendulum over that of its small swings.
 *
 * @param amplitude of the swing, in radians
 * @{ */
double furiko_period_ratio(double amplitude);
float furiko_period_ratiof(float amplitude);
void furiko_period_ratio_v(size_t count, const double amplitude[], double ratio[]);
void furiko_period_ratio_vf(size_t count, const float amplitude[], float ratio[]);
/** @} */

/** By how much a pendulum's period exceeds that of small swings.
 *
 * @param amplitude of the swing, in radians
 * @{ */
double furiko_period_excess(double amplitude);
float furiko_period_excessf(float amplitude);
void furiko_period_excess_v(size_t count, const double amplitude[], double excess[]);
void furiko_period_excess_vf(size_t count, const float amplitude[], float excess[]);
/** @} */

/** The amplitude of a pendulum of this period ratio T/T_h.
 *
 * @param ratio T/T_h, period over that of small swings
 * @{ */
double furiko_amplitude_of_period(double ratio);
float furiko_amplitude_of_periodf(float ratio);
void furiko_amplitude_of_period_v(size_t count, const double ratio[], double theta_0[]);
void furiko_amplitude_of_period_vf(size_t count, const float ratio[], float theta_0[]);
/** @} */

/** The amplitude of a pendulum of this excess T/T_h - 1.
 *
 * @param excess T/T_h - 1
 * @{ */
double furiko_amplitude_of_excess(double excess);
float furiko_amplitude_of_excessf(float excess);
void furiko_amplitude_of_excess_v(size_t count, const double excess[], double theta_0[]);
void furiko_amplitude_of_excess_vf(size_t count, const float excess[], float theta_0[]);
/** @} */

/* ---- The pendulum's period by its series ---- */

/** The amplitude of a pendulum of this excess by three terms.
 *
 * @param excess T/T_h - 1
 * @{ */
double furiko_amplitude_three_terms(double excess);
float furiko_amplitude_three_termsf(float excess);
void furiko_amplitude_three_terms_v(size_t count, const double excess[], double theta_0[]);
void furiko_amplitude_three_terms_vf(size_t count, const float excess[], float theta_0[]);
/** @} */

/* ---- The ellipse ---- */

/** The perimeter of an ellipse of semiaxes a and b, in any order.
 *
 * @param a semiaxis
 * @param b semiaxis
 * @{ */
double furiko_ellipse_perimeter(double a, double b);
float furiko_ellipse_perimeterf(float a, float b);
void furiko_ellipse_perimeter_v(size_t count, const double a[], const double b[], double l[]);
void furiko_ellipse_perimeter_vf(size_t count, const float a[], const float b[], float l[]);
/** @} */

/* ---- One modulus, many arguments ---- */

/** A modulus made ready for many arguments, in your storage: copy it, put it on the stack, share it among threads;
 * nothing is to be freed. One of the functions `furiko_modulus_from_...` makes it; before, all it says is NaN (but give
 * it a value first: `furiko_modulus p = {{0}}`). What is in it is of this version of the library. */
typedef struct furiko_modulus {
    double opaque[64];
} furiko_modulus;

/** sizeof(furiko_modulus) of the library. Equal sizes are not equal versions: compare furiko_version(). */
size_t furiko_modulus_size(void);

/** Any finite number; infinity and NaN make a modulus that says NaN.
 *
 * @param k modulus
 * @param m parameter, m = k^2
 * @param mc complementary parameter 1 - m
 * @param alpha modular angle in radians, k = sin(alpha), |alpha| <= pi/2
 * @param amplitude of a pendulum's swing in radians, k = sin(amplitude/2), |amplitude| <= pi
 * @{ */
void furiko_modulus_from_k(furiko_modulus *self, double k);
void furiko_modulus_from_m(furiko_modulus *self, double m);
void furiko_modulus_from_mc(furiko_modulus *self, double mc);
void furiko_modulus_from_alpha(furiko_modulus *self, double alpha);
void furiko_modulus_from_amplitude(furiko_modulus *self, double amplitude);
/** @} */
/** The modulus of 1 - m */
void furiko_modulus_complement(const furiko_modulus *self, furiko_modulus *complement);

/** The modulus k (NaN for m < 0), the parameter m, 1 - m; K(m) and E(m) (NaN for m > 1); the real quarter period,
 * K(m), for m > 1 K(1/m)/k; the nome, negative for m < 0, NaN for m > 1. @{ */
double furiko_modulus_k(const furiko_modulus *self);
double furiko_modulus_m(const furiko_modulus *self);
double furiko_modulus_mc(const furiko_modulus *self);
double furiko_modulus_ellipk(const furiko_modulus *self);
double furiko_modulus_ellipe(const furiko_modulus *self);
double furiko_modulus_quarter_period(const furiko_modulus *self);
double furiko_modulus_nome(const furiko_modulus *self);
/** @} */

/** sn, cn and dn of u; the amplitude, continuous in u; Jacobi's epsilon, the integral of dn^2 from 0 to u. @{ */
void furiko_modulus_jacobi(const furiko_modulus *self, double u, double *sn, double *cn, double *dn);
void furiko_modulus_jacobi_v(const furiko_modulus *self, size_t count, const double u[], double sn[], double cn[],
        double dn[]);
double furiko_modulus_am(const furiko_modulus *self, double u);
void furiko_modulus_am_v(const furiko_modulus *self, size_t count, const double u[], double am[]);
double furiko_modulus_epsilon(const furiko_modulus *self, double u);
void furiko_modulus_epsilon_v(const furiko_modulus *self, size_t count, const double u[], double epsilon[]);
/** @} */

/* ---- The pendulum's exact motion ---- */

/** A motion of a pendulum without friction, in your storage, as furiko_modulus. Length in metres, gravity in metres
 * per square second, both above 0; time in seconds, angles in radians from the bottom, beyond pi in rotation. */
typedef struct furiko_motion {
    double opaque[96];
} furiko_motion;

/** sizeof(furiko_motion) of the library. Equal sizes are not equal versions: compare furiko_version(). */
size_t furiko_motion_size(void);

/** At rest at an angle at the time 0. */
void furiko_motion_released(furiko_motion *self, double length, double gravity, double angle);
/** Through the bottom at the time 0, up to an amplitude; a negative one swings to the other side first. */
void furiko_motion_swinging(furiko_motion *self, double length, double gravity, double amplitude);
/** Any angle and any rate, radians per second, at the time 0. */
void furiko_motion_started(furiko_motion *self, double length, double gravity, double angle, double rate);

/** 1 where it swings to and fro, or else 0. */
int furiko_motion_is_libration(const furiko_motion *self);
/** 1 where it goes over the top, or else 0. */
int furiko_motion_is_rotation(const furiko_motion *self);
/** Of a full swing to and fro, or of a full turn, seconds; infinite in between. */
double furiko_motion_period(const furiko_motion *self);
/** The largest angle, radians; infinite in rotation. */
double furiko_motion_amplitude(const furiko_motion *self);
/** rate^2/2 - g/l cos(angle), s^-2. */
double furiko_motion_energy(const furiko_motion *self);

/** At a time: the angle, radians; its rate, radians per second; the pull of the rod as a
 * multiple of the weight, negative where the rod pushes. @{ */
double furiko_motion_angle(const furiko_motion *self, double time);
void furiko_motion_angle_v(const furiko_motion *self, size_t count, const double time[], double angle[]);
double furiko_motion_rate(const furiko_motion *self, double time);
void furiko_motion_rate_v(const furiko_motion *self, size_t count, const double time[], double rate[]);
double furiko_motion_tension(const furiko_motion *self, double time);
void furiko_motion_tension_v(const furiko_motion *self, size_t count, const double time[], double tension[]);
/** @} */
/** The angle of the small-angle motion from the same state, radians. */
double furiko_motion_harmonic_angle(const furiko_motion *self, double time);
/** The part of a period since the bottom was passed in the direction of the start, from 0 up to 1. */
double furiko_motion_phase(const furiko_motion *self, double time);
/** When the angle is reached first, seconds from the time 0 on; NaN if never. */
double furiko_motion_time_to(const furiko_motion *self, double angle);
/** The angle at which a string would go slack first; NaN if never. */
double furiko_motion_slack_angle(const furiko_motion *self);

/* ---- Equations of motion step by step ---- */

/** Steps of many pendulums, angle'' = -omega2 sin(angle), of equal size h (below 0: backwards); with steps <= 0
 * nothing is done. Runge-Kutta's, Verlet's and Forest and Ruth's. Each pendulum has an omega2 = g/l of its own.
 *
 * @param angle radians, before and after
 * @param rate before and after
 * @{ */
void furiko_pendulum_rk4(size_t count, const double omega2[], double h, int steps, double angle[], double rate[]);
void furiko_pendulum_rk4f(size_t count, const float omega2[], float h, int steps, float angle[], float rate[]);
void furiko_pendulum_verlet(size_t count, const double omega2[], double h, int steps, double angle[],
        double rate[]);
void furiko_pendulum_verletf(size_t count, const float omega2[], float h, int steps, float angle[],
        float rate[]);
void furiko_pendulum_forest_ruth(size_t count, const double omega2[], double h, int steps, double angle[],
        double rate[]);
void furiko_pendulum_forest_ruthf(size_t count, const float omega2[], float h, int steps, float angle[],
        float rate[]);
/** @} */

/** The same of pendulums with the same omega2, side by side: some times as fast. @{ */
void furiko_pendulum_rk4_same(size_t count, double omega2, double h, int steps, double angle[], double rate[]);
void furiko_pendulum_rk4_samef(size_t count, float omega2, float h, int steps, float angle[], float rate[]);
void furiko_pendulum_verlet_same(size_t count, double omega2, double h, int steps, double angle[], double rate[]);
void furiko_pendulum_verlet_samef(size_t count, float omega2, float h, int steps, float angle[], float rate[]);
void furiko_pendulum_forest_ruth_same(size_t count, double omega2, double h, int steps, double angle[],
        double rate[]);
void furiko_pendulum_forest_ruth_samef(size_t count, float omega2, float h, int steps, float angle[],
        float rate[]);
/** @} */

/** The right-hand side of y' = f(t, y): writes y' into `dy`; `context` is what was given to furiko_rk4. It returns
 * (no longjmp, no exception of C++ out of it). */
typedef void (*furiko_rates)(double t, const double y[], double dy[], void *context);
typedef void (*furiko_ratesf)(float t, const float y[], float dy[], void *context);

/** Runge-Kutta steps of any system of `count` equations; with steps <= 0 nothing is done.
 *
 * @param t0 time of the given state
 * @param h size of a step, may be below 0
 * @param y state, before and after
 * @{ */
void furiko_rk4(furiko_rates f, void *context, size_t count, double t0, double h, int steps, double y[]);
void furiko_rk4f(furiko_ratesf f, void *context, size_t count, float t0, float h, int steps, float y[]);
/** @} */

/** The right-hand side of x'' = a(x): writes x'' into `a`; as furiko_rates. */
typedef void (*furiko_acceleration)(const double x[], double a[], void *context);
typedef void (*furiko_accelerationf)(const float x[], float a[], void *context);

/** Verlet's and Forest and Ruth's steps of any system of `count` coordinates; with steps <= 0 nothing is done.
 *
 * @param h size of a step, may be below 0
 * @param x coordinates, before and after
 * @param v velocities, before and after
 * @{ */
void furiko_verlet(furiko_acceleration f, void *context, size_t count, double h, int steps, double x[], double v[]);
void furiko_verletf(furiko_accelerationf f, void *context, size_t count, float h, int steps, float x[], float v[]);
void furiko_forest_ruth(furiko_acceleration f, void *context, size_t count, double h, int steps, double x[],
        double v[]);
void furiko_forest_ruthf(furiko_accelerationf f, void *context, size_t count, float h, int steps, float x[],
        float v[]);
/** @} */

#ifdef __cplusplus
}
#endif

#endif
