! SPDX-License-Identifier: MIT

!> Duffing's oscillator x'' = -x - x^3, let go at x = 2, exactly: its period, and x after 1, 10 and 100 s.
program duffing
   use, intrinsic :: iso_fortran_env, only : wp => real64
   use furiko, only : ellipk_m, jacobi_cn_m
   implicit none
   real(wp), parameter :: alpha = 1.0_wp, beta = 1.0_wp, x0 = 2.0_wp
   real(wp), parameter :: omega = sqrt(alpha + beta*x0**2), m = beta*x0**2/(2*omega**2)

   print '(f15.12)', 4*ellipk_m(m)/omega   ! => 3.179723316782
   print '(3f17.12)', x0*jacobi_cn_m(omega*[1.0_wp, 10.0_wp, 100.0_wp], m)
   ! => -0.704667056766 1.127595846849 -1.873476813976
end program duffing
