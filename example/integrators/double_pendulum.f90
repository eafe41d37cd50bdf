! SPDX-License-Identifier: MIT

!> Two equal pendulums, one below the other, let go level: angles after 1 s, and whether the energy
!> is still 0.
module double_pendulum_system
   use, intrinsic :: iso_fortran_env, only : wp => real64
   implicit none
   private
   public :: double_rates, wp
contains
   ! y: both angles, then both rates; lengths are 1 m, the parameter is the gravity
   subroutine double_rates(t, y, parameters, rate)
      real(wp), intent(in) :: t, y(:), parameters(:)
      real(wp), intent(out) :: rate(:)
      real(wp) :: f(2)

      associate (s => sin(y(1) - y(2)), c => cos(y(1) - y(2)), g => parameters(1), unused => t)
         f = [-s*y(4)**2 - 2*g*sin(y(1)), s*y(3)**2 - g*sin(y(2))]
         rate = [y(3), y(4), (f(1) - c*f(2))/(2 - c**2), (2*f(2) - c*f(1))/(2 - c**2)]
      end associate
   end subroutine double_rates
end module double_pendulum_system

program double_pendulum
   use double_pendulum_system, only : double_rates, wp
   use furiko, only : rk4
   implicit none
   real(wp), parameter :: g = 9.8_wp
   real(wp) :: y(4), energy

   y = [acos(-1.0_wp)/2, acos(-1.0_wp)/2, 0.0_wp, 0.0_wp]
   call rk4(double_rates, [g], 0.0_wp, 0.0005_wp, 2000, y)
   print '(2f12.7)', y(:2)   ! => -0.6230884 -1.0339186
   energy = y(3)**2 + y(4)**2/2 + y(3)*y(4)*cos(y(1) - y(2)) - g*(2*cos(y(1)) + cos(y(2)))
   print '(l1)', abs(energy) < 1e-10_wp   ! => T
end program double_pendulum
