! SPDX-License-Identifier: MIT

!> The mutual inductance of two coaxial loops of 10 cm and 20 cm, 5 cm apart, in microhenry.
program two_loops
   use, intrinsic :: iso_fortran_env, only : wp => real64
   use furiko, only : ellipb_m, ellipd_m
   implicit none
   real(wp), parameter :: a = 0.1_wp, b = 0.2_wp, z = 0.05_wp, mu0 = 4e-7_wp*acos(-1.0_wp)
   real(wp) :: m

   m = 4*a*b/((a + b)**2 + z**2)
   ! Maxwell's (2/k - k) K - (2/k) E is k (D - B), which keeps its digits for loops far apart
   print '(f12.9)', 1e6_wp*mu0*sqrt(a*b*m)*(ellipd_m(m) - ellipb_m(m))   ! => 0.095932940
end program two_loops
