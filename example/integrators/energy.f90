! SPDX-License-Identifier: MIT

!> What is left of a pendulum's energy after 10000 swings of 1 rad, at 100 steps each.
program energy
   use, intrinsic :: iso_fortran_env, only : wp => real64
   use furiko, only : pendulum_forest_ruth, pendulum_rk4, pendulum_verlet, period_ratio
   implicit none
   real(wp) :: h, angle(3), rate(3)

   h = 2*acos(-1.0_wp)*period_ratio(1.0_wp)/100
   angle = 1
   rate = 0
   call pendulum_rk4(1.0_wp, h, 1000000, angle(1), rate(1))
   call pendulum_verlet(1.0_wp, h, 1000000, angle(2), rate(2))
   call pendulum_forest_ruth(1.0_wp, h, 1000000, angle(3), rate(3))
   print '(3f9.5)', (rate**2/2 + 1 - cos(angle))/(1 - cos(1.0_wp))
   ! => 0.99910 1.00000 1.00000
end program energy
