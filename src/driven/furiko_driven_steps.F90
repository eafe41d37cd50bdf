! SPDX-License-Identifier: MIT
#include "../arithmetic/furiko_compiler.inc"

!> Driven, damped pendulums, many at once, in steps that fit their drives:
!>
!> $$ \ddot\theta = -b\,\dot\theta - c\,|\dot\theta|\,\dot\theta - \sin\theta + I
!>    + g \cos(\Omega t + \varphi). $$
!>
!> Time is counted in units of 1/omega0 = sqrt(l/gravity), so that b = 1/q, and angles in radians. This is
!> the equation of Baker and Gollub and, with b = 1/2, frequency 2/3 and g = gamma, that of Taylor's
!> chapter 12. Stroboscopic sections are at t = 0, T, 2T, ..., T = 2 pi/frequency.
module furiko_driven_steps
   use, intrinsic :: iso_fortran_env, only : int64, ip => int64, wp => real64
   use furiko_bits_dp, only : nan
   use furiko_driven_scheme, only : driven_scheme
   implicit none
   private
   public :: driven_pendulum, driven_state, driven_steps, driven_periods, driven_set, driven_get, &
      driven_is_near
   public :: driven_block, driven_ran, driven_left
   public :: driven_damping, driven_quadratic, driven_torque, driven_amplitude, driven_frequency, driven_phase


   !> Members that go side by side: calls are best with a multiple of this
   integer, parameter :: driven_block = 64
   !> What a state says: it may go on; or it was NaN or became too large, and has stopped
   integer, parameter :: driven_ran = 0, driven_left = 1
   !> The constants of a member by number, for [[driven_set]] and [[driven_get]]
   integer, parameter :: driven_damping = 1, driven_quadratic = 2, driven_torque = 3, driven_amplitude = 4, &
      driven_frequency = 5, driven_phase = 6


   !> A member's constants, of any sign unless said otherwise; a structure constructor makes one.
   type :: driven_pendulum
      !> b, linear damping; 1/q
      real(wp) :: damping = 0.0_wp
      !> c, quadratic damping
      real(wp) :: quadratic = 0.0_wp
      !> I, a constant torque
      real(wp) :: torque = 0.0_wp
      !> g, the drive's amplitude
      real(wp) :: amplitude = 0.0_wp
      !> Omega, the drive's angular frequency, above 0. Without a drive it still says how long a step is.
      real(wp) :: frequency = 1.0_wp
      !> phi, the drive's phase at t = 0, radians
      real(wp) :: phase = 0.0_wp
   end type driven_pendulum


   !> Where a member is
   type :: driven_state
      !> Angle from the bottom, in [-pi, pi], radians
      real(wp) :: angle = 0.0_wp
      !> Its rate
      real(wp) :: rate = 0.0_wp
      !> Whole turns, to be added to the angle
      integer(int64) :: turns = 0_int64
      !> driven_ran or driven_left
      integer :: status = driven_ran
   end type driven_state


   ! Rates and constants are counted in steps: with the step as the unit of time, b h, c, I h^2, g h^2.
   type :: lanes
      !> Of the members (0) and of columns of the tangent map
      real(wp), dimension(driven_block, 0:2) :: angle, rate
      real(wp), dimension(driven_block) :: turns, h, gravity, linear, quadratic, torque, even, odd
      logical :: left(driven_block)
   end type lanes

   integer, parameter :: block = driven_block, most_stages = 12
   ! Angles up to here are reduced exactly
   real(wp), parameter :: far = 2.0_wp**20
   include '../integrators/furiko_pendulum_pi_dp.inc'


contains


   !> Take members `steps` steps further, of which each has `scheme%steps` to a period of its own drive.
   !>
   !> `columns`, where given, hold one or two tangent vectors (angle, rate) for each member, and are taken
   !> along by the variational equations: from [1, 0] and [0, 1] the columns of the tangent map.
   !>
   !> Each member's end has the same bits whatever the others are and wherever it stands among them. One that
   !> is NaN, whose constants or state exceed 2^20 or whose frequency is not above 2^-20, or that gets
   !> there, stops: its status is driven_left, angle and rate are NaN. The others go on.
   pure subroutine driven_steps(scheme, pendulum, state, first, steps, columns)
      !> Method and steps to a period
      type(driven_scheme), intent(in) :: scheme
      !> Constants of each member
      type(driven_pendulum), intent(in) :: pendulum(:)
      !> Their states, before and after; as many
      type(driven_state), intent(inout) :: state(:)
      !> Steps since t = 0, whole periods left out or not
      integer, intent(in) :: first
      !> Steps to be made; with 0 and less, none
      integer, intent(in) :: steps
      !> Tangent vectors: (angle and rate, 1 or 2 of them, members)
      real(wp), intent(inout), optional :: columns(:, :, :)
      type(lanes) :: x
      integer :: i, last, tangents

      tangents = 0
      if (present(columns)) tangents = min(size(columns, 2), 2)
      do i = 1, size(state), block
         last = min(i + block - 1, size(state))
         call load(scheme, pendulum(i:last), state(i:last), x)
         if (present(columns)) call load_columns(columns(:, :, i:last), x)
         call make_steps(scheme, first, steps, tangents, x)
         call store(x, state(i:last))
         if (present(columns)) call store_columns(x, columns(:, :, i:last))
      end do
   end subroutine driven_steps


   !> Take members whole periods of their drives further, from section to section, as [[driven_steps]] does.
   !> With OpenMP, threads share the members; the results do not depend on how many there are.
   subroutine driven_periods(scheme, pendulum, state, periods, columns)
      !> Method and steps to a period
      type(driven_scheme), intent(in) :: scheme
      !> Constants of each member
      type(driven_pendulum), intent(in) :: pendulum(:)
      !> Their states, before and after; as many
      type(driven_state), intent(inout) :: state(:)
      !> Periods to go; with 0 and less, none
      integer, intent(in) :: periods
      !> Tangent vectors: (angle and rate, 1 or 2 of them, members)
      real(wp), intent(inout), optional :: columns(:, :, :)
      integer :: i, last, j

      !$omp parallel do private(last, j) schedule(dynamic)
      do i = 1, size(state), block
         last = min(i + block - 1, size(state))
         do j = 1, periods
            if (present(columns)) then
               call driven_steps(scheme, pendulum(i:last), state(i:last), 0, scheme%steps, columns(:, &
                  :, i:last))
            else
               call driven_steps(scheme, pendulum(i:last), state(i:last), 0, scheme%steps)
            end if
         end do
      end do
      !$omp end parallel do
   end subroutine driven_periods


   !> Change one constant of a member, as a sweep does
   elemental subroutine driven_set(pendulum, which, value)
      type(driven_pendulum), intent(inout) :: pendulum
      !> driven_damping ... driven_phase; nothing is changed for another number
      integer, intent(in) :: which
      real(wp), intent(in) :: value

      select case (which)
      case (driven_damping)
         pendulum%damping = value
      case (driven_quadratic)
         pendulum%quadratic = value
      case (driven_torque)
         pendulum%torque = value
      case (driven_amplitude)
         pendulum%amplitude = value
      case (driven_frequency)
         pendulum%frequency = value
      case (driven_phase)
         pendulum%phase = value
      case default
         return
      end select
   end subroutine driven_set


   !> One constant of a member; NaN where there is none of that number
   elemental function driven_get(pendulum, which) result(value)
      type(driven_pendulum), intent(in) :: pendulum
      !> driven_damping ... driven_phase
      integer, intent(in) :: which
      real(wp) :: value

      associate (p => pendulum)
         value = nan
         if (which < 1 .or. which > 6) return
         associate (all => [p%damping, p%quadratic, p%torque, p%amplitude, p%frequency, p%phase])
            value = all(which)
         end associate
      end associate
   end function driven_get


   !> Whether two states are within a tolerance, in angle (but for whole turns) and rate together
   elemental function driven_is_near(a, b, tolerance) result(near)
      type(driven_state), intent(in) :: a
      type(driven_state), intent(in) :: b
      real(wp), intent(in) :: tolerance
      logical :: near
      real(wp) :: apart

      near = a%status == driven_ran .and. b%status == driven_ran
      if (.not. near) return
      apart = abs(a%angle - b%angle)
      near = min(apart, abs(2*acos(-1.0_wp) - apart)) + abs(a%rate - b%rate) <= tolerance
   end function driven_is_near


   !> A block of members, in units of a step; who cannot go, and who is not there to fill it up, rests.
   pure subroutine load(scheme, pendulum, state, x)
      type(driven_scheme), intent(in) :: scheme
      type(driven_pendulum), intent(in) :: pendulum(:)
      type(driven_state), intent(in) :: state(:)
      type(lanes), intent(out) :: x
      integer :: i

      x = resting()
      do i = 1, size(state)
         x%turns(i) = real(state(i)%turns, wp)
         if (.not. is_usable(pendulum(i), state(i))) cycle
         x%left(i) = .false.
         associate (p => pendulum(i), h => x%h(i))
            h = 2.0_wp*acos(-1.0_wp)/(real(scheme%steps, wp)*p%frequency)
            x%gravity(i) = h**2
            x%linear(i) = h*p%damping
            x%quadratic(i) = p%quadratic
            x%torque(i) = h**2*p%torque
            x%even(i) = h**2*p%amplitude*cos(p%phase)
            x%odd(i) = -h**2*p%amplitude*sin(p%phase)
            x%angle(i, 0) = state(i)%angle
            x%rate(i, 0) = h*state(i)%rate
         end associate
      end do
   end subroutine load


   !> Members without weight, at rest
   pure function resting() result(x)
      type(lanes) :: x

      x%angle = 0.0_wp
      x%rate = 0.0_wp
      x%turns = 0.0_wp
      x%h = 1.0_wp
      x%gravity = 0.0_wp
      x%linear = 0.0_wp
      x%quadratic = 0.0_wp
      x%torque = 0.0_wp
      x%even = 0.0_wp
      x%odd = 0.0_wp
      x%left = .true.
   end function resting


   !> Whether a member can go
   elemental function is_usable(p, s) result(usable)
      type(driven_pendulum), intent(in) :: p
      type(driven_state), intent(in) :: s
      logical :: usable

      usable = s%status == driven_ran .and. is_within(p%damping, far) .and. is_within(p%quadratic, &
         far) .and. &
         is_within(p%torque, far) .and. is_within(p%amplitude, far) .and. is_within(p%phase, far) .and. &
         is_within(p%frequency, far) .and. is_within(s%angle, far) .and. is_within(s%rate, far)
      if (usable) usable = p%frequency > 1.0_wp/far
   end function is_usable


   pure subroutine load_columns(columns, x)
      real(wp), intent(in) :: columns(:, :, :)
      type(lanes), intent(inout) :: x
      integer :: i, j

      do i = 1, size(columns, 3)
         do j = 1, min(size(columns, 2), 2)
            x%angle(i, j) = columns(1, j, i)
            x%rate(i, j) = x%h(i)*columns(2, j, i)
         end do
      end do
   end subroutine load_columns


   pure subroutine store(x, state)
      type(lanes), intent(in) :: x
      type(driven_state), intent(inout) :: state(:)
      integer :: i

      do i = 1, size(state)
         if (x%left(i)) then
            state(i) = driven_state(nan, nan, state(i)%turns, driven_left)
         else
            state(i) = driven_state(x%angle(i, 0), x%rate(i, 0)/x%h(i), nint(x%turns(i), int64), driven_ran)
         end if
      end do
   end subroutine store


   pure subroutine store_columns(x, columns)
      type(lanes), intent(in) :: x
      real(wp), intent(inout) :: columns(:, :, :)
      integer :: i, j

      do i = 1, size(columns, 3)
         do j = 1, min(size(columns, 2), 2)
            columns(1, j, i) = x%angle(i, j)
            columns(2, j, i) = x%rate(i, j)/x%h(i)
         end do
      end do
   end subroutine store_columns


   !> Steps of a block
   pure subroutine make_steps(scheme, first, steps, tangents, x)
      type(driven_scheme), intent(in) :: scheme
      integer, intent(in) :: first
      integer, intent(in) :: steps
      integer, intent(in) :: tangents
      type(lanes), intent(inout) :: x
      integer :: at, done

      at = modulo(first, scheme%steps)
      do done = 1, steps
         call step(scheme%stages, scheme%wave(:, :, at), tangents, x)
         at = at + 1
         if (at == scheme%steps .or. done == steps) call turn_back(x)
         if (at == scheme%steps) at = 0
      end do
   end subroutine make_steps


   !> A step of a block; k(:, i, j) are the accelerations of the stage i, of the members themselves (j = 0)
   !> and of their tangent vectors
   pure subroutine step(stages, wave, tangents, x)
      integer, intent(in) :: stages
      real(wp), intent(in) :: wave(2, stages)
      integer, intent(in) :: tangents
      type(lanes), intent(inout) :: x
      real(wp) :: k(block, most_stages, 0:2)
      real(wp), dimension(block, 0:2) :: angle, rate
      integer :: i, j

      call slopes(x, wave(:, 1), tangents, x%angle, x%rate, 1, k)
      do i = 2, stages
         do j = 0, tangents
            if (stages == most_stages) then
               call reach_order8(i, x%angle(:, j), x%rate(:, j), k(:, :, j), angle(:, j), rate(:, j))
            else
               call reach_rk4(i, x%angle(:, j), x%rate(:, j), k(:, :, j), angle(:, j), rate(:, j))
            end if
         end do
         call slopes(x, wave(:, i), tangents, angle, rate, i, k)
      end do
      do j = 0, tangents
         if (stages == most_stages) then
            call finish_order8(k(:, :, j), x%angle(:, j), x%rate(:, j))
         else
            call finish_rk4(k(:, :, j), x%angle(:, j), x%rate(:, j))
         end if
      end do
   end subroutine step


   !> The accelerations of a stage, of the members and of their tangent vectors
   pure subroutine slopes(x, wave, tangents, angle, rate, i, k)
      type(lanes), intent(in) :: x
      real(wp), intent(in) :: wave(2)
      integer, intent(in) :: tangents
      real(wp), intent(in) :: angle(block, 0:2)
      real(wp), intent(in) :: rate(block, 0:2)
      integer, intent(in) :: i
      real(wp), intent(inout) :: k(block, most_stages, 0:2)
      real(wp), dimension(block) :: stiffness, drag
      integer :: j

      if (tangents == 0) then
         call accelerate(x, wave, angle(:, 0), rate(:, 0), k(:, i, 0))
      else
         call differentiate(x, wave, angle(:, 0), rate(:, 0), k(:, i, 0), stiffness, drag)
      end if
      do j = 1, tangents
         k(:, i, j) = stiffness*angle(:, j) + drag*rate(:, j)
      end do
   end subroutine slopes


   !> The accelerations where a stage is; the phase of the drive has this cosine and sine.
   pure subroutine accelerate(x, wave, position, rate, k)
      type(lanes), intent(in) :: x
      real(wp), intent(in) :: wave(2)
      real(wp), intent(in) :: position(block)
      real(wp), intent(in) :: rate(block)
      real(wp), intent(out) :: k(block)
      real(wp) :: r
      integer(ip) :: flip
      integer :: i

      do i = 1, block
         call reduce(position(i), r, flip)
         k(i) = ((x%torque(i) + x%even(i)*wave(1)) + x%odd(i)*wave(2)) &
            - (x%linear(i) + x%quadratic(i)*abs(rate(i)))*rate(i) &
            - real_of(ieor(bits_of(x%gravity(i)), flip))*(r + r*((r*r)*sine_quotient(r*r)))
      end do
   end subroutine accelerate


   !> The same, and their derivatives by angle and rate
   pure subroutine differentiate(x, wave, position, rate, k, stiffness, drag)
      type(lanes), intent(in) :: x
      real(wp), intent(in) :: wave(2)
      real(wp), intent(in) :: position(block)
      real(wp), intent(in) :: rate(block)
      real(wp), intent(out) :: k(block)
      real(wp), intent(out) :: stiffness(block)
      real(wp), intent(out) :: drag(block)
      real(wp) :: gravity, r
      integer(ip) :: flip
      integer :: i

      do i = 1, block
         call reduce(position(i), r, flip)
         gravity = real_of(ieor(bits_of(x%gravity(i)), flip))
         k(i) = ((x%torque(i) + x%even(i)*wave(1)) + x%odd(i)*wave(2)) &
            - (x%linear(i) + x%quadratic(i)*abs(rate(i)))*rate(i) &
            - gravity*(r + r*((r*r)*sine_quotient(r*r)))
         stiffness(i) = -gravity*(1.0_wp + (r*r)*cosine_quotient(r*r))
         drag(i) = -(x%linear(i) + 2.0_wp*x%quadratic(i)*abs(rate(i)))
      end do
   end subroutine differentiate


   !> x = r + n pi with abs(r) <= pi/2, and the bit that changes a sign where n is odd. n is rounded by adding
   !> a number whose last place is 1 (see `nearest_whole`), and its last bit moved to that of the sign.
   elemental subroutine reduce(x, r, flip)
      real(wp), intent(in) :: x
      real(wp), intent(out) :: r
      integer(ip), intent(out) :: flip
      real(wp), parameter :: unit = 2.0_wp**(digits(1.0_wp) - 1), whole = 1.5_wp*unit
      real(wp) :: n
      integer(ip) :: held

      held = ior(bits_of(x*(1.0_wp/acos(-1.0_wp)) + whole), iand(bits_of(unit), -bits_of(unit)))
      n = real_of(held) - whole
      r = (x - n*pi(1)) - n*pi(2)
      flip = shiftl(held, bit_size(1_ip) - 1)
   end subroutine reduce


   !> Whole turns of the angle go to their count. Who has left the range rests from here on.
   pure subroutine turn_back(x)
      type(lanes), intent(inout) :: x
      real(wp) :: n
      integer :: i

      do i = 1, block
         if (.not. (is_within(x%angle(i, 0), far) .and. is_within(x%rate(i, 0), far))) then
            x%left(i) = .true.
            x%angle(i, 0) = 0.0_wp
            x%rate(i, 0) = 0.0_wp
            x%gravity(i) = 0.0_wp
            x%linear(i) = 0.0_wp
            x%quadratic(i) = 0.0_wp
            x%torque(i) = 0.0_wp
            x%even(i) = 0.0_wp
            x%odd(i) = 0.0_wp
         end if
         n = nearest_whole(x%angle(i, 0)*(0.5_wp/acos(-1.0_wp)))
         x%angle(i, 0) = (x%angle(i, 0) - 2.0_wp*n*pi(1)) - 2.0_wp*n*pi(2)
         x%turns(i) = x%turns(i) + n
      end do
   end subroutine turn_back


   include 'furiko_driven_stages.inc'
   include 'furiko_driven_cosine_dp.inc'
   include '../integrators/furiko_pendulum_sine_dp.inc'
#include "../arithmetic/furiko_bits.inc"
   include '../arithmetic/furiko_is_within.inc'
   include '../arithmetic/furiko_nearest_whole.inc'
end module furiko_driven_steps
! rooms: 2794324495
