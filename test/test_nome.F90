! SPDX-License-Identifier: MIT
#include "../src/arithmetic/furiko_compiler.inc"

module test_nome_sp
   use, intrinsic :: iso_fortran_env, only : compiler_version, wp => real32
   use, intrinsic :: ieee_arithmetic, only : ieee_is_nan, ieee_positive_inf, ieee_quiet_nan, &
      ieee_value
   use, intrinsic :: ieee_exceptions, only : ieee_get_flag, ieee_set_flag, ieee_usual
   use furiko, only : complementary_parameter_from_ellipk, complementary_parameter_from_nome, &
      complementary_parameter_from_period_ratio, ellipe_m, ellipeinc_m, ellipeinc_mc, ellipf_m, &
      ellipf_mc, &
      ellipk_m, ellipk_mc, heuman_lambda_k, heuman_lambda_m, heuman_lambda_mc, jacobi_am_m, &
      jacobi_sn_m, &
      jacobi_zeta_k, jacobi_zeta_m, jacobi_zeta_mc, nome_k, nome_m, nome_mc, &
      parameter_from_ellipk, &
      parameter_from_nome, parameter_from_period_ratio, theta1, theta1_prime, theta2, &
      theta2_prime, &
      theta3, theta3_prime, theta4, theta4_prime
   use testdrive, only : check, error_type, new_unittest, skip_test, unittest_type
   implicit none
   private
   include 'test_nome.inc'
end module test_nome_sp


module test_nome_dp
   use, intrinsic :: iso_fortran_env, only : compiler_version, wp => real64
   use, intrinsic :: ieee_arithmetic, only : ieee_is_nan, ieee_positive_inf, ieee_quiet_nan, &
      ieee_value
   use, intrinsic :: ieee_exceptions, only : ieee_get_flag, ieee_set_flag, ieee_usual
   use furiko, only : complementary_parameter_from_ellipk, complementary_parameter_from_nome, &
      complementary_parameter_from_period_ratio, ellipe_m, ellipeinc_m, ellipeinc_mc, ellipf_m, &
      ellipf_mc, &
      ellipk_m, ellipk_mc, heuman_lambda_k, heuman_lambda_m, heuman_lambda_mc, jacobi_am_m, &
      jacobi_sn_m, &
      jacobi_zeta_k, jacobi_zeta_m, jacobi_zeta_mc, nome_k, nome_m, nome_mc, &
      parameter_from_ellipk, &
      parameter_from_nome, parameter_from_period_ratio, theta1, theta1_prime, theta2, &
      theta2_prime, &
      theta3, theta3_prime, theta4, theta4_prime
   use testdrive, only : check, error_type, new_unittest, skip_test, unittest_type
   implicit none
   private
   include 'test_nome.inc'
end module test_nome_dp


#ifdef FURIKO_REAL128
module test_nome_qp
   use, intrinsic :: iso_fortran_env, only : compiler_version, wp => real128
   use, intrinsic :: ieee_arithmetic, only : ieee_is_nan, ieee_positive_inf, ieee_quiet_nan, &
      ieee_value
   use, intrinsic :: ieee_exceptions, only : ieee_get_flag, ieee_set_flag, ieee_usual
   use furiko, only : complementary_parameter_from_ellipk, complementary_parameter_from_nome, &
      complementary_parameter_from_period_ratio, ellipe_m, ellipeinc_m, ellipeinc_mc, ellipf_m, &
      ellipf_mc, &
      ellipk_m, ellipk_mc, heuman_lambda_k, heuman_lambda_m, heuman_lambda_mc, jacobi_am_m, &
      jacobi_sn_m, &
      jacobi_zeta_k, jacobi_zeta_m, jacobi_zeta_mc, nome_k, nome_m, nome_mc, &
      parameter_from_ellipk, &
      parameter_from_nome, parameter_from_period_ratio, theta1, theta1_prime, theta2, &
      theta2_prime, &
      theta3, theta3_prime, theta4, theta4_prime
   use testdrive, only : check, error_type, new_unittest, skip_test, unittest_type
   implicit none
   private
   include 'test_nome.inc'
end module test_nome_qp
#endif
! rooms: 4099105582
