! SPDX-License-Identifier: MIT
#include "../arithmetic/furiko_compiler.inc"

module furiko_second_inverse_sp
   use, intrinsic :: iso_fortran_env, only : wp => real32
   use furiko_bits_sp, only : is_nan, nan
   use furiko_fold_sp, only : fold
   use furiko_forms, only : by_k, by_m, by_mc
   use furiko_legendre_sp, only : second_in_words
   use furiko_parameters_sp, only : parameters, outside
   use furiko_word_arithmetic_sp, only : words, value, operator(+), operator(-), operator(*), &
      operator(/), scale, pi_words
   implicit none
   private
   include 'furiko_second_inverse.inc'
end module furiko_second_inverse_sp


module furiko_second_inverse_dp
   use, intrinsic :: iso_fortran_env, only : wp => real64
   use furiko_bits_dp, only : is_nan, nan
   use furiko_fold_dp, only : fold
   use furiko_forms, only : by_k, by_m, by_mc
   use furiko_legendre_dp, only : second_in_words
   use furiko_parameters_dp, only : parameters, outside
   use furiko_word_arithmetic_dp, only : words, value, operator(+), operator(-), operator(*), &
      operator(/), scale, pi_words
   implicit none
   private
   include 'furiko_second_inverse.inc'
end module furiko_second_inverse_dp


#ifdef FURIKO_REAL128
module furiko_second_inverse_qp
   use, intrinsic :: iso_fortran_env, only : wp => real128
   use furiko_bits_qp, only : is_nan, nan
   use furiko_fold_qp, only : fold
   use furiko_forms, only : by_k, by_m, by_mc
   use furiko_legendre_qp, only : second_in_words
   use furiko_parameters_qp, only : parameters, outside
   use furiko_word_arithmetic_qp, only : words, value, operator(+), operator(-), operator(*), &
      operator(/), scale, pi_words
   implicit none
   private
   include 'furiko_second_inverse.inc'
end module furiko_second_inverse_qp
#endif


!> The inverse of the incomplete integral of the second kind, in real32, real64 and real128
! allow(C121)
module furiko_second_inverse
   use furiko_second_inverse_sp
   use furiko_second_inverse_dp
#ifdef FURIKO_REAL128
   use furiko_second_inverse_qp
#endif
   implicit none
   public
end module furiko_second_inverse
! rooms: 2197212548
