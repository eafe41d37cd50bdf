! SPDX-License-Identifier: MIT

!> `furiko table`: how the period of a pendulum grows with its amplitude.
module furiko_cli_table
   use, intrinsic :: iso_fortran_env, only : int64
   use furiko_cli_arguments, only : argument_reader, value_of
   use furiko_cli_decimal, only : decimal, fixed, read_decimal, rescale, to_double_word, to_text
   use furiko_cli_terminal, only : finish, put, refuse
   use furiko_period_degrees, only : period_ratio_degrees
   implicit none
   private
   public :: table_command


   character(len=*), parameter :: nl = new_line('a')
   character(len=*), parameter :: help = &
      'furiko table [--from A] [--to B] [--step S] [--format text|csv|json]' // nl // nl // &
      'The period of a pendulum over that of its small swings, T/T_h = (2/pi) K(sin(A/2)),' // nl // &
      'for amplitudes A in degrees, every value correctly rounded to 15 decimals.' // nl // nl // &
      '  --from A     first amplitude, 0 <= A < 180 degrees, fractions allowed (0)' // nl // &
      '  --to B       last amplitude, A <= B < 180; always the last row (179)' // nl // &
      '  --step S     distance of the rows, S > 0 (1)' // nl // &
      '  --format F   text (as in the lecture note), csv or json (text)' // nl // nl // &
      'Numbers have at most 15 decimal places. Example:' // nl // nl // &
      '  furiko table --from 179 --to 179.999999 --step 0.1 --format csv'


contains


   !> Parse the words that follow `table`, then print.
   subroutine table_command(arguments)
      type(argument_reader), intent(inout) :: arguments
      type(decimal) :: first, last, step
      character(len=:), allocatable :: form, option

      first = decimal(0)
      last = decimal(179)
      step = decimal(1)
      form = 'text'
      do while (.not. arguments%done())
         option = arguments%word()
         call arguments%advance()
         select case (option)
         case ('-h', '--help')
            call put(help)
            call finish()
            return
         case ('--from')
            call read_amplitude(option, value_of('furiko table', option, arguments), first)
         case ('--to')
            call read_amplitude(option, value_of('furiko table', option, arguments), last)
         case ('--step')
            call read_step(option, value_of('furiko table', option, arguments), step)
         case ('--format')
            form = value_of('furiko table', option, arguments)
            if (all(form /= [character(len=4) :: 'text', 'csv', 'json'])) then
               call reject("--format '" // form // "' is none of text, csv, json")
            end if
         case default
            call reject("unknown word '" // option // "'; see furiko table --help")
         end select
      end do
      call print_table(first, last, step, form)
   end subroutine table_command


   subroutine read_amplitude(option, word, amplitude)
      character(len=*), intent(in) :: option
      character(len=*), intent(in) :: word
      type(decimal), intent(out) :: amplitude

      call read_number(option, word, amplitude)
      if (amplitude%digits < 0 .or. amplitude%digits >= 180*10_int64**amplitude%places) then
         call reject(option // ' ' // word // &
            ' is outside 0 <= amplitude < 180 degrees (at 180 the period is infinite)')
      end if
   end subroutine read_amplitude


   subroutine read_step(option, word, step)
      character(len=*), intent(in) :: option
      character(len=*), intent(in) :: word
      type(decimal), intent(out) :: step

      call read_number(option, word, step)
      if (step%digits <= 0) call reject(option // ' ' // word // ' is not above 0 degrees')
   end subroutine read_step


   subroutine read_number(option, word, number)
      character(len=*), intent(in) :: option
      character(len=*), intent(in) :: word
      type(decimal), intent(out) :: number
      logical :: valid

      call read_decimal(word, number, valid)
      if (valid) return
      call reject(option // " '" // word // "' is not a number below 1000 with at most 15 decimals")
   end subroutine read_number


   !> Rows at first, first + step, ... and at last, all in steps of the last decimal place.
   subroutine print_table(first, last, step, form)
      type(decimal), intent(in) :: first
      type(decimal), intent(in) :: last
      type(decimal), intent(in) :: step
      character(len=*), intent(in) :: form
      type(decimal) :: amplitude, limit, stride
      integer(int64) :: digits
      integer :: places

      places = max(first%places, last%places, step%places)
      amplitude = rescale(first, places)
      limit = rescale(last, places)
      stride = rescale(step, places)
      if (amplitude%digits > limit%digits) then
         call reject('--from ' // to_text(first) // ' is beyond --to ' // to_text(last))
      end if

      if (form == 'csv') call put('amplitude_deg,period_ratio')
      if (form == 'json') call put('[')
      ! a counted loop: in any other flang keeps each row's text on the stack
      do digits = amplitude%digits, limit%digits - 1, stride%digits
         call put(row(decimal(digits, places), form) // trim(merge(',', ' ', form == 'json')))
      end do
      call put(row(limit, form))
      if (form == 'json') call put(']')
      call finish()
   end subroutine print_table


   !> One amplitude and its period; in text the columns of the note's '%2d %20.15f', the first
   !> as wide as its decimals ask.
   pure function row(amplitude, form) result(line)
      type(decimal), intent(in) :: amplitude
      character(len=*), intent(in) :: form
      character(len=:), allocatable :: line
      character(len=:), allocatable :: angle, ratio

      angle = to_text(amplitude)
      ratio = fixed(period_ratio_degrees(to_double_word(amplitude)))
      select case (form)
      case ('csv')
         line = angle // ',' // ratio
      case ('json')
         line = '  {"amplitude_deg": ' // angle // ', "period_ratio": ' // ratio // '}'
      case default
         line = right(angle, merge(2, amplitude%places + 4, amplitude%places == 0)) // ' ' // &
            right(ratio, 20)
      end select
   end function row


   !> text behind as many blanks as make it that wide.
   pure function right(text, width)
      character(len=*), intent(in) :: text
      integer, intent(in) :: width
      character(len=:), allocatable :: right

      right = repeat(' ', max(0, width - len(text))) // text
   end function right


   subroutine reject(message)
      character(len=*), intent(in) :: message

      call refuse('furiko table: ' // message)
   end subroutine reject

end module furiko_cli_table
