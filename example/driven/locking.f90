! SPDX-License-Identifier: MIT

!> A rotation that is locked to its drive, and the least torque that keeps a pendulum turning.
program locking
   use, intrinsic :: iso_fortran_env, only : int64, wp => real64
   use furiko, only : driven_locking, driven_order8, driven_pendulum, driven_periods, driven_return_torque, &
      driven_scheme, driven_state
   implicit none
   type(driven_scheme) :: scheme
   type(driven_pendulum) :: body(1)
   type(driven_state) :: state(1)
   integer(int64) :: turns(1)
   integer :: period(1)

   scheme = driven_order8(96)
   body = driven_pendulum(damping=0.5_wp, amplitude=1.4_wp, frequency=2.0_wp/3.0_wp)
   call driven_periods(scheme, body, state, 1000)
   call driven_locking(scheme, body, state, 8, 1e-9_wp, period, turns)
   print '(i0, a, i0)', abs(turns(1)), ' turns in periods: ', period(1)   ! => 1 turns in periods: 1
   print '(f11.8)', driven_return_torque(0.5_wp)   ! => 0.59738320
end program locking
