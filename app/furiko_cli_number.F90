! SPDX-License-Identifier: MIT
#include "../src/arithmetic/furiko_compiler.inc"

!> Numbers from text and text from numbers: the program's only code for it, faster than Fortran's
!> `read` and `write`, which decide where it cannot. The tests include the same rooms.
module furiko_cli_number
   use, intrinsic :: iso_fortran_env, only : dp => real64, int64, qp => real128, sp => real32
   use furiko_bits_dp, only : infinity, is_finite, is_nan, nan
   use furiko_word_arithmetic_dp, only : words, operator(*)
   implicit none
   private
#ifdef FURIKO_REAL128
   include 'furiko_cli_number_qp_names.inc'
#endif
   include 'furiko_cli_number.inc'
#ifdef FURIKO_REAL128
   include 'furiko_cli_number_qp.inc'
#endif
end module furiko_cli_number
! rooms: 2513583206
