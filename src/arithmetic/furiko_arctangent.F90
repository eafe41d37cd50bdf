! SPDX-License-Identifier: MIT
#include "furiko_compiler.inc"

!> The arctangent of two numbers for blocks of lanes, where the compiler's library offers one lane at
!> a time or fewer bits; the text is in furiko_arctangent.inc. Internal.
module furiko_arctangent_sp
   use, intrinsic :: iso_fortran_env, only : wp => real32, ip => int32
   use furiko_half_pi_sp, only : half_pi
   implicit none
   private
   integer, parameter :: width = 8
   include 'furiko_arctangent.inc'
   include 'furiko_arctangent_sp.inc'
#include "furiko_bits.inc"
   include 'furiko_head.inc'
end module furiko_arctangent_sp


module furiko_arctangent_dp
   use, intrinsic :: iso_fortran_env, only : wp => real64, ip => int64
   use furiko_half_pi_dp, only : half_pi
   implicit none
   private
   integer, parameter :: width = 8
   include 'furiko_arctangent.inc'
   include 'furiko_arctangent_dp.inc'
#include "furiko_bits.inc"
   include 'furiko_head.inc'
end module furiko_arctangent_dp


#ifdef FURIKO_REAL128
module furiko_arctangent_qp
   use, intrinsic :: iso_fortran_env, only : wp => real128
   implicit none
   private
   include 'furiko_arctangent_plain.inc'
end module furiko_arctangent_qp
#endif
! rooms: 3160264989
