! SPDX-License-Identifier: MIT
#include "../arithmetic/furiko_compiler.inc"

module furiko_incomplete_sp
   use, intrinsic :: iso_fortran_env, only : wp => real32
   use furiko_forms, only : by_k, by_m, by_mc
   use furiko_legendre_plain_sp, only : integral
   use furiko_legendre_sp, only : first, second, second_d
   implicit none
   private
   include 'furiko_incomplete.inc'
end module furiko_incomplete_sp


module furiko_incomplete_dp
   use, intrinsic :: iso_fortran_env, only : wp => real64
   use furiko_forms, only : by_k, by_m, by_mc
   use furiko_legendre_plain_dp, only : integral
   use furiko_legendre_dp, only : first, second, second_d
   implicit none
   private
   include 'furiko_incomplete.inc'
end module furiko_incomplete_dp


#ifdef FURIKO_REAL128
module furiko_incomplete_qp
   use, intrinsic :: iso_fortran_env, only : wp => real128
   use furiko_forms, only : by_k, by_m, by_mc
   use furiko_legendre_one_qp, only : integral
   use furiko_legendre_qp, only : first, second, second_d
   implicit none
   private
   include 'furiko_incomplete.inc'
end module furiko_incomplete_qp
#endif


!> Legendre's incomplete integrals F, E and D for any real angle, in real32, real64 and real128.
!> Rank-1 arguments go to a batch of lanes; scalars and other ranks are elemental.
! allow(C121)
module furiko_incomplete
   use furiko_incomplete_sp
   use furiko_incomplete_dp
#ifdef FURIKO_REAL128
   use furiko_incomplete_qp
#endif
   implicit none
   public
end module furiko_incomplete
! rooms: 3255315519
