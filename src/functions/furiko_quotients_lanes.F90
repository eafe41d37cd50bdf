! SPDX-License-Identifier: MIT
#include "../arithmetic/furiko_compiler.inc"

!> sn, cn and dn of one modulus and many arguments side by side. Internal.
module furiko_quotients_lanes_sp
   use, intrinsic :: iso_fortran_env, only : wp => real32, ip => int32
   use furiko_quotients_sp, only : cosine, hyperbolic_terms, lanes, least_bent, ln2_head, ln2_rest, &
      per_ln2, sine, terms, thetas, two_words_do
   implicit none
   private
   integer, parameter :: width = 8
   include 'furiko_quotients_lanes.inc'
   include '../arithmetic/furiko_quarter_sine_sp.inc'
#include "../arithmetic/furiko_bits.inc"
   include '../arithmetic/furiko_head.inc'
   include '../arithmetic/furiko_nearest_whole.inc'
   include '../arithmetic/furiko_power_of_two.inc'
   include '../arithmetic/furiko_tame.inc'
end module furiko_quotients_lanes_sp


module furiko_quotients_lanes_dp
   use, intrinsic :: iso_fortran_env, only : wp => real64, ip => int64
   use furiko_quotients_dp, only : cosine, hyperbolic_terms, lanes, least_bent, ln2_head, ln2_rest, &
      per_ln2, sine, terms, thetas, two_words_do
   implicit none
   private
   integer, parameter :: width = 8
   include 'furiko_quotients_lanes.inc'
   include '../arithmetic/furiko_quarter_sine_dp.inc'
#include "../arithmetic/furiko_bits.inc"
   include '../arithmetic/furiko_head.inc'
   include '../arithmetic/furiko_nearest_whole.inc'
   include '../arithmetic/furiko_power_of_two.inc'
   include '../arithmetic/furiko_tame.inc'
end module furiko_quotients_lanes_dp
! rooms: 1445949451
