! SPDX-License-Identifier: MIT

!> What a book on elliptic functions shows first: sn, cn, dn, am; K and E, F and E; sn over u and m.
module furiko_figure_functions
   use, intrinsic :: iso_fortran_env, only : wp => real64
   use furiko, only : ellipe_mc, ellipeinc_m, ellipf_m, ellipk_mc, jacobi_am_m, jacobi_cn_m, jacobi_dn_m, &
      jacobi_sn_m
   use furiko_figure, only : amplitude, black, blue, column, figure, fixed, green, line_break, orange, ramp
   implicit none
   private
   public :: functions_figure, integrals_figure, surface_figure


   real(wp), parameter :: half_pi = acos(-1.0_wp)/2
   real(wp), parameter :: degree = half_pi/90
   real(wp), parameter :: parameters(*) = [0.0_wp, 0.5_wp, 0.9_wp, 0.99_wp]
   character(len=*), parameter :: labels(*) = [character(len=10) :: '<m> = 0', '0.5', '0.9', '0.99']
   integer, parameter :: pens(*) = [black, blue, orange, green]
   !> Where the axis of u ends
   real(wp), parameter :: last = 12.0_wp


contains


   subroutine functions_figure(amplitudes, self)
      type(amplitude), intent(in) :: amplitudes(:)
      type(figure), intent(inout) :: self
      real(wp) :: u(241)
      integer :: i

      associate (unused => amplitudes)
      end associate
      u = ramp(0.0_wp, last, 240)
      call self%begin([column('u', 'argument'), column('value', 'sn, cn, dn; am in units of pi/2')], &
         'The Jacobi functions sn, cn, dn and the amplitude am against u for m = 0, 0.5, 0.9 and 0.99. ' // &
         'At m = 0 they are sine, cosine, 1 and u itself. As m rises their waves become longer and ' // &
         'flatter, and the amplitude becomes a staircase.')
      call open_panel('sn(<u>, <m>)', [-1.1_wp, 1.1_wp], [1, 2, 1, 2])
      do i = 1, size(parameters)
         call one('sn', jacobi_sn_m(u, parameters(i)))
      end do
      call self%plot()
      call open_panel('cn(<u>, <m>)', [-1.1_wp, 1.1_wp], [2, 2, 1, 2])
      do i = 1, size(parameters)
         call one('cn', jacobi_cn_m(u, parameters(i)))
      end do
      call self%plot()
      call open_panel('dn(<u>, <m>)', [0.0_wp, 1.1_wp], [1, 2, 2, 2])
      do i = 1, size(parameters)
         call one('dn', jacobi_dn_m(u, parameters(i)))
      end do
      call self%plot()
      call open_panel('am(<u>, <m>) / (π/2)', [0.0_wp, 8.0_wp], [2, 2, 2, 2])
      do i = 1, size(parameters)
         call one('am', jacobi_am_m(u, parameters(i))/half_pi)
      end do
      call self%plot()

   contains

      subroutine open_panel(caption, range, cell)
         character(len=*), intent(in) :: caption
         real(wp), intent(in) :: range(2)
         integer, intent(in) :: cell(4)

         call self%panel(trim(merge('argument <u>', '            ', cell(3) == 2)), '', [0.0_wp, last], &
            range, &
            cell=cell)
         call self%say('set xtics 2; set ytics ' // trim(merge('2  ', '0.5', range(2) > 2)))
         call self%caption(caption)
      end subroutine open_panel

      subroutine one(name, value)
         character(len=*), intent(in) :: name
         real(wp), intent(in) :: value(:)

         call self%add(name // ' of m = ' // fixed(parameters(i), 2), u, value)
         call self%draw(pens(i), trim(labels(i)))
      end subroutine one

   end subroutine functions_figure


   subroutine integrals_figure(amplitudes, self)
      type(amplitude), intent(in) :: amplitudes(:)
      type(figure), intent(inout) :: self
      real(wp) :: m(121), mc(121), phi(91)
      integer :: i

      associate (unused => amplitudes)
      end associate
      ! Closer together towards both ends
      m = sin(ramp(0.02_wp, half_pi - 0.02_wp, 120))**2
      mc = cos(ramp(0.02_wp, half_pi - 0.02_wp, 120))**2
      phi = ramp(0.0_wp, 180.0_wp, 90)
      call self%begin([column('m_or_phi_deg', 'parameter m, or angle in degrees'), column('value', &
         'integral')], &
         'On the left the complete integrals K and E against m, and their complements, which are K and ' // &
         'E of 1 - m: K grows without bound as m goes to 1, E falls from pi/2 to 1. On the right the ' // &
         'incomplete integrals F and E against the angle, up to 180 degrees, for m = 0, 0.5 and 0.99.')
      call self%panel('parameter <m>', '', [0.0_wp, 1.0_wp], [0.8_wp, 4.0_wp], cell=[1, 2, 1, 1])
      call self%say('set xtics 0.2; set ytics 1, 0.5')
      call self%caption('complete integrals')
      call self%add('K', m, ellipk_mc(mc))
      call self%draw(black, '<K>(<m>)')
      call self%add('E', m, ellipe_mc(mc))
      call self%draw(blue, '<E>(<m>)')
      call self%add('complement of K', m, ellipk_mc(m))
      call self%draw(orange, '<K>′ = <K>(1 − <m>)')
      call self%add('complement of E', m, ellipe_mc(m))
      call self%draw(green, '<E>′ = <E>(1 − <m>)')
      call self%plot()

      call self%panel('', '', [0.0_wp, 180.0_wp], [0.0_wp, 7.5_wp], cell=[2, 2, 1, 2])
      call self%say('set xtics 45; set ytics 2')
      call self%caption('<F>(<φ>, <m>)')
      do i = 1, size(parameters)
         if (i == 3) cycle
         call self%add('F of m = ' // fixed(parameters(i), 2), phi, ellipf_m(phi*degree, parameters(i)))
         call self%draw(pens(i), trim(labels(i)))
      end do
      call self%plot()
      call self%panel('angle <φ>  (degrees)', '', [0.0_wp, 180.0_wp], [0.0_wp, 3.2_wp], cell=[2, 2, 2, 2])
      call self%say('set xtics 45; set ytics 1')
      call self%caption('<E>(<φ>, <m>)')
      do i = 1, size(parameters)
         if (i == 3) cycle
         call self%add('E of m = ' // fixed(parameters(i), 2), phi, ellipeinc_m(phi*degree, parameters(i)))
         call self%draw(pens(i), trim(labels(i)))
      end do
      call self%plot()
   end subroutine integrals_figure


   !> A grid in space: a row of points for each m
   subroutine surface_figure(amplitudes, self)
      type(amplitude), intent(in) :: amplitudes(:)
      type(figure), intent(inout) :: self
      integer, parameter :: rows = 13, row = 44
      real(wp) :: m(rows*row), u(rows*row)
      integer :: i

      associate (unused => amplitudes)
      end associate
      do i = 1, rows
         u((i - 1)*row + 1:i*row) = [ramp(0.0_wp, last, row - 2), line_break()]
         m((i - 1)*row + 1:i*row) = 1 - (1 - (i - 1.0_wp)/(rows - 1))**2
      end do
      call self%begin([column('u', 'argument'), column('m', 'parameter'), column('sn', 'sn(u, m)')], &
         'The surface sn(u, m) over u from 0 to 12 and m from 0 to 1: in front, at m = 0, a sine; the ' // &
         'waves grow longer and flatter as m rises, until at m = 1 only one step, tanh u, is left.')
      call self%add('sn', u, m, more=reshape(jacobi_sn_m(merge(0.0_wp, u, u > last), m), [rows*row, 1]))
      call self%space('argument <u>', 'parameter <m>', 'sn(<u>, <m>)')
   end subroutine surface_figure

end module furiko_figure_functions
