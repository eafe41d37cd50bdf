! SPDX-License-Identifier: MIT

!> Stand-in for the library's furiko_motion until it has landed; the interface is that one's.
module furiko_stand_in
   use, intrinsic :: iso_fortran_env, only : wp => real64
   use furiko, only : ellipk_mc
   implicit none
   private
   public :: pendulum, motion

   type :: pendulum
      real(wp) :: length = 1.0_wp
      real(wp) :: gravity = 9.80665_wp
   contains
      procedure :: released
      procedure :: swinging
      procedure :: frequency
      procedure :: small_period
   end type pendulum

   type :: motion
      real(wp) :: omega = 1.0_wp, k = 0.0_wp, kc = 1.0_wp, u0 = 0.0_wp
   contains
      procedure :: angle
      procedure :: period
   end type motion

contains

   elemental function frequency(self)
      class(pendulum), intent(in) :: self
      real(wp) :: frequency
      frequency = sqrt(self%gravity/self%length)
   end function frequency

   elemental function small_period(self)
      class(pendulum), intent(in) :: self
      real(wp) :: small_period
      small_period = 2*acos(-1.0_wp)/self%frequency()
   end function small_period

   elemental function swinging(self, amplitude) result(path)
      class(pendulum), intent(in) :: self
      real(wp), intent(in) :: amplitude
      type(motion) :: path
      path%omega = self%frequency()
      path%k = sin(amplitude/2)
      path%kc = cos(amplitude/2)
   end function swinging

   elemental function released(self, angle) result(path)
      class(pendulum), intent(in) :: self
      real(wp), intent(in) :: angle
      type(motion) :: path
      path = self%swinging(angle)
      path%u0 = ellipk_mc(path%kc**2)
   end function released

   elemental function period(self)
      class(motion), intent(in) :: self
      real(wp) :: period
      period = 4*ellipk_mc(self%kc**2)/self%omega
   end function period

   !> am by the descending AGM (DLMF 22.20.3-5)
   elemental function angle(self, time)
      class(motion), intent(in) :: self
      real(wp), intent(in) :: time
      real(wp) :: angle
      real(wp) :: a(0:12), b(0:12), c(0:12), phi
      integer :: n
      a(0) = 1
      b(0) = self%kc
      c(0) = self%k
      do n = 1, 12
         a(n) = (a(n - 1) + b(n - 1))/2
         b(n) = sqrt(a(n - 1)*b(n - 1))
         c(n) = c(n - 1)**2/(4*a(n))
      end do
      phi = 2.0_wp**12*a(12)*(self%omega*time + self%u0)
      do n = 12, 1, -1
         phi = (phi + asin(c(n)/a(n)*sin(phi)))/2
      end do
      angle = 2*asin(self%k*sin(phi))
   end function angle

end module furiko_stand_in
