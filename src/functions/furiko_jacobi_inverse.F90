! SPDX-License-Identifier: MIT
#include "../arithmetic/furiko_compiler.inc"

module furiko_jacobi_inverse_sp
   use, intrinsic :: iso_fortran_env, only : wp => real32
   use furiko_bits_sp, only : infinity, is_nan, nan
   use furiko_duplication_sp, only : rf_of_roots
   use furiko_forms, only : by_k, by_m, by_mc
   use furiko_parameters_sp, only : parameters
   use furiko_word_arithmetic_sp, only : words, value, operator(+), operator(-), operator(*), &
      operator(/), sqrt, scale
   implicit none
   private
   include 'furiko_jacobi_inverse.inc'
end module furiko_jacobi_inverse_sp


module furiko_jacobi_inverse_dp
   use, intrinsic :: iso_fortran_env, only : wp => real64
   use furiko_bits_dp, only : infinity, is_nan, nan
   use furiko_duplication_dp, only : rf_of_roots
   use furiko_forms, only : by_k, by_m, by_mc
   use furiko_parameters_dp, only : parameters
   use furiko_word_arithmetic_dp, only : words, value, operator(+), operator(-), operator(*), &
      operator(/), sqrt, scale
   implicit none
   private
   include 'furiko_jacobi_inverse.inc'
end module furiko_jacobi_inverse_dp


#ifdef FURIKO_REAL128
module furiko_jacobi_inverse_qp
   use, intrinsic :: iso_fortran_env, only : wp => real128
   use furiko_bits_qp, only : infinity, is_nan, nan
   use furiko_duplication_qp, only : rf_of_roots
   use furiko_forms, only : by_k, by_m, by_mc
   use furiko_parameters_qp, only : parameters
   use furiko_word_arithmetic_qp, only : words, value, operator(+), operator(-), operator(*), &
      operator(/), sqrt, scale
   implicit none
   private
   include 'furiko_jacobi_inverse.inc'
end module furiko_jacobi_inverse_qp
#endif


!> The inverses of the twelve Jacobi elliptic functions, in real32, real64 and real128
! allow(C121)
module furiko_jacobi_inverse
   use furiko_jacobi_inverse_sp
   use furiko_jacobi_inverse_dp
#ifdef FURIKO_REAL128
   use furiko_jacobi_inverse_qp
#endif
   implicit none
   public
end module furiko_jacobi_inverse
! rooms: 1943715822
