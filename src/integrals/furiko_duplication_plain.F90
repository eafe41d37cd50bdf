! SPDX-License-Identifier: MIT

!> Carlson's duplication for blocks of lanes, words at both ends and plain precision between: the
!> fast kernel behind the rank-1 entries, where `furiko_duplication` is in words throughout.
!> Internal.
module furiko_duplication_plain_sp
   use, intrinsic :: iso_fortran_env, only : wp => real32, int32
   use furiko_duplication_sp, only : lanes
   implicit none
   private
   include 'furiko_duplication_plain.inc'
   include '../arithmetic/furiko_head_sp.inc'
end module furiko_duplication_plain_sp


module furiko_duplication_plain_dp
   use, intrinsic :: iso_fortran_env, only : wp => real64, int64
   use furiko_duplication_dp, only : lanes
   implicit none
   private
   include 'furiko_duplication_plain.inc'
   include '../arithmetic/furiko_head_dp.inc'
end module furiko_duplication_plain_dp
