! SPDX-License-Identifier: MIT
#include "../src/arithmetic/furiko_compiler.inc"

module test_motion_sp
   use, intrinsic :: iso_fortran_env, only : compiler_version, wp => real32
   use, intrinsic :: ieee_arithmetic, only : ieee_is_nan, ieee_positive_inf, ieee_quiet_nan, ieee_value
   use, intrinsic :: ieee_exceptions, only : ieee_get_flag, ieee_get_halting_mode, &
      ieee_overflow, ieee_set_flag, ieee_usual
   use furiko, only : amplitude_of_excess, amplitude_of_period, ellipf_k, motion => motion_real32, &
      pendulum => pendulum_real32, period_excess, period_ratio
   use test_by_name_sp, only : motion_from, yardstick
   use test_measurement, only : unpack
   use test_program, only : test_folder
   use testdrive, only : check, error_type, new_unittest, skip_test, unittest_type
   implicit none
   private
   character(len=*), parameter :: kind_name = 'real32'
   include 'test_motion.inc'
end module test_motion_sp


module test_motion_dp
   use, intrinsic :: iso_fortran_env, only : compiler_version, wp => real64
   use, intrinsic :: ieee_arithmetic, only : ieee_is_nan, ieee_positive_inf, ieee_quiet_nan, ieee_value
   use, intrinsic :: ieee_exceptions, only : ieee_get_flag, ieee_get_halting_mode, &
      ieee_overflow, ieee_set_flag, ieee_usual
   use furiko, only : amplitude_of_excess, amplitude_of_period, ellipf_k, motion, pendulum, &
      period_excess, period_ratio
   use test_by_name_dp, only : motion_from, yardstick
   use test_measurement, only : unpack
   use test_program, only : test_folder
   use testdrive, only : check, error_type, new_unittest, skip_test, unittest_type
   implicit none
   private
   character(len=*), parameter :: kind_name = 'real64'
   include 'test_motion.inc'
end module test_motion_dp


#ifdef FURIKO_REAL128
module test_motion_qp
   use, intrinsic :: iso_fortran_env, only : compiler_version, wp => real128
   use, intrinsic :: ieee_arithmetic, only : ieee_is_nan, ieee_positive_inf, ieee_quiet_nan, ieee_value
   use, intrinsic :: ieee_exceptions, only : ieee_get_flag, ieee_get_halting_mode, &
      ieee_overflow, ieee_set_flag, ieee_usual
   use furiko, only : amplitude_of_excess, amplitude_of_period, ellipf_k, motion => motion_real128, &
      pendulum => pendulum_real128, period_excess, period_ratio
   use test_by_name_qp, only : motion_from, yardstick
   use test_measurement, only : unpack
   use test_program, only : test_folder
   use testdrive, only : check, error_type, new_unittest, skip_test, unittest_type
   implicit none
   private
   character(len=*), parameter :: kind_name = 'real128'
   include 'test_motion.inc'
end module test_motion_qp
#endif
! rooms: 4171958878
