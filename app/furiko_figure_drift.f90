! SPDX-License-Identifier: MIT

!> Ten swings beside the small-angle pendulum: how a clock that is 3 % slow loses step.
module furiko_figure_drift
   use, intrinsic :: iso_fortran_env, only : wp => real64
   use furiko, only : amplitude_of_excess, motion, pendulum, period_ratio
   use furiko_figure, only : amplitude, figure, fixed, ramp, to_text
   implicit none
   private
   public :: drift_figure


   real(wp), parameter :: pi = acos(-1.0_wp)
   real(wp), parameter :: degree = pi/180
   !> What is shown, in points that make a smooth curve
   integer, parameter :: swings = 10
   integer, parameter :: points_per_swing = 40


contains


   subroutine drift_figure(amplitudes, self)
      !> One, or none for that of a period 3 % longer
      type(amplitude), intent(in) :: amplitudes(:)
      type(figure), intent(out) :: self
      character(len=:), allocatable :: label
      type(pendulum) :: bob
      type(motion) :: path
      real(wp), allocatable :: time(:)
      real(wp) :: largest, ratio, until

      if (size(amplitudes) == 1) then
         largest = amplitudes(1)%radians
         label = amplitudes(1)%label
      else
         largest = amplitude_of_excess(0.03_wp)
         label = fixed(largest/degree, 2) // '°'
      end if
      ratio = period_ratio(largest)
      until = swings*ratio + 0.25_wp
      time = ramp(0.0_wp, until, ceiling(until*points_per_swing))
      path = bob%released(largest)
      largest = largest/degree

      call self%begin('time_over_small_period', 'angle_deg')
      call self%add('exact', time, path%angle(time*bob%small_period())/degree)
      call self%draw('lines lw 3 lc rgb "#0072B2" title "exact, <θ>_0 = ' // label // &
         ', <T> = ' // fixed(ratio, 4) // ' <T>_h"')
      call self%add('small-angle', time, largest*cos(2*pi*time))
      call self%draw('lines lw 1.5 dt (6, 4) lc rgb "#000000" title "small-angle pendulum"')

      call self%say('set xlabel "time  <t> / <T>_h  (periods of small swings)"')
      call self%say('set ylabel "angle <θ>  (degrees)" offset 1')
      call self%say('set xrange [0:' // to_text(until) // ']')
      call self%say('set yrange [' // to_text(-1.05_wp*largest) // ':' // &
         to_text(1.45_wp*largest) // ']')
      call self%say('set ytics (' // to_text(-largest) // ', 0, ' // to_text(largest) // &
         ') format "%.4g"')
      call self%say('set key left top Left reverse samplen 3')
      call mark(swings*1.0_wp)
      call mark(swings*ratio)
      call self%say('set arrow from ' // to_text(swings) // ', ' // to_text(1.15_wp*largest) // &
         ' to ' // to_text(swings*ratio) // ', ' // to_text(1.15_wp*largest) // ' lw 1')
      call self%say('set label "ten swings end ' // fixed(swings*(ratio - 1), 2) // &
         ' <T>_h late" at ' // to_text(swings*ratio) // ', ' // to_text(1.3_wp*largest) // ' right')
      call self%plot()

   contains

      !> A short line above the curves, where a swing ends
      subroutine mark(at)
         real(wp), intent(in) :: at

         call self%say('set arrow from ' // to_text(at) // ', ' // to_text(1.02_wp*largest) // &
            ' to ' // to_text(at) // ', ' // to_text(1.2_wp*largest) // ' nohead lw 1')
      end subroutine mark

   end subroutine drift_figure

end module furiko_figure_drift
