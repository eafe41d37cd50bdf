! SPDX-License-Identifier: MIT

!> Standard input or a file line by line, in constant memory; what one read of it has brought is there at
!> once.
module furiko_cli_input
   use, intrinsic :: iso_c_binding, only : c_char, c_int, c_intptr_t, c_size_t
   use furiko_cli_io, only : cannot, quit
   implicit none
   private
   public :: line_input, longest_line


   !> Characters; a longer line is no row of a table, and must not take all memory
   integer, parameter :: longest_line = 10**6
   !> What a pipe of Linux holds
   integer, parameter :: first_size = 2**16


   !> The lines that are there are walked by `next_line`; behind the last of them `refill` waits for
   !> more. The text lies between `start` and `length` of a buffer that grows for a long line only.
   type :: line_input
      private
      character(len=:), allocatable, public :: text
      !> Where in the text the line stands, without its end
      integer, public :: first = 1
      integer, public :: last = 0
      !> Its number
      integer, public :: number = 0
      logical, public :: at_end = .false.
      !> Its descriptor, and what a message calls it; standard input's if no name is given
      integer(c_int), public :: file = 0_c_int
      character(len=:), allocatable, public :: name
      !> What follows the line, how much of it is known to have no end of a line, and all there is
      integer :: start = 1
      integer :: searched = 0
      integer :: length = 0
   contains
      procedure :: next_line
      procedure :: refill
      procedure :: begins_with
   end type line_input


   interface
      function c_read(file, text, size) result(count) bind(c, name='read')
         import :: c_char, c_int, c_intptr_t, c_size_t
         implicit none
         integer(c_int), value :: file
         character(kind=c_char), intent(inout) :: text(*)
         integer(c_size_t), value :: size
         integer(c_intptr_t) :: count
      end function c_read
   end interface


contains


   !> Go to the next line; `found` says whether one is there, whole, or longer than any may be.
   subroutine next_line(self, found)
      class(line_input), intent(inout) :: self
      logical, intent(out) :: found
      integer :: i

      do i = max(self%start, self%searched + 1), self%length
         if (self%text(i:i) == new_line('a')) exit
      end do
      self%searched = i - 1
      found = i <= self%length .or. i - self%start > longest_line
      if (.not. found) return
      self%number = self%number + 1
      self%first = self%start
      self%last = i - 1
      self%start = i + 1
      if (self%number == 1) self%first = self%first + mark_length(self%text(self%first:self%last))
      if (self%last >= self%first) then
         if (self%text(self%last:self%last) == achar(13)) self%last = self%last - 1
      end if
   end subroutine next_line


   !> The length of the mark in front that says: this is UTF-8
   pure function mark_length(text) result(length)
      character(len=*), intent(in) :: text
      integer :: length
      character(len=*), parameter :: mark = char(239) // char(187) // char(191)

      length = 0
      if (index(text, mark) == 1) length = len(mark)
   end function mark_length


   !> Read what is there, or wait for it; a last line without an end gets one.
   subroutine refill(self)
      class(line_input), intent(inout) :: self
      integer(c_intptr_t) :: count
      integer :: rest

      rest = self%length - self%start + 1
      call make_room(self, rest)
      count = c_read(self%file, self%text(rest + 1:), int(len(self%text) - rest, c_size_t))
      if (count < 0) call give_up(self)
      self%at_end = count == 0
      self%length = rest + int(count)
      if (self%at_end .and. rest > 0) then
         self%length = self%length + 1
         self%text(self%length:self%length) = new_line('a')
      end if
   end subroutine refill


   !> Bring the rest of the text to the front, into a buffer of twice the size where it fills that.
   subroutine make_room(self, rest)
      class(line_input), intent(inout) :: self
      integer, intent(in) :: rest
      character(len=:), allocatable :: larger

      if (.not. allocated(self%text)) allocate(character(len=first_size) :: self%text)
      if (2*rest > len(self%text)) then
         allocate(character(len=2*len(self%text)) :: larger)
         larger(:rest) = self%text(self%start:self%length)
         call move_alloc(larger, self%text)
      else if (self%start > 1) then
         self%text(:rest) = self%text(self%start:self%length)
      end if
      self%searched = max(0, self%searched - self%start + 1)
      self%start = 1
   end subroutine make_room


   !> Whether what the first `refill` has brought begins with some bytes
   pure function begins_with(self, bytes) result(yes)
      class(line_input), intent(in) :: self
      character(len=*), intent(in) :: bytes
      logical :: yes

      yes = self%length >= len(bytes)
      if (yes) yes = self%text(:len(bytes)) == bytes
   end function begins_with


   !> Say why, as the C library knows it; does not return.
   subroutine give_up(self)
      class(line_input), intent(in) :: self

      if (allocated(self%name)) call cannot('read ' // self%name)
      if (.not. allocated(self%name)) call cannot('read standard input')
      call quit(2)
   end subroutine give_up

end module furiko_cli_input
