! SPDX-License-Identifier: MIT

!> Five points at equal steps of arc on a quarter of the ellipse of half axes 2 and 1
program equal_arcs
   use, intrinsic :: iso_fortran_env, only : wp => real64
   use furiko, only : ellipe_mc, ellipeinc_inverse_mc
   implicit none
   real(wp), parameter :: a = 2.0_wp, b = 1.0_wp
   real(wp) :: phi
   integer :: i

   do i = 0, 4
      phi = ellipeinc_inverse_mc(0.25_wp*i*ellipe_mc((b/a)**2), (b/a)**2)
      print '(2f9.6)', a*sin(phi), b*cos(phi)
   end do
   ! => 0.000000 1.000000
   ! => 0.603118 0.953447
   ! => 1.188944 0.804116
   ! => 1.716666 0.513093
   ! => 2.000000 0.000000
end program equal_arcs
