! SPDX-License-Identifier: MIT
#include "../arithmetic/furiko_compiler.inc"

!> Reduction of an angle by multiples of pi with its sine and cosine in words. Internal.
module furiko_fold_sp
   use, intrinsic :: iso_fortran_env, only : wp => real32, ip => int32, int64
   use furiko_half_pi_sp, only : half_pi
   use furiko_word_arithmetic_sp, only : words, operator(+), operator(-), operator(*), operator(/), pi_words
   implicit none
   private
   include 'furiko_fold.inc'
#include "../arithmetic/furiko_bits.inc"
   include '../arithmetic/furiko_head.inc'
end module furiko_fold_sp


module furiko_fold_dp
   use, intrinsic :: iso_fortran_env, only : wp => real64, ip => int64, int64
   use furiko_half_pi_dp, only : half_pi
   use furiko_word_arithmetic_dp, only : words, operator(+), operator(-), operator(*), operator(/), pi_words
   implicit none
   private
   include 'furiko_fold.inc'
#include "../arithmetic/furiko_bits.inc"
   include '../arithmetic/furiko_head.inc'
end module furiko_fold_dp


#ifdef FURIKO_REAL128
module furiko_fold_qp
   use, intrinsic :: iso_fortran_env, only : wp => real128, int64
   use furiko_bits_qp, only : head
   use furiko_half_pi_qp, only : half_pi
   use furiko_word_arithmetic_qp, only : words, operator(+), operator(-), operator(*), operator(/), pi_words
   implicit none
   private
   include 'furiko_fold.inc'
end module furiko_fold_qp
#endif
! rooms: 783469094
