! SPDX-License-Identifier: MIT
#include "../arithmetic/furiko_compiler.inc"

module furiko_third_kind_sp
   use, intrinsic :: iso_fortran_env, only : wp => real32
   use furiko_forms, only : by_k, by_m, by_mc
   use furiko_legendre_plain_sp, only : integral, complete_third
   use furiko_legendre_sp, only : third
   implicit none
   private
   include 'furiko_third_kind.inc'
end module furiko_third_kind_sp


module furiko_third_kind_dp
   use, intrinsic :: iso_fortran_env, only : wp => real64
   use furiko_forms, only : by_k, by_m, by_mc
   use furiko_legendre_plain_dp, only : integral, complete_third
   use furiko_legendre_dp, only : third
   implicit none
   private
   include 'furiko_third_kind.inc'
end module furiko_third_kind_dp


#ifdef FURIKO_REAL128
module furiko_third_kind_qp
   use, intrinsic :: iso_fortran_env, only : wp => real128
   use furiko_forms, only : by_k, by_m, by_mc
   use furiko_legendre_one_qp, only : integral, complete_third => complete_third_of_one
   use furiko_legendre_qp, only : third
   implicit none
   private
   include 'furiko_third_kind.inc'
end module furiko_third_kind_qp
#endif


!> Elliptic integrals of the third kind, complete and incomplete, in real32, real64 and real128.
!> Rank-1 arguments go to a batch of lanes; scalars and other ranks are elemental.
! allow(C121)
module furiko_third_kind
   use furiko_third_kind_sp
   use furiko_third_kind_dp
#ifdef FURIKO_REAL128
   use furiko_third_kind_qp
#endif
   implicit none
   public
end module furiko_third_kind
! rooms: 83273896
