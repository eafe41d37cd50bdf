! SPDX-License-Identifier: MIT

!> Quantities as people type them: 57.3deg, 1rad, 50cm, 9.8, 1/2, 3%.
module furiko_cli_quantity
   use, intrinsic :: iso_fortran_env, only : int64, wp => real64
   use furiko_bits_dp, only : infinity
   use furiko_cli_decimal, only : decimal, read_decimal, to_double_word
   use furiko_cli_number, only : is_number, read_whole
   use furiko_cli_terminal, only : refuse
   use furiko_double_word, only : double_word, double_word_pi, operator(-), operator(*), operator(/)
   implicit none
   private
   public :: angle_of, is_below_half_turn, number_of, integer_of, unit, metres, seconds, pure_number


   !> A unit and its size in the unit that the program computes in
   type :: unit
      character(len=3) :: name
      real(wp) :: size
   end type unit

   type(unit), parameter :: metres(*) = [unit('km', 1000.0_wp), unit('cm', 0.01_wp), &
      unit('mm', 0.001_wp), unit('m', 1.0_wp)]
   type(unit), parameter :: seconds(*) = [unit('ms', 0.001_wp), unit('min', 60.0_wp), &
      unit('h', 3600.0_wp), unit('s', 1.0_wp)]
   type(unit), parameter :: pure_number(*) = [unit('%', 0.01_wp)]


contains


   !> An angle in radians, to 30 digits: degrees where the word does not end in rad.
   function angle_of(what, word) result(angle)
      !> Who asks for it, as in 'furiko motion: --angle'
      character(len=*), intent(in) :: what
      character(len=*), intent(in) :: word
      type(double_word) :: angle
      character(len=:), allocatable :: text
      logical :: in_radians, valid

      text = word
      in_radians = ends_in(word, 'rad')
      if (in_radians .or. ends_in(word, 'deg')) text = word(:len(word) - 3)
      call read_exactly(text, angle, valid)
      if (.not. valid) call refuse(what // " '" // word // "' is not an angle (as 57.3, 57.3deg or 1rad)")
      if (.not. in_radians) angle = angle*double_word_pi/double_word(180.0_wp)
      if (.not. in_range(angle%hi, text)) then
         call refuse(what // " '" // word // "' is not a number of this range")
      end if
   end function angle_of


   !> Whether an angle is within pi on either side, to 30 digits
   pure function is_below_half_turn(angle) result(yes)
      type(double_word), intent(in) :: angle
      logical :: yes
      type(double_word) :: beyond

      beyond = double_word(abs(angle%hi), sign(angle%lo, angle%hi*angle%lo)) - double_word_pi
      yes = beyond%hi < 0.0_wp
   end function is_below_half_turn


   !> A number in one of `units`; without a unit it stands as it is.
   function number_of(what, word, units) result(number)
      character(len=*), intent(in) :: what
      character(len=*), intent(in) :: word
      !> The longer names first where one ends in another
      type(unit), intent(in) :: units(:)
      real(wp) :: number
      character(len=:), allocatable :: text
      type(double_word) :: x
      real(wp) :: size_of_unit
      logical :: valid
      integer :: i

      text = word
      size_of_unit = 1.0_wp
      do i = 1, size(units)
         if (.not. ends_in(word, trim(units(i)%name))) cycle
         text = word(:len(word) - len_trim(units(i)%name))
         size_of_unit = units(i)%size
         exit
      end do
      call read_exactly(text, x, valid)
      if (.not. valid) call refuse(what // " '" // word // "' is not a number" // accepted(units))
      number = x%hi
      ! 3% is 3/100, not 3 times a rounded 0.01
      if (size_of_unit < 1.0_wp) then
         number = number/nint(1/size_of_unit)
      else
         number = number*size_of_unit
      end if
      if (.not. in_range(number, text)) call refuse(what // " '" // word // "' is not a number of this range")
   end function number_of


   !> A whole number from `least` to `most`.
   function integer_of(what, word, least, most) result(number)
      character(len=*), intent(in) :: what
      character(len=*), intent(in) :: word
      integer, intent(in) :: least
      integer, intent(in) :: most
      integer :: number
      character(len=12) :: bounds(2)
      integer(int64) :: whole
      logical :: valid

      call read_whole(word, whole, valid)
      number = int(max(min(whole, int(most, int64)), int(least, int64)))
      if (valid .and. number == whole) return
      write(bounds, '(i0)') least, most
      call refuse(what // " '" // word // "' is not a whole number from " // trim(bounds(1)) // &
         ' to ' // trim(bounds(2)))
   end function integer_of


   !> A decimal number or a fraction a/b of two; exact decimals keep 30 digits.
   pure subroutine read_exactly(text, x, valid)
      character(len=*), intent(in) :: text
      type(double_word), intent(out) :: x
      logical, intent(out) :: valid
      type(double_word) :: y
      integer :: slash

      slash = index(text // '/', '/')
      call read_one(text(:slash - 1), x, valid)
      if (.not. valid .or. slash > len(text)) return
      call read_one(text(slash + 1:), y, valid)
      valid = valid .and. is_nonzero(text(slash + 1:))
      if (valid) x = x/y
   end subroutine read_exactly


   !> A number out of range is infinite, or zero.
   pure subroutine read_one(text, x, valid)
      character(len=*), intent(in) :: text
      type(double_word), intent(out) :: x
      logical, intent(out) :: valid
      type(decimal) :: number
      integer :: stat

      call read_decimal(text, number, valid)
      if (valid) then
         x = to_double_word(number)
         return
      end if
      valid = is_number(text)
      if (.not. valid) return
      read(text, *, iostat=stat) x%hi
      if (stat /= 0) x%hi = infinity
   end subroutine read_one


   !> Whether x, read from a number or fraction, is finite, and zero only where a zero was typed
   pure function in_range(x, text)
      real(wp), intent(in) :: x
      character(len=*), intent(in) :: text
      logical :: in_range

      in_range = abs(x) <= huge(x) .and. (abs(x) > 0.0_wp .or. .not. is_nonzero(text))
   end function in_range


   !> Whether the number in front, before any exponent and fraction, has a digit other than zero
   pure function is_nonzero(text)
      character(len=*), intent(in) :: text
      logical :: is_nonzero

      is_nonzero = scan(text(:scan(text // '/', '/eEdD') - 1), '123456789') > 0
   end function is_nonzero


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


   pure function ends_in(word, ending)
      character(len=*), intent(in) :: word
      character(len=*), intent(in) :: ending
      logical :: ends_in

      ends_in = len(word) > len(ending)
      if (ends_in) ends_in = word(len(word) - len(ending) + 1:) == ending
   end function ends_in

end module furiko_cli_quantity
