! SPDX-License-Identifier: MIT

!> Ten swings beside the small-angle pendulum: how a clock that is 3 % slow loses step.
module furiko_figure_drift
   use, intrinsic :: iso_fortran_env, only : wp => real64
   use furiko, only : amplitude_of_excess, motion, pendulum, period_excess, period_ratio
   use furiko_figure, only : amplitude, black, blue, column, figure, fixed, orange, plain, ramp, &
      significant, to_text
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
      type(figure), intent(inout) :: self
      character(len=:), allocatable :: label, late
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
      late = significant(swings*period_excess(largest))
      until = swings*ratio + 0.25_wp
      time = ramp(0.0_wp, until, ceiling(until*points_per_swing))
      path = bob%released(largest)

      call self%begin([column('time_over_small_period', 'time in periods of small swings'), &
         column('angle_deg', 'angle in degrees')], &
         'Ten swings of ' // label // ' beside those of a small-angle pendulum that starts with them. ' // &
         'They end ' // &
         plain(late) // ' periods later.')
      associate (top => largest/degree)
         call self%panel('time  <t> / <T>_h  (periods of small swings)', 'angle <θ>  (degrees)', &
            [0.0_wp, until], &
            [-1.05_wp, 1.45_wp]*top)
         call self%say('set ytics (' // to_text(-top) // ', 0, ' // to_text(top) // ') format "%.4g"')
         call self%add('exact', time, path%angle(time*bob%small_period())/degree)
         call self%draw(blue, style='lines lw 3')
         call self%add('small-angle', time, top*cos(2*pi*time))
         call self%draw(black, dash=orange)
         call self%note('exact, <θ>_0 = ' // label // ', <T> = ' // fixed(ratio, 4) // ' <T>_h', 0.0_wp, &
            1.34_wp*top, 'left', blue)
         call self%note('dashed: small-angle pendulum, <T>_h', 0.0_wp, 1.2_wp*top, 'left')
         call mark(swings*1.0_wp, top)
         call mark(swings*ratio, top)
         ! A head longer than its line would say nothing.
         if (swings*(ratio - 1) > 0.02_wp*until) then
            call self%arrow([swings*1.0_wp, swings*ratio], spread(1.15_wp*top, 1, 2), black, .true.)
         end if
         call self%note('ten swings end ' // late // ' <T>_h late', until, 1.34_wp*top, 'right')
      end associate
      call self%plot()

   contains

      !> A short line above the curves, where a swing ends
      subroutine mark(at, top)
         real(wp), intent(in) :: at
         real(wp), intent(in) :: top

         call self%arrow([at, at], [1.02_wp, 1.2_wp]*top, black, .false.)
      end subroutine mark

   end subroutine drift_figure

end module furiko_figure_drift
