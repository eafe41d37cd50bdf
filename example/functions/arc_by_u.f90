! SPDX-License-Identifier: MIT

!> The arc E(am u) is a straight line in u and a ripple of the period 2 K, Jacobi's zeta.
program arc_by_u
   use, intrinsic :: iso_fortran_env, only : wp => real64
   use furiko, only : ellipe_m, ellipk_m, jacobi_am_m, jacobi_epsilon_m, jacobi_zeta_m
   implicit none
   real(wp), parameter :: m = 0.9_wp, u = 7.0_wp

   print '(f16.13)', jacobi_epsilon_m(u, m)   ! => 3.2279827507762
   print '(f16.13)', u*ellipe_m(m)/ellipk_m(m) + jacobi_zeta_m(jacobi_am_m(u, m), m)
   ! => 3.2279827507762
end program arc_by_u
