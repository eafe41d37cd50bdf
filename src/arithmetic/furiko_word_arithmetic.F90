! SPDX-License-Identifier: MIT

!> Arithmetic, square root, exponential and logarithm on words hi + lo, where operators say it more
!> plainly than the calls of furiko_words.inc and speed is not the point. Internal.
module furiko_word_arithmetic_sp
   use, intrinsic :: iso_fortran_env, only : wp => real32, int32
   use furiko_half_pi_sp, only : half_pi
   implicit none
   private
   include 'furiko_log_two_sp.inc'
   include 'furiko_word_arithmetic.inc'
   include 'furiko_head_sp.inc'
end module furiko_word_arithmetic_sp


module furiko_word_arithmetic_dp
   use, intrinsic :: iso_fortran_env, only : wp => real64, int64
   use furiko_half_pi_dp, only : half_pi
   implicit none
   private
   include 'furiko_log_two_dp.inc'
   include 'furiko_word_arithmetic.inc'
   include 'furiko_head_dp.inc'
end module furiko_word_arithmetic_dp


#ifdef __GFC_REAL_16__
module furiko_word_arithmetic_qp
   use, intrinsic :: iso_fortran_env, only : wp => real128, int32, int64
   use furiko_half_pi_qp, only : half_pi
   implicit none
   private
   include 'furiko_log_two_qp.inc'
   include 'furiko_word_arithmetic.inc'
   include 'furiko_head_qp.inc'
end module furiko_word_arithmetic_qp
#endif
