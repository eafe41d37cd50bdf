! SPDX-License-Identifier: MIT

!> Lines on standard output, one line on standard error, an exit code. Codes: 0 done, 1 the output
!> could not be written, 2 a bad command line, 3 no gnuplot, 4 this build computes wrong numbers.
!>
!> All through C's library: gfortran's own units lose what a full or closed output refuses and say
!> nothing, and Fortran 2008's `stop` prints its code.
module furiko_cli_io
   use, intrinsic :: iso_c_binding, only : c_char, c_int, c_null_char, c_null_ptr, c_ptr, c_size_t
   implicit none
   private
   public :: put, put_text, finish, refuse, fail, complain, say_why, cannot, quit, put_error, c_fflush


   interface
      function c_puts(line) result(stat) bind(c, name='puts')
         import :: c_char, c_int
         implicit none
         character(kind=c_char), intent(in) :: line(*)
         integer(c_int) :: stat
      end function c_puts

      function c_fflush(stream) result(stat) bind(c, name='fflush')
         import :: c_int, c_ptr
         implicit none
         type(c_ptr), value :: stream
         integer(c_int) :: stat
      end function c_fflush

      function c_write(descriptor, text, length) result(written) bind(c, name='write')
         import :: c_char, c_int, c_size_t
         implicit none
         integer(c_int), value :: descriptor
         character(kind=c_char), intent(in) :: text(*)
         integer(c_size_t), value :: length
         integer(c_size_t) :: written
      end function c_write

      subroutine c_perror(message) bind(c, name='perror')
         import :: c_char
         implicit none
         character(kind=c_char), intent(in) :: message(*)
      end subroutine c_perror

      subroutine c_exit(code) bind(c, name='exit')
         import :: c_int
         implicit none
         integer(c_int), value :: code
      end subroutine c_exit
   end interface


contains


   !> Write one line to standard output.
   subroutine put(line)
      character(len=*), intent(in) :: line

      if (c_puts(line // c_null_char) < 0) call fail('the output')
   end subroutine put


   !> Write text to standard output at once, line ends and all; not beside `put`, whose lines wait.
   subroutine put_text(text)
      character(len=*), intent(in) :: text
      integer(c_size_t) :: length, written

      length = 0
      do while (length < len(text))
         written = c_write(1_c_int, text(length + 1:), len(text) - length)
         if (written < 0) call fail('the output')
         length = length + written
      end do
   end subroutine put_text


   !> Flush standard output: a full disk may show only now.
   subroutine finish()
      if (c_fflush(c_null_ptr) /= 0) call fail('the output')
   end subroutine finish


   !> Answer a bad command line; does not return.
   subroutine refuse(message)
      character(len=*), intent(in) :: message

      call complain(message)
      call quit(2)
   end subroutine refuse


   !> Answer that something cannot be written; does not return.
   subroutine fail(what)
      character(len=*), intent(in) :: what

      call say_why(what)
      call quit()
   end subroutine fail


   !> Say that something cannot be written, and why, as the C library knows it.
   subroutine say_why(what)
      character(len=*), intent(in) :: what

      call cannot('write ' // what)
   end subroutine say_why


   !> Say that something cannot be done, and why, as the C library knows it.
   subroutine cannot(action)
      character(len=*), intent(in) :: action

      call c_perror('furiko: cannot ' // printable(action) // c_null_char)
   end subroutine cannot


   !> Write one line to standard error.
   subroutine complain(message)
      character(len=*), intent(in) :: message

      call put_error(printable(message) // new_line('a'))
   end subroutine complain


   !> A text that does nothing to a terminal: control characters, which a word of the command line may
   !> have in it, as \x1b
   pure function printable(text) result(safe)
      character(len=*), intent(in) :: text
      character(len=:), allocatable :: safe
      character(len=2) :: code
      integer :: i

      safe = ''
      do i = 1, len(text)
         if (iachar(text(i:i)) >= 32 .and. iachar(text(i:i)) /= 127) then
            safe = safe // text(i:i)
         else
            write(code, '(z2.2)') iachar(text(i:i))
            safe = safe // '\x' // code
         end if
      end do
   end function printable


   !> Write text to standard error at once. Whoever has closed that wants no word of it.
   subroutine put_error(text)
      character(len=*), intent(in) :: text
      integer(c_int), parameter :: standard_error = 2
      integer(c_size_t) :: ignored

      ignored = c_write(standard_error, text, len(text, c_size_t))
   end subroutine put_error


   !> End with an exit code, that of what could not be written if none is given.
   subroutine quit(code)
      integer, intent(in), optional :: code

      if (present(code)) call c_exit(int(code, c_int))
      call c_exit(1_c_int)
   end subroutine quit

end module furiko_cli_io
