! SPDX-License-Identifier: MIT
#include "../arithmetic/furiko_compiler.inc"

!> Legendre's F, E, D and Pi of many arguments by plain duplication, lanes out of the ordinary in
!> words. Internal.
module furiko_legendre_plain_sp
   use, intrinsic :: iso_fortran_env, only : wp => real32, ip => int32
   use furiko_bits_sp, only : infinity
   use furiko_duplication_plain_sp, only : lanes, width, plain_rf, plain_rd, plain_rfd, plain_rj
   use furiko_forms, only : by_k, by_m, by_mc
   use furiko_half_pi_sp, only : half_pi
   use furiko_legendre_one_sp, only : integral_of_one, complete_third_of_one, complete
   use furiko_legendre_sp, only : first, second, second_d, third, third_j
   implicit none
   private
   include 'furiko_legendre_plain.inc'
#include "../arithmetic/furiko_bits.inc"
   include '../arithmetic/furiko_head.inc'
   include '../arithmetic/furiko_nearest_whole.inc'
   include '../arithmetic/furiko_oddness.inc'
   include '../arithmetic/furiko_quarter_sine_sp.inc'
end module furiko_legendre_plain_sp


module furiko_legendre_plain_dp
   use, intrinsic :: iso_fortran_env, only : wp => real64, ip => int64
   use furiko_bits_dp, only : infinity
   use furiko_duplication_plain_dp, only : lanes, width, plain_rf, plain_rd, plain_rfd, plain_rj
   use furiko_forms, only : by_k, by_m, by_mc
   use furiko_half_pi_dp, only : half_pi
   use furiko_legendre_one_dp, only : integral_of_one, complete_third_of_one, complete
   use furiko_legendre_dp, only : first, second, second_d, third, third_j
   implicit none
   private
   include 'furiko_legendre_plain.inc'
#include "../arithmetic/furiko_bits.inc"
   include '../arithmetic/furiko_head.inc'
   include '../arithmetic/furiko_nearest_whole.inc'
   include '../arithmetic/furiko_oddness.inc'
   include '../arithmetic/furiko_quarter_sine_dp.inc'
end module furiko_legendre_plain_dp
! rooms: 2521457952
