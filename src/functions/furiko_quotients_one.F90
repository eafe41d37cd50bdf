! SPDX-License-Identifier: MIT
#include "../arithmetic/furiko_compiler.inc"

!> sn, cn and dn of one argument and its own modulus, in real64 and real128. Internal.
module furiko_quotients_one_dp
   use, intrinsic :: iso_fortran_env, only : wp => real64, ip => int64
   use furiko_forms, only : by_k, by_m
   use furiko_half_pi_dp, only : half_pi
   use furiko_quotients_dp, only : cosine, hyperbolic_terms, ln2_head, ln2_rest, mean, per_ln2, sine
   implicit none
   private
   include '../arithmetic/furiko_log_two_dp.inc'
   include 'furiko_jacobi_coefficients_dp.inc'
   include 'furiko_quotients_one.inc'
#include "../arithmetic/furiko_bits.inc"
   include '../arithmetic/furiko_head.inc'
   include '../arithmetic/furiko_is_within.inc'
   include '../arithmetic/furiko_nearest_whole.inc'
   include '../arithmetic/furiko_power_of_two.inc'
end module furiko_quotients_one_dp


#ifdef FURIKO_REAL128
module furiko_quotients_one_qp
   use, intrinsic :: iso_fortran_env, only : int64, qp => real128, wp => real64
   use furiko_bits_qp, only : head, is_within, nearest_whole
   use furiko_forms, only : by_m, by_mc
   use furiko_half_pi_dp, only : half_pi
   implicit none
   private
   include 'furiko_landen.inc'
end module furiko_quotients_one_qp
#endif
! rooms: 2668014855
