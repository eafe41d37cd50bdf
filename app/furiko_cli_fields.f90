! SPDX-License-Identifier: MIT

!> The fields of a line.
!>
!> Semicolons separate them if the line has one; if not, commas; if not, tabs; if not, blanks, any
!> number of them. Blanks and tabs beside a field do not belong to it. Nothing between two semicolons,
!> commas or tabs is an empty field, as it is before the first or behind the last semicolon or comma. A
!> field may stand in double quotes, in which nothing separates.
module furiko_cli_fields
   implicit none
   private
   public :: field, split, is_skipped


   !> Where in the line a field stands, without its quotes
   type :: field
      integer :: first = 1
      integer :: last = 0
   end type field


   character(len=*), parameter :: tab = achar(9)


contains


   !> Whether a line has no row: it is blank or a comment.
   pure function is_skipped(line)
      character(len=*), intent(in) :: line
      logical :: is_skipped
      integer :: first

      first = first_in(line)
      is_skipped = first > len(line)
      if (.not. is_skipped) is_skipped = line(first:first) == '#'
   end function is_skipped


   !> The fields of a line that is not skipped; `count` is that of all, also where there is room for
   !> fewer.
   pure subroutine split(line, fields, count)
      character(len=*), intent(in) :: line
      type(field), intent(out) :: fields(:)
      integer, intent(out) :: count
      character(len=1) :: separator
      type(field) :: next
      integer :: at, last

      last = last_in(line)
      at = first_in(line)
      separator = separator_of(line(at:last))
      count = 0
      do
         call take_field(line(:last), separator, at, next)
         count = count + 1
         if (count <= size(fields)) fields(count) = next
         if (at > last + 1) exit
      end do
   end subroutine split


   !> What separates the fields of a line without blanks at its ends
   pure function separator_of(line) result(separator)
      character(len=*), intent(in) :: line
      character(len=1) :: separator
      logical :: quoted
      integer :: i

      separator = ' '
      quoted = .false.
      do i = 1, len(line)
         if (line(i:i) == '"') quoted = .not. quoted
         if (quoted) cycle
         if (line(i:i) == ';') then
            separator = ';'
            return
         end if
         if (line(i:i) == ',') separator = ','
         if (line(i:i) == tab .and. separator == ' ') separator = tab
      end do
   end function separator_of


   !> The field from a place on; that goes behind the separator, or further where the line ends.
   pure subroutine take_field(line, separator, at, next)
      character(len=*), intent(in) :: line
      character(len=1), intent(in) :: separator
      integer, intent(inout) :: at
      type(field), intent(out) :: next
      logical :: quoted
      integer :: i

      do at = at, len(line)
         if (line(at:at) == separator .and. separator /= ' ') exit
         if (.not. is_blank(line(at:at))) exit
      end do
      quoted = .false.
      do i = at, len(line)
         if (line(i:i) == '"') quoted = .not. quoted
         if (.not. quoted .and. line(i:i) == separator) exit
      end do
      next%first = at
      next%last = at - 1 + last_in(line(at:i - 1))
      at = i + 1
      if (next%last <= next%first) return
      if (line(next%first:next%first) == '"' .and. line(next%last:next%last) == '"') then
         next = field(next%first + 1, next%last - 1)
      end if
   end subroutine take_field


   !> The place of the first character that is not blank; behind the text where there is none
   pure function first_in(text) result(first)
      character(len=*), intent(in) :: text
      integer :: first

      do first = 1, len(text)
         if (.not. is_blank(text(first:first))) exit
      end do
   end function first_in


   !> The place of the last; 0 where there is none
   pure function last_in(text) result(last)
      character(len=*), intent(in) :: text
      integer :: last

      do last = len(text), 1, -1
         if (.not. is_blank(text(last:last))) exit
      end do
   end function last_in


   elemental function is_blank(character)
      character(len=1), intent(in) :: character
      logical :: is_blank

      is_blank = character == ' ' .or. character == tab
   end function is_blank

end module furiko_cli_fields
