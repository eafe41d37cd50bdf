! SPDX-License-Identifier: MIT
#include "../arithmetic/furiko_compiler.inc"

!> Quotients of theta functions for blocks of lanes: the kernel of the Jacobi functions. Internal.
module furiko_quotients_sp
   use, intrinsic :: iso_fortran_env, only : wp => real32, ip => int32
   use furiko_bits_sp, only : infinity
   use furiko_half_pi_sp, only : half_pi
   implicit none
   private
   include 'furiko_quotients.inc'
#include "../arithmetic/furiko_bits.inc"
   include '../arithmetic/furiko_head.inc'
   include '../arithmetic/furiko_nearest_whole.inc'
   include '../arithmetic/furiko_is_finite.inc'
   include '../arithmetic/furiko_is_nan.inc'
   include '../arithmetic/furiko_power_of_two.inc'
end module furiko_quotients_sp


module furiko_quotients_dp
   use, intrinsic :: iso_fortran_env, only : wp => real64, ip => int64
   use furiko_bits_dp, only : infinity
   use furiko_half_pi_dp, only : half_pi
   implicit none
   private
   include 'furiko_quotients.inc'
#include "../arithmetic/furiko_bits.inc"
   include '../arithmetic/furiko_head.inc'
   include '../arithmetic/furiko_nearest_whole.inc'
   include '../arithmetic/furiko_is_finite.inc'
   include '../arithmetic/furiko_is_nan.inc'
   include '../arithmetic/furiko_power_of_two.inc'
end module furiko_quotients_dp


#ifdef FURIKO_REAL128
module furiko_quotients_qp
   use, intrinsic :: iso_fortran_env, only : wp => real128
   use furiko_bits_qp, only : head, is_finite, is_nan, nearest_whole, power_of_two
   use furiko_half_pi_qp, only : half_pi
   implicit none
   private
   include 'furiko_quotients.inc'
end module furiko_quotients_qp
#endif
! rooms: 1258820679
