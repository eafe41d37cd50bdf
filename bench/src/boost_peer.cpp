// SPDX-License-Identifier: MIT
//
// Boost's elliptic integrals for the benchmark, computed in double as ours and GSL's are; NaN where
// Boost is not installed.
#include <limits>

#if __has_include(<boost/math/special_functions/ellint_1.hpp>)
#include <boost/math/special_functions/ellint_1.hpp>
#include <boost/math/special_functions/ellint_2.hpp>
#include <boost/math/special_functions/ellint_3.hpp>
#include <boost/math/special_functions/ellint_d.hpp>
#include <boost/math/special_functions/ellint_rc.hpp>
#include <boost/math/special_functions/ellint_rd.hpp>
#include <boost/math/special_functions/ellint_rf.hpp>
#include <boost/math/special_functions/ellint_rg.hpp>
#include <boost/math/special_functions/ellint_rj.hpp>
#include <boost/math/special_functions/heuman_lambda.hpp>
#include <boost/math/special_functions/jacobi_elliptic.hpp>
#include <boost/math/special_functions/jacobi_zeta.hpp>
namespace peer = boost::math;
static const peer::policies::policy<peer::policies::promote_double<false>> plain;
#define PEER(value) value
#else
static const double absent = std::numeric_limits<double>::quiet_NaN();
#define PEER(value) absent
#endif

extern "C" {
double boost_k(double k) { return PEER(peer::ellint_1(k, plain)); }
double boost_e(double k) { return PEER(peer::ellint_2(k, plain)); }
double boost_d(double k) { return PEER(peer::ellint_d(k, plain)); }
double boost_pi(double k, double n) { return PEER(peer::ellint_3(k, n, plain)); }
double boost_f(double phi, double k) { return PEER(peer::ellint_1(k, phi, plain)); }
double boost_einc(double phi, double k) { return PEER(peer::ellint_2(k, phi, plain)); }
double boost_dinc(double phi, double k) { return PEER(peer::ellint_d(k, phi, plain)); }
double boost_piinc(double phi, double k, double n) { return PEER(peer::ellint_3(k, n, phi, plain)); }
double boost_rf(double x, double y, double z) { return PEER(peer::ellint_rf(x, y, z, plain)); }
double boost_rc(double x, double y) { return PEER(peer::ellint_rc(x, y, plain)); }
double boost_rg(double x, double y, double z) { return PEER(peer::ellint_rg(x, y, z, plain)); }
double boost_rd(double x, double y, double z) { return PEER(peer::ellint_rd(x, y, z, plain)); }
double boost_jacobi(double k, double u, double *cn, double *dn) { return PEER(peer::jacobi_elliptic(k, u, cn, dn, plain)); }
double boost_zeta(double phi, double k) { return PEER(peer::jacobi_zeta(k, phi, plain)); }
double boost_lambda(double phi, double k) { return PEER(peer::heuman_lambda(k, phi, plain)); }
double boost_rj(double x, double y, double z, double p) { return PEER(peer::ellint_rj(x, y, z, p, plain)); }
}
