! SPDX-License-Identifier: MIT
#include "arithmetic/furiko_compiler.inc"

!> Elliptic integrals, Jacobi elliptic functions and the exact pendulum: what a program `use`s.
!>
!> The argument's form is in the name, always: `_k` takes the modulus k, `_m` the parameter
!> m = k^2, `_mc` the complementary parameter mc = 1 - m, `_alpha` the modular angle. n and phi stand
!> before it. All procedures are elemental and generic over real32, real64 and (where the compiler
!> has it) real128; arrays of rank 1 go to vectorised kernels under the same names.
!>
!> - Complete integrals K, E, B, D: `print *, ellipk_m(0.25d0), ellipe_k(0.5)`, K and E at once
!>   `call ellipke_mc(mc, k, e)`; see [[ellipk_k]], [[ellipe_k]], [[ellipb_k]], [[ellipd_k]].
!> - Incomplete integrals F, E, D: `ellipf_m(phi, m)`; see [[ellipf_k]], [[ellipeinc_k]], [[ellipdinc_k]].
!> - The third kind: `ellippi_m(n, m)`, `ellippiinc_m(n, phi, m)`; see [[ellippi_k]], [[ellippiinc_k]].
!> - Carlson's forms: `carlson_rf(x, y, z)`; see [[carlson_rf]] and its sisters.
!> - Jacobi elliptic functions: `call jacobi_m(u, m, sn, cn, dn)`, `jacobi_sn_k(u, k)` and its eleven
!>   sisters, the amplitude `jacobi_am_m`, the inverses `jacobi_arcsn_m(x, m)` ...; see [[jacobi_k]].
!> - One modulus, many u: `p = modulus_from_k(k)`, `call p%jacobi(u, sn, cn, dn)`; see [[modulus]].
!> - Nome, theta functions, zeta and lambda: `nome_m(m)`, `theta1(z, q)`, `jacobi_zeta_m(phi, m)`; see
!>   [[nome_m]], [[theta1]], [[jacobi_zeta_m]].
!> - The pendulum's exact motion: `path = body%released(1.0d0)`, `path%angle(t)`; see [[pendulum]],
!>   [[motion]]. Its period: `period_ratio(theta0)` times 2 pi sqrt(l/g); see [[period_ratio]].
!> - The notes' own ways, to be compared with: the power series `ellipk_series_k(k, terms)` and the
!>   bound on its remainder, the trapezoidal rule `ellipk_trapezoid_k(k, n)`, the mean step by step
!>   `agm_steps_k`; see [[ellipk_series_k]], [[ellipk_trapezoid_k]], [[agm_steps_k]].
!> - An ellipse's perimeter: `ellipse_perimeter(2.0, 1.0)`; see [[ellipse_perimeter]].
!> - Equations of motion in steps: `call rk4(rates, parameters, t0, h, steps, y)` for any system,
!>   `verlet` and `forest_ruth` for x'' = a(x), `call pendulum_rk4(omega2, h, steps, angle, rate)` for
!>   one pendulum or many; see [[rk4]], [[verlet]], [[pendulum_rk4]].
!> - Whether this build computes right: `furiko_selftest()` is 0; see [[furiko_selftest]].
!> - The arithmetic-geometric mean: `agm(1.0, sqrt(2.0))`; see [[agm]].
module furiko
   use furiko_agm, only : agm
   use furiko_complete, only : ellipk_k, ellipk_m, ellipk_mc, ellipk_alpha, ellipe_k, ellipe_m, &
      ellipe_mc, ellipe_alpha, ellipke_k, ellipke_m, ellipke_mc, ellipke_alpha, ellipb_k, &
      ellipb_m, ellipb_mc, ellipb_alpha, ellipd_k, ellipd_m, ellipd_mc, ellipd_alpha
   use furiko_incomplete, only : ellipf_k, ellipf_m, ellipf_mc, ellipeinc_k, ellipeinc_m, &
      ellipeinc_mc, ellipdinc_k, ellipdinc_m, ellipdinc_mc
   use furiko_third_kind, only : ellippi_k, ellippi_m, ellippi_mc, ellippiinc_k, ellippiinc_m, &
      ellippiinc_mc
   use furiko_carlson, only : carlson_rf, carlson_rc, carlson_rd, carlson_rj, carlson_rg
   use furiko_nome, only : nome_k, nome_m, nome_mc, parameter_from_nome, &
      complementary_parameter_from_nome
   use furiko_theta, only : theta1, theta2, theta3, theta4, theta1_prime, theta2_prime, &
      theta3_prime, theta4_prime
   use furiko_jacobi, only : jacobi_k, jacobi_m, jacobi_mc, jacobi_sn_k, jacobi_sn_m, jacobi_sn_mc, &
      jacobi_cn_k, jacobi_cn_m, jacobi_cn_mc, jacobi_dn_k, jacobi_dn_m, jacobi_dn_mc, &
      jacobi_ns_k, jacobi_ns_m, jacobi_ns_mc, jacobi_nc_k, jacobi_nc_m, jacobi_nc_mc, &
      jacobi_nd_k, jacobi_nd_m, jacobi_nd_mc, jacobi_sc_k, jacobi_sc_m, jacobi_sc_mc, &
      jacobi_cs_k, jacobi_cs_m, jacobi_cs_mc, jacobi_sd_k, jacobi_sd_m, jacobi_sd_mc, &
      jacobi_ds_k, jacobi_ds_m, jacobi_ds_mc, jacobi_cd_k, jacobi_cd_m, jacobi_cd_mc, &
      jacobi_dc_k, jacobi_dc_m, jacobi_dc_mc, jacobi_am_k, jacobi_am_m, jacobi_am_mc
   use furiko_modulus, only : modulus, modulus_real32, modulus_from_k, modulus_from_m, &
      modulus_from_mc, modulus_from_alpha, modulus_from_amplitude
#ifdef FURIKO_REAL128
   use furiko_modulus, only : modulus_real128
#endif
   use furiko_jacobi_epsilon, only : jacobi_epsilon_k, jacobi_epsilon_m, jacobi_epsilon_mc
   use furiko_jacobi_inverse, only : jacobi_arcsn_k, jacobi_arcsn_m, jacobi_arcsn_mc, &
      jacobi_arccn_k, jacobi_arccn_m, jacobi_arccn_mc, jacobi_arcdn_k, jacobi_arcdn_m, &
      jacobi_arcdn_mc, jacobi_arcns_k, jacobi_arcns_m, jacobi_arcns_mc, jacobi_arcnc_k, &
      jacobi_arcnc_m, jacobi_arcnc_mc, jacobi_arcnd_k, jacobi_arcnd_m, jacobi_arcnd_mc, &
      jacobi_arcsc_k, jacobi_arcsc_m, jacobi_arcsc_mc, jacobi_arccs_k, jacobi_arccs_m, &
      jacobi_arccs_mc, jacobi_arcsd_k, jacobi_arcsd_m, jacobi_arcsd_mc, jacobi_arcds_k, &
      jacobi_arcds_m, jacobi_arcds_mc, jacobi_arccd_k, jacobi_arccd_m, jacobi_arccd_mc, &
      jacobi_arcdc_k, jacobi_arcdc_m, jacobi_arcdc_mc
   use furiko_inverse_period, only : parameter_from_ellipk, complementary_parameter_from_ellipk, &
      parameter_from_period_ratio, complementary_parameter_from_period_ratio
   use furiko_jacobi_zeta, only : jacobi_zeta_k, jacobi_zeta_m, jacobi_zeta_mc, heuman_lambda_k, &
      heuman_lambda_m, heuman_lambda_mc
   use furiko_motion, only : pendulum, motion, pendulum_real32, motion_real32
#ifdef FURIKO_REAL128
   use furiko_motion, only : pendulum_real128, motion_real128
#endif
   use furiko_period, only : period_ratio, period_excess, amplitude_of_period, amplitude_of_excess
   use furiko_series, only : ellipk_series_k, ellipk_series_m, ellipk_remainder_k, &
      ellipk_remainder_m, ellipe_series_k, ellipe_series_m, ellipe_remainder_k, &
      ellipe_remainder_m, period_ratio_series, amplitude_three_terms
   use furiko_trapezoid, only : ellipk_trapezoid_k, ellipk_trapezoid_m, ellipk_trapezoid_mc, &
      ellipe_trapezoid_k, ellipe_trapezoid_m, ellipe_trapezoid_mc
   use furiko_agm_steps, only : agm_steps_k, agm_steps_m, agm_steps_mc
   use furiko_ellipse, only : ellipse_perimeter, ellipse_perimeter_series
   use furiko_known_values, only : furiko_selftest
   use furiko_rk4, only : rk4
   use furiko_symplectic, only : verlet, forest_ruth
   use furiko_pendulum_steps, only : pendulum_rk4, pendulum_verlet, pendulum_forest_ruth
   implicit none
   private
   public :: furiko_selftest, furiko_version
   public :: agm
   public :: ellipk_k, ellipk_m, ellipk_mc, ellipk_alpha, ellipe_k, ellipe_m, ellipe_mc, &
      ellipe_alpha, ellipke_k, ellipke_m, ellipke_mc, ellipke_alpha, ellipb_k, ellipb_m, &
      ellipb_mc, ellipb_alpha, ellipd_k, ellipd_m, ellipd_mc, ellipd_alpha
   public :: ellipf_k, ellipf_m, ellipf_mc, ellipeinc_k, ellipeinc_m, ellipeinc_mc, ellipdinc_k, &
      ellipdinc_m, ellipdinc_mc
   public :: ellippi_k, ellippi_m, ellippi_mc, ellippiinc_k, ellippiinc_m, ellippiinc_mc
   public :: carlson_rf, carlson_rc, carlson_rd, carlson_rj, carlson_rg
   public :: nome_k, nome_m, nome_mc, parameter_from_nome, complementary_parameter_from_nome
   public :: theta1, theta2, theta3, theta4, theta1_prime, theta2_prime, &
      theta3_prime, theta4_prime
   public :: jacobi_k, jacobi_m, jacobi_mc, jacobi_sn_k, jacobi_sn_m, jacobi_sn_mc, jacobi_cn_k, &
      jacobi_cn_m, jacobi_cn_mc, jacobi_dn_k, jacobi_dn_m, jacobi_dn_mc, jacobi_ns_k, &
      jacobi_ns_m, jacobi_ns_mc, jacobi_nc_k, jacobi_nc_m, jacobi_nc_mc, jacobi_nd_k, &
      jacobi_nd_m, jacobi_nd_mc, jacobi_sc_k, jacobi_sc_m, jacobi_sc_mc, jacobi_cs_k, &
      jacobi_cs_m, jacobi_cs_mc, jacobi_sd_k, jacobi_sd_m, jacobi_sd_mc, jacobi_ds_k, &
      jacobi_ds_m, jacobi_ds_mc, jacobi_cd_k, jacobi_cd_m, jacobi_cd_mc, jacobi_dc_k, &
      jacobi_dc_m, jacobi_dc_mc, jacobi_am_k, jacobi_am_m, jacobi_am_mc
   public :: modulus, modulus_real32, modulus_from_k, modulus_from_m, modulus_from_mc, &
      modulus_from_alpha, modulus_from_amplitude
   public :: jacobi_zeta_k, jacobi_zeta_m, jacobi_zeta_mc, heuman_lambda_k, heuman_lambda_m, &
      heuman_lambda_mc
   public :: jacobi_epsilon_k, jacobi_epsilon_m, jacobi_epsilon_mc
   public :: jacobi_arcsn_k, jacobi_arcsn_m, jacobi_arcsn_mc, jacobi_arccn_k, jacobi_arccn_m, &
      jacobi_arccn_mc, jacobi_arcdn_k, jacobi_arcdn_m, jacobi_arcdn_mc, jacobi_arcns_k, &
      jacobi_arcns_m, jacobi_arcns_mc, jacobi_arcnc_k, jacobi_arcnc_m, jacobi_arcnc_mc, &
      jacobi_arcnd_k, jacobi_arcnd_m, jacobi_arcnd_mc, jacobi_arcsc_k, jacobi_arcsc_m, &
      jacobi_arcsc_mc, jacobi_arccs_k, jacobi_arccs_m, jacobi_arccs_mc, jacobi_arcsd_k, &
      jacobi_arcsd_m, jacobi_arcsd_mc, jacobi_arcds_k, jacobi_arcds_m, jacobi_arcds_mc, &
      jacobi_arccd_k, jacobi_arccd_m, jacobi_arccd_mc, jacobi_arcdc_k, jacobi_arcdc_m, &
      jacobi_arcdc_mc
   public :: parameter_from_ellipk, complementary_parameter_from_ellipk, &
      parameter_from_period_ratio, complementary_parameter_from_period_ratio
   public :: pendulum, motion, pendulum_real32, motion_real32
#ifdef FURIKO_REAL128
   public :: modulus_real128, pendulum_real128, motion_real128
#endif
   public :: period_ratio, period_excess, amplitude_of_period, amplitude_of_excess
   public :: ellipk_series_k, ellipk_series_m, ellipk_remainder_k, ellipk_remainder_m, &
      ellipe_series_k, ellipe_series_m, ellipe_remainder_k, ellipe_remainder_m, &
      period_ratio_series, amplitude_three_terms
   public :: ellipk_trapezoid_k, ellipk_trapezoid_m, ellipk_trapezoid_mc, ellipe_trapezoid_k, &
      ellipe_trapezoid_m, ellipe_trapezoid_mc
   public :: agm_steps_k, agm_steps_m, agm_steps_mc
   public :: ellipse_perimeter, ellipse_perimeter_series
   public :: rk4, verlet, forest_ruth
   public :: pendulum_rk4, pendulum_verlet, pendulum_forest_ruth


   !> The library's version, by the rules of semver.org
   character(len=*), parameter :: furiko_version = '0.3.0'

end module furiko
! rooms: 3759241635
