! SPDX-License-Identifier: MIT
#include "../arithmetic/furiko_compiler.inc"

!> What quotients of theta functions need to know of a modulus. Internal.
module furiko_quotients_sp
   use, intrinsic :: iso_fortran_env, only : wp => real32
   implicit none
   private
   include 'furiko_quotients.inc'
end module furiko_quotients_sp


module furiko_quotients_dp
   use, intrinsic :: iso_fortran_env, only : wp => real64
   implicit none
   private
   include 'furiko_quotients.inc'
end module furiko_quotients_dp


#ifdef FURIKO_REAL128
module furiko_quotients_qp
   use, intrinsic :: iso_fortran_env, only : wp => real128
   implicit none
   private
   include 'furiko_quotients.inc'
end module furiko_quotients_qp
#endif
! rooms: 187191109
