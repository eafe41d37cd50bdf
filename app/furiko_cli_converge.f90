! SPDX-License-Identifier: MIT

!> `furiko converge`: the notes' own ways to K side by side, in two words, so that what is printed is right.
module furiko_cli_converge
   use, intrinsic :: iso_fortran_env, only : int64, wp => real64
   use furiko_cli_io, only : finish
   use furiko_cli_options, only : command, command_line, demand, option
   use furiko_cli_quantity, only : no_unit, number_of, whole_of
   use furiko_cli_sheet, only : begin_sheet, column, format_option, places_of_words, powers, sheet, whole
   use furiko_word_arithmetic_dp, only : words, pi_words, mean_with_one, sin, sqrt, operator(+), &
      operator(-), operator(*), operator(/)
   implicit none
   private
   public :: converge_usage, series, trapezoid, agm


contains


   function converge_usage() result(usage)
      type(command) :: usage

      usage = command('converge', 'series, trapezoidal rule and AGM side by side', '', 0, &
         'K(k) by three ways side by side: the first n terms of its power series, the trapezoidal rule ' // &
         'with n intervals, n steps of the arithmetic-geometric mean. For n = 1 to N each has its value ' // &
         'and its relative error; csv and json also say how many digits are right, up to 28.', &
         example='furiko converge --k 1/2 --steps 8', options=[ &
         option('--k', 'K', '1/2', 'modulus, -1 < K < 1, as 0.5 or 1/2, taken exactly'), &
         option('--steps', 'N', '8', 'last n'), format_option], run=converge_command)
   end function converge_usage


   subroutine converge_command(line)
      type(command_line), intent(in) :: line
      type(column), parameter :: columns(10) = [column('n', whole, width=4), &
         column('series', places_of_words, 15, width=18), column('series_error', powers, 1, 3, 7, 'error'), &
         column('series_digits', whole, head='-'), &
         column('trapezoid', places_of_words, 15, width=18), column('trapezoid_error', powers, 1, 3, 7, &
            'error'), &
         column('trapezoid_digits', whole, head='-'), &
         column('agm', places_of_words, 15, width=18), column('agm_error', powers, 1, 3, 7, 'error'), &
         column('agm_digits', whole, head='-')]
      type(sheet) :: page
      type(words) :: errors(3), exact, k, m, mc, row(10), values(3)
      integer :: i, n, steps

      k = number_of(line%value('--k'), no_unit)
      m = k*k
      mc = (1.0_wp - k)*(1.0_wp + k)
      call demand(mc%hi > 0.0_wp, line%value('--k'), '-1 < k < 1')
      steps = whole_of(line%value('--steps'), 1, 10000)
      exact = agm(mc)
      page = begin_sheet(line, columns, rows=int(steps, int64))
      do n = 1, steps
         values = [series(m, n), trapezoid(m, mc, n), agm(mc, n)]
         row(1) = words(real(n, wp))
         do i = 1, 3
            errors(i) = values(i)/exact - 1.0_wp
            row(3*i - 1:3*i + 1) = [values(i), errors(i), words(digits_of(errors(i)%hi))]
         end do
         call page%row(row)
      end do
      call page%end()
      call finish()
   end subroutine converge_command


   !> The first n terms of pi/2 (1 + m/4 + 9 m^2/64 + ...), DLMF 19.5.1
   pure function series(m, n) result(integral)
      type(words), intent(in) :: m
      integer, intent(in) :: n
      type(words) :: integral
      type(words) :: factor, term
      integer :: i

      term = pi_words/2.0_wp
      integral = term
      do i = 1, n - 1
         factor = words(2*i - 1.0_wp)/(2.0_wp*i)
         term = term*(factor*factor*m)
         integral = integral + term
      end do
   end function series


   !> pi/(2n) times the sum of 1/sqrt(1 - m sin^2) = 1/sqrt(mc + m cos^2) at n + 1 angles, half the first
   !> and the last
   pure function trapezoid(m, mc, n) result(integral)
      type(words), intent(in) :: m
      type(words), intent(in) :: mc
      integer, intent(in) :: n
      type(words) :: integral
      type(words) :: cosine, step
      integer :: i

      step = pi_words/(2.0_wp*n)
      integral = (1.0_wp + 1.0_wp/sqrt(mc))/2.0_wp
      do i = 1, n - 1
         cosine = sin(real(i, wp)*step)
         integral = integral + 1.0_wp/sqrt(mc + m*cosine*cosine)
      end do
      integral = integral*step
   end function trapezoid


   !> pi/2 over the arithmetic-geometric mean of 1 and sqrt(mc), or over what n steps make of it, DLMF 19.8.5
   pure function agm(mc, n) result(integral)
      type(words), intent(in) :: mc
      integer, intent(in), optional :: n
      type(words) :: integral
      type(words) :: mean

      call mean_with_one(sqrt(mc), mean, steps=n)
      integral = pi_words/(2.0_wp*mean)
   end function agm


   !> How many decimal digits an error leaves, at most the 28 that are right here
   elemental function digits_of(error)
      real(wp), intent(in) :: error
      real(wp) :: digits_of

      digits_of = aint(min(28.0_wp, -log10(max(abs(error), tiny(error)))))
   end function digits_of

end module furiko_cli_converge
