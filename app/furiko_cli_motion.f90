! SPDX-License-Identifier: MIT

!> `furiko motion` and `furiko time`: where the pendulum is at a time, and when it is somewhere.
module furiko_cli_motion
   use, intrinsic :: iso_fortran_env, only : int64, wp => real64
   use furiko, only : motion, pendulum, pendulum_rk4
   use furiko_cli_io, only : finish, refuse
   use furiko_cli_options, only : command, command_line, demand, option, word
   use furiko_cli_pendulum, only : gravity_option, length_option, motion_of, pendulum_of, start_options
   use furiko_cli_quantity, only : angle_of, in_degrees, number_of, seconds
   use furiko_cli_sheet, only : begin_sheet, column, digits, format_option, places, powers, sheet, whole
   use furiko_cli_text, only : cut, suggestion
   use furiko_word_arithmetic_dp, only : words, operator(+), operator(-), operator(*), operator(/)
   implicit none
   private
   public :: motion_usage, time_usage


   !> What --columns may name, and how it is written
   character(len=8), parameter :: names(*) = [character(len=8) :: 'time', 'angle', 'harmonic', &
      'degrees', 'rate', 'energy', 'tension', 'turns', 'phase', 'rk4', 'error']
   type(column), parameter :: columns(*) = [column('time_s', places, 6, 12), &
      column('angle_rad', places, 6, 12), column('harmonic_rad', places, 6, 12), &
      column('degrees', places, 6, 10), column('rate_rad_s', places, 6, 12), &
      column('energy_s_2', places, 6, 12), column('tension', places, 6, 10), column('turns', whole), &
      column('phase', places, 6, 12), column('rk4_rad', places, 6, 12), column('error_rad', powers, 3)]
   character(len=*), parameter :: usual_columns = 'time,angle,harmonic'
   ! More are a slip: these fill 40 terabytes
   real(wp), parameter :: most_rows = 1.0e12_wp


contains


   function motion_usage() result(usage)
      type(command) :: usage

      usage = command('motion', 'where the pendulum is, time by time', '', 0, &
         'The exact motion of a pendulum, a row for each time, from a start that --amplitude, --release ' // &
         'or --angle names; angles in degrees, or as 1rad.', &
         'The columns are time, angle, harmonic (the small-angle motion from the same start), rk4 (by ' // &
         'Runge-Kutta, a step a row) and its error, all angles in radians; degrees; rate; energy ' // &
         '(rate^2/2 - (g/l) cos(angle), that is, over m l^2); tension (over m g); turns (over the ' // &
         'top; -1 the other way); phase (the part of a period since the bottom). Without --columns ' // &
         'the text is that of the lecture note''s furiko.c, without a head.', &
         'furiko motion --amplitude 1rad --to 10 --step 0.01 --gravity 9.8', options=[ &
         start_options, &
         option('--at', 'T', '', 'one time in seconds, or as 500ms, 2min'), &
         option('--from', 'T', '0', 'first time'), &
         option('--to', 'T', '10', 'last time'), &
         option('--step', 'DT', '0.01', 'distance of the rows'), &
         option('--columns', 'LIST', '', 'which columns, as ' // usual_columns), &
         length_option, gravity_option, format_option], run=motion_command)
   end function motion_usage


   subroutine motion_command(line)
      type(command_line), intent(in) :: line
      type(motion) :: path
      type(pendulum) :: body
      type(word) :: list
      type(sheet) :: page
      type(words) :: from, step
      integer, allocatable :: chosen(:)
      real(wp) :: rk4(2)
      integer(int64) :: i, last

      list = line%value('--columns')
      if (.not. line%given('--columns')) list%text = usual_columns
      call read_columns(list, chosen)
      call read_times(line, from, step, last)
      body = pendulum_of(line)
      path = motion_of(line, body)

      if (line%given('--columns')) then
         page = begin_sheet(line, columns(chosen), rows=last + 1)
      else
         page = begin_sheet(line, free(columns(chosen)), .true., last + 1)
      end if
      rk4 = [path%angle(from%hi), path%rate(from%hi)]
      do i = 0, last
         call page%row(values(path, body, chosen, from + real(i, wp)*step, rk4(1)))
         call pendulum_rk4(body%gravity/body%length, step%hi, 1, rk4(1), rk4(2))
      end do
      call page%end()
      call finish()
   end subroutine motion_command


   !> The note's columns have no width; a blank stands between.
   pure function free(columns) result(narrow)
      type(column), intent(in) :: columns(:)
      type(column) :: narrow(size(columns))

      narrow = columns
      narrow%width = 0
   end function free


   !> The first time, the distance to the next, and how many follow
   subroutine read_times(line, from, step, last)
      type(command_line), intent(in) :: line
      type(words), intent(out) :: from
      type(words), intent(out) :: step
      integer(int64), intent(out) :: last
      type(words) :: steps, to
      type(word) :: word_from, word_step, word_to

      step = number_of(line%value('--step'), seconds)
      call demand(step%hi > 0.0_wp, line%value('--step'), 'step > 0 s')
      last = 0
      if (line%given('--at')) then
         if (line%given('--from') .or. line%given('--to')) call line%reject('--at is the only time: no ' // &
            '--from, no --to')
         from = number_of(line%value('--at'), seconds)
         return
      end if
      from = number_of(line%value('--from'), seconds)
      to = number_of(line%value('--to'), seconds)
      word_from = line%value('--from')
      word_to = line%value('--to')
      word_step = line%value('--step')
      if (from%hi > to%hi) call line%reject('--to ' // word_to%text // ' is before --from ' // word_from%text)
      steps = (to - from)/step
      if (.not. steps%hi <= most_rows) call line%reject('--step ' // word_step%text // ' up to --to ' // &
         word_to%text // ' makes more rows than 1e12')
      ! a last step that the rounding of the steps' number has made a trifle too long still counts
      last = int(steps%hi*(1 + epsilon(1.0_wp)), int64)
   end subroutine read_times


   !> Which columns a list with commas names
   subroutine read_columns(list, chosen)
      type(word), intent(in) :: list
      integer, allocatable, intent(out) :: chosen(:)
      character(len=:), allocatable :: name, rest
      integer :: i

      allocate(chosen(0))
      rest = list%text // ','
      do while (len(rest) > 0)
         call cut(rest, ',', name)
         do i = size(names), 1, -1
            if (names(i) == name) exit
         end do
         if (i == 0) call refuse(list%what // ": no column '" // name // "'; " // &
            suggestion(name, names, 'see furiko motion --help'))
         if (any(chosen == i)) call refuse(list%what // ": '" // name // "' comes twice")
         chosen = [chosen, i]
      end do
   end subroutine read_columns


   !> The chosen columns at a time, whose lower word moves what it can be seen in
   function values(path, body, chosen, time, rk4) result(row)
      type(motion), intent(in) :: path
      type(pendulum), intent(in) :: body
      integer, intent(in) :: chosen(:)
      type(words), intent(in) :: time
      !> The angle by Runge-Kutta
      real(wp), intent(in) :: rk4
      type(words) :: row(size(chosen))
      real(wp), parameter :: pi = acos(-1.0_wp)
      real(wp) :: angle, rate
      integer :: i

      angle = path%angle(time%hi)
      rate = path%rate(time%hi)
      do i = 1, size(row)
         select case (names(chosen(i)))
         case ('time')
            row(i) = time
         case ('angle')
            row(i) = words(angle) + rate*time%lo
         case ('degrees')
            row(i) = in_degrees(words(angle) + rate*time%lo)
         case ('rk4')
            row(i) = words(rk4)
         case ('error')
            row(i) = words(rk4 - angle)
         case ('harmonic')
            row(i) = words(path%harmonic_angle(time%hi))
         case ('rate')
            row(i) = words(rate - body%gravity/body%length*sin(angle)*time%lo)
         case ('energy')
            row(i) = words(path%energy())
         case ('tension')
            row(i) = words(path%tension(time%hi))
         case ('turns')
            row(i) = words(anint(angle/(2*pi)))
         case default
            row(i) = words(path%phase(time%hi))
         end select
      end do
   end function values


   function time_usage() result(usage)
      type(command) :: usage

      usage = command('time', 'when the pendulum is first at an angle, when a string goes slack', '', 0, &
         'When a pendulum is first at the angle A from the time 0 on, with its rate and the tension ' // &
         '(over m g) there, from a start that --amplitude, --release or --angle names; angles in ' // &
         'degrees, or as 1rad. With --slack: where and when a string in place of the rod goes slack.', &
         example='furiko time --release 90 --at 0', options=[ &
         option('--at', 'A', '', 'the angle, turns counted: 370 is 10 in the next turn'), &
         option('--slack', about='the angle at which the tension is first 0'), &
         start_options, length_option, gravity_option, format_option], run=time_command)
   end function time_usage


   subroutine time_command(line)
      type(command_line), intent(in) :: line
      type(motion) :: path
      type(sheet) :: page
      type(words) :: angle
      type(word) :: at
      real(wp) :: time

      if (line%given('--at') .eqv. line%given('--slack')) call line%reject('at which angle? --at 0, ' // &
         'or --slack, one of them')
      path = motion_of(line, pendulum_of(line))
      if (line%given('--at')) then
         at = line%value('--at')
         angle = angle_of(at)
      else
         angle = words(path%slack_angle())
         if (.not. abs(angle%hi) <= huge(1.0_wp)) call line%reject('a string would never go slack')
      end if
      time = path%time_to(angle%hi)
      if (.not. time <= huge(time)) call line%reject('the pendulum never gets to ' // at%text)
      page = begin_sheet(line, [column('angle_deg', digits, 12), column('time_s', digits, 12), &
         column('rate_rad_s', places, 10), column('tension', places, 10)])
      call page%row([in_degrees(angle), words(time), words(path%rate(time)), &
         words(path%tension(time))])
      call page%end()
      call finish()
   end subroutine time_command

end module furiko_cli_motion
