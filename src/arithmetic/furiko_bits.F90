! SPDX-License-Identifier: MIT
#include "furiko_compiler.inc"

!> What is seen in the bits of a number: NaN, infinity, the leading half of the digits. Internal.
!>
!> Rooms that ask in their innermost loops include the functions as text; the others, and all of
!> real128, use these modules.
module furiko_bits_sp
   use, intrinsic :: iso_fortran_env, only : wp => real32, ip => int32
   implicit none
   private
   include 'furiko_bits_names.inc'
contains
#include "furiko_bits.inc"
   include 'furiko_head.inc'
   include 'furiko_is_nan.inc'
   include 'furiko_is_finite.inc'
end module furiko_bits_sp


module furiko_bits_dp
   use, intrinsic :: iso_fortran_env, only : wp => real64, ip => int64
   implicit none
   private
   include 'furiko_bits_names.inc'
contains
#include "furiko_bits.inc"
   include 'furiko_head.inc'
   include 'furiko_is_nan.inc'
   include 'furiko_is_finite.inc'
end module furiko_bits_dp


#ifdef FURIKO_REAL128
module furiko_bits_qp
   use, intrinsic :: iso_fortran_env, only : wp => real128, ip => int64, int32
   implicit none
   private
   include 'furiko_bits_qp.inc'
end module furiko_bits_qp
#endif
! rooms: 569044787
