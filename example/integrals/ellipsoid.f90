! SPDX-License-Identifier: MIT

!> An ellipsoid of half axes 1, 2, 3: its demagnetizing factors, its capacitance over 4 pi epsilon0.
program ellipsoid
   use, intrinsic :: iso_fortran_env, only : wp => real64
   use furiko, only : carlson_rd, carlson_rf
   implicit none
   real(wp) :: n(3)

   n(1) = 2*carlson_rd(4.0_wp, 9.0_wp, 1.0_wp)
   n(2) = 2*carlson_rd(9.0_wp, 1.0_wp, 4.0_wp)
   n(3) = 2*carlson_rd(1.0_wp, 4.0_wp, 9.0_wp)
   print '(4f13.10)', n, sum(n)
   ! => 0.5765452609 0.2671540403 0.1563006988 1.0000000000
   print '(f13.10)', 1/carlson_rf(1.0_wp, 4.0_wp, 9.0_wp)    ! => 1.9660092007
end program ellipsoid
