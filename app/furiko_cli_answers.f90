! SPDX-License-Identifier: MIT

!> Rows of numbers on standard output, as text, csv or json, gathered and written many at a time.
module furiko_cli_answers
   use, intrinsic :: iso_fortran_env, only : int64
   use furiko_cli_io, only : put_text
   use furiko_cli_number, only : longest
   use furiko_cli_progress, only : progress
   implicit none
   private
   public :: answers, begin_answers, phrase


   !> Words of various lengths
   type :: phrase
      character(len=:), allocatable :: text
   end type phrase


   !> text: the numbers, a blank apart. csv: the columns' names, then numbers, a comma apart. json: an
   !> array of objects, one a line. Up to `full` characters wait for `flush`; a number is written into
   !> text(length + 1:), where `before_number` has made room.
   type :: answers
      character(len=:), allocatable :: text
      integer :: length = 0
      logical :: in_json = .false.
      character(len=:), allocatable, private :: form
      type(phrase), allocatable, private :: names(:)
      !> What stands before the number of each column
      type(phrase), allocatable, private :: labels(:)
      logical, private :: begun = .false.
      integer(int64), private :: rows = 0
      !> To be ended before anything goes to standard error
      type(progress) :: bar
   contains
      procedure :: rename
      procedure :: append
      procedure :: begin_row
      procedure :: before_number
      procedure :: end_row
      procedure :: flush => flush_answers
      procedure :: end => end_answers
   end type answers


   character(len=*), parameter :: nl = new_line('a')
   !> What a pipe of Linux holds
   integer, parameter :: full = 2**16


contains


   function begin_answers(form, names, rows) result(self)
      !> text, csv or json
      character(len=*), intent(in) :: form
      type(phrase), intent(in) :: names(:)
      !> How many there will be, if known
      integer(int64), intent(in), optional :: rows
      type(answers) :: self
      integer(int64) :: total
      integer :: i

      self%form = form
      self%in_json = form == 'json'
      self%names = names
      allocate(self%labels(size(names)))
      do i = 1, size(names)
         call self%rename(i, names(i)%text)
      end do
      allocate(character(len=2*full) :: self%text)
      total = 0
      if (present(rows)) total = rows
      call self%bar%begin(total, 'rows')
   end function begin_answers


   !> Give a column another name, before the first row.
   subroutine rename(self, column, name)
      class(answers), intent(inout) :: self
      integer, intent(in) :: column
      character(len=*), intent(in) :: name
      character(len=:), allocatable :: label

      self%names(column)%text = name
      select case (self%form)
      case ('json')
         label = merge('{', ' ', column == 1) // '"' // name // '": '
         if (column > 1) label = ',' // label
      case ('csv')
         label = repeat(',', merge(0, 1, column == 1))
      case default
         label = repeat(' ', merge(0, 1, column == 1))
      end select
      self%labels(column)%text = label
   end subroutine rename


   subroutine append(self, text)
      class(answers), intent(inout) :: self
      character(len=*), intent(in) :: text

      if (self%length + len(text) + longest > len(self%text)) call self%flush()
      if (len(text) + longest > len(self%text)) then
         call put_text(text)
      else
         self%text(self%length + 1:self%length + len(text)) = text
         self%length = self%length + len(text)
      end if
   end subroutine append


   !> What stands before all rows, once, and before this one
   subroutine begin_row(self)
      class(answers), intent(inout) :: self

      if (.not. self%begun) call begin(self)
      if (self%in_json .and. self%rows > 0) call self%append(',')
   end subroutine begin_row


   subroutine begin(self)
      class(answers), intent(inout) :: self
      integer :: i

      self%begun = .true.
      if (self%form == 'json') call self%append('[' // nl)
      if (self%form /= 'csv') return
      do i = 1, size(self%names)
         if (i > 1) call self%append(',')
         call self%append(self%names(i)%text)
      end do
      call self%append(nl)
   end subroutine begin


   subroutine before_number(self, column)
      class(answers), intent(inout) :: self
      integer, intent(in) :: column

      call self%append(self%labels(column)%text)
   end subroutine before_number


   subroutine end_row(self)
      class(answers), intent(inout) :: self

      if (self%in_json) call self%append('}')
      call self%append(nl)
      self%rows = self%rows + 1
      call self%bar%step(self%rows)
   end subroutine end_row


   !> Write what has gathered.
   subroutine flush_answers(self)
      class(answers), intent(inout) :: self

      call put_text(self%text(:self%length))
      self%length = 0
   end subroutine flush_answers


   !> What stands behind all rows
   subroutine end_answers(self)
      class(answers), intent(inout) :: self

      if (.not. self%begun) call begin(self)
      if (self%in_json) call self%append(']' // nl)
      call self%flush()
      call self%bar%end()
   end subroutine end_answers

end module furiko_cli_answers
