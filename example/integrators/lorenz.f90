! SPDX-License-Identifier: MIT

!> The Lorenz system by Runge-Kutta: the right-hand side is a subroutine of a module.
module lorenz_system
   use, intrinsic :: iso_fortran_env, only : wp => real64
   implicit none
   private
   public :: lorenz_rates, wp
contains
   subroutine lorenz_rates(t, y, parameters, rate)
      real(wp), intent(in) :: t, y(:), parameters(:)
      real(wp), intent(out) :: rate(:)

      associate (sigma => parameters(1), rho => parameters(2), beta => parameters(3), unused => t)
         rate = [sigma*(y(2) - y(1)), y(1)*(rho - y(3)) - y(2), y(1)*y(2) - beta*y(3)]
      end associate
   end subroutine lorenz_rates
end module lorenz_system

program lorenz
   use lorenz_system, only : lorenz_rates, wp
   use furiko, only : rk4
   implicit none
   real(wp) :: y(3)

   y = [1.0_wp, 1.0_wp, 1.0_wp]
   call rk4(lorenz_rates, [10.0_wp, 28.0_wp, 8.0_wp/3.0_wp], 0.0_wp, 0.001_wp, 5000, y)
   print '(3f12.6)', y   ! => -6.512114 -6.974043 23.924130
end program lorenz
