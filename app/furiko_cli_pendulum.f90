! SPDX-License-Identifier: MIT

!> The options that several commands share: those of the pendulum, and those of a start.
module furiko_cli_pendulum
   use, intrinsic :: iso_fortran_env, only : wp => real64
   use furiko, only : motion, pendulum
   use furiko_cli_options, only : command_line, demand, option, word
   use furiko_cli_quantity, only : angle_of, is_below_half_turn, metres, no_unit, number_of, unit
   use furiko_word_arithmetic_dp, only : words
   implicit none
   private
   public :: length_option, gravity_option, start_options, pendulum_of, length_of, gravity_of, amplitude_of, &
      motion_of


   type(option), parameter :: length_option = option('--length', 'L', '1', 'metres, or as 25cm')
   type(option), parameter :: gravity_option = option('--gravity', 'G', '9.80665', 'm/s^2')
   type(option), parameter :: start_options(*) = [ &
      option('--amplitude', 'A', '', 'through the bottom at the time 0, swinging out to A (below 180deg)'), &
      option('--release', 'A', '', 'let go at A at the time 0'), &
      option('--angle', 'A', '', 'any state at the time 0, over the top too: this angle, with --rate'), &
      option('--rate', 'R', '0', 'rad/s at the time 0, with --angle')]


contains


   function pendulum_of(line) result(body)
      type(command_line), intent(in) :: line
      type(pendulum) :: body
      type(words) :: gravity, length

      length = length_of(line)
      gravity = gravity_of(line)
      body%length = length%hi
      body%gravity = gravity%hi
   end function pendulum_of


   function length_of(line) result(length)
      type(command_line), intent(in) :: line
      type(words) :: length

      length = moderate(line%value('--length'), metres, '1e-100 <= length <= 1e100 m')
   end function length_of


   function gravity_of(line) result(gravity)
      type(command_line), intent(in) :: line
      type(words) :: gravity

      gravity = moderate(line%value('--gravity'), no_unit, '1e-100 <= gravity <= 1e100 m/s^2')
   end function gravity_of


   !> A length or gravity that no intermediate result can overflow with
   function moderate(given, units, range) result(number)
      type(word), intent(in) :: given
      type(unit), intent(in) :: units(:)
      character(len=*), intent(in) :: range
      type(words) :: number

      number = number_of(given, units)
      call demand(number%hi >= 1.0e-100_wp .and. number%hi <= 1.0e100_wp, given, range)
   end function moderate


   !> An amplitude in radians, within 0 to 180 degrees
   function amplitude_of(given) result(amplitude)
      type(word), intent(in) :: given
      type(words) :: amplitude

      amplitude = angle_of(given)
      call demand(amplitude%hi >= 0.0_wp .and. is_below_half_turn(amplitude), given, &
         '0 <= amplitude < 180 degrees')
   end function amplitude_of


   !> The motion from the start that the options name
   function motion_of(line, body) result(path)
      type(command_line), intent(in) :: line
      type(pendulum), intent(in) :: body
      type(motion) :: path
      character(len=11), parameter :: starts(3) = [character(len=11) :: '--amplitude', '--release', '--angle']
      type(words) :: angle, rate
      integer :: i, which

      which = 0
      do i = 1, 3
         if (.not. line%given(trim(starts(i)))) cycle
         if (which > 0) call line%reject(trim(starts(which)) // ' and ' // trim(starts(i)) // &
            ' are two starts; one is enough')
         which = i
      end do
      if (line%given('--rate') .and. which < 3) call line%reject('--rate goes with --angle, as --angle 0')
      if (which == 0) call line%reject('name a start, as --amplitude 1rad; see ' // line%name // ' --help')
      angle = angle_of(line%value(trim(starts(which))))
      if (which < 3) call demand(is_below_half_turn(angle), line%value(trim(starts(which))), &
         '-180 < angle < 180 degrees')
      select case (which)
      case (1)
         path = body%swinging(angle%hi, angle%lo)
      case (2)
         path = body%released(angle%hi, angle%lo)
      case default
         call demand(abs(angle%hi) <= 1.0e9_wp*acos(-1.0_wp)/180, line%value('--angle'), &
            '-1e9 <= angle <= 1e9 degrees')
         rate = number_of(line%value('--rate'), no_unit)
         call demand(abs(rate%hi) <= 1.0e100_wp, line%value('--rate'), '-1e100 <= rate <= 1e100 rad/s')
         path = body%started(angle%hi, rate%hi, angle%lo)
      end select
   end function motion_of

end module furiko_cli_pendulum
