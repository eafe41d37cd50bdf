! SPDX-License-Identifier: MIT

!> K and E, by modulus, parameter and complementary parameter.
program complete
   use, intrinsic :: iso_fortran_env, only : wp => real64
   use furiko, only : ellipk_k, ellipk_mc, ellipke_m
   implicit none
   real(wp) :: k, e

   print '(f18.15)', ellipk_k(0.5_wp)     ! =>  1.685750354812596
   call ellipke_m(0.25_wp, k, e)
   print '(2f18.15)', k, e                ! =>  1.685750354812596 1.467462209339427
   print '(f18.13)', ellipk_mc(1e-300_wp) ! =>  346.7740583102267
end program complete
