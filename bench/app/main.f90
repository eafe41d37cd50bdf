! SPDX-License-Identifier: MIT

!> furiko beside GSL, Boost and SciPy in one run, function by function and regime by regime of the
!> arguments: one call at a time (throughput, and latency: the first argument waits for the last result)
!> and arrays. Interleaved repeats, the least of each chunk of points, in ns a call. Prints a Markdown
!> table; `bench/run` makes doc/speed.md of it.
program main
   use, intrinsic :: iso_fortran_env, only : error_unit, int64, wp => real64
   use bench_calls, only : arrays_of, boost, call_of, can, carlson, classes, gsl, jacobi, legendre, names, &
      scipy, us
   use bench_peers, only : has_boost, has_scipy
   use bench_table, only : cell, ratio_cell
   implicit none
   integer, parameter :: chunk = 512, points = 16*chunk, repeats = 15
   !> How the library is called: its arrays, then it and its peers one call at a time
   integer, parameter :: arrays = 0
   real(wp), parameter :: half_pi = acos(-1.0_wp)/2
   character(len=*), parameter :: places(6, 4) = reshape([character(len=29) :: &
      'm uniform', '1 - m from 1e-12 to 0.1', 'm from -1 to 0', '', '', '', &
      'phi to pi/2, m uniform', 'phi < 0.7', 'phi to 30', '1 - m from 1e-12 to 0.1', &
      'next to the separatrix', 'm from -1 to 0', &
      'uniform', 'from 1e-6 to 1e6', '', '', '', '', &
      'u to 6, m uniform', 'u < 1', 'u < 100', 'u from 1e3 to 1e6', '1 - m from 1e-12 to 0.1', &
      'm from -1 to 0'], [6, 4])
   real(wp) :: r(points, 4)
   !> Arguments of furiko and SciPy, of GSL and Boost, which take k
   real(wp), target :: by_m(4, points), by_k(4, points)
   real(wp) :: throughput(arrays:scipy), latency(us:scipy), sums(arrays:scipy), wait
   logical :: there(arrays:scipy), installed(us:scipy)
   integer :: place, which, who, class

   installed = [.true., .true., has_boost(), has_scipy()]
   call random_number(r)
   wait = 0
   call print_header()
   do which = 1, size(names)
      class = classes(which)
      do place = 1, count(places(:, class) /= '')
         call set_points(classes(which), place)
         if (.not. can(which, us, by_m(2, :))) cycle
         there(arrays) = .true.
         do who = us, scipy
            there(who) = installed(who) .and. can(which, who, by_m(2, :))
         end do
         call measure(which)
         call check_sums(which, place)
         call print_row(which, place)
      end do
   end do


contains


   subroutine print_header()
      character(len=*), parameter :: peers(us:scipy) = [character(len=6) :: 'furiko', 'GSL', 'Boost', 'SciPy']
      integer :: who

      write(*, '(a)', advance='no') '| function | arguments | furiko, array |'
      do who = us, scipy
         if (installed(who)) write(*, '(4a)', advance='no') ' ', trim(peers(who)), ' | waits |'
      end do
      print '(a)', ' fastest peer / array | / furiko | waits: / furiko |'
      print '(a)', '|---|---'//repeat('|---', 4 + 2*count(installed))//'|'
   end subroutine print_header


   subroutine print_row(which, place)
      integer, intent(in) :: which, place
      real(wp) :: fastest, first
      integer :: who

      write(*, '(7a)', advance='no') '| ', names(which), ' | ', places(place, classes(which)), ' | ', &
         cell(throughput(arrays), there(arrays)), ' |'
      do who = us, scipy
         if (installed(who)) write(*, '(4a)', advance='no') cell(throughput(who), there(who)), ' |', &
            cell(latency(who), there(who)), ' |'
      end do
      fastest = minval(throughput(gsl:), there(gsl:))
      first = minval(latency(gsl:), there(gsl:))
      print '(6a)', ratio_cell(fastest/throughput(arrays), any(there(gsl:))), ' |', &
         ratio_cell(fastest/throughput(us), any(there(gsl:))), ' |', &
         ratio_cell(first/latency(us), any(there(gsl:))), ' |'
   end subroutine print_row


   !> The arguments of a class of functions in one of its regimes
   subroutine set_points(class, place)
      integer, intent(in) :: class, place
      real(wp) :: m(points)

      m = r(:, 2)
      select case (places(place, class))
      case ('1 - m from 1e-12 to 0.1', 'next to the separatrix')
         m = 1 - 10.0_wp**(-1 - 11*r(:, 2))
      case ('m from -1 to 0')
         m = -r(:, 2)
      case default
         ! uniform
      end select
      by_m = transpose(reshape([first_of(class, place), m, 0.9_wp*r(:, 3), r(:, 4)], [points, 4]))
      if (class == carlson) then
         by_m = transpose(r)
         if (place == 2) by_m = 10.0_wp**(12*by_m - 6)
      end if
      by_k = by_m
      if (class /= carlson) by_k(2, :) = sqrt(max(m, 0.0_wp))
   end subroutine set_points


   !> phi or u
   function first_of(class, place) result(x)
      integer, intent(in) :: class, place
      real(wp) :: x(points)

      x = merge(half_pi, 6.0_wp, class == legendre)*r(:, 1)
      if (place == 2) x = merge(0.7_wp, 1.0_wp, class == legendre)*r(:, 1)
      if (place == 3) x = merge(30, 100, class == legendre)*r(:, 1)
      if (place == 4 .and. class == jacobi) x = 10.0_wp**(3 + 3*r(:, 1))
      if (place == 5 .and. class == legendre) x = half_pi - 10.0_wp**(-1 - 7*r(:, 1))
   end function first_of


   !> Least times of each chunk, in all ns a call, and the sums of the values
   subroutine measure(which)
      integer, intent(in) :: which
      real(wp) :: times(points/chunk, arrays:scipy), waits(points/chunk, us:scipy), value
      integer :: j, repeat, who

      times = huge(times)
      waits = huge(waits)
      do repeat = 1, repeats
         sums = 0
         do j = 1, size(times, 1)
            do who = arrays, scipy
               if (.not. there(who)) cycle
               call time_chunk(which, who, j, times(j, who), value)
               sums(who) = sums(who) + value
               if (who /= arrays) call time_chain(which, who, j, waits(j, who))
            end do
         end do
      end do
      throughput = sum(times, 1)/points
      latency = sum(waits, 1)/points
   end subroutine measure


   !> Calls that do not wait for each other
   subroutine time_chunk(which, who, j, least, total)
      integer, intent(in) :: which, who, j
      real(wp), intent(inout) :: least
      real(wp), intent(out) :: total
      real(wp), pointer :: x(:, :)
      real(wp) :: columns(chunk, 4), values(chunk)
      integer(int64) :: start, finish, rate
      integer :: i

      x => arguments_of(which, who, j)
      total = 0
      if (who == arrays) columns = transpose(x)
      call system_clock(start, rate)
      if (who == arrays) then
         call arrays_of(which, columns(:, 1), columns(:, 2), columns(:, 3), columns(:, 4), values)
      else
         do i = 1, chunk
            total = total + call_of(which, who, x(1, i), x(2, i), x(3, i), x(4, i))
         end do
      end if
      call system_clock(finish)
      if (who == arrays) total = sum(values)
      least = min(least, real(finish - start, wp)/real(rate, wp)*1.0e9_wp)
   end subroutine time_chunk


   !> Calls whose arguments wait for the last result, of which they take 0 times (a multiplication and a
   !> sum, 2 ns, are in the time)
   subroutine time_chain(which, who, j, least)
      integer, intent(in) :: which, who, j
      real(wp), intent(inout) :: least
      real(wp), pointer :: x(:, :)
      real(wp) :: last, delay
      integer(int64) :: start, finish, rate
      integer :: i

      x => arguments_of(which, who, j)
      last = 0
      call system_clock(start, rate)
      do i = 1, chunk
         delay = wait*last
         last = call_of(which, who, x(1, i) + delay, x(2, i) + delay, x(3, i), x(4, i))
      end do
      call system_clock(finish)
      ! What came of it is looked at, and so computed
      if (last /= last) error stop 'bench: not a number'
      least = min(least, real(finish - start, wp)/real(rate, wp)*1.0e9_wp)
   end subroutine time_chain


   !> GSL and Boost take k, but for GSL's sn, cn, dn
   function arguments_of(which, who, j) result(x)
      integer, intent(in) :: which, who, j
      real(wp), pointer :: x(:, :)

      if (who == boost .or. (who == gsl .and. classes(which) /= jacobi)) then
         x => by_k(:, (j - 1)*chunk + 1:j*chunk)
      else
         x => by_m(:, (j - 1)*chunk + 1:j*chunk)
      end if
   end function arguments_of


   !> All must have computed the same, as far as the peers allow: k = sqrt(m) has few digits of 1 - m
   subroutine check_sums(which, place)
      integer, intent(in) :: which, place
      real(wp) :: allowed
      integer :: who

      do who = arrays, scipy
         if (.not. there(who)) cycle
         allowed = 1.0e-6_wp
         if ((who == gsl .or. who == boost) .and. minval(1 - by_m(2, :)) < 1.0e-9_wp) allowed = 1.0e-3_wp
         if (abs(sums(who) - sums(us)) <= allowed*abs(sums(us))) cycle
         write(error_unit, '(4a, i0)') 'bench: other values in ', trim(names(which)), ', ', &
            trim(places(place, classes(which)))//', by ', who
         error stop 1
      end do
   end subroutine check_sums

end program main
