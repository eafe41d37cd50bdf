! SPDX-License-Identifier: MIT

!> Hit at the bottom a trifle too weakly, just right and a trifle too hard to go over the top.
program over_the_top
   use, intrinsic :: iso_fortran_env, only : wp => real64
   use furiko, only : motion, pendulum
   implicit none
   type(pendulum) :: body
   type(motion) :: path
   integer :: i

   body = pendulum(length=1.0_wp, gravity=4.0_wp)   ! the separatrix: 2 omega = 4 rad/s
   do i = -1, 1
      path = body%started(0.0_wp, 4.0_wp + i*1e-9_wp)
      print '(2l2, 1x, f7.4, 3f10.5)', path%is_libration(), path%is_rotation(), path%period(), &
         path%angle([1.0_wp, 10.0_wp, 20.0_wp])
   end do
   ! => T F 24.1890 2.60352 3.08095 -3.14067
   ! => F F Inf 2.60352 3.14159 3.14159
   ! => F T 12.0945 2.60352 3.20223 9.42570
end program over_the_top
