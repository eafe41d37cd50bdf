/* SPDX-License-Identifier: MIT
 *
 * include/furiko_gsl.h beside GSL itself, at random arguments where both have values; with -DALONE, without any header
 * or library of GSL's: a program of GSL's names still compiles and knows K(1/2).
 */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#ifdef ALONE
#include "furiko_gsl.h"

int main(void)
{
    gsl_sf_result result;
    double sn, cn, dn;
    const int status = gsl_sf_ellint_Kcomp_e(0.5, GSL_MODE_DEFAULT, &result);
    return !(status == GSL_SUCCESS && fabs(result.val - 1.6857503548125961) <= result.err && result.err < 1e-14 &&
        gsl_sf_elljac_e(0.2, 0.3, &sn, &cn, &dn) == GSL_SUCCESS && fabs(sn - 0.1983) < 1e-4);
}
#else
#include <gsl/gsl_errno.h>
#include <gsl/gsl_sf_ellint.h>
#include <gsl/gsl_sf_elljac.h>

/* GSL's own, before the names are furiko's */
#define OWN(name) static double own_##name(const double x[]) { return name(ARGUMENTS, GSL_PREC_DOUBLE); }
#define ARGUMENTS x[0]
OWN(gsl_sf_ellint_Kcomp) OWN(gsl_sf_ellint_Ecomp) OWN(gsl_sf_ellint_Dcomp)
#undef ARGUMENTS
#define ARGUMENTS x[0], x[1]
OWN(gsl_sf_ellint_Pcomp)
#undef ARGUMENTS
/* phi, k; x, y, z, p: k comes first above */
#define ARGUMENTS x[1], x[0]
OWN(gsl_sf_ellint_F) OWN(gsl_sf_ellint_E) OWN(gsl_sf_ellint_D)
#undef ARGUMENTS
#define ARGUMENTS x[1], x[0], x[2]
OWN(gsl_sf_ellint_P)
#undef ARGUMENTS
#define ARGUMENTS x[0], x[1]
OWN(gsl_sf_ellint_RC)
#undef ARGUMENTS
#define ARGUMENTS x[0], x[1], x[2]
OWN(gsl_sf_ellint_RD) OWN(gsl_sf_ellint_RF)
#undef ARGUMENTS
#define ARGUMENTS x[0], x[1], x[2], x[3]
OWN(gsl_sf_ellint_RJ)
static int own_elljac(double u, double m, double y[]) { return gsl_sf_elljac_e(u, m, y, y + 1, y + 2); }

#include "furiko_gsl.h"

static long checks = 0, wrong = 0;

static void near(const char *what, double x, double y, double error)
{
    ++checks;
    if (fabs(x - y) <= error*fabs(y)) return;
    ++wrong;
    printf("wrong: %s: %.17g, GSL %.17g\n", what, x, y);
}

static double any(double from, double to) { return from + (to - from)*rand()/RAND_MAX; }

/* One name at one place: the value, and the twin's */
#define SAME(name, x, ...) do { \
    gsl_sf_result r; \
    const double gsl = own_##name(x); \
    near(#name, name(__VA_ARGS__, GSL_PREC_DOUBLE), gsl, 1e-13); \
    near(#name "_e", name##_e(__VA_ARGS__, GSL_PREC_SINGLE, &r), GSL_SUCCESS, 0); \
    near(#name "_e", r.val, gsl, 1e-13); \
} while (0)

int main(void)
{
    gsl_sf_result r;
    double y[3], z[3];
    int i, j;
    srand(7);
    gsl_set_error_handler_off();
    for (i = 0; i < 2000; ++i) {
        const double l[3] = {any(-0.99, 0.99), any(-1.5, 1.5), any(-0.5, 3)};
        const double p[2] = {l[0], l[2]}, c[4] = {any(0, 2), any(0.1, 2), any(0.1, 2), any(0.1, 2)};
        SAME(gsl_sf_ellint_Kcomp, l, l[0]);
        SAME(gsl_sf_ellint_Ecomp, l, l[0]);
        SAME(gsl_sf_ellint_Dcomp, l, l[0]);
        SAME(gsl_sf_ellint_Pcomp, p, p[0], p[1]);
        SAME(gsl_sf_ellint_F, l, l[1], l[0]);
        SAME(gsl_sf_ellint_E, l, l[1], l[0]);
        SAME(gsl_sf_ellint_D, l, l[1], l[0]);
        SAME(gsl_sf_ellint_P, l, l[1], l[0], l[2]);
        SAME(gsl_sf_ellint_RC, c, c[0], c[1]);
        SAME(gsl_sf_ellint_RD, c, c[0], c[1], c[2]);
        SAME(gsl_sf_ellint_RF, c, c[0], c[1], c[2]);
        SAME(gsl_sf_ellint_RJ, c, c[0], c[1], c[2], c[3]);
        own_elljac(3*l[1], l[0]*l[0], y);
        near("gsl_sf_elljac_e", gsl_sf_elljac_e(3*l[1], l[0]*l[0], z, z + 1, z + 2), GSL_SUCCESS, 0);
        for (j = 0; j < 3; ++j) near("gsl_sf_elljac_e", z[j] + 2, y[j] + 2, 1e-14);
    }
    /* Where there is no value */
    near("status of K(2)", gsl_sf_ellint_Kcomp_e(2, GSL_MODE_DEFAULT, &r), GSL_EDOM, 0);
    near("K(2) is NaN", isnan(r.val) != 0, 1, 0);
    near("status of K(1)", gsl_sf_ellint_Kcomp_e(1, GSL_MODE_DEFAULT, &r), GSL_EDOM, 0);
    near("status of RF(-1, 1, 1)", gsl_sf_ellint_RF_e(-1, 1, 1, GSL_MODE_DEFAULT, &r), GSL_EDOM, 0);
    near("status of sn(infinity)", gsl_sf_elljac_e(HUGE_VAL, 0.5, z, z + 1, z + 2), GSL_EDOM, 0);
    printf("gsl: %ld values, %ld wrong\n", checks, wrong);
    return wrong != 0;
}
#endif
