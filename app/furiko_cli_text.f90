! SPDX-License-Identifier: MIT

!> Words: texts that grow, parts replaced, lists taken apart, whole numbers, and what was meant by a
!> misspelt word.
module furiko_cli_text
   use, intrinsic :: iso_fortran_env, only : int32, int64
   implicit none
   private
   public :: append_to, cut, replaced, suggestion, whole_text


   !> A whole number, without blanks
   interface whole_text
      module procedure :: whole_text_int32
      module procedure :: whole_text_int64
   end interface whole_text


contains


   !> Add to the first `length` characters of a text, which gets longer where it has no room. Joining long
   !> texts by // costs a copy each time, and flang makes that on the stack.
   pure subroutine append_to(text, length, more)
      character(len=:), allocatable, intent(inout) :: text
      integer, intent(inout) :: length
      character(len=*), intent(in) :: more
      character(len=:), allocatable :: longer

      if (length + len(more) > len(text)) then
         allocate(character(len=2*(length + len(more))) :: longer)
         longer(:length) = text(:length)
         call move_alloc(longer, text)
      end if
      text(length + 1:length + len(more)) = more
      length = length + len(more)
   end subroutine append_to


   !> Cut off what stands before the first of a mark, and that; all where there is none.
   pure subroutine cut(rest, mark, first)
      character(len=:), allocatable, intent(inout) :: rest
      character(len=1), intent(in) :: mark
      character(len=:), allocatable, intent(out) :: first
      integer :: place

      place = index(rest // mark, mark)
      first = rest(:place - 1)
      rest = rest(min(place + 1, len(rest) + 1):)
   end subroutine cut


   pure function whole_text_int32(number) result(text)
      integer(int32), intent(in) :: number
      character(len=:), allocatable :: text

      text = whole_text(int(number, int64))
   end function whole_text_int32


   pure function whole_text_int64(number) result(text)
      integer(int64), intent(in) :: number
      character(len=:), allocatable :: text
      character(len=20) :: buffer

      write(buffer, '(i0)') number
      text = trim(buffer)
   end function whole_text_int64


   !> A text with each of its parts `old` replaced
   pure function replaced(text, old, new)
      character(len=*), intent(in) :: text
      character(len=*), intent(in) :: old
      character(len=*), intent(in) :: new
      character(len=:), allocatable :: replaced
      character(len=:), allocatable :: rest
      integer :: place

      replaced = ''
      rest = text
      do
         place = index(rest, old)
         if (place == 0) exit
         replaced = replaced // rest(:place - 1) // new
         rest = rest(place + len(old):)
      end do
      replaced = replaced // rest
   end function replaced


   !> The question whether one of the names was meant, if one is near; else the advice.
   pure function suggestion(text, names, advice) result(hint)
      character(len=*), intent(in) :: text
      character(len=*), intent(in) :: names(:)
      character(len=*), intent(in) :: advice
      character(len=:), allocatable :: hint
      integer :: best, i, steps

      hint = advice
      best = 1 + len(text)/3
      if (len(text) > 40) return
      do i = 1, size(names)
         steps = distance(text, trim(names(i)))
         if (steps >= best) cycle
         best = steps
         hint = 'did you mean ' // trim(names(i)) // '?'
      end do
   end function suggestion


   !> How many letters to change, insert, leave out or exchange with their neighbour lead from one word
   !> to the other (Damerau's distance, by the usual table)
   pure function distance(from, to) result(steps)
      character(len=*), intent(in) :: from
      character(len=*), intent(in) :: to
      integer :: steps
      integer :: i, j, table(0:len(from), 0:len(to))

      table = 0
      table(0:, 0) = [(i, i=0, len(from))]
      table(0, 0:) = [(j, j=0, len(to))]
      do j = 1, len(to)
         do i = 1, len(from)
            table(i, j) = min(table(i - 1, j) + 1, table(i, j - 1) + 1, &
               table(i - 1, j - 1) + merge(0, 1, from(i:i) == to(j:j)))
            if (min(i, j) > 1 .and. from(max(i - 1, 1):i) == to(j:j) // to(max(j - 1, 1):j - 1)) then
               table(i, j) = min(table(i, j), table(max(i - 2, 0), max(j - 2, 0)) + 1)
            end if
         end do
      end do
      steps = table(len(from), len(to))
   end function distance

end module furiko_cli_text
