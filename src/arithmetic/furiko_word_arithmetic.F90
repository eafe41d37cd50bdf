! SPDX-License-Identifier: MIT
#include "furiko_compiler.inc"

!> Arithmetic on words hi + lo, where operators say it more plainly than the calls of furiko_words.inc and
!> speed is not the point: square root, exponential, logarithm, sine, arithmetic-geometric mean. Those of
!> real64, 106 bits or 31 digits everywhere, also where there is no real128, are the program's, too.
!> Internal.
!>
!> Relative errors of product, quotient and square root stay below 8 epsilon^2 (2^-101 in real64; of
!> real128 2^-209, for its heads are cut unevenly), with and without FMA contraction. Next to the ends of
!> the range words lose their second one.
!>
!> Source: Joldes, Muller, Popescu, Tight and rigorous error bounds for basic building blocks
!> of double-word arithmetic, ACM TOMS 44 (2017) 15.
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
! rooms: 2530931970
