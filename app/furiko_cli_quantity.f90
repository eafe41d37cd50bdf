! SPDX-License-Identifier: MIT

!> Quantities as people type them, to 30 digits: 57.3deg, 57°18', 1rad, pi/3, 50cm, 9.8, 1/2, 3%.
module furiko_cli_quantity
   use, intrinsic :: iso_fortran_env, only : int64, wp => real64
   use furiko_bits_dp, only : infinity
   use furiko_cli_decimal, only : decimal, read_decimal, to_words
   use furiko_cli_io, only : refuse
   use furiko_cli_number, only : is_number, is_out_of_range, read_number, read_whole
   use furiko_cli_options, only : word
   use furiko_cli_text, only : replaced, whole_text
   use furiko_word_arithmetic_dp, only : words, pi_words, operator(+), operator(-), operator(*), &
      operator(/)
   implicit none
   private
   public :: angle_of, in_degrees, is_below_half_turn, number_of, whole_of, unit, metres, seconds, &
      pure_number, no_unit


   !> A unit in the unit that the program computes in: times/per
   type :: unit
      character(len=3) :: name
      real(wp) :: times
      real(wp) :: per
   end type unit

   type(unit), parameter :: metres(*) = [unit('km', 1000.0_wp, 1.0_wp), unit('cm', 1.0_wp, 100.0_wp), &
      unit('mm', 1.0_wp, 1000.0_wp), unit('m', 1.0_wp, 1.0_wp)]
   type(unit), parameter :: seconds(*) = [unit('ms', 1.0_wp, 1000.0_wp), unit('min', 60.0_wp, 1.0_wp), &
      unit('h', 3600.0_wp, 1.0_wp), unit('s', 1.0_wp, 1.0_wp)]
   type(unit), parameter :: pure_number(*) = [unit('%', 1.0_wp, 100.0_wp)]
   type(unit), parameter :: no_unit(*) = pure_number(:0)


contains


   !> An angle in radians: degrees where the word says nothing else.
   function angle_of(given) result(angle)
      type(word), intent(in) :: given
      type(words) :: angle
      character(len=:), allocatable :: text
      integer :: at_pi
      logical :: valid

      text = replaced(replaced(replaced(replaced(replaced(given%text, 'deg', 'd'), '°', 'd'), &
         '′', "'"), '″', '"'), 'π', 'pi')
      at_pi = index(text, 'pi')
      if (ends_in(text, 'rad')) text = text(:len(text) - 3)
      if (at_pi > 0) then
         call read_part_of_pi(text(:at_pi - 1), text(at_pi + 2:), angle, valid)
      else if (ends_in(given%text, 'rad')) then
         call read_exactly(text, angle, valid)
      else
         call read_degrees(text, angle, valid)
         angle = quotient(angle*pi_words, words(180.0_wp))
      end if
      if (.not. valid) call refuse(given%what // " '" // given%text // &
         "' is not an angle (as 57.3, 57.3deg, 57°18', 1rad or pi/3)")
      call demand_range(angle, given)
   end function angle_of


   !> What stands in front of pi and behind it: 2pi/3, 0.5pi, -pi
   pure subroutine read_part_of_pi(front, back, angle, valid)
      character(len=*), intent(in) :: front
      character(len=*), intent(in) :: back
      type(words), intent(out) :: angle
      logical, intent(out) :: valid

      call read_exactly(front // trim(merge('1', ' ', front == '' .or. front == '+' .or. front == '-')) // &
         back, angle, valid)
      valid = valid .and. (back == '' .or. index(back, '/') == 1 .and. index(front, '/') == 0)
      angle = angle*pi_words
   end subroutine read_part_of_pi


   !> Degrees, or degrees with minutes and seconds: 57.3, 57d18', 57d17'44.8", 30'
   pure subroutine read_degrees(text, degrees, valid)
      character(len=*), intent(in) :: text
      type(words), intent(out) :: degrees
      logical, intent(out) :: valid
      character(len=1), parameter :: marks(3) = ['d', "'", '"']
      type(words) :: part
      character(len=:), allocatable :: rest
      integer :: i, mark

      degrees = words(0.0_wp)
      rest = text // trim(merge('d', ' ', scan(text, 'd''"') == 0))
      valid = .true.
      do i = 1, 3
         mark = index(rest, marks(i))
         if (mark == 0) cycle
         call read_exactly(rest(:mark - 1), part, valid)
         if (i > 1 .and. len(rest) < len(text)) valid = valid .and. scan(rest(:1), '+-') == 0
         if (i > 1) valid = valid .and. abs(part%hi) < 60.0_wp
         if (.not. valid) return
         if (index(text, '-') == 1 .and. i > 1 .and. len(rest) < len(text)) then
            part = -part
         end if
         degrees = degrees + part/60.0_wp**(i - 1)
         rest = rest(mark + 1:)
      end do
      valid = rest == ''
   end subroutine read_degrees


   !> Whether an angle is within pi on either side, to 30 digits
   pure function is_below_half_turn(angle) result(yes)
      type(words), intent(in) :: angle
      logical :: yes
      type(words) :: beyond

      beyond = words(abs(angle%hi), sign(angle%lo, angle%hi*angle%lo)) - pi_words
      yes = beyond%hi < 0.0_wp
   end function is_below_half_turn


   elemental function in_degrees(angle) result(degrees)
      type(words), intent(in) :: angle
      type(words) :: degrees

      degrees = 180.0_wp*angle/pi_words
   end function in_degrees


   !> A number in one of `units`; without a unit it stands as it is.
   function number_of(given, units) result(number)
      type(word), intent(in) :: given
      !> The longer names first where one ends in another
      type(unit), intent(in) :: units(:)
      type(words) :: number
      character(len=:), allocatable :: text
      logical :: valid
      integer :: i

      text = given%text
      do i = 1, size(units)
         if (ends_in(text, trim(units(i)%name))) exit
      end do
      if (i <= size(units)) text = text(:len(text) - len_trim(units(i)%name))
      call read_exactly(text, number, valid)
      if (.not. valid) call refuse(given%what // " '" // given%text // "' is not a number" // accepted(units))
      if (i <= size(units)) number = quotient(number*units(i)%times, words(units(i)%per))
      call demand_range(number, given)
   end function number_of


   !> A whole number from `least` to `most`.
   function whole_of(given, least, most) result(number)
      type(word), intent(in) :: given
      integer, intent(in) :: least
      integer, intent(in) :: most
      integer :: number
      integer(int64) :: whole
      logical :: valid

      call read_whole(given%text, whole, valid)
      number = int(max(min(whole, int(most, int64)), int(least, int64)))
      if (valid .and. number == whole) return
      call refuse(given%what // " '" // given%text // "' is not a whole number from " // &
         whole_text(least) // ' to ' // whole_text(most))
   end function whole_of


   !> A decimal number or a fraction a/b of two; exact decimals keep 30 digits. What is out of range is not
   !> finite.
   pure subroutine read_exactly(text, x, valid)
      character(len=*), intent(in) :: text
      type(words), intent(out) :: x
      logical, intent(out) :: valid
      type(words) :: y
      integer :: slash

      slash = index(text // '/', '/')
      call read_one(text(:slash - 1), x, valid)
      if (.not. valid .or. slash > len(text)) return
      call read_one(text(slash + 1:), y, valid)
      valid = valid .and. abs(y%hi) > 0.0_wp
      if (valid) x = quotient(x, y)
   end subroutine read_exactly


   pure subroutine read_one(text, x, valid)
      character(len=*), intent(in) :: text
      type(words), intent(out) :: x
      logical, intent(out) :: valid
      type(decimal) :: number
      integer :: verdict

      x = words(0.0_wp)
      call read_decimal(text, number, valid)
      if (valid) then
         x = to_words(number)
         return
      end if
      valid = is_number(text)
      if (.not. valid) return
      call read_number(text, x%hi, verdict)
      if (verdict == is_out_of_range) x%hi = infinity
   end subroutine read_one


   !> x/y, infinite where it would become zero
   elemental function quotient(x, y) result(z)
      type(words), intent(in) :: x
      type(words), intent(in) :: y
      type(words) :: z

      z = x/y
      if (abs(x%hi) > 0.0_wp .and. .not. abs(z%hi) > 0.0_wp) z = words(infinity)
   end function quotient


   !> Refuse what is not finite.
   subroutine demand_range(x, given)
      type(words), intent(in) :: x
      type(word), intent(in) :: given

      if (abs(x%hi) <= huge(x%hi)) return
      call refuse(given%what // " '" // given%text // "' is not a number of this range")
   end subroutine demand_range


   pure function accepted(units) result(text)
      type(unit), intent(in) :: units(:)
      character(len=:), allocatable :: text
      integer :: i

      text = ''
      if (size(units) == 0) return
      text = ' (units:'
      do i = size(units), 1, -1
         text = text // ' ' // trim(units(i)%name)
      end do
      text = text // ')'
   end function accepted


   pure function ends_in(text, ending)
      character(len=*), intent(in) :: text
      character(len=*), intent(in) :: ending
      logical :: ends_in

      ends_in = len(text) > len(ending)
      if (ends_in) ends_in = text(len(text) - len(ending) + 1:) == ending
   end function ends_in

end module furiko_cli_quantity
