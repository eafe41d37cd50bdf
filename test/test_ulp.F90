! SPDX-License-Identifier: MIT
#include "../src/arithmetic/furiko_compiler.inc"

module test_ulp_sp
   use, intrinsic :: iso_fortran_env, only : wp => real32
   implicit none
   private
   include 'test_ulp.inc'
end module test_ulp_sp


module test_ulp_dp
   use, intrinsic :: iso_fortran_env, only : wp => real64
   implicit none
   private
   include 'test_ulp.inc'
end module test_ulp_dp


#ifdef FURIKO_REAL128
module test_ulp_qp
   use, intrinsic :: iso_fortran_env, only : wp => real128
   implicit none
   private
   include 'test_ulp.inc'
end module test_ulp_qp
#endif


module test_ulp
   use test_ulp_sp, only : ulps
   use test_ulp_dp, only : ulps
#ifdef FURIKO_REAL128
   use test_ulp_qp, only : ulps
#endif
   implicit none
   private
   public :: ulps
end module test_ulp
! rooms: 2097068212
