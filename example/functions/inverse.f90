! SPDX-License-Identifier: MIT

!> When is sn u = 1/2? And which pendulum swings ten times slower than a small swing?
program inverse
   use, intrinsic :: iso_fortran_env, only : wp => real64
   use furiko, only : complementary_parameter_from_period_ratio, jacobi_arcsn_m, jacobi_sn_m
   implicit none
   real(wp) :: mc, u

   u = jacobi_arcsn_m(0.5_wp, 0.8_wp)
   print '(2f18.15)', u, jacobi_sn_m(u, 0.8_wp)           ! => 0.543604780272615 0.500000000000000
   mc = complementary_parameter_from_period_ratio(10.0_wp)
   print '(es22.15)', mc                                  ! => 3.633761709328261E-13
   ! so many degrees short of upside down
   print '(es22.15)', 2*asin(sqrt(mc))*180/acos(-1.0_wp)  ! => 6.907658362662064E-05
end program inverse
