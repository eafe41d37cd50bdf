! SPDX-License-Identifier: MIT
#include "furiko_compiler.inc"

!> The arctangent of two numbers, one lane at a time; many are in furiko_arctangent.F90: the same text in
!> another file, for gfortran folds what is the same in one, and then does not inline it. Internal.
module furiko_arctangent_one_sp
   use, intrinsic :: iso_fortran_env, only : wp => real32, ip => int32
   use furiko_half_pi_sp, only : half_pi
   implicit none
   private
   integer, parameter :: width = 1
   include 'furiko_arctangent.inc'
   include 'furiko_arctangent_sp.inc'
#include "furiko_bits.inc"
   include 'furiko_head.inc'
end module furiko_arctangent_one_sp


module furiko_arctangent_one_dp
   use, intrinsic :: iso_fortran_env, only : wp => real64, ip => int64
   use furiko_half_pi_dp, only : half_pi
   implicit none
   private
   integer, parameter :: width = 1
   include 'furiko_arctangent.inc'
   include 'furiko_arctangent_dp.inc'
#include "furiko_bits.inc"
   include 'furiko_head.inc'
end module furiko_arctangent_one_dp
! rooms: 2842565799
