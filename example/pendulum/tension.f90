! SPDX-License-Identifier: MIT

!> A string instead of a rod: how hard it is pulled, where it goes slack, and when.
program tension
   use, intrinsic :: iso_fortran_env, only : wp => real64
   use furiko, only : motion, pendulum
   implicit none
   real(wp), parameter :: degree = acos(-1.0_wp)/180
   type(pendulum) :: body
   type(motion) :: path

   path = body%swinging(120*degree)
   print '(f9.6)', path%tension(0.0_wp)   ! => 4.000000
   print '(2f11.6)', path%slack_angle()/degree, path%time_to(path%slack_angle())   ! => 109.471221 0.482298
   path = body%swinging(90*degree)
   print '(f9.6)', path%slack_angle()   ! => NaN
end program tension
