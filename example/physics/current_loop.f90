! SPDX-License-Identifier: MIT

!> The field of a loop of radius 1, over mu0 I, radial and axial: next to the axis, inside, next to the wire,
!> and so far away that it is a dipole's. No term cancels where it is taken; by K and E the radial part has
!> no digit right at the first point and four at the last.
program current_loop
   use, intrinsic :: iso_fortran_env, only : wp => real64
   use furiko, only : ellipd_mc, ellipe_mc, ellips_mc
   implicit none
   real(wp), parameter, dimension(4) :: rho = [1.0e-8_wp, 0.5_wp, 0.999999_wp, 3.0e5_wp], &
      z = [0.5_wp, 0.5_wp, 1.0e-6_wp, 4.0e5_wp], far = (1 + rho)**2 + z**2, near = (1 - rho)**2 + z**2, &
      m = 4*rho/far, mc = near/far
   real(wp), dimension(4) :: t, axial

   t = m*(ellipd_mc(mc) - ellips_mc(mc))
   axial = merge(m*ellipd_mc(mc)/2 + (1 - rho)*ellipe_mc(mc)/near, (ellipe_mc(mc) - rho*t)/near, &
      rho < 1 .or. mc < 0.05_wp)
   print '(4es21.13)', z*t/near/(acos(-1.0_wp)*sqrt(far)), axial/(acos(-1.0_wp)*sqrt(far))
   ! => 2.1466252583998E-09 1.2866808487309E-01 7.9577511331547E+04 2.8799999999893E-18
   ! => 3.5777087639997E-01 3.4583167004288E-01 7.9578669058709E+04 1.8400000000056E-18
end program current_loop
