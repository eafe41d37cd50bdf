! SPDX-License-Identifier: MIT
#include "../arithmetic/furiko_compiler.inc"

!> A pendulum's exact motion for C: the object lies in the caller's storage, as numbers that mean nothing to
!> anybody else.
module furiko_c_motion
   use, intrinsic :: iso_c_binding, only : c_double, c_int, c_int64_t, c_size_t
   use furiko_motion, only : motion, pendulum
   implicit none
   private

   integer, parameter :: wp = c_double
   !> Numbers of the storage in C; some are left for what is to come
   integer, parameter :: room = 95
   !> Says in one more that it was made; any bits would do
   integer(c_int64_t), parameter :: made = 7885350463184921940_c_int64_t
   ! How many of an array are worked on at once: the kernels count by default integers
   integer(c_size_t), parameter :: most = 4096


   !> `furiko_motion` in C
   type, bind(c) :: c_motion
      real(c_double) :: opaque(room)
      real(c_double) :: tag
   end type c_motion


contains


   pure subroutine c_released(self, length, gravity, angle) bind(c, name='furiko_motion_released')
      type(c_motion), intent(out) :: self
      real(wp), intent(in), value :: length, gravity, angle
      type(pendulum) :: body

      body = pendulum(length=length, gravity=gravity)
      call store(body%released(angle), self)
   end subroutine c_released


   pure subroutine c_swinging(self, length, gravity, amplitude) bind(c, name='furiko_motion_swinging')
      type(c_motion), intent(out) :: self
      real(wp), intent(in), value :: length, gravity, amplitude
      type(pendulum) :: body

      body = pendulum(length=length, gravity=gravity)
      call store(body%swinging(amplitude), self)
   end subroutine c_swinging


   pure subroutine c_started(self, length, gravity, angle, rate) bind(c, name='furiko_motion_started')
      type(c_motion), intent(out) :: self
      real(wp), intent(in), value :: length, gravity, angle, rate
      type(pendulum) :: body

      body = pendulum(length=length, gravity=gravity)
      call store(body%started(angle, rate), self)
   end subroutine c_started


   pure function c_size() result(bytes) bind(c, name='furiko_motion_size')
      integer(c_size_t) :: bytes
      type(c_motion) :: self

      bytes = storage_size(self, c_size_t)/8
   end function c_size


   pure function c_is_libration(self) result(yes) bind(c, name='furiko_motion_is_libration')
      type(c_motion), intent(in) :: self
      integer(c_int) :: yes
      type(motion) :: path

      path = stored(self)
      yes = merge(1_c_int, 0_c_int, path%is_libration())
   end function c_is_libration


   pure function c_is_rotation(self) result(yes) bind(c, name='furiko_motion_is_rotation')
      type(c_motion), intent(in) :: self
      integer(c_int) :: yes
      type(motion) :: path

      path = stored(self)
      yes = merge(1_c_int, 0_c_int, path%is_rotation())
   end function c_is_rotation


   pure function c_period(self) result(f) bind(c, name='furiko_motion_period')
      type(c_motion), intent(in) :: self
      real(wp) :: f
      type(motion) :: path

      path = stored(self)
      f = path%period()
   end function c_period


   pure function c_amplitude(self) result(f) bind(c, name='furiko_motion_amplitude')
      type(c_motion), intent(in) :: self
      real(wp) :: f
      type(motion) :: path

      path = stored(self)
      f = path%amplitude()
   end function c_amplitude


   pure function c_energy(self) result(f) bind(c, name='furiko_motion_energy')
      type(c_motion), intent(in) :: self
      real(wp) :: f
      type(motion) :: path

      path = stored(self)
      f = path%energy()
   end function c_energy


   pure function c_slack_angle(self) result(f) bind(c, name='furiko_motion_slack_angle')
      type(c_motion), intent(in) :: self
      real(wp) :: f
      type(motion) :: path

      path = stored(self)
      f = path%slack_angle()
   end function c_slack_angle


   pure function c_time_to(self, angle) result(f) bind(c, name='furiko_motion_time_to')
      type(c_motion), intent(in) :: self
      real(wp), intent(in), value :: angle
      real(wp) :: f
      type(motion) :: path

      path = stored(self)
      f = path%time_to(angle)
   end function c_time_to


   pure function c_phase(self, time) result(f) bind(c, name='furiko_motion_phase')
      type(c_motion), intent(in) :: self
      real(wp), intent(in), value :: time
      real(wp) :: f
      type(motion) :: path

      path = stored(self)
      f = path%phase(time)
   end function c_phase


   pure function c_harmonic_angle(self, time) result(f) bind(c, name='furiko_motion_harmonic_angle')
      type(c_motion), intent(in) :: self
      real(wp), intent(in), value :: time
      real(wp) :: f
      type(motion) :: path

      path = stored(self)
      f = path%harmonic_angle(time)
   end function c_harmonic_angle


   pure function c_angle(self, time) result(f) bind(c, name='furiko_motion_angle')
      type(c_motion), intent(in) :: self
      real(wp), intent(in), value :: time
      real(wp) :: f
      type(motion) :: path

      path = stored(self)
      f = path%angle(time)
   end function c_angle


   pure subroutine c_angle_v(self, count, time, f) bind(c, name='furiko_motion_angle_v')
      type(c_motion), intent(in) :: self
      integer(c_size_t), intent(in), value :: count
      real(wp), intent(in) :: time(count)
      real(wp), intent(out) :: f(count)
      type(motion) :: path
      integer(c_size_t) :: first, last

      path = stored(self)
      do first = 1, count, most
         last = min(first + most - 1, count)
         f(first:last) = path%angle(time(first:last))
      end do
   end subroutine c_angle_v


   pure function c_rate(self, time) result(f) bind(c, name='furiko_motion_rate')
      type(c_motion), intent(in) :: self
      real(wp), intent(in), value :: time
      real(wp) :: f
      type(motion) :: path

      path = stored(self)
      f = path%rate(time)
   end function c_rate


   pure subroutine c_rate_v(self, count, time, f) bind(c, name='furiko_motion_rate_v')
      type(c_motion), intent(in) :: self
      integer(c_size_t), intent(in), value :: count
      real(wp), intent(in) :: time(count)
      real(wp), intent(out) :: f(count)
      type(motion) :: path
      integer(c_size_t) :: first, last

      path = stored(self)
      do first = 1, count, most
         last = min(first + most - 1, count)
         f(first:last) = path%rate(time(first:last))
      end do
   end subroutine c_rate_v


   pure function c_tension(self, time) result(f) bind(c, name='furiko_motion_tension')
      type(c_motion), intent(in) :: self
      real(wp), intent(in), value :: time
      real(wp) :: f
      type(motion) :: path

      path = stored(self)
      f = path%tension(time)
   end function c_tension


   pure subroutine c_tension_v(self, count, time, f) bind(c, name='furiko_motion_tension_v')
      type(c_motion), intent(in) :: self
      integer(c_size_t), intent(in), value :: count
      real(wp), intent(in) :: time(count)
      real(wp), intent(out) :: f(count)
      type(motion) :: path
      integer(c_size_t) :: first, last

      path = stored(self)
      do first = 1, count, most
         last = min(first + most - 1, count)
         f(first:last) = path%tension(time(first:last))
      end do
   end subroutine c_tension_v


   !> The object's bits into the caller's storage. A room too small is found by strict compilers.
   pure subroutine store(path, self)
      type(motion), intent(in) :: path
      type(c_motion), intent(out) :: self
      integer, parameter :: used = ceiling(storage_size(path)/64.0)
      ! Not an array, which would be allocated
      type :: image
         real(c_double) :: numbers(used)
      end type image
      type(image) :: bits

      bits = transfer(path, bits)
      self%opaque(:used) = bits%numbers
      self%opaque(used + 1:) = 0.0_wp
      self%tag = transfer(made, 1.0_wp)
   end subroutine store


   !> And back; what was never made says NaN, as in Fortran
   pure function stored(self) result(path)
      type(c_motion), intent(in) :: self
      type(motion) :: path

      if (transfer(self%tag, made) == made) path = transfer(self, path)
   end function stored

end module furiko_c_motion
! rooms: 3759241635
