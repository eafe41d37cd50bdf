! SPDX-License-Identifier: MIT
#include "../arithmetic/furiko_compiler.inc"

!> How driven pendulums turn: winding numbers, locked steps, and what it takes to keep turning.
module furiko_driven_rotation
   use, intrinsic :: iso_fortran_env, only : int64, wp => real64
   use furiko_bits_dp, only : nan
   use furiko_driven_scheme, only : driven_order8, driven_scheme
   use furiko_driven_steps, only : driven_block, driven_is_near, driven_pendulum, driven_periods, driven_state
   implicit none
   private
   public :: driven_winding, driven_locking, driven_return_torque, driven_least_rate

   real(wp), parameter :: pi = acos(-1.0_wp)
   ! Times that a bracket is divided by driven_block + 1: to the last digit
   integer, parameter :: passes = 9


contains


   !> The winding number of each member, turns for each period of the drive: the angle gained over so many
   !> periods, after a transient. It errs by about 1/periods where it is not locked; see [[driven_locking]]
   !> for what it is exactly where it is. NaN for a member that stops on its way.
   subroutine driven_winding(scheme, pendulum, state, transient, periods, winding)
      !> Method and steps to a period
      type(driven_scheme), intent(in) :: scheme
      !> Constants of each member
      type(driven_pendulum), intent(in) :: pendulum(:)
      !> Their starts, and their ends
      type(driven_state), intent(inout) :: state(:)
      !> Periods before the first
      integer, intent(in) :: transient
      !> Periods to count over, at least 1
      integer, intent(in) :: periods
      !> Turns to a period
      real(wp), intent(out) :: winding(:)
      type(driven_state) :: before(size(state))

      call driven_periods(scheme, pendulum, state, transient)
      before = state
      call driven_periods(scheme, pendulum, state, periods)
      winding = (real(state%turns - before%turns, wp) + (state%angle - before%angle)/(2*pi))/real(periods, wp)
   end subroutine driven_winding


   !> Whether each member has come to a cycle: its least period, and the whole turns that it makes in that,
   !> so that the winding number is exactly turns/period. The period is 0 where there is none up to `longest`,
   !> or none yet.
   subroutine driven_locking(scheme, pendulum, state, longest, tolerance, period, turns)
      !> Method and steps to a period
      type(driven_scheme), intent(in) :: scheme
      !> Constants of each member
      type(driven_pendulum), intent(in) :: pendulum(:)
      !> Where they are when the transient is over, and where they are `longest` periods later
      type(driven_state), intent(inout) :: state(:)
      !> The longest period that is looked for
      integer, intent(in) :: longest
      !> How near the member has to come to where it was, in angle and rate
      real(wp), intent(in) :: tolerance
      !> Periods of the cycle, or 0
      integer, intent(out) :: period(:)
      !> Its turns
      integer(int64), intent(out) :: turns(:)
      type(driven_state) :: start(size(state))
      integer :: i

      start = state
      period = 0
      turns = 0_int64
      do i = 1, longest
         call driven_periods(scheme, pendulum, state, 1)
         where (period == 0 .and. driven_is_near(state, start, tolerance))
            period = i
            turns = state%turns - start%turns + nint((state%angle - start%angle)/(2*pi), int64)
         end where
      end do
   end subroutine driven_locking


   !> The return torque (of a Josephson junction, the return current): the least torque that keeps a pendulum
   !> with linear damping b, without a drive, turning for ever. There a rotation that has just left the upper,
   !> unstable equilibrium comes to it again. About 4 b/pi for small b, and 1 from b = 1.193 on, where the
   !> pendulum stops as soon as it can.
   !>
   !> By trying a block of torques at once, each next to where the last block changed from falling back to
   !> going round; the start is next to the equilibrium, on the unstable manifold. To some 1e-13;
   !> b in [0.01, 10], NaN elsewhere.
   function driven_return_torque(damping) result(torque)
      !> b
      real(wp), intent(in) :: damping
      real(wp) :: torque
      type(driven_pendulum) :: pendulum(driven_block)
      type(driven_state) :: state(driven_block)
      real(wp) :: low, high, slowest, tried(driven_block)
      integer :: i

      torque = nan
      if (.not. (damping >= 0.01_wp .and. damping <= 10.0_wp)) return
      low = 0.0_wp
      high = 1.0_wp
      pendulum%damping = damping
      do i = 1, passes
         tried = trials(low, high)
         pendulum%torque = tried
         state = behind_the_top(damping, tried)
         slowest = growth(damping, sqrt(1.0_wp - tried(driven_block)**2))
         call driven_periods(driven_order8(96), pendulum, state, waiting(slowest, 1))
         call bracket(tried, whole_angle(state) < 3*pi - asin(tried), low, high)
      end do
      torque = 0.5_wp*(low + high)
   end function driven_return_torque


   !> A little past the upper equilibrium, pi - asin(torque), on the way down
   elemental function behind_the_top(b, torque) result(state)
      real(wp), intent(in) :: b
      real(wp), intent(in) :: torque
      type(driven_state) :: state
      ! So small that the curvature of the unstable manifold, and a d^3 of energy, does not matter
      real(wp), parameter :: d = 2.0_wp**(-14)

      state = driven_state(angle=pi - asin(torque) + d, rate=d*growth(b, sqrt(1.0_wp - torque**2)))
   end function behind_the_top


   !> The least rate at the bottom with which a pendulum with linear damping b, without drive and torque,
   !> passes the top so many times, tried block by block as in [[driven_return_torque]]. To some 1e-13
   !> relative; b in [0, 10], NaN elsewhere.
   function driven_least_rate(damping, times) result(rate)
      !> b
      real(wp), intent(in) :: damping
      !> How often, at least 1
      integer, intent(in) :: times
      real(wp) :: rate
      type(driven_pendulum) :: pendulum(driven_block)
      type(driven_state) :: state(driven_block)
      real(wp) :: low, high, top, tried(driven_block)
      integer :: i

      rate = nan
      if (.not. (damping >= 0.0_wp .and. damping <= 10.0_wp .and. times > 0)) return
      top = pi*real(2*times - 1, wp)
      low = 0.0_wp
      ! Without damping, 2 is enough; with it, an angle costs no more than b times itself besides.
      high = 3.0_wp + damping*top
      pendulum%damping = damping
      do i = 1, passes
         tried = trials(low, high)
         state = driven_state()
         state%rate = tried
         call driven_periods(driven_order8(96), pendulum, state, waiting(growth(damping, 1.0_wp), times))
         call bracket(tried, whole_angle(state) < top, low, high)
      end do
      rate = 0.5_wp*(low + high)
   end function driven_least_rate


   !> Values inside a bracket
   pure function trials(low, high) result(values)
      real(wp), intent(in) :: low
      real(wp), intent(in) :: high
      real(wp) :: values(driven_block)
      integer :: i

      values = low + (high - low)*([(real(i, wp), i = 1, driven_block)]/real(driven_block + 1, wp))
   end function trials


   !> The bracket of the values between which falling back becomes going round
   pure subroutine bracket(values, fell, low, high)
      real(wp), intent(in) :: values(driven_block)
      logical, intent(in) :: fell(driven_block)
      real(wp), intent(inout) :: low
      real(wp), intent(inout) :: high
      integer :: n

      n = count(fell)
      if (n > 0) low = values(n)
      if (n < driven_block) high = values(n + 1)
   end subroutine bracket


   !> How fast what is next to the unstable equilibrium leaves it: s^2 + b s = root
   elemental function growth(b, root) result(s)
      real(wp), intent(in) :: b
      real(wp), intent(in) :: root
      real(wp) :: s

      s = 2*root/(b + sqrt(b**2 + 4*root))
   end function growth


   !> Periods of 2 pi until a difference of 1e-17 next to the unstable equilibrium has decided; near a torque
   !> of 1 that would be for ever
   elemental function waiting(s, times) result(periods)
      real(wp), intent(in) :: s
      integer, intent(in) :: times
      integer :: periods

      periods = ceiling((10.0_wp*real(times, wp) + 48.0_wp/max(s, 0.008_wp))/(2*pi))
   end function waiting


   !> The angle with its turns
   elemental function whole_angle(state) result(angle)
      type(driven_state), intent(in) :: state
      real(wp) :: angle

      angle = state%angle + 2*pi*real(state%turns, wp)
   end function whole_angle
end module furiko_driven_rotation
! rooms: 3759241635
