/* SPDX-License-Identifier: MIT */
/* Written by tools/make_c_interface.py. */
/**
 * @file furiko.hpp
 * furiko.h for C++11 and later: one name for double, float and arrays, in the namespace furiko; nothing is allocated,
 * nothing is thrown. What the functions are and promise: furiko.h. Arguments are all double or all float:
 * agm(1.0, 2.0), not agm(1, 2), which a compiler calls ambiguous. std::modulus is something else.
 */
#ifndef FURIKO_HPP
#define FURIKO_HPP

#include <cstddef>

#include "furiko.h"

namespace furiko {

/* ---- Arithmetic-geometric mean ---- */

/** Arithmetic-geometric mean M(a, b). @{ */
inline double agm(double a, double b) { return furiko_agm(a, b); }
inline void agm(std::size_t count, const double a[], const double b[], double mean[]) {
    furiko_agm_v(count, a, b, mean);
}
inline float agm(float a, float b) { return furiko_agmf(a, b); }
inline void agm(std::size_t count, const float a[], const float b[], float mean[]) {
    furiko_agm_vf(count, a, b, mean);
}
/** @} */

/* ---- Complete integrals K, E, B, D ---- */

/** Complete elliptic integral of the first kind. @{ */
inline double ellipk_k(double k) { return furiko_ellipk_k(k); }
inline void ellipk_k(std::size_t count, const double k[], double big_k[]) {
    furiko_ellipk_k_v(count, k, big_k);
}
inline float ellipk_k(float k) { return furiko_ellipk_kf(k); }
inline void ellipk_k(std::size_t count, const float k[], float big_k[]) {
    furiko_ellipk_k_vf(count, k, big_k);
}
/** @} */

/** Complete elliptic integral of the first kind. @{ */
inline double ellipk_m(double m) { return furiko_ellipk_m(m); }
inline void ellipk_m(std::size_t count, const double m[], double big_k[]) {
    furiko_ellipk_m_v(count, m, big_k);
}
inline float ellipk_m(float m) { return furiko_ellipk_mf(m); }
inline void ellipk_m(std::size_t count, const float m[], float big_k[]) {
    furiko_ellipk_m_vf(count, m, big_k);
}
/** @} */

/** Complete elliptic integral of the first kind. @{ */
inline double ellipk_mc(double mc) { return furiko_ellipk_mc(mc); }
inline void ellipk_mc(std::size_t count, const double mc[], double big_k[]) {
    furiko_ellipk_mc_v(count, mc, big_k);
}
inline float ellipk_mc(float mc) { return furiko_ellipk_mcf(mc); }
inline void ellipk_mc(std::size_t count, const float mc[], float big_k[]) {
    furiko_ellipk_mc_vf(count, mc, big_k);
}
/** @} */

/** Complete elliptic integral of the first kind. @{ */
inline double ellipk_alpha(double alpha) { return furiko_ellipk_alpha(alpha); }
inline void ellipk_alpha(std::size_t count, const double alpha[], double big_k[]) {
    furiko_ellipk_alpha_v(count, alpha, big_k);
}
inline float ellipk_alpha(float alpha) { return furiko_ellipk_alphaf(alpha); }
inline void ellipk_alpha(std::size_t count, const float alpha[], float big_k[]) {
    furiko_ellipk_alpha_vf(count, alpha, big_k);
}
/** @} */

/** Complete elliptic integral of the second kind. @{ */
inline double ellipe_k(double k) { return furiko_ellipe_k(k); }
inline void ellipe_k(std::size_t count, const double k[], double e[]) {
    furiko_ellipe_k_v(count, k, e);
}
inline float ellipe_k(float k) { return furiko_ellipe_kf(k); }
inline void ellipe_k(std::size_t count, const float k[], float e[]) {
    furiko_ellipe_k_vf(count, k, e);
}
/** @} */

/** Complete elliptic integral of the second kind. @{ */
inline double ellipe_m(double m) { return furiko_ellipe_m(m); }
inline void ellipe_m(std::size_t count, const double m[], double e[]) {
    furiko_ellipe_m_v(count, m, e);
}
inline float ellipe_m(float m) { return furiko_ellipe_mf(m); }
inline void ellipe_m(std::size_t count, const float m[], float e[]) {
    furiko_ellipe_m_vf(count, m, e);
}
/** @} */

/** Complete elliptic integral of the second kind. @{ */
inline double ellipe_mc(double mc) { return furiko_ellipe_mc(mc); }
inline void ellipe_mc(std::size_t count, const double mc[], double e[]) {
    furiko_ellipe_mc_v(count, mc, e);
}
inline float ellipe_mc(float mc) { return furiko_ellipe_mcf(mc); }
inline void ellipe_mc(std::size_t count, const float mc[], float e[]) {
    furiko_ellipe_mc_vf(count, mc, e);
}
/** @} */

/** Complete elliptic integral of the second kind. @{ */
inline double ellipe_alpha(double alpha) { return furiko_ellipe_alpha(alpha); }
inline void ellipe_alpha(std::size_t count, const double alpha[], double e[]) {
    furiko_ellipe_alpha_v(count, alpha, e);
}
inline float ellipe_alpha(float alpha) { return furiko_ellipe_alphaf(alpha); }
inline void ellipe_alpha(std::size_t count, const float alpha[], float e[]) {
    furiko_ellipe_alpha_vf(count, alpha, e);
}
/** @} */

/** Associated complete elliptic integral B = (E - mc K)/m. @{ */
inline double ellipb_k(double k) { return furiko_ellipb_k(k); }
inline void ellipb_k(std::size_t count, const double k[], double b[]) {
    furiko_ellipb_k_v(count, k, b);
}
inline float ellipb_k(float k) { return furiko_ellipb_kf(k); }
inline void ellipb_k(std::size_t count, const float k[], float b[]) {
    furiko_ellipb_k_vf(count, k, b);
}
/** @} */

/** Associated complete elliptic integral B = (E - mc K)/m. @{ */
inline double ellipb_m(double m) { return furiko_ellipb_m(m); }
inline void ellipb_m(std::size_t count, const double m[], double b[]) {
    furiko_ellipb_m_v(count, m, b);
}
inline float ellipb_m(float m) { return furiko_ellipb_mf(m); }
inline void ellipb_m(std::size_t count, const float m[], float b[]) {
    furiko_ellipb_m_vf(count, m, b);
}
/** @} */

/** Associated complete elliptic integral B = (E - mc K)/m. @{ */
inline double ellipb_mc(double mc) { return furiko_ellipb_mc(mc); }
inline void ellipb_mc(std::size_t count, const double mc[], double b[]) {
    furiko_ellipb_mc_v(count, mc, b);
}
inline float ellipb_mc(float mc) { return furiko_ellipb_mcf(mc); }
inline void ellipb_mc(std::size_t count, const float mc[], float b[]) {
    furiko_ellipb_mc_vf(count, mc, b);
}
/** @} */

/** Associated complete elliptic integral B = (E - mc K)/m. @{ */
inline double ellipb_alpha(double alpha) { return furiko_ellipb_alpha(alpha); }
inline void ellipb_alpha(std::size_t count, const double alpha[], double b[]) {
    furiko_ellipb_alpha_v(count, alpha, b);
}
inline float ellipb_alpha(float alpha) { return furiko_ellipb_alphaf(alpha); }
inline void ellipb_alpha(std::size_t count, const float alpha[], float b[]) {
    furiko_ellipb_alpha_vf(count, alpha, b);
}
/** @} */

/** Complete elliptic integral D = (K - E)/m. @{ */
inline double ellipd_k(double k) { return furiko_ellipd_k(k); }
inline void ellipd_k(std::size_t count, const double k[], double d[]) {
    furiko_ellipd_k_v(count, k, d);
}
inline float ellipd_k(float k) { return furiko_ellipd_kf(k); }
inline void ellipd_k(std::size_t count, const float k[], float d[]) {
    furiko_ellipd_k_vf(count, k, d);
}
/** @} */

/** Complete elliptic integral D = (K - E)/m. @{ */
inline double ellipd_m(double m) { return furiko_ellipd_m(m); }
inline void ellipd_m(std::size_t count, const double m[], double d[]) {
    furiko_ellipd_m_v(count, m, d);
}
inline float ellipd_m(float m) { return furiko_ellipd_mf(m); }
inline void ellipd_m(std::size_t count, const float m[], float d[]) {
    furiko_ellipd_m_vf(count, m, d);
}
/** @} */

/** Complete elliptic integral D = (K - E)/m. @{ */
inline double ellipd_mc(double mc) { return furiko_ellipd_mc(mc); }
inline void ellipd_mc(std::size_t count, const double mc[], double d[]) {
    furiko_ellipd_mc_v(count, mc, d);
}
inline float ellipd_mc(float mc) { return furiko_ellipd_mcf(mc); }
inline void ellipd_mc(std::size_t count, const float mc[], float d[]) {
    furiko_ellipd_mc_vf(count, mc, d);
}
/** @} */

/** Complete elliptic integral D = (K - E)/m. @{ */
inline double ellipd_alpha(double alpha) { return furiko_ellipd_alpha(alpha); }
inline void ellipd_alpha(std::size_t count, const double alpha[], double d[]) {
    furiko_ellipd_alpha_v(count, alpha, d);
}
inline float ellipd_alpha(float alpha) { return furiko_ellipd_alphaf(alpha); }
inline void ellipd_alpha(std::size_t count, const float alpha[], float d[]) {
    furiko_ellipd_alpha_vf(count, alpha, d);
}
/** @} */

/** K and E together. @{ */
inline void ellipke_k(double k, double &big_k, double &e) {
    furiko_ellipke_k(k, &big_k, &e);
}
inline void ellipke_k(std::size_t count, const double k[], double big_k[], double e[]) {
    furiko_ellipke_k_v(count, k, big_k, e);
}
inline void ellipke_k(float k, float &big_k, float &e) {
    furiko_ellipke_kf(k, &big_k, &e);
}
inline void ellipke_k(std::size_t count, const float k[], float big_k[], float e[]) {
    furiko_ellipke_k_vf(count, k, big_k, e);
}
/** @} */

/** K and E together. @{ */
inline void ellipke_m(double m, double &big_k, double &e) {
    furiko_ellipke_m(m, &big_k, &e);
}
inline void ellipke_m(std::size_t count, const double m[], double big_k[], double e[]) {
    furiko_ellipke_m_v(count, m, big_k, e);
}
inline void ellipke_m(float m, float &big_k, float &e) {
    furiko_ellipke_mf(m, &big_k, &e);
}
inline void ellipke_m(std::size_t count, const float m[], float big_k[], float e[]) {
    furiko_ellipke_m_vf(count, m, big_k, e);
}
/** @} */

/** K and E together. @{ */
inline void ellipke_mc(double mc, double &big_k, double &e) {
    furiko_ellipke_mc(mc, &big_k, &e);
}
inline void ellipke_mc(std::size_t count, const double mc[], double big_k[], double e[]) {
    furiko_ellipke_mc_v(count, mc, big_k, e);
}
inline void ellipke_mc(float mc, float &big_k, float &e) {
    furiko_ellipke_mcf(mc, &big_k, &e);
}
inline void ellipke_mc(std::size_t count, const float mc[], float big_k[], float e[]) {
    furiko_ellipke_mc_vf(count, mc, big_k, e);
}
/** @} */

/** K and E together. @{ */
inline void ellipke_alpha(double alpha, double &big_k, double &e) {
    furiko_ellipke_alpha(alpha, &big_k, &e);
}
inline void ellipke_alpha(std::size_t count, const double alpha[], double big_k[], double e[]) {
    furiko_ellipke_alpha_v(count, alpha, big_k, e);
}
inline void ellipke_alpha(float alpha, float &big_k, float &e) {
    furiko_ellipke_alphaf(alpha, &big_k, &e);
}
inline void ellipke_alpha(std::size_t count, const float alpha[], float big_k[], float e[]) {
    furiko_ellipke_alpha_vf(count, alpha, big_k, e);
}
/** @} */

/* ---- The complete integral S ---- */

/** Complete elliptic integral S = (D - B)/m. @{ */
inline double ellips_k(double k) { return furiko_ellips_k(k); }
inline void ellips_k(std::size_t count, const double k[], double s[]) {
    furiko_ellips_k_v(count, k, s);
}
inline float ellips_k(float k) { return furiko_ellips_kf(k); }
inline void ellips_k(std::size_t count, const float k[], float s[]) {
    furiko_ellips_k_vf(count, k, s);
}
/** @} */

/** Complete elliptic integral S = (D - B)/m. @{ */
inline double ellips_m(double m) { return furiko_ellips_m(m); }
inline void ellips_m(std::size_t count, const double m[], double s[]) {
    furiko_ellips_m_v(count, m, s);
}
inline float ellips_m(float m) { return furiko_ellips_mf(m); }
inline void ellips_m(std::size_t count, const float m[], float s[]) {
    furiko_ellips_m_vf(count, m, s);
}
/** @} */

/** Complete elliptic integral S = (D - B)/m. @{ */
inline double ellips_mc(double mc) { return furiko_ellips_mc(mc); }
inline void ellips_mc(std::size_t count, const double mc[], double s[]) {
    furiko_ellips_mc_v(count, mc, s);
}
inline float ellips_mc(float mc) { return furiko_ellips_mcf(mc); }
inline void ellips_mc(std::size_t count, const float mc[], float s[]) {
    furiko_ellips_mc_vf(count, mc, s);
}
/** @} */

/* ---- Incomplete integrals F, E, D ---- */

/** Legendre's incomplete integral of the first kind. @{ */
inline double ellipf_k(double phi, double k) { return furiko_ellipf_k(phi, k); }
inline void ellipf_k(std::size_t count, const double phi[], const double k[], double f[]) {
    furiko_ellipf_k_v(count, phi, k, f);
}
inline float ellipf_k(float phi, float k) { return furiko_ellipf_kf(phi, k); }
inline void ellipf_k(std::size_t count, const float phi[], const float k[], float f[]) {
    furiko_ellipf_k_vf(count, phi, k, f);
}
/** @} */

/** Legendre's incomplete integral of the first kind. @{ */
inline double ellipf_m(double phi, double m) { return furiko_ellipf_m(phi, m); }
inline void ellipf_m(std::size_t count, const double phi[], const double m[], double f[]) {
    furiko_ellipf_m_v(count, phi, m, f);
}
inline float ellipf_m(float phi, float m) { return furiko_ellipf_mf(phi, m); }
inline void ellipf_m(std::size_t count, const float phi[], const float m[], float f[]) {
    furiko_ellipf_m_vf(count, phi, m, f);
}
/** @} */

/** Legendre's incomplete integral of the first kind. @{ */
inline double ellipf_mc(double phi, double mc) { return furiko_ellipf_mc(phi, mc); }
inline void ellipf_mc(std::size_t count, const double phi[], const double mc[], double f[]) {
    furiko_ellipf_mc_v(count, phi, mc, f);
}
inline float ellipf_mc(float phi, float mc) { return furiko_ellipf_mcf(phi, mc); }
inline void ellipf_mc(std::size_t count, const float phi[], const float mc[], float f[]) {
    furiko_ellipf_mc_vf(count, phi, mc, f);
}
/** @} */

/** Legendre's incomplete integral of the second kind. @{ */
inline double ellipeinc_k(double phi, double k) { return furiko_ellipeinc_k(phi, k); }
inline void ellipeinc_k(std::size_t count, const double phi[], const double k[], double e[]) {
    furiko_ellipeinc_k_v(count, phi, k, e);
}
inline float ellipeinc_k(float phi, float k) { return furiko_ellipeinc_kf(phi, k); }
inline void ellipeinc_k(std::size_t count, const float phi[], const float k[], float e[]) {
    furiko_ellipeinc_k_vf(count, phi, k, e);
}
/** @} */

/** Legendre's incomplete integral of the second kind. @{ */
inline double ellipeinc_m(double phi, double m) { return furiko_ellipeinc_m(phi, m); }
inline void ellipeinc_m(std::size_t count, const double phi[], const double m[], double e[]) {
    furiko_ellipeinc_m_v(count, phi, m, e);
}
inline float ellipeinc_m(float phi, float m) { return furiko_ellipeinc_mf(phi, m); }
inline void ellipeinc_m(std::size_t count, const float phi[], const float m[], float e[]) {
    furiko_ellipeinc_m_vf(count, phi, m, e);
}
/** @} */

/** Legendre's incomplete integral of the second kind. @{ */
inline double ellipeinc_mc(double phi, double mc) { return furiko_ellipeinc_mc(phi, mc); }
inline void ellipeinc_mc(std::size_t count, const double phi[], const double mc[], double e[]) {
    furiko_ellipeinc_mc_v(count, phi, mc, e);
}
inline float ellipeinc_mc(float phi, float mc) { return furiko_ellipeinc_mcf(phi, mc); }
inline void ellipeinc_mc(std::size_t count, const float phi[], const float mc[], float e[]) {
    furiko_ellipeinc_mc_vf(count, phi, mc, e);
}
/** @} */

/** Legendre's incomplete integral D = (F - E)/m. @{ */
inline double ellipdinc_k(double phi, double k) { return furiko_ellipdinc_k(phi, k); }
inline void ellipdinc_k(std::size_t count, const double phi[], const double k[], double d[]) {
    furiko_ellipdinc_k_v(count, phi, k, d);
}
inline float ellipdinc_k(float phi, float k) { return furiko_ellipdinc_kf(phi, k); }
inline void ellipdinc_k(std::size_t count, const float phi[], const float k[], float d[]) {
    furiko_ellipdinc_k_vf(count, phi, k, d);
}
/** @} */

/** Legendre's incomplete integral D = (F - E)/m. @{ */
inline double ellipdinc_m(double phi, double m) { return furiko_ellipdinc_m(phi, m); }
inline void ellipdinc_m(std::size_t count, const double phi[], const double m[], double d[]) {
    furiko_ellipdinc_m_v(count, phi, m, d);
}
inline float ellipdinc_m(float phi, float m) { return furiko_ellipdinc_mf(phi, m); }
inline void ellipdinc_m(std::size_t count, const float phi[], const float m[], float d[]) {
    furiko_ellipdinc_m_vf(count, phi, m, d);
}
/** @} */

/** Legendre's incomplete integral D = (F - E)/m. @{ */
inline double ellipdinc_mc(double phi, double mc) { return furiko_ellipdinc_mc(phi, mc); }
inline void ellipdinc_mc(std::size_t count, const double phi[], const double mc[], double d[]) {
    furiko_ellipdinc_mc_v(count, phi, mc, d);
}
inline float ellipdinc_mc(float phi, float mc) { return furiko_ellipdinc_mcf(phi, mc); }
inline void ellipdinc_mc(std::size_t count, const float phi[], const float mc[], float d[]) {
    furiko_ellipdinc_mc_vf(count, phi, mc, d);
}
/** @} */

/* ---- The third kind ---- */

/** Complete elliptic integral of the third kind. @{ */
inline double ellippi_k(double n, double k) { return furiko_ellippi_k(n, k); }
inline void ellippi_k(std::size_t count, const double n[], const double k[], double pi[]) {
    furiko_ellippi_k_v(count, n, k, pi);
}
inline float ellippi_k(float n, float k) { return furiko_ellippi_kf(n, k); }
inline void ellippi_k(std::size_t count, const float n[], const float k[], float pi[]) {
    furiko_ellippi_k_vf(count, n, k, pi);
}
/** @} */

/** Complete elliptic integral of the third kind. @{ */
inline double ellippi_m(double n, double m) { return furiko_ellippi_m(n, m); }
inline void ellippi_m(std::size_t count, const double n[], const double m[], double pi[]) {
    furiko_ellippi_m_v(count, n, m, pi);
}
inline float ellippi_m(float n, float m) { return furiko_ellippi_mf(n, m); }
inline void ellippi_m(std::size_t count, const float n[], const float m[], float pi[]) {
    furiko_ellippi_m_vf(count, n, m, pi);
}
/** @} */

/** Complete elliptic integral of the third kind. @{ */
inline double ellippi_mc(double n, double mc) { return furiko_ellippi_mc(n, mc); }
inline void ellippi_mc(std::size_t count, const double n[], const double mc[], double pi[]) {
    furiko_ellippi_mc_v(count, n, mc, pi);
}
inline float ellippi_mc(float n, float mc) { return furiko_ellippi_mcf(n, mc); }
inline void ellippi_mc(std::size_t count, const float n[], const float mc[], float pi[]) {
    furiko_ellippi_mc_vf(count, n, mc, pi);
}
/** @} */

/** Legendre's incomplete integral of the third kind. @{ */
inline double ellippiinc_k(double n, double phi, double k) { return furiko_ellippiinc_k(n, phi, k); }
inline void ellippiinc_k(std::size_t count, const double n[], const double phi[], const double k[],
        double pi[]) {
    furiko_ellippiinc_k_v(count, n, phi, k, pi);
}
inline float ellippiinc_k(float n, float phi, float k) { return furiko_ellippiinc_kf(n, phi, k); }
inline void ellippiinc_k(std::size_t count, const float n[], const float phi[], const float k[], float pi[]) {
    furiko_ellippiinc_k_vf(count, n, phi, k, pi);
}
/** @} */

/** Legendre's incomplete integral of the third kind. @{ */
inline double ellippiinc_m(double n, double phi, double m) { return furiko_ellippiinc_m(n, phi, m); }
inline void ellippiinc_m(std::size_t count, const double n[], const double phi[], const double m[],
        double pi[]) {
    furiko_ellippiinc_m_v(count, n, phi, m, pi);
}
inline float ellippiinc_m(float n, float phi, float m) { return furiko_ellippiinc_mf(n, phi, m); }
inline void ellippiinc_m(std::size_t count, const float n[], const float phi[], const float m[], float pi[]) {
    furiko_ellippiinc_m_vf(count, n, phi, m, pi);
}
/** @} */

/** Legendre's incomplete integral of the third kind. @{ */
inline double ellippiinc_mc(double n, double phi, double mc) { return furiko_ellippiinc_mc(n, phi, mc); }
inline void ellippiinc_mc(std::size_t count, const double n[], const double phi[], const double mc[],
        double pi[]) {
    furiko_ellippiinc_mc_v(count, n, phi, mc, pi);
}
inline float ellippiinc_mc(float n, float phi, float mc) { return furiko_ellippiinc_mcf(n, phi, mc); }
inline void ellippiinc_mc(std::size_t count, const float n[], const float phi[], const float mc[],
        float pi[]) {
    furiko_ellippiinc_mc_vf(count, n, phi, mc, pi);
}
/** @} */

/* ---- The associate integral of the third kind ---- */

/** Associate complete integral J = (Pi - K)/n. @{ */
inline double ellipj_k(double n, double k) { return furiko_ellipj_k(n, k); }
inline void ellipj_k(std::size_t count, const double n[], const double k[], double j[]) {
    furiko_ellipj_k_v(count, n, k, j);
}
inline float ellipj_k(float n, float k) { return furiko_ellipj_kf(n, k); }
inline void ellipj_k(std::size_t count, const float n[], const float k[], float j[]) {
    furiko_ellipj_k_vf(count, n, k, j);
}
/** @} */

/** Associate complete integral J = (Pi - K)/n. @{ */
inline double ellipj_m(double n, double m) { return furiko_ellipj_m(n, m); }
inline void ellipj_m(std::size_t count, const double n[], const double m[], double j[]) {
    furiko_ellipj_m_v(count, n, m, j);
}
inline float ellipj_m(float n, float m) { return furiko_ellipj_mf(n, m); }
inline void ellipj_m(std::size_t count, const float n[], const float m[], float j[]) {
    furiko_ellipj_m_vf(count, n, m, j);
}
/** @} */

/** Associate complete integral J = (Pi - K)/n. @{ */
inline double ellipj_mc(double n, double mc) { return furiko_ellipj_mc(n, mc); }
inline void ellipj_mc(std::size_t count, const double n[], const double mc[], double j[]) {
    furiko_ellipj_mc_v(count, n, mc, j);
}
inline float ellipj_mc(float n, float mc) { return furiko_ellipj_mcf(n, mc); }
inline void ellipj_mc(std::size_t count, const float n[], const float mc[], float j[]) {
    furiko_ellipj_mc_vf(count, n, mc, j);
}
/** @} */

/** Associate incomplete integral J = (Pi - F)/n. @{ */
inline double ellipjinc_k(double n, double phi, double k) { return furiko_ellipjinc_k(n, phi, k); }
inline void ellipjinc_k(std::size_t count, const double n[], const double phi[], const double k[],
        double j[]) {
    furiko_ellipjinc_k_v(count, n, phi, k, j);
}
inline float ellipjinc_k(float n, float phi, float k) { return furiko_ellipjinc_kf(n, phi, k); }
inline void ellipjinc_k(std::size_t count, const float n[], const float phi[], const float k[], float j[]) {
    furiko_ellipjinc_k_vf(count, n, phi, k, j);
}
/** @} */

/** Associate incomplete integral J = (Pi - F)/n. @{ */
inline double ellipjinc_m(double n, double phi, double m) { return furiko_ellipjinc_m(n, phi, m); }
inline void ellipjinc_m(std::size_t count, const double n[], const double phi[], const double m[],
        double j[]) {
    furiko_ellipjinc_m_v(count, n, phi, m, j);
}
inline float ellipjinc_m(float n, float phi, float m) { return furiko_ellipjinc_mf(n, phi, m); }
inline void ellipjinc_m(std::size_t count, const float n[], const float phi[], const float m[], float j[]) {
    furiko_ellipjinc_m_vf(count, n, phi, m, j);
}
/** @} */

/** Associate incomplete integral J = (Pi - F)/n. @{ */
inline double ellipjinc_mc(double n, double phi, double mc) { return furiko_ellipjinc_mc(n, phi, mc); }
inline void ellipjinc_mc(std::size_t count, const double n[], const double phi[], const double mc[],
        double j[]) {
    furiko_ellipjinc_mc_v(count, n, phi, mc, j);
}
inline float ellipjinc_mc(float n, float phi, float mc) { return furiko_ellipjinc_mcf(n, phi, mc); }
inline void ellipjinc_mc(std::size_t count, const float n[], const float phi[], const float mc[], float j[]) {
    furiko_ellipjinc_mc_vf(count, n, phi, mc, j);
}
/** @} */

/* ---- Bulirsch's cel ---- */

/** Bulirsch's general complete elliptic integral. @{ */
inline double bulirsch_cel(double kc, double p, double a, double b) { return furiko_bulirsch_cel(kc, p, a, b); }
inline void bulirsch_cel(std::size_t count, const double kc[], const double p[], const double a[],
        const double b[], double f[]) {
    furiko_bulirsch_cel_v(count, kc, p, a, b, f);
}
inline float bulirsch_cel(float kc, float p, float a, float b) { return furiko_bulirsch_celf(kc, p, a, b); }
inline void bulirsch_cel(std::size_t count, const float kc[], const float p[], const float a[],
        const float b[], float f[]) {
    furiko_bulirsch_cel_vf(count, kc, p, a, b, f);
}
/** @} */

/* ---- Carlson's integrals ---- */

/** Carlson's integral of the first kind. @{ */
inline double carlson_rf(double x, double y, double z) { return furiko_carlson_rf(x, y, z); }
inline void carlson_rf(std::size_t count, const double x[], const double y[], const double z[], double rf[]) {
    furiko_carlson_rf_v(count, x, y, z, rf);
}
inline float carlson_rf(float x, float y, float z) { return furiko_carlson_rff(x, y, z); }
inline void carlson_rf(std::size_t count, const float x[], const float y[], const float z[], float rf[]) {
    furiko_carlson_rf_vf(count, x, y, z, rf);
}
/** @} */

/** Carlson's degenerate integral R_C(x,y) = R_F(x,y,y). @{ */
inline double carlson_rc(double x, double y) { return furiko_carlson_rc(x, y); }
inline void carlson_rc(std::size_t count, const double x[], const double y[], double rc[]) {
    furiko_carlson_rc_v(count, x, y, rc);
}
inline float carlson_rc(float x, float y) { return furiko_carlson_rcf(x, y); }
inline void carlson_rc(std::size_t count, const float x[], const float y[], float rc[]) {
    furiko_carlson_rc_vf(count, x, y, rc);
}
/** @} */

/** Carlson's integral of the second kind, R_D(x,y,z) = R_J(x,y,z,z). @{ */
inline double carlson_rd(double x, double y, double z) { return furiko_carlson_rd(x, y, z); }
inline void carlson_rd(std::size_t count, const double x[], const double y[], const double z[], double rd[]) {
    furiko_carlson_rd_v(count, x, y, z, rd);
}
inline float carlson_rd(float x, float y, float z) { return furiko_carlson_rdf(x, y, z); }
inline void carlson_rd(std::size_t count, const float x[], const float y[], const float z[], float rd[]) {
    furiko_carlson_rd_vf(count, x, y, z, rd);
}
/** @} */

/** Carlson's integral of the third kind. @{ */
inline double carlson_rj(double x, double y, double z, double p) { return furiko_carlson_rj(x, y, z, p); }
inline void carlson_rj(std::size_t count, const double x[], const double y[], const double z[],
        const double p[], double rj[]) {
    furiko_carlson_rj_v(count, x, y, z, p, rj);
}
inline float carlson_rj(float x, float y, float z, float p) { return furiko_carlson_rjf(x, y, z, p); }
inline void carlson_rj(std::size_t count, const float x[], const float y[], const float z[], const float p[],
        float rj[]) {
    furiko_carlson_rj_vf(count, x, y, z, p, rj);
}
/** @} */

/** Carlson's symmetric integral of the second kind. @{ */
inline double carlson_rg(double x, double y, double z) { return furiko_carlson_rg(x, y, z); }
inline void carlson_rg(std::size_t count, const double x[], const double y[], const double z[], double rg[]) {
    furiko_carlson_rg_v(count, x, y, z, rg);
}
inline float carlson_rg(float x, float y, float z) { return furiko_carlson_rgf(x, y, z); }
inline void carlson_rg(std::size_t count, const float x[], const float y[], const float z[], float rg[]) {
    furiko_carlson_rg_vf(count, x, y, z, rg);
}
/** @} */

/* ---- The nome ---- */

/** Jacobi's nome. @{ */
inline double nome_k(double k) { return furiko_nome_k(k); }
inline void nome_k(std::size_t count, const double k[], double q[]) {
    furiko_nome_k_v(count, k, q);
}
inline float nome_k(float k) { return furiko_nome_kf(k); }
inline void nome_k(std::size_t count, const float k[], float q[]) {
    furiko_nome_k_vf(count, k, q);
}
/** @} */

/** Jacobi's nome. @{ */
inline double nome_m(double m) { return furiko_nome_m(m); }
inline void nome_m(std::size_t count, const double m[], double q[]) {
    furiko_nome_m_v(count, m, q);
}
inline float nome_m(float m) { return furiko_nome_mf(m); }
inline void nome_m(std::size_t count, const float m[], float q[]) {
    furiko_nome_m_vf(count, m, q);
}
/** @} */

/** Jacobi's nome. @{ */
inline double nome_mc(double mc) { return furiko_nome_mc(mc); }
inline void nome_mc(std::size_t count, const double mc[], double q[]) {
    furiko_nome_mc_v(count, mc, q);
}
inline float nome_mc(float mc) { return furiko_nome_mcf(mc); }
inline void nome_mc(std::size_t count, const float mc[], float q[]) {
    furiko_nome_mc_vf(count, mc, q);
}
/** @} */

/** The parameter m of Jacobi's nome q. @{ */
inline double parameter_from_nome(double q) { return furiko_parameter_from_nome(q); }
inline void parameter_from_nome(std::size_t count, const double q[], double m[]) {
    furiko_parameter_from_nome_v(count, q, m);
}
inline float parameter_from_nome(float q) { return furiko_parameter_from_nomef(q); }
inline void parameter_from_nome(std::size_t count, const float q[], float m[]) {
    furiko_parameter_from_nome_vf(count, q, m);
}
/** @} */

/** The complementary parameter mc = 1 - m of Jacobi's nome q. @{ */
inline double complementary_parameter_from_nome(double q) { return furiko_complementary_parameter_from_nome(q); }
inline void complementary_parameter_from_nome(std::size_t count, const double q[], double mc[]) {
    furiko_complementary_parameter_from_nome_v(count, q, mc);
}
inline float complementary_parameter_from_nome(float q) { return furiko_complementary_parameter_from_nomef(q); }
inline void complementary_parameter_from_nome(std::size_t count, const float q[], float mc[]) {
    furiko_complementary_parameter_from_nome_vf(count, q, mc);
}
/** @} */

/* ---- Theta functions ---- */

/** Jacobi's theta function theta_1. @{ */
inline double theta1(double z, double q) { return furiko_theta1(z, q); }
inline void theta1(std::size_t count, const double z[], const double q[], double theta1[]) {
    furiko_theta1_v(count, z, q, theta1);
}
inline float theta1(float z, float q) { return furiko_theta1f(z, q); }
inline void theta1(std::size_t count, const float z[], const float q[], float theta1[]) {
    furiko_theta1_vf(count, z, q, theta1);
}
/** @} */

/** Jacobi's theta function theta_2. @{ */
inline double theta2(double z, double q) { return furiko_theta2(z, q); }
inline void theta2(std::size_t count, const double z[], const double q[], double theta2[]) {
    furiko_theta2_v(count, z, q, theta2);
}
inline float theta2(float z, float q) { return furiko_theta2f(z, q); }
inline void theta2(std::size_t count, const float z[], const float q[], float theta2[]) {
    furiko_theta2_vf(count, z, q, theta2);
}
/** @} */

/** Jacobi's theta function theta_3. @{ */
inline double theta3(double z, double q) { return furiko_theta3(z, q); }
inline void theta3(std::size_t count, const double z[], const double q[], double theta3[]) {
    furiko_theta3_v(count, z, q, theta3);
}
inline float theta3(float z, float q) { return furiko_theta3f(z, q); }
inline void theta3(std::size_t count, const float z[], const float q[], float theta3[]) {
    furiko_theta3_vf(count, z, q, theta3);
}
/** @} */

/** Jacobi's theta function theta_4. @{ */
inline double theta4(double z, double q) { return furiko_theta4(z, q); }
inline void theta4(std::size_t count, const double z[], const double q[], double theta4[]) {
    furiko_theta4_v(count, z, q, theta4);
}
inline float theta4(float z, float q) { return furiko_theta4f(z, q); }
inline void theta4(std::size_t count, const float z[], const float q[], float theta4[]) {
    furiko_theta4_vf(count, z, q, theta4);
}
/** @} */

/** Derivative of theta1 with respect to z. @{ */
inline double theta1_prime(double z, double q) { return furiko_theta1_prime(z, q); }
inline void theta1_prime(std::size_t count, const double z[], const double q[], double theta1_prime[]) {
    furiko_theta1_prime_v(count, z, q, theta1_prime);
}
inline float theta1_prime(float z, float q) { return furiko_theta1_primef(z, q); }
inline void theta1_prime(std::size_t count, const float z[], const float q[], float theta1_prime[]) {
    furiko_theta1_prime_vf(count, z, q, theta1_prime);
}
/** @} */

/** Derivative of theta2 with respect to z. @{ */
inline double theta2_prime(double z, double q) { return furiko_theta2_prime(z, q); }
inline void theta2_prime(std::size_t count, const double z[], const double q[], double theta2_prime[]) {
    furiko_theta2_prime_v(count, z, q, theta2_prime);
}
inline float theta2_prime(float z, float q) { return furiko_theta2_primef(z, q); }
inline void theta2_prime(std::size_t count, const float z[], const float q[], float theta2_prime[]) {
    furiko_theta2_prime_vf(count, z, q, theta2_prime);
}
/** @} */

/** Derivative of theta3 with respect to z. @{ */
inline double theta3_prime(double z, double q) { return furiko_theta3_prime(z, q); }
inline void theta3_prime(std::size_t count, const double z[], const double q[], double theta3_prime[]) {
    furiko_theta3_prime_v(count, z, q, theta3_prime);
}
inline float theta3_prime(float z, float q) { return furiko_theta3_primef(z, q); }
inline void theta3_prime(std::size_t count, const float z[], const float q[], float theta3_prime[]) {
    furiko_theta3_prime_vf(count, z, q, theta3_prime);
}
/** @} */

/** Derivative of theta4 with respect to z. @{ */
inline double theta4_prime(double z, double q) { return furiko_theta4_prime(z, q); }
inline void theta4_prime(std::size_t count, const double z[], const double q[], double theta4_prime[]) {
    furiko_theta4_prime_v(count, z, q, theta4_prime);
}
inline float theta4_prime(float z, float q) { return furiko_theta4_primef(z, q); }
inline void theta4_prime(std::size_t count, const float z[], const float q[], float theta4_prime[]) {
    furiko_theta4_prime_vf(count, z, q, theta4_prime);
}
/** @} */

/* ---- Jacobi elliptic functions ---- */

/** The Jacobi elliptic functions sn, cn and dn. @{ */
inline void jacobi_k(double u, double k, double &sn, double &cn, double &dn) {
    furiko_jacobi_k(u, k, &sn, &cn, &dn);
}
inline void jacobi_k(std::size_t count, const double u[], const double k[], double sn[], double cn[],
        double dn[]) {
    furiko_jacobi_k_v(count, u, k, sn, cn, dn);
}
inline void jacobi_k(float u, float k, float &sn, float &cn, float &dn) {
    furiko_jacobi_kf(u, k, &sn, &cn, &dn);
}
inline void jacobi_k(std::size_t count, const float u[], const float k[], float sn[], float cn[],
        float dn[]) {
    furiko_jacobi_k_vf(count, u, k, sn, cn, dn);
}
/** @} */

/** The Jacobi elliptic functions sn, cn and dn. @{ */
inline void jacobi_m(double u, double m, double &sn, double &cn, double &dn) {
    furiko_jacobi_m(u, m, &sn, &cn, &dn);
}
inline void jacobi_m(std::size_t count, const double u[], const double m[], double sn[], double cn[],
        double dn[]) {
    furiko_jacobi_m_v(count, u, m, sn, cn, dn);
}
inline void jacobi_m(float u, float m, float &sn, float &cn, float &dn) {
    furiko_jacobi_mf(u, m, &sn, &cn, &dn);
}
inline void jacobi_m(std::size_t count, const float u[], const float m[], float sn[], float cn[],
        float dn[]) {
    furiko_jacobi_m_vf(count, u, m, sn, cn, dn);
}
/** @} */

/** The Jacobi elliptic functions sn, cn and dn. @{ */
inline void jacobi_mc(double u, double mc, double &sn, double &cn, double &dn) {
    furiko_jacobi_mc(u, mc, &sn, &cn, &dn);
}
inline void jacobi_mc(std::size_t count, const double u[], const double mc[], double sn[], double cn[],
        double dn[]) {
    furiko_jacobi_mc_v(count, u, mc, sn, cn, dn);
}
inline void jacobi_mc(float u, float mc, float &sn, float &cn, float &dn) {
    furiko_jacobi_mcf(u, mc, &sn, &cn, &dn);
}
inline void jacobi_mc(std::size_t count, const float u[], const float mc[], float sn[], float cn[],
        float dn[]) {
    furiko_jacobi_mc_vf(count, u, mc, sn, cn, dn);
}
/** @} */

/** Jacobi's amplitude. @{ */
inline double jacobi_am_k(double u, double k) { return furiko_jacobi_am_k(u, k); }
inline void jacobi_am_k(std::size_t count, const double u[], const double k[], double am[]) {
    furiko_jacobi_am_k_v(count, u, k, am);
}
inline float jacobi_am_k(float u, float k) { return furiko_jacobi_am_kf(u, k); }
inline void jacobi_am_k(std::size_t count, const float u[], const float k[], float am[]) {
    furiko_jacobi_am_k_vf(count, u, k, am);
}
/** @} */

/** Jacobi's amplitude. @{ */
inline double jacobi_am_m(double u, double m) { return furiko_jacobi_am_m(u, m); }
inline void jacobi_am_m(std::size_t count, const double u[], const double m[], double am[]) {
    furiko_jacobi_am_m_v(count, u, m, am);
}
inline float jacobi_am_m(float u, float m) { return furiko_jacobi_am_mf(u, m); }
inline void jacobi_am_m(std::size_t count, const float u[], const float m[], float am[]) {
    furiko_jacobi_am_m_vf(count, u, m, am);
}
/** @} */

/** Jacobi's amplitude. @{ */
inline double jacobi_am_mc(double u, double mc) { return furiko_jacobi_am_mc(u, mc); }
inline void jacobi_am_mc(std::size_t count, const double u[], const double mc[], double am[]) {
    furiko_jacobi_am_mc_v(count, u, mc, am);
}
inline float jacobi_am_mc(float u, float mc) { return furiko_jacobi_am_mcf(u, mc); }
inline void jacobi_am_mc(std::size_t count, const float u[], const float mc[], float am[]) {
    furiko_jacobi_am_mc_vf(count, u, mc, am);
}
/** @} */

/** Jacobi's sn. @{ */
inline double jacobi_sn_k(double u, double k) { return furiko_jacobi_sn_k(u, k); }
inline void jacobi_sn_k(std::size_t count, const double u[], const double k[], double sn[]) {
    furiko_jacobi_sn_k_v(count, u, k, sn);
}
inline float jacobi_sn_k(float u, float k) { return furiko_jacobi_sn_kf(u, k); }
inline void jacobi_sn_k(std::size_t count, const float u[], const float k[], float sn[]) {
    furiko_jacobi_sn_k_vf(count, u, k, sn);
}
/** @} */

/** Jacobi's sn. @{ */
inline double jacobi_sn_m(double u, double m) { return furiko_jacobi_sn_m(u, m); }
inline void jacobi_sn_m(std::size_t count, const double u[], const double m[], double sn[]) {
    furiko_jacobi_sn_m_v(count, u, m, sn);
}
inline float jacobi_sn_m(float u, float m) { return furiko_jacobi_sn_mf(u, m); }
inline void jacobi_sn_m(std::size_t count, const float u[], const float m[], float sn[]) {
    furiko_jacobi_sn_m_vf(count, u, m, sn);
}
/** @} */

/** Jacobi's sn. @{ */
inline double jacobi_sn_mc(double u, double mc) { return furiko_jacobi_sn_mc(u, mc); }
inline void jacobi_sn_mc(std::size_t count, const double u[], const double mc[], double sn[]) {
    furiko_jacobi_sn_mc_v(count, u, mc, sn);
}
inline float jacobi_sn_mc(float u, float mc) { return furiko_jacobi_sn_mcf(u, mc); }
inline void jacobi_sn_mc(std::size_t count, const float u[], const float mc[], float sn[]) {
    furiko_jacobi_sn_mc_vf(count, u, mc, sn);
}
/** @} */

/** Jacobi's cn. @{ */
inline double jacobi_cn_k(double u, double k) { return furiko_jacobi_cn_k(u, k); }
inline void jacobi_cn_k(std::size_t count, const double u[], const double k[], double cn[]) {
    furiko_jacobi_cn_k_v(count, u, k, cn);
}
inline float jacobi_cn_k(float u, float k) { return furiko_jacobi_cn_kf(u, k); }
inline void jacobi_cn_k(std::size_t count, const float u[], const float k[], float cn[]) {
    furiko_jacobi_cn_k_vf(count, u, k, cn);
}
/** @} */

/** Jacobi's cn. @{ */
inline double jacobi_cn_m(double u, double m) { return furiko_jacobi_cn_m(u, m); }
inline void jacobi_cn_m(std::size_t count, const double u[], const double m[], double cn[]) {
    furiko_jacobi_cn_m_v(count, u, m, cn);
}
inline float jacobi_cn_m(float u, float m) { return furiko_jacobi_cn_mf(u, m); }
inline void jacobi_cn_m(std::size_t count, const float u[], const float m[], float cn[]) {
    furiko_jacobi_cn_m_vf(count, u, m, cn);
}
/** @} */

/** Jacobi's cn. @{ */
inline double jacobi_cn_mc(double u, double mc) { return furiko_jacobi_cn_mc(u, mc); }
inline void jacobi_cn_mc(std::size_t count, const double u[], const double mc[], double cn[]) {
    furiko_jacobi_cn_mc_v(count, u, mc, cn);
}
inline float jacobi_cn_mc(float u, float mc) { return furiko_jacobi_cn_mcf(u, mc); }
inline void jacobi_cn_mc(std::size_t count, const float u[], const float mc[], float cn[]) {
    furiko_jacobi_cn_mc_vf(count, u, mc, cn);
}
/** @} */

/** Jacobi's dn. @{ */
inline double jacobi_dn_k(double u, double k) { return furiko_jacobi_dn_k(u, k); }
inline void jacobi_dn_k(std::size_t count, const double u[], const double k[], double dn[]) {
    furiko_jacobi_dn_k_v(count, u, k, dn);
}
inline float jacobi_dn_k(float u, float k) { return furiko_jacobi_dn_kf(u, k); }
inline void jacobi_dn_k(std::size_t count, const float u[], const float k[], float dn[]) {
    furiko_jacobi_dn_k_vf(count, u, k, dn);
}
/** @} */

/** Jacobi's dn. @{ */
inline double jacobi_dn_m(double u, double m) { return furiko_jacobi_dn_m(u, m); }
inline void jacobi_dn_m(std::size_t count, const double u[], const double m[], double dn[]) {
    furiko_jacobi_dn_m_v(count, u, m, dn);
}
inline float jacobi_dn_m(float u, float m) { return furiko_jacobi_dn_mf(u, m); }
inline void jacobi_dn_m(std::size_t count, const float u[], const float m[], float dn[]) {
    furiko_jacobi_dn_m_vf(count, u, m, dn);
}
/** @} */

/** Jacobi's dn. @{ */
inline double jacobi_dn_mc(double u, double mc) { return furiko_jacobi_dn_mc(u, mc); }
inline void jacobi_dn_mc(std::size_t count, const double u[], const double mc[], double dn[]) {
    furiko_jacobi_dn_mc_v(count, u, mc, dn);
}
inline float jacobi_dn_mc(float u, float mc) { return furiko_jacobi_dn_mcf(u, mc); }
inline void jacobi_dn_mc(std::size_t count, const float u[], const float mc[], float dn[]) {
    furiko_jacobi_dn_mc_vf(count, u, mc, dn);
}
/** @} */

/** Jacobi's ns = 1/sn. @{ */
inline double jacobi_ns_k(double u, double k) { return furiko_jacobi_ns_k(u, k); }
inline void jacobi_ns_k(std::size_t count, const double u[], const double k[], double ns[]) {
    furiko_jacobi_ns_k_v(count, u, k, ns);
}
inline float jacobi_ns_k(float u, float k) { return furiko_jacobi_ns_kf(u, k); }
inline void jacobi_ns_k(std::size_t count, const float u[], const float k[], float ns[]) {
    furiko_jacobi_ns_k_vf(count, u, k, ns);
}
/** @} */

/** Jacobi's ns = 1/sn. @{ */
inline double jacobi_ns_m(double u, double m) { return furiko_jacobi_ns_m(u, m); }
inline void jacobi_ns_m(std::size_t count, const double u[], const double m[], double ns[]) {
    furiko_jacobi_ns_m_v(count, u, m, ns);
}
inline float jacobi_ns_m(float u, float m) { return furiko_jacobi_ns_mf(u, m); }
inline void jacobi_ns_m(std::size_t count, const float u[], const float m[], float ns[]) {
    furiko_jacobi_ns_m_vf(count, u, m, ns);
}
/** @} */

/** Jacobi's ns = 1/sn. @{ */
inline double jacobi_ns_mc(double u, double mc) { return furiko_jacobi_ns_mc(u, mc); }
inline void jacobi_ns_mc(std::size_t count, const double u[], const double mc[], double ns[]) {
    furiko_jacobi_ns_mc_v(count, u, mc, ns);
}
inline float jacobi_ns_mc(float u, float mc) { return furiko_jacobi_ns_mcf(u, mc); }
inline void jacobi_ns_mc(std::size_t count, const float u[], const float mc[], float ns[]) {
    furiko_jacobi_ns_mc_vf(count, u, mc, ns);
}
/** @} */

/** Jacobi's nc = 1/cn. @{ */
inline double jacobi_nc_k(double u, double k) { return furiko_jacobi_nc_k(u, k); }
inline void jacobi_nc_k(std::size_t count, const double u[], const double k[], double nc[]) {
    furiko_jacobi_nc_k_v(count, u, k, nc);
}
inline float jacobi_nc_k(float u, float k) { return furiko_jacobi_nc_kf(u, k); }
inline void jacobi_nc_k(std::size_t count, const float u[], const float k[], float nc[]) {
    furiko_jacobi_nc_k_vf(count, u, k, nc);
}
/** @} */

/** Jacobi's nc = 1/cn. @{ */
inline double jacobi_nc_m(double u, double m) { return furiko_jacobi_nc_m(u, m); }
inline void jacobi_nc_m(std::size_t count, const double u[], const double m[], double nc[]) {
    furiko_jacobi_nc_m_v(count, u, m, nc);
}
inline float jacobi_nc_m(float u, float m) { return furiko_jacobi_nc_mf(u, m); }
inline void jacobi_nc_m(std::size_t count, const float u[], const float m[], float nc[]) {
    furiko_jacobi_nc_m_vf(count, u, m, nc);
}
/** @} */

/** Jacobi's nc = 1/cn. @{ */
inline double jacobi_nc_mc(double u, double mc) { return furiko_jacobi_nc_mc(u, mc); }
inline void jacobi_nc_mc(std::size_t count, const double u[], const double mc[], double nc[]) {
    furiko_jacobi_nc_mc_v(count, u, mc, nc);
}
inline float jacobi_nc_mc(float u, float mc) { return furiko_jacobi_nc_mcf(u, mc); }
inline void jacobi_nc_mc(std::size_t count, const float u[], const float mc[], float nc[]) {
    furiko_jacobi_nc_mc_vf(count, u, mc, nc);
}
/** @} */

/** Jacobi's nd = 1/dn. @{ */
inline double jacobi_nd_k(double u, double k) { return furiko_jacobi_nd_k(u, k); }
inline void jacobi_nd_k(std::size_t count, const double u[], const double k[], double nd[]) {
    furiko_jacobi_nd_k_v(count, u, k, nd);
}
inline float jacobi_nd_k(float u, float k) { return furiko_jacobi_nd_kf(u, k); }
inline void jacobi_nd_k(std::size_t count, const float u[], const float k[], float nd[]) {
    furiko_jacobi_nd_k_vf(count, u, k, nd);
}
/** @} */

/** Jacobi's nd = 1/dn. @{ */
inline double jacobi_nd_m(double u, double m) { return furiko_jacobi_nd_m(u, m); }
inline void jacobi_nd_m(std::size_t count, const double u[], const double m[], double nd[]) {
    furiko_jacobi_nd_m_v(count, u, m, nd);
}
inline float jacobi_nd_m(float u, float m) { return furiko_jacobi_nd_mf(u, m); }
inline void jacobi_nd_m(std::size_t count, const float u[], const float m[], float nd[]) {
    furiko_jacobi_nd_m_vf(count, u, m, nd);
}
/** @} */

/** Jacobi's nd = 1/dn. @{ */
inline double jacobi_nd_mc(double u, double mc) { return furiko_jacobi_nd_mc(u, mc); }
inline void jacobi_nd_mc(std::size_t count, const double u[], const double mc[], double nd[]) {
    furiko_jacobi_nd_mc_v(count, u, mc, nd);
}
inline float jacobi_nd_mc(float u, float mc) { return furiko_jacobi_nd_mcf(u, mc); }
inline void jacobi_nd_mc(std::size_t count, const float u[], const float mc[], float nd[]) {
    furiko_jacobi_nd_mc_vf(count, u, mc, nd);
}
/** @} */

/** Jacobi's sc = sn/cn. @{ */
inline double jacobi_sc_k(double u, double k) { return furiko_jacobi_sc_k(u, k); }
inline void jacobi_sc_k(std::size_t count, const double u[], const double k[], double sc[]) {
    furiko_jacobi_sc_k_v(count, u, k, sc);
}
inline float jacobi_sc_k(float u, float k) { return furiko_jacobi_sc_kf(u, k); }
inline void jacobi_sc_k(std::size_t count, const float u[], const float k[], float sc[]) {
    furiko_jacobi_sc_k_vf(count, u, k, sc);
}
/** @} */

/** Jacobi's sc = sn/cn. @{ */
inline double jacobi_sc_m(double u, double m) { return furiko_jacobi_sc_m(u, m); }
inline void jacobi_sc_m(std::size_t count, const double u[], const double m[], double sc[]) {
    furiko_jacobi_sc_m_v(count, u, m, sc);
}
inline float jacobi_sc_m(float u, float m) { return furiko_jacobi_sc_mf(u, m); }
inline void jacobi_sc_m(std::size_t count, const float u[], const float m[], float sc[]) {
    furiko_jacobi_sc_m_vf(count, u, m, sc);
}
/** @} */

/** Jacobi's sc = sn/cn. @{ */
inline double jacobi_sc_mc(double u, double mc) { return furiko_jacobi_sc_mc(u, mc); }
inline void jacobi_sc_mc(std::size_t count, const double u[], const double mc[], double sc[]) {
    furiko_jacobi_sc_mc_v(count, u, mc, sc);
}
inline float jacobi_sc_mc(float u, float mc) { return furiko_jacobi_sc_mcf(u, mc); }
inline void jacobi_sc_mc(std::size_t count, const float u[], const float mc[], float sc[]) {
    furiko_jacobi_sc_mc_vf(count, u, mc, sc);
}
/** @} */

/** Jacobi's cs = cn/sn. @{ */
inline double jacobi_cs_k(double u, double k) { return furiko_jacobi_cs_k(u, k); }
inline void jacobi_cs_k(std::size_t count, const double u[], const double k[], double cs[]) {
    furiko_jacobi_cs_k_v(count, u, k, cs);
}
inline float jacobi_cs_k(float u, float k) { return furiko_jacobi_cs_kf(u, k); }
inline void jacobi_cs_k(std::size_t count, const float u[], const float k[], float cs[]) {
    furiko_jacobi_cs_k_vf(count, u, k, cs);
}
/** @} */

/** Jacobi's cs = cn/sn. @{ */
inline double jacobi_cs_m(double u, double m) { return furiko_jacobi_cs_m(u, m); }
inline void jacobi_cs_m(std::size_t count, const double u[], const double m[], double cs[]) {
    furiko_jacobi_cs_m_v(count, u, m, cs);
}
inline float jacobi_cs_m(float u, float m) { return furiko_jacobi_cs_mf(u, m); }
inline void jacobi_cs_m(std::size_t count, const float u[], const float m[], float cs[]) {
    furiko_jacobi_cs_m_vf(count, u, m, cs);
}
/** @} */

/** Jacobi's cs = cn/sn. @{ */
inline double jacobi_cs_mc(double u, double mc) { return furiko_jacobi_cs_mc(u, mc); }
inline void jacobi_cs_mc(std::size_t count, const double u[], const double mc[], double cs[]) {
    furiko_jacobi_cs_mc_v(count, u, mc, cs);
}
inline float jacobi_cs_mc(float u, float mc) { return furiko_jacobi_cs_mcf(u, mc); }
inline void jacobi_cs_mc(std::size_t count, const float u[], const float mc[], float cs[]) {
    furiko_jacobi_cs_mc_vf(count, u, mc, cs);
}
/** @} */

/** Jacobi's sd = sn/dn. @{ */
inline double jacobi_sd_k(double u, double k) { return furiko_jacobi_sd_k(u, k); }
inline void jacobi_sd_k(std::size_t count, const double u[], const double k[], double sd[]) {
    furiko_jacobi_sd_k_v(count, u, k, sd);
}
inline float jacobi_sd_k(float u, float k) { return furiko_jacobi_sd_kf(u, k); }
inline void jacobi_sd_k(std::size_t count, const float u[], const float k[], float sd[]) {
    furiko_jacobi_sd_k_vf(count, u, k, sd);
}
/** @} */

/** Jacobi's sd = sn/dn. @{ */
inline double jacobi_sd_m(double u, double m) { return furiko_jacobi_sd_m(u, m); }
inline void jacobi_sd_m(std::size_t count, const double u[], const double m[], double sd[]) {
    furiko_jacobi_sd_m_v(count, u, m, sd);
}
inline float jacobi_sd_m(float u, float m) { return furiko_jacobi_sd_mf(u, m); }
inline void jacobi_sd_m(std::size_t count, const float u[], const float m[], float sd[]) {
    furiko_jacobi_sd_m_vf(count, u, m, sd);
}
/** @} */

/** Jacobi's sd = sn/dn. @{ */
inline double jacobi_sd_mc(double u, double mc) { return furiko_jacobi_sd_mc(u, mc); }
inline void jacobi_sd_mc(std::size_t count, const double u[], const double mc[], double sd[]) {
    furiko_jacobi_sd_mc_v(count, u, mc, sd);
}
inline float jacobi_sd_mc(float u, float mc) { return furiko_jacobi_sd_mcf(u, mc); }
inline void jacobi_sd_mc(std::size_t count, const float u[], const float mc[], float sd[]) {
    furiko_jacobi_sd_mc_vf(count, u, mc, sd);
}
/** @} */

/** Jacobi's ds = dn/sn. @{ */
inline double jacobi_ds_k(double u, double k) { return furiko_jacobi_ds_k(u, k); }
inline void jacobi_ds_k(std::size_t count, const double u[], const double k[], double ds[]) {
    furiko_jacobi_ds_k_v(count, u, k, ds);
}
inline float jacobi_ds_k(float u, float k) { return furiko_jacobi_ds_kf(u, k); }
inline void jacobi_ds_k(std::size_t count, const float u[], const float k[], float ds[]) {
    furiko_jacobi_ds_k_vf(count, u, k, ds);
}
/** @} */

/** Jacobi's ds = dn/sn. @{ */
inline double jacobi_ds_m(double u, double m) { return furiko_jacobi_ds_m(u, m); }
inline void jacobi_ds_m(std::size_t count, const double u[], const double m[], double ds[]) {
    furiko_jacobi_ds_m_v(count, u, m, ds);
}
inline float jacobi_ds_m(float u, float m) { return furiko_jacobi_ds_mf(u, m); }
inline void jacobi_ds_m(std::size_t count, const float u[], const float m[], float ds[]) {
    furiko_jacobi_ds_m_vf(count, u, m, ds);
}
/** @} */

/** Jacobi's ds = dn/sn. @{ */
inline double jacobi_ds_mc(double u, double mc) { return furiko_jacobi_ds_mc(u, mc); }
inline void jacobi_ds_mc(std::size_t count, const double u[], const double mc[], double ds[]) {
    furiko_jacobi_ds_mc_v(count, u, mc, ds);
}
inline float jacobi_ds_mc(float u, float mc) { return furiko_jacobi_ds_mcf(u, mc); }
inline void jacobi_ds_mc(std::size_t count, const float u[], const float mc[], float ds[]) {
    furiko_jacobi_ds_mc_vf(count, u, mc, ds);
}
/** @} */

/** Jacobi's cd = cn/dn. @{ */
inline double jacobi_cd_k(double u, double k) { return furiko_jacobi_cd_k(u, k); }
inline void jacobi_cd_k(std::size_t count, const double u[], const double k[], double cd[]) {
    furiko_jacobi_cd_k_v(count, u, k, cd);
}
inline float jacobi_cd_k(float u, float k) { return furiko_jacobi_cd_kf(u, k); }
inline void jacobi_cd_k(std::size_t count, const float u[], const float k[], float cd[]) {
    furiko_jacobi_cd_k_vf(count, u, k, cd);
}
/** @} */

/** Jacobi's cd = cn/dn. @{ */
inline double jacobi_cd_m(double u, double m) { return furiko_jacobi_cd_m(u, m); }
inline void jacobi_cd_m(std::size_t count, const double u[], const double m[], double cd[]) {
    furiko_jacobi_cd_m_v(count, u, m, cd);
}
inline float jacobi_cd_m(float u, float m) { return furiko_jacobi_cd_mf(u, m); }
inline void jacobi_cd_m(std::size_t count, const float u[], const float m[], float cd[]) {
    furiko_jacobi_cd_m_vf(count, u, m, cd);
}
/** @} */

/** Jacobi's cd = cn/dn. @{ */
inline double jacobi_cd_mc(double u, double mc) { return furiko_jacobi_cd_mc(u, mc); }
inline void jacobi_cd_mc(std::size_t count, const double u[], const double mc[], double cd[]) {
    furiko_jacobi_cd_mc_v(count, u, mc, cd);
}
inline float jacobi_cd_mc(float u, float mc) { return furiko_jacobi_cd_mcf(u, mc); }
inline void jacobi_cd_mc(std::size_t count, const float u[], const float mc[], float cd[]) {
    furiko_jacobi_cd_mc_vf(count, u, mc, cd);
}
/** @} */

/** Jacobi's dc = dn/cn. @{ */
inline double jacobi_dc_k(double u, double k) { return furiko_jacobi_dc_k(u, k); }
inline void jacobi_dc_k(std::size_t count, const double u[], const double k[], double dc[]) {
    furiko_jacobi_dc_k_v(count, u, k, dc);
}
inline float jacobi_dc_k(float u, float k) { return furiko_jacobi_dc_kf(u, k); }
inline void jacobi_dc_k(std::size_t count, const float u[], const float k[], float dc[]) {
    furiko_jacobi_dc_k_vf(count, u, k, dc);
}
/** @} */

/** Jacobi's dc = dn/cn. @{ */
inline double jacobi_dc_m(double u, double m) { return furiko_jacobi_dc_m(u, m); }
inline void jacobi_dc_m(std::size_t count, const double u[], const double m[], double dc[]) {
    furiko_jacobi_dc_m_v(count, u, m, dc);
}
inline float jacobi_dc_m(float u, float m) { return furiko_jacobi_dc_mf(u, m); }
inline void jacobi_dc_m(std::size_t count, const float u[], const float m[], float dc[]) {
    furiko_jacobi_dc_m_vf(count, u, m, dc);
}
/** @} */

/** Jacobi's dc = dn/cn. @{ */
inline double jacobi_dc_mc(double u, double mc) { return furiko_jacobi_dc_mc(u, mc); }
inline void jacobi_dc_mc(std::size_t count, const double u[], const double mc[], double dc[]) {
    furiko_jacobi_dc_mc_v(count, u, mc, dc);
}
inline float jacobi_dc_mc(float u, float mc) { return furiko_jacobi_dc_mcf(u, mc); }
inline void jacobi_dc_mc(std::size_t count, const float u[], const float mc[], float dc[]) {
    furiko_jacobi_dc_mc_vf(count, u, mc, dc);
}
/** @} */

/* ---- Jacobi's epsilon ---- */

/** Jacobi's epsilon. @{ */
inline double jacobi_epsilon_k(double u, double k) { return furiko_jacobi_epsilon_k(u, k); }
inline void jacobi_epsilon_k(std::size_t count, const double u[], const double k[], double epsilon[]) {
    furiko_jacobi_epsilon_k_v(count, u, k, epsilon);
}
inline float jacobi_epsilon_k(float u, float k) { return furiko_jacobi_epsilon_kf(u, k); }
inline void jacobi_epsilon_k(std::size_t count, const float u[], const float k[], float epsilon[]) {
    furiko_jacobi_epsilon_k_vf(count, u, k, epsilon);
}
/** @} */

/** Jacobi's epsilon. @{ */
inline double jacobi_epsilon_m(double u, double m) { return furiko_jacobi_epsilon_m(u, m); }
inline void jacobi_epsilon_m(std::size_t count, const double u[], const double m[], double epsilon[]) {
    furiko_jacobi_epsilon_m_v(count, u, m, epsilon);
}
inline float jacobi_epsilon_m(float u, float m) { return furiko_jacobi_epsilon_mf(u, m); }
inline void jacobi_epsilon_m(std::size_t count, const float u[], const float m[], float epsilon[]) {
    furiko_jacobi_epsilon_m_vf(count, u, m, epsilon);
}
/** @} */

/** Jacobi's epsilon. @{ */
inline double jacobi_epsilon_mc(double u, double mc) { return furiko_jacobi_epsilon_mc(u, mc); }
inline void jacobi_epsilon_mc(std::size_t count, const double u[], const double mc[], double epsilon[]) {
    furiko_jacobi_epsilon_mc_v(count, u, mc, epsilon);
}
inline float jacobi_epsilon_mc(float u, float mc) { return furiko_jacobi_epsilon_mcf(u, mc); }
inline void jacobi_epsilon_mc(std::size_t count, const float u[], const float mc[], float epsilon[]) {
    furiko_jacobi_epsilon_mc_vf(count, u, mc, epsilon);
}
/** @} */

/* ---- Inverses of Jacobi's functions ---- */

/** The u with sn(u|m) = x. @{ */
inline double jacobi_arcsn_k(double x, double k) { return furiko_jacobi_arcsn_k(x, k); }
inline void jacobi_arcsn_k(std::size_t count, const double x[], const double k[], double u[]) {
    furiko_jacobi_arcsn_k_v(count, x, k, u);
}
inline float jacobi_arcsn_k(float x, float k) { return furiko_jacobi_arcsn_kf(x, k); }
inline void jacobi_arcsn_k(std::size_t count, const float x[], const float k[], float u[]) {
    furiko_jacobi_arcsn_k_vf(count, x, k, u);
}
/** @} */

/** The u with sn(u|m) = x. @{ */
inline double jacobi_arcsn_m(double x, double m) { return furiko_jacobi_arcsn_m(x, m); }
inline void jacobi_arcsn_m(std::size_t count, const double x[], const double m[], double u[]) {
    furiko_jacobi_arcsn_m_v(count, x, m, u);
}
inline float jacobi_arcsn_m(float x, float m) { return furiko_jacobi_arcsn_mf(x, m); }
inline void jacobi_arcsn_m(std::size_t count, const float x[], const float m[], float u[]) {
    furiko_jacobi_arcsn_m_vf(count, x, m, u);
}
/** @} */

/** The u with sn(u|m) = x. @{ */
inline double jacobi_arcsn_mc(double x, double mc) { return furiko_jacobi_arcsn_mc(x, mc); }
inline void jacobi_arcsn_mc(std::size_t count, const double x[], const double mc[], double u[]) {
    furiko_jacobi_arcsn_mc_v(count, x, mc, u);
}
inline float jacobi_arcsn_mc(float x, float mc) { return furiko_jacobi_arcsn_mcf(x, mc); }
inline void jacobi_arcsn_mc(std::size_t count, const float x[], const float mc[], float u[]) {
    furiko_jacobi_arcsn_mc_vf(count, x, mc, u);
}
/** @} */

/** The u with cn(u|m) = x. @{ */
inline double jacobi_arccn_k(double x, double k) { return furiko_jacobi_arccn_k(x, k); }
inline void jacobi_arccn_k(std::size_t count, const double x[], const double k[], double u[]) {
    furiko_jacobi_arccn_k_v(count, x, k, u);
}
inline float jacobi_arccn_k(float x, float k) { return furiko_jacobi_arccn_kf(x, k); }
inline void jacobi_arccn_k(std::size_t count, const float x[], const float k[], float u[]) {
    furiko_jacobi_arccn_k_vf(count, x, k, u);
}
/** @} */

/** The u with cn(u|m) = x. @{ */
inline double jacobi_arccn_m(double x, double m) { return furiko_jacobi_arccn_m(x, m); }
inline void jacobi_arccn_m(std::size_t count, const double x[], const double m[], double u[]) {
    furiko_jacobi_arccn_m_v(count, x, m, u);
}
inline float jacobi_arccn_m(float x, float m) { return furiko_jacobi_arccn_mf(x, m); }
inline void jacobi_arccn_m(std::size_t count, const float x[], const float m[], float u[]) {
    furiko_jacobi_arccn_m_vf(count, x, m, u);
}
/** @} */

/** The u with cn(u|m) = x. @{ */
inline double jacobi_arccn_mc(double x, double mc) { return furiko_jacobi_arccn_mc(x, mc); }
inline void jacobi_arccn_mc(std::size_t count, const double x[], const double mc[], double u[]) {
    furiko_jacobi_arccn_mc_v(count, x, mc, u);
}
inline float jacobi_arccn_mc(float x, float mc) { return furiko_jacobi_arccn_mcf(x, mc); }
inline void jacobi_arccn_mc(std::size_t count, const float x[], const float mc[], float u[]) {
    furiko_jacobi_arccn_mc_vf(count, x, mc, u);
}
/** @} */

/** The u with dn(u|m) = x. @{ */
inline double jacobi_arcdn_k(double x, double k) { return furiko_jacobi_arcdn_k(x, k); }
inline void jacobi_arcdn_k(std::size_t count, const double x[], const double k[], double u[]) {
    furiko_jacobi_arcdn_k_v(count, x, k, u);
}
inline float jacobi_arcdn_k(float x, float k) { return furiko_jacobi_arcdn_kf(x, k); }
inline void jacobi_arcdn_k(std::size_t count, const float x[], const float k[], float u[]) {
    furiko_jacobi_arcdn_k_vf(count, x, k, u);
}
/** @} */

/** The u with dn(u|m) = x. @{ */
inline double jacobi_arcdn_m(double x, double m) { return furiko_jacobi_arcdn_m(x, m); }
inline void jacobi_arcdn_m(std::size_t count, const double x[], const double m[], double u[]) {
    furiko_jacobi_arcdn_m_v(count, x, m, u);
}
inline float jacobi_arcdn_m(float x, float m) { return furiko_jacobi_arcdn_mf(x, m); }
inline void jacobi_arcdn_m(std::size_t count, const float x[], const float m[], float u[]) {
    furiko_jacobi_arcdn_m_vf(count, x, m, u);
}
/** @} */

/** The u with dn(u|m) = x. @{ */
inline double jacobi_arcdn_mc(double x, double mc) { return furiko_jacobi_arcdn_mc(x, mc); }
inline void jacobi_arcdn_mc(std::size_t count, const double x[], const double mc[], double u[]) {
    furiko_jacobi_arcdn_mc_v(count, x, mc, u);
}
inline float jacobi_arcdn_mc(float x, float mc) { return furiko_jacobi_arcdn_mcf(x, mc); }
inline void jacobi_arcdn_mc(std::size_t count, const float x[], const float mc[], float u[]) {
    furiko_jacobi_arcdn_mc_vf(count, x, mc, u);
}
/** @} */

/** The u with ns(u|m) = x. @{ */
inline double jacobi_arcns_k(double x, double k) { return furiko_jacobi_arcns_k(x, k); }
inline void jacobi_arcns_k(std::size_t count, const double x[], const double k[], double u[]) {
    furiko_jacobi_arcns_k_v(count, x, k, u);
}
inline float jacobi_arcns_k(float x, float k) { return furiko_jacobi_arcns_kf(x, k); }
inline void jacobi_arcns_k(std::size_t count, const float x[], const float k[], float u[]) {
    furiko_jacobi_arcns_k_vf(count, x, k, u);
}
/** @} */

/** The u with ns(u|m) = x. @{ */
inline double jacobi_arcns_m(double x, double m) { return furiko_jacobi_arcns_m(x, m); }
inline void jacobi_arcns_m(std::size_t count, const double x[], const double m[], double u[]) {
    furiko_jacobi_arcns_m_v(count, x, m, u);
}
inline float jacobi_arcns_m(float x, float m) { return furiko_jacobi_arcns_mf(x, m); }
inline void jacobi_arcns_m(std::size_t count, const float x[], const float m[], float u[]) {
    furiko_jacobi_arcns_m_vf(count, x, m, u);
}
/** @} */

/** The u with ns(u|m) = x. @{ */
inline double jacobi_arcns_mc(double x, double mc) { return furiko_jacobi_arcns_mc(x, mc); }
inline void jacobi_arcns_mc(std::size_t count, const double x[], const double mc[], double u[]) {
    furiko_jacobi_arcns_mc_v(count, x, mc, u);
}
inline float jacobi_arcns_mc(float x, float mc) { return furiko_jacobi_arcns_mcf(x, mc); }
inline void jacobi_arcns_mc(std::size_t count, const float x[], const float mc[], float u[]) {
    furiko_jacobi_arcns_mc_vf(count, x, mc, u);
}
/** @} */

/** The u with nc(u|m) = x. @{ */
inline double jacobi_arcnc_k(double x, double k) { return furiko_jacobi_arcnc_k(x, k); }
inline void jacobi_arcnc_k(std::size_t count, const double x[], const double k[], double u[]) {
    furiko_jacobi_arcnc_k_v(count, x, k, u);
}
inline float jacobi_arcnc_k(float x, float k) { return furiko_jacobi_arcnc_kf(x, k); }
inline void jacobi_arcnc_k(std::size_t count, const float x[], const float k[], float u[]) {
    furiko_jacobi_arcnc_k_vf(count, x, k, u);
}
/** @} */

/** The u with nc(u|m) = x. @{ */
inline double jacobi_arcnc_m(double x, double m) { return furiko_jacobi_arcnc_m(x, m); }
inline void jacobi_arcnc_m(std::size_t count, const double x[], const double m[], double u[]) {
    furiko_jacobi_arcnc_m_v(count, x, m, u);
}
inline float jacobi_arcnc_m(float x, float m) { return furiko_jacobi_arcnc_mf(x, m); }
inline void jacobi_arcnc_m(std::size_t count, const float x[], const float m[], float u[]) {
    furiko_jacobi_arcnc_m_vf(count, x, m, u);
}
/** @} */

/** The u with nc(u|m) = x. @{ */
inline double jacobi_arcnc_mc(double x, double mc) { return furiko_jacobi_arcnc_mc(x, mc); }
inline void jacobi_arcnc_mc(std::size_t count, const double x[], const double mc[], double u[]) {
    furiko_jacobi_arcnc_mc_v(count, x, mc, u);
}
inline float jacobi_arcnc_mc(float x, float mc) { return furiko_jacobi_arcnc_mcf(x, mc); }
inline void jacobi_arcnc_mc(std::size_t count, const float x[], const float mc[], float u[]) {
    furiko_jacobi_arcnc_mc_vf(count, x, mc, u);
}
/** @} */

/** The u with nd(u|m) = x. @{ */
inline double jacobi_arcnd_k(double x, double k) { return furiko_jacobi_arcnd_k(x, k); }
inline void jacobi_arcnd_k(std::size_t count, const double x[], const double k[], double u[]) {
    furiko_jacobi_arcnd_k_v(count, x, k, u);
}
inline float jacobi_arcnd_k(float x, float k) { return furiko_jacobi_arcnd_kf(x, k); }
inline void jacobi_arcnd_k(std::size_t count, const float x[], const float k[], float u[]) {
    furiko_jacobi_arcnd_k_vf(count, x, k, u);
}
/** @} */

/** The u with nd(u|m) = x. @{ */
inline double jacobi_arcnd_m(double x, double m) { return furiko_jacobi_arcnd_m(x, m); }
inline void jacobi_arcnd_m(std::size_t count, const double x[], const double m[], double u[]) {
    furiko_jacobi_arcnd_m_v(count, x, m, u);
}
inline float jacobi_arcnd_m(float x, float m) { return furiko_jacobi_arcnd_mf(x, m); }
inline void jacobi_arcnd_m(std::size_t count, const float x[], const float m[], float u[]) {
    furiko_jacobi_arcnd_m_vf(count, x, m, u);
}
/** @} */

/** The u with nd(u|m) = x. @{ */
inline double jacobi_arcnd_mc(double x, double mc) { return furiko_jacobi_arcnd_mc(x, mc); }
inline void jacobi_arcnd_mc(std::size_t count, const double x[], const double mc[], double u[]) {
    furiko_jacobi_arcnd_mc_v(count, x, mc, u);
}
inline float jacobi_arcnd_mc(float x, float mc) { return furiko_jacobi_arcnd_mcf(x, mc); }
inline void jacobi_arcnd_mc(std::size_t count, const float x[], const float mc[], float u[]) {
    furiko_jacobi_arcnd_mc_vf(count, x, mc, u);
}
/** @} */

/** The u with sc(u|m) = x. @{ */
inline double jacobi_arcsc_k(double x, double k) { return furiko_jacobi_arcsc_k(x, k); }
inline void jacobi_arcsc_k(std::size_t count, const double x[], const double k[], double u[]) {
    furiko_jacobi_arcsc_k_v(count, x, k, u);
}
inline float jacobi_arcsc_k(float x, float k) { return furiko_jacobi_arcsc_kf(x, k); }
inline void jacobi_arcsc_k(std::size_t count, const float x[], const float k[], float u[]) {
    furiko_jacobi_arcsc_k_vf(count, x, k, u);
}
/** @} */

/** The u with sc(u|m) = x. @{ */
inline double jacobi_arcsc_m(double x, double m) { return furiko_jacobi_arcsc_m(x, m); }
inline void jacobi_arcsc_m(std::size_t count, const double x[], const double m[], double u[]) {
    furiko_jacobi_arcsc_m_v(count, x, m, u);
}
inline float jacobi_arcsc_m(float x, float m) { return furiko_jacobi_arcsc_mf(x, m); }
inline void jacobi_arcsc_m(std::size_t count, const float x[], const float m[], float u[]) {
    furiko_jacobi_arcsc_m_vf(count, x, m, u);
}
/** @} */

/** The u with sc(u|m) = x. @{ */
inline double jacobi_arcsc_mc(double x, double mc) { return furiko_jacobi_arcsc_mc(x, mc); }
inline void jacobi_arcsc_mc(std::size_t count, const double x[], const double mc[], double u[]) {
    furiko_jacobi_arcsc_mc_v(count, x, mc, u);
}
inline float jacobi_arcsc_mc(float x, float mc) { return furiko_jacobi_arcsc_mcf(x, mc); }
inline void jacobi_arcsc_mc(std::size_t count, const float x[], const float mc[], float u[]) {
    furiko_jacobi_arcsc_mc_vf(count, x, mc, u);
}
/** @} */

/** The u with cs(u|m) = x. @{ */
inline double jacobi_arccs_k(double x, double k) { return furiko_jacobi_arccs_k(x, k); }
inline void jacobi_arccs_k(std::size_t count, const double x[], const double k[], double u[]) {
    furiko_jacobi_arccs_k_v(count, x, k, u);
}
inline float jacobi_arccs_k(float x, float k) { return furiko_jacobi_arccs_kf(x, k); }
inline void jacobi_arccs_k(std::size_t count, const float x[], const float k[], float u[]) {
    furiko_jacobi_arccs_k_vf(count, x, k, u);
}
/** @} */

/** The u with cs(u|m) = x. @{ */
inline double jacobi_arccs_m(double x, double m) { return furiko_jacobi_arccs_m(x, m); }
inline void jacobi_arccs_m(std::size_t count, const double x[], const double m[], double u[]) {
    furiko_jacobi_arccs_m_v(count, x, m, u);
}
inline float jacobi_arccs_m(float x, float m) { return furiko_jacobi_arccs_mf(x, m); }
inline void jacobi_arccs_m(std::size_t count, const float x[], const float m[], float u[]) {
    furiko_jacobi_arccs_m_vf(count, x, m, u);
}
/** @} */

/** The u with cs(u|m) = x. @{ */
inline double jacobi_arccs_mc(double x, double mc) { return furiko_jacobi_arccs_mc(x, mc); }
inline void jacobi_arccs_mc(std::size_t count, const double x[], const double mc[], double u[]) {
    furiko_jacobi_arccs_mc_v(count, x, mc, u);
}
inline float jacobi_arccs_mc(float x, float mc) { return furiko_jacobi_arccs_mcf(x, mc); }
inline void jacobi_arccs_mc(std::size_t count, const float x[], const float mc[], float u[]) {
    furiko_jacobi_arccs_mc_vf(count, x, mc, u);
}
/** @} */

/** The u with sd(u|m) = x. @{ */
inline double jacobi_arcsd_k(double x, double k) { return furiko_jacobi_arcsd_k(x, k); }
inline void jacobi_arcsd_k(std::size_t count, const double x[], const double k[], double u[]) {
    furiko_jacobi_arcsd_k_v(count, x, k, u);
}
inline float jacobi_arcsd_k(float x, float k) { return furiko_jacobi_arcsd_kf(x, k); }
inline void jacobi_arcsd_k(std::size_t count, const float x[], const float k[], float u[]) {
    furiko_jacobi_arcsd_k_vf(count, x, k, u);
}
/** @} */

/** The u with sd(u|m) = x. @{ */
inline double jacobi_arcsd_m(double x, double m) { return furiko_jacobi_arcsd_m(x, m); }
inline void jacobi_arcsd_m(std::size_t count, const double x[], const double m[], double u[]) {
    furiko_jacobi_arcsd_m_v(count, x, m, u);
}
inline float jacobi_arcsd_m(float x, float m) { return furiko_jacobi_arcsd_mf(x, m); }
inline void jacobi_arcsd_m(std::size_t count, const float x[], const float m[], float u[]) {
    furiko_jacobi_arcsd_m_vf(count, x, m, u);
}
/** @} */

/** The u with sd(u|m) = x. @{ */
inline double jacobi_arcsd_mc(double x, double mc) { return furiko_jacobi_arcsd_mc(x, mc); }
inline void jacobi_arcsd_mc(std::size_t count, const double x[], const double mc[], double u[]) {
    furiko_jacobi_arcsd_mc_v(count, x, mc, u);
}
inline float jacobi_arcsd_mc(float x, float mc) { return furiko_jacobi_arcsd_mcf(x, mc); }
inline void jacobi_arcsd_mc(std::size_t count, const float x[], const float mc[], float u[]) {
    furiko_jacobi_arcsd_mc_vf(count, x, mc, u);
}
/** @} */

/** The u with ds(u|m) = x. @{ */
inline double jacobi_arcds_k(double x, double k) { return furiko_jacobi_arcds_k(x, k); }
inline void jacobi_arcds_k(std::size_t count, const double x[], const double k[], double u[]) {
    furiko_jacobi_arcds_k_v(count, x, k, u);
}
inline float jacobi_arcds_k(float x, float k) { return furiko_jacobi_arcds_kf(x, k); }
inline void jacobi_arcds_k(std::size_t count, const float x[], const float k[], float u[]) {
    furiko_jacobi_arcds_k_vf(count, x, k, u);
}
/** @} */

/** The u with ds(u|m) = x. @{ */
inline double jacobi_arcds_m(double x, double m) { return furiko_jacobi_arcds_m(x, m); }
inline void jacobi_arcds_m(std::size_t count, const double x[], const double m[], double u[]) {
    furiko_jacobi_arcds_m_v(count, x, m, u);
}
inline float jacobi_arcds_m(float x, float m) { return furiko_jacobi_arcds_mf(x, m); }
inline void jacobi_arcds_m(std::size_t count, const float x[], const float m[], float u[]) {
    furiko_jacobi_arcds_m_vf(count, x, m, u);
}
/** @} */

/** The u with ds(u|m) = x. @{ */
inline double jacobi_arcds_mc(double x, double mc) { return furiko_jacobi_arcds_mc(x, mc); }
inline void jacobi_arcds_mc(std::size_t count, const double x[], const double mc[], double u[]) {
    furiko_jacobi_arcds_mc_v(count, x, mc, u);
}
inline float jacobi_arcds_mc(float x, float mc) { return furiko_jacobi_arcds_mcf(x, mc); }
inline void jacobi_arcds_mc(std::size_t count, const float x[], const float mc[], float u[]) {
    furiko_jacobi_arcds_mc_vf(count, x, mc, u);
}
/** @} */

/** The u with cd(u|m) = x. @{ */
inline double jacobi_arccd_k(double x, double k) { return furiko_jacobi_arccd_k(x, k); }
inline void jacobi_arccd_k(std::size_t count, const double x[], const double k[], double u[]) {
    furiko_jacobi_arccd_k_v(count, x, k, u);
}
inline float jacobi_arccd_k(float x, float k) { return furiko_jacobi_arccd_kf(x, k); }
inline void jacobi_arccd_k(std::size_t count, const float x[], const float k[], float u[]) {
    furiko_jacobi_arccd_k_vf(count, x, k, u);
}
/** @} */

/** The u with cd(u|m) = x. @{ */
inline double jacobi_arccd_m(double x, double m) { return furiko_jacobi_arccd_m(x, m); }
inline void jacobi_arccd_m(std::size_t count, const double x[], const double m[], double u[]) {
    furiko_jacobi_arccd_m_v(count, x, m, u);
}
inline float jacobi_arccd_m(float x, float m) { return furiko_jacobi_arccd_mf(x, m); }
inline void jacobi_arccd_m(std::size_t count, const float x[], const float m[], float u[]) {
    furiko_jacobi_arccd_m_vf(count, x, m, u);
}
/** @} */

/** The u with cd(u|m) = x. @{ */
inline double jacobi_arccd_mc(double x, double mc) { return furiko_jacobi_arccd_mc(x, mc); }
inline void jacobi_arccd_mc(std::size_t count, const double x[], const double mc[], double u[]) {
    furiko_jacobi_arccd_mc_v(count, x, mc, u);
}
inline float jacobi_arccd_mc(float x, float mc) { return furiko_jacobi_arccd_mcf(x, mc); }
inline void jacobi_arccd_mc(std::size_t count, const float x[], const float mc[], float u[]) {
    furiko_jacobi_arccd_mc_vf(count, x, mc, u);
}
/** @} */

/** The u with dc(u|m) = x. @{ */
inline double jacobi_arcdc_k(double x, double k) { return furiko_jacobi_arcdc_k(x, k); }
inline void jacobi_arcdc_k(std::size_t count, const double x[], const double k[], double u[]) {
    furiko_jacobi_arcdc_k_v(count, x, k, u);
}
inline float jacobi_arcdc_k(float x, float k) { return furiko_jacobi_arcdc_kf(x, k); }
inline void jacobi_arcdc_k(std::size_t count, const float x[], const float k[], float u[]) {
    furiko_jacobi_arcdc_k_vf(count, x, k, u);
}
/** @} */

/** The u with dc(u|m) = x. @{ */
inline double jacobi_arcdc_m(double x, double m) { return furiko_jacobi_arcdc_m(x, m); }
inline void jacobi_arcdc_m(std::size_t count, const double x[], const double m[], double u[]) {
    furiko_jacobi_arcdc_m_v(count, x, m, u);
}
inline float jacobi_arcdc_m(float x, float m) { return furiko_jacobi_arcdc_mf(x, m); }
inline void jacobi_arcdc_m(std::size_t count, const float x[], const float m[], float u[]) {
    furiko_jacobi_arcdc_m_vf(count, x, m, u);
}
/** @} */

/** The u with dc(u|m) = x. @{ */
inline double jacobi_arcdc_mc(double x, double mc) { return furiko_jacobi_arcdc_mc(x, mc); }
inline void jacobi_arcdc_mc(std::size_t count, const double x[], const double mc[], double u[]) {
    furiko_jacobi_arcdc_mc_v(count, x, mc, u);
}
inline float jacobi_arcdc_mc(float x, float mc) { return furiko_jacobi_arcdc_mcf(x, mc); }
inline void jacobi_arcdc_mc(std::size_t count, const float x[], const float mc[], float u[]) {
    furiko_jacobi_arcdc_mc_vf(count, x, mc, u);
}
/** @} */

/* ---- Inverses of K and of the period ---- */

/** The parameter m with K(m) = k. @{ */
inline double parameter_from_ellipk(double big_k) { return furiko_parameter_from_ellipk(big_k); }
inline void parameter_from_ellipk(std::size_t count, const double big_k[], double m[]) {
    furiko_parameter_from_ellipk_v(count, big_k, m);
}
inline float parameter_from_ellipk(float big_k) { return furiko_parameter_from_ellipkf(big_k); }
inline void parameter_from_ellipk(std::size_t count, const float big_k[], float m[]) {
    furiko_parameter_from_ellipk_vf(count, big_k, m);
}
/** @} */

/** The complementary parameter mc = 1 - m with K(m) = k. @{ */
inline double complementary_parameter_from_ellipk(double big_k) { return furiko_complementary_parameter_from_ellipk(big_k); }
inline void complementary_parameter_from_ellipk(std::size_t count, const double big_k[], double mc[]) {
    furiko_complementary_parameter_from_ellipk_v(count, big_k, mc);
}
inline float complementary_parameter_from_ellipk(float big_k) { return furiko_complementary_parameter_from_ellipkf(big_k); }
inline void complementary_parameter_from_ellipk(std::size_t count, const float big_k[], float mc[]) {
    furiko_complementary_parameter_from_ellipk_vf(count, big_k, mc);
}
/** @} */

/** The parameter m of a pendulum of this period ratio T/T_h. @{ */
inline double parameter_from_period_ratio(double ratio) { return furiko_parameter_from_period_ratio(ratio); }
inline void parameter_from_period_ratio(std::size_t count, const double ratio[], double m[]) {
    furiko_parameter_from_period_ratio_v(count, ratio, m);
}
inline float parameter_from_period_ratio(float ratio) { return furiko_parameter_from_period_ratiof(ratio); }
inline void parameter_from_period_ratio(std::size_t count, const float ratio[], float m[]) {
    furiko_parameter_from_period_ratio_vf(count, ratio, m);
}
/** @} */

/** The complementary parameter mc = 1 - m of this period ratio T/T_h. @{ */
inline double complementary_parameter_from_period_ratio(double ratio) { return furiko_complementary_parameter_from_period_ratio(ratio); }
inline void complementary_parameter_from_period_ratio(std::size_t count, const double ratio[], double mc[]) {
    furiko_complementary_parameter_from_period_ratio_v(count, ratio, mc);
}
inline float complementary_parameter_from_period_ratio(float ratio) { return furiko_complementary_parameter_from_period_ratiof(ratio); }
inline void complementary_parameter_from_period_ratio(std::size_t count, const float ratio[], float mc[]) {
    furiko_complementary_parameter_from_period_ratio_vf(count, ratio, mc);
}
/** @} */

/* ---- The inverse of E(phi) ---- */

/** The angle phi with E(phi|m) = s. @{ */
inline double ellipeinc_inverse_k(double s, double k) { return furiko_ellipeinc_inverse_k(s, k); }
inline void ellipeinc_inverse_k(std::size_t count, const double s[], const double k[], double phi[]) {
    furiko_ellipeinc_inverse_k_v(count, s, k, phi);
}
inline float ellipeinc_inverse_k(float s, float k) { return furiko_ellipeinc_inverse_kf(s, k); }
inline void ellipeinc_inverse_k(std::size_t count, const float s[], const float k[], float phi[]) {
    furiko_ellipeinc_inverse_k_vf(count, s, k, phi);
}
/** @} */

/** The angle phi with E(phi|m) = s. @{ */
inline double ellipeinc_inverse_m(double s, double m) { return furiko_ellipeinc_inverse_m(s, m); }
inline void ellipeinc_inverse_m(std::size_t count, const double s[], const double m[], double phi[]) {
    furiko_ellipeinc_inverse_m_v(count, s, m, phi);
}
inline float ellipeinc_inverse_m(float s, float m) { return furiko_ellipeinc_inverse_mf(s, m); }
inline void ellipeinc_inverse_m(std::size_t count, const float s[], const float m[], float phi[]) {
    furiko_ellipeinc_inverse_m_vf(count, s, m, phi);
}
/** @} */

/** The angle phi with E(phi|m) = s. @{ */
inline double ellipeinc_inverse_mc(double s, double mc) { return furiko_ellipeinc_inverse_mc(s, mc); }
inline void ellipeinc_inverse_mc(std::size_t count, const double s[], const double mc[], double phi[]) {
    furiko_ellipeinc_inverse_mc_v(count, s, mc, phi);
}
inline float ellipeinc_inverse_mc(float s, float mc) { return furiko_ellipeinc_inverse_mcf(s, mc); }
inline void ellipeinc_inverse_mc(std::size_t count, const float s[], const float mc[], float phi[]) {
    furiko_ellipeinc_inverse_mc_vf(count, s, mc, phi);
}
/** @} */

/* ---- Jacobi's zeta, Heuman's lambda ---- */

/** Jacobi's zeta function. @{ */
inline double jacobi_zeta_k(double phi, double k) { return furiko_jacobi_zeta_k(phi, k); }
inline void jacobi_zeta_k(std::size_t count, const double phi[], const double k[], double z[]) {
    furiko_jacobi_zeta_k_v(count, phi, k, z);
}
inline float jacobi_zeta_k(float phi, float k) { return furiko_jacobi_zeta_kf(phi, k); }
inline void jacobi_zeta_k(std::size_t count, const float phi[], const float k[], float z[]) {
    furiko_jacobi_zeta_k_vf(count, phi, k, z);
}
/** @} */

/** Jacobi's zeta function. @{ */
inline double jacobi_zeta_m(double phi, double m) { return furiko_jacobi_zeta_m(phi, m); }
inline void jacobi_zeta_m(std::size_t count, const double phi[], const double m[], double z[]) {
    furiko_jacobi_zeta_m_v(count, phi, m, z);
}
inline float jacobi_zeta_m(float phi, float m) { return furiko_jacobi_zeta_mf(phi, m); }
inline void jacobi_zeta_m(std::size_t count, const float phi[], const float m[], float z[]) {
    furiko_jacobi_zeta_m_vf(count, phi, m, z);
}
/** @} */

/** Jacobi's zeta function. @{ */
inline double jacobi_zeta_mc(double phi, double mc) { return furiko_jacobi_zeta_mc(phi, mc); }
inline void jacobi_zeta_mc(std::size_t count, const double phi[], const double mc[], double z[]) {
    furiko_jacobi_zeta_mc_v(count, phi, mc, z);
}
inline float jacobi_zeta_mc(float phi, float mc) { return furiko_jacobi_zeta_mcf(phi, mc); }
inline void jacobi_zeta_mc(std::size_t count, const float phi[], const float mc[], float z[]) {
    furiko_jacobi_zeta_mc_vf(count, phi, mc, z);
}
/** @} */

/** Heuman's lambda function. @{ */
inline double heuman_lambda_k(double phi, double k) { return furiko_heuman_lambda_k(phi, k); }
inline void heuman_lambda_k(std::size_t count, const double phi[], const double k[], double lambda[]) {
    furiko_heuman_lambda_k_v(count, phi, k, lambda);
}
inline float heuman_lambda_k(float phi, float k) { return furiko_heuman_lambda_kf(phi, k); }
inline void heuman_lambda_k(std::size_t count, const float phi[], const float k[], float lambda[]) {
    furiko_heuman_lambda_k_vf(count, phi, k, lambda);
}
/** @} */

/** Heuman's lambda function. @{ */
inline double heuman_lambda_m(double phi, double m) { return furiko_heuman_lambda_m(phi, m); }
inline void heuman_lambda_m(std::size_t count, const double phi[], const double m[], double lambda[]) {
    furiko_heuman_lambda_m_v(count, phi, m, lambda);
}
inline float heuman_lambda_m(float phi, float m) { return furiko_heuman_lambda_mf(phi, m); }
inline void heuman_lambda_m(std::size_t count, const float phi[], const float m[], float lambda[]) {
    furiko_heuman_lambda_m_vf(count, phi, m, lambda);
}
/** @} */

/** Heuman's lambda function. @{ */
inline double heuman_lambda_mc(double phi, double mc) { return furiko_heuman_lambda_mc(phi, mc); }
inline void heuman_lambda_mc(std::size_t count, const double phi[], const double mc[], double lambda[]) {
    furiko_heuman_lambda_mc_v(count, phi, mc, lambda);
}
inline float heuman_lambda_mc(float phi, float mc) { return furiko_heuman_lambda_mcf(phi, mc); }
inline void heuman_lambda_mc(std::size_t count, const float phi[], const float mc[], float lambda[]) {
    furiko_heuman_lambda_mc_vf(count, phi, mc, lambda);
}
/** @} */

/* ---- The pendulum's period ---- */

/** The period T of a pendulum over that of its small swings. @{ */
inline double period_ratio(double amplitude) { return furiko_period_ratio(amplitude); }
inline void period_ratio(std::size_t count, const double amplitude[], double ratio[]) {
    furiko_period_ratio_v(count, amplitude, ratio);
}
inline float period_ratio(float amplitude) { return furiko_period_ratiof(amplitude); }
inline void period_ratio(std::size_t count, const float amplitude[], float ratio[]) {
    furiko_period_ratio_vf(count, amplitude, ratio);
}
/** @} */

/** By how much a pendulum's period exceeds that of small swings. @{ */
inline double period_excess(double amplitude) { return furiko_period_excess(amplitude); }
inline void period_excess(std::size_t count, const double amplitude[], double excess[]) {
    furiko_period_excess_v(count, amplitude, excess);
}
inline float period_excess(float amplitude) { return furiko_period_excessf(amplitude); }
inline void period_excess(std::size_t count, const float amplitude[], float excess[]) {
    furiko_period_excess_vf(count, amplitude, excess);
}
/** @} */

/** The amplitude of a pendulum of this period ratio T/T_h. @{ */
inline double amplitude_of_period(double ratio) { return furiko_amplitude_of_period(ratio); }
inline void amplitude_of_period(std::size_t count, const double ratio[], double theta_0[]) {
    furiko_amplitude_of_period_v(count, ratio, theta_0);
}
inline float amplitude_of_period(float ratio) { return furiko_amplitude_of_periodf(ratio); }
inline void amplitude_of_period(std::size_t count, const float ratio[], float theta_0[]) {
    furiko_amplitude_of_period_vf(count, ratio, theta_0);
}
/** @} */

/** The amplitude of a pendulum of this excess T/T_h - 1. @{ */
inline double amplitude_of_excess(double excess) { return furiko_amplitude_of_excess(excess); }
inline void amplitude_of_excess(std::size_t count, const double excess[], double theta_0[]) {
    furiko_amplitude_of_excess_v(count, excess, theta_0);
}
inline float amplitude_of_excess(float excess) { return furiko_amplitude_of_excessf(excess); }
inline void amplitude_of_excess(std::size_t count, const float excess[], float theta_0[]) {
    furiko_amplitude_of_excess_vf(count, excess, theta_0);
}
/** @} */

/* ---- The pendulum's period by its series ---- */

/** The amplitude of a pendulum of this excess by three terms. @{ */
inline double amplitude_three_terms(double excess) { return furiko_amplitude_three_terms(excess); }
inline void amplitude_three_terms(std::size_t count, const double excess[], double theta_0[]) {
    furiko_amplitude_three_terms_v(count, excess, theta_0);
}
inline float amplitude_three_terms(float excess) { return furiko_amplitude_three_termsf(excess); }
inline void amplitude_three_terms(std::size_t count, const float excess[], float theta_0[]) {
    furiko_amplitude_three_terms_vf(count, excess, theta_0);
}
/** @} */

/* ---- The ellipse ---- */

/** The perimeter of an ellipse of semiaxes a and b, in any order. @{ */
inline double ellipse_perimeter(double a, double b) { return furiko_ellipse_perimeter(a, b); }
inline void ellipse_perimeter(std::size_t count, const double a[], const double b[], double l[]) {
    furiko_ellipse_perimeter_v(count, a, b, l);
}
inline float ellipse_perimeter(float a, float b) { return furiko_ellipse_perimeterf(a, b); }
inline void ellipse_perimeter(std::size_t count, const float a[], const float b[], float l[]) {
    furiko_ellipse_perimeter_vf(count, a, b, l);
}
/** @} */

/** One modulus, many arguments: furiko_modulus with members. */
class modulus {
public:
    static modulus from_k(double k) { modulus p; furiko_modulus_from_k(&p.self, k); return p; }
    static modulus from_m(double m) { modulus p; furiko_modulus_from_m(&p.self, m); return p; }
    static modulus from_mc(double mc) { modulus p; furiko_modulus_from_mc(&p.self, mc); return p; }
    static modulus from_alpha(double alpha) { modulus p; furiko_modulus_from_alpha(&p.self, alpha); return p; }
    static modulus from_amplitude(double amplitude) {
        modulus p;
        furiko_modulus_from_amplitude(&p.self, amplitude);
        return p;
    }
    /** Before it is made all that it says is NaN */
    modulus() : self() {}
    modulus complement() const { modulus p; furiko_modulus_complement(&self, &p.self); return p; }
    double k() const { return furiko_modulus_k(&self); }
    double m() const { return furiko_modulus_m(&self); }
    double mc() const { return furiko_modulus_mc(&self); }
    double ellipk() const { return furiko_modulus_ellipk(&self); }
    double ellipe() const { return furiko_modulus_ellipe(&self); }
    double quarter_period() const { return furiko_modulus_quarter_period(&self); }
    double nome() const { return furiko_modulus_nome(&self); }
    void jacobi(double u, double &sn, double &cn, double &dn) const {
        furiko_modulus_jacobi(&self, u, &sn, &cn, &dn);
    }
    void jacobi(std::size_t count, const double u[], double sn[], double cn[], double dn[]) const {
        furiko_modulus_jacobi_v(&self, count, u, sn, cn, dn);
    }
    double am(double u) const { return furiko_modulus_am(&self, u); }
    void am(std::size_t count, const double u[], double am[]) const { furiko_modulus_am_v(&self, count, u, am); }
    double epsilon(double u) const { return furiko_modulus_epsilon(&self, u); }
    void epsilon(std::size_t count, const double u[], double epsilon[]) const {
        furiko_modulus_epsilon_v(&self, count, u, epsilon);
    }

private:
    furiko_modulus self;
};

/** A pendulum's exact motion: furiko_motion with members. */
class motion {
public:
    static motion released(double length, double gravity, double angle) {
        motion p;
        furiko_motion_released(&p.self, length, gravity, angle);
        return p;
    }
    static motion swinging(double length, double gravity, double amplitude) {
        motion p;
        furiko_motion_swinging(&p.self, length, gravity, amplitude);
        return p;
    }
    static motion started(double length, double gravity, double angle, double rate) {
        motion p;
        furiko_motion_started(&p.self, length, gravity, angle, rate);
        return p;
    }
    /** Before it is made all that it says is NaN */
    motion() : self() {}
    bool is_libration() const { return furiko_motion_is_libration(&self) != 0; }
    bool is_rotation() const { return furiko_motion_is_rotation(&self) != 0; }
    double period() const { return furiko_motion_period(&self); }
    double amplitude() const { return furiko_motion_amplitude(&self); }
    double energy() const { return furiko_motion_energy(&self); }
    double angle(double time) const { return furiko_motion_angle(&self, time); }
    void angle(std::size_t count, const double time[], double angle[]) const {
        furiko_motion_angle_v(&self, count, time, angle);
    }
    double rate(double time) const { return furiko_motion_rate(&self, time); }
    void rate(std::size_t count, const double time[], double rate[]) const {
        furiko_motion_rate_v(&self, count, time, rate);
    }
    double tension(double time) const { return furiko_motion_tension(&self, time); }
    void tension(std::size_t count, const double time[], double tension[]) const {
        furiko_motion_tension_v(&self, count, time, tension);
    }
    double harmonic_angle(double time) const { return furiko_motion_harmonic_angle(&self, time); }
    double phase(double time) const { return furiko_motion_phase(&self, time); }
    double time_to(double angle) const { return furiko_motion_time_to(&self, angle); }
    double slack_angle() const { return furiko_motion_slack_angle(&self); }

private:
    furiko_motion self;
};

}

#endif
