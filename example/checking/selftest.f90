! SPDX-License-Identifier: MIT

!> Does this build compute right? Ask once, before you rely on a number.
program selftest
   use furiko, only : furiko_selftest
   implicit none

   if (furiko_selftest() /= 0) error stop 'furiko computes wrong numbers in this build'
   print '(a)', 'all known values are right'   ! => all known values are right
end program selftest
