! SPDX-License-Identifier: MIT

!> The road to chaos: where the cycle of a driven pendulum doubles its period, once, twice, three times.
program doubling
   use, intrinsic :: iso_fortran_env, only : wp => real64
   use furiko, only : driven_amplitude, driven_cascade, driven_order8, driven_pendulum, driven_periods, &
      driven_scheme, driven_state
   implicit none
   type(driven_scheme) :: scheme
   type(driven_pendulum) :: body(1)
   type(driven_state) :: state(1)
   real(wp) :: thresholds(3)
   integer :: found

   scheme = driven_order8(96)
   body = driven_pendulum(damping=0.5_wp, amplitude=1.06_wp, frequency=2.0_wp/3.0_wp)
   call driven_periods(scheme, body, state, 500)
   call driven_cascade(scheme, body(1), driven_amplitude, 1e-3_wp, state, thresholds, found)
   print '(i1, 3f15.11)', found, thresholds   ! => 3 1.06637286246 1.07931390590 1.08208438429
end program doubling
