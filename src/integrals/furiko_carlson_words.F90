! SPDX-License-Identifier: MIT
#include "../arithmetic/furiko_compiler.inc"

!> Carlson's forms from duplication in words. Internal.
module furiko_carlson_words_dp
   use, intrinsic :: iso_fortran_env, only : wp => real64
   use furiko_bits_dp, only : infinity, is_nan, nan
   use furiko_edges_dp, only : rc_at_edge, rd_at_edge, rj_at_edge
   use furiko_duplication_dp, only : rf_of_roots, rd_of_roots, rj_of_roots
   use furiko_word_arithmetic_dp, only : words, value, operator(+), operator(-), operator(*), operator(/), &
      sqrt, scale
   implicit none
   private
   include 'furiko_carlson_words.inc'
end module furiko_carlson_words_dp


module furiko_carlson_words_sp
   use, intrinsic :: iso_fortran_env, only : real64, wp => real32
   use furiko_bits_sp, only : infinity, is_nan, nan
   use furiko_carlson_words_dp, only : double_rc => rc, double_rd => rd, double_rj => rj
   use furiko_duplication_sp, only : rf_of_roots, rd_of_roots, rj_of_roots
   use furiko_word_arithmetic_sp, only : words, value, operator(+), operator(-), operator(*), operator(/), &
      sqrt, scale
   implicit none
   private
   include 'furiko_carlson_words.inc'
   include 'furiko_carlson_by_real64.inc'
end module furiko_carlson_words_sp


#ifdef FURIKO_REAL128
module furiko_carlson_words_qp
   use, intrinsic :: iso_fortran_env, only : wp => real128
   use furiko_bits_qp, only : infinity, is_nan, nan
   use furiko_edges_qp, only : rc_at_edge, rd_at_edge, rj_at_edge
   use furiko_duplication_qp, only : rf_of_roots, rd_of_roots, rj_of_roots
   use furiko_word_arithmetic_qp, only : words, value, operator(+), operator(-), operator(*), operator(/), &
      sqrt, scale
   implicit none
   private
   include 'furiko_carlson_words.inc'
end module furiko_carlson_words_qp
#endif
! rooms: 467008713
