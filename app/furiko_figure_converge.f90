! SPDX-License-Identifier: MIT

!> The error of K against work: the power series, the trapezoidal rule, the AGM, in two words as `furiko
!> converge` computes them, so that the curves run through the rounding of a double and beyond.
module furiko_figure_converge
   use, intrinsic :: iso_fortran_env, only : wp => real64
   use furiko_cli_converge, only : agm, series, trapezoid
   use furiko_figure, only : amplitude, black, blue, column, figure, orange, to_text
   use furiko_word_arithmetic_dp, only : words, operator(-), operator(*), operator(/)
   implicit none
   private
   public :: converge_figure


   !> As far as the series goes
   integer, parameter :: most_work = 10000
   !> Half an ulp of a number next to 1: what a double cannot tell
   real(wp), parameter :: rounding = epsilon(1.0_wp)/2
   real(wp), parameter :: lowest = 1e-20_wp
   character(len=*), parameter :: names(*) = [character(len=16) :: 'power series', 'trapezoidal rule', 'AGM']
   character(len=*), parameter :: units(*) = [character(len=12) :: 'terms', 'subintervals', 'steps']
   character(len=*), parameter :: looks(*) = [character(len=36) :: 'lines lw 2 dt (9, 3)', &
      'lines lw 2 dt (4, 3)', 'linespoints lw 2 pt 7 ps 0.5*scale']
   integer, parameter :: pens(*) = [orange, blue, black]


contains


   subroutine converge_figure(amplitudes, self)
      type(amplitude), intent(in) :: amplitudes(:)
      type(figure), intent(inout) :: self
      integer :: i

      call self%begin([column('work', 'terms, subintervals or steps'), &
         column('relative_error', 'relative error of K')], &
         'Relative error of K against work, a panel for each amplitude. All digits of a double, errors ' // &
         'below 1.1e-16, are there after')
      do i = 1, size(amplitudes)
         if (i > 1) self%about = self%about // ', and after'
         call self%panel('terms, subintervals, steps', 'relative error of <K>', [0.9_wp, 1e4_wp], &
            [lowest, 10.0_wp], log='xy', cell=[i, size(amplitudes), 1, 1])
         call self%say('set xtics 10 format "10^{%T}"; set mxtics 10; set ytics 1e-20, 100 format ' // &
            '"10^{%T}"; unset mytics')
         call self%caption('<θ>_0 = ' // amplitudes(i)%label // ';  line: half an ulp')
         call add_methods(amplitudes(i), self)
         call self%add('rounding ' // amplitudes(i)%label, [0.9_wp, 1e4_wp], [rounding, rounding])
         call self%draw(black, '1.1·10^{−16}', style='lines lw 1')
         call self%plot()
      end do
      self%about = self%about // '.'
   end subroutine converge_figure


   !> The curve of each method, up to the first point below the rounding, and how much work that is
   subroutine add_methods(amplitude_, self)
      type(amplitude), intent(in) :: amplitude_
      type(figure), intent(inout) :: self
      type(words) :: exact, m, mc
      character(len=:), allocatable :: work
      integer, allocatable :: n(:)
      real(wp), allocatable :: errors(:)
      integer :: i

      ! A multiple of 2^-52, so that 1 - m has no rounding, fused or not
      m = words(scale(anint(scale(sin(amplitude_%radians/2)**2, 52)), -52))
      mc = words(1.0_wp - m%hi)
      exact = agm(mc)
      work = ''
      do i = 1, size(names)
         call follow(i, m, mc, exact, n, errors)
         work = to_text(n(size(n)))
         if (errors(size(n)) > rounding) work = 'more than ' // work
         self%about = self%about // trim(merge(' ', ',', i == 1)) // ' ' // work // ' ' // trim(units(i))
         call self%add(trim(names(i)) // ' ' // amplitude_%label, real(n, wp), errors)
         call self%draw(pens(i), trim(names(i)) // ': ' // work, style=trim(looks(i)))
      end do
      self%about = self%about // ' at ' // amplitude_%label
   end subroutine add_methods


   !> Errors of a method, for so many terms or steps as are drawn
   subroutine follow(method, m, mc, exact, n, errors)
      integer, intent(in) :: method
      type(words), intent(in) :: m
      type(words), intent(in) :: mc
      type(words), intent(in) :: exact
      integer, allocatable, intent(out) :: n(:)
      real(wp), allocatable, intent(out) :: errors(:)
      type(words) :: error
      integer :: next

      allocate(n(0), errors(0))
      next = 1
      do
         select case (method)
         case (1)
            error = series(m, next)/exact - 1.0_wp
         case (2)
            error = trapezoid(m, mc, next)/exact - 1.0_wp
         case default
            error = agm(mc, next)/exact - 1.0_wp
         end select
         n = [n, next]
         errors = [errors, max(abs(error%hi), lowest/10)]
         if (abs(error%hi) <= rounding .or. next == most_work) exit
         next = min(most_work, next + max(1, next/64))
      end do
   end subroutine follow

end module furiko_figure_converge
