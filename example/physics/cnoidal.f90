! SPDX-License-Identifier: MIT

!> A cnoidal wave of Korteweg and de Vries, 1 m high on water 5 m deep, mc = 1e-3: its length in metres, its
!> speed in m/s, the level of its troughs, and that of the surface from a crest to a trough in quarters.
program cnoidal
   use, intrinsic :: iso_fortran_env, only : wp => real64
   use furiko, only : ellipke_mc, jacobi_cn_mc
   implicit none
   real(wp), parameter :: depth = 5.0_wp, height = 1.0_wp, mc = 1.0e-3_wp, m = 1 - mc, g = 9.80665_wp
   real(wp) :: k, e, trough
   integer :: i

   call ellipke_mc(mc, k, e)
   trough = height/m*(mc - e/k)
   print '(3f14.9)', depth*sqrt(16*m*depth/(3*height))*k, &
      sqrt(g*depth)*(1 + height/(m*depth)*(1 - m/2 - 1.5_wp*e/k)), trough
   ! => 124.934990840 7.268706712 -0.206217858
   print '(5f14.9)', trough + height*jacobi_cn_mc(k*[(0.25_wp*i, i=0, 4)], mc)**2
   ! => 0.793782142 0.093409226 -0.175564428 -0.203885827 -0.206217858
end program cnoidal
