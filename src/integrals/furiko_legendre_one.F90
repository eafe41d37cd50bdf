! SPDX-License-Identifier: MIT
#include "../arithmetic/furiko_compiler.inc"

!> Legendre's F, E, D and Pi of one set of arguments by plain duplication, what is out of the ordinary in
!> words. Internal.
module furiko_legendre_one_sp
   use, intrinsic :: iso_fortran_env, only : wp => real32, ip => int32
   use furiko_complete_sp, only : ellipk_k, ellipk_m, ellipk_mc, ellipe_k, ellipe_m, ellipe_mc, &
      ellipd_k, ellipd_m, ellipd_mc
   use furiko_forms, only : by_k, by_m
   use furiko_half_pi_sp, only : half_pi
   use furiko_legendre_sp, only : in_words => integral_of_one, &
      complete_in_words => complete_third_of_one, first, second, second_d, third, third_j
   implicit none
   private
   include 'furiko_legendre_one.inc'
   include 'furiko_legendre_complete.inc'
   include '../arithmetic/furiko_quarter_sine_sp.inc'
   include 'furiko_rc_series_sp.inc'
   include 'furiko_rc_wide_sp.inc'
#include "../arithmetic/furiko_bits.inc"
   include '../arithmetic/furiko_head.inc'
   include '../arithmetic/furiko_is_within.inc'
   include '../arithmetic/furiko_nearest_whole.inc'
   include '../arithmetic/furiko_oddness.inc'
end module furiko_legendre_one_sp


module furiko_legendre_one_dp
   use, intrinsic :: iso_fortran_env, only : wp => real64, ip => int64
   use furiko_complete_dp, only : ellipk_k, ellipk_m, ellipk_mc, ellipe_k, ellipe_m, ellipe_mc, &
      ellipd_k, ellipd_m, ellipd_mc
   use furiko_forms, only : by_k, by_m
   use furiko_half_pi_dp, only : half_pi
   use furiko_legendre_dp, only : in_words => integral_of_one, &
      complete_in_words => complete_third_of_one, first, second, second_d, third, third_j
   implicit none
   private
   include 'furiko_legendre_one.inc'
   include 'furiko_legendre_complete.inc'
   include '../arithmetic/furiko_quarter_sine_dp.inc'
   include 'furiko_rc_series_dp.inc'
   include 'furiko_rc_wide_dp.inc'
#include "../arithmetic/furiko_bits.inc"
   include '../arithmetic/furiko_head.inc'
   include '../arithmetic/furiko_is_within.inc'
   include '../arithmetic/furiko_nearest_whole.inc'
   include '../arithmetic/furiko_oddness.inc'
end module furiko_legendre_one_dp


#ifdef FURIKO_REAL128
module furiko_legendre_one_qp
   use, intrinsic :: iso_fortran_env, only : wp => real128
   use furiko_bits_qp, only : head, is_within, nearest_whole, oddness
   use furiko_forms, only : by_k, by_m
   use furiko_half_pi_qp, only : parts => half_pi
   use furiko_legendre_qp, only : in_words => integral_of_one, &
      complete_in_words => complete_third_of_one, first, second, second_d, third, third_j
   implicit none
   private
   public :: integral
   interface integral
      procedure integral_of_one
      procedure integral_of_many
   end interface integral
   ! Of 98 bits each: the products with the quarters up to `phi_max` are exact
   real(wp), parameter :: half_pi(4) = [parts(1) + parts(2), parts(3) + parts(4), parts(5) + parts(6), 0.0_wp]
   include 'furiko_legendre_one.inc'
   include 'furiko_legendre_complete_qp.inc'
   include 'furiko_legendre_loop.inc'
   include '../arithmetic/furiko_quarter_sine_qp.inc'
   include 'furiko_rc_series_qp.inc'
   include 'furiko_rc_wide_qp.inc'
end module furiko_legendre_one_qp
#endif
! rooms: 1520180282
