! SPDX-License-Identifier: MIT

!> The phase portrait: librations, the separatrix and rotations.
module furiko_figure_phase
   use, intrinsic :: iso_fortran_env, only : wp => real64
   use furiko_figure, only : amplitude, black, blue, column, figure, fixed, orange, ramp, solid
   implicit none
   private
   public :: phase_figure, add_separatrix, flow_at, mark_fixed_points


   real(wp), parameter :: pi = acos(-1.0_wp)
   real(wp), parameter :: degree = pi/180
   !> Energies of the rotations over m g l, from rest at the bottom; the separatrix has 2
   real(wp), parameter :: rotations(*) = [3.0_wp, 4.5_wp]


contains


   subroutine phase_figure(amplitudes, self)
      type(amplitude), intent(in) :: amplitudes(:)
      type(figure), intent(inout) :: self
      real(wp) :: angle(145)
      integer :: i

      call self%begin([column('angle_deg', 'angle in degrees'), &
         column('rate_over_sqrt_g_by_l', 'angular rate over sqrt(g/l)')], &
         'Angle against angular rate. Closed curves round rest at 0 degrees are swings to and fro, each ' // &
         'to its amplitude. The separatrix runs from upright to upright, at -180 and 180 degrees. Open ' // &
         'curves above and below it are rotations over the top.')
      call self%panel('angle <θ>  (degrees)', 'angular rate  d<θ>/d<t> / √(<g>/<l>)', &
         [-180.0_wp, 180.0_wp], [-3.4_wp, 3.4_wp])
      call self%say('set xtics 45; set ytics 1')
      ! Below the curves: an orbit of a degree is smaller than the disc
      call mark_fixed_points(self, labelled=.true.)
      call add_separatrix(self, labelled=.true.)
      do i = 1, size(amplitudes)
         call add_libration(amplitudes(i), self)
      end do
      angle = ramp(-180.0_wp, 180.0_wp, 144)
      do i = 1, size(rotations)
         associate (rate => sqrt(2*rotations(i) - 4*sin(angle*degree/2)**2))
            call add_rotation(rotations(i), angle, rate, 'to the right', self)
            call add_rotation(rotations(i), angle(145:1:-1), -rate, 'to the left', self)
         end associate
      end do
      call self%plot()
   end subroutine phase_figure


   !> sin(θ/2) = k sin(φ) and θ' = 2 k cos(φ) sqrt(g/l) go round the ellipse of one energy, 2 k^2.
   subroutine add_libration(amplitude_, self)
      type(amplitude), intent(in) :: amplitude_
      type(figure), intent(inout) :: self
      real(wp) :: phi(121)
      real(wp) :: k

      phi = ramp(0.0_wp, 2*pi, 120)
      k = sin(amplitude_%radians/2)
      call self%add('libration to ' // amplitude_%label, 2*asin(k*sin(phi))/degree, 2*k*cos(phi))
      call self%draw(blue, amplitude_%label, dash=solid, side=4)
      call self%head(1)
   end subroutine add_libration


   !> θ' = ±sqrt(2 E - 4 sin^2(θ/2)) sqrt(g/l) for E beyond 2
   subroutine add_rotation(energy, angle, rate, way, self)
      real(wp), intent(in) :: energy
      real(wp), intent(in) :: angle(:)
      real(wp), intent(in) :: rate(:)
      character(len=*), intent(in) :: way
      type(figure), intent(inout) :: self

      call self%add('rotation ' // way // ' of E/(mgl) ' // fixed(energy, 1), angle, rate)
      if (way == 'to the right') then
         call self%draw(orange, '<E> = ' // fixed(energy, 1) // ' <mgl>', dash=solid)
      else
         call self%draw(orange, dash=solid)
      end if
      call self%head(size(angle)/2)
   end subroutine add_rotation


   !> θ' = ±2 cos(θ/2) sqrt(g/l), round the whole of it
   subroutine add_separatrix(self, labelled)
      type(figure), intent(inout) :: self
      logical, intent(in) :: labelled
      real(wp) :: angle(145), angles(289), rates(289)

      angle = ramp(-180.0_wp, 180.0_wp, 144)
      angles = [angle, angle(144:1:-1)]
      rates = 2*cos(angles*degree/2)*[spread(1, 1, 145), spread(-1, 1, 144)]
      if (size(self%columns) == 4) then
         call self%add('separatrix', angles, rates, more=flow_at(angles, rates))
      else
         call self%add('separatrix', angles, rates)
      end if
      call self%draw(black, trim(merge('separatrix', '          ', labelled)), style='lines lw 2.5 dt ' // &
         '(10, 5)')
      call self%head(110)
      call self%head(255)
   end subroutine add_separatrix


   !> The changes of angle in degrees and rate in a time of sqrt(l/g), a row for each point
   pure function flow_at(angle, rate) result(flow)
      real(wp), intent(in) :: angle(:)
      real(wp), intent(in) :: rate(:)
      real(wp) :: flow(size(angle), 2)

      flow(:, 1) = rate/degree
      flow(:, 2) = -sin(angle*degree)
   end function flow_at


   !> A disc where rest is stable, rings where it is not
   subroutine mark_fixed_points(self, labelled)
      type(figure), intent(inout) :: self
      logical, intent(in) :: labelled

      call self%add('stable rest', [0.0_wp], [0.0_wp])
      call self%draw(black, trim(merge('rest', '    ', labelled)), style='points pt 7 ps 0.8*scale')
      call self%add('unstable rest', [-180.0_wp, 180.0_wp], [0.0_wp, 0.0_wp])
      if (labelled) call self%note('upright', 180.0_wp, 0.95_wp, 'right')
      call self%draw(black, style='points pt 6 lw 2 ps ' // &
         '1.2*scale')
   end subroutine mark_fixed_points

end module furiko_figure_phase
