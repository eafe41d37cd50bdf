! SPDX-License-Identifier: MIT

!> The meridian of the Earth's ellipsoid (WGS 84) in metres: a quarter, and from the equator to 30, 45 and
!> 60 degrees north.
program meridian
   use, intrinsic :: iso_fortran_env, only : wp => real64
   use furiko, only : ellipe_m, ellippiinc_m
   implicit none
   real(wp), parameter :: a = 6378137.0_wp, f = 1/298.257223563_wp, e2 = f*(2 - f)
   real(wp), parameter :: degree = acos(-1.0_wp)/180

   print '(f15.5)', a*ellipe_m(e2)   ! => 10001965.72931
   print '(3f15.5)', a*(1 - e2)*ellippiinc_m(e2, degree*[30, 45, 60], e2)
   ! => 3320113.39794 4984944.37798 6654072.81949
end program meridian
