! SPDX-License-Identifier: MIT

!> The attractors of basins: found once, when the file is made, and from then on read from there. So all
!> processes and all later runs have the same labels, and only one has the work.
module furiko_ensemble_attractors
   use, intrinsic :: iso_fortran_env, only : int64, wp => real64
   use furiko, only : driven_attractors, driven_pendulum, driven_state
   use furiko_ensemble_sweep, only : in_range, quantity, scheme_of, sweep, take_members
   implicit none
   private
   public :: attractor_quantities, find_attractors, given_attractors, same_attractors, take_attractors


contains


   !> The attractors to which 256 starts come, of all angles and of the rates that are asked for
   subroutine find_attractors(asked)
      type(sweep), intent(inout) :: asked
      integer, parameter :: side = 16, most_points = 1024
      type(sweep) :: starts
      type(driven_pendulum), allocatable :: pendulum(:)
      type(driven_state), allocatable :: state(:)
      type(driven_state) :: points(most_points)
      real(wp), allocatable :: values(:)
      integer :: label(most_points), found

      starts = asked
      starts%grid = side
      starts%points = side**2
      starts%chunk = side**2
      starts%angles = [-180.0_wp, 180.0_wp]
      call take_members(starts, 0_int64, values, pendulum, state)
      call driven_attractors(scheme_of(asked), pendulum(1), state, asked%transient, asked%cycle, points, &
         label, found)
      asked%attractor = points(:count(label > 0))
      asked%label = label(:count(label > 0))
   end subroutine find_attractors


   !> Points of attractors, by number
   function attractor_quantities(points) result(all)
      integer, intent(in) :: points
      type(quantity) :: all(6)
      integer :: i, j

      all = [quantity('point', '1', 'of all attractors, one after another', points), &
         quantity('label', '1', 'the attractor to which the point belongs', points), &
         quantity('cycle', '1', 'periods of the drive until it comes again', points), &
         quantity('turns', '1', 'whole turns by then', points), &
         quantity('angle', 'rad', 'from the bottom', points), quantity('rate', 'sqrt(gravity/length)', &
         'of the angle', points)]
      do i = 1, 4
         all(i)%wholes = reshape([(j, j=1, points)], [points, 1])
      end do
      allocate(all(5)%reals(points, 1), all(6)%reals(points, 1), source=0.0_wp)
   end function attractor_quantities


   !> Attractors as quantities
   function given_attractors(asked) result(all)
      type(sweep), intent(in) :: asked
      type(quantity) :: all(6)
      integer :: i

      all = attractor_quantities(size(asked%label))
      all(2)%wholes(:, 1) = asked%label
      all(3)%wholes(:, 1) = [(count(asked%label == asked%label(i)), i=1, size(asked%label))]
      all(4)%wholes(:, 1) = in_range(asked%attractor%turns)
      all(5)%reals(:, 1) = asked%attractor%angle
      all(6)%reals(:, 1) = asked%attractor%rate
   end function given_attractors


   !> The other way
   subroutine take_attractors(all, asked)
      type(quantity), intent(in) :: all(6)
      type(sweep), intent(inout) :: asked

      asked%label = int(all(2)%wholes(:, 1))
      if (allocated(asked%attractor)) deallocate(asked%attractor)
      allocate(asked%attractor(size(asked%label)))
      asked%attractor%turns = all(4)%wholes(:, 1)
      asked%attractor%angle = all(5)%reals(:, 1)
      asked%attractor%rate = all(6)%reals(:, 1)
   end subroutine take_attractors


   !> Whether two sweeps match against the same points
   function same_attractors(a, b) result(same)
      type(sweep), intent(in) :: a
      type(sweep), intent(in) :: b
      logical :: same

      same = a%subject /= 'basins'
      if (same) return
      same = size(a%label) == size(b%label)
      if (same) same = all(a%label == b%label) .and. .not. &
         any(abs(a%attractor%angle - b%attractor%angle) > 0 .or. abs(a%attractor%rate - b%attractor%rate) > 0)
   end function same_attractors
end module furiko_ensemble_attractors
