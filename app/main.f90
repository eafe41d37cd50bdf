! SPDX-License-Identifier: MIT

!> furiko [COMMAND] [OPTIONS]: one command for each question; without one, the table.
program main
   use furiko, only : furiko_selftest, furiko_version
   ! allow(C121)
   use furiko_c ! nothing of it: lest fpm leaves it out of the library
   use furiko_cli_commands, only : find_command
   use furiko_cli_help, only : put_help
   use furiko_cli_io, only : complain, finish, put, quit
   use furiko_cli_options, only : argument, command, command_line, read_command_line
   use furiko_cli_process, only : settle_signals
   implicit none
   type(command) :: chosen
   type(command_line) :: line
   character(len=:), allocatable :: name
   integer :: next
   logical :: asks_help

   call settle_signals()
   if (furiko_selftest() /= 0) then
      call complain('furiko: this build computes wrong numbers: its compiler or flags break IEEE ' // &
         'arithmetic; see "Compiling" in README.md')
      call quit(4)
   end if

   name = 'table'
   next = 1
   if (command_argument_count() > 0) name = argument(1)
   if (name == '--version') then
      call put('furiko ' // furiko_version)
      call finish()
      call quit(0)
   end if
   if (name == '-h' .or. name == '--help') name = 'help'
   if (index(name, '-') == 1) then
      name = 'table'
   else
      next = 2
   end if
   chosen = find_command(name)
   call read_command_line(chosen, next, line, asks_help)
   if (asks_help) then
      call put_help(chosen)
      call finish()
   else
      call chosen%run(line)
   end if
end program main
