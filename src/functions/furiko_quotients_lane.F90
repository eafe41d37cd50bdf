! SPDX-License-Identifier: MIT
#include "../arithmetic/furiko_compiler.inc"

!> sn, cn and dn of one modulus, one argument at a time; many are in furiko_quotients_lanes.F90: the same
!> text in another file, for gfortran folds what is the same in one, and then does not inline it. Internal.
module furiko_quotients_lane_sp
   use, intrinsic :: iso_fortran_env, only : wp => real32, ip => int32
   use furiko_quotients_sp, only : cosine, hyperbolic_terms, lanes, least_bent, ln2_head, ln2_rest, &
      per_ln2, sine, terms, thetas, two_words_do
   implicit none
   private
   integer, parameter :: width = 1
   include 'furiko_quotients_lanes.inc'
   include '../arithmetic/furiko_quarter_sine_sp.inc'
#include "../arithmetic/furiko_bits.inc"
   include '../arithmetic/furiko_head.inc'
   include '../arithmetic/furiko_nearest_whole.inc'
   include '../arithmetic/furiko_power_of_two.inc'
   include '../arithmetic/furiko_tame.inc'
end module furiko_quotients_lane_sp


module furiko_quotients_lane_dp
   use, intrinsic :: iso_fortran_env, only : wp => real64, ip => int64
   use furiko_quotients_dp, only : cosine, hyperbolic_terms, lanes, least_bent, ln2_head, ln2_rest, &
      per_ln2, sine, terms, thetas, two_words_do
   implicit none
   private
   integer, parameter :: width = 1
   include 'furiko_quotients_lanes.inc'
   include '../arithmetic/furiko_quarter_sine_dp.inc'
#include "../arithmetic/furiko_bits.inc"
   include '../arithmetic/furiko_head.inc'
   include '../arithmetic/furiko_nearest_whole.inc'
   include '../arithmetic/furiko_power_of_two.inc'
   include '../arithmetic/furiko_tame.inc'
end module furiko_quotients_lane_dp


#ifdef FURIKO_REAL128
module furiko_quotients_lane_qp
   use, intrinsic :: iso_fortran_env, only : wp => real128
   use furiko_bits_qp, only : head, nearest_whole, power_of_two, tame
   use furiko_quotients_qp, only : cosine, hyperbolic_terms, lanes, least_bent, ln2_head, ln2_rest, &
      per_ln2, sine, terms, thetas, two_words_do
   implicit none
   private
   integer, parameter :: width = 1
   include 'furiko_quotients_lanes.inc'
   include '../arithmetic/furiko_quarter_sine_qp.inc'
end module furiko_quotients_lane_qp
#endif
! rooms: 1606321855
