! SPDX-License-Identifier: MIT
#include "../arithmetic/furiko_compiler.inc"

!> sn, cn and dn for blocks of lanes of which each has its own modulus. Internal.
module furiko_quotients_many_sp
   use, intrinsic :: iso_fortran_env, only : wp => real32, ip => int32
   use furiko_bits_sp, only : infinity
   use furiko_forms, only : by_k, by_m, by_mc
   use furiko_half_pi_sp, only : half_pi
   use furiko_quotients_sp, only : circular_terms, cosine, hyperbolic_terms, ln2_head, ln2_rest, &
      per_ln2, sine
   implicit none
   private
   include '../arithmetic/furiko_log_two_sp.inc'
   include 'furiko_quotients_many.inc'
#include "../arithmetic/furiko_bits.inc"
   include '../arithmetic/furiko_head.inc'
   include '../arithmetic/furiko_nearest_whole.inc'
   include '../arithmetic/furiko_is_nan.inc'
   include '../arithmetic/furiko_power_of_two.inc'
end module furiko_quotients_many_sp


module furiko_quotients_many_dp
   use, intrinsic :: iso_fortran_env, only : wp => real64, ip => int64
   use furiko_bits_dp, only : infinity
   use furiko_forms, only : by_k, by_m, by_mc
   use furiko_half_pi_dp, only : half_pi
   use furiko_quotients_dp, only : circular_terms, cosine, hyperbolic_terms, ln2_head, ln2_rest, &
      per_ln2, sine
   implicit none
   private
   include '../arithmetic/furiko_log_two_dp.inc'
   include 'furiko_quotients_many.inc'
#include "../arithmetic/furiko_bits.inc"
   include '../arithmetic/furiko_head.inc'
   include '../arithmetic/furiko_nearest_whole.inc'
   include '../arithmetic/furiko_is_nan.inc'
   include '../arithmetic/furiko_power_of_two.inc'
end module furiko_quotients_many_dp
! rooms: 2433818918
