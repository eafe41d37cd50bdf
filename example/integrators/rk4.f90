! SPDX-License-Identifier: MIT

!> Runge-Kutta against the exact period: let go at 1 rad, 100 steps to a period, every 20th printed.
program rk4_steps
   use, intrinsic :: iso_fortran_env, only : wp => real64
   use furiko, only : period_ratio, rk4
   use furiko_pendulum_rates_dp, only : pendulum_rates
   implicit none
   real(wp), parameter :: omega2 = 9.8_wp
   real(wp) :: period, y(2), states(2, 5)

   period = 2*acos(-1.0_wp)/sqrt(omega2)*period_ratio(1.0_wp)
   y = [1.0_wp, 0.0_wp]
   call rk4(pendulum_rates, [omega2], 0.0_wp, period/100, 20, y, states)
   print '(5f10.6)', states(1, :)
   ! => 0.315270 -0.815133 -0.815134 0.315269 1.000000
   print '(5f10.6)', states(2, :)
   ! => -2.836203 -1.688547 1.688546 2.836203 0.000002
end program rk4_steps
