! SPDX-License-Identifier: MIT
#include "../arithmetic/furiko_compiler.inc"

module furiko_cel_dp
   use, intrinsic :: iso_fortran_env, only : wp => real64, ip => int64
   use furiko_bits_dp, only : infinity, is_nan, nan
   use furiko_edges_dp, only : cel_at_edge, far_out => cel_at_edge
   use furiko_word_arithmetic_dp, only : words, pi_words
   implicit none
   private
   include 'furiko_cel.inc'
#include "../arithmetic/furiko_bits.inc"
   include '../arithmetic/furiko_head.inc'
end module furiko_cel_dp


module furiko_cel_sp
   use, intrinsic :: iso_fortran_env, only : real64, wp => real32, ip => int32
   use furiko_bits_sp, only : infinity, is_nan, nan
   use furiko_cel_dp, only : bulirsch_cel_dp => bulirsch_cel
   use furiko_edges_sp, only : cel_at_edge
   use furiko_word_arithmetic_sp, only : words, pi_words
   implicit none
   private
   include 'furiko_cel.inc'
   include 'furiko_cel_by_real64.inc'
#include "../arithmetic/furiko_bits.inc"
   include '../arithmetic/furiko_head.inc'
end module furiko_cel_sp


#ifdef FURIKO_REAL128
module furiko_cel_qp
   use, intrinsic :: iso_fortran_env, only : wp => real128
   use furiko_bits_qp, only : head, infinity, is_nan, nan
   use furiko_edges_qp, only : cel_at_edge, far_out => cel_at_edge
   use furiko_word_arithmetic_qp, only : words, pi_words
   implicit none
   private
   include 'furiko_cel.inc'
end module furiko_cel_qp
#endif


!> Bulirsch's general complete elliptic integral in real32, real64 and real128.
! allow(C121)
module furiko_cel
   use furiko_cel_sp
   use furiko_cel_dp
#ifdef FURIKO_REAL128
   use furiko_cel_qp
#endif
   implicit none
   public
end module furiko_cel
! rooms: 1835724257
