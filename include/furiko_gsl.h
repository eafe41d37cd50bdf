/* SPDX-License-Identifier: MIT */
/**
 * @file furiko_gsl.h
 * GSL's elliptic functions under GSL's names, computed by furiko: gsl_sf_ellint_*, gsl_sf_elljac_e. To be included behind
 * GSL's own headers, or without them; linked is furiko in place of GSL. Needs C99 or C++11.
 *
 * Otherwise than GSL: the mode is not looked at, numbers are always right to some units in the last place; where GSL
 * refuses and furiko has a value (m < 0 or m > 1 of elljac, k >= 1 where the integral is real), there is that value. No
 * error handler is called: where there is no value it is NaN, at a pole infinite, and GSL_EDOM is returned. n has GSL's
 * sign, the opposite of furiko's. `err` is 4 epsilon times the value.
 */
#ifndef FURIKO_GSL_H
#define FURIKO_GSL_H

#include <float.h>
#include <math.h>

#include "furiko.h"

#ifndef __GSL_MODE_H__
typedef unsigned int gsl_mode_t;
#define GSL_PREC_DOUBLE 0
#define GSL_PREC_SINGLE 1
#define GSL_PREC_APPROX 2
#define GSL_MODE_DEFAULT 0
#endif
#ifndef __GSL_SF_RESULT_H__
typedef struct gsl_sf_result_struct {
    double val;
    double err;
} gsl_sf_result;
#endif
#ifndef __GSL_ERRNO_H__
enum { GSL_SUCCESS = 0, GSL_EDOM = 1 };
#endif

static inline int furiko_gsl_result(double value, gsl_sf_result *result)
{
    result->val = value;
    result->err = 4*DBL_EPSILON*fabs(value);
    return isfinite(value) ? GSL_SUCCESS : GSL_EDOM;
}

/* A function of furiko's value and its arguments, and its twin with an error */
#define FURIKO_GSL(name, value, ...) \
    static inline double furiko_gsl_##name(__VA_ARGS__, gsl_mode_t mode) { (void)mode; return value; } \
    static inline int furiko_gsl_##name##_e(__VA_ARGS__, gsl_mode_t mode, gsl_sf_result *result) \
    { (void)mode; return furiko_gsl_result(value, result); }
FURIKO_GSL(Kcomp, furiko_ellipk_k(k), double k)
FURIKO_GSL(Ecomp, furiko_ellipe_k(k), double k)
FURIKO_GSL(Dcomp, furiko_ellipd_k(k), double k)
FURIKO_GSL(Pcomp, furiko_ellippi_k(-n, k), double k, double n)
FURIKO_GSL(F, furiko_ellipf_k(phi, k), double phi, double k)
FURIKO_GSL(E, furiko_ellipeinc_k(phi, k), double phi, double k)
FURIKO_GSL(D, furiko_ellipdinc_k(phi, k), double phi, double k)
FURIKO_GSL(P, furiko_ellippiinc_k(-n, phi, k), double phi, double k, double n)
FURIKO_GSL(RC, furiko_carlson_rc(x, y), double x, double y)
FURIKO_GSL(RD, furiko_carlson_rd(x, y, z), double x, double y, double z)
FURIKO_GSL(RF, furiko_carlson_rf(x, y, z), double x, double y, double z)
FURIKO_GSL(RJ, furiko_carlson_rj(x, y, z, p), double x, double y, double z, double p)
#undef FURIKO_GSL

static inline int furiko_gsl_elljac_e(double u, double m, double *sn, double *cn, double *dn)
{
    furiko_jacobi_m(u, m, sn, cn, dn);
    return isfinite(*sn) ? GSL_SUCCESS : GSL_EDOM;
}

/* GSL's names for them, also where GSL's headers have declared its own */
#define gsl_sf_ellint_Kcomp furiko_gsl_Kcomp
#define gsl_sf_ellint_Kcomp_e furiko_gsl_Kcomp_e
#define gsl_sf_ellint_Ecomp furiko_gsl_Ecomp
#define gsl_sf_ellint_Ecomp_e furiko_gsl_Ecomp_e
#define gsl_sf_ellint_Dcomp furiko_gsl_Dcomp
#define gsl_sf_ellint_Dcomp_e furiko_gsl_Dcomp_e
#define gsl_sf_ellint_Pcomp furiko_gsl_Pcomp
#define gsl_sf_ellint_Pcomp_e furiko_gsl_Pcomp_e
#define gsl_sf_ellint_F furiko_gsl_F
#define gsl_sf_ellint_F_e furiko_gsl_F_e
#define gsl_sf_ellint_E furiko_gsl_E
#define gsl_sf_ellint_E_e furiko_gsl_E_e
#define gsl_sf_ellint_D furiko_gsl_D
#define gsl_sf_ellint_D_e furiko_gsl_D_e
#define gsl_sf_ellint_P furiko_gsl_P
#define gsl_sf_ellint_P_e furiko_gsl_P_e
#define gsl_sf_ellint_RC furiko_gsl_RC
#define gsl_sf_ellint_RC_e furiko_gsl_RC_e
#define gsl_sf_ellint_RD furiko_gsl_RD
#define gsl_sf_ellint_RD_e furiko_gsl_RD_e
#define gsl_sf_ellint_RF furiko_gsl_RF
#define gsl_sf_ellint_RF_e furiko_gsl_RF_e
#define gsl_sf_ellint_RJ furiko_gsl_RJ
#define gsl_sf_ellint_RJ_e furiko_gsl_RJ_e
#define gsl_sf_elljac_e furiko_gsl_elljac_e

#endif
