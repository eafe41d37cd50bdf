! SPDX-License-Identifier: MIT

!> A thousand pendulums at once, one let go at each thousandth of 3 rad: how far those at 1, 2 and
!> 3 rad are after a minute.
program many
   use, intrinsic :: iso_fortran_env, only : wp => real64
   use furiko, only : pendulum_rk4
   implicit none
   real(wp) :: angle(1000), rate(1000)
   integer :: i

   angle = [(0.003_wp*i, i=1, 1000)]
   rate = 0
   call pendulum_rk4(9.8_wp, 0.001_wp, 60000, angle, rate)
   print '(3f12.6)', angle([333, 667, 1000])
   ! => 0.971706 -1.996282 -2.592006
end program many
