! SPDX-License-Identifier: MIT

!> What the program says and how it ends: data on standard output, one line on standard error,
!> an exit code. Codes: 0 done, 1 the output could not be written, 2 a bad command line, 3 no gnuplot,
!> 4 this build computes wrong numbers.
!>
!> Output goes through C's library: gfortran's own units lose what a full or closed output refuses
!> and say nothing, and Fortran 2008's `stop` prints its code.
module furiko_cli_terminal
   use, intrinsic :: iso_fortran_env, only : error_unit
   use, intrinsic :: iso_c_binding, only : c_char, c_int, c_null_char, c_null_ptr, c_ptr
   implicit none
   private
   public :: put, finish, refuse, fail, complain, say_why, quit


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

      call c_perror('furiko: cannot write ' // what // c_null_char)
   end subroutine say_why


   !> Write one line to standard error.
   subroutine complain(message)
      character(len=*), intent(in) :: message

      write(error_unit, '(a)') message
   end subroutine complain


   !> End with an exit code, that of what could not be written if none is given.
   subroutine quit(code)
      integer, intent(in), optional :: code

      if (present(code)) call c_exit(int(code, c_int))
      call c_exit(1_c_int)
   end subroutine quit

end module furiko_cli_terminal
