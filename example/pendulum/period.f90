! SPDX-License-Identifier: MIT

!> How much slower does a pendulum of 1 m swing at 45, 90 and 179 degrees?
program period
   use, intrinsic :: iso_fortran_env, only : wp => real64
   use furiko, only : period_ratio
   implicit none
   real(wp), parameter :: pi = acos(-1.0_wp), length = 1.0_wp, gravity = 9.8_wp
   real(wp) :: ratio(3)

   ratio = period_ratio([45, 90, 179]*pi/180)
   print '(3f16.12)', ratio                           ! =>  1.039973343197 1.180340599016 3.901065160389
   print '(3f9.5)', 2*pi*sqrt(length/gravity)*ratio   ! =>  2.08732  2.36905  7.82979
end program period
