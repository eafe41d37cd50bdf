! SPDX-License-Identifier: MIT

!> The third kind from R_J, and the logarithm of 2 from R_C.
program symmetric
   use, intrinsic :: iso_fortran_env, only : wp => real64
   use furiko, only : carlson_rc, carlson_rj, ellipk_m, ellippi_m
   implicit none
   real(wp), parameter :: n = 0.3_wp, m = 0.25_wp

   print '(f15.12)', ellippi_m(n, m)                                              ! => 2.027792445811
   print '(f15.12)', ellipk_m(m) + n/3*carlson_rj(0.0_wp, 1 - m, 1.0_wp, 1 - n)   ! => 2.027792445811
   print '(2f15.12)', log(2.0_wp), carlson_rc(2.25_wp, 2.0_wp)
   ! => 0.693147180560 0.693147180560
end program symmetric
