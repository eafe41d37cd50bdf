! SPDX-License-Identifier: MIT

!> A planet of eccentricity 1/2 for a thousand years: the energy, which is -1/2, by Verlet and Forest-Ruth.
module kepler_force
   use, intrinsic :: iso_fortran_env, only : wp => real64
   implicit none
   private
   public :: gravity, wp
contains
   subroutine gravity(x, parameters, a)
      real(wp), intent(in) :: x(:), parameters(:)
      real(wp), intent(out) :: a(:)

      a = -parameters(1)*x/norm2(x)**3
   end subroutine gravity
end module kepler_force

program kepler
   use kepler_force, only : gravity, wp
   use furiko, only : forest_ruth, verlet
   implicit none
   real(wp), parameter :: year = 2*acos(-1.0_wp)
   real(wp) :: x(2, 2), v(2, 2)

   x(1, :) = 0.5_wp
   x(2, :) = 0
   v(1, :) = 0
   v(2, :) = sqrt(3.0_wp)
   call verlet(gravity, [1.0_wp], year/1000, 1000000, x(:, 1), v(:, 1))
   call forest_ruth(gravity, [1.0_wp], year/1000, 1000000, x(:, 2), v(:, 2))
   print '(2f14.9)', sum(v**2, 1)/2 - 1/norm2(x, 1)   ! => -0.500001389 -0.500000000
end program kepler
