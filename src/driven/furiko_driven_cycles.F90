! SPDX-License-Identifier: MIT
#include "../arithmetic/furiko_compiler.inc"

!> Cycles of the driven pendulum on its section, their multipliers, and where they double their period.
module furiko_driven_cycles
   use, intrinsic :: iso_fortran_env, only : int64, wp => real64
   use furiko_driven_scheme, only : driven_scheme
   use furiko_driven_steps, only : driven_get, driven_pendulum, driven_ran, driven_set, driven_state, &
      driven_steps
   implicit none
   private
   public :: driven_cycle, driven_doubling, driven_cascade, driven_round


   !> What once round a cycle does
   type :: driven_round
      !> The tangent map, in (angle, rate)
      real(wp) :: map(2, 2)
      !> Its determinant, as the product of those of the single periods, which keeps its digits: exp(-b n T)
      !> where there is no quadratic damping
      real(wp) :: area
      !> Its eigenvalues, the larger one first: the cycle is stable where both are below 1 in size
      complex(wp) :: multipliers(2)
      !> Whole turns of the angle
      integer(int64) :: turns
   end type driven_round


   ! A place on a branch of cycles
   type :: place
      !> The constant that is moved
      real(wp) :: value
      !> 1 + trace + determinant = (1 + multiplier 1)(1 + multiplier 2) of the tangent map
      real(wp) :: f
      type(driven_state), allocatable :: points(:)
   end type place


contains


   !> A cycle of n periods by Newton's method, stable or not: the n points of the section that the strobe
   !> map takes each to the next, and the last one to the first up to whole turns.
   !>
   !> All points are found together (multiple shooting), as n members that go one period each: rounding
   !> does not grow along the cycle, whatever n is.
   !>
   !> With `half`, the map is half a period, seen in the mirror: (angle, rate) at t to (-angle, -rate) at
   !> t + T/2. Without a torque it maps solutions to solutions, and its fixed points are the orbits that
   !> are symmetric; the scheme's steps have to be even.
   !>
   !> The result is good to some 1e-15/abs(1 - multiplier), and to what the scheme's steps leave.
   pure subroutine driven_cycle(scheme, pendulum, points, round, found, half)
      !> Method and steps to a period
      type(driven_scheme), intent(in) :: scheme
      !> Constants
      type(driven_pendulum), intent(in) :: pendulum
      !> A guess, and the cycle; as many as its periods
      type(driven_state), intent(inout) :: points(:)
      !> What once round it does
      type(driven_round), intent(out) :: round
      !> Whether corrections became small; else nothing of the result is of use
      logical, intent(out) :: found
      !> Half a period, mirrored, instead of a period
      logical, intent(in), optional :: half
      ! Newton's corrections square: one below this leaves none. The largest step that is made at once
      real(wp), parameter :: small = 1.0e-9_wp, largest = 0.5_wp
      integer, parameter :: most = 40
      real(wp) :: maps(2, 2, size(points)), rest(2, size(points)), size_of
      integer :: i

      size_of = huge(size_of)
      do i = 1, most
         call shoot(scheme, pendulum, points, maps, rest, round%turns, half)
         call go_round(maps, round)
         found = size_of < small
         if (found .or. .not. all(points%status == driven_ran)) return
         call correct(maps, round%map, rest)
         size_of = maxval(abs(rest))
         if (size_of > largest) rest = rest*(largest/size_of)
         points%angle = points%angle + rest(1, :)
         points%rate = points%rate + rest(2, :)
      end do
      found = .false.
   end subroutine driven_cycle


   !> The tangent maps of all periods as one
   pure subroutine go_round(maps, round)
      real(wp), intent(in) :: maps(:, :, :)
      type(driven_round), intent(inout) :: round
      real(wp) :: mean, square, root
      integer :: i

      round%map = maps(:, :, 1)
      round%area = determinant(maps(:, :, 1))
      do i = 2, size(maps, 3)
         round%map = matmul(maps(:, :, i), round%map)
         round%area = round%area*determinant(maps(:, :, i))
      end do
      mean = 0.5_wp*(round%map(1, 1) + round%map(2, 2))
      square = (0.5_wp*(round%map(1, 1) - round%map(2, 2)))**2 + round%map(1, 2)*round%map(2, 1)
      if (square < 0.0_wp) then
         round%multipliers = [cmplx(mean, sqrt(-square), wp), cmplx(mean, -sqrt(-square), wp)]
      else
         ! The smaller one from the product, where a difference would lose it
         root = mean + sign(sqrt(square), mean)
         round%multipliers = [cmplx(root, 0.0_wp, wp), cmplx(0.0_wp, 0.0_wp, wp)]
         if (abs(root) > 0.0_wp) round%multipliers(2) = cmplx(round%area/root, 0.0_wp, wp)
      end if
   end subroutine go_round


   pure function determinant(map) result(area)
      real(wp), intent(in) :: map(2, 2)
      real(wp) :: area

      area = map(1, 1)*map(2, 2) - map(1, 2)*map(2, 1)
   end function determinant


   !> Where a cycle doubles its period: one of the constants is moved until a multiplier is -1, first in
   !> steps along the branch, then by false position. With `half`, see [[driven_cycle]], this is where a
   !> symmetric orbit loses its symmetry.
   pure subroutine driven_doubling(scheme, pendulum, which, step, points, round, found, half)
      !> Method and steps to a period
      type(driven_scheme), intent(in) :: scheme
      !> Constants, those of the start and those where the period doubles
      type(driven_pendulum), intent(inout) :: pendulum
      !> The constant to move: driven_amplitude, ...
      integer, intent(in) :: which
      !> First step of it; its sign is the direction
      real(wp), intent(in) :: step
      !> The cycle at the start (a guess will do), and where its period doubles
      type(driven_state), intent(inout) :: points(:)
      !> What once round it does
      type(driven_round), intent(out) :: round
      !> Whether a multiplier of -1 has been found
      logical, intent(out) :: found
      !> Half a period, mirrored, instead of a period
      logical, intent(in), optional :: half
      integer, parameter :: most = 200
      type(place) :: a, b, c
      real(wp) :: h
      integer :: i

      h = step
      b = place(driven_get(pendulum, which), 0.0_wp, points)
      call go_to(scheme, pendulum, which, b, b, b%value, c, round, found, half)
      found = found .and. c%f > 0.0_wp
      if (.not. found) return
      b = c
      do i = 1, most
         if (b%f < 0.0_wp .or. abs(h) < 1.0e-12_wp*abs(b%value)) exit
         if (i == 1) a = b
         call go_to(scheme, pendulum, which, a, b, b%value + h, c, round, found, half)
         if (found .and. distance(c%points, b%points) < 0.5_wp) then
            a = b
            b = c
            h = 1.5_wp*h
         else
            h = 0.25_wp*h
         end if
      end do
      found = b%f < 0.0_wp
      if (found) call close_in(scheme, pendulum, which, a, b, round, found, half)
      points = b%points
      call driven_set(pendulum, which, b%value)
   end subroutine driven_doubling


   !> The bracket of a and b, on both sides of f = 0, closed by false position; an end that stays has its
   !> value halved (Illinois). The last place is in b.
   pure subroutine close_in(scheme, pendulum, which, a, b, round, found, half)
      type(driven_scheme), intent(in) :: scheme
      type(driven_pendulum), intent(inout) :: pendulum
      integer, intent(in) :: which
      type(place), intent(inout) :: a
      type(place), intent(inout) :: b
      type(driven_round), intent(out) :: round
      logical, intent(out) :: found
      logical, intent(in), optional :: half
      integer, parameter :: most = 60
      type(place) :: c
      integer :: i

      do i = 1, most
         call go_to(scheme, pendulum, which, a, b, b%value - b%f*((b%value - a%value)/(b%f - a%f)), c, &
            round, found, half)
         if (.not. found) return
         if (c%f > 0.0_wp .neqv. b%f > 0.0_wp) then
            a = b
         else
            a%f = 0.5_wp*a%f
         end if
         b = c
         if (abs(c%f) < 1.0e-13_wp .or. abs(a%value - b%value) <= 2*epsilon(1.0_wp)*abs(b%value)) return
      end do
   end subroutine close_in


   !> The cycle at another value, guessed on the line through those at two places
   pure subroutine go_to(scheme, pendulum, which, a, b, value, c, round, found, half)
      type(driven_scheme), intent(in) :: scheme
      type(driven_pendulum), intent(inout) :: pendulum
      integer, intent(in) :: which
      type(place), intent(in) :: a
      type(place), intent(in) :: b
      real(wp), intent(in) :: value
      type(place), intent(out) :: c
      type(driven_round), intent(out) :: round
      logical, intent(out) :: found
      logical, intent(in), optional :: half
      real(wp) :: part

      part = 0.0_wp
      if (abs(b%value - a%value) > 0.0_wp) part = (value - b%value)/(b%value - a%value)
      c = place(value, 0.0_wp, b%points)
      c%points%angle = b%points%angle + part*near_zero(b%points%angle - a%points%angle)
      c%points%rate = b%points%rate + part*(b%points%rate - a%points%rate)
      call driven_set(pendulum, which, value)
      call driven_cycle(scheme, pendulum, c%points, round, found, half)
      c%f = 1.0_wp + (round%map(1, 1) + round%map(2, 2)) + round%area
   end subroutine go_to


   !> A cascade of period doublings, from a cycle onwards: where it doubles, where the doubled one does, ...
   !> The ratios of the gaps tend to Feigenbaum's 4.6692; after the first two, they say where to look.
   pure subroutine driven_cascade(scheme, pendulum, which, step, points, thresholds, found)
      !> Method and steps to a period
      type(driven_scheme), intent(in) :: scheme
      !> Constants of the start; only one of them is moved
      type(driven_pendulum), intent(in) :: pendulum
      !> The constant to move: driven_amplitude, ...
      integer, intent(in) :: which
      !> First step of it; its sign is the direction
      real(wp), intent(in) :: step
      !> The cycle at the start, or a guess
      type(driven_state), intent(in) :: points(:)
      !> Its values where the periods double
      real(wp), intent(out) :: thresholds(:)
      !> How many of them have been found
      integer, intent(out) :: found
      type(driven_state) :: cycle(size(points)*2**max(size(thresholds) - 1, 0))
      type(driven_pendulum) :: p
      type(driven_round) :: round
      real(wp) :: gap, before
      integer :: i, n
      logical :: good

      p = pendulum
      n = size(points)
      cycle(:n) = points
      gap = 4.0_wp*step
      before = driven_get(p, which)
      good = .true.
      found = 0
      do i = 1, size(thresholds)
         if (i > 1) call double_cycle(scheme, p, which, before + 0.3_wp*gap, round%map, n, cycle, good)
         if (.not. good) return
         call driven_doubling(scheme, p, which, 0.25_wp*gap, cycle(:n), round, good)
         if (.not. good) return
         thresholds(i) = driven_get(p, which)
         if (i > 1) gap = (thresholds(i) - before)/4.669_wp
         before = thresholds(i)
         found = i
      end do
   end subroutine driven_cascade


   !> The cycle of twice the period behind a doubling: the points moved to both sides along the vector that
   !> the map turns round, by so much that Newton's method finds another cycle than the one that was
   pure subroutine double_cycle(scheme, pendulum, which, value, map, n, cycle, good)
      type(driven_scheme), intent(in) :: scheme
      type(driven_pendulum), intent(inout) :: pendulum
      integer, intent(in) :: which
      real(wp), intent(in) :: value
      real(wp), intent(in) :: map(2, 2)
      integer, intent(inout) :: n
      type(driven_state), intent(inout) :: cycle(:)
      logical, intent(out) :: good
      type(driven_state) :: both(2*n)
      real(wp) :: maps(2, 2, n), rest(2, n), along(2, n), s
      type(driven_round) :: twice
      integer(int64) :: turns
      integer :: i

      both = [cycle(:n), cycle(:n)]
      call shoot(scheme, pendulum, both(:n), maps, rest, turns)
      along(:, 1) = [map(1, 2), -1.0_wp - map(1, 1)]
      along(:, 1) = along(:, 1)/norm2(along(:, 1))
      do i = 2, n
         along(:, i) = matmul(maps(:, :, i - 1), along(:, i - 1))
      end do
      along = along/maxval(abs(along))
      call driven_set(pendulum, which, value)
      s = 0.5_wp
      do i = 1, 40
         s = 0.75_wp*s
         both%angle = [cycle(:n)%angle + s*along(1, :), cycle(:n)%angle - s*along(1, :)]
         both%rate = [cycle(:n)%rate + s*along(2, :), cycle(:n)%rate - s*along(2, :)]
         both%status = driven_ran
         call driven_cycle(scheme, pendulum, both, twice, good)
         if (good) good = distance(both(:n), both(n + 1:)) > 1.0e-5_wp .and. distance(both(:n), &
            cycle(:n)) < 0.5_wp
         if (good) exit
      end do
      n = 2*n
      if (good) cycle(:n) = both
   end subroutine double_cycle


   !> The largest difference of angles and rates
   pure function distance(these, those) result(d)
      type(driven_state), intent(in) :: these(:)
      type(driven_state), intent(in) :: those(:)
      real(wp) :: d

      d = max(maxval(abs(near_zero(these%angle - those%angle))), maxval(abs(these%rate - those%rate)))
   end function distance


   !> Each point a period on, or half a one mirrored: the tangent maps, and by how much each end misses the
   !> next point. The points' angles are brought to [-pi, pi].
   pure subroutine shoot(scheme, pendulum, points, maps, rest, turns, half)
      type(driven_scheme), intent(in) :: scheme
      type(driven_pendulum), intent(in) :: pendulum
      type(driven_state), intent(inout) :: points(:)
      real(wp), intent(out) :: maps(:, :, :)
      real(wp), intent(out) :: rest(:, :)
      integer(int64), intent(out) :: turns
      logical, intent(in), optional :: half
      type(driven_state) :: ends(size(points))
      type(driven_pendulum) :: same(size(points))
      logical :: mirrored
      integer :: i

      mirrored = .false.
      if (present(half)) mirrored = half
      same = pendulum
      points%angle = near_zero(points%angle)
      ends = points
      ends%turns = 0_int64
      do i = 1, size(points)
         maps(:, :, i) = reshape([1.0_wp, 0.0_wp, 0.0_wp, 1.0_wp], [2, 2])
      end do
      call driven_steps(scheme, same, ends, 0, merge(scheme%steps/2, scheme%steps, mirrored), maps)
      if (mirrored) then
         ends%angle = -ends%angle
         ends%rate = -ends%rate
         ends%turns = -ends%turns
         maps = -maps
      end if
      points%status = ends%status
      turns = sum(ends%turns)
      do i = 1, size(points)
         associate (end => ends(i), next => points(modulo(i, size(points)) + 1))
            rest(:, i) = [near_zero(end%angle - next%angle), end%rate - next%rate]
            turns = turns + nint((end%angle - next%angle - rest(1, i))/(2*acos(-1.0_wp)), int64)
         end associate
      end do
   end subroutine shoot


   !> An angle less whole turns
   elemental function near_zero(angle) result(rest)
      real(wp), intent(in) :: angle
      real(wp) :: rest
      real(wp), parameter :: turn = 2*acos(-1.0_wp)

      rest = angle - turn*anint(angle/turn)
   end function near_zero


   !> Newton's correction of all points: d(i + 1) = M(i) d(i) + rest(i), closed to a ring by d(1) = d(n + 1)
   pure subroutine correct(maps, map, rest)
      real(wp), intent(in) :: maps(:, :, :)
      real(wp), intent(in) :: map(2, 2)
      !> What is missed, and the corrections
      real(wp), intent(inout) :: rest(:, :)
      real(wp) :: d(2), next(2), a(2, 2)
      integer :: i

      d = 0.0_wp
      do i = 1, size(rest, 2)
         d = matmul(maps(:, :, i), d) + rest(:, i)
      end do
      a = reshape([1.0_wp, 0.0_wp, 0.0_wp, 1.0_wp], [2, 2]) - map
      d = [a(2, 2)*d(1) - a(1, 2)*d(2), a(1, 1)*d(2) - a(2, 1)*d(1)]/(a(1, 1)*a(2, 2) - a(1, 2)*a(2, 1))
      do i = 1, size(rest, 2)
         next = matmul(maps(:, :, i), d) + rest(:, i)
         rest(:, i) = d
         d = next
      end do
   end subroutine correct
end module furiko_driven_cycles
! rooms: 3759241635
