! SPDX-License-Identifier: MIT

!> The note's AGM and series as anyone would write them, to be timed beside the library's, which carry
!> each rounding error.
module bench_note_dp
   use, intrinsic :: iso_fortran_env, only : wp => real64
   implicit none
   private
   include 'bench_note.inc'
end module bench_note_dp


module bench_note_qp
   use, intrinsic :: iso_fortran_env, only : wp => real128
   implicit none
   private
#ifdef __GFC_REAL_16__
   include 'bench_note.inc'
#endif
end module bench_note_qp
! rooms: 2845852919
