! SPDX-License-Identifier: MIT

!> `furiko period`, `furiko amplitude` and `furiko drift`: how long a swing takes, and its inverse.
module furiko_cli_period
   use, intrinsic :: iso_fortran_env, only : wp => real64
   use furiko, only : amplitude_of_excess, amplitude_three_terms, period_excess, period_ratio_series
   use furiko_cli_io, only : finish, put
   use furiko_cli_options, only : command, command_line, demand, option, word
   use furiko_cli_pendulum, only : amplitude_of, gravity_of, gravity_option, length_of, length_option
   use furiko_cli_quantity, only : in_degrees, number_of, pure_number, whole_of
   use furiko_cli_sheet, only : begin_sheet, column, digits, format_option, places_of_words, sheet
   use furiko_period_degrees, only : period_ratio_degrees
   use furiko_word_arithmetic_dp, only : words, pi_words, sqrt, operator(+), operator(-), &
      operator(*), operator(/)
   implicit none
   private
   public :: period_usage, amplitude_usage, drift_usage


contains


   function period_usage() result(usage)
      type(command) :: usage

      usage = command('period', 'the period for an amplitude', 'A [A ...]', huge(1), &
         'The period of a pendulum of amplitude A (degrees, or as 1rad; below 180): a row for each with ' // &
         'A in degrees, T in seconds, T/T_h, and how much that is above 1 in percent, T_h being the ' // &
         'period of small swings.', &
         example='furiko period 45 90deg 1rad --terms 3', options=[ &
         option('--terms', 'N', '', 'a further column: T/T_h by the first N terms of its series'), &
         length_option, gravity_option, format_option], run=period_command)
   end function period_usage


   subroutine period_command(line)
      type(command_line), intent(in) :: line
      type(column), parameter :: columns(5) = [column('amplitude_deg', places_of_words, 9, 12), &
         column('period_s', digits, 12, 15, 15), column('period_ratio', places_of_words, 15, width=19), &
         column('slower_percent', digits, 12, width=16), column('series', digits, 11, 12, 14)]
      type(sheet) :: page
      type(words) :: amplitudes(size(line%operands)), row(5), small_period
      integer :: i, last, terms

      if (size(line%operands) == 0) call line%reject('name an amplitude, as 90deg or 1rad')
      last = merge(5, 4, line%given('--terms'))
      terms = 1
      if (line%given('--terms')) terms = whole_of(line%value('--terms'), 1, 1000000)
      small_period = small_period_of(line)
      do i = 1, size(line%operands)
         amplitudes(i) = amplitude_of(line%operands(i))
      end do
      page = begin_sheet(line, columns(:last))
      do i = 1, size(line%operands)
         row(1) = in_degrees(amplitudes(i))
         row(3) = period_ratio_degrees(row(1))
         row(2) = small_period*row(3)
         row(4) = 100.0_wp*excess_of(amplitudes(i))
         row(5) = words(period_ratio_series(amplitudes(i)%hi, terms))
         call page%row(row(:last))
      end do
      call page%end()
      call finish()
   end subroutine period_command


   !> 2 pi sqrt(l/g)
   function small_period_of(line) result(period)
      type(command_line), intent(in) :: line
      type(words) :: period

      period = 2.0_wp*pi_words*sqrt(length_of(line)/gravity_of(line))
   end function small_period_of


   !> By how much the period is above that of small swings: a double's worth of digits
   function excess_of(amplitude) result(excess)
      type(words), intent(in) :: amplitude
      type(words) :: excess

      excess = period_ratio_degrees(in_degrees(amplitude)) - 1.0_wp
      if (excess%hi < 0.5_wp) excess = words(period_excess(amplitude%hi))
   end function excess_of


   function amplitude_usage() result(usage)
      type(command) :: usage

      usage = command('amplitude', 'the amplitude for a period: where a pendulum is 3 % slow', '', 0, &
         'The amplitude at which a pendulum is slower than for small swings by the part P of its period ' // &
         '(3%, 0.03, 1e-15 or 1000), in degrees and radians; and what three terms of the series for the ' // &
         'period give (nan where they reach no such period).', &
         example='furiko amplitude --slower 3%', options=[ &
         option('--slower', 'P', '', 'a part of the period, above 0'), format_option], run=amplitude_command)
   end function amplitude_usage


   subroutine amplitude_command(line)
      type(command_line), intent(in) :: line
      type(sheet) :: page
      type(words) :: amplitude, slower, three_terms
      type(word) :: form

      if (.not. line%given('--slower')) call line%reject('say how much, as --slower 3%')
      slower = part_of(line%value('--slower'))
      amplitude = words(amplitude_of_excess(slower%hi))
      three_terms = words(amplitude_three_terms(slower%hi))
      page = begin_sheet(line, [column('amplitude_deg', digits, 12), column('amplitude_rad', digits, 12), &
         column('three_terms_deg', digits, 12)])
      call page%row([in_degrees(amplitude), amplitude, in_degrees(three_terms)])
      call page%end()
      form = line%value('--format')
      if (form%text == 'text' .and. nint(1000*min(slower%hi, 1.0_wp)) == 30) then
         call put('(The lecture note of 2005 reads 38 degrees off a table for the last.)')
      end if
      call finish()
   end subroutine amplitude_command


   function drift_usage() result(usage)
      type(command) :: usage

      usage = command('drift', 'how long a small-angle clock keeps step', '', 0, &
         'After how many swings a clock that counts on small swings is off by Q of a swing, and when, ' // &
         'if its pendulum swings out to A or is slower by the part P; ten swings of the lecture note''s ' // &
         'pendulum are the example.', &
         example='furiko drift --slower 3% --off 30%', options=[ &
         option('--amplitude', 'A', '', 'degrees, or as 1rad; this or --slower'), &
         option('--slower', 'P', '', 'as 3%'), &
         option('--off', 'Q', '1/2', 'part of a swing, as 1/2 or 30%'), &
         length_option, gravity_option, format_option], run=drift_command)
   end function drift_usage


   subroutine drift_command(line)
      type(command_line), intent(in) :: line
      type(sheet) :: page
      type(words) :: amplitude, slower, swings, time

      if (line%given('--amplitude') .eqv. line%given('--slower')) then
         call line%reject('one of --amplitude and --slower, as --amplitude 20deg or --slower 3%')
      end if
      if (line%given('--amplitude')) then
         amplitude = amplitude_of(line%value('--amplitude'))
         slower = excess_of(amplitude)
         if (.not. slower%hi > 0.0_wp) call line%reject('--amplitude 0 never drifts; it has to be above 0')
      else
         slower = part_of(line%value('--slower'))
         amplitude = words(amplitude_of_excess(slower%hi))
      end if
      swings = part_of(line%value('--off'))/slower
      time = swings*(1.0_wp + slower)*small_period_of(line)
      page = begin_sheet(line, [column('amplitude_deg', digits, 12), column('slower_percent', digits, 12), &
         column('swings', digits, 12), column('time_s', digits, 12)])
      call page%row([in_degrees(amplitude), 100.0_wp*slower, swings, time])
      call page%end()
      call finish()
   end subroutine drift_command


   !> A part of a whole, above 0
   !> Quotients and products of such parts are within the range of numbers.
   function part_of(given) result(part)
      type(word), intent(in) :: given
      type(words) :: part

      part = number_of(given, pure_number)
      call demand(part%hi >= 1.0e-100_wp .and. part%hi <= 1.0e100_wp, given, '1e-100 <= part <= 1e100')
   end function part_of

end module furiko_cli_period
