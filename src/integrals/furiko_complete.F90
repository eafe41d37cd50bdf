! SPDX-License-Identifier: MIT
#include "../arithmetic/furiko_compiler.inc"

!> Coefficients of the real32 kernel, which computes in real64
module furiko_complete_coefficients_sp
   use, intrinsic :: iso_fortran_env, only : wp => real64, ip => int64
   implicit none
   public
   include 'furiko_complete_coefficients_sp.inc'
   include 'furiko_complete_layout.inc'
end module furiko_complete_coefficients_sp


!> Coefficients of the real64 kernel
module furiko_complete_coefficients_dp
   use, intrinsic :: iso_fortran_env, only : wp => real64, ip => int64
   implicit none
   public
   include 'furiko_complete_coefficients_dp.inc'
   include 'furiko_complete_layout.inc'
end module furiko_complete_coefficients_dp


!> The real32 kernel
module furiko_complete_rounded
   use, intrinsic :: iso_fortran_env, only : single => real32
   use furiko_bits_dp, only : infinity, nan
   ! allow(C121)
   use furiko_complete_coefficients_sp
   use furiko_forms, only : by_k, by_m, by_alpha
   use furiko_word_arithmetic_dp, only : words, operator(+), operator(-), operator(*), operator(/), sqrt, &
      mean_with_one, pi_words
   implicit none
   private
   public :: complement_of_k, complement_of_m, complement_of_alpha, k_at, e_at, b_at, d_at, evaluate
   public :: integral_k, integral_e, integral_b, integral_d
   include 'furiko_complete_choices.inc'
   include 'furiko_complete_rounded.inc'
   include 'furiko_complete_near.inc'
#include "../arithmetic/furiko_bits.inc"
   include '../arithmetic/furiko_is_nan.inc'
end module furiko_complete_rounded


!> Complete elliptic integrals in real32
module furiko_complete_sp
   use, intrinsic :: iso_fortran_env, only : wp => real32, xp => real64
   ! allow(C121)
   use furiko_complete_rounded
   use furiko_forms, only : by_k, by_m, by_mc, by_alpha
   implicit none
   private
   include 'furiko_complete.inc'
end module furiko_complete_sp


!> Complete elliptic integrals in real64
module furiko_complete_dp
   use, intrinsic :: iso_fortran_env, only : xp => real64
   use furiko_bits_dp, only : infinity, nan
   ! allow(C121)
   use furiko_complete_coefficients_dp
   use furiko_forms, only : by_k, by_m, by_mc, by_alpha
   implicit none
   private
   include 'furiko_complete_choices.inc'
   include 'furiko_complete.inc'
   include 'furiko_complete_segments.inc'
   include 'furiko_complete_near.inc'
#include "../arithmetic/furiko_bits.inc"
   include '../arithmetic/furiko_is_nan.inc'
end module furiko_complete_dp


#ifdef FURIKO_REAL128
!> Complete elliptic integrals in real128
module furiko_complete_qp
   use furiko_bits_qp, only : infinity, is_nan, nan
   use, intrinsic :: iso_fortran_env, only : wp => real128, xp => real128
   use furiko_forms, only : by_k, by_m, by_mc, by_alpha
   implicit none
   private
   include 'furiko_complete_choices.inc'
   ! Means that differ by this part have a limit of three terms
   real(wp), parameter :: close = 4.0e-6_wp
   ! The exponent of the means' ratio, at most 62, halves; then their common digits double
   integer, parameter :: most_steps = 16
   include 'furiko_complete.inc'
   include 'furiko_complete_agm.inc'
end module furiko_complete_qp
#endif


!> Complete elliptic integrals K, E, B, D in real32, real64 and real128
!>
!> The form of the argument is in the name: modulus `_k`, parameter `_m` = k^2, complementary
!> parameter `_mc` = 1 - m, modular angle `_alpha` in radians, k = sin(alpha).
! allow(C121)
module furiko_complete
   use furiko_complete_sp
   use furiko_complete_dp
#ifdef FURIKO_REAL128
   use furiko_complete_qp
#endif
   implicit none
   public
end module furiko_complete
! rooms: 2471630999
