! SPDX-License-Identifier: MIT

!> The period's series: two and three terms at 45 degrees, and the bound on what they leave out.
program series
   use, intrinsic :: iso_fortran_env, only : wp => real64
   use furiko, only : amplitude_three_terms, ellipk_remainder_k, period_ratio, period_ratio_series
   implicit none
   real(wp), parameter :: degree = acos(-1.0_wp)/180

   print '(3f9.5)', period_ratio_series(45*degree, [2, 3]), period_ratio(45*degree)
   ! =>  1.03661  1.03963  1.03997
   print '(es8.1)', 2/acos(-1.0_wp)*ellipk_remainder_k(sin(22.5_wp*degree), 3)      ! =>  3.6E-04
   print '(f7.3)', amplitude_three_terms(0.03_wp)/degree                            ! =>  39.256
end program series
