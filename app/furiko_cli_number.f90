! SPDX-License-Identifier: MIT

!> What counts as a number where people type one: Fortran's `read` takes 2*3, 1-5 and 7, as well.
module furiko_cli_number
   use, intrinsic :: iso_fortran_env, only : int64
   implicit none
   private
   public :: is_number, exponent_mark, read_whole


contains


   !> Whether text is [sign] digits [. digits] [e [sign] digits], d being as good as e.
   pure function is_number(text)
      character(len=*), intent(in) :: text
      logical :: is_number
      integer :: mark

      mark = exponent_mark(text)
      is_number = is_decimal(unsigned(text(:mark - 1)))
      if (mark <= len(text)) is_number = is_number .and. is_digits(unsigned(text(mark + 1:)))
   end function is_number


   !> [sign] digits, however many: `valid` says whether text is that. A number beyond 18 digits becomes
   !> the largest of its sign.
   pure subroutine read_whole(text, number, valid)
      character(len=*), intent(in) :: text
      integer(int64), intent(out) :: number
      logical, intent(out) :: valid
      integer, parameter :: most_digits = 18
      character(len=:), allocatable :: figures

      number = 0
      figures = unsigned(text)
      valid = is_digits(figures)
      if (.not. valid) return
      figures = figures(verify(figures // '1', '0'):)
      if (len(figures) > most_digits) then
         number = huge(number)
      else if (len(figures) > 0) then
         read(figures, '(i18)') number
      end if
      if (text(1:1) == '-') number = -number
   end subroutine read_whole


   !> Where the exponent's letter stands; behind the text where there is none.
   pure function exponent_mark(text) result(mark)
      character(len=*), intent(in) :: text
      integer :: mark

      mark = scan(text // 'e', 'eEdD')
   end function exponent_mark


   pure function unsigned(text)
      character(len=*), intent(in) :: text
      character(len=:), allocatable :: unsigned

      unsigned = text
      if (scan(text, '+-') == 1) unsigned = text(2:)
   end function unsigned


   pure function is_decimal(text)
      character(len=*), intent(in) :: text
      logical :: is_decimal
      integer :: point

      point = scan(text // '.', '.')
      is_decimal = is_digits(text(:point - 1) // text(point + 1:))
   end function is_decimal


   pure function is_digits(text)
      character(len=*), intent(in) :: text
      logical :: is_digits

      is_digits = len(text) > 0 .and. verify(text, '0123456789') == 0
   end function is_digits

end module furiko_cli_number
