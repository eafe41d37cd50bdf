! SPDX-License-Identifier: MIT

!> Three ways to K(1/2): terms of the series, subintervals of the trapezoid, steps of the AGM.
program converge
   use, intrinsic :: iso_fortran_env, only : wp => real64
   use furiko, only : agm_steps_k, ellipk_series_k, ellipk_trapezoid_k
   implicit none
   real(wp), dimension(6) :: a, b, c, k, e
   integer :: n

   call agm_steps_k(0.5_wp, a, b, c, k, e)
   do n = 2, 5
      print '(i1, 3f18.15)', n, ellipk_series_k(0.5_wp, n), ellipk_trapezoid_k(0.5_wp, n), k(n + 1)
   end do
   ! => 2 1.668971097219578 1.685774876938636 1.685749651293059
   ! => 3 1.682776924310548 1.685750459103333 1.685750354812523
   ! => 4 1.685173769291620 1.685750355280611 1.685750354812596
   ! => 5 1.685632540401278 1.685750354814761 1.685750354812596
end program converge
