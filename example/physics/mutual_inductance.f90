! SPDX-License-Identifier: MIT

!> The mutual inductance of two coaxial loops of radii 1 and 1e-6, 1 apart, over mu0: by S to all digits,
!> and as Maxwell has it, by K and E, of which three figures are right. S of mc keeps them for loops that
!> nearly touch, too.
program mutual_inductance
   use, intrinsic :: iso_fortran_env, only : wp => real64
   use furiko, only : ellipe_m, ellipk_m, ellips_mc
   implicit none
   real(wp), parameter :: a = 1.0_wp, b = 1.0e-6_wp, d = 1.0_wp, q = (a + b)**2 + d**2, m = 4*a*b/q
   real(wp), parameter :: mc = ((a - b)**2 + d**2)/q

   print '(es22.15)', m**2*sqrt(q)/2*ellips_mc(mc)   ! => 5.553603672696395E-13
   print '(es9.2)', sqrt(a*b/m)*((2 - m)*ellipk_m(m) - 2*ellipe_m(m))   ! => 5.55E-13
end program mutual_inductance
