! SPDX-License-Identifier: MIT

!> The phase portrait: librations, the separatrix and rotations, coloured by energy.
module furiko_figure_phase
   use, intrinsic :: iso_fortran_env, only : wp => real64
   use furiko_figure, only : amplitude, figure, fixed, ramp, to_text
   implicit none
   private
   public :: phase_figure


   real(wp), parameter :: pi = acos(-1.0_wp)
   real(wp), parameter :: degree = pi/180
   !> Energies of the rotations over m g l, from rest; the separatrix has 2
   real(wp), parameter :: rotations(*) = [2.5_wp, 3.25_wp, 4.0_wp]


contains


   subroutine phase_figure(amplitudes, self)
      type(amplitude), intent(in) :: amplitudes(:)
      type(figure), intent(out) :: self
      integer :: i

      call self%begin('angle_deg', 'rate_over_sqrt_g_by_l')
      do i = 1, size(amplitudes)
         call add_libration(amplitudes(i), self)
      end do
      do i = 1, size(rotations)
         call add_rotation('rotation', rotations(i), 1.0_wp, self)
         call add_rotation('rotation', rotations(i), -1.0_wp, self)
      end do
      call add_rotation('separatrix', 2.0_wp, 1.0_wp, self)
      call add_rotation('separatrix', 2.0_wp, -1.0_wp, self)

      call self%say('set xlabel "angle <θ>  (degrees)"')
      call self%say('set ylabel "angular rate  d<θ>/d<t> / √(<g>/<l>)"')
      call self%say('set cblabel "energy above rest  <E>/(<mgl>)" offset 0.5')
      call self%say('set xrange [-360:360]')
      call self%say('set yrange [-3.1:3.1]')
      call self%say('set cbrange [0:4]')
      call self%say('set xtics 90')
      call self%say('set ytics 1')
      call self%say('set cbtics 1')
      call self%say('set palette maxcolors 64')
      ! Viridis as far as it stands out against white: lightness rises with the energy
      call self%say('set palette defined (0 "#440154", 1 "#3b528b", 2 "#21808c", ' // &
         '3 "#35a56b", 4 "#8fbf3a")')
      call self%say('set style textbox opaque noborder margins 0.5, 0.2')
      call self%say('set label "libration" at 0, 0 center boxed front')
      call self%say('set label "rotation →" at 0, 2.67 center boxed front')
      call self%say('set label "← rotation" at 0, -2.67 center boxed front')
      call self%say('set label "separatrix" at 114, 1.35 left boxed front')
      call self%plot()
   end subroutine phase_figure


   !> sin(θ/2) = k sin(φ) and θ' = 2 k cos(φ) sqrt(g/l) go round the ellipse of one energy, 2 k^2.
   subroutine add_libration(amplitude_, self)
      type(amplitude), intent(in) :: amplitude_
      type(figure), intent(inout) :: self
      character(len=*), parameter :: cells(*) = [character(len=8) :: '2', '($2-360)', '($2+360)']
      real(wp) :: phi(121)
      real(wp) :: k
      integer :: i

      phi = ramp(0.0_wp, 2*pi, 120)
      k = sin(amplitude_%radians/2)
      call self%add('libration to ' // amplitude_%label, 2*asin(k*sin(phi))/degree, 2*k*cos(phi))
      do i = 1, size(cells)
         call self%draw(colour_of(2*k**2), trim(cells(i)))
      end do
   end subroutine add_libration


   !> θ' = ±sqrt(2 E - 4 sin^2(θ/2)) sqrt(g/l) for E of at least 2
   subroutine add_rotation(name, energy, sign, self)
      character(len=*), intent(in) :: name
      real(wp), intent(in) :: energy
      real(wp), intent(in) :: sign
      type(figure), intent(inout) :: self
      real(wp) :: angle(145)

      angle = ramp(-360.0_wp, 360.0_wp, 144)
      call self%add(name // ' of E/(mgl) ' // fixed(energy, 2), angle, &
         sign*sqrt((2*energy - 4) + 4*cos(angle*degree/2)**2))
      if (name == 'separatrix') then
         call self%draw('lines lw 2.5 dt (10, 5) lc rgb "#000000"')
      else
         call self%draw(colour_of(energy))
      end if
   end subroutine add_rotation


   pure function colour_of(energy) result(look)
      real(wp), intent(in) :: energy
      character(len=:), allocatable :: look

      look = 'lines lw 2 lc palette cb ' // to_text(energy)
   end function colour_of

end module furiko_figure_phase
