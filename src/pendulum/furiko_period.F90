! SPDX-License-Identifier: MIT
#include "../arithmetic/furiko_compiler.inc"

!> The period of the pendulum, in each kind of real; the text is in furiko_period.inc.
module furiko_period_sp
   use, intrinsic :: iso_fortran_env, only : wp => real32
   use furiko_bits_sp, only : is_nan, nan
   use furiko_fold_sp, only : fold
   use furiko_nome_sp, only : nome_ratio
   use furiko_parameter_of_k_sp, only : parameters_of_words
   use furiko_word_arithmetic_sp, only : words, value, sqrt, operator(+), operator(-), &
      operator(*), operator(/), mean_with_one, pi_words
   implicit none
   private
   include 'furiko_period.inc'
   include 'furiko_period_words.inc'
end module furiko_period_sp


module furiko_period_dp
   use, intrinsic :: iso_fortran_env, only : wp => real64
   use furiko_bits_dp, only : is_nan, nan
   use furiko_fold_dp, only : fold
   use furiko_nome_dp, only : nome_ratio
   use furiko_parameter_of_k_dp, only : parameters_of_words
   use furiko_word_arithmetic_dp, only : words, value, sqrt, operator(+), operator(-), &
      operator(*), operator(/), mean_with_one, pi_words
   implicit none
   private
   include 'furiko_period.inc'
   include 'furiko_period_words.inc'
end module furiko_period_dp


#ifdef FURIKO_REAL128
module furiko_period_qp
   use, intrinsic :: iso_fortran_env, only : wp => real128
   use furiko_bits_qp, only : is_nan, nan
   use furiko_parameter_of_k_qp, only : parameters_of_words
   use furiko_word_arithmetic_qp, only : words, value, sqrt, operator(+), operator(-), &
      operator(*), operator(/), pi_words
   implicit none
   private
   include 'furiko_period.inc'
   include 'furiko_period_agm.inc'
end module furiko_period_qp
#endif


! allow(C121)
module furiko_period
   use furiko_period_sp
   use furiko_period_dp
#ifdef FURIKO_REAL128
   use furiko_period_qp
#endif
   implicit none
   public
end module furiko_period
! rooms: 1590140926
