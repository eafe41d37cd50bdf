! SPDX-License-Identifier: MIT
#include "furiko_compiler.inc"

!> pi/2 in parts of half the bits, in each kind of real: their products with whole numbers are exact.
!> Internal.
module furiko_half_pi_sp
   use, intrinsic :: iso_fortran_env, only : wp => real32
   implicit none
   private
   public :: half_pi
   include 'furiko_half_pi_sp.inc'
end module furiko_half_pi_sp


module furiko_half_pi_dp
   use, intrinsic :: iso_fortran_env, only : wp => real64
   implicit none
   private
   public :: half_pi
   include 'furiko_half_pi_dp.inc'
end module furiko_half_pi_dp


#ifdef FURIKO_REAL128
module furiko_half_pi_qp
   use, intrinsic :: iso_fortran_env, only : wp => real128
   implicit none
   private
   public :: half_pi
   include 'furiko_half_pi_qp.inc'
end module furiko_half_pi_qp
#endif
! rooms: 1601300663
