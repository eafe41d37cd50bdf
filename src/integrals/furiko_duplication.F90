! SPDX-License-Identifier: MIT
#include "../arithmetic/furiko_compiler.inc"

!> Carlson's duplication in words (hi + lo) for blocks of lanes: the one kernel behind the
!> Carlson forms and the
!> Legendre integrals. Internal; a block of one lane serves the scalar entries.
module furiko_duplication_sp
   use, intrinsic :: iso_fortran_env, only : wp => real32, ip => int32
   implicit none
   private
   include 'furiko_duplication.inc'
#include "../arithmetic/furiko_bits.inc"
   include '../arithmetic/furiko_head.inc'
end module furiko_duplication_sp


module furiko_duplication_dp
   use, intrinsic :: iso_fortran_env, only : wp => real64, ip => int64
   implicit none
   private
   include 'furiko_duplication.inc'
#include "../arithmetic/furiko_bits.inc"
   include '../arithmetic/furiko_head.inc'
end module furiko_duplication_dp


#ifdef FURIKO_REAL128
module furiko_duplication_qp
   use, intrinsic :: iso_fortran_env, only : wp => real128
   use furiko_bits_qp, only : head
   implicit none
   private
   include 'furiko_duplication.inc'
end module furiko_duplication_qp
#endif
! rooms: 3595822355
