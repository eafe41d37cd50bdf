! SPDX-License-Identifier: MIT

!> Carlson's duplication in words (hi + lo) for blocks of lanes: the one kernel behind the
!> Carlson forms and the
!> Legendre integrals. Internal; a block of one lane serves the scalar entries.
module furiko_duplication_sp
   use, intrinsic :: iso_fortran_env, only : wp => real32, int32
   implicit none
   private
   include 'furiko_duplication.inc'
   include '../arithmetic/furiko_head_sp.inc'
end module furiko_duplication_sp


module furiko_duplication_dp
   use, intrinsic :: iso_fortran_env, only : wp => real64, int64
   implicit none
   private
   include 'furiko_duplication.inc'
   include '../arithmetic/furiko_head_dp.inc'
end module furiko_duplication_dp


#ifdef __GFC_REAL_16__
module furiko_duplication_qp
   use, intrinsic :: iso_fortran_env, only : wp => real128, int32, int64
   implicit none
   private
   include 'furiko_duplication.inc'
   include '../arithmetic/furiko_head_qp.inc'
end module furiko_duplication_qp
#endif
