! SPDX-License-Identifier: MIT

!> The angle against time, exact and harmonic, from the same start: the first note's figures 2 to 4.
module furiko_figure_motion
   use, intrinsic :: iso_fortran_env, only : wp => real64
   use furiko, only : motion, pendulum, period_ratio
   use furiko_figure, only : amplitude, figure, fixed, ramp, to_text
   implicit none
   private
   public :: motion_figure


   !> Seconds, as in the note
   real(wp), parameter :: until = 10.0_wp
   real(wp), parameter :: degree = acos(-1.0_wp)/180


contains


   subroutine motion_figure(amplitudes, self)
      type(amplitude), intent(in) :: amplitudes(:)
      type(figure), intent(out) :: self
      integer :: i

      call self%begin('time_s', merge('angle_deg', 'angle_rad', in_degrees(amplitudes)), &
         to_text(size(amplitudes)) // ',1 margins left, right, bottom, top spacing 0.1')
      call self%say('set xrange [0:10]')
      call self%say('set xtics 1 format ""')
      call self%say('set key at graph 1, 1.02 right bottom horizontal nobox samplen 3')
      do i = 1, size(amplitudes)
         if (i == size(amplitudes)) then
            call self%say('set xtics 1 format "%g"')
            call self%say('set xlabel "time <t>  (seconds; <l> = 1 m, <g> = 9.80665 m/s²)"')
         end if
         call add_panel(amplitudes(i), in_degrees(amplitudes), self)
         call self%say('unset key')
      end do
      call self%say('unset multiplot')
   end subroutine motion_figure


   !> Through the bottom with the rate 2 k ω: θ = 2 asin(k sn(ωt)) beside 2 k sin(ωt), (8) and (9)
   !> of the note.
   subroutine add_panel(amplitude_, degrees, self)
      type(amplitude), intent(in) :: amplitude_
      !> Whether to draw degrees, rather than radians
      logical, intent(in) :: degrees
      type(figure), intent(inout) :: self
      type(pendulum) :: bob
      type(motion) :: path
      real(wp) :: time(401)
      real(wp) :: largest, unit

      unit = merge(degree, 1.0_wp, degrees)
      time = ramp(0.0_wp, until, 400)
      path = bob%swinging(amplitude_%radians)
      call self%add('exact ' // amplitude_%label, time, path%angle(time)/unit)
      call self%draw('lines lw 4 lc rgb "#56B4E9" title "exact"')
      call self%add('harmonic ' // amplitude_%label, time, &
         2*sin(amplitude_%radians/2)*sin(bob%frequency()*time)/unit)
      call self%draw('lines lw 1.5 dt (6, 4) lc rgb "#000000" title "harmonic"')

      largest = amplitude_%radians/unit
      call self%say('set label 1 "<θ>_0 = ' // amplitude_%label // ',  <T> = ' // &
         fixed(period_ratio(amplitude_%radians), 4) // ' <T>_h" at graph 0, 1 offset 0, 0.8 left')
      call self%say('set ylabel "<θ>  (' // trim(merge('degrees', 'rad    ', degrees)) // &
         ')" offset 1')
      call self%say('set yrange [' // to_text(-1.05_wp*largest) // ':' // &
         to_text(1.05_wp*largest) // ']')
      call self%say('set ytics (' // to_text(-largest) // ', 0, ' // to_text(largest) // &
         ') format "%g"')
      call self%plot()
   end subroutine add_panel


   pure function in_degrees(amplitudes)
      type(amplitude), intent(in) :: amplitudes(:)
      logical :: in_degrees
      integer :: i

      in_degrees = all([(amplitudes(i)%in_degrees, i=1, size(amplitudes))])
   end function in_degrees


end module furiko_figure_motion
