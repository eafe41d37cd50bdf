! SPDX-License-Identifier: MIT

!> A pendulum with friction and a drive, θ'' = −sin θ − θ'/2 + a cos(2t/3), of Baker and Gollub
!> (Chaotic Dynamics, 1990): orbits that close and one that does not, and the section of the latter.
!>
!> Neighbours on the chaotic orbit are on average 2.9 times as far apart after each period of the drive. So
!> few periods of it are drawn, of one start or of many, that what rounding adds stays far below a pixel.
!> Across the attractor, what is left of a start falls by exp(-5.8) in a period.
module furiko_figure_driven
   use, intrinsic :: iso_fortran_env, only : wp => real64
   use furiko, only : rk4
   use furiko_figure, only : amplitude, black, blue, broken, column, figure, fixed, orange, solid
   use furiko_pendulum_rates_dp, only : driven_pendulum_rates
   implicit none
   private
   public :: driven_figure, poincare_figure


   real(wp), parameter :: pi = acos(-1.0_wp)
   real(wp), parameter :: degree = pi/180
   real(wp), parameter :: friction = 0.5_wp, nu = 2.0_wp/3.0_wp
   real(wp), parameter :: period = 2*pi/nu
   !> An error of 1e-6 in a period, on either side of chaos
   integer, parameter :: steps = 240
   real(wp), parameter :: chaotic = 1.5_wp


contains


   subroutine driven_figure(amplitudes, self)
      type(amplitude), intent(in) :: amplitudes(:)
      type(figure), intent(inout) :: self

      associate (unused => amplitudes)
      end associate
      call begin_driven(self, 'Orbits of a pendulum with friction and a drive, angle against angular ' // &
         'rate, after the start is forgotten. Driven by 0.9 the orbit closes after one period of the ' // &
         'drive, by 1.07 after two; by 1.5 it never closes, here for six periods. Discs mark the ' // &
         'beginning of each period.')
      call add_orbit(0.9_wp, 'one period', 80, 1, 1, self)
      call add_orbit(1.07_wp, 'two periods', 80, 2, 2, self)
      call add_orbit(chaotic, 'chaos', 6, 6, 3, self)
   end subroutine driven_figure


   subroutine begin_driven(self, about)
      type(figure), intent(inout) :: self
      character(len=*), intent(in) :: about

      call self%begin([column('angle_deg', 'angle in degrees, -180 to 180'), &
         column('rate_over_sqrt_g_by_l', 'angular rate over sqrt(g/l)')], about)
   end subroutine begin_driven


   !> A panel: the orbit, and its points at the beginning of each period
   subroutine add_orbit(drive, caption, forgotten, periods, cell, self)
      real(wp), intent(in) :: drive
      character(len=*), intent(in) :: caption
      !> Periods of the drive before those that are drawn
      integer, intent(in) :: forgotten
      integer, intent(in) :: periods
      integer, intent(in) :: cell
      type(figure), intent(inout) :: self
      integer, parameter :: every = 2
      real(wp) :: state(2), states(2, periods*steps/every)

      call self%panel('angle <θ>  (degrees)', 'd<θ>/d<t>', &
         [-180.0_wp, 180.0_wp], [-3.0_wp, 3.0_wp], cell=[cell, 3, 1, 1])
      call self%say('set xtics 180; set ytics 1')
      call self%caption('<a> = ' // fixed(drive, 2) // ': ' // caption)
      state = [0.2_wp, 0.0_wp]
      call follow(drive, steps*forgotten, state)
      call rk4(driven_pendulum_rates, [1.0_wp, friction, 0.0_wp, drive, nu], 0.0_wp, period/steps, &
         every, state, &
         states)
      associate (angle => wrapped(states(1, :)), rate => states(2, :))
         call self%add('orbit of a = ' // fixed(drive, 2), broken(angle, angle, 180.0_wp), &
            broken(rate, angle, 180.0_wp))
         call self%draw(blue, dash=solid)
         call self%add('periods of a = ' // fixed(drive, 2), angle(steps/every::steps/every), &
            rate(steps/every::steps/every))
         call self%draw(orange, style='points pt 7 ps 0.7*scale')
      end associate
      call self%plot()
   end subroutine add_orbit


   !> Many starts, a few periods each: once the friction has brought them there, all are on the attractor.
   subroutine poincare_figure(amplitudes, self)
      type(amplitude), intent(in) :: amplitudes(:)
      type(figure), intent(inout) :: self
      integer, parameter :: starts = 400, forgotten = 5, kept = 3
      real(wp), dimension(starts*kept) :: angle, rate
      real(wp) :: state(2)
      integer :: i, j

      associate (unused => amplitudes)
      end associate
      do i = 1, starts
         state = [-pi + 2*pi*i/starts, 0.0_wp]
         call follow(chaotic, steps*forgotten, state)
         do j = 1, kept
            call follow(chaotic, steps, state)
            angle((i - 1)*kept + j) = wrapped(state(1))
            rate((i - 1)*kept + j) = state(2)
         end do
      end do
      call begin_driven(self, 'Angle and angular rate of a chaotic driven pendulum at the beginning of ' // &
         'periods of the drive: 1200 points that lie on thin layers, folded into each other, the ' // &
         'strange attractor.')
      call self%panel('angle <θ>  (degrees)', 'angular rate  d<θ>/d<t> / √(<g>/<l>)', [-180.0_wp, &
         180.0_wp], &
         [-0.5_wp, 3.0_wp], cell=[1, 1, 1, 1])
      call self%say('set xtics 45; set ytics 1')
      call self%caption('d^2<θ>/d<t>^2 = −sin <θ> − 0.5 d<θ>/d<t> + 1.5 cos(2<t>/3), once a ' // &
         'period of the drive')
      call self%add('section', angle, rate)
      call self%draw(black, style='points pt 7 ps 0.25*scale')
      call self%plot()
   end subroutine poincare_figure


   !> So many steps, from the beginning of a period of the drive
   subroutine follow(drive, count, state)
      real(wp), intent(in) :: drive
      integer, intent(in) :: count
      real(wp), intent(inout) :: state(2)

      call rk4(driven_pendulum_rates, [1.0_wp, friction, 0.0_wp, drive, nu], 0.0_wp, period/steps, &
         count, state)
   end subroutine follow


   !> An angle in degrees, within half a turn
   elemental function wrapped(angle) result(degrees)
      real(wp), intent(in) :: angle
      real(wp) :: degrees

      degrees = (angle - 2*pi*anint(angle/(2*pi)))/degree
   end function wrapped

end module furiko_figure_driven
