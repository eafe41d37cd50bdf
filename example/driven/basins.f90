! SPDX-License-Identifier: MIT

!> Two attractors, a rotation to either side, and how many of 64 starts each of them draws.
program basins
   use, intrinsic :: iso_fortran_env, only : wp => real64
   use furiko, only : driven_attractors, driven_basins, driven_order8, driven_pendulum, &
      driven_scheme, driven_state
   implicit none
   type(driven_pendulum) :: body
   type(driven_state) :: start(64), state(64), points(8)
   integer :: label(8), found, basin(64), arrival(64), i

   body = driven_pendulum(damping=0.5_wp, amplitude=1.4_wp, frequency=2.0_wp/3.0_wp)
   start = [(driven_state(angle=0.1_wp*i - 3.2_wp), i=1, 64)]
   state = start
   call driven_attractors(driven_order8(64), body, state, 500, 4, points, label, found)
   state = start
   call driven_basins(driven_order8(64), body, state, points, label, 1e-3_wp, 500, basin, arrival)
   print '(4i4)', found, [(count(basin == i), i=0, 2)]   ! => 2 0 9 55
end program basins
