! SPDX-License-Identifier: MIT

!> J of an angle is D where n is 0, and phi**3/3 for small angles; by Pi - F that would be 0.
program third_of_angle
   use, intrinsic :: iso_fortran_env, only : wp => real64
   use furiko, only : ellipdinc_m, ellipjinc_m
   implicit none

   print '(2f17.14)', ellipjinc_m(0.0_wp, 1.0_wp, 0.5_wp), ellipdinc_m(1.0_wp, 0.5_wp)
   ! => 0.31177377844146 0.31177377844146
   print '(es22.14)', ellipjinc_m(0.3_wp, 1e-6_wp, 0.5_wp)   ! => 3.33333333333377E-19
end program third_of_angle
