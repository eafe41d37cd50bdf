/* SPDX-License-Identifier: MIT
 *
 * The elliptic functions of Cephes (Moshier: Methods and Programs for Mathematical Functions, 1989;
 * ellf/) under their names, computed by furiko. ellpk and ellpe take the complementary parameter m1 = 1 -
 * m, the others m = k^2. SciPy's copy of ellpe takes m: what was scipy's is furiko_ellipe_m.
 *
 * Otherwise than there: mtherr is not called; where there is no value it is NaN (there: 0), at a pole
 * infinite (there: MAXNUM); m < 0, and m > 1 where that has a value, are computed. ellpj is -1 where the
 * results are NaN.
 */
#include "furiko.h"

double ellpk(double m1) { return furiko_ellipk_mc(m1); }

double ellpe(double m1) { return furiko_ellipe_mc(m1); }

double ellik(double phi, double m) { return furiko_ellipf_m(phi, m); }

double ellie(double phi, double m) { return furiko_ellipeinc_m(phi, m); }

int ellpj(double u, double m, double *sn, double *cn, double *dn, double *ph)
{
    furiko_jacobi_m(u, m, sn, cn, dn);
    *ph = furiko_jacobi_am_m(u, m);
    return *sn == *sn ? 0 : -1;
}
