! SPDX-License-Identifier: MIT
#include "../arithmetic/furiko_compiler.inc"

!> Legendre's F, E, D and Pi of many arguments by plain duplication, lanes out of the ordinary in
!> words. Internal.
module furiko_legendre_plain_sp
   use, intrinsic :: iso_fortran_env, only : wp => real32, ip => int32
   use furiko_bits_sp, only : infinity
   use furiko_complete_sp, only : ellipk_k, ellipk_m, ellipk_mc, ellipe_k, ellipe_m, ellipe_mc, &
      ellipd_k, ellipd_m, ellipd_mc
   use furiko_duplication_sp, only : lanes
   use furiko_duplication_plain_sp, only : plain_rf, plain_rd, plain_rj
   use furiko_half_pi_sp, only : half_pi
   use furiko_legendre_sp, only : integral_of_one, words => integral, &
      complete_third_of_one, complete_words => complete_third, &
      first, second, second_d, third, by_k, by_m, by_mc
   implicit none
   private
   include 'furiko_legendre_plain.inc'
#include "../arithmetic/furiko_bits.inc"
   include '../arithmetic/furiko_head.inc'
   include '../arithmetic/furiko_nearest_whole.inc'
   include '../arithmetic/furiko_is_nan.inc'
end module furiko_legendre_plain_sp


module furiko_legendre_plain_dp
   use, intrinsic :: iso_fortran_env, only : wp => real64, ip => int64
   use furiko_bits_dp, only : infinity
   use furiko_complete_dp, only : ellipk_k, ellipk_m, ellipk_mc, ellipe_k, ellipe_m, ellipe_mc, &
      ellipd_k, ellipd_m, ellipd_mc
   use furiko_duplication_dp, only : lanes
   use furiko_duplication_plain_dp, only : plain_rf, plain_rd, plain_rj
   use furiko_half_pi_dp, only : half_pi
   use furiko_legendre_dp, only : integral_of_one, words => integral, &
      complete_third_of_one, complete_words => complete_third, &
      first, second, second_d, third, by_k, by_m, by_mc
   implicit none
   private
   include 'furiko_legendre_plain.inc'
#include "../arithmetic/furiko_bits.inc"
   include '../arithmetic/furiko_head.inc'
   include '../arithmetic/furiko_nearest_whole.inc'
   include '../arithmetic/furiko_is_nan.inc'
end module furiko_legendre_plain_dp
! rooms: 1184502505
