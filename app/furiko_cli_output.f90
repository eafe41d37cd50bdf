! SPDX-License-Identifier: MIT

!> Where a command's `-o` goes: a file, whole or not at all, or standard output for `-`.
module furiko_cli_output
   use, intrinsic :: iso_c_binding, only : c_associated, c_char, c_int, c_null_char, c_null_ptr, c_ptr
   use furiko_cli_terminal, only : fail, finish, print_line => put, quit, say_why
   implicit none
   private
   public :: output, open_output


   !> A file is written under another name beside it, which it bears until `close`. What is empty or
   !> in /dev (so any device, pipe or link to one) is written in place, and emptied where that fails.
   type :: output
      private
      character(len=:), allocatable :: file
      !> The name it is written under
      character(len=:), allocatable :: draft
      !> C's stream, or null for standard output
      type(c_ptr) :: stream = c_null_ptr
   contains
      procedure :: put
      procedure :: close
   end type output


   interface
      function c_fopen(file, mode) result(stream) bind(c, name='fopen')
         import :: c_char, c_ptr
         implicit none
         character(kind=c_char), intent(in) :: file(*)
         character(kind=c_char), intent(in) :: mode(*)
         type(c_ptr) :: stream
      end function c_fopen

      function c_fputs(text, stream) result(stat) bind(c, name='fputs')
         import :: c_char, c_int, c_ptr
         implicit none
         character(kind=c_char), intent(in) :: text(*)
         type(c_ptr), value :: stream
         integer(c_int) :: stat
      end function c_fputs

      function c_fclose(stream) result(stat) bind(c, name='fclose')
         import :: c_int, c_ptr
         implicit none
         type(c_ptr), value :: stream
         integer(c_int) :: stat
      end function c_fclose

      function c_rename(old, new) result(stat) bind(c, name='rename')
         import :: c_char, c_int
         implicit none
         character(kind=c_char), intent(in) :: old(*)
         character(kind=c_char), intent(in) :: new(*)
         integer(c_int) :: stat
      end function c_rename

      function c_remove(file) result(stat) bind(c, name='remove')
         import :: c_char, c_int
         implicit none
         character(kind=c_char), intent(in) :: file(*)
         integer(c_int) :: stat
      end function c_remove
   end interface


contains


   !> Make sure that a file can be written, before any work is done for it.
   function open_output(file) result(self)
      character(len=*), intent(in) :: file
      type(output) :: self
      logical :: exists
      integer :: length

      self%file = file
      self%draft = file
      if (file == '-') return
      inquire(file=file, exist=exists, size=length)
      if (exists) then
         ! Neither creates nor empties: a folder or a file under write protection shows here.
         self%stream = c_fopen(file // c_null_char, 'r+' // c_null_char)
         if (.not. c_associated(self%stream)) call fail(file)
         if (c_fclose(self%stream) /= 0) call fail(file)
      end if
      if (length /= 0 .and. index(file, '/dev/') /= 1) self%draft = file // '.part'
      self%stream = c_fopen(self%draft // c_null_char, 'w' // c_null_char)
      if (.not. c_associated(self%stream)) call fail(file)
   end function open_output


   !> Write one line.
   subroutine put(self, line)
      class(output), intent(in) :: self
      character(len=*), intent(in) :: line

      if (.not. c_associated(self%stream)) then
         call print_line(line)
      else if (c_fputs(line // new_line('a') // c_null_char, self%stream) < 0) then
         call give_up(self)
      end if
   end subroutine put


   !> A full disk may show only now; then the file is what it was before.
   subroutine close(self)
      class(output), intent(in) :: self

      if (.not. c_associated(self%stream)) then
         call finish()
         return
      end if
      if (c_fclose(self%stream) /= 0) call give_up(self)
      if (self%draft == self%file) return
      if (c_rename(self%draft // c_null_char, self%file // c_null_char) /= 0) call give_up(self)
   end subroutine close


   !> Leave no part of the file behind; does not return.
   subroutine give_up(self)
      class(output), intent(in) :: self
      type(c_ptr) :: emptied
      integer(c_int) :: ignored

      call say_why(self%file)
      if (self%draft /= self%file) then
         ignored = c_remove(self%draft // c_null_char)
      else
         emptied = c_fopen(self%file // c_null_char, 'w' // c_null_char)
         if (c_associated(emptied)) ignored = c_fclose(emptied)
      end if
      call quit()
   end subroutine give_up

end module furiko_cli_output
