! SPDX-License-Identifier: MIT
#include "../arithmetic/furiko_compiler.inc"

module furiko_inverse_period_sp
   use, intrinsic :: iso_fortran_env, only : wp => real32
   use furiko_bits_sp, only : infinity, is_nan, nan
   use furiko_half_pi_sp, only : half_pi
   use furiko_parameter_of_k_sp, only : parameters_of_words
   use furiko_word_arithmetic_sp, only : words, operator(-), operator(*), operator(/), pi_words
   implicit none
   private
   include 'furiko_inverse_period.inc'
end module furiko_inverse_period_sp


module furiko_inverse_period_dp
   use, intrinsic :: iso_fortran_env, only : wp => real64
   use furiko_bits_dp, only : infinity, is_nan, nan
   use furiko_half_pi_dp, only : half_pi
   use furiko_parameter_of_k_dp, only : parameters_of_words
   use furiko_word_arithmetic_dp, only : words, operator(-), operator(*), operator(/), pi_words
   implicit none
   private
   include 'furiko_inverse_period.inc'
end module furiko_inverse_period_dp


#ifdef FURIKO_REAL128
module furiko_inverse_period_qp
   use, intrinsic :: iso_fortran_env, only : wp => real128
   use furiko_bits_qp, only : infinity, is_nan, nan
   use furiko_half_pi_qp, only : half_pi
   use furiko_parameter_of_k_qp, only : parameters_of_words
   use furiko_word_arithmetic_qp, only : words, operator(-), operator(*), operator(/), pi_words
   implicit none
   private
   include 'furiko_inverse_period.inc'
end module furiko_inverse_period_qp
#endif


!> The parameter of a complete integral of the first kind or of a pendulum's period, in real32,
!> real64 and real128
! allow(C121)
module furiko_inverse_period
   use furiko_inverse_period_sp
   use furiko_inverse_period_dp
#ifdef FURIKO_REAL128
   use furiko_inverse_period_qp
#endif
   implicit none
   public
end module furiko_inverse_period
! rooms: 3730169734
