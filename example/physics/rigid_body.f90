! SPDX-License-Identifier: MIT

!> A free rigid body with moments of inertia 1, 2, 3 (a racket in the air): its angular velocity, which
!> begins as (1, 0, 0.6), by Euler's equations after 0, 5 and 10 s, and its period.
program rigid_body
   use, intrinsic :: iso_fortran_env, only : wp => real64
   use furiko, only : ellipk_m, jacobi_m
   implicit none
   real(wp), parameter :: i1 = 1.0_wp, i2 = 2.0_wp, i3 = 3.0_wp, w1 = 1.0_wp, w3 = 0.6_wp
   real(wp), parameter :: m = (i2 - i1)*i1*w1**2/((i3 - i2)*i3*w3**2)
   real(wp), parameter :: rate = w3*sqrt((i3 - i2)*(i3 - i1)/(i1*i2))
   real(wp), parameter :: w2 = w1*sqrt(i1*(i3 - i1)/(i2*(i3 - i2)))
   real(wp), dimension(3) :: t = [0.0_wp, 5.0_wp, 10.0_wp], sn, cn, dn

   call jacobi_m(rate*t, spread(m, 1, 3), sn, cn, dn)
   print '(3f16.12)', w1*cn   ! => 1.000000000000 -0.077018583682 -0.860470146054
   print '(3f16.12)', w2*sn   ! => 0.000000000000 0.997029657416 -0.509500861383
   print '(3f16.12)', w3*dn   ! => 0.600000000000 0.169245248316 0.522943232181
   print '(f16.12)', 4*ellipk_m(m)/rate   ! => 18.134176597606
end program rigid_body
