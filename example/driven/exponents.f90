! SPDX-License-Identifier: MIT

!> Lyapunov exponents of a periodic and of a chaotic pendulum: is the first above 0? Their sum is -damping.
program exponents
   use, intrinsic :: iso_fortran_env, only : wp => real64
   use furiko, only : driven_exponents, driven_order8, driven_pendulum, driven_scheme, driven_state
   implicit none
   type(driven_scheme) :: scheme
   type(driven_pendulum) :: body(2)
   type(driven_state) :: state(2)
   real(wp) :: lambda(2, 2), error(2)

   scheme = driven_order8(64)
   body = driven_pendulum(damping=0.5_wp, amplitude=0.9_wp, frequency=2.0_wp/3.0_wp)
   body(2)%amplitude = 1.2_wp
   call driven_exponents(scheme, body, state, 200, 1600, lambda, error)
   print '(2l2)', lambda(1, :) > 0           ! => F T
   print '(2f12.8)', sum(lambda, 1)          ! => -0.50000000 -0.50000000
end program exponents
