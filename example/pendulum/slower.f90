! SPDX-License-Identifier: MIT

!> At which amplitude is a pendulum 3 percent slow, and when is its clock half a swing off?
program slower
   use, intrinsic :: iso_fortran_env, only : wp => real64
   use furiko, only : amplitude_of_excess, amplitude_three_terms, period_excess
   implicit none
   real(wp), parameter :: degree = acos(-1.0_wp)/180

   print '(f8.4)', amplitude_of_excess(0.03_wp)/degree       ! => 39.1588
   print '(f8.4)', amplitude_three_terms(0.03_wp)/degree     ! => 39.2562
   print '(es12.5)', amplitude_of_excess(1e-15_wp)/degree    ! => 7.24741E-06
   print '(f7.3)', 0.5_wp/period_excess(20*degree)           ! => 65.197
end program slower
