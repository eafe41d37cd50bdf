! SPDX-License-Identifier: MIT
#include "../src/arithmetic/furiko_compiler.inc"

module test_second_inverse_sp
   use, intrinsic :: iso_fortran_env, only : compiler_version, wp => real32
   use, intrinsic :: ieee_arithmetic, only : ieee_is_nan, ieee_value, ieee_positive_inf, &
      ieee_quiet_nan
   use, intrinsic :: ieee_exceptions, only : ieee_get_flag, ieee_set_flag, ieee_usual
   use furiko, only : ellipe_m, ellipeinc_inverse_k, ellipeinc_inverse_m, ellipeinc_inverse_mc, &
      ellipeinc_m
   use testdrive, only : check, error_type, new_unittest, skip_test, unittest_type
   implicit none
   private
   include 'test_second_inverse.inc'
end module test_second_inverse_sp


module test_second_inverse_dp
   use, intrinsic :: iso_fortran_env, only : compiler_version, wp => real64
   use, intrinsic :: ieee_arithmetic, only : ieee_is_nan, ieee_value, ieee_positive_inf, &
      ieee_quiet_nan
   use, intrinsic :: ieee_exceptions, only : ieee_get_flag, ieee_set_flag, ieee_usual
   use furiko, only : ellipe_m, ellipeinc_inverse_k, ellipeinc_inverse_m, ellipeinc_inverse_mc, &
      ellipeinc_m
   use testdrive, only : check, error_type, new_unittest, skip_test, unittest_type
   implicit none
   private
   include 'test_second_inverse.inc'
end module test_second_inverse_dp


#ifdef FURIKO_REAL128
module test_second_inverse_qp
   use, intrinsic :: iso_fortran_env, only : compiler_version, wp => real128
   use, intrinsic :: ieee_arithmetic, only : ieee_is_nan, ieee_value, ieee_positive_inf, &
      ieee_quiet_nan
   use, intrinsic :: ieee_exceptions, only : ieee_get_flag, ieee_set_flag, ieee_usual
   use furiko, only : ellipe_m, ellipeinc_inverse_k, ellipeinc_inverse_m, ellipeinc_inverse_mc, &
      ellipeinc_m
   use testdrive, only : check, error_type, new_unittest, skip_test, unittest_type
   implicit none
   private
   include 'test_second_inverse.inc'
end module test_second_inverse_qp
#endif
! rooms: 3476292720
