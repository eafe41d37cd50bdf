! SPDX-License-Identifier: MIT
#include "../arithmetic/furiko_compiler.inc"

!> The parameter of a complete integral of the first kind, in words. Internal.
module furiko_parameter_of_k_sp
   use, intrinsic :: iso_fortran_env, only : wp => real32
   use furiko_nome_sp, only : nome_to_parameter, log_nome_to_parameter
   use furiko_word_arithmetic_sp, only : words, value, operator(+), operator(-), operator(*), &
      operator(/), sqrt, scale, exponential, exp_minus_one
   implicit none
   private
   include 'furiko_parameter_of_k.inc'
end module furiko_parameter_of_k_sp


module furiko_parameter_of_k_dp
   use, intrinsic :: iso_fortran_env, only : wp => real64
   use furiko_nome_dp, only : nome_to_parameter, log_nome_to_parameter
   use furiko_word_arithmetic_dp, only : words, value, operator(+), operator(-), operator(*), &
      operator(/), sqrt, scale, exponential, exp_minus_one
   implicit none
   private
   include 'furiko_parameter_of_k.inc'
end module furiko_parameter_of_k_dp


#ifdef FURIKO_REAL128
module furiko_parameter_of_k_qp
   use, intrinsic :: iso_fortran_env, only : wp => real128
   use furiko_nome_qp, only : nome_to_parameter, log_nome_to_parameter
   use furiko_word_arithmetic_qp, only : words, value, operator(+), operator(-), operator(*), &
      operator(/), sqrt, scale, exponential, exp_minus_one
   implicit none
   private
   include 'furiko_parameter_of_k.inc'
end module furiko_parameter_of_k_qp
#endif
! rooms: 2725709684
