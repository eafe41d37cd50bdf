! SPDX-License-Identifier: MIT

!> The period against the amplitude: exact, by small angles, by the first terms of the series. The axis is
!> broken at 90 degrees; beyond, it tells the distance from the top, decade by decade.
module furiko_figure_period
   use, intrinsic :: iso_fortran_env, only : wp => real64
   use furiko, only : amplitude_of_excess, period_ratio, period_ratio_series
   use furiko_figure, only : amplitude, black, blue, column, figure, fixed, green, orange, purple, ramp
   implicit none
   private
   public :: period_figure


   real(wp), parameter :: degree = acos(-1.0_wp)/180
   real(wp), parameter :: highest = 179.9_wp
   !> Partial sums of the series, as they are drawn and as the data name them
   character(len=*), parameter :: labels(4) = [character(len=8) :: '1 term', '2 terms', '3 terms', '4 terms']
   character(len=*), parameter :: names(4) = [character(len=12) :: 'small angle', 'to k^2', &
      'to k^4', 'to k^6']
   integer, parameter :: pens(4) = [purple, green, orange, blue]


contains


   subroutine period_figure(amplitudes, self)
      type(amplitude), intent(in) :: amplitudes(:)
      type(figure), intent(inout) :: self
      real(wp) :: slower
      integer :: i, n

      associate (unused => amplitudes)
      end associate
      slower = amplitude_of_excess(0.03_wp)/degree
      call self%begin([column('amplitude_deg', 'amplitude in degrees'), &
         column('period_ratio', 'period over that of small swings, T/T_h'), &
         column('below_180_deg', '180 degrees less the amplitude')], &
         'Period against amplitude, exact and by one to four terms of its series. At ' // fixed(slower, &
         2) // &
         ' degrees it is 3 percent longer than that of small swings, at 90 degrees 18 percent, at 179.9 ' // &
         'degrees ' // &
         fixed(period_ratio(highest*degree), 2) // ' times as long: next to the top each tenth of the ' // &
         'distance adds 1.466, for ever. The terms of the series stay below 1.49.')

      call self%panel('amplitude <θ>_0  (degrees)', 'period  <T> / <T>_h', [0.0_wp, 90.0_wp], &
         [0.99_wp, 1.19_wp], cell=[1, 2, 1, 1], margin=48)
      call self%say('set xtics 15; set ytics 1, 0.03 format "%.2f"')
      call self%caption('to 90 degrees')
      call self%arrow([0.0_wp, slower], [1.03_wp, 1.03_wp], black, .false.)
      call self%arrow([slower, slower], [1.03_wp, 0.99_wp], black, .false.)
      call self%note('3 % longer at ' // fixed(slower, 2) // '°', slower, 1.013_wp, 'left')
      call add_curves(ramp(0.0_wp, 90.0_wp, 180), ' to 90', 2)
      do n = 1, size(labels)
         call self%note(trim(labels(n)), 90.0_wp, period_ratio_series(90*degree, n), 'left', pens(n))
      end do
      call self%note('exact', 90.0_wp, period_ratio(90*degree) + 0.001_wp, 'left')
      call self%plot()

      call self%panel('amplitude <θ>_0  (degrees)', '', [90.0_wp, 0.1_wp], [0.9_wp, 5.6_wp], log='x', &
         cell=[2, 2, 1, 1], margin=48)
      call self%say('set xtics ("90" 90, "170" 10, "179" 1, "179.9" 0.1); set ytics 1, 1 ' // &
         'format "%g"')
      call self%caption('from 90 to 179.9 degrees')
      call add_curves(180 - 90*[(10.0_wp**(-i*log10(900.0_wp)/150), i=0, 150)], '', 4, &
         label='(2/π) <K>(<k>)')
      do n = 1, size(labels), 3
         call self%note(trim(labels(n)), 180 - highest, period_ratio_series(highest*degree, n), 'left', &
            pens(n))
      end do
      call self%plot()

   contains

      subroutine add_curves(amplitude, suffix, x_column, label)
         real(wp), intent(in) :: amplitude(:)
         character(len=*), intent(in) :: suffix
         integer, intent(in) :: x_column
         !> Of the exact curve
         character(len=*), intent(in), optional :: label

         do n = 1, size(names)
            call self%add(trim(names(n)) // suffix, amplitude, period_ratio_series(amplitude*degree, n), &
               more=reshape(180 - amplitude, [size(amplitude), 1]))
            call self%draw(pens(n), x_column=x_column)
         end do
         call self%add('exact' // suffix, amplitude, period_ratio(amplitude*degree), &
            more=reshape(180 - amplitude, [size(amplitude), 1]))
         call self%draw(black, label, style='lines lw 3', x_column=x_column)
      end subroutine add_curves

   end subroutine period_figure

end module furiko_figure_period
