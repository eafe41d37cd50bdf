! SPDX-License-Identifier: MIT

!> Rows of numbers that are read once and gone through twice, however many there are: the first hundred
!> thousand in memory, the rest in a scratch file.
module furiko_cli_store
   use, intrinsic :: iso_fortran_env, only : int64, wp => real64
   use furiko_cli_io, only : fail
   implicit none
   private
   public :: store, begin_store


   integer, parameter :: most_rows = 131072


   type :: store
      private
      integer(int64), public :: rows = 0
      real(wp), allocatable :: block(:, :)
      !> Rows in the block, blocks in the file, and the next row to be read, of all and of the block
      integer :: filled = 0
      integer :: blocks = 0
      integer(int64) :: next = 1
      integer :: unit = 0
   contains
      procedure :: add
      procedure :: rewind => to_first
      procedure :: take
   end type store


contains


   function begin_store(columns) result(self)
      integer, intent(in) :: columns
      type(store) :: self

      allocate(self%block(columns, most_rows))
   end function begin_store


   subroutine add(self, row)
      class(store), intent(inout) :: self
      real(wp), intent(in) :: row(:)

      if (self%filled == most_rows) call put_away(self)
      self%filled = self%filled + 1
      self%rows = self%rows + 1
      self%block(:, self%filled) = row
   end subroutine add


   !> Write the block into the scratch file.
   subroutine put_away(self)
      class(store), intent(inout) :: self
      integer :: stat

      stat = 0
      if (self%blocks == 0) open(newunit=self%unit, status='scratch', access='stream', form='unformatted', &
         action='readwrite', iostat=stat)
      if (stat == 0) write(self%unit, iostat=stat) self%block(:, :self%filled)
      if (stat /= 0) call fail('a temporary file')
      self%blocks = self%blocks + 1
      self%filled = 0
   end subroutine put_away


   !> Begin to read; nothing can be added from then on.
   subroutine to_first(self)
      class(store), intent(inout) :: self
      integer :: stat

      self%next = 1
      if (self%blocks == 0) return
      if (self%filled > 0) call put_away(self)
      rewind(self%unit, iostat=stat)
      if (stat /= 0) call fail('a temporary file')
   end subroutine to_first


   !> The next row; `found` is false behind the last one.
   subroutine take(self, row, found)
      class(store), intent(inout) :: self
      real(wp), intent(out) :: row(:)
      logical, intent(out) :: found
      integer :: at, length, stat

      found = self%next <= self%rows
      if (.not. found) return
      at = int(modulo(self%next - 1, int(most_rows, int64))) + 1
      if (at == 1 .and. self%blocks > 0) then
         length = int(min(self%rows - self%next + 1, int(most_rows, int64)))
         read(self%unit, iostat=stat) self%block(:, :length)
         if (stat /= 0) call fail('a temporary file')
      end if
      row = self%block(:, at)
      self%next = self%next + 1
   end subroutine take

end module furiko_cli_store
