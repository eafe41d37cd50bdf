! SPDX-License-Identifier: MIT
#include "furiko_compiler.inc"

!> Numbers of more than four times the digits of a kind and of any exponent. Internal.
!>
!> For the few arguments where words do not do: next to a pole or an edge, where most digits cancel,
!> and spread over more than the exponent range. Integer arithmetic in base 2**24, so that no flag is
!> raised but by the one rounding at the end; a product takes a tenth of a microsecond.
module furiko_long_sp
   use, intrinsic :: iso_fortran_env, only : wp => real32, int64
   implicit none
   private
   include 'furiko_long.inc'
end module furiko_long_sp


module furiko_long_dp
   use, intrinsic :: iso_fortran_env, only : wp => real64, int64
   implicit none
   private
   include 'furiko_long.inc'
end module furiko_long_dp


#ifdef FURIKO_REAL128
module furiko_long_qp
   use, intrinsic :: iso_fortran_env, only : wp => real128, int64
   implicit none
   private
   include 'furiko_long.inc'
end module furiko_long_qp
#endif
! rooms: 3578559237
