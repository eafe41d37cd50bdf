! SPDX-License-Identifier: MIT
#include "../arithmetic/furiko_compiler.inc"

module furiko_agm_steps_sp
   use, intrinsic :: iso_fortran_env, only : wp => real32
   use furiko_bits_sp, only : infinity, is_nan, nan
   use furiko_forms, only : by_k, by_m, by_mc
   use furiko_word_arithmetic_sp, only : words, value, pi_words, sqrt, operator(+), operator(-), &
      operator(*), operator(/)
   implicit none
   private
   include 'furiko_agm_steps.inc'
end module furiko_agm_steps_sp


module furiko_agm_steps_dp
   use, intrinsic :: iso_fortran_env, only : wp => real64
   use furiko_bits_dp, only : infinity, is_nan, nan
   use furiko_forms, only : by_k, by_m, by_mc
   use furiko_word_arithmetic_dp, only : words, value, pi_words, sqrt, operator(+), operator(-), &
      operator(*), operator(/)
   implicit none
   private
   include 'furiko_agm_steps.inc'
end module furiko_agm_steps_dp


#ifdef FURIKO_REAL128
module furiko_agm_steps_qp
   use, intrinsic :: iso_fortran_env, only : wp => real128
   use furiko_bits_qp, only : infinity, is_nan, nan
   use furiko_forms, only : by_k, by_m, by_mc
   use furiko_word_arithmetic_qp, only : words, value, pi_words, sqrt, operator(+), operator(-), &
      operator(*), operator(/)
   implicit none
   private
   include 'furiko_agm_steps.inc'
end module furiko_agm_steps_qp
#endif


!> The arithmetic-geometric mean step by step, on its way to K and E.
! allow(C121)
module furiko_agm_steps
   use furiko_agm_steps_sp
   use furiko_agm_steps_dp
#ifdef FURIKO_REAL128
   use furiko_agm_steps_qp
#endif
   implicit none
   public
end module furiko_agm_steps
! rooms: 2428536625
