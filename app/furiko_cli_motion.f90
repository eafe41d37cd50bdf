! SPDX-License-Identifier: MIT

!> `furiko motion`: where the pendulum is, time by time.
module furiko_cli_motion
   use, intrinsic :: iso_fortran_env, only : int64, wp => real64
   use furiko, only : motion, pendulum, pendulum_rk4
   use furiko_cli_arguments, only : argument_reader, value_of
   use furiko_cli_pendulum, only : amplitude_of, angle_at_start, rate_at_start, read_pendulum_option
   use furiko_cli_quantity, only : number_of, seconds
   use furiko_cli_sheet, only : begin_sheet, sheet
   use furiko_cli_terminal, only : finish, put, refuse
   use furiko_double_word, only : double_word
   implicit none
   private
   public :: motion_command


   character(len=*), parameter :: command = 'furiko motion'
   character(len=*), parameter :: nl = new_line('a')
   character(len=*), parameter :: help = &
      'furiko motion START [--from T] [--to T] [--step DT] [--columns LIST] [--format F]' // nl // &
      '              [--length L] [--gravity G]' // nl // nl // &
      'The exact motion of a pendulum, a row for each time. START is one of' // nl // nl // &
      '  --amplitude A       through the bottom at the time 0, swinging out to A (below 180deg)' // nl // &
      '  --release A         let go at A at the time 0' // nl // &
      '  --angle A --rate R  any state at the time 0: also over the top; R in rad/s (0)' // nl // nl // &
      'Angles are in degrees, or as 1rad. Further:' // nl // nl // &
      '  --from T, --to T    first and last time in seconds, or as 500ms, 2min (0, 10)' // nl // &
      '  --step DT           distance of the rows (0.01)' // nl // &
      '  --columns LIST      any of time,angle,harmonic,degrees,rate,energy,tension,turns,phase,rk4,' // &
      nl // '                      error (time,angle,harmonic): angles in radians but for degrees;' // nl // &
      '                      harmonic is the small-angle motion from the same start; energy over' // nl // &
      '                      m l^2; tension over the weight; rk4 by Runge-Kutta, a step a row,' // nl // &
      '                      and its error' // nl // &
      '  --length L          metres, or as 25cm (1)' // nl // &
      '  --gravity G         m/s^2 (9.80665)' // nl // &
      '  --format F          text (six decimals, as the lecture note''s furiko.c), csv or json (text)' // &
      nl // nl // 'Example, the note''s:' // nl // nl // &
      '  furiko motion --amplitude 1rad --to 10 --step 0.01 --gravity 9.8'
   character(len=*), parameter :: known_columns(*) = [character(len=8) :: 'time', 'angle', &
      'harmonic', 'degrees', 'rate', 'energy', 'tension', 'turns', 'phase', 'rk4', 'error']
   character(len=*), parameter :: units(*) = [character(len=6) :: 's', 'rad', 'rad', '', &
      'rad_s', 's_2', '', '', '', 'rad', 'rad']


   real(wp), parameter :: most_rows = 1.0e12_wp


   !> What the command line asks for
   type :: request
      type(pendulum) :: body
      !> The option that names the start
      character(len=:), allocatable :: start
      type(double_word) :: angle
      real(wp) :: rate = 0.0_wp
      logical :: has_rate = .false.
      real(wp) :: from = 0.0_wp
      real(wp) :: to = 10.0_wp
      real(wp) :: step = 0.01_wp
      !> The three as they were typed
      character(len=:), allocatable :: from_word, to_word, step_word
      character(len=8), allocatable :: columns(:)
      character(len=:), allocatable :: form
   end type request


contains


   subroutine motion_command(arguments)
      type(argument_reader), intent(inout) :: arguments
      type(request) :: wish
      character(len=:), allocatable :: option
      logical :: known

      wish%start = ''
      wish%form = 'text'
      wish%columns = known_columns(:3)
      wish%from_word = '0'
      wish%to_word = '10'
      wish%step_word = '0.01'
      do while (.not. arguments%done())
         option = arguments%word()
         call arguments%advance()
         select case (option)
         case ('-h', '--help')
            call put(help)
            call finish()
            return
         case ('--format')
            wish%form = value_of(command, option, arguments)
         case ('--columns')
            call read_columns(value_of(command, option, arguments), wish%columns)
         case ('--amplitude', '--release', '--angle', '--rate')
            call read_start(option, value_of(command, option, arguments), wish)
         case ('--from', '--to', '--step')
            call read_time(option, value_of(command, option, arguments), wish)
         case default
            call read_pendulum_option(command, option, arguments, wish%body, known)
            if (.not. known) call reject("unknown word '" // option // "'; see furiko motion --help")
         end select
      end do
      if (wish%start == '') call reject('name a start, as --amplitude 1rad; see furiko motion --help')
      if (wish%has_rate .and. wish%start /= '--angle') call reject('--rate goes with --angle')
      if (wish%from > wish%to) then
         call reject('--to ' // wish%to_word // ' is before --from ' // wish%from_word)
      end if
      if ((wish%to - wish%from)/wish%step > most_rows) then
         call reject('--step ' // wish%step_word // ' up to --to ' // wish%to_word // &
            ' makes more rows than 1e12')
      end if
      call print_motion(wish)
   end subroutine motion_command


   subroutine read_start(option, word, wish)
      character(len=*), intent(in) :: option
      character(len=*), intent(in) :: word
      type(request), intent(inout) :: wish

      if (option == '--rate') then
         wish%rate = rate_at_start(command, option, word)
         wish%has_rate = .true.
         return
      end if
      if (wish%start /= '') then
         call reject(option // ' ' // word // ': there is a start already, ' // wish%start)
      end if
      wish%start = option
      if (option == '--angle') then
         wish%angle = angle_at_start(command, option, word)
      else
         wish%angle = amplitude_of(command, option, word)
      end if
   end subroutine read_start


   subroutine read_time(option, word, wish)
      character(len=*), intent(in) :: option
      character(len=*), intent(in) :: word
      type(request), intent(inout) :: wish
      real(wp) :: time

      time = number_of(command // ': ' // option, word, seconds)
      select case (option)
      case ('--from')
         wish%from = time
         wish%from_word = word
      case ('--to')
         wish%to = time
         wish%to_word = word
      case default
         wish%step = time
         wish%step_word = word
         if (.not. time > 0.0_wp) call reject(option // ' ' // word // ' is not above 0 s')
      end select
   end subroutine read_time


   !> The names in a list with commas
   subroutine read_columns(word, columns)
      character(len=*), intent(in) :: word
      character(len=8), allocatable, intent(out) :: columns(:)
      character(len=:), allocatable :: name, rest
      integer :: comma

      allocate(columns(0))
      rest = word // ','
      do while (len(rest) > 0)
         comma = index(rest, ',')
         name = rest(:comma - 1)
         if (all(known_columns /= name)) then
            call reject("--columns: no column '" // name // "'; see furiko motion --help")
         end if
         columns = [character(len=8) :: columns, name]
         rest = rest(comma + 1:)
      end do
   end subroutine read_columns


   subroutine print_motion(wish)
      type(request), intent(in) :: wish
      type(motion) :: path
      type(sheet) :: page
      character(len=16) :: names(size(wish%columns))
      real(wp) :: rk4(2)
      integer(int64) :: i, last
      integer :: column

      select case (wish%start)
      case ('--amplitude')
         path = wish%body%swinging(wish%angle%hi, wish%angle%lo)
      case ('--release')
         path = wish%body%released(wish%angle%hi, wish%angle%lo)
      case default
         path = wish%body%started(wish%angle%hi, wish%rate, wish%angle%lo)
      end select
      do column = 1, size(names)
         names(column) = heading(wish%columns(column))
      end do
      ! a last step that roundings have made a trifle too long still counts
      last = int((wish%to - wish%from)/wish%step*(1 + epsilon(1.0_wp)), int64)
      page = begin_sheet(command, wish%form, names, &
         [(merge('es16.8e3', 'f0.6    ', wish%columns(column) == 'error'), column=1, size(names))])
      rk4 = [path%angle(wish%from), path%rate(wish%from)]
      do i = 0, last
         call page%row(values(path, wish, wish%from + i*wish%step, rk4(1)))
         call pendulum_rk4(wish%body%gravity/wish%body%length, wish%step, 1, rk4(1), rk4(2))
      end do
      call page%end()
      call finish()
   end subroutine print_motion


   !> A column's name with its unit
   pure function heading(column)
      character(len=*), intent(in) :: column
      character(len=16) :: heading
      integer :: i

      i = 1
      do while (known_columns(i) /= column)
         i = i + 1
      end do
      heading = column
      if (units(i) /= '') heading = trim(column) // '_' // units(i)
   end function heading


   pure function values(path, wish, time, rk4) result(row)
      type(motion), intent(in) :: path
      type(request), intent(in) :: wish
      real(wp), intent(in) :: time
      !> The angle by Runge-Kutta
      real(wp), intent(in) :: rk4
      real(wp) :: row(size(wish%columns))
      real(wp), parameter :: pi = acos(-1.0_wp)
      integer :: i

      do i = 1, size(row)
         select case (wish%columns(i))
         case ('time')
            row(i) = time
         case ('angle')
            row(i) = path%angle(time)
         case ('degrees')
            row(i) = path%angle(time)*(180/pi)
         case ('rk4')
            row(i) = rk4
         case ('error')
            row(i) = rk4 - path%angle(time)
         case ('harmonic')
            row(i) = path%harmonic_angle(time)
         case ('rate')
            row(i) = path%rate(time)
         case ('energy')
            row(i) = path%energy()
         case ('tension')
            row(i) = path%tension(time)
         case ('turns')
            row(i) = anint(path%angle(time)/(2*pi)) + 0.0_wp
         case default
            row(i) = path%phase(time)
         end select
      end do
   end function values


   subroutine reject(message)
      character(len=*), intent(in) :: message

      call refuse(command // ': ' // message)
   end subroutine reject

end module furiko_cli_motion
