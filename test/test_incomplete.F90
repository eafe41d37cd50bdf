! SPDX-License-Identifier: MIT
#include "../src/arithmetic/furiko_compiler.inc"

module test_incomplete_sp
   use, intrinsic :: iso_fortran_env, only : compiler_version, wp => real32
   use, intrinsic :: ieee_arithmetic, only : ieee_is_nan, ieee_value, ieee_positive_inf, &
      ieee_quiet_nan
   use, intrinsic :: ieee_exceptions, only : ieee_get_flag, ieee_set_flag, ieee_usual
   use furiko, only : bulirsch_cel, carlson_rc, carlson_rd, carlson_rf, carlson_rg, carlson_rj, &
      ellipb_m, ellipb_mc, ellipd_m, ellipd_mc, ellipdinc_k, ellipdinc_m, ellipe_m, ellipe_mc, ellipeinc_m, &
      ellipeinc_mc, ellipf_k, ellipf_m, ellipf_mc, ellipj_m, ellipj_mc, ellipjinc_m, ellipk_m, ellipk_mc, &
      ellippi_m, ellippi_mc, ellippiinc_m, ellips_k, ellips_m, ellips_mc
   use testdrive, only : check, error_type, new_unittest, skip_test, unittest_type
   implicit none
   private
   include 'test_incomplete.inc'
end module test_incomplete_sp


module test_incomplete_dp
   use, intrinsic :: iso_fortran_env, only : compiler_version, wp => real64
   use, intrinsic :: ieee_arithmetic, only : ieee_is_nan, ieee_value, ieee_positive_inf, &
      ieee_quiet_nan
   use, intrinsic :: ieee_exceptions, only : ieee_get_flag, ieee_set_flag, ieee_usual
   use furiko, only : bulirsch_cel, carlson_rc, carlson_rd, carlson_rf, carlson_rg, carlson_rj, &
      ellipb_m, ellipb_mc, ellipd_m, ellipd_mc, ellipdinc_k, ellipdinc_m, ellipe_m, ellipe_mc, ellipeinc_m, &
      ellipeinc_mc, ellipf_k, ellipf_m, ellipf_mc, ellipj_m, ellipj_mc, ellipjinc_m, ellipk_m, ellipk_mc, &
      ellippi_m, ellippi_mc, ellippiinc_m, ellips_k, ellips_m, ellips_mc
   use testdrive, only : check, error_type, new_unittest, skip_test, unittest_type
   implicit none
   private
   include 'test_incomplete.inc'
end module test_incomplete_dp


#ifdef FURIKO_REAL128
module test_incomplete_qp
   use, intrinsic :: iso_fortran_env, only : compiler_version, wp => real128
   use, intrinsic :: ieee_arithmetic, only : ieee_is_nan, ieee_value, ieee_positive_inf, &
      ieee_quiet_nan
   use, intrinsic :: ieee_exceptions, only : ieee_get_flag, ieee_set_flag, ieee_usual
   use furiko, only : bulirsch_cel, carlson_rc, carlson_rd, carlson_rf, carlson_rg, carlson_rj, &
      ellipb_m, ellipb_mc, ellipd_m, ellipd_mc, ellipdinc_k, ellipdinc_m, ellipe_m, ellipe_mc, ellipeinc_m, &
      ellipeinc_mc, ellipf_k, ellipf_m, ellipf_mc, ellipj_m, ellipj_mc, ellipjinc_m, ellipk_m, ellipk_mc, &
      ellippi_m, ellippi_mc, ellippiinc_m, ellips_k, ellips_m, ellips_mc
   use testdrive, only : check, error_type, new_unittest, skip_test, unittest_type
   implicit none
   private
   include 'test_incomplete.inc'
end module test_incomplete_qp
#endif
! rooms: 2259759744
