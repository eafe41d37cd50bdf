! SPDX-License-Identifier: MIT

!> The options that several commands share: --length and --gravity, and those of a start.
module furiko_cli_pendulum
   use, intrinsic :: iso_fortran_env, only : wp => real64
   use furiko, only : pendulum
   use furiko_cli_arguments, only : argument_reader, value_of
   use furiko_cli_quantity, only : angle_of, is_below_half_turn, metres, number_of, pure_number
   use furiko_cli_terminal, only : refuse
   use furiko_double_word, only : double_word
   implicit none
   private
   public :: read_pendulum_option, amplitude_of, angle_at_start, rate_at_start


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
         call demand(in_range(body%length), command, option, word, '1e-100 <= length <= 1e100 m')
      else
         body%gravity = number_of(command // ': ' // option, word, pure_number(:0))
         call demand(in_range(body%gravity), command, option, word, '1e-100 <= gravity <= 1e100 m/s^2')
      end if
   end subroutine read_pendulum_option


   !> An angle to which the pendulum swings out, to either side
   function amplitude_of(command, option, word) result(amplitude)
      character(len=*), intent(in) :: command
      character(len=*), intent(in) :: option
      character(len=*), intent(in) :: word
      type(double_word) :: amplitude

      amplitude = angle_of(command // ': ' // option, word)
      call demand(is_below_half_turn(amplitude), command, option, word, '-180 < angle < 180 degrees')
   end function amplitude_of


   function angle_at_start(command, option, word) result(angle)
      character(len=*), intent(in) :: command
      character(len=*), intent(in) :: option
      character(len=*), intent(in) :: word
      type(double_word) :: angle
      real(wp), parameter :: most = 1.0e9_wp*acos(-1.0_wp)/180

      angle = angle_of(command // ': ' // option, word)
      call demand(abs(angle%hi) <= most, command, option, word, '-1e9 <= angle <= 1e9 degrees')
   end function angle_at_start


   function rate_at_start(command, option, word) result(rate)
      character(len=*), intent(in) :: command
      character(len=*), intent(in) :: option
      character(len=*), intent(in) :: word
      real(wp) :: rate

      rate = number_of(command // ': ' // option, word, pure_number(:0))
      call demand(abs(rate) <= 1.0e100_wp, command, option, word, '-1e100 <= rate <= 1e100 rad/s')
   end function rate_at_start


   !> Refuse a value that is outside its range.
   subroutine demand(inside, command, option, word, range)
      logical, intent(in) :: inside
      character(len=*), intent(in) :: command
      character(len=*), intent(in) :: option
      character(len=*), intent(in) :: word
      character(len=*), intent(in) :: range

      if (.not. inside) call refuse(command // ': ' // option // ' ' // word // ' is outside ' // range)
   end subroutine demand


   !> Lengths and gravities that no intermediate result can overflow with
   pure function in_range(x)
      real(wp), intent(in) :: x
      logical :: in_range

      in_range = x >= 1.0e-100_wp .and. x <= 1.0e100_wp
   end function in_range

end module furiko_cli_pendulum
