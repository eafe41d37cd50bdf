! SPDX-License-Identifier: MIT

!> The error of K against work: the power series, the trapezoidal rule, the AGM.
module furiko_figure_converge
   use, intrinsic :: iso_fortran_env, only : wp => real64
   use furiko, only : agm_steps_mc, ellipk_mc, ellipk_series_m, ellipk_trapezoid_mc
   use furiko_figure, only : amplitude, figure, to_text
   implicit none
   private
   public :: converge_figure


   !> As far as the series goes
   integer, parameter :: most_work = 10000
   !> Errors below that are rounding: a point there ends a curve
   real(wp), parameter :: floor_error = epsilon(1.0_wp)/2


contains


   subroutine converge_figure(amplitudes, self)
      type(amplitude), intent(in) :: amplitudes(:)
      type(figure), intent(out) :: self
      integer :: i

      call self%begin('work', 'relative_error', '1,' // to_text(size(amplitudes)) // &
         ' margins left, right, bottom, top - 2*line spacing 0.06')
      call self%say('set logscale xy')
      call self%say('set format y "10^{%T}"')
      call self%say('set xrange [0.9:10000]')
      call self%say('set yrange [3e-17:10]')
      call self%say('set ytics 1e-16, 100, 1')
      call self%say('set xtics 100')
      call self%say('unset mytics')
      call self%say('set xlabel "terms, subintervals, steps"')
      call self%say('set ylabel "relative error of <K>" offset 1')
      do i = 1, size(amplitudes)
         if (i == size(amplitudes)) then
            call self%say('set key at graph 1, graph 1.02 right bottom samplen 4')
         end if
         call add_panel(amplitudes(i), self)
         call self%say('set format y ""')
         call self%say('unset ylabel')
      end do
      call self%say('unset multiplot')
   end subroutine converge_figure


   subroutine add_panel(amplitude_, self)
      type(amplitude), intent(in) :: amplitude_
      type(figure), intent(inout) :: self
      real(wp) :: exact, m, mc
      real(wp), dimension(12) :: a, b, c, k, e
      integer :: i

      ! Both exact: m = 1 - mc without rounding
      m = 1 - cos(amplitude_%radians/2)**2
      mc = 1 - m
      exact = ellipk_mc(mc)
      call add_method('power series', counts(), ellipk_series_m(m, counts()), &
         'lines lw 2 dt (12, 4) lc rgb "#D55E00"')
      call add_method('trapezoidal rule', counts(), ellipk_trapezoid_mc(mc, counts()), &
         'lines lw 2 dt (4, 3) lc rgb "#0072B2"')
      call agm_steps_mc(mc, a, b, c, k, e)
      call add_method('AGM', [(i, i=1, size(k) - 1)], k(2:), &
         'linespoints lw 2 pt 7 ps 0.5 lc rgb "#000000"')
      call self%say('set label 1 "<θ>_0 = ' // amplitude_%label // &
         '" at graph 0, 1 offset 0, 0.8 left')
      call self%plot()

   contains

      !> Add the curve of a method up to where it meets the rounding.
      subroutine add_method(name, n, values, look)
         character(len=*), intent(in) :: name
         integer, intent(in) :: n(:)
         real(wp), intent(in) :: values(:)
         character(len=*), intent(in) :: look
         real(wp) :: errors(size(values))
         integer :: last

         errors = max(abs(values/exact - 1), floor_error)
         last = 1
         do while (errors(last) > 2*floor_error .and. last < size(errors))
            last = last + 1
         end do
         call self%add(name // ' ' // amplitude_%label, real(n(:last), wp), errors(:last))
         call self%draw(look // ' title "' // name // '"')
      end subroutine add_method

   end subroutine add_panel


   !> 1, 2, 3, ..., 40, then about thirty to the decade.
   pure function counts() result(n)
      integer, allocatable :: n(:)
      integer :: i

      allocate(n(40))
      n = [(i, i=1, 40)]
      do while (n(size(n)) < most_work)
         n = [n, min(most_work, n(size(n)) + n(size(n))/13)]
      end do
   end function counts

end module furiko_figure_converge
