! SPDX-License-Identifier: MIT
#include "../arithmetic/furiko_compiler.inc"

!> What driven pendulums do: their orbits, and their stroboscopic sections, of many members at once. The
!> section of a family of members, each with another constant, is a bifurcation diagram.
module furiko_driven_sections
   use, intrinsic :: iso_fortran_env, only : wp => real64
   use furiko_driven_scheme, only : driven_scheme
   use furiko_driven_steps, only : driven_block, driven_pendulum, driven_periods, driven_state, driven_steps
   implicit none
   private
   public :: driven_orbit, driven_section


contains


   !> States of one member, a column after another `every` steps: with `every = scheme%steps/32`, 32 to each
   !> period of the drive. The start is not among them.
   pure subroutine driven_orbit(scheme, pendulum, state, every, states)
      !> Method and steps to a period
      type(driven_scheme), intent(in) :: scheme
      !> Constants
      type(driven_pendulum), intent(in) :: pendulum
      !> The start, at t = 0, and the end
      type(driven_state), intent(inout) :: state
      !> Steps from one state to the next
      integer, intent(in) :: every
      !> States after `every`, 2 `every`, ... steps
      type(driven_state), intent(out) :: states(:)
      type(driven_state) :: one(1)
      integer :: i, at

      one = state
      at = 0
      do i = 1, size(states)
         call driven_steps(scheme, [pendulum], one, at, every)
         at = modulo(at + every, scheme%steps)
         states(i) = one(1)
      end do
      state = one(1)
   end subroutine driven_orbit


   !> Sections of many members: after `transient` periods, which are not stored, the states at the beginning
   !> of each of the next periods, in a column a member. Threads share the members, as in
   !> [[driven_periods]].
   subroutine driven_section(scheme, pendulum, state, transient, points)
      !> Method and steps to a period
      type(driven_scheme), intent(in) :: scheme
      !> Constants of each member
      type(driven_pendulum), intent(in) :: pendulum(:)
      !> Their starts, and their ends
      type(driven_state), intent(inout) :: state(:)
      !> Periods before the first point
      integer, intent(in) :: transient
      !> Points of the section, as many a member as there are rows: (points, members)
      type(driven_state), intent(out) :: points(:, :)
      integer :: i, last, j

      call driven_periods(scheme, pendulum, state, transient)
      !$omp parallel do private(last, j) schedule(dynamic)
      do i = 1, size(state), driven_block
         last = min(i + driven_block - 1, size(state))
         do j = 1, size(points, 1)
            call driven_steps(scheme, pendulum(i:last), state(i:last), 0, scheme%steps)
            points(j, i:last) = state(i:last)
         end do
      end do
      !$omp end parallel do
   end subroutine driven_section
end module furiko_driven_sections
! rooms: 3759241635
