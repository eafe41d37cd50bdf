! SPDX-License-Identifier: MIT

!> The field of a loop of radius 1, over mu0 I, radial and axial: next to the axis, inside, and so far away
!> that it is a dipole's. By K and E the radial part has no digit right at the first point, four at the last.
program current_loop
   use, intrinsic :: iso_fortran_env, only : wp => real64
   use furiko, only : ellipd_m, ellipe_m, ellips_m
   implicit none
   real(wp), parameter :: rho(3) = [1.0e-8_wp, 0.5_wp, 3.0e5_wp], z(3) = [0.5_wp, 0.5_wp, 4.0e5_wp]
   real(wp), dimension(3) :: q, m, t, weight

   q = (1 + rho)**2 + z**2
   m = 4*rho/q
   t = m*(ellipd_m(m) - ellips_m(m))
   weight = 1/(acos(-1.0_wp)*sqrt(q)*((1 - rho)**2 + z**2))
   print '(3es21.13)', weight*z*t, weight*(ellipe_m(m) - rho*t)
   ! => 2.1466252583998E-09 1.2866808487309E-01 2.8799999999893E-18
   ! => 3.5777087639997E-01 3.4583167004288E-01 1.8400000000056E-18
end program current_loop
