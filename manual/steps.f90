! SPDX-License-Identifier: MIT

!> The tables of doc/steps.md: how many steps a period an integrator takes for so many digits of angle and
!> rate, and what becomes of the energy. `python3 manual/steps.py FOLDER` compiles it and puts them there.
program steps
   use, intrinsic :: iso_fortran_env, only : wp => real64
   use furiko, only : pendulum_forest_ruth, pendulum_rk4, pendulum_verlet, period_ratio
   implicit none
   character(len=*), parameter :: methods(3) = [character(len=11) :: 'RK4', 'Forest-Ruth', 'Verlet']
   real(wp), parameter :: amplitudes(3) = [0.1_wp, 1.0_wp, 3.0_wp]
   ! More steps in all would be mostly rounding
   integer, parameter :: most = 10000000
   integer :: method, digits, periods, i

   print '(a)', '| periods | amplitude | method | 6 digits | 9 digits | 12 digits |', &
      '|---|---|---|---|---|---|'
   do periods = 1, 100, 99
      do i = 1, size(amplitudes)
         do method = 1, size(methods)
            print '(a, i0, a, f3.1, 20a)', '| ', periods, ' | ', amplitudes(i), ' rad | ', &
               trim(methods(method)), (' | ' // trim(least(method, amplitudes(i), periods, &
               0.5_wp*0.1_wp**digits)), digits=6, 12, 3), ' |'
         end do
      end do
   end do
   print '(a)', '', '| amplitude | method | after 10 periods | after 1,000 | after 100,000 |', &
      '|---|---|---|---|---|'
   do i = 1, size(amplitudes)
      do method = 1, size(methods)
         print '(a, f3.1, 20a)', '| ', amplitudes(i), ' rad | ', trim(methods(method)), &
            (' | ' // drift(method, amplitudes(i), periods), periods=1, 3), ' |'
      end do
   end do

contains

   !> A pendulum of omega = 1 so many steps further, of which n make a period
   pure subroutine swing(method, amplitude, n, steps, angle, rate)
      integer, intent(in) :: method, n, steps
      real(wp), intent(in) :: amplitude
      real(wp), intent(inout) :: angle, rate
      real(wp) :: h

      h = 2*acos(-1.0_wp)*period_ratio(amplitude)/n
      select case (method)
      case (1)
         call pendulum_rk4(1.0_wp, h, steps, angle, rate)
      case (2)
         call pendulum_forest_ruth(1.0_wp, h, steps, angle, rate)
      case default
         call pendulum_verlet(1.0_wp, h, steps, angle, rate)
      end select
   end subroutine swing


   !> Whether angle and rate, over their largest, are within the tolerance of where the exact pendulum is,
   !> at the start
   pure logical function is_good(method, amplitude, n, periods, tolerance)
      integer, intent(in) :: method, n, periods
      real(wp), intent(in) :: amplitude, tolerance
      real(wp) :: angle, rate

      angle = amplitude
      rate = 0
      call swing(method, amplitude, n, n*periods, angle, rate)
      is_good = max(abs(angle/amplitude - 1), abs(rate)/(2*sin(amplitude/2))) <= tolerance
   end function is_good


   !> The fewest steps a period, to two figures
   pure function least(method, amplitude, periods, tolerance) result(text)
      integer, intent(in) :: method, periods
      real(wp), intent(in) :: amplitude, tolerance
      character(len=7) :: text
      integer :: low, high, middle

      if (tolerance < 100*periods*epsilon(tolerance)) then
         text = 'no'
         return
      end if
      high = 8
      do while (.not. is_good(method, amplitude, high, periods, tolerance))
         high = 2*high
         if (high > most/periods) then
            text = 'no'
            return
         end if
      end do
      low = high/2
      do while (high - low > 1 + high/200)
         middle = (low + high)/2
         if (is_good(method, amplitude, middle, periods, tolerance)) then
            high = middle
         else
            low = middle
         end if
      end do
      middle = 10**max(0, int(log10(real(high, wp))) - 1)
      write (text, '(i0)') middle*((high + middle - 1)/middle)
   end function least


   !> The largest change of the energy, over its size from the bottom, in the period after so many, by 100
   !> steps a period
   pure function drift(method, amplitude, level) result(text)
      integer, intent(in) :: method, level
      real(wp), intent(in) :: amplitude
      character(len=7) :: text
      real(wp) :: angle, rate, worst
      integer :: i

      angle = amplitude
      rate = 0
      worst = 0
      call swing(method, amplitude, 100, 100*10**(2*level - 1), angle, rate)
      do i = 1, 100
         worst = max(worst, abs((rate**2/2 + 1 - cos(angle))/(1 - cos(amplitude)) - 1))
         call swing(method, amplitude, 100, 1, angle, rate)
      end do
      write (text, '(es7.1)') worst
   end function drift

end program steps
