! SPDX-License-Identifier: MIT
#include "../arithmetic/furiko_compiler.inc"

!> Carlson's duplication for blocks of lanes, as `furiko_duplication_one` does it for one set of arguments:
!> the fast kernel behind the rank-1 entries, where `furiko_duplication` is in words throughout.
!> Internal.
module furiko_duplication_plain_sp
   use, intrinsic :: iso_fortran_env, only : wp => real32, ip => int32
   implicit none
   private
   include 'furiko_duplication_plain.inc'
#include "../arithmetic/furiko_bits.inc"
   include '../arithmetic/furiko_head.inc'
   include 'furiko_rc_series_sp.inc'
end module furiko_duplication_plain_sp


module furiko_duplication_plain_dp
   use, intrinsic :: iso_fortran_env, only : wp => real64, ip => int64
   implicit none
   private
   include 'furiko_duplication_plain.inc'
#include "../arithmetic/furiko_bits.inc"
   include '../arithmetic/furiko_head.inc'
   include 'furiko_rc_series_dp.inc'
end module furiko_duplication_plain_dp
! rooms: 27221617
