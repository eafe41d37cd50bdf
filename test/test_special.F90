! SPDX-License-Identifier: MIT
#include "../src/arithmetic/furiko_compiler.inc"

!> Every function at special arguments, each against each: test/data/special.dat.gz
module test_special_sp
   use, intrinsic :: iso_fortran_env, only : wp => real32
   use, intrinsic :: ieee_arithmetic, only : ieee_is_nan
   use furiko_by_name_sp, only : evaluate
   use test_measurement, only : name_length, unpack
   use test_program, only : test_folder
   use testdrive, only : check, error_type, new_unittest, unittest_type
   implicit none
   private
   include 'test_special.inc'
end module test_special_sp


module test_special_dp
   use, intrinsic :: iso_fortran_env, only : wp => real64
   use, intrinsic :: ieee_arithmetic, only : ieee_is_nan
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
   use, intrinsic :: iso_fortran_env, only : wp => real128
   use, intrinsic :: ieee_arithmetic, only : ieee_is_nan
   use furiko_by_name_qp, only : evaluate
   use test_measurement, only : name_length, unpack
   use test_program, only : test_folder
   use testdrive, only : check, error_type, new_unittest, unittest_type
   implicit none
   private
   include 'test_special.inc'
end module test_special_qp
#endif
! rooms: 3035475288
