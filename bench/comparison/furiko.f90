! SPDX-License-Identifier: MIT

!> The cascade by furiko: TRANSIENT KEPT STEPS rk4|order8
program cascade
   use, intrinsic :: iso_fortran_env, only : error_unit, int64, wp => real64
   use furiko_driven_scheme, only : driven_order8, driven_rk4
   use furiko_driven_sections, only : driven_section
   use furiko_driven_steps, only : driven_pendulum, driven_state
   implicit none
   type(driven_pendulum), allocatable :: pendulum(:)
   type(driven_state), allocatable :: state(:), points(:, :)
   real(wp) :: drives(100000)
   character(len=8) :: words(4)
   integer :: transient, kept, steps, members, i, stat
   integer(int64) :: start, end, rate

   do i = 1, 4
      call get_command_argument(i, words(i))
   end do
   read(words(:3), *) transient, kept, steps
   do members = 0, size(drives) - 1
      read(*, *, iostat=stat) drives(members + 1)
      if (stat /= 0) exit
   end do
   allocate(pendulum(members), state(members), points(kept, members))
   pendulum = driven_pendulum(damping=0.5_wp, frequency=2/3.0_wp)
   pendulum%amplitude = drives(:members)
   state%angle = -acos(0.0_wp)

   call system_clock(start, rate)
   if (words(4) == 'rk4') then
      call driven_section(driven_rk4(steps), pendulum, state, transient, points)
   else
      call driven_section(driven_order8(steps), pendulum, state, transient, points)
   end if
   call system_clock(end)
   write(error_unit, *) real(end - start, wp)/real(rate, wp)
   do i = 1, members
      print '(3es25.16)', (drives(i), points(stat, i)%angle, points(stat, i)%rate, stat=1, kept)
   end do
end program cascade
