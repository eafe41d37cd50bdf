/* SPDX-License-Identifier: MIT
 *
 * compat/cephes.c against Abramowitz and Stegun: tables 17.1 (m = 1/2), 17.5 and 17.6 (30 degrees, k =
 * 1/2); Cephes prints accuracies, no values. Which form of the modulus each takes shows in K(1/4) and
 * E(1/4).
 */
#include <math.h>
#include <stdio.h>

double ellpk(double), ellpe(double), ellik(double, double), ellie(double, double);
int ellpj(double, double, double *, double *, double *, double *);

static int wrong = 0;

static void near(const char *what, double x, double published, double error)
{
    if (fabs(x - published) <= error) return;
    printf("wrong: %s: %.17g\n", what, x);
    ++wrong;
}

int main(void)
{
    const double pi = 3.14159265358979323846;
    double sn, cn, dn, phi;
    near("ellpk", ellpk(0.5), 1.854074677301372, 1e-15);
    near("ellpe", ellpe(0.5), 1.350643881047675, 1e-15);
    near("ellpk of 1 - m", ellpk(0.75), 1.685750354812596, 1e-15);
    near("ellpe of 1 - m", ellpe(0.75), 1.467462209339427, 1e-15);
    near("ellik", ellik(pi/6, 0.25), 0.52942863, 1e-8);
    near("ellie", ellie(pi/6, 0.25), 0.51788193, 1e-8);
    near("ellpj", ellpj(0.52942863, 0.25, &sn, &cn, &dn, &phi), 0, 0);
    near("ellpj: sn", sn, 0.5, 1e-8);
    near("ellpj: cn", cn, sqrt(0.75), 1e-8);
    near("ellpj: dn", dn, sqrt(0.9375), 1e-8);
    near("ellpj: phi", phi, pi/6, 1e-8);
    near("ellpj of infinity", ellpj(HUGE_VAL, 0.25, &sn, &cn, &dn, &phi), -1, 0);
    printf("cephes: %d wrong\n", wrong);
    return wrong != 0;
}
