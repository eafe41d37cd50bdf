! SPDX-License-Identifier: MIT
#include "../arithmetic/furiko_compiler.inc"

module furiko_theta_sp
   use, intrinsic :: iso_fortran_env, only : wp => real32
   use furiko_bits_sp, only : is_nan, nan
   use furiko_fold_sp, only : quadrant_of
   use furiko_word_arithmetic_sp, only : words, value, operator(+), operator(-), operator(*), &
      operator(/), sqrt, log, scale, exponential, exp_minus_one, pi_words
   implicit none
   private
   include 'furiko_theta.inc'
end module furiko_theta_sp


module furiko_theta_dp
   use, intrinsic :: iso_fortran_env, only : wp => real64
   use furiko_bits_dp, only : is_nan, nan
   use furiko_fold_dp, only : quadrant_of
   use furiko_word_arithmetic_dp, only : words, value, operator(+), operator(-), operator(*), &
      operator(/), sqrt, log, scale, exponential, exp_minus_one, pi_words
   implicit none
   private
   include 'furiko_theta.inc'
end module furiko_theta_dp


#ifdef FURIKO_REAL128
module furiko_theta_qp
   use, intrinsic :: iso_fortran_env, only : wp => real128
   use furiko_bits_qp, only : is_nan, nan
   use furiko_fold_qp, only : quadrant_of
   use furiko_word_arithmetic_qp, only : words, value, operator(+), operator(-), operator(*), &
      operator(/), sqrt, log, scale, exponential, exp_minus_one, pi_words
   implicit none
   private
   include 'furiko_theta.inc'
end module furiko_theta_qp
#endif


!> Jacobi's theta functions of a real angle and their derivatives, in real32, real64 and real128
! allow(C121)
module furiko_theta
   use furiko_theta_sp
   use furiko_theta_dp
#ifdef FURIKO_REAL128
   use furiko_theta_qp
#endif
   implicit none
   public
end module furiko_theta
! rooms: 1386793096
