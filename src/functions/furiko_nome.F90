! SPDX-License-Identifier: MIT
#include "../arithmetic/furiko_compiler.inc"

module furiko_nome_dp
   use, intrinsic :: iso_fortran_env, only : wp => real64, ip => int64
   use furiko_bits_dp, only : infinity, is_nan, nan
   use furiko_forms, only : by_k, by_m, by_mc
   use furiko_parameters_dp, only : parameters, outside
   use furiko_quotients_one_dp, only : half_log
   use furiko_word_arithmetic_dp, only : words, value, operator(+), operator(-), operator(*), &
      operator(/), sqrt, log, scale, exponential, pi_words
   implicit none
   private
   include '../arithmetic/furiko_log_two_dp.inc'
   include 'furiko_nome.inc'
   include 'furiko_nome_pairs.inc'
#include "../arithmetic/furiko_bits.inc"
   include '../arithmetic/furiko_head.inc'
end module furiko_nome_dp


module furiko_nome_sp
   use, intrinsic :: iso_fortran_env, only : real64, wp => real32
   use furiko_bits_sp, only : infinity, is_nan, nan
   use furiko_forms, only : by_k, by_m, by_mc
   use furiko_nome_dp, only : double_nome => nome_of_pairs
   use furiko_parameters_sp, only : parameters, outside
   use furiko_word_arithmetic_sp, only : words, value, operator(+), operator(-), operator(*), &
      operator(/), sqrt, log, scale, exponential, pi_words
   implicit none
   private
   include 'furiko_nome.inc'
   include 'furiko_nome_by_real64.inc'
end module furiko_nome_sp


#ifdef FURIKO_REAL128
module furiko_nome_qp
   use, intrinsic :: iso_fortran_env, only : wp => real128
   use furiko_bits_qp, only : infinity, is_nan, nan
   use furiko_forms, only : by_k, by_m, by_mc
   use furiko_parameters_qp, only : parameters, outside
   use furiko_word_arithmetic_qp, only : words, value, operator(+), operator(-), operator(*), &
      operator(/), sqrt, log, scale, exponential, exp_minus_one, pi_words
   implicit none
   private
   include 'furiko_nome.inc'
   include 'furiko_nome_words.inc'
end module furiko_nome_qp
#endif


!> Jacobi's nome of k, m or mc and its inverse, in real32, real64 and real128. By lists: the kinds'
!> modules have procedures for other rooms, too, of the same names.
module furiko_nome
   use furiko_nome_sp, only : nome_k, nome_m, nome_mc, parameter_from_nome, &
      complementary_parameter_from_nome
   use furiko_nome_dp, only : nome_k, nome_m, nome_mc, parameter_from_nome, &
      complementary_parameter_from_nome
#ifdef FURIKO_REAL128
   use furiko_nome_qp, only : nome_k, nome_m, nome_mc, parameter_from_nome, &
      complementary_parameter_from_nome
#endif
   implicit none
   private
   public :: nome_k, nome_m, nome_mc, parameter_from_nome, &
      complementary_parameter_from_nome
end module furiko_nome
! rooms: 1410704603
