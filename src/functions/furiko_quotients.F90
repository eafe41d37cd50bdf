! SPDX-License-Identifier: MIT
#include "../arithmetic/furiko_compiler.inc"

!> Quotients of theta functions for blocks of lanes: the kernel of the Jacobi functions. Internal.
module furiko_quotients_sp
   use, intrinsic :: iso_fortran_env, only : wp => real32, ip => int32
   implicit none
   private
   include 'furiko_quotients.inc'
#include "../arithmetic/furiko_bits.inc"
   include '../arithmetic/furiko_head.inc'
   include '../arithmetic/furiko_nearest_whole.inc'
   include '../arithmetic/furiko_power_of_two.inc'
end module furiko_quotients_sp


module furiko_quotients_dp
   use, intrinsic :: iso_fortran_env, only : wp => real64, ip => int64
   implicit none
   private
   include 'furiko_quotients.inc'
#include "../arithmetic/furiko_bits.inc"
   include '../arithmetic/furiko_head.inc'
   include '../arithmetic/furiko_nearest_whole.inc'
   include '../arithmetic/furiko_power_of_two.inc'
end module furiko_quotients_dp


#ifdef FURIKO_REAL128
module furiko_quotients_qp
   use, intrinsic :: iso_fortran_env, only : wp => real128
   use furiko_bits_qp, only : head, nearest_whole, power_of_two
   implicit none
   private
   include 'furiko_quotients.inc'
end module furiko_quotients_qp
#endif
! rooms: 398674935
