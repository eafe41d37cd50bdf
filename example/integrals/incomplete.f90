! SPDX-License-Identifier: MIT

!> How long does a pendulum of amplitude 90 degrees take from the bottom to 45 degrees?
program incomplete
   use, intrinsic :: iso_fortran_env, only : wp => real64
   use furiko, only : ellipf_k, ellipk_k
   implicit none
   real(wp), parameter :: pi = acos(-1.0_wp)
   real(wp) :: k, phi

   k = sin(pi/4)                                ! of the amplitude's half
   phi = asin(sin(pi/8)/k)
   ! in units of sqrt(l/g), and of the quarter period
   print '(f15.12)', ellipf_k(phi, k)                ! => 0.587532348924
   print '(f15.12)', ellipf_k(phi, k)/ellipk_k(k)    ! => 0.316887100674
end program incomplete
