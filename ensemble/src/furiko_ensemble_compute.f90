! SPDX-License-Identifier: MIT

!> The numbers of a chunk, by the library's procedures.
module furiko_ensemble_compute
   use, intrinsic :: iso_fortran_env, only : int64, wp => real64
   use furiko, only : driven_basins, driven_exponents, driven_locking, driven_pendulum, driven_scheme, &
      driven_section, driven_state, driven_winding
   use furiko_ensemble_sweep, only : in_range, quantity, sweep, take_members, tolerance
   implicit none
   private
   public :: compute


contains


   !> The results of a chunk
   subroutine compute(asked, scheme, chunk, results)
      type(sweep), intent(in) :: asked
      type(driven_scheme), intent(in) :: scheme
      integer(int64), intent(in) :: chunk
      type(quantity), intent(inout) :: results(:)
      type(driven_pendulum), allocatable :: pendulum(:)
      type(driven_state), allocatable :: state(:)
      real(wp), allocatable :: values(:)
      integer :: n

      call take_members(asked, chunk, values, pendulum, state)
      n = size(state)
      if (allocated(results(1)%reals)) results(1)%reals(1, :n) = values
      select case (asked%subject)
      case ('section', 'bifurcation')
         call compute_sections(asked, scheme, pendulum, state, results)
      case ('lyapunov')
         call compute_exponents(asked, scheme, pendulum, state, results)
      case ('winding')
         call compute_winding(asked, scheme, pendulum, state, results)
      case default
         call compute_basins(asked, scheme, pendulum(1), state, results)
      end select
      results(size(results))%wholes(1, :n) = state%status
   end subroutine compute


   !> Threads share groups of members, of which each makes all its points: so states and numbers of a whole
   !> chunk are never in memory both.
   subroutine compute_sections(asked, scheme, pendulum, state, results)
      type(sweep), intent(in) :: asked
      type(driven_scheme), intent(in) :: scheme
      type(driven_pendulum), intent(in) :: pendulum(:)
      type(driven_state), intent(inout) :: state(:)
      type(quantity), intent(inout) :: results(:)
      ! a block of the library's kernels
      integer, parameter :: group = 64
      integer :: i, last

      !$omp parallel do private(last) schedule(dynamic)
      do i = 1, size(state), group
         last = min(i + group - 1, size(state))
         call compute_group(asked, scheme, pendulum(i:last), i, state(i:last), results)
      end do
      !$omp end parallel do
   end subroutine compute_sections


   subroutine compute_group(asked, scheme, pendulum, first, state, results)
      type(sweep), intent(in) :: asked
      type(driven_scheme), intent(in) :: scheme
      type(driven_pendulum), intent(in) :: pendulum(:)
      !> Its place among the results
      integer, intent(in) :: first
      type(driven_state), intent(inout) :: state(:)
      type(quantity), intent(inout) :: results(:)
      type(driven_state), allocatable :: points(:, :)
      integer :: last

      allocate(points(asked%periods, size(state)))
      last = first + size(state) - 1
      call driven_section(scheme, pendulum, state, asked%transient, points)
      results(2)%reals(:, first:last) = points%angle
      results(3)%reals(:, first:last) = points%rate
      ! One number for each period of a section, the last one of a bifurcation diagram
      associate (rows => results(4)%rows)
         results(4)%wholes(:, first:last) = in_range(points(asked%periods - rows + 1:, :)%turns)
      end associate
   end subroutine compute_group


   subroutine compute_exponents(asked, scheme, pendulum, state, results)
      type(sweep), intent(in) :: asked
      type(driven_scheme), intent(in) :: scheme
      type(driven_pendulum), intent(in) :: pendulum(:)
      type(driven_state), intent(inout) :: state(:)
      type(quantity), intent(inout) :: results(:)
      real(wp) :: exponents(2, size(state))

      call driven_exponents(scheme, pendulum, state, asked%transient, asked%periods, exponents, &
         results(4)%reals(1, :size(state)))
      results(2)%reals(1, :size(state)) = exponents(1, :)
      results(3)%reals(1, :size(state)) = exponents(2, :)
   end subroutine compute_exponents


   !> By counting, and exactly where a member is locked
   subroutine compute_winding(asked, scheme, pendulum, state, results)
      type(sweep), intent(in) :: asked
      type(driven_scheme), intent(in) :: scheme
      type(driven_pendulum), intent(in) :: pendulum(:)
      type(driven_state), intent(inout) :: state(:)
      type(quantity), intent(inout) :: results(:)
      real(wp), parameter :: same = 1.0e-6_wp
      integer :: period(size(state))
      integer(int64) :: turns(size(state))

      associate (winding => results(2)%reals(1, :size(state)))
         call driven_winding(scheme, pendulum, state, asked%transient, asked%periods, winding)
         call driven_locking(scheme, pendulum, state, asked%cycle, same, period, turns)
         where (period > 0) winding = real(turns, wp)/period
      end associate
      results(3)%wholes(1, :size(state)) = in_range(turns)
      results(4)%wholes(1, :size(state)) = period
   end subroutine compute_winding


   subroutine compute_basins(asked, scheme, pendulum, state, results)
      type(sweep), intent(in) :: asked
      type(driven_scheme), intent(in) :: scheme
      type(driven_pendulum), intent(in) :: pendulum
      type(driven_state), intent(inout) :: state(:)
      type(quantity), intent(inout) :: results(:)
      integer, dimension(size(state)) :: arrival, basin

      call driven_basins(scheme, pendulum, state, asked%attractor, asked%label, tolerance, asked%periods, &
         basin, arrival)
      results(1)%wholes(1, :size(state)) = basin
      results(2)%wholes(1, :size(state)) = arrival
   end subroutine compute_basins
end module furiko_ensemble_compute
