! SPDX-License-Identifier: MIT

!> `furiko driven`: driven, damped pendulums, one or a family of them.
module furiko_cli_driven
   use, intrinsic :: iso_fortran_env, only : int64, wp => real64
   use furiko, only : driven_amplitude, driven_attractors, driven_basins, driven_cascade, driven_cycle, &
      driven_damping, &
      driven_exponents, driven_frequency, driven_get, driven_locking, driven_order8, driven_pendulum, &
      driven_periods, driven_phase, driven_quadratic, driven_rk4, driven_round, driven_scheme, &
         driven_section, &
      driven_set, driven_state, driven_steps, driven_torque, driven_winding
   use furiko_bits_dp, only : nan
   use furiko_cli_io, only : finish
   use furiko_cli_options, only : command, command_line, demand, option, word
   use furiko_cli_quantity, only : angle_of, no_unit, number_of, whole_of
   use furiko_cli_sheet, only : begin_sheet, column, digits, format_option, places, powers, sheet, whole
   use furiko_cli_text, only : cut, suggestion
   use furiko_word_arithmetic_dp, only : words
   implicit none
   private
   public :: driven_usage


   real(wp), parameter :: pi = acos(-1.0_wp)
   integer, parameter :: most = 1000000000
   !> Members that are computed before their rows are written
   integer, parameter :: chunk = 4096
   !> Constants by name, in the order of their numbers in the library
   character(len=9), parameter :: constants(6) = [character(len=9) :: 'damping', 'quadratic', 'torque', &
      'drive', 'frequency', 'phase']
   integer, parameter :: numbers(6) = [driven_damping, driven_quadratic, driven_torque, driven_amplitude, &
      driven_frequency, driven_phase]
   character(len=11), parameter :: subjects(9) = [character(len=11) :: 'orbit', 'section', &
      'bifurcation', 'lyapunov', 'winding', 'cycle', 'doublings', 'attractors', 'basins']
   !> How near a member has to come to where it was, or to an attractor; how many points attractors may have
   real(wp), parameter :: same = 1.0e-6_wp, near = 1.0e-3_wp
   integer, parameter :: most_points = 1024

   type(column), parameter :: angle = column('angle_rad', places, 9, 15), rate = column('rate', places, 9, 15)


   !> What is asked of all subjects
   type :: question
      type(driven_scheme) :: scheme
      type(driven_pendulum) :: pendulum
      type(driven_state) :: start
      integer :: transient
      integer :: periods
      !> Periods of a cycle, or the longest that is looked for
      integer :: cycle
      !> The constant that is varied, 0 for none, over so many values
      integer :: vary = 0
      real(wp) :: from = 0.0_wp
      real(wp) :: to = 0.0_wp
      integer :: points = 1
   end type question


contains


   function driven_usage() result(usage)
      type(command) :: usage

      usage = command('driven', 'a pendulum with friction and a drive: chaos, cycles, basins', 'WHAT', 1, &
         'The pendulum angle'''' = -B angle'' - C |angle''| angle'' - sin(angle) + I + G cos(W t + ' // &
         'A), time in units of sqrt(l/g), in steps of which a whole number makes a period of the ' // &
         'drive. WHAT is one of: orbit, angle and rate, time in periods of the drive; section, the ' // &
         'same once a period; bifurcation, sections for many values of a constant; lyapunov, both ' // &
         'exponents and the error of the first; winding, turns a period, and the fraction ' // &
         'turns/cycle where it is locked; cycle, a cycle of --cycle periods by Newton''s method, ' // &
         'with its multipliers; doublings, the values of a constant where that cycle doubles its ' // &
         'period, again and again; attractors, the stable cycles of up to --cycle periods; basins, ' // &
         'which of them each start comes to, and after how many periods (0 and -1 for none).', &
         'With --vary, lyapunov and winding have a row for each value. Chaos amplifies the last digit: ' // &
         'statistics can be repeated on another machine, single points cannot. NaN stands for a member ' // &
         'that has run away (beyond 2^20), and for a ratio of doublings that has no two before it. ' // &
         'doc/driven.md says more.', &
         'furiko driven bifurcation --vary drive --from 1.06 --to 1.09 --points 64 --periods 32', options=[ &
         option('--damping', 'B', '0.5', 'linear damping; 1/q'), &
         option('--quadratic', 'C', '0', 'quadratic damping'), &
         option('--torque', 'I', '0', 'a constant torque'), &
         option('--drive', 'G', '1.2', 'amplitude of the drive'), &
         option('--frequency', 'W', '2/3', 'of the drive'), &
         option('--phase', 'A', '0', 'of the drive at the time 0; degrees, or as 1rad'), &
         option('--angle', 'A', '0', 'at the time 0; degrees, or as 1rad'), &
         option('--rate', 'R', '0', 'at the time 0'), &
         option('--vary', 'CONSTANT', '', 'damping, quadratic, torque, drive, frequency or phase (rad)'), &
         option('--from', 'X', '', 'its first value'), &
         option('--to', 'X', '', 'its last value'), &
         option('--points', 'N', '100', 'how many values; doublings: how many of them'), &
         option('--transient', 'N', '500', 'periods that are left out first'), &
         option('--periods', 'N', '100', 'periods that are counted or shown; basins: that are waited'), &
         option('--cycle', 'N', '1', 'periods of the cycle; winding, attractors and basins: at most (8)'), &
         option('--every', 'N', '', 'orbit: a row after every N steps (default: 32 rows a period)'), &
         option('--grid', 'N', '64', 'basins: N angles times N rates, the middles of cells'), &
         option('--rates', 'LOW,HIGH', '-3,3', 'basins: the edges of the rates'), &
         option('--method', 'order8|rk4', 'order8', 'order 8 by Dormand and Prince, or Runge-Kutta'), &
         option('--steps', 'N', '96', 'steps a period; 96 for 12 digits by order8, 24 for a picture'), &
         format_option], run=driven_command)
   end function driven_usage


   subroutine driven_command(line)
      type(command_line), intent(in) :: line
      type(question) :: asked

      if (size(line%operands) == 0) call line%reject('what of it? orbit, section, bifurcation, ...; see ' // &
         line%name // ' --help')
      if (all(subjects /= line%operands(1)%text)) call line%reject("no '" // line%operands(1)%text // &
         "'; " // suggestion(line%operands(1)%text, subjects, 'see ' // line%name // ' --help'))
      call read_question(line, asked)
      select case (line%operands(1)%text)
      case ('orbit')
         call show_orbit(line, asked)
      case ('section')
         call show_section(line, asked)
      case ('bifurcation')
         call show_bifurcation(line, asked)
      case ('lyapunov')
         call show_exponents(line, asked)
      case ('winding')
         call show_winding(line, asked)
      case ('cycle')
         call show_cycle(line, asked)
      case ('doublings')
         call show_doublings(line, asked)
      case ('attractors')
         call show_attractors(line, asked)
      case default
         call show_basins(line, asked)
      end select
      call finish()
   end subroutine driven_command


   subroutine read_question(line, asked)
      type(command_line), intent(in) :: line
      type(question), intent(out) :: asked
      integer, parameter :: finest = 65536
      type(words) :: number
      type(word) :: method
      integer :: i

      do i = 1, 5
         number = number_of(line%value('--' // trim(constants(i))), no_unit)
         call demand(abs(number%hi) <= 1.0e6_wp, line%value('--' // trim(constants(i))), '-1e6 to 1e6')
         call driven_set(asked%pendulum, numbers(i), number%hi)
      end do
      call demand(asked%pendulum%frequency >= 1.0e-6_wp, line%value('--frequency'), '1e-6 to 1e6')
      number = angle_of(line%value('--phase'))
      call demand(abs(number%hi) <= 1.0e6_wp, line%value('--phase'), '-1e6 to 1e6 radians')
      asked%pendulum%phase = number%hi
      number = angle_of(line%value('--angle'))
      call demand(abs(number%hi) <= 1.0e6_wp, line%value('--angle'), '-1e6 to 1e6 radians')
      asked%start%angle = number%hi
      number = number_of(line%value('--rate'), no_unit)
      call demand(abs(number%hi) <= 1.0e6_wp, line%value('--rate'), '-1e6 to 1e6')
      asked%start%rate = number%hi
      asked%transient = whole_of(line%value('--transient'), 0, most)
      asked%periods = whole_of(line%value('--periods'), 1, most)
      asked%cycle = whole_of(line%value('--cycle'), 1, most_points)
      method = line%value('--method')
      if (method%text == 'rk4') then
         asked%scheme = driven_rk4(whole_of(line%value('--steps'), 1, finest))
      else
         asked%scheme = driven_order8(whole_of(line%value('--steps'), 1, finest))
      end if
      call read_values(line, asked)
   end subroutine read_question


   !> --vary and its values
   subroutine read_values(line, asked)
      type(command_line), intent(in) :: line
      type(question), intent(inout) :: asked
      type(words) :: from, to
      type(word) :: name
      integer :: i

      asked%points = whole_of(line%value('--points'), 1, most)
      if (.not. line%given('--vary')) then
         if (line%given('--from') .or. line%given('--to')) call line%reject('--from and --to go with --vary')
         return
      end if
      name = line%value('--vary')
      do i = 1, size(constants)
         if (constants(i) == name%text) asked%vary = numbers(i)
      end do
      if (asked%vary == 0) call line%reject("--vary '" // name%text // "' is no constant; " // &
         suggestion(name%text, constants, 'see ' // line%name // ' --help'))
      if (line%operands(1)%text == 'doublings') return
      if (.not. (line%given('--from') .and. &
         line%given('--to'))) call line%reject('--vary needs --from and --to')
      from = number_of(line%value('--from'), no_unit)
      to = number_of(line%value('--to'), no_unit)
      call demand(abs(from%hi) <= 1.0e6_wp, line%value('--from'), '-1e6 to 1e6')
      call demand(abs(to%hi) <= 1.0e6_wp, line%value('--to'), '-1e6 to 1e6')
      if (asked%vary == driven_frequency) call demand(min(from%hi, to%hi) >= 1.0e-6_wp, &
         line%value('--from'), &
         '1e-6 to 1e6')
      asked%from = from%hi
      asked%to = to%hi
   end subroutine read_values


   !> Values, members and starts of a part of the family, from the number `first` on; one without --vary
   subroutine take_members(asked, first, values, pendulum, state)
      type(question), intent(in) :: asked
      integer, intent(in) :: first
      real(wp), allocatable, intent(out) :: values(:)
      type(driven_pendulum), allocatable, intent(out) :: pendulum(:)
      type(driven_state), allocatable, intent(out) :: state(:)
      integer :: i, n

      n = 1
      if (asked%vary > 0) n = min(chunk, asked%points - first + 1)
      allocate(pendulum(n), state(n))
      values = [(asked%from + (asked%to - asked%from)*((first + i - 2)/real(max(asked%points - 1, 1), &
         wp)), i=1, n)]
      pendulum = asked%pendulum
      state = asked%start
      if (asked%vary > 0) call driven_set(pendulum, asked%vary, values)
   end subroutine take_members


   !> A column for the constant that is varied, if any is, and others
   function with_value(asked, others) result(columns)
      type(question), intent(in) :: asked
      type(column), intent(in) :: others(:)
      type(column), allocatable :: columns(:)
      integer :: first

      first = merge(2, 1, asked%vary > 0)
      allocate(columns(first - 1 + size(others)))
      if (asked%vary > 0) columns(1) = column(constants(asked%vary), places, 9, 15)
      columns(first:) = others
   end function with_value


   !> The value in front, as many as there are columns for
   pure function row_of(asked, value, others) result(row)
      type(question), intent(in) :: asked
      real(wp), intent(in) :: value
      real(wp), intent(in) :: others(:)
      real(wp), allocatable :: row(:)

      row = others
      if (asked%vary > 0) row = [value, others]
   end function row_of


   pure function family_size(asked) result(n)
      type(question), intent(in) :: asked
      integer :: n

      n = 1
      if (asked%vary > 0) n = asked%points
   end function family_size


   subroutine show_orbit(line, asked)
      type(command_line), intent(in) :: line
      type(question), intent(in) :: asked
      type(driven_state) :: state(1)
      type(sheet) :: page
      integer :: every
      integer(int64) :: done, i, rows

      every = max(asked%scheme%steps/32, 1)
      if (line%given('--every')) every = whole_of(line%value('--every'), 1, most)
      state = asked%start
      call driven_periods(asked%scheme, [asked%pendulum], state, asked%transient)
      rows = int(asked%periods, int64)*asked%scheme%steps/every
      page = begin_sheet(line, [column('periods', places, 6, 12), angle, rate, column('turns', whole)], &
         rows=rows + 1)
      do i = 0, rows
         done = i*every
         call page%row([asked%transient + real(done, wp)/asked%scheme%steps, state%angle, state%rate, &
            real(state%turns, wp)])
         call driven_steps(asked%scheme, [asked%pendulum], state, int(modulo(done, &
            int(asked%scheme%steps, int64))), every)
      end do
      call page%end()
   end subroutine show_orbit


   subroutine show_section(line, asked)
      type(command_line), intent(in) :: line
      type(question), intent(in) :: asked
      type(driven_state) :: state(1)
      type(sheet) :: page
      integer :: i

      state = asked%start
      call driven_periods(asked%scheme, [asked%pendulum], state, asked%transient)
      page = begin_sheet(line, [column('period', whole), angle, rate, column('turns', whole)], &
         rows=int(asked%periods, int64))
      do i = 1, asked%periods
         call driven_periods(asked%scheme, [asked%pendulum], state, 1)
         call page%row([real(asked%transient, wp) + i, state%angle, state%rate, real(state%turns, wp)])
      end do
      call page%end()
   end subroutine show_section


   subroutine show_bifurcation(line, asked)
      type(command_line), intent(in) :: line
      type(question), intent(in) :: asked
      real(wp), allocatable :: values(:)
      type(driven_pendulum), allocatable :: pendulum(:)
      type(driven_state), allocatable :: state(:), points(:, :)
      type(sheet) :: page
      integer :: first, i, j

      if (asked%vary == 0) call line%reject('over which constant? --vary drive --from 1 --to 1.5')
      call demand(asked%periods <= 100000, line%value('--periods'), '1 to 100000 for a bifurcation')
      page = begin_sheet(line, with_value(asked, [angle, rate]), rows=int(asked%points, int64)*asked%periods)
      do first = 1, asked%points, chunk
         call take_members(asked, first, values, pendulum, state)
         allocate(points(asked%periods, size(state)))
         call driven_section(asked%scheme, pendulum, state, asked%transient, points)
         do i = 1, size(state)
            do j = 1, asked%periods
               call page%row([values(i), points(j, i)%angle, points(j, i)%rate])
            end do
         end do
         deallocate(points)
      end do
      call page%end()
   end subroutine show_bifurcation


   subroutine show_exponents(line, asked)
      type(command_line), intent(in) :: line
      type(question), intent(in) :: asked
      real(wp), allocatable :: values(:), exponents(:, :), errors(:)
      type(driven_pendulum), allocatable :: pendulum(:)
      type(driven_state), allocatable :: state(:)
      type(sheet) :: page
      integer :: first, i

      call demand(asked%periods >= 16, line%value('--periods'), '16 or more, for the error')
      page = begin_sheet(line, with_value(asked, [column('exponent_1', places, 6, 12), &
         column('exponent_2', places, 6, &
         12), column('error_1', powers, 2)]), rows=int(family_size(asked), int64))
      do first = 1, family_size(asked), chunk
         call take_members(asked, first, values, pendulum, state)
         if (allocated(errors)) deallocate(exponents, errors)
         allocate(exponents(2, size(state)), errors(size(state)))
         call driven_exponents(asked%scheme, pendulum, state, asked%transient, asked%periods, &
            exponents, errors)
         do i = 1, size(state)
            call page%row(row_of(asked, values(i), [exponents(:, i), errors(i)]))
         end do
      end do
      call page%end()
   end subroutine show_exponents


   subroutine show_winding(line, asked)
      type(command_line), intent(in) :: line
      type(question), intent(in) :: asked
      real(wp), allocatable :: values(:), winding(:)
      type(driven_pendulum), allocatable :: pendulum(:)
      type(driven_state), allocatable :: state(:)
      integer, allocatable :: period(:)
      integer(int64), allocatable :: turns(:)
      type(sheet) :: page
      integer :: first, i

      page = begin_sheet(line, with_value(asked, [column('winding', places, 6, 12), column('turns', whole), &
         column('cycle', whole)]), rows=int(family_size(asked), int64))
      do first = 1, family_size(asked), chunk
         call take_members(asked, first, values, pendulum, state)
         if (allocated(winding)) deallocate(winding, period, turns)
         allocate(winding(size(state)), period(size(state)), turns(size(state)))
         call driven_winding(asked%scheme, pendulum, state, asked%transient, asked%periods, winding)
         call driven_locking(asked%scheme, pendulum, state, longest(line, asked), same, period, turns)
         do i = 1, size(state)
            if (period(i) > 0) winding(i) = real(turns(i), wp)/period(i)
            call page%row(row_of(asked, values(i), [winding(i), real(turns(i), wp), real(period(i), wp)]))
         end do
      end do
      call page%end()
   end subroutine show_winding


   !> The longest cycle that is looked for: 8 unless --cycle says something else
   function longest(line, asked) result(n)
      type(command_line), intent(in) :: line
      type(question), intent(in) :: asked
      integer :: n

      n = merge(asked%cycle, 8, line%given('--cycle'))
   end function longest


   !> The cycle next to where the start has come to
   subroutine find_cycle(line, asked, points, round)
      type(command_line), intent(in) :: line
      type(question), intent(in) :: asked
      type(driven_state), intent(out) :: points(:)
      type(driven_round), intent(out) :: round
      type(driven_state) :: state(1)
      integer :: i
      logical :: found

      state = asked%start
      call driven_periods(asked%scheme, [asked%pendulum], state, asked%transient)
      do i = 1, size(points)
         points(i) = state(1)
         call driven_periods(asked%scheme, [asked%pendulum], state, 1)
      end do
      call driven_cycle(asked%scheme, asked%pendulum, points, round, found)
      if (.not. found) call line%reject('Newton''s method finds no cycle of so many periods next to ' // &
         'where the start has come to; try another start, another --transient, another --cycle')
   end subroutine find_cycle


   subroutine show_cycle(line, asked)
      type(command_line), intent(in) :: line
      type(question), intent(in) :: asked
      type(driven_state) :: points(asked%cycle)
      type(driven_round) :: round
      type(sheet) :: page
      integer :: i

      call find_cycle(line, asked, points, round)
      page = begin_sheet(line, [column('point', whole), angle, rate, column('turns', whole), &
         column('multiplier_1_re', digits, 9, 15), column('multiplier_1_im', digits, 9, 15), &
         column('multiplier_2_re', digits, 9, 15), column('multiplier_2_im', digits, 9, 15)])
      do i = 1, asked%cycle
         call page%row([real(i, wp), points(i)%angle, points(i)%rate, real(round%turns, wp), &
            real(round%multipliers(1)), aimag(round%multipliers(1)), real(round%multipliers(2)), &
            aimag(round%multipliers(2))])
      end do
      call page%end()
   end subroutine show_cycle


   subroutine show_doublings(line, asked)
      type(command_line), intent(in) :: line
      type(question), intent(in) :: asked
      integer, parameter :: most_doublings = 10
      real(wp), parameter :: step = 0.002_wp
      type(driven_state) :: points(asked%cycle)
      type(driven_round) :: round
      type(sheet) :: page
      real(wp), allocatable :: thresholds(:)
      real(wp) :: ratio
      integer :: found, i

      if (asked%vary == 0) call line%reject('over which constant? --vary drive')
      allocate(thresholds(4))
      if (line%given('--points')) then
         deallocate(thresholds)
         allocate(thresholds(whole_of(line%value('--points'), 1, most_doublings)))
      end if
      call find_cycle(line, asked, points, round)
      call driven_cascade(asked%scheme, asked%pendulum, asked%vary, step*max(abs(driven_get(asked%pendulum, &
         asked%vary)), 0.01_wp), points, thresholds, found)
      if (found == 0) call line%reject('no doubling is found; the cycle has to be stable where it starts')
      page = begin_sheet(line, [column('cycle', whole), column(constants(asked%vary), places, 13, 15), &
         column('ratio', places, 5, 9)])
      do i = 1, found
         ratio = nan
         if (i > 2) ratio = (thresholds(i - 1) - thresholds(i - 2))/(thresholds(i) - thresholds(i - 1))
         call page%row([real(asked%cycle, wp)*2**(i - 1), thresholds(i), ratio])
      end do
      call page%end()
   end subroutine show_doublings


   !> The attractors that 256 starts of the plane find
   subroutine find_attractors(line, asked, points, label, found)
      type(command_line), intent(in) :: line
      type(question), intent(in) :: asked
      type(driven_state), intent(out) :: points(most_points)
      integer, intent(out) :: label(most_points)
      integer, intent(out) :: found
      type(driven_state), allocatable :: state(:)

      call fill_grid(line, 16, 1, 256, state)
      call driven_attractors(asked%scheme, asked%pendulum, state, asked%transient, longest(line, &
         asked), points, label, &
         found)
      if (found == 0) call line%reject('no start comes to a cycle of so many periods: try a longer ' // &
         '--transient or --cycle; chaos has none')
   end subroutine find_attractors


   !> Cells from one number to another of a grid of n angles by n rates
   subroutine fill_grid(line, n, first, last, state)
      type(command_line), intent(in) :: line
      integer, intent(in) :: n
      integer, intent(in) :: first
      integer, intent(in) :: last
      type(driven_state), allocatable, intent(out) :: state(:)
      character(len=:), allocatable :: high, low
      type(word) :: rates
      type(words) :: from, to
      integer :: i

      rates = line%value('--rates')
      high = rates%text
      call cut(high, ',', low)
      from = number_of(word(rates%what, low), no_unit)
      to = number_of(word(rates%what, high), no_unit)
      call demand(from%hi < to%hi .and. abs(from%hi) <= 1.0e6_wp .and. abs(to%hi) <= 1.0e6_wp, rates, &
         'LOW < HIGH, -1e6 to 1e6')
      allocate(state(last - first + 1))
      do i = first, last
         associate (cell => state(i - first + 1))
            cell%angle = pi*((2*modulo(i - 1, n) + 1)/real(n, wp) - 1)
            cell%rate = from%hi + (to%hi - from%hi)*(((i - 1)/n + 0.5_wp)/n)
         end associate
      end do
   end subroutine fill_grid


   subroutine show_attractors(line, asked)
      type(command_line), intent(in) :: line
      type(question), intent(in) :: asked
      type(driven_state) :: points(most_points)
      integer :: label(most_points), found, i
      type(sheet) :: page

      call find_attractors(line, asked, points, label, found)
      page = begin_sheet(line, [column('attractor', whole), column('cycle', whole), angle, rate, &
         column('turns', whole)])
      do i = 1, count(label > 0)
         call page%row([real(label(i), wp), real(count(label == label(i)), wp), points(i)%angle, &
            points(i)%rate, &
            real(points(i)%turns, wp)])
      end do
      call page%end()
   end subroutine show_attractors


   subroutine show_basins(line, asked)
      type(command_line), intent(in) :: line
      type(question), intent(in) :: asked
      type(driven_state) :: points(most_points)
      type(driven_state), allocatable :: state(:), start(:)
      integer :: label(most_points), basin(chunk), arrival(chunk), found, first, i, last, n
      type(sheet) :: page

      n = whole_of(line%value('--grid'), 1, 16384)
      call find_attractors(line, asked, points, label, found)
      page = begin_sheet(line, [angle, rate, column('attractor', whole), column('arrival', whole)], &
         rows=int(n, int64)**2)
      do first = 1, n*n, chunk
         last = min(first + chunk - 1, n*n)
         call fill_grid(line, n, first, last, state)
         start = state
         associate (cells => size(state))
            call driven_basins(asked%scheme, asked%pendulum, state, points(:count(label > 0)), label, &
               near, asked%periods, &
               basin(:cells), arrival(:cells))
         end associate
         do i = 1, size(state)
            call page%row([start(i)%angle, start(i)%rate, real(basin(i), wp), real(arrival(i), wp)])
         end do
      end do
      call page%end()
   end subroutine show_basins

end module furiko_cli_driven
