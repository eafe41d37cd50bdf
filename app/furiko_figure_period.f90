! SPDX-License-Identifier: MIT

!> The period against the amplitude: exact, by small angles, by the first terms of the series.
module furiko_figure_period
   use, intrinsic :: iso_fortran_env, only : wp => real64
   use furiko, only : amplitude_of_excess, period_ratio, period_ratio_series
   use furiko_figure, only : figure, fixed, ramp, to_text
   implicit none
   private
   public :: period_figure


   real(wp), parameter :: degree = acos(-1.0_wp)/180
   !> What the series adds, term by term, as it is drawn and as the data name it
   character(len=*), parameter :: labels(4) = [character(len=32) :: '1', '1 + <k>^2/4', &
      '⋯ + 9<k>^4/64', '⋯ + 25<k>^6/256']
   character(len=*), parameter :: names(4) = [character(len=12) :: 'small angle', 'to k^2', &
      'to k^4', 'to k^6']
   character(len=*), parameter :: looks(4) = [character(len=48) :: &
      'lines lw 2 dt (3, 4) lc rgb "#000000"', 'lines lw 2 dt (12, 4) lc rgb "#009E73"', &
      'lines lw 2 dt (12, 4, 2, 4) lc rgb "#D55E00"', 'lines lw 2 dt (5, 3) lc rgb "#0072B2"']


contains


   subroutine period_figure(self)
      type(figure), intent(out) :: self
      real(wp) :: amplitude(360), partial(360)
      real(wp) :: slower
      integer :: n

      amplitude = ramp(0.0_wp, 179.5_wp, 359)
      call self%begin('amplitude_deg', 'period_ratio')
      do n = 1, size(names)
         partial = period_ratio_series(amplitude*degree, n)
         call self%add(trim(names(n)), amplitude, partial)
         call self%draw(trim(looks(n)))
         call self%say('set label "' // trim(labels(n)) // '" at 182, ' // &
            to_text(partial(size(partial))) // ' left')
      end do
      call self%add('exact', amplitude, period_ratio(amplitude*degree))
      call self%draw('lines lw 3 lc rgb "#000000"')
      slower = amplitude_of_excess(0.03_wp)/degree

      call self%say('set rmargin 17')
      call self%say('set xlabel "amplitude <θ>_0  (degrees)"')
      call self%say('set ylabel "period  <T> / <T>_h" offset 1')
      call self%say('set xrange [0:180]')
      call self%say('set yrange [0.95:3]')
      call self%say('set xtics 30')
      call self%say('set ytics 1, 0.5')
      call self%say('set label "exact: (2/π) <K>(<k>)" at 166, 2.5 right')
      call self%say('set label "<k> = sin(<θ>_0/2)" at 182, 1.75 left')
      call self%say('set multiplot')
      call self%plot(again=.true.)

      call self%say('unset label')
      call self%say('unset title')
      call self%say('set origin 0.13, 0.44')
      call self%say('set size 0.48, 0.5')
      call self%say('set rmargin 2')
      call self%say('unset xlabel')
      call self%say('unset ylabel')
      call self%say('set xrange [0:60]')
      call self%say('set yrange [0.995:1.08]')
      call self%say('set xtics 10')
      call self%say('set ytics 1, 0.02')
      call self%say('set format y "%.2f"')
      call self%say('set arrow from 0, 1.03 to ' // fixed(slower, 4) // ', 1.03 nohead lw 1')
      call self%say('set arrow from ' // fixed(slower, 4) // ', 1.03 to ' // fixed(slower, 4) // &
         ', 0.995 nohead lw 1')
      call self%say('set label "3 % longer at ' // fixed(slower, 2) // '°" at 2, 1.034 left')
      call self%plot()
      call self%say('unset multiplot')
   end subroutine period_figure


end module furiko_figure_period
