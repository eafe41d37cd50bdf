! SPDX-License-Identifier: MIT
#include "furiko_compiler.inc"

!> Arithmetic, square root, exponential and logarithm on words hi + lo, where operators say it more
!> plainly than the calls of furiko_words.inc and speed is not the point. Internal.
module furiko_word_arithmetic_sp
   use, intrinsic :: iso_fortran_env, only : wp => real32, ip => int32
   use furiko_half_pi_sp, only : half_pi
   implicit none
   private
   include 'furiko_log_two_sp.inc'
   include 'furiko_word_arithmetic.inc'
#include "furiko_bits.inc"
   include 'furiko_head.inc'
end module furiko_word_arithmetic_sp


module furiko_word_arithmetic_dp
   use, intrinsic :: iso_fortran_env, only : wp => real64, ip => int64
   use furiko_half_pi_dp, only : half_pi
   implicit none
   private
   include 'furiko_log_two_dp.inc'
   include 'furiko_word_arithmetic.inc'
#include "furiko_bits.inc"
   include 'furiko_head.inc'
end module furiko_word_arithmetic_dp


#ifdef FURIKO_REAL128
module furiko_word_arithmetic_qp
   use, intrinsic :: iso_fortran_env, only : wp => real128
   use furiko_bits_qp, only : head
   use furiko_half_pi_qp, only : half_pi
   implicit none
   private
   include 'furiko_log_two_qp.inc'
   include 'furiko_word_arithmetic.inc'
end module furiko_word_arithmetic_qp
#endif
! rooms: 2095363260
