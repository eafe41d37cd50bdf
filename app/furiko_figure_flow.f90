! SPDX-License-Identifier: MIT

!> The vector field of the pendulum, θ' and θ'' at every angle and rate.
module furiko_figure_flow
   use, intrinsic :: iso_fortran_env, only : wp => real64
   use furiko_figure, only : amplitude, blue, column, figure
   use furiko_figure_phase, only : add_separatrix, flow_at, mark_fixed_points
   implicit none
   private
   public :: flow_figure


   integer, parameter :: columns = 20, rows = 12


contains


   !> Angles and rates in the middle of equal cells; l = g = 1
   subroutine flow_figure(amplitudes, self)
      type(amplitude), intent(in) :: amplitudes(:)
      type(figure), intent(inout) :: self
      real(wp), dimension(columns*rows) :: angle, rate
      integer :: i, j

      associate (unused => amplitudes)
      end associate
      angle = [((-180 + 360*(i - 0.5_wp)/columns, i=1, columns), j=1, rows)]
      rate = [((-3 + 6*(j - 0.5_wp)/rows, i=1, columns), j=1, rows)]
      call self%begin([column('angle_deg', 'angle in degrees'), &
         column('rate_over_sqrt_g_by_l', 'angular rate over sqrt(g/l)'), &
         column('angle_rate_deg', 'change of the angle, degrees in a time of sqrt(l/g)'), &
         column('rate_rate', 'change of the rate in such a time, in the same units')], &
         'Arrows that tell where each angle and angular rate go next: round rest clockwise, along the ' // &
         'separatrix towards upright, above it to the right and below it to the left, over the top.')
      call self%panel('angle <θ>  (degrees)', 'angular rate  d<θ>/d<t> / √(<g>/<l>)', [-180.0_wp, &
         180.0_wp], &
         [-3.0_wp, 3.0_wp], cell=[1, 1, 1, 1])
      call self%say('set xtics 45; set ytics 1')
      call self%caption('dashed: the separatrix;  disc: rest;  rings: upright')
      call self%add('flow', angle, rate, more=flow_at(angle, rate))
      call self%field(blue)
      call add_separatrix(self, labelled=.false.)
      call mark_fixed_points(self, labelled=.false.)
      call self%plot()
   end subroutine flow_figure

end module furiko_figure_flow
