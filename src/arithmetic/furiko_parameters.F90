! SPDX-License-Identifier: MIT
#include "furiko_compiler.inc"

!> The parameter and its complement in words. Internal.
module furiko_parameters_sp
   use, intrinsic :: iso_fortran_env, only : wp => real32
   use furiko_forms, only : by_k, by_m
   use furiko_word_arithmetic_sp, only : words, operator(+), operator(-), operator(*)
   implicit none
   private
   include 'furiko_parameters.inc'
end module furiko_parameters_sp


module furiko_parameters_dp
   use, intrinsic :: iso_fortran_env, only : wp => real64
   use furiko_forms, only : by_k, by_m
   use furiko_word_arithmetic_dp, only : words, operator(+), operator(-), operator(*)
   implicit none
   private
   include 'furiko_parameters.inc'
end module furiko_parameters_dp


#ifdef FURIKO_REAL128
module furiko_parameters_qp
   use, intrinsic :: iso_fortran_env, only : wp => real128
   use furiko_forms, only : by_k, by_m
   use furiko_word_arithmetic_qp, only : words, operator(+), operator(-), operator(*)
   implicit none
   private
   include 'furiko_parameters.inc'
end module furiko_parameters_qp
#endif
! rooms: 793065061
