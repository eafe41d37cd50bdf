! SPDX-License-Identifier: MIT

!> How hard the rod is pulled on the way up, and where a string in its place goes slack.
module furiko_figure_tension
   use, intrinsic :: iso_fortran_env, only : wp => real64
   use furiko, only : motion, pendulum
   use furiko_figure, only : amplitude, black, blue, column, figure, fixed, orange, ramp, solid
   implicit none
   private
   public :: tension_figure


   real(wp), parameter :: degree = acos(-1.0_wp)/180


contains


   !> From the bottom to the turning point, a quarter of a period
   subroutine tension_figure(amplitudes, self)
      type(amplitude), intent(in) :: amplitudes(:)
      type(figure), intent(inout) :: self
      type(pendulum) :: body
      type(motion) :: path
      real(wp) :: slack, time(121)
      integer :: i

      call self%begin([column('angle_deg', 'angle in degrees'), &
         column('tension_over_weight', 'pull along the rod over the weight m g')], &
         'Pull along the rod against the angle, from the bottom to the turning point, for each ' // &
         'amplitude. At the bottom it is more than the weight. Above 90 degrees it falls below zero on ' // &
         'the way up, where a rod pushes and a string goes slack')
      call self%panel('angle <θ>  (degrees)', 'tension / weight', [0.0_wp, 180.0_wp], [-1.2_wp, 5.2_wp], &
         cell=[1, 1, 1, 1])
      call self%caption('from the bottom to the amplitudes that the curves bear')
      call self%say('set xtics 30; set ytics 1')
      do i = 1, size(amplitudes)
         path = body%swinging(amplitudes(i)%radians)
         slack = path%slack_angle()/degree
         ! NaN where it never does
         if (abs(slack) <= huge(slack)) then
            self%about = self%about // ', at ' // fixed(slack, 1) // ' degrees for ' // amplitudes(i)%label
            call self%add('slack of ' // amplitudes(i)%label, [slack], [0.0_wp])
            call self%draw(orange, 'slack at ' // fixed(slack, 1) // '°', style='points pt 6 lw 2 ps ' // &
               '1.2*scale')
         end if
         time = ramp(0.0_wp, path%period()/4, 120)
         call self%add('amplitude ' // amplitudes(i)%label, path%angle(time)/degree, path%tension(time))
         call self%draw(blue, amplitudes(i)%label, dash=merge(solid, orange, modulo(i, 2) == 1))
      end do
      self%about = self%about // '.'
      call self%add('zero', [0.0_wp, 180.0_wp], [0.0_wp, 0.0_wp])
      call self%draw(black, 'below 0 a rod pushes', style='lines lw 1')
      call self%plot()
   end subroutine tension_figure

end module furiko_figure_tension
