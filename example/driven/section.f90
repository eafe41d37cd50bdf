! SPDX-License-Identifier: MIT

!> Two driven pendulums side by side: three points of the section of each, one with a period of two drives.
program section
   use, intrinsic :: iso_fortran_env, only : wp => real64
   use furiko, only : driven_order8, driven_pendulum, driven_periods, driven_scheme, &
      driven_section, driven_state
   implicit none
   type(driven_scheme) :: scheme
   type(driven_pendulum) :: body(2)
   type(driven_state) :: state(2), points(3, 2)

   scheme = driven_order8(96)
   body = driven_pendulum(damping=0.5_wp, amplitude=0.9_wp, frequency=2.0_wp/3.0_wp)
   body(2)%amplitude = 1.07_wp
   call driven_periods(scheme, body, state, 500)
   call driven_section(scheme, body, state, 500, points)
   print '(3f12.8)', points%angle   ! => -0.56022833 -0.56022833 -0.56022833
   ! => -0.32017765 -0.14672150 -0.32017765
end program section
