! SPDX-License-Identifier: MIT

!> Decimal numbers as people type them, kept exact: 179.999999 is not what a real makes of it.
module furiko_cli_decimal
   use, intrinsic :: iso_fortran_env, only : int64, wp => real64
   use furiko_cli_number, only : numeral, take_apart
   use furiko_word_arithmetic_dp, only : words, operator(-), operator(*), operator(/)
   implicit none
   private
   public :: decimal, read_decimal, rescale, to_text, to_words, fixed


   !> The number digits/10**places
   type :: decimal
      integer(int64) :: digits = 0
      integer :: places = 0
   end type decimal


   !> Keeps sums of a few such numbers, at a common number of places, within int64
   integer, parameter :: most_places = 15


contains


   !> Read a number; `valid` says whether text was one, with at most 15 places and a magnitude below
   !> 1000.
   pure subroutine read_decimal(text, number, valid)
      character(len=*), intent(in) :: text
      type(decimal), intent(out) :: number
      logical, intent(out) :: valid
      type(numeral) :: parts

      call take_apart(text, parts, valid)
      number%places = max(0, -parts%power)
      valid = valid .and. .not. (parts%more .or. parts%bare) .and. number%places <= most_places .and. &
         (parts%power < 3 .or. parts%figures == 0)
      if (.not. valid) return
      number%digits = parts%figures*10_int64**max(0, min(parts%power, 2))
      valid = number%digits < 10_int64**(number%places + 3)
      if (parts%negative) number%digits = -number%digits
   end subroutine read_decimal


   !> The same number with more places.
   elemental function rescale(number, places) result(scaled)
      type(decimal), intent(in) :: number
      integer, intent(in) :: places
      type(decimal) :: scaled

      scaled = decimal(number%digits*10_int64**(places - number%places), places)
   end function rescale


   !> All its places, and no blanks: 7, 0.50, -179.999999
   pure function to_text(number) result(text)
      type(decimal), intent(in) :: number
      character(len=:), allocatable :: text
      character(len=24) :: buffer
      integer(int64) :: rest
      integer :: place

      ! by hand: an internal write takes ten times as long
      rest = abs(number%digits)
      place = len(buffer)
      do
         buffer(place:place) = achar(iachar('0') + int(mod(rest, 10_int64)))
         rest = rest/10
         if (rest == 0 .and. place <= len(buffer) - number%places) exit
         place = place - 1
      end do
      text = buffer(place:)
      if (number%places > 0) text = text(:len(text) - number%places) // '.' // &
         text(len(text) - number%places + 1:)
      if (number%digits < 0) text = '-' // text
   end function to_text


   elemental function to_words(number) result(x)
      type(decimal), intent(in) :: number
      type(words) :: x
      real(wp) :: hi

      hi = real(number%digits, wp)
      x = words(hi, real(number%digits - int(hi, int64), wp))/10.0_wp**number%places
   end function to_words


   !> x rounded to a number of decimal places, for x times 10**places below 9e18
   pure function fixed(x, places) result(text)
      type(words), intent(in) :: x
      integer, intent(in) :: places
      character(len=:), allocatable :: text
      type(words) :: scaled
      integer(int64) :: units

      scaled = x*10.0_wp**places
      units = nint(scaled%hi, int64)
      scaled = scaled - real(units, wp)
      text = to_text(decimal(units + nint(scaled%hi, int64), places))
   end function fixed

end module furiko_cli_decimal
