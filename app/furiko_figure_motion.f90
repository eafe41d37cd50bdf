! SPDX-License-Identifier: MIT

!> The angle against time, exact and harmonic, from the same start: the first note's figures 2 to 4.
module furiko_figure_motion
   use, intrinsic :: iso_fortran_env, only : wp => real64
   use furiko, only : motion, pendulum, period_ratio
   use furiko_figure, only : amplitude, blue, black, column, figure, fixed, orange, ramp, to_text
   implicit none
   private
   public :: motion_figure


   !> Seconds, as in the note
   real(wp), parameter :: until = 10.0_wp
   real(wp), parameter :: degree = acos(-1.0_wp)/180


contains


   subroutine motion_figure(amplitudes, self)
      type(amplitude), intent(in) :: amplitudes(:)
      type(figure), intent(inout) :: self
      integer :: i
      logical :: degrees

      degrees = all([(amplitudes(i)%in_degrees, i=1, size(amplitudes))])
      call self%begin([column('time_s', 'time in seconds; l = 1 m, g = 9.80665 m/s^2'), &
         column(merge('angle_deg', 'angle_rad', degrees), 'angle in ' // merge('degrees', 'radians', &
         degrees))], &
         'Angle against time during ten seconds, a panel for each amplitude. The exact motion and the ' // &
         'harmonic one start alike, at the bottom with the same rate; the exact one is slower, and the ' // &
         'more so the wider it swings.')
      do i = 1, size(amplitudes)
         call add_panel(amplitudes(i), degrees, [1, 1, i, size(amplitudes)], self)
      end do
   end subroutine motion_figure


   !> Through the bottom with the rate 2 k ω: θ = 2 asin(k sn(ωt)) beside 2 k sin(ωt), (8) and (9)
   !> of the note.
   subroutine add_panel(amplitude_, degrees, cell, self)
      type(amplitude), intent(in) :: amplitude_
      !> Whether to draw degrees, rather than radians
      logical, intent(in) :: degrees
      integer, intent(in) :: cell(4)
      type(figure), intent(inout) :: self
      type(pendulum) :: bob
      type(motion) :: path
      real(wp) :: time(401)
      real(wp) :: harmonic, largest, unit

      unit = merge(degree, 1.0_wp, degrees)
      largest = amplitude_%radians/unit
      harmonic = 2*sin(amplitude_%radians/2)/unit
      if (cell(3) == cell(4)) then
         call self%panel('time <t>  (seconds; <l> = 1 m, <g> = 9.80665 m/s²)', &
            '<θ>  (' // trim(merge('degrees', 'rad    ', degrees)) // ')', [0.0_wp, until], &
            [-1.05_wp, 1.05_wp]*largest, cell=cell)
         call self%say('set xtics 1 format "%g"')
      else
         call self%panel('', '<θ>  (' // trim(merge('degrees', 'rad    ', degrees)) // ')', [0.0_wp, &
            until], &
            [-1.05_wp, 1.05_wp]*largest, cell=cell)
         call self%say('set xtics 1 format ""')
      end if
      call self%say('set ytics (' // to_text(-largest) // ', 0, ' // to_text(largest) // ') format "%.4g"')
      time = ramp(0.0_wp, until, 400)
      path = bob%swinging(amplitude_%radians)
      call self%add('exact ' // amplitude_%label, time, path%angle(time)/unit)
      call self%draw(blue, style='lines lw 3')
      call self%add('harmonic ' // amplitude_%label, time, harmonic*sin(bob%frequency()*time))
      call self%draw(black, dash=orange)
      call self%caption('<θ>_0 = ' // amplitude_%label // ', <T> = ' // &
         fixed(period_ratio(amplitude_%radians), 4) // &
         ' <T>_h;  dotted: to 2<k> = 2 sin(<θ>_0/2) = ' // fixed(harmonic, 4) // &
         trim(merge('°', '  ', degrees)))
      call self%plot()
   end subroutine add_panel

end module furiko_figure_motion
