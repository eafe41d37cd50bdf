! SPDX-License-Identifier: MIT

!> A pendulum of 25 cm let go at 90 degrees: exact, rate, and what the small-angle formula says.
program motion_released
   use, intrinsic :: iso_fortran_env, only : wp => real64
   use furiko, only : motion, pendulum
   implicit none
   type(pendulum) :: body
   type(motion) :: path
   integer :: i

   body = pendulum(length=0.25_wp, gravity=9.8_wp)
   path = body%released(acos(-1.0_wp)/2)
   print '(2f9.6)', body%small_period(), path%period()   ! => 1.003545 1.184525
   do i = 1, 3
      associate (t => 0.2_wp*i)
         print '(f4.1, 3f10.6)', t, path%angle(t), path%rate(t), path%harmonic_angle(t)
      end associate
   end do
   ! => 0.2 0.802383 -7.381572 0.492029
   ! => 0.4 -0.858640 -7.157644 -1.262554
   ! => 0.6 -1.569623 0.303313 -1.282983
end program motion_released
