! SPDX-License-Identifier: MIT
#include "../src/arithmetic/furiko_compiler.inc"

module test_classics_sp
   use, intrinsic :: iso_fortran_env, only : compiler_version, wp => real32
   use, intrinsic :: ieee_arithmetic, only : ieee_is_nan, ieee_value, &
      ieee_positive_inf, ieee_quiet_nan
   use, intrinsic :: ieee_exceptions, only : ieee_get_flag, ieee_set_flag, ieee_usual
   use furiko, only : agm_steps_k, agm_steps_m, agm_steps_mc, amplitude_three_terms, ellipe_k, &
      ellipe_m, ellipe_mc, ellipe_remainder_k, ellipe_remainder_m, ellipe_series_k, &
      ellipe_series_m, ellipe_trapezoid_k, ellipe_trapezoid_m, ellipe_trapezoid_mc, ellipk_k, &
      ellipk_m, ellipk_mc, ellipk_remainder_k, ellipk_remainder_m, ellipk_series_k, &
      ellipk_series_m, ellipk_trapezoid_k, ellipk_trapezoid_m, ellipk_trapezoid_mc, &
      ellipse_perimeter, ellipse_perimeter_series, period_ratio_series
   use testdrive, only : check, error_type, new_unittest, skip_test, unittest_type
   implicit none
   private
   include 'test_classics.inc'
end module test_classics_sp


module test_classics_dp
   use, intrinsic :: iso_fortran_env, only : compiler_version, wp => real64
   use, intrinsic :: ieee_arithmetic, only : ieee_is_nan, ieee_value, &
      ieee_positive_inf, ieee_quiet_nan
   use, intrinsic :: ieee_exceptions, only : ieee_get_flag, ieee_set_flag, ieee_usual
   use furiko, only : agm_steps_k, agm_steps_m, agm_steps_mc, amplitude_three_terms, ellipe_k, &
      ellipe_m, ellipe_mc, ellipe_remainder_k, ellipe_remainder_m, ellipe_series_k, &
      ellipe_series_m, ellipe_trapezoid_k, ellipe_trapezoid_m, ellipe_trapezoid_mc, ellipk_k, &
      ellipk_m, ellipk_mc, ellipk_remainder_k, ellipk_remainder_m, ellipk_series_k, &
      ellipk_series_m, ellipk_trapezoid_k, ellipk_trapezoid_m, ellipk_trapezoid_mc, &
      ellipse_perimeter, ellipse_perimeter_series, period_ratio_series
   use testdrive, only : check, error_type, new_unittest, skip_test, unittest_type
   implicit none
   private
   include 'test_classics.inc'
end module test_classics_dp


#ifdef FURIKO_REAL128
module test_classics_qp
   use, intrinsic :: iso_fortran_env, only : compiler_version, wp => real128
   use, intrinsic :: ieee_arithmetic, only : ieee_is_nan, ieee_value, &
      ieee_positive_inf, ieee_quiet_nan
   use, intrinsic :: ieee_exceptions, only : ieee_get_flag, ieee_set_flag, ieee_usual
   use furiko, only : agm_steps_k, agm_steps_m, agm_steps_mc, amplitude_three_terms, ellipe_k, &
      ellipe_m, ellipe_mc, ellipe_remainder_k, ellipe_remainder_m, ellipe_series_k, &
      ellipe_series_m, ellipe_trapezoid_k, ellipe_trapezoid_m, ellipe_trapezoid_mc, ellipk_k, &
      ellipk_m, ellipk_mc, ellipk_remainder_k, ellipk_remainder_m, ellipk_series_k, &
      ellipk_series_m, ellipk_trapezoid_k, ellipk_trapezoid_m, ellipk_trapezoid_mc, &
      ellipse_perimeter, ellipse_perimeter_series, period_ratio_series
   use testdrive, only : check, error_type, new_unittest, skip_test, unittest_type
   implicit none
   private
   include 'test_classics.inc'
end module test_classics_qp
#endif
! rooms: 3349711193
