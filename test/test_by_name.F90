! SPDX-License-Identifier: MIT
#include "../src/arithmetic/furiko_compiler.inc"

module test_by_name_sp
   use, intrinsic :: iso_fortran_env, only : wp => real32
   use furiko_agm_steps_sp, only : agm_steps_k, agm_steps_m, agm_steps_mc
   use furiko_by_name_sp, only : evaluate
   use furiko_ellipse_sp, only : ellipse_perimeter, ellipse_perimeter_series
   use furiko_jacobi_sp, only : jacobi_k, jacobi_m, jacobi_mc
   use furiko_modulus_sp, only : modulus, modulus_from_alpha, modulus_from_k, modulus_from_m, modulus_from_mc
   use furiko_motion_sp, only : motion, pendulum
   use furiko_series_sp, only : amplitude_three_terms, ellipe_series_k, ellipe_series_m, &
      ellipk_series_k, ellipk_series_m, period_ratio_series
   use furiko_trapezoid_sp, only : ellipe_trapezoid_k, ellipe_trapezoid_m, ellipe_trapezoid_mc, &
      ellipk_trapezoid_k, ellipk_trapezoid_m, ellipk_trapezoid_mc
   implicit none
   private
   include 'test_by_name.inc'
end module test_by_name_sp


module test_by_name_dp
   use, intrinsic :: iso_fortran_env, only : wp => real64
   use furiko_agm_steps_dp, only : agm_steps_k, agm_steps_m, agm_steps_mc
   use furiko_by_name_dp, only : evaluate
   use furiko_ellipse_dp, only : ellipse_perimeter, ellipse_perimeter_series
   use furiko_jacobi_dp, only : jacobi_k, jacobi_m, jacobi_mc
   use furiko_modulus_dp, only : modulus, modulus_from_alpha, modulus_from_k, modulus_from_m, modulus_from_mc
   use furiko_motion_dp, only : motion, pendulum
   use furiko_series_dp, only : amplitude_three_terms, ellipe_series_k, ellipe_series_m, &
      ellipk_series_k, ellipk_series_m, period_ratio_series
   use furiko_trapezoid_dp, only : ellipe_trapezoid_k, ellipe_trapezoid_m, ellipe_trapezoid_mc, &
      ellipk_trapezoid_k, ellipk_trapezoid_m, ellipk_trapezoid_mc
   implicit none
   private
   include 'test_by_name.inc'
end module test_by_name_dp


#ifdef FURIKO_REAL128
module test_by_name_qp
   use, intrinsic :: iso_fortran_env, only : wp => real128
   use furiko_agm_steps_qp, only : agm_steps_k, agm_steps_m, agm_steps_mc
   use furiko_by_name_qp, only : evaluate
   use furiko_ellipse_qp, only : ellipse_perimeter, ellipse_perimeter_series
   use furiko_jacobi_qp, only : jacobi_k, jacobi_m, jacobi_mc
   use furiko_modulus_qp, only : modulus, modulus_from_alpha, modulus_from_k, modulus_from_m, modulus_from_mc
   use furiko_motion_qp, only : motion, pendulum
   use furiko_series_qp, only : amplitude_three_terms, ellipe_series_k, ellipe_series_m, &
      ellipk_series_k, ellipk_series_m, period_ratio_series
   use furiko_trapezoid_qp, only : ellipe_trapezoid_k, ellipe_trapezoid_m, ellipe_trapezoid_mc, &
      ellipk_trapezoid_k, ellipk_trapezoid_m, ellipk_trapezoid_mc
   implicit none
   private
   include 'test_by_name.inc'
end module test_by_name_qp
#endif
! rooms: 703135753
