! SPDX-License-Identifier: MIT
#include "../arithmetic/furiko_compiler.inc"

!> Carlson's duplication in words: behind what needs half an ulp (the pendulum, the inverses), and the
!> arguments of Carlson's forms and the Legendre integrals that are out of the ordinary. Internal.
module furiko_duplication_sp
   use, intrinsic :: iso_fortran_env, only : wp => real32, ip => int32
   use furiko_word_arithmetic_sp, only : words
   implicit none
   private
   include 'furiko_duplication.inc'
#include "../arithmetic/furiko_bits.inc"
   include '../arithmetic/furiko_head.inc'
end module furiko_duplication_sp


module furiko_duplication_dp
   use, intrinsic :: iso_fortran_env, only : wp => real64, ip => int64
   use furiko_word_arithmetic_dp, only : words
   implicit none
   private
   include 'furiko_duplication.inc'
#include "../arithmetic/furiko_bits.inc"
   include '../arithmetic/furiko_head.inc'
end module furiko_duplication_dp


#ifdef FURIKO_REAL128
module furiko_duplication_qp
   use, intrinsic :: iso_fortran_env, only : wp => real128
   use furiko_bits_qp, only : head
   use furiko_word_arithmetic_qp, only : words
   implicit none
   private
   include 'furiko_duplication.inc'
end module furiko_duplication_qp
#endif
! rooms: 1180575663
