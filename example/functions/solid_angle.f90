! SPDX-License-Identifier: MIT

!> The solid angle of a disk of radius 1, seen from 1 above it and 1/2 off its axis (Paxton 1959).
program solid_angle
   use, intrinsic :: iso_fortran_env, only : wp => real64
   use furiko, only : ellipk_mc, heuman_lambda_mc
   implicit none
   real(wp), parameter :: pi = acos(-1.0_wp), height = 1.0_wp, off = 0.5_wp
   real(wp) :: far, mc, omega

   far = hypot(height, 1 + off)
   mc = (height**2 + (1 - off)**2)/far**2
   omega = 2*pi - 2*height/far*ellipk_mc(mc) - pi*heuman_lambda_mc(atan(height/(1 - off)), mc)
   print '(f15.12)', omega   ! => 1.637103549345
end program solid_angle
