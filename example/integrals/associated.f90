! SPDX-License-Identifier: MIT

!> B and D of a small m, where (K - E)/m has lost most of its digits.
program associated
   use, intrinsic :: iso_fortran_env, only : wp => real64
   use furiko, only : ellipb_m, ellipd_m, ellipe_m, ellipk_m
   implicit none
   real(wp), parameter :: m = 1e-10_wp

   print '(2f18.15)', ellipb_m(m), ellipd_m(m)         ! => 0.785398163407266 0.785398163426901
   print '(f10.7)', (ellipk_m(m) - ellipe_m(m))/m      ! => 0.7853984
end program associated
