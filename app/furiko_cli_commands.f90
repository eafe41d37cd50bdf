! SPDX-License-Identifier: MIT

!> All commands of the program, and those that speak of them.
module furiko_cli_commands
   use furiko, only : furiko_selftest
   use furiko_cli_animate, only : animate_usage
   use furiko_cli_converge, only : converge_usage
   use furiko_cli_digits, only : digits_usage
   use furiko_cli_driven, only : driven_usage
   use furiko_cli_ellipse, only : arc_usage, perimeter_usage
   use furiko_cli_eval, only : eval_usage
   use furiko_cli_help, only : put_bash, put_fish, put_help, put_manual, put_overview, put_zsh
   use furiko_cli_io, only : finish, put, refuse
   use furiko_cli_motion, only : motion_usage, time_usage
   use furiko_cli_options, only : command, command_line
   use furiko_cli_period, only : amplitude_usage, drift_usage, period_usage
   use furiko_cli_plot, only : plot_usage
   use furiko_cli_rk4, only : rk4_usage
   use furiko_cli_table, only : table_usage
   use furiko_cli_text, only : suggestion, whole_text
   implicit none
   private
   public :: find_command


   integer, parameter :: how_many = 19


contains


   function all_commands() result(commands)
      type(command) :: commands(how_many)

      commands(1) = table_usage()
      commands(2) = motion_usage()
      commands(3) = time_usage()
      commands(4) = period_usage()
      commands(5) = amplitude_usage()
      commands(6) = drift_usage()
      commands(7) = rk4_usage()
      commands(8) = driven_usage()
      commands(9) = converge_usage()
      commands(10) = digits_usage()
      commands(11) = perimeter_usage()
      commands(12) = arc_usage()
      commands(13) = plot_usage()
      commands(14) = eval_usage()
      commands(15) = animate_usage()
      commands(16) = selftest_usage()
      commands(17) = help_usage()
      commands(18) = man_usage()
      commands(19) = completion_usage()
   end function all_commands


   !> The command of a name
   function find_command(name) result(usage)
      character(len=*), intent(in) :: name
      type(command) :: usage
      type(command) :: commands(how_many)
      integer :: i

      commands = all_commands()
      do i = 1, size(commands)
         if (commands(i)%name == name) then
            usage = commands(i)
            return
         end if
      end do
      call refuse("furiko: unknown command '" // name // "'; " // &
         suggestion(name, [(commands(i)%name, i=1, size(commands))], 'see furiko --help'))
   end function find_command


   function selftest_usage() result(usage)
      type(command) :: usage

      usage = command('selftest', 'whether this build computes what it should', '', 0, &
         'Compares some values of every part of the library with known ones, in each kind of real: a ' // &
         'build whose compiler or flags break IEEE arithmetic is found by it.', run=selftest_command)
      allocate(usage%options(0))
   end function selftest_usage


   !> The program has looked already, as it does before any command.
   subroutine selftest_command(line)
      type(command_line), intent(in) :: line

      call put(line%name // ': ' // whole_text(furiko_selftest()) // ' of the known values are wrong')
      call finish()
   end subroutine selftest_command


   function help_usage() result(usage)
      type(command) :: usage

      usage = command('help', 'what a command does and takes', '[COMMAND]', 1, &
         'What a command does and takes; without COMMAND, which commands there are.', &
         example='furiko help motion', run=help_command)
      allocate(usage%options(0))
   end function help_usage


   subroutine help_command(line)
      type(command_line), intent(in) :: line

      if (size(line%operands) > 0) then
         call put_help(find_command(line%operands(1)%text))
      else
         call put_overview(all_commands())
      end if
      call finish()
   end subroutine help_command


   function man_usage() result(usage)
      type(command) :: usage

      usage = command('man', 'the manual page, for man', '', 0, &
         'Prints the manual page, to be put where man finds it, or read at once.', &
         example='furiko man > furiko.1 && man ./furiko.1', run=man_command)
      allocate(usage%options(0))
   end function man_usage


   subroutine man_command(line)
      type(command_line), intent(in) :: line

      call put('.\" Written by ' // line%name)
      call put_manual(all_commands())
      call finish()
   end subroutine man_command


   function completion_usage() result(usage)
      type(command) :: usage

      usage = command('completion', 'the words a shell completes: bash, zsh, fish', 'bash|zsh|fish', 1, &
         'Prints what a shell needs to complete the commands and options of furiko.', &
         'For zsh: furiko completion zsh > _furiko in a folder of $fpath. For fish: furiko completion ' // &
         'fish > ~/.config/fish/completions/furiko.fish', &
         'furiko completion bash >> ~/.bashrc', run=completion_command)
      allocate(usage%options(0))
   end function completion_usage


   subroutine completion_command(line)
      type(command_line), intent(in) :: line

      if (size(line%operands) == 0) call line%reject('for which shell? bash, zsh or fish')
      select case (line%operands(1)%text)
      case ('bash')
         call put_bash(all_commands())
      case ('zsh')
         call put_zsh(all_commands())
      case ('fish')
         call put_fish(all_commands())
      case default
         call line%reject("'" // line%operands(1)%text // "' is none of bash, zsh, fish")
      end select
      call finish()
   end subroutine completion_command

end module furiko_cli_commands
