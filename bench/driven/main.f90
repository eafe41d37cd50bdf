! SPDX-License-Identifier: MIT

!> What a step of a driven, damped pendulum costs: 512 members, each with its own amplitude, nanoseconds a step
!> and member, the least of five runs, by processor time. See `run`.
program driven_speed
   use, intrinsic :: iso_fortran_env, only : wp => real64
   use furiko_driven_scheme, only : driven_order8, driven_rk4, driven_scheme
   use furiko_driven_steps, only : driven_pendulum, driven_periods, driven_state
   implicit none
   integer, parameter :: members = 512

   print '(a, 4f8.2)', '', cost(driven_rk4(256), 0), cost(driven_rk4(256), 1), cost(driven_order8(96), 0), &
      cost(driven_order8(96), 1)


contains


   function cost(scheme, tangents) result(nanoseconds)
      type(driven_scheme), intent(in) :: scheme
      integer, intent(in) :: tangents
      real(wp) :: nanoseconds
      integer, parameter :: periods = 50
      type(driven_pendulum) :: pendulum(members)
      type(driven_state) :: state(members)
      real(wp) :: columns(2, 1, members), start, end
      integer :: i, j

      pendulum = driven_pendulum(damping=0.5_wp, frequency=2/3.0_wp)
      pendulum%amplitude = [(1 + 0.001_wp*i, i=1, members)]
      state = driven_state(angle=0.1_wp)
      columns = 1.0_wp
      nanoseconds = huge(nanoseconds)
      do i = 1, 5
         call cpu_time(start)
         if (tangents == 0) then
            call driven_periods(scheme, pendulum, state, periods)
         else
            do j = 1, periods
               call driven_periods(scheme, pendulum, state, 1, columns)
               columns = 1.0_wp
            end do
         end if
         call cpu_time(end)
         nanoseconds = min(nanoseconds, (end - start)*1.0e9_wp/(real(members, wp)*scheme%steps*periods))
      end do
   end function cost

end program driven_speed
