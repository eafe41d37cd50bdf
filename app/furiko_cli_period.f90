! SPDX-License-Identifier: MIT

!> `furiko period`, `furiko amplitude` and `furiko drift`: how long a swing takes, and its inverse.
module furiko_cli_period
   use, intrinsic :: iso_fortran_env, only : wp => real64
   use furiko, only : amplitude_of_excess, amplitude_three_terms, pendulum, period_excess, &
      period_ratio_series
   use furiko_cli_arguments, only : argument_reader, value_of
   use furiko_cli_pendulum, only : read_pendulum_option
   use furiko_cli_quantity, only : angle_of, integer_of, is_below_half_turn, number_of, pure_number
   use furiko_cli_sheet, only : begin_sheet, sheet
   use furiko_cli_terminal, only : finish, put, refuse
   use furiko_double_word, only : double_word, double_word_pi, &
      operator(-), operator(*), operator(/)
   use furiko_period_degrees, only : period_ratio_degrees
   implicit none
   private
   public :: period_command, amplitude_command, drift_command


   character(len=*), parameter :: nl = new_line('a')
   character(len=*), parameter :: period_help = &
      'furiko period A [A ...] [--terms N] [--length L] [--gravity G] [--format F]' // nl // nl // &
      'The period of a pendulum of amplitude A (degrees, or as 1rad; below 180): a row for each with' // &
      nl // 'A in degrees, T in seconds, T/T_h, and how much that is above 1 in percent, T_h being' // &
      nl // 'the period of small swings.' // nl // nl // &
      '  --terms N      a further column: T/T_h by the first N terms of its series' // nl // &
      '  --length L     metres, or as 25cm (1)' // nl // &
      '  --gravity G    m/s^2 (9.80665)' // nl // &
      '  --format F     text, csv or json (text)' // nl // nl // &
      'Example:' // nl // nl // &
      '  furiko period 45 90deg 1rad --terms 3'
   character(len=*), parameter :: amplitude_help = &
      'furiko amplitude --slower P [--format F]' // nl // nl // &
      'The amplitude at which a pendulum is slower than for small swings by the part P of its period' // &
      nl // '(3%, 0.03, 1e-15 or 1000), in degrees and radians; and what three terms of the series' // &
      nl // 'for the period give (NaN where they reach no such period).' // nl // nl // &
      '  --format F     text, csv or json (text)' // nl // nl // &
      'Example:' // nl // nl // &
      '  furiko amplitude --slower 3%'
   character(len=*), parameter :: drift_help = &
      'furiko drift (--amplitude A | --slower P) [--off Q] [--length L] [--gravity G] [--format F]' // &
      nl // nl // &
      'After how many swings a clock that counts on small swings is off by Q of a swing, and when,' // &
      nl // 'if its pendulum swings out to A (degrees, or as 1rad) or is slower by the part P.' // &
      nl // nl // &
      '  --off Q        part of a swing, as 1/2 or 30% (1/2)' // nl // &
      '  --length L     metres, or as 25cm (1)' // nl // &
      '  --gravity G    m/s^2 (9.80665)' // nl // &
      '  --format F     text, csv or json (text)' // nl // nl // &
      'Example, ten swings of the lecture note''s pendulum:' // nl // nl // &
      '  furiko drift --slower 3% --off 30%'


contains


   subroutine period_command(arguments)
      type(argument_reader), intent(inout) :: arguments
      character(len=*), parameter :: command = 'furiko period'
      type(pendulum) :: body
      type(double_word), allocatable :: amplitudes(:)
      character(len=:), allocatable :: form, word
      integer :: terms
      logical :: known

      form = 'text'
      terms = 0
      allocate(amplitudes(0))
      do while (.not. arguments%done())
         word = arguments%word()
         call arguments%advance()
         select case (word)
         case ('-h', '--help')
            call put(period_help)
            call finish()
            return
         case ('--format')
            form = value_of(command, word, arguments)
         case ('--terms')
            terms = integer_of(command // ': ' // word, value_of(command, word, arguments), 1, 1000000)
         case default
            call read_pendulum_option(command, word, arguments, body, known)
            if (known) cycle
            if (index(word, '--') == 1) then
               call refuse(command // ": unknown word '" // word // "'; see furiko period --help")
            end if
            amplitudes = [amplitudes, swing_of(command, word)]
         end select
      end do
      if (size(amplitudes) == 0) call refuse(command // ': name an amplitude, as 90deg or 1rad')
      call print_periods(command, amplitudes, terms, body, form)
   end subroutine period_command


   subroutine print_periods(command, amplitudes, terms, body, form)
      character(len=*), intent(in) :: command
      type(double_word), intent(in) :: amplitudes(:)
      integer, intent(in) :: terms
      type(pendulum), intent(in) :: body
      character(len=*), intent(in) :: form
      type(sheet) :: page
      type(double_word) :: degrees, ratio
      character(len=16), parameter :: columns(5) = [character(len=16) :: 'amplitude_deg', 'period_s', &
         'period_ratio', 'slower_percent', 'series']
      character(len=8), parameter :: styles(5) = [character(len=8) :: 'f18.12', 'g22.15', 'f20.15', &
         'g22.15', 'f20.15']
      real(wp) :: row(5), low(5)
      integer :: i, last

      last = merge(5, 4, terms > 0)
      low = 0.0_wp
      page = begin_sheet(command, form, columns(:last), styles(:last))
      do i = 1, size(amplitudes)
         degrees = amplitudes(i)*double_word(180.0_wp)/double_word_pi
         ratio = period_ratio_degrees(degrees)
         row(1) = degrees%hi
         row(2) = body%small_period()*ratio%hi
         row(3) = ratio%hi
         low(3) = ratio%lo
         ratio = ratio - double_word(1.0_wp)
         row(4) = 100*ratio%hi
         if (ratio%hi < 0.5_wp) row(4) = 100*period_excess(amplitudes(i)%hi)
         if (terms > 0) row(5) = period_ratio_series(amplitudes(i)%hi, terms)
         call page%row(row(:last), low(:last))
      end do
      call page%end()
      call finish()
   end subroutine print_periods


   subroutine amplitude_command(arguments)
      type(argument_reader), intent(inout) :: arguments
      character(len=*), parameter :: command = 'furiko amplitude'
      type(sheet) :: page
      character(len=:), allocatable :: form, word
      real(wp) :: amplitude, slower, three_terms
      integer :: i

      form = 'text'
      slower = -1.0_wp
      do while (.not. arguments%done())
         word = arguments%word()
         call arguments%advance()
         select case (word)
         case ('-h', '--help')
            call put(amplitude_help)
            call finish()
            return
         case ('--format')
            form = value_of(command, word, arguments)
         case ('--slower')
            slower = part_of(command, word, value_of(command, word, arguments))
         case default
            call refuse(command // ": unknown word '" // word // "'; see furiko amplitude --help")
         end select
      end do
      if (slower < 0.0_wp) call refuse(command // ': say how much, as --slower 3%')

      amplitude = amplitude_of_excess(slower)
      three_terms = amplitude_three_terms(slower)
      page = begin_sheet(command, form, [character(len=16) :: 'amplitude_deg', 'amplitude_rad', &
         'three_terms_deg'], [('g23.16', i=1, 3)])
      call page%row([in_degrees(amplitude), amplitude, in_degrees(three_terms)])
      call page%end()
      if (form == 'text' .and. nint(1000*slower) == 30) then
         call put('(The lecture note of 2005 reads 38 degrees off a trigonometric table for the last.)')
      end if
      call finish()
   end subroutine amplitude_command


   subroutine drift_command(arguments)
      type(argument_reader), intent(inout) :: arguments
      character(len=*), parameter :: command = 'furiko drift'
      type(pendulum) :: body
      type(sheet) :: page
      type(double_word) :: amplitude
      character(len=:), allocatable :: form, word
      real(wp) :: off, slower
      integer :: i
      logical :: known

      form = 'text'
      off = 0.5_wp
      slower = -1.0_wp
      do while (.not. arguments%done())
         word = arguments%word()
         call arguments%advance()
         select case (word)
         case ('-h', '--help')
            call put(drift_help)
            call finish()
            return
         case ('--format')
            form = value_of(command, word, arguments)
         case ('--slower')
            call only_one(command, slower)
            slower = part_of(command, word, value_of(command, word, arguments))
            amplitude = double_word(amplitude_of_excess(slower))
         case ('--off')
            off = part_of(command, word, value_of(command, word, arguments))
         case ('--amplitude')
            call only_one(command, slower)
            amplitude = swing_of(command, value_of(command, word, arguments))
            slower = period_excess(amplitude%hi)
         case default
            call read_pendulum_option(command, word, arguments, body, known)
            if (.not. known) then
               call refuse(command // ": unknown word '" // word // "'; see furiko drift --help")
            end if
         end select
      end do
      if (slower < 0.0_wp) call refuse(command // ': say what, as --amplitude 20deg or --slower 3%')
      if (.not. slower > 0.0_wp) call refuse(command // ': --amplitude 0 never drifts; it has to be above 0')

      page = begin_sheet(command, form, [character(len=16) :: 'amplitude_deg', 'slower_percent', &
         'swings', 'time_s'], [('g23.16', i=1, 4)])
      call page%row([in_degrees(amplitude%hi), 100*slower, off/slower, &
         off/slower*(1 + slower)*body%small_period()])
      call page%end()
      call finish()
   end subroutine drift_command


   !> --amplitude and --slower say the same thing.
   subroutine only_one(command, slower)
      character(len=*), intent(in) :: command
      real(wp), intent(in) :: slower

      if (slower >= 0.0_wp) call refuse(command // ': --amplitude or --slower, not both')
   end subroutine only_one


   !> An amplitude in radians, within 0 to 180 degrees
   function swing_of(command, word) result(amplitude)
      character(len=*), intent(in) :: command
      character(len=*), intent(in) :: word
      type(double_word) :: amplitude

      amplitude = angle_of(command // ': the amplitude', word)
      if (amplitude%hi < 0.0_wp .or. .not. is_below_half_turn(amplitude)) then
         call refuse(command // ': the amplitude ' // word // ' is outside 0 <= A < 180 degrees')
      end if
   end function swing_of


   !> A part of a whole, above 0
   function part_of(command, option, word) result(part)
      character(len=*), intent(in) :: command
      character(len=*), intent(in) :: option
      character(len=*), intent(in) :: word
      real(wp) :: part

      part = number_of(command // ': ' // option, word, pure_number)
      if (.not. part > 0.0_wp) call refuse(command // ': ' // option // ' ' // word // ' is not above 0')
   end function part_of


   elemental function in_degrees(angle)
      real(wp), intent(in) :: angle
      real(wp) :: in_degrees
      real(wp), parameter :: pi = acos(-1.0_wp)

      in_degrees = angle*(180.0_wp/pi)
   end function in_degrees

end module furiko_cli_period
