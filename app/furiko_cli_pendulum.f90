! SPDX-License-Identifier: MIT

!> The options that several commands share: --length and --gravity.
module furiko_cli_pendulum
   use, intrinsic :: iso_fortran_env, only : wp => real64
   use furiko, only : pendulum
   use furiko_cli_arguments, only : argument_reader, value_of
   use furiko_cli_quantity, only : metres, number_of, pure_number
   use furiko_cli_terminal, only : refuse
   implicit none
   private
   public :: read_pendulum_option


contains


   !> Take the option if it is one of the pendulum's; `known` tells.
   subroutine read_pendulum_option(command, option, arguments, body, known)
      character(len=*), intent(in) :: command
      character(len=*), intent(in) :: option
      type(argument_reader), intent(inout) :: arguments
      type(pendulum), intent(inout) :: body
      logical, intent(out) :: known
      character(len=:), allocatable :: word

      known = option == '--length' .or. option == '--gravity'
      if (.not. known) return
      word = value_of(command, option, arguments)
      if (option == '--length') then
         body%length = number_of(command // ': ' // option, word, metres)
         if (.not. in_range(body%length)) call refuse(command // ': ' // option // ' ' // word // &
            ' is outside 1e-100 <= length <= 1e100 m')
      else
         body%gravity = number_of(command // ': ' // option, word, pure_number(:0))
         if (.not. in_range(body%gravity)) call refuse(command // ': ' // option // ' ' // word // &
            ' is outside 1e-100 <= gravity <= 1e100 m/s^2')
      end if
   end subroutine read_pendulum_option


   !> Lengths and gravities that no intermediate result can overflow with
   pure function in_range(x)
      real(wp), intent(in) :: x
      logical :: in_range

      in_range = x >= 1.0e-100_wp .and. x <= 1.0e100_wp
   end function in_range

end module furiko_cli_pendulum
