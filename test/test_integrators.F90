! SPDX-License-Identifier: MIT
#include "../src/arithmetic/furiko_compiler.inc"

module test_integrators_sp
   use, intrinsic :: iso_fortran_env, only : compiler_version, wp => real32
   use, intrinsic :: ieee_arithmetic, only : ieee_is_nan, ieee_value, &
      ieee_positive_inf, ieee_quiet_nan
   use, intrinsic :: ieee_exceptions, only : ieee_get_flag, ieee_set_flag, ieee_usual
   use furiko, only : ellipf_k, forest_ruth, pendulum_forest_ruth, pendulum_rk4, pendulum_verlet, &
      period_ratio, rk4, verlet
   use furiko_pendulum_rates_sp, only : damped_pendulum_rates, driven_pendulum_rates, &
      pendulum_rates
   use testdrive, only : check, error_type, new_unittest, skip_test, unittest_type
   implicit none
   private
   include 'test_integrators.inc'
end module test_integrators_sp


module test_integrators_dp
   use, intrinsic :: iso_fortran_env, only : compiler_version, wp => real64
   use, intrinsic :: ieee_arithmetic, only : ieee_is_nan, ieee_value, &
      ieee_positive_inf, ieee_quiet_nan
   use, intrinsic :: ieee_exceptions, only : ieee_get_flag, ieee_set_flag, ieee_usual
   use furiko, only : ellipf_k, forest_ruth, pendulum_forest_ruth, pendulum_rk4, pendulum_verlet, &
      period_ratio, rk4, verlet
   use furiko_pendulum_rates_dp, only : damped_pendulum_rates, driven_pendulum_rates, &
      pendulum_rates
   use testdrive, only : check, error_type, new_unittest, skip_test, unittest_type
   implicit none
   private
   include 'test_integrators.inc'
end module test_integrators_dp


#ifdef FURIKO_REAL128
module test_integrators_qp
   use, intrinsic :: iso_fortran_env, only : compiler_version, wp => real128
   use, intrinsic :: ieee_arithmetic, only : ieee_is_nan, ieee_value, &
      ieee_positive_inf, ieee_quiet_nan
   use, intrinsic :: ieee_exceptions, only : ieee_get_flag, ieee_set_flag, ieee_usual
   use furiko, only : ellipf_k, forest_ruth, pendulum_forest_ruth, pendulum_rk4, pendulum_verlet, &
      period_ratio, rk4, verlet
   use furiko_pendulum_rates_qp, only : damped_pendulum_rates, driven_pendulum_rates, &
      pendulum_rates
   use testdrive, only : check, error_type, new_unittest, skip_test, unittest_type
   implicit none
   private
   include 'test_integrators.inc'
end module test_integrators_qp
#endif
! rooms: 2510528991
