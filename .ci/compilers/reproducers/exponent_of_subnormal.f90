! SPDX-License-Identifier: MIT

! flang 19 and 22: the exponent of a subnormal constant is folded to that of the smallest normal number,
! -1021, where the same number in a variable has -1073.
program main
   use, intrinsic :: iso_fortran_env, only : wp => real64
   implicit none
   real(wp), parameter :: least = tiny(1.0_wp)*epsilon(1.0_wp)
   real(wp) :: x

   x = least
   print '(2(i0, 1x))', exponent(least), exponent(x)
end program main
