! SPDX-License-Identifier: MIT
#include "../arithmetic/furiko_compiler.inc"

!> Where driven pendulums end: attractors, basins of attraction, and how uncertain they are.
module furiko_driven_basins
   use, intrinsic :: iso_fortran_env, only : int64, wp => real64
   use furiko_driven_cycles, only : driven_cycle, driven_round
   use furiko_driven_rotation, only : driven_locking
   use furiko_driven_scheme, only : driven_scheme
   use furiko_driven_steps, only : driven_block, driven_is_near, driven_pendulum, driven_periods, &
      driven_ran, &
      driven_state, driven_steps
   implicit none
   private
   public :: driven_attractors, driven_basins, driven_uncertainty


   !> Starts of [[driven_basins]] that a thread takes at a time
   integer, parameter :: company = 4*driven_block


contains


   !> The stable cycles that some starts come to, made exact by Newton's method, each once; the shortest
   !> first, and of equal ones that which the earlier start came to. The points of the section stand one
   !> after another: those of attractor j are the `points` whose `label` is j, in the order in which they
   !> follow each other, and their `turns` are those of one cycle.
   !>
   !> A member that has not come to a cycle of up to `longest` periods by then (a chaotic one, a long
   !> transient) says nothing.
   subroutine driven_attractors(scheme, pendulum, state, transient, longest, points, label, found)
      !> Method and steps to a period
      type(driven_scheme), intent(in) :: scheme
      !> Constants of all
      type(driven_pendulum), intent(in) :: pendulum
      !> Starts, and where they have come to
      type(driven_state), intent(inout) :: state(:)
      !> Periods to go first
      integer, intent(in) :: transient
      !> The longest period that is looked for
      integer, intent(in) :: longest
      !> Points of the attractors; those that find no room are left out
      type(driven_state), intent(out) :: points(:)
      !> The attractor of each point, or 0 behind the last one
      integer, intent(out) :: label(:)
      !> How many attractors there are
      integer, intent(out) :: found
      type(driven_pendulum) :: same(size(state))
      type(driven_state) :: cycle(longest)
      integer(int64) :: turns(size(state))
      integer :: period(size(state)), i, n, used
      logical :: new

      same = pendulum
      label = 0
      found = 0
      used = 0
      call driven_periods(scheme, same, state, transient)
      call driven_locking(scheme, same, state, longest, 1.0e-6_wp, period, turns)
      do n = 1, longest
         do i = 1, size(state)
            if (period(i) /= n .or. used + n > size(points)) cycle
            if (any(driven_is_near(points(:used), state(i), 1.0e-4_wp))) cycle
            call follow(scheme, pendulum, state(i), cycle(:n), new)
            if (.not. new) cycle
            found = found + 1
            points(used + 1:used + n) = cycle(:n)
            label(used + 1:used + n) = found
            used = used + n
         end do
      end do
   end subroutine driven_attractors


   !> The stable cycle that begins next to a state, its lowest angle first
   pure subroutine follow(scheme, pendulum, state, cycle, good)
      type(driven_scheme), intent(in) :: scheme
      type(driven_pendulum), intent(in) :: pendulum
      type(driven_state), intent(in) :: state
      type(driven_state), intent(out) :: cycle(:)
      logical, intent(out) :: good
      type(driven_round) :: round
      integer :: i

      cycle(1) = state
      do i = 2, size(cycle)
         cycle(i) = cycle(i - 1)
         call driven_steps(scheme, [pendulum], cycle(i:i), 0, scheme%steps)
      end do
      call driven_cycle(scheme, pendulum, cycle, round, good)
      if (good) good = maxval(abs(round%multipliers)) < 1.0_wp
      cycle%turns = round%turns
      cycle = cshift(cycle, minloc(cycle%angle, 1) - 1)
   end subroutine follow


   !> Which attractor each start comes to, and when: it has come when it is within the tolerance of a point of
   !> one, in angle and rate together, at the end of a period.
   !>
   !> Of the label of a start that wanders for long before it comes, real64 decides and not the equation: what
   !> errs by 1e-16 at first errs by 1 after some forty periods of an exponent of 0.15, and another build may
   !> say another label. So the time is kept with the label: early ones can be relied on, the rest by numbers.
   !> Threads share the members; the results do not depend on how many there are.
   subroutine driven_basins(scheme, pendulum, state, points, label, tolerance, periods, basin, arrival)
      !> Method and steps to a period
      type(driven_scheme), intent(in) :: scheme
      !> Constants of all
      type(driven_pendulum), intent(in) :: pendulum
      !> Starts, and where they are when they have come
      type(driven_state), intent(inout) :: state(:)
      !> Points of the attractors, as of [[driven_attractors]]
      type(driven_state), intent(in) :: points(:)
      !> The attractor of each, from 1 on; points of label 0 are no attractor's
      integer, intent(in) :: label(:)
      !> How near is near
      real(wp), intent(in) :: tolerance
      !> The longest time that is waited
      integer, intent(in) :: periods
      !> The attractor of each start; 0 for one that has come to none
      integer, intent(out) :: basin(:)
      !> The period at whose end it had come, 0 for the start itself; -1 for none
      integer, intent(out) :: arrival(:)
      integer :: i, last

      !$omp parallel do private(last) schedule(dynamic)
      do i = 1, size(state), company
         last = min(i + company - 1, size(state))
         call settle(scheme, pendulum, state(i:last), points, label, tolerance, periods, basin(i:last), &
            arrival(i:last))
      end do
      !$omp end parallel do
   end subroutine driven_basins


   !> Starts that go side by side. Who has come makes room: the last of them would hold up all others of a
   !> block, which takes twice as long where transients are long.
   pure subroutine settle(scheme, pendulum, state, points, label, tolerance, periods, basin, arrival)
      type(driven_scheme), intent(in) :: scheme
      type(driven_pendulum), intent(in) :: pendulum
      type(driven_state), intent(inout) :: state(:)
      type(driven_state), intent(in) :: points(:)
      integer, intent(in) :: label(:)
      real(wp), intent(in) :: tolerance
      integer, intent(in) :: periods
      integer, intent(out) :: basin(:)
      integer, intent(out) :: arrival(:)
      type(driven_pendulum) :: same(company)
      type(driven_state) :: going(company)
      !> Which of the starts each of those is that still go, and where it has come
      integer :: which(company), come(company)
      integer :: i, j, n

      same = pendulum
      basin = 0
      arrival = -1
      n = size(state)
      going(:n) = state
      which(:n) = [(j, j=1, n)]
      do i = 0, periods
         if (i > 0) call driven_steps(scheme, same(:n), going(:n), 0, scheme%steps)
         come(:n) = 0
         do j = 1, size(points)
            where (come(:n) == 0 .and. driven_is_near(going(:n), points(j), tolerance)) come(:n) = label(j)
         end do
         state(which(:n)) = going(:n)
         basin(which(:n)) = come(:n)
         where (come(:n) /= 0) arrival(which(:n)) = i
         call leave(come(:n) /= 0 .or. going(:n)%status /= driven_ran, going, which, n)
         if (n == 0) exit
      end do
   end subroutine settle


   !> Some leave; those behind them close up.
   pure subroutine leave(leaves, going, which, n)
      logical, intent(in) :: leaves(:)
      type(driven_state), intent(inout) :: going(:)
      integer, intent(inout) :: which(:)
      integer, intent(out) :: n
      integer :: i

      n = 0
      do i = 1, size(leaves)
         if (leaves(i)) cycle
         n = n + 1
         going(n) = going(i)
         which(n) = which(i)
      end do
   end subroutine leave


   !> The part of starts whose end is uncertain where their angle is known to +-epsilon: one or both of the
   !> starts at that distance come to another attractor. It goes as epsilon^alpha, alpha the uncertainty
   !> exponent, and the boundary of the basins has the dimension D = 2 - alpha. A start is not counted where
   !> one of the three has come nowhere.
   !> Source: McDonald, Grebogi, Ott, Yorke, Physica D 17 (1985) 125.
   subroutine driven_uncertainty(scheme, pendulum, start, points, label, tolerance, periods, epsilons, &
      uncertain, &
         exponent, error)
      !> Method and steps to a period
      type(driven_scheme), intent(in) :: scheme
      !> Constants of all
      type(driven_pendulum), intent(in) :: pendulum
      !> Starts, all over the plane
      type(driven_state), intent(in) :: start(:)
      !> As of [[driven_basins]]
      type(driven_state), intent(in) :: points(:)
      integer, intent(in) :: label(:)
      real(wp), intent(in) :: tolerance
      integer, intent(in) :: periods
      !> Half distances, two or more of them
      real(wp), intent(in) :: epsilons(:)
      !> The uncertain part at each
      real(wp), intent(out) :: uncertain(:)
      !> alpha, by least squares of the logarithms, each with the weight of its counting error
      real(wp), intent(out) :: exponent
      !> Its standard error, by counting
      real(wp), intent(out) :: error
      type(driven_state) :: state(size(start))
      integer, dimension(size(start)) :: middle, left, right, when
      real(wp) :: weight(size(epsilons)), x(size(epsilons))
      integer :: i, counted

      state = start
      call driven_basins(scheme, pendulum, state, points, label, tolerance, periods, middle, when)
      do i = 1, size(epsilons)
         state = start
         state%angle = start%angle - epsilons(i)
         call driven_basins(scheme, pendulum, state, points, label, tolerance, periods, left, when)
         state = start
         state%angle = start%angle + epsilons(i)
         call driven_basins(scheme, pendulum, state, points, label, tolerance, periods, right, when)
         associate (come => middle > 0 .and. left > 0 .and. right > 0)
            counted = max(count(come), 1)
            uncertain(i) = count(come .and. (left /= middle .or. right /= middle))/real(counted, wp)
         end associate
         ! The variance of ln f is (1 - f)/(n f); a part of 0 or 1 has no weight that means anything.
         weight(i) = counted*uncertain(i)/max(1.0_wp - uncertain(i), 1.0_wp/counted)
      end do
      x = log(epsilons)
      x = x - sum(weight*x)/sum(weight)
      exponent = sum(weight*x*log(max(uncertain, tiny(1.0_wp))))/sum(weight*x**2)
      error = 1/sqrt(sum(weight*x**2))
   end subroutine driven_uncertainty
end module furiko_driven_basins
! rooms: 3759241635
