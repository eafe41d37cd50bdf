! SPDX-License-Identifier: MIT

!> Runge-Kutta steps of the pendulum beside GSL's in one run: interleaved repeats, the least of each,
!> in ns a step. Prints a Markdown table.
program steps
   use, intrinsic :: iso_fortran_env, only : error_unit, int64, wp => real64
   use bench_odeiv2, only : gsl_driver, gsl_steps
   use furiko, only : pendulum_forest_ruth, pendulum_rk4, pendulum_verlet, rk4
   use furiko_pendulum_rates_dp, only : pendulum_rates
   implicit none
   integer, parameter :: swings = 100
   integer, parameter :: members = 512
   integer, parameter :: repeats = 15
   integer, parameter :: driver = 1, bare = 2
   real(wp), parameter :: h = acos(-1.0_wp)/50
   character(len=*), parameter :: names(8) = [character(len=36) :: 'GSL rk4, driver of fixed step', &
      'GSL rk4, step function', 'rk4, any system', 'pendulum_rk4, one', 'pendulum_verlet, one', &
      'pendulum_forest_ruth, one', 'pendulum_rk4, 512 at once', 'pendulum_forest_ruth, 512 at once']
   real(wp) :: times(size(names)), values(size(names))
   integer :: i, repeat

   times = huge(times)
   do repeat = 1, repeats
      do i = 1, size(names)
         times(i) = min(times(i), time_of(i, values(i)))
      end do
   end do
   call check_values()
   print '(a)', '| | ns | GSL driver / this | GSL step / this |', '|---|---|---|---|'
   do i = 1, size(names)
      print '(3a, 3(f8.1, a))', '| ', names(i), ' | ', times(i), ' | ', times(driver)/times(i), ' | ', &
         times(bare)/times(i), ' |'
   end do


contains


   !> ns a step
   function time_of(case, value) result(time)
      integer, intent(in) :: case
      real(wp), intent(out) :: value
      real(wp) :: time
      integer(int64) :: start, finish, rate
      integer :: n

      n = 100*swings
      if (case > size(names) - 2) n = 5*swings*members
      call system_clock(start, rate)
      value = angle_after(case)
      call system_clock(finish)
      time = real(finish - start, wp)/real(rate, wp)*1.0e9_wp/n
   end function time_of


   !> Where a pendulum let go at 1 rad is in the end
   function angle_after(case) result(angle)
      integer, intent(in) :: case
      real(wp) :: angle
      real(wp) :: y(2), rate
      real(wp), dimension(members) :: angles, rates

      y = [1.0_wp, 0.0_wp]
      angle = 1
      rate = 0
      angles = 1
      rates = 0
      select case (case)
      case (driver)
         call gsl_driver(h, 100*swings, y)
         angle = y(1)
      case (bare)
         call gsl_steps(h, 100*swings, y)
         angle = y(1)
      case (3)
         call rk4(pendulum_rates, [1.0_wp], 0.0_wp, h, 100*swings, y)
         angle = y(1)
      case (4)
         call pendulum_rk4(1.0_wp, h, 100*swings, angle, rate)
      case (5)
         call pendulum_verlet(1.0_wp, h, 100*swings, angle, rate)
      case (6)
         call pendulum_forest_ruth(1.0_wp, h, 100*swings, angle, rate)
      case (7)
         call pendulum_rk4(1.0_wp, h, 5*swings, angles, rates)
         angle = angles(members)
      case default
         call pendulum_forest_ruth(1.0_wp, h, 5*swings, angles, rates)
         angle = angles(members)
      end select
   end function angle_after


   !> GSL's step is two of ours of half the size; and all of ours agree
   subroutine check_values()
      real(wp) :: angle, rate, y(2)

      angle = 1
      rate = 0
      call pendulum_rk4(1.0_wp, h/2, 200*swings, angle, rate)
      y = [1.0_wp, 0.0_wp]
      call rk4(pendulum_rates, [1.0_wp], 0.0_wp, h, 5*swings, y)
      if (max(abs(values(driver) - angle), abs(values(bare) - angle), abs(values(3) - values(4)), &
         abs(values(7) - y(1))) > 1.0e-10_wp) then
         write(error_unit, '(a)') 'bench: the steps differ'
         error stop 1
      end if
   end subroutine check_values

end program steps
