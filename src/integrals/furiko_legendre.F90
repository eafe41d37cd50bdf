! SPDX-License-Identifier: MIT
#include "../arithmetic/furiko_compiler.inc"

!> Legendre integrals in words, for arguments that are out of the ordinary. Internal.
module furiko_legendre_dp
   use, intrinsic :: iso_fortran_env, only : wp => real64
   use furiko_bits_dp, only : infinity, is_nan, nan
   use furiko_edges_dp, only : legendre_at_edge, legendre_far => legendre_at_edge, &
      complete_third_far => complete_third_at_edge, first, second, second_d, third, third_j
   use furiko_fold_dp, only : fold
   use furiko_duplication_dp, only : rf_of_roots, rd_of_roots, rj_of_roots
   use furiko_forms, only : by_k, by_m, by_mc
   use furiko_parameters_dp, only : parameters
   use furiko_word_arithmetic_dp, only : words, value, operator(+), operator(-), operator(*), operator(/), &
      sqrt, scale
   implicit none
   private
   include 'furiko_legendre.inc'
end module furiko_legendre_dp


module furiko_legendre_sp
   use, intrinsic :: iso_fortran_env, only : real64, wp => real32
   use furiko_bits_sp, only : infinity, is_nan, nan
   use furiko_edges_sp, only : legendre_at_edge, first, second, second_d, third, third_j
   use furiko_fold_sp, only : fold
   use furiko_forms, only : by_k, by_m, by_mc
   use furiko_legendre_dp, only : double_integral => integral_of_one, double_third => complete_third_of_one
   use furiko_duplication_sp, only : rf_of_roots, rd_of_roots, rj_of_roots
   use furiko_parameters_sp, only : parameters
   use furiko_word_arithmetic_sp, only : words, value, operator(+), operator(-), operator(*), operator(/), &
      sqrt, scale
   implicit none
   private
   include 'furiko_legendre.inc'
   include 'furiko_legendre_by_real64.inc'
end module furiko_legendre_sp


#ifdef FURIKO_REAL128
module furiko_legendre_qp
   use, intrinsic :: iso_fortran_env, only : wp => real128
   use furiko_bits_qp, only : infinity, is_nan, nan
   use furiko_edges_qp, only : legendre_at_edge, legendre_far => legendre_at_edge, &
      complete_third_far => complete_third_at_edge, first, second, second_d, third, third_j
   use furiko_fold_qp, only : fold
   use furiko_duplication_qp, only : rf_of_roots, rd_of_roots, rj_of_roots
   use furiko_forms, only : by_k, by_m, by_mc
   use furiko_parameters_qp, only : parameters
   use furiko_word_arithmetic_qp, only : words, value, operator(+), operator(-), operator(*), operator(/), &
      sqrt, scale
   implicit none
   private
   include 'furiko_legendre.inc'
end module furiko_legendre_qp
#endif
! rooms: 789005433
