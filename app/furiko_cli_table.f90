! SPDX-License-Identifier: MIT

!> `furiko table`: how the period of a pendulum grows with its amplitude.
module furiko_cli_table
   use, intrinsic :: iso_fortran_env, only : int64
   use furiko_cli_decimal, only : decimal, read_decimal, rescale, to_words
   use furiko_cli_io, only : finish, refuse
   use furiko_cli_options, only : command, command_line, demand, option, word
   use furiko_cli_sheet, only : begin_sheet, column, format_option, places_of_words, sheet
   use furiko_period_degrees, only : period_ratio_degrees
   implicit none
   private
   public :: table_usage


contains


   function table_usage() result(usage)
      type(command) :: usage

      usage = command('table', 'the period of a pendulum against its amplitude; the default', &
         about='The period of a pendulum over that of its small swings, T/T_h = (2/pi) K(sin(A/2)), ' // &
         'for amplitudes A in degrees, every value correctly rounded to 15 decimals. Text is that of ' // &
         'the lecture note, without a head.', &
         notes='Numbers have at most 15 decimal places.', &
         example='furiko table --from 179 --to 179.999999 --step 0.1 --format csv', &
         options=[ &
         option('--from', 'A', '0', 'first amplitude, 0 <= A < 180 degrees, fractions allowed'), &
         option('--to', 'B', '179', 'last amplitude, A <= B < 180; always the last row'), &
         option('--step', 'S', '1', 'distance of the rows, S > 0'), &
         format_option], run=table_command)
   end function table_usage


   !> Rows at first, first + step, ... and at last, all in steps of the last decimal place
   subroutine table_command(line)
      type(command_line), intent(in) :: line
      type(decimal) :: first, last, step
      type(sheet) :: page
      type(word) :: from, to
      integer(int64) :: amplitude
      integer :: digits

      from = line%value('--from')
      to = line%value('--to')
      first = amplitude_of(from)
      last = amplitude_of(to)
      step = decimal_of(line%value('--step'))
      call demand(step%digits > 0, line%value('--step'), 'step > 0 degrees')
      digits = max(first%places, last%places, step%places)
      first = rescale(first, digits)
      last = rescale(last, digits)
      step = rescale(step, digits)
      if (first%digits > last%digits) call line%reject('--from ' // from%text // ' is beyond --to ' // &
         to%text)

      ! the columns of the note's '%2d %20.15f', the first as wide as its decimals ask
      page = begin_sheet(line, [column('amplitude_deg', places_of_words, digits, &
         width=merge(2, digits + 4, digits == 0)), column('period_ratio', places_of_words, 15, width=21)], &
         .true., (last%digits - first%digits - 1)/step%digits + 2)
      ! a counted loop: in any other flang keeps each row's text on the stack
      do amplitude = first%digits, last%digits - 1, step%digits
         call put_row(page, decimal(amplitude, digits))
      end do
      call put_row(page, last)
      call page%end()
      call finish()
   end subroutine table_command


   subroutine put_row(page, amplitude)
      type(sheet), intent(inout) :: page
      type(decimal), intent(in) :: amplitude

      call page%row([to_words(amplitude), period_ratio_degrees(to_words(amplitude))])
   end subroutine put_row


   function amplitude_of(given) result(amplitude)
      type(word), intent(in) :: given
      type(decimal) :: amplitude

      amplitude = decimal_of(given)
      call demand(amplitude%digits >= 0 .and. amplitude%digits < 180*10_int64**amplitude%places, given, &
         '0 <= amplitude < 180 degrees (at 180 the period is infinite)')
   end function amplitude_of


   function decimal_of(given) result(number)
      type(word), intent(in) :: given
      type(decimal) :: number
      logical :: valid

      call read_decimal(given%text, number, valid)
      if (.not. valid) call refuse(given%what // " '" // given%text // &
         "' is not a number below 1000 with at most 15 decimals")
   end function decimal_of

end module furiko_cli_table
