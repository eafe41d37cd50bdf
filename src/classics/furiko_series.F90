! SPDX-License-Identifier: MIT
#include "../arithmetic/furiko_compiler.inc"

module furiko_series_sp
   use furiko_bits_sp, only : infinity, is_nan, nan
   use furiko_fold_sp, only : quadrant_of
   use furiko_forms, only : by_k, by_m
   use furiko_word_arithmetic_sp, only : words, value, pi_words, operator(+), operator(*), operator(/)
   use, intrinsic :: iso_fortran_env, only : wp => real32
   implicit none
   private
   include 'furiko_series.inc'
end module furiko_series_sp


module furiko_series_dp
   use furiko_bits_dp, only : infinity, is_nan, nan
   use furiko_fold_dp, only : quadrant_of
   use furiko_forms, only : by_k, by_m
   use furiko_word_arithmetic_dp, only : words, value, pi_words, operator(+), operator(*), operator(/)
   use, intrinsic :: iso_fortran_env, only : wp => real64
   implicit none
   private
   include 'furiko_series.inc'
end module furiko_series_dp


#ifdef FURIKO_REAL128
module furiko_series_qp
   use furiko_bits_qp, only : infinity, is_nan, nan
   use furiko_fold_qp, only : quadrant_of
   use furiko_forms, only : by_k, by_m
   use furiko_word_arithmetic_qp, only : words, value, pi_words, operator(+), operator(*), operator(/)
   use, intrinsic :: iso_fortran_env, only : wp => real128
   implicit none
   private
   include 'furiko_series.inc'
end module furiko_series_qp
#endif


!> The power series of K and E, to any number of terms, and the bound on what is left.
! allow(C121)
module furiko_series
   use furiko_series_sp
   use furiko_series_dp
#ifdef FURIKO_REAL128
   use furiko_series_qp
#endif
   implicit none
   public
end module furiko_series
! rooms: 1633365130
