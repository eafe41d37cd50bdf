! SPDX-License-Identifier: MIT
#include "../src/arithmetic/furiko_compiler.inc"

!> All functions at random bits, in each kind: what must hold for any arguments. The text is in test_fuzz.inc.
module test_fuzz_sp
   use, intrinsic :: ieee_arithmetic, only : ieee_is_nan, ieee_negative_inf, ieee_positive_inf, &
      ieee_quiet_nan, ieee_value
   use, intrinsic :: ieee_exceptions, only : ieee_get_flag, ieee_set_flag, ieee_usual
   use, intrinsic :: iso_fortran_env, only : compiler_version, wp => real32, wide => real64
   use furiko_by_name_sp, only : evaluate
   use furiko_by_name_dp, only : evaluate_wide => evaluate
   use furiko_catalogue, only : argument_count, catalogue, catalogue_entry, find_entry, result_count
   use test_chance, only : chance, one_of, seed_chance, watch
   use testdrive, only : check, error_type, new_unittest, unittest_type
   implicit none
   private
   integer, parameter :: rows = 200
   include 'test_fuzz.inc'
end module test_fuzz_sp


module test_fuzz_dp
#ifdef FURIKO_REAL128
   use, intrinsic :: iso_fortran_env, only : wide => real128
   use furiko_by_name_qp, only : evaluate_wide => evaluate
#else
   use, intrinsic :: iso_fortran_env, only : wide => real64
   use furiko_by_name_dp, only : evaluate_wide => evaluate
#endif
   use, intrinsic :: ieee_arithmetic, only : ieee_is_nan, ieee_negative_inf, ieee_positive_inf, &
      ieee_quiet_nan, ieee_value
   use, intrinsic :: ieee_exceptions, only : ieee_get_flag, ieee_set_flag, ieee_usual
   use, intrinsic :: iso_fortran_env, only : compiler_version, wp => real64
   use furiko_by_name_dp, only : evaluate
   use furiko_catalogue, only : argument_count, catalogue, catalogue_entry, find_entry, result_count
   use test_chance, only : chance, one_of, seed_chance, watch
   use testdrive, only : check, error_type, new_unittest, unittest_type
   implicit none
   private
   integer, parameter :: rows = 100
   include 'test_fuzz.inc'
end module test_fuzz_dp


#ifdef FURIKO_REAL128
module test_fuzz_qp
   use, intrinsic :: ieee_arithmetic, only : ieee_is_nan, ieee_negative_inf, ieee_positive_inf, &
      ieee_quiet_nan, ieee_value
   use, intrinsic :: ieee_exceptions, only : ieee_get_flag, ieee_set_flag, ieee_usual
   use, intrinsic :: iso_fortran_env, only : compiler_version, wp => real128, wide => real128
   use furiko_by_name_qp, only : evaluate, evaluate_wide => evaluate
   use furiko_catalogue, only : argument_count, catalogue, catalogue_entry, find_entry, result_count
   use test_chance, only : chance, one_of, seed_chance, watch
   use testdrive, only : check, error_type, new_unittest, unittest_type
   implicit none
   private
   integer, parameter :: rows = 8
   include 'test_fuzz.inc'
end module test_fuzz_qp
#endif
! rooms: 2104095416
