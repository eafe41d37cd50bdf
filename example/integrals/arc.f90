! SPDX-License-Identifier: MIT

!> The arc of the ellipse of half axes 2 and 1 from the end of the short axis to 30 degrees, in two ways.
program arc
   use, intrinsic :: iso_fortran_env, only : wp => real64
   use furiko, only : ellipdinc_m, ellipeinc_m, ellipf_m
   implicit none
   real(wp), parameter :: phi = acos(-1.0_wp)/6, m = 0.75_wp

   print '(f16.13)', 2*ellipeinc_m(phi, m)                          ! => 1.0121841449315
   print '(f16.13)', 2*(ellipf_m(phi, m) - m*ellipdinc_m(phi, m))   ! => 1.0121841449315
end program arc
