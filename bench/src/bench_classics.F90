! SPDX-License-Identifier: MIT

!> Ways to K in real64 and real128: the note's AGM and series as anyone would write them beside the
!> library's, which carry each rounding error. Empty where there is no real128.
module bench_classics_dp
   use, intrinsic :: iso_fortran_env, only : dp => real64, int64, qp => real128, wp => real64
   use furiko, only : agm_steps_k, ellipk_k, ellipk_series_k, ellipk_trapezoid_k
   implicit none
   private
#ifdef __GFC_REAL_16__
   include 'bench_classics.inc'
#endif
end module bench_classics_dp


module bench_classics_qp
   use, intrinsic :: iso_fortran_env, only : dp => real64, int64, qp => real128, wp => real128
   use furiko, only : agm_steps_k, ellipk_k, ellipk_series_k, ellipk_trapezoid_k
   implicit none
   private
#ifdef __GFC_REAL_16__
   include 'bench_classics.inc'
#endif
end module bench_classics_qp
! rooms: 3860846342
