! SPDX-License-Identifier: MIT

!> furiko [COMMAND] [OPTIONS]: one command for each question; without one, the table.
program main
   use furiko, only : furiko_selftest, furiko_version
   use furiko_cli_animate, only : animate_command
   use furiko_cli_arguments, only : argument_reader
   use furiko_cli_classics, only : converge_command, perimeter_command
   use furiko_cli_digits, only : digits_command
   use furiko_cli_eval, only : eval_command
   use furiko_cli_motion, only : motion_command
   use furiko_cli_period, only : amplitude_command, drift_command, period_command
   use furiko_cli_plot, only : plot_command
   use furiko_cli_rk4, only : rk4_command
   use furiko_cli_table, only : table_command
   use furiko_cli_terminal, only : complain, finish, put, quit, refuse
   implicit none
   character(len=*), parameter :: nl = new_line('a')
   character(len=*), parameter :: help = &
      'furiko [COMMAND] [OPTIONS]: elliptic functions and the exact pendulum' // nl // nl // &
      '  table      the period of a pendulum against its amplitude (without a command, too)' // nl // &
      '  motion     where the pendulum is, time by time' // nl // &
      '  period     the period for an amplitude' // nl // &
      '  amplitude  the amplitude for a period: where a pendulum is 3 % slow' // nl // &
      '  drift      how long a small-angle clock keeps step' // nl // &
      '  rk4        step by step: Runge-Kutta, Stoermer-Verlet, Forest-Ruth' // nl // &
      '  converge   series, trapezoidal rule and AGM side by side' // nl // &
      '  digits     K to 33 digits' // nl // &
      '  perimeter  of an ellipse' // nl // &
      '  plot       figures, as SVG, PNG or PDF' // nl // &
      '  eval       any function of the library on rows of arguments' // nl // &
      '  animate    the pendulum in motion, as a page for the browser' // nl // nl // &
      'furiko COMMAND --help tells more; furiko --version prints the version.'
   type(argument_reader) :: arguments
   character(len=:), allocatable :: command, word

   command = 'table'
   if (.not. arguments%done()) then
      word = arguments%word()
      if (index(word, '-') /= 1 .or. is_global(word)) then
         command = word
         call arguments%advance()
      end if
   end if

   if (furiko_selftest() /= 0) then
      call complain('furiko: this build computes wrong numbers: its compiler or flags break IEEE ' // &
         'arithmetic; see "Compiling" in README.md')
      call quit(4)
   end if

   select case (command)
   case ('table')
      call table_command(arguments)
   case ('motion')
      call motion_command(arguments)
   case ('period')
      call period_command(arguments)
   case ('amplitude')
      call amplitude_command(arguments)
   case ('drift')
      call drift_command(arguments)
   case ('rk4')
      call rk4_command(arguments)
   case ('converge')
      call converge_command(arguments)
   case ('digits')
      call digits_command(arguments)
   case ('perimeter')
      call perimeter_command(arguments)
   case ('eval')
      call eval_command(arguments)
   case ('plot')
      call plot_command(arguments)
   case ('animate')
      call animate_command(arguments)
   case ('-h', '--help', 'help')
      call put(help)
      call finish()
   case ('--version')
      call put('furiko ' // furiko_version)
      call finish()
   case default
      call refuse("furiko: unknown command '" // command // "'; see furiko --help")
   end select


contains


   !> Whether a word speaks to the program rather than to the table.
   pure logical function is_global(word)
      character(len=*), intent(in) :: word

      is_global = any(word == [character(len=9) :: '-h', '--help', '--version'])
   end function is_global

end program main
