! SPDX-License-Identifier: MIT

!> The surface of the ellipsoid with axes 1, 2, 3 is 4 pi R_G(1*4, 1*9, 4*9).
program carlson
   use, intrinsic :: iso_fortran_env, only : wp => real64
   use furiko, only : carlson_rg
   implicit none

   print '(f15.11)', 4*acos(-1.0_wp)*carlson_rg(4.0_wp, 9.0_wp, 36.0_wp) ! => 48.88214630258
end program carlson
