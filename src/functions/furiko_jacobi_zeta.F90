! SPDX-License-Identifier: MIT
#include "../arithmetic/furiko_compiler.inc"

module furiko_jacobi_zeta_sp
   use, intrinsic :: iso_fortran_env, only : wp => real32
   use furiko_bits_sp, only : infinity, is_nan, nan
   use furiko_fold_sp, only : fold
   use furiko_duplication_sp, only : lanes, rj_of_roots
   use furiko_parameters_sp, only : parameters, outside, by_k, by_m, by_mc
   use furiko_word_arithmetic_sp, only : words, value, operator(+), operator(*), operator(/), &
      sqrt, scale, pi_words
   implicit none
   private
   include 'furiko_jacobi_zeta.inc'
end module furiko_jacobi_zeta_sp


module furiko_jacobi_zeta_dp
   use, intrinsic :: iso_fortran_env, only : wp => real64
   use furiko_bits_dp, only : infinity, is_nan, nan
   use furiko_fold_dp, only : fold
   use furiko_duplication_dp, only : lanes, rj_of_roots
   use furiko_parameters_dp, only : parameters, outside, by_k, by_m, by_mc
   use furiko_word_arithmetic_dp, only : words, value, operator(+), operator(*), operator(/), &
      sqrt, scale, pi_words
   implicit none
   private
   include 'furiko_jacobi_zeta.inc'
end module furiko_jacobi_zeta_dp


#ifdef FURIKO_REAL128
module furiko_jacobi_zeta_qp
   use, intrinsic :: iso_fortran_env, only : wp => real128
   use furiko_bits_qp, only : infinity, is_nan, nan
   use furiko_fold_qp, only : fold
   use furiko_duplication_qp, only : lanes, rj_of_roots
   use furiko_parameters_qp, only : parameters, outside, by_k, by_m, by_mc
   use furiko_word_arithmetic_qp, only : words, value, operator(+), operator(*), operator(/), &
      sqrt, scale, pi_words
   implicit none
   private
   include 'furiko_jacobi_zeta.inc'
end module furiko_jacobi_zeta_qp
#endif


!> Jacobi's zeta and Heuman's lambda function of an amplitude, in real32, real64 and real128
module furiko_jacobi_zeta
   use furiko_jacobi_zeta_sp, only : jacobi_zeta_k, jacobi_zeta_m, jacobi_zeta_mc, &
      heuman_lambda_k, heuman_lambda_m, heuman_lambda_mc
   use furiko_jacobi_zeta_dp, only : jacobi_zeta_k, jacobi_zeta_m, jacobi_zeta_mc, &
      heuman_lambda_k, heuman_lambda_m, heuman_lambda_mc
#ifdef FURIKO_REAL128
   use furiko_jacobi_zeta_qp, only : jacobi_zeta_k, jacobi_zeta_m, jacobi_zeta_mc, &
      heuman_lambda_k, heuman_lambda_m, heuman_lambda_mc
#endif
   implicit none
   private
   public :: jacobi_zeta_k, jacobi_zeta_m, jacobi_zeta_mc, &
      heuman_lambda_k, heuman_lambda_m, heuman_lambda_mc
end module furiko_jacobi_zeta
! rooms: 3867979259
