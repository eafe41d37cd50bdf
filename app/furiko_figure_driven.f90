! SPDX-License-Identifier: MIT

!> A pendulum with friction and a drive, θ'' = −sin θ − θ'/2 + a cos(2t/3), of Baker and Gollub
!> (Chaotic Dynamics, 1990): orbits that close and one that does not, and the section of the latter.
!>
!> Neighbours on the chaotic orbit are on average 2.9 times as far apart after each period of the drive. So
!> few periods of it are drawn, of one start or of many, that what rounding adds stays far below a pixel.
!> Across the attractor, what is left of a start falls by exp(-5.8) in a period.
module furiko_figure_driven
   use, intrinsic :: iso_fortran_env, only : int64, wp => real64
   use furiko, only : driven_orbit, driven_pendulum, driven_periods, driven_rk4, driven_section, driven_state
   use furiko_cli_store, only : store
   use furiko_figure, only : amplitude, black, blue, broken, column, figure, fixed, orange, solid
   use furiko_figure_density, only : add_density, angle_range
   use furiko_figure_table, only : extent_of, longest_name, padded, read_table
   implicit none
   private
   public :: driven_figure, poincare_figure


   real(wp), parameter :: pi = acos(-1.0_wp)
   real(wp), parameter :: degree = pi/180
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
      type(driven_state) :: state(1), states(periods*steps/every)
      real(wp), dimension(size(states)) :: angle, rate

      call self%panel('angle <θ>  (degrees)', 'd<θ>/d<t>', &
         [-180.0_wp, 180.0_wp], [-3.0_wp, 3.0_wp], cell=[cell, 3, 1, 1])
      call self%say('set xtics 180; set ytics 1')
      call self%caption('<a> = ' // fixed(drive, 2) // ': ' // caption)
      state = driven_state(angle=0.2_wp)
      call driven_periods(driven_rk4(steps), [driven_by(drive)], state, forgotten)
      call driven_orbit(driven_rk4(steps), driven_by(drive), state(1), every, states)
      angle = states%angle/degree
      rate = states%rate
      call self%add('orbit of a = ' // fixed(drive, 2), broken(angle, angle, 180.0_wp), &
         broken(rate, angle, 180.0_wp))
      call self%draw(blue, dash=solid)
      call self%add('periods of a = ' // fixed(drive, 2), angle(steps/every::steps/every), &
         rate(steps/every::steps/every))
      call self%draw(orange, style='points pt 7 ps 0.7*scale')
      call self%plot()
   end subroutine add_orbit


   !> Many starts, a few periods each: once the friction has brought them there, all are on the attractor.
   subroutine poincare_figure(amplitudes, self)
      type(amplitude), intent(in) :: amplitudes(:)
      type(figure), intent(inout) :: self
      integer, parameter :: starts = 400, forgotten = 5, kept = 3
      type(driven_state) :: state(starts), points(kept, starts)
      real(wp), dimension(kept, starts) :: angle, rate
      integer :: i

      associate (unused => amplitudes)
      end associate
      if (self%from /= '') then
         call section_figure(self)
         return
      end if
      state = [(driven_state(angle=-pi + 2*pi*i/starts), i=1, starts)]
      call driven_section(driven_rk4(steps), spread(driven_by(chaotic), 1, starts), state, forgotten, points)
      angle = points%angle/degree
      rate = points%rate
      call begin_driven(self, 'Angle and angular rate of a chaotic driven pendulum at the beginning of ' // &
         'periods of the drive: 1200 points that lie on thin layers, folded into each other, the ' // &
         'strange attractor.')
      call self%panel('angle <θ>  (degrees)', 'angular rate  d<θ>/d<t> / √(<g>/<l>)', [-180.0_wp, &
         180.0_wp], &
         [-0.5_wp, 3.0_wp], cell=[1, 1, 1, 1])
      call self%say('set xtics 45; set ytics 1')
      call self%caption('d^2<θ>/d<t>^2 = −sin <θ> − 0.5 d<θ>/d<t> + 1.5 cos(2<t>/3), once a ' // &
         'period of the drive')
      call self%add('section', pack(angle, .true.), pack(rate, .true.))
      call self%draw(black, style='points pt 7 ps 0.25*scale')
      call self%plot()
   end subroutine poincare_figure


   !> The section of a file: the density of its points
   subroutine section_figure(self)
      type(figure), intent(inout) :: self
      type(store) :: rows
      character(len=longest_name) :: ignored
      real(wp) :: extent(2, 2), angles(2), rates(2)
      integer(int64) :: changes

      call read_table(self%from, [character(len=9) :: 'angle_rad', 'rate'], 2, rows, ignored)
      call extent_of(rows, extent, changes)
      angles = angle_range(extent(:, 1)/degree)
      rates = padded(extent(:, 2), 0.01_wp)
      call self%begin([column('angle_deg', 'angle in degrees, -180 to 180'), &
         column('rate_over_sqrt_g_by_l', 'angular rate over sqrt(g/l)'), &
         column('points', 'points of the section in the cell'), &
         column('shade', 'up to 100 for the fullest cells, 0 for none')], &
         'Angle and angular rate of driven pendulums at the beginning of periods of the drive, darker ' // &
         'where they come by more often. Of a chaotic one the points lie on thin layers, ' // &
         'folded into each other.')
      call self%panel('angle <θ>  (degrees)', 'angular rate  d<θ>/d<t> / √(<g>/<l>)', angles, rates, &
         cell=[1, 1, 1, 1])
      if (angles(2) - angles(1) > 359) call self%say('set xtics 45')
      call add_density(self, rows, [degree, 1.0_wp], angles, rates, self%pixels(), by_column=.false.)
      call self%plot()
   end subroutine section_figure


   elemental function driven_by(drive) result(pendulum)
      real(wp), intent(in) :: drive
      type(driven_pendulum) :: pendulum

      pendulum = driven_pendulum(damping=0.5_wp, amplitude=drive, frequency=2.0_wp/3.0_wp)
   end function driven_by

end module furiko_figure_driven
