! SPDX-License-Identifier: MIT
#include "../arithmetic/furiko_compiler.inc"

!> Coefficients of the real32 kernel
module furiko_complete_coefficients_sp
   use, intrinsic :: iso_fortran_env, only : wp => real32, ip => int32
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


!> Complete elliptic integrals in real32
module furiko_complete_sp
   use furiko_bits_sp, only : infinity, nan
   ! allow(C121)
   use furiko_complete_coefficients_sp
   implicit none
   private
   include 'furiko_complete.inc'
   include 'furiko_complete_segments.inc'
#include "../arithmetic/furiko_bits.inc"
   include '../arithmetic/furiko_is_nan.inc'
end module furiko_complete_sp


!> Complete elliptic integrals in real64
module furiko_complete_dp
   use furiko_bits_dp, only : infinity, nan
   ! allow(C121)
   use furiko_complete_coefficients_dp
   implicit none
   private
   include 'furiko_complete.inc'
   include 'furiko_complete_segments.inc'
#include "../arithmetic/furiko_bits.inc"
   include '../arithmetic/furiko_is_nan.inc'
end module furiko_complete_dp


#ifdef FURIKO_REAL128
!> Complete elliptic integrals in real128
module furiko_complete_qp
   use furiko_bits_qp, only : infinity, is_nan, nan
   use, intrinsic :: iso_fortran_env, only : wp => real128
   implicit none
   private
   include 'furiko_complete.inc'
   include 'furiko_complete_series.inc'
end module furiko_complete_qp
#endif


!> Complete elliptic integrals K, E, B, D in real32, real64 and real128
!>
!> The form of the argument is in the name: modulus `_k`, parameter `_m` = k^2, complementary
!> parameter `_mc` = 1 - m, modular angle `_alpha` in radians, k = sin(alpha).
module furiko_complete
   use furiko_complete_sp, only : ellipk_k, ellipk_m, ellipk_mc, ellipk_alpha, &
      ellipe_k, ellipe_m, ellipe_mc, ellipe_alpha, &
      ellipb_k, ellipb_m, ellipb_mc, ellipb_alpha, &
      ellipd_k, ellipd_m, ellipd_mc, ellipd_alpha, &
      ellipke_k, ellipke_m, ellipke_mc, ellipke_alpha
   use furiko_complete_dp, only : ellipk_k, ellipk_m, ellipk_mc, ellipk_alpha, &
      ellipe_k, ellipe_m, ellipe_mc, ellipe_alpha, &
      ellipb_k, ellipb_m, ellipb_mc, ellipb_alpha, &
      ellipd_k, ellipd_m, ellipd_mc, ellipd_alpha, &
      ellipke_k, ellipke_m, ellipke_mc, ellipke_alpha
#ifdef FURIKO_REAL128
   use furiko_complete_qp, only : ellipk_k, ellipk_m, ellipk_mc, ellipk_alpha, &
      ellipe_k, ellipe_m, ellipe_mc, ellipe_alpha, &
      ellipb_k, ellipb_m, ellipb_mc, ellipb_alpha, &
      ellipd_k, ellipd_m, ellipd_mc, ellipd_alpha, &
      ellipke_k, ellipke_m, ellipke_mc, ellipke_alpha
#endif
   implicit none
   private
   public :: ellipk_k, ellipk_m, ellipk_mc, ellipk_alpha, &
      ellipe_k, ellipe_m, ellipe_mc, ellipe_alpha, &
      ellipb_k, ellipb_m, ellipb_mc, ellipb_alpha, &
      ellipd_k, ellipd_m, ellipd_mc, ellipd_alpha, &
      ellipke_k, ellipke_m, ellipke_mc, ellipke_alpha
end module furiko_complete
! rooms: 3746526603
