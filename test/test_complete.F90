! SPDX-License-Identifier: MIT
#include "../src/arithmetic/furiko_compiler.inc"

module test_complete_sp
   use, intrinsic :: iso_fortran_env, only : compiler_version, wp => real32
   use, intrinsic :: ieee_arithmetic, only : ieee_is_nan, ieee_value, &
      ieee_positive_inf, ieee_quiet_nan
   use, intrinsic :: ieee_exceptions, only : ieee_get_flag, ieee_set_flag, ieee_usual
   use furiko, only : agm, ellipb_mc, ellipd_mc, ellipe_alpha, ellipe_k, ellipe_m, ellipe_mc, &
      ellipk_alpha, ellipk_k, ellipk_m, ellipk_mc, ellipke_alpha, ellipke_k, ellipke_m, ellipke_mc, &
      period_ratio
   use testdrive, only : check, error_type, new_unittest, skip_test, unittest_type
   implicit none
   private
   include 'test_complete.inc'
end module test_complete_sp


module test_complete_dp
   use, intrinsic :: iso_fortran_env, only : compiler_version, wp => real64
   use, intrinsic :: ieee_arithmetic, only : ieee_is_nan, ieee_value, &
      ieee_positive_inf, ieee_quiet_nan
   use, intrinsic :: ieee_exceptions, only : ieee_get_flag, ieee_set_flag, ieee_usual
   use furiko, only : agm, ellipb_mc, ellipd_mc, ellipe_alpha, ellipe_k, ellipe_m, ellipe_mc, &
      ellipk_alpha, ellipk_k, ellipk_m, ellipk_mc, ellipke_alpha, ellipke_k, ellipke_m, ellipke_mc, &
      period_ratio
   use testdrive, only : check, error_type, new_unittest, skip_test, unittest_type
   implicit none
   private
   include 'test_complete.inc'
end module test_complete_dp


#ifdef FURIKO_REAL128
module test_complete_qp
   use, intrinsic :: iso_fortran_env, only : compiler_version, wp => real128
   use, intrinsic :: ieee_arithmetic, only : ieee_is_nan, ieee_value, &
      ieee_positive_inf, ieee_quiet_nan
   use, intrinsic :: ieee_exceptions, only : ieee_get_flag, ieee_set_flag, ieee_usual
   use furiko, only : agm, ellipb_mc, ellipd_mc, ellipe_alpha, ellipe_k, ellipe_m, ellipe_mc, &
      ellipk_alpha, ellipk_k, ellipk_m, ellipk_mc, ellipke_alpha, ellipke_k, ellipke_m, ellipke_mc, &
      period_ratio
   use testdrive, only : check, error_type, new_unittest, skip_test, unittest_type
   implicit none
   private
   include 'test_complete.inc'
end module test_complete_qp
#endif
! rooms: 3090851768
