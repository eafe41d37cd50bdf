! SPDX-License-Identifier: MIT

!> A pendulum with friction and a drive: angle and rate after one, two and three periods of the drive.
program driven
   use, intrinsic :: iso_fortran_env, only : wp => real64
   use furiko, only : rk4
   use furiko_pendulum_rates_dp, only : driven_pendulum_rates
   implicit none
   real(wp), parameter :: nu = 2.0_wp/3.0_wp, h = 2*acos(-1.0_wp)/nu/200
   real(wp) :: y(2), states(2, 3)

   y = [0.2_wp, 0.0_wp]
   ! omega2, linear and quadratic friction, drive and its frequency
   call rk4(driven_pendulum_rates, [1.0_wp, 0.5_wp, 0.0_wp, 0.9_wp, nu], 0.0_wp, h, 200, y, states)
   print '(2f12.7)', states
   ! => 1.0558793 1.2002484
   ! => -0.9604774 1.8797377
   ! => -0.5540481 1.9367142
end program driven
