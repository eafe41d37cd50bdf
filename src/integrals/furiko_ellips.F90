! SPDX-License-Identifier: MIT
#include "../arithmetic/furiko_compiler.inc"

module furiko_ellips_sp
   use, intrinsic :: iso_fortran_env, only : wp => real32, ip => int32
   use furiko_bits_sp, only : infinity, is_nan, nan
   use furiko_complete_sp, only : ellipd_mc
   use furiko_forms, only : by_k, by_m, by_mc
   use furiko_parameters_sp, only : outside, parameters
   use furiko_word_arithmetic_sp, only : words
   implicit none
   private
   include 'furiko_ellips.inc'
#include "../arithmetic/furiko_bits.inc"
   include '../arithmetic/furiko_head.inc'
end module furiko_ellips_sp


module furiko_ellips_dp
   use, intrinsic :: iso_fortran_env, only : wp => real64, ip => int64
   use furiko_bits_dp, only : infinity, is_nan, nan
   use furiko_complete_dp, only : ellipd_mc
   use furiko_forms, only : by_k, by_m, by_mc
   use furiko_parameters_dp, only : outside, parameters
   use furiko_word_arithmetic_dp, only : words
   implicit none
   private
   include 'furiko_ellips.inc'
#include "../arithmetic/furiko_bits.inc"
   include '../arithmetic/furiko_head.inc'
end module furiko_ellips_dp


#ifdef FURIKO_REAL128
module furiko_ellips_qp
   use, intrinsic :: iso_fortran_env, only : wp => real128
   use furiko_bits_qp, only : head, infinity, is_nan, nan
   use furiko_complete_qp, only : ellipd_mc
   use furiko_forms, only : by_k, by_m, by_mc
   use furiko_parameters_qp, only : outside, parameters
   use furiko_word_arithmetic_qp, only : words
   implicit none
   private
   include 'furiko_ellips.inc'
end module furiko_ellips_qp
#endif


!> The complete elliptic integral S = (D - B)/m in real32, real64 and real128.
! allow(C121)
module furiko_ellips
   use furiko_ellips_sp
   use furiko_ellips_dp
#ifdef FURIKO_REAL128
   use furiko_ellips_qp
#endif
   implicit none
   public
end module furiko_ellips
! rooms: 261337193
