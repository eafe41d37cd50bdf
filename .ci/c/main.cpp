// SPDX-License-Identifier: MIT
//
// Every function of furiko.hpp from C++: each name, in double, float and arrays, is C's function of that name. calls.h
// is that of main.c.
#include <cmath>
#include <cstdio>
#include <cstring>

#include "furiko.hpp"

static long checks = 0, faults = 0;

static void check(bool good, const char *what) {
    ++checks;
    if (good) return;
    ++faults;
    std::printf("wrong: %s\n", what);
}

// The same bits; NaN is itself
template <typename T> static bool same(T x, T y) { return x == y || (x != x && y != y); }

// Arguments within the domain of most functions
static const double x[] = {0.35, 0.45, 0.55, 0.65};
static const float xf[] = {0.35f, 0.45f, 0.55f, 0.65f};

#define FUNCTION(name, given, givenf, arrays, arraysf) \
    static void check_##name() { \
        double y = 0; \
        float yf = 0; \
        check(same(furiko::name given, furiko_##name given), #name); \
        check(same(furiko::name givenf, furiko_##name##f givenf), #name " of float"); \
        furiko::name arrays; \
        check(std::fabs(y - furiko_##name given) <= 1e-14*std::fabs(y) || y != y, #name " of arrays"); \
        furiko::name arraysf; \
        check(std::fabs(yf - furiko_##name##f givenf) <= 1e-5f*std::fabs(yf) || yf != yf, #name " of arrays of float"); \
        check(y != 0 && yf != 0, #name " of arrays is not done"); \
    }
#define CALL_1_1(name) FUNCTION(name, (x[0]), (xf[0]), (1, x, &y), (1, xf, &yf))
#define CALL_2_1(name) FUNCTION(name, (x[0], x[1]), (xf[0], xf[1]), (1, x, x + 1, &y), (1, xf, xf + 1, &yf))
#define CALL_3_1(name) \
    FUNCTION(name, (x[0], x[1], x[2]), (xf[0], xf[1], xf[2]), (1, x, x + 1, x + 2, &y), (1, xf, xf + 1, xf + 2, &yf))
#define CALL_4_1(name) \
    FUNCTION(name, (x[0], x[1], x[2], x[3]), (xf[0], xf[1], xf[2], xf[3]), (1, x, x + 1, x + 2, x + 3, &y), \
        (1, xf, xf + 1, xf + 2, xf + 3, &yf))
#define SEVERAL(name, given, givenf, arrays, arraysf, c, cf, results) \
    static void check_##name() { \
        double y[3], z[3]; \
        float yf[3], zf[3]; \
        furiko::name given; \
        furiko_##name c; \
        furiko::name givenf; \
        furiko_##name##f cf; \
        for (int i = 0; i < results; ++i) check(same(y[i], z[i]) && same(yf[i], zf[i]), #name); \
        furiko::name arrays; \
        furiko::name arraysf; \
        for (int i = 0; i < results; ++i) \
            check(std::fabs(y[i] - z[i]) < 1e-14 && std::fabs(yf[i] - zf[i]) < 1e-5f, #name " of arrays"); \
    }
#define CALL_1_2(name) \
    SEVERAL(name, (x[0], y[0], y[1]), (xf[0], yf[0], yf[1]), (1, x, y, y + 1), (1, xf, yf, yf + 1), \
        (x[0], z, z + 1), (xf[0], zf, zf + 1), 2)
#define CALL_2_3(name) \
    SEVERAL(name, (x[0], x[1], y[0], y[1], y[2]), (xf[0], xf[1], yf[0], yf[1], yf[2]), \
        (1, x, x + 1, y, y + 1, y + 2), (1, xf, xf + 1, yf, yf + 1, yf + 2), \
        (x[0], x[1], z, z + 1, z + 2), (xf[0], xf[1], zf, zf + 1, zf + 2), 3)
#include "calls.h"
#undef CALL_1_1
#undef CALL_2_1
#undef CALL_3_1
#undef CALL_4_1
#undef CALL_1_2
#undef CALL_2_3

static void check_functions() {
#define CALL_1_1(name) check_##name();
#define CALL_2_1(name) check_##name();
#define CALL_3_1(name) check_##name();
#define CALL_4_1(name) check_##name();
#define CALL_1_2(name) check_##name();
#define CALL_2_3(name) check_##name();
#include "calls.h"
}

static void check_modulus() {
    const furiko::modulus p = furiko::modulus::from_m(0.3), copy = p;
    furiko_modulus q;
    double sn, cn, dn, y[3];
    furiko_modulus_from_m(&q, 0.3);
    static_assert(sizeof p == sizeof q, "a modulus is no larger than C's");
    check(p.k() == furiko_modulus_k(&q) && p.m() == 0.3 && p.mc() == furiko_modulus_mc(&q), "m of modulus");
    check(p.ellipk() == furiko_modulus_ellipk(&q) && p.ellipe() == furiko_modulus_ellipe(&q), "K and E of modulus");
    check(p.quarter_period() == furiko_modulus_quarter_period(&q) && p.nome() == furiko_modulus_nome(&q), "its nome");
    check(copy.am(0.5) == furiko_modulus_am(&q, 0.5) && copy.epsilon(0.5) == furiko_modulus_epsilon(&q, 0.5), "its am");
    p.jacobi(x[0], sn, cn, dn);
    furiko_modulus_jacobi(&q, x[0], y, y + 1, y + 2);
    check(sn == y[0] && cn == y[1] && dn == y[2], "jacobi of modulus");
    p.jacobi(1, x, &sn, &cn, &dn);
    furiko_modulus_jacobi_v(&q, 1, x, y, y + 1, y + 2);
    check(sn == y[0] && cn == y[1] && dn == y[2], "jacobi of modulus and arrays");
    p.am(3, x, y);
    furiko_modulus_am_v(&q, 1, x + 2, &sn);
    check(y[2] == sn, "am of modulus and arrays");
    p.epsilon(3, x, y);
    furiko_modulus_epsilon_v(&q, 1, x + 2, &sn);
    check(y[2] == sn, "epsilon of modulus and arrays");
    check(p.complement().m() == p.mc(), "complement");
    check(furiko::modulus::from_k(0.6).k() == 0.6 && furiko::modulus::from_mc(0.6).mc() == 0.6, "from_k, from_mc");
    check(furiko::modulus::from_alpha(0.5).ellipk() == furiko::modulus::from_amplitude(1.0).ellipk(), "from_alpha");
    check(furiko::modulus().ellipk() != furiko::modulus().ellipk(), "what was never made");
}

static void check_motion() {
    const furiko::motion path = furiko::motion::released(1, 9.81, 2);
    const furiko::motion over = furiko::motion::started(1, 9.81, 0, 7);
    furiko_motion q;
    double y[3], z;
    furiko_motion_released(&q, 1, 9.81, 2);
    static_assert(sizeof path == sizeof q, "a motion is no larger than C's");
    check(path.is_libration() && !path.is_rotation() && over.is_rotation() && !over.is_libration(), "libration");
    check(path.period() == furiko_motion_period(&q) && path.amplitude() == furiko_motion_amplitude(&q), "period");
    check(path.energy() == furiko_motion_energy(&q) && path.slack_angle() == furiko_motion_slack_angle(&q), "energy");
    check(path.angle(0.5) == furiko_motion_angle(&q, 0.5) && path.rate(0.5) == furiko_motion_rate(&q, 0.5), "angle");
    check(path.tension(0.5) == furiko_motion_tension(&q, 0.5) && path.phase(0.5) == furiko_motion_phase(&q, 0.5)
        && path.harmonic_angle(0.5) == furiko_motion_harmonic_angle(&q, 0.5), "tension");
    check(path.time_to(-1) == furiko_motion_time_to(&q, -1), "time_to");
    path.angle(3, x, y);
    furiko_motion_angle_v(&q, 1, x + 2, &z);
    check(y[2] == z, "angles");
    path.rate(3, x, y);
    furiko_motion_rate_v(&q, 1, x + 2, &z);
    check(y[2] == z, "rates");
    path.tension(3, x, y);
    furiko_motion_tension_v(&q, 1, x + 2, &z);
    check(y[2] == z, "tensions");
    check(furiko::motion::swinging(1, 9.81, 2).period() == path.period(), "swinging");
    check(furiko::motion().period() != furiko::motion().period(), "what was never made");
}

int main() {
    check(furiko_version() == FURIKO_VERSION, "furiko_version");
    check_functions();
    check_modulus();
    check_motion();
    std::printf("%ld of %ld checks failed\n", faults, checks);
    return faults != 0 || checks < 700;
}
