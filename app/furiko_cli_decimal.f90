! SPDX-License-Identifier: MIT

!> Decimal numbers as people type them, kept exact: 179.999999 is not what a real makes of it.
module furiko_cli_decimal
   use, intrinsic :: iso_fortran_env, only : int64, wp => real64
   use furiko_cli_number, only : exponent_mark, is_number, read_whole
   use furiko_double_word, only : double_word, operator(-), operator(*), operator(/)
   implicit none
   private
   public :: decimal, read_decimal, rescale, to_text, to_double_word, fixed


   !> The number digits/10**places
   type :: decimal
      integer(int64) :: digits = 0
      integer :: places = 0
   end type decimal


   !> Bounds that keep sums of a few such numbers, at a common number of places, within int64
   integer, parameter :: most_figures = 18
   integer, parameter :: most_places = 15


contains


   !> Read a number; `valid` says whether text was one, with at most 15 places and a magnitude below
   !> 1000.
   pure subroutine read_decimal(text, number, valid)
      character(len=*), intent(in) :: text
      type(decimal), intent(out) :: number
      logical, intent(out) :: valid
      character(len=:), allocatable :: figures
      integer(int64) :: power
      integer :: mark, point, start

      valid = .false.
      if (.not. is_number(text)) return
      mark = exponent_mark(text)
      power = 0
      if (mark <= len(text)) then
         call read_whole(text(mark + 1:), power, valid)
         valid = .false.
         if (abs(power) > 99) return
      end if
      start = 1
      if (scan(text, '+-') == 1) start = 2
      point = scan(text(:mark - 1) // '.', '.')
      figures = text(start:point - 1) // text(point + 1:mark - 1)
      number%places = max(0, mark - 1 - point) - int(power)
      if (number%places < 0) figures = figures // repeat('0', min(-number%places, most_figures))
      number%places = max(0, number%places)
      figures = figures(verify(figures // '1', '0'):)
      if (len(figures) > most_figures .or. number%places > most_places) return
      if (len(figures) - number%places > 3) return

      if (len(figures) > 0) read(figures, '(i18)') number%digits
      if (text(1:1) == '-') number%digits = -number%digits
      valid = .true.
   end subroutine read_decimal


   !> The same number with more places.
   elemental function rescale(number, places) result(scaled)
      type(decimal), intent(in) :: number
      integer, intent(in) :: places
      type(decimal) :: scaled

      scaled = decimal(number%digits*10_int64**(places - number%places), places)
   end function rescale


   !> All its places, and no blanks: 7, 0.50, 179.999999. For numbers >= 0.
   pure function to_text(number) result(text)
      type(decimal), intent(in) :: number
      character(len=:), allocatable :: text
      character(len=24) :: buffer
      integer(int64) :: rest
      integer :: place

      ! by hand: an internal write takes ten times as long
      rest = number%digits
      place = len(buffer)
      do
         buffer(place:place) = achar(iachar('0') + int(mod(rest, 10_int64)))
         rest = rest/10
         if (rest == 0 .and. place <= len(buffer) - number%places) exit
         place = place - 1
      end do
      text = buffer(place:)
      if (number%places == 0) return
      text = text(:len(text) - number%places) // '.' // text(len(text) - number%places + 1:)
   end function to_text


   elemental function to_double_word(number) result(x)
      type(decimal), intent(in) :: number
      type(double_word) :: x
      real(wp) :: hi

      hi = real(number%digits, wp)
      x = double_word(hi, real(number%digits - int(hi, int64), wp)) &
         /double_word(10.0_wp**number%places)
   end function to_double_word


   !> x >= 0, below 9000, correctly rounded to 15 decimals.
   pure function fixed(x) result(text)
      type(double_word), intent(in) :: x
      character(len=:), allocatable :: text
      integer(int64), parameter :: unit = 10_int64**15
      type(double_word) :: rest
      integer(int64) :: units, whole

      whole = int(x%hi, int64)
      rest = (x - double_word(real(whole, wp)))*double_word(real(unit, wp))
      units = nint(rest%hi, int64)
      rest = rest - double_word(real(units, wp))
      units = whole*unit + units + nint(rest%hi, int64)
      text = to_text(decimal(units, 15))
   end function fixed

end module furiko_cli_decimal
