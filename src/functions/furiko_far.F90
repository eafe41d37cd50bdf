! SPDX-License-Identifier: MIT
#include "../arithmetic/furiko_compiler.inc"

!> How many quarter periods a huge argument has. Internal.
module furiko_far_sp
   use, intrinsic :: iso_fortran_env, only : int64, wp => real32
   use furiko_forms, only : by_k, by_m, by_mc, by_k_of_complement
   use furiko_long_numbers, only : limb_bits, long_difference, long_mean, long_number, &
      long_product, long_root, long_sum, most_limbs, two_over_pi_long
   implicit none
   private
   include 'furiko_far.inc'
end module furiko_far_sp


module furiko_far_dp
   use, intrinsic :: iso_fortran_env, only : int64, wp => real64
   use furiko_forms, only : by_k, by_m, by_mc, by_k_of_complement
   use furiko_long_numbers, only : limb_bits, long_difference, long_mean, long_number, &
      long_product, long_root, long_sum, most_limbs, two_over_pi_long
   implicit none
   private
   include 'furiko_far.inc'
end module furiko_far_dp


#ifdef FURIKO_REAL128
module furiko_far_qp
   use, intrinsic :: iso_fortran_env, only : int64, wp => real128
   use furiko_forms, only : by_k, by_m, by_mc, by_k_of_complement
   use furiko_long_numbers, only : limb_bits, long_difference, long_mean, long_number, &
      long_product, long_root, long_sum, most_limbs, two_over_pi_long
   implicit none
   private
   include 'furiko_far.inc'
end module furiko_far_qp
#endif
! rooms: 75574955
