! SPDX-License-Identifier: MIT
#include "../src/arithmetic/furiko_compiler.inc"

!> Every function at special arguments, each against each: test/data/special.dat.gz
module test_special_sp
   use, intrinsic :: iso_fortran_env, only : compiler_version, real64, wp => real32
   use, intrinsic :: ieee_arithmetic, only : ieee_is_nan, ieee_positive_inf, ieee_quiet_nan, ieee_value
   use, intrinsic :: ieee_exceptions, only : ieee_get_flag, ieee_set_flag, ieee_usual
   use furiko, only : modulus => modulus_real32, carlson_rc, carlson_rd, carlson_rf, carlson_rg, carlson_rj, &
      ellipe_k, ellipe_m, ellipe_mc, ellipk_k, ellipk_m, ellipk_mc, modulus_from_k, modulus_from_m, &
      modulus_from_mc, nome_k, nome_m, nome_mc
   use furiko_by_name_sp, only : evaluate
   use test_measurement, only : name_length, unpack
   use test_program, only : test_folder
   use testdrive, only : check, error_type, new_unittest, unittest_type
   implicit none
   private
   include 'test_special.inc'
end module test_special_sp


module test_special_dp
   use, intrinsic :: iso_fortran_env, only : compiler_version, real64, wp => real64
   use, intrinsic :: ieee_arithmetic, only : ieee_is_nan, ieee_positive_inf, ieee_quiet_nan, ieee_value
   use, intrinsic :: ieee_exceptions, only : ieee_get_flag, ieee_set_flag, ieee_usual
   use furiko, only : modulus, carlson_rc, carlson_rd, carlson_rf, carlson_rg, carlson_rj, &
      ellipe_k, ellipe_m, ellipe_mc, ellipk_k, ellipk_m, ellipk_mc, modulus_from_k, modulus_from_m, &
      modulus_from_mc, nome_k, nome_m, nome_mc
   use furiko_by_name_dp, only : evaluate
   use test_measurement, only : name_length, unpack
   use test_program, only : test_folder
   use testdrive, only : check, error_type, new_unittest, unittest_type
   implicit none
   private
   include 'test_special.inc'
end module test_special_dp


#ifdef FURIKO_REAL128
module test_special_qp
   use, intrinsic :: iso_fortran_env, only : compiler_version, real64, wp => real128
   use, intrinsic :: ieee_arithmetic, only : ieee_is_nan, ieee_positive_inf, ieee_quiet_nan, ieee_value
   use, intrinsic :: ieee_exceptions, only : ieee_get_flag, ieee_set_flag, ieee_usual
   use furiko, only : modulus => modulus_real128, carlson_rc, carlson_rd, carlson_rf, carlson_rg, &
      carlson_rj, ellipe_k, ellipe_m, ellipe_mc, ellipk_k, ellipk_m, ellipk_mc, modulus_from_k, &
      modulus_from_m, modulus_from_mc, nome_k, nome_m, nome_mc
   use furiko_by_name_qp, only : evaluate
   use test_measurement, only : name_length, unpack
   use test_program, only : test_folder
   use testdrive, only : check, error_type, new_unittest, unittest_type
   implicit none
   private
   include 'test_special.inc'
end module test_special_qp
#endif
! rooms: 3651636184
