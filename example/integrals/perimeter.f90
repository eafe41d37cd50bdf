! SPDX-License-Identifier: MIT

!> The perimeter of an ellipse, of a circle, of a needle, and of the Earth's meridian in metres.
program perimeter
   use, intrinsic :: iso_fortran_env, only : wp => real64
   use furiko, only : ellipse_perimeter
   implicit none

   print '(3f15.11)', ellipse_perimeter([2.0_wp, 1.0_wp, 0.0_wp], 1.0_wp)
   ! =>  9.68844822055 6.28318530718 4.00000000000
   print '(f15.5)', ellipse_perimeter(6378137.0_wp, 6356752.314245_wp)    ! => 40007862.91725
end program perimeter
