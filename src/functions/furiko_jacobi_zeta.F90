! SPDX-License-Identifier: MIT
#include "../arithmetic/furiko_compiler.inc"

module furiko_jacobi_zeta_sp
   use, intrinsic :: iso_fortran_env, only : wp => real32, ip => int32
   use furiko_bits_sp, only : infinity, is_nan, nan
   use furiko_fold_sp, only : fold
   use furiko_forms, only : by_k, by_m, by_mc
   use furiko_legendre_one_sp, only : fold_one, phi_max
   use furiko_parameters_sp, only : parameters, outside
   use furiko_word_arithmetic_sp, only : words, value, operator(+), operator(-), operator(*), &
      operator(/), sqrt, scale, pi_words
   implicit none
   private
   include 'furiko_jacobi_zeta.inc'
   include 'furiko_jacobi_zeta_turns.inc'
#include "../arithmetic/furiko_bits.inc"
   include '../arithmetic/furiko_head.inc'
end module furiko_jacobi_zeta_sp


module furiko_jacobi_zeta_dp
   use, intrinsic :: iso_fortran_env, only : wp => real64, ip => int64
   use furiko_bits_dp, only : infinity, is_nan, nan
   use furiko_fold_dp, only : fold
   use furiko_forms, only : by_k, by_m, by_mc
   use furiko_legendre_one_dp, only : fold_one, phi_max
   use furiko_parameters_dp, only : parameters, outside
   use furiko_word_arithmetic_dp, only : words, value, operator(+), operator(-), operator(*), &
      operator(/), sqrt, scale, pi_words
   implicit none
   private
   include 'furiko_jacobi_zeta.inc'
   include 'furiko_jacobi_zeta_turns.inc'
#include "../arithmetic/furiko_bits.inc"
   include '../arithmetic/furiko_head.inc'
end module furiko_jacobi_zeta_dp


#ifdef FURIKO_REAL128
module furiko_jacobi_zeta_qp
   use, intrinsic :: iso_fortran_env, only : wp => real128
   use furiko_bits_qp, only : head, infinity, is_nan, nan
   use furiko_fold_qp, only : fold
   use furiko_forms, only : by_k, by_m, by_mc
   use furiko_legendre_one_qp, only : fold_one, phi_max
   use furiko_parameters_qp, only : parameters, outside
   use furiko_word_arithmetic_qp, only : words, value, operator(+), operator(-), operator(*), &
      operator(/), sqrt, scale, pi_words
   implicit none
   private
   include 'furiko_jacobi_zeta.inc'
   include 'furiko_jacobi_zeta_turns.inc'
end module furiko_jacobi_zeta_qp
#endif


!> Jacobi's zeta and Heuman's lambda function of an amplitude, in real32, real64 and real128
! allow(C121)
module furiko_jacobi_zeta
   use furiko_jacobi_zeta_sp
   use furiko_jacobi_zeta_dp
#ifdef FURIKO_REAL128
   use furiko_jacobi_zeta_qp
#endif
   implicit none
   public
end module furiko_jacobi_zeta
! rooms: 2919369207
