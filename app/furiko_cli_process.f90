! SPDX-License-Identifier: MIT

!> Signals, and another program that ends with this one.
module furiko_cli_process
   use, intrinsic :: iso_c_binding, only : c_char, c_funptr, c_int, c_intptr_t, c_loc, c_null_char, &
      c_null_funptr, c_null_ptr, c_ptr, c_size_t
   implicit none
   private
   public :: defer_signals, deliver_signals, settle_signals, run_filter


   !> What ends a program politely: SIGHUP, SIGINT, SIGQUIT, SIGTERM
   integer(c_int), parameter :: polite(*) = [1_c_int, 2_c_int, 3_c_int, 15_c_int]
   integer(c_int), parameter :: kill_signal = 9
   !> SIGXFSZ
   integer(c_int), parameter :: file_limit = 25
   !> SIGQUIT, SIGXCPU
   integer(c_int), parameter :: traced(*) = [3_c_int, 24_c_int]


   interface
      function c_sighold(number) result(stat) bind(c, name='sighold')
         import :: c_int
         implicit none
         integer(c_int), value :: number
         integer(c_int) :: stat
      end function c_sighold

      function c_sigrelse(number) result(stat) bind(c, name='sigrelse')
         import :: c_int
         implicit none
         integer(c_int), value :: number
         integer(c_int) :: stat
      end function c_sigrelse

      function c_signal(number, handler) result(old) bind(c, name='signal')
         import :: c_funptr, c_int
         implicit none
         integer(c_int), value :: number
         type(c_funptr), value :: handler
         type(c_funptr) :: old
      end function c_signal

      function c_fork() result(id) bind(c, name='fork')
         import :: c_int
         implicit none
         integer(c_int) :: id
      end function c_fork

      function c_setpgid(id, group) result(stat) bind(c, name='setpgid')
         import :: c_int
         implicit none
         integer(c_int), value :: id
         integer(c_int), value :: group
         integer(c_int) :: stat
      end function c_setpgid

      function c_kill(id, number) result(stat) bind(c, name='kill')
         import :: c_int
         implicit none
         integer(c_int), value :: id
         integer(c_int), value :: number
         integer(c_int) :: stat
      end function c_kill

      function c_waitpid(id, status, options) result(ended) bind(c, name='waitpid')
         import :: c_int
         implicit none
         integer(c_int), value :: id
         integer(c_int), intent(inout) :: status
         integer(c_int), value :: options
         integer(c_int) :: ended
      end function c_waitpid

      function c_execvp(file, words) result(stat) bind(c, name='execvp')
         import :: c_char, c_int, c_ptr
         implicit none
         character(kind=c_char), intent(in) :: file(*)
         type(c_ptr), intent(in) :: words(*)
         integer(c_int) :: stat
      end function c_execvp

      subroutine c_exit_at_once(code) bind(c, name='_exit')
         import :: c_int
         implicit none
         integer(c_int), value :: code
      end subroutine c_exit_at_once

      function c_pipe(ends) result(stat) bind(c, name='pipe')
         import :: c_int
         implicit none
         integer(c_int), intent(out) :: ends(2)
         integer(c_int) :: stat
      end function c_pipe

      function c_dup2(old, new) result(stat) bind(c, name='dup2')
         import :: c_int
         implicit none
         integer(c_int), value :: old
         integer(c_int), value :: new
         integer(c_int) :: stat
      end function c_dup2

      function c_close(descriptor) result(stat) bind(c, name='close')
         import :: c_int
         implicit none
         integer(c_int), value :: descriptor
         integer(c_int) :: stat
      end function c_close

      function c_read(descriptor, bytes, count) result(read) bind(c, name='read')
         import :: c_char, c_int, c_size_t
         implicit none
         integer(c_int), value :: descriptor
         character(kind=c_char), intent(inout) :: bytes(*)
         integer(c_size_t), value :: count
         integer(c_size_t) :: read
      end function c_read
   end interface


contains


   !> Have the signals that end a program wait until [[deliver_signals]].
   subroutine defer_signals()
      integer(c_int) :: i, ignored

      do i = 1, size(polite)
         ignored = c_sighold(polite(i))
      end do
   end subroutine defer_signals


   subroutine deliver_signals()
      integer(c_int) :: i, ignored

      do i = 1, size(polite)
         ignored = c_sigrelse(polite(i))
      end do
   end subroutine deliver_signals


   !> Have the limit of `ulimit -f` told as an error of writing, and let what ends the program do so
   !> without the backtrace of gfortran's.
   subroutine settle_signals()
      type(c_funptr) :: default, ignore, ignored
      integer :: i

      ! C's SIG_DFL and SIG_IGN
      default = transfer(0_c_intptr_t, c_null_funptr)
      ignore = transfer(1_c_intptr_t, c_null_funptr)
      do i = 1, size(traced)
         ignored = c_signal(traced(i), default)
      end do
      ignored = c_signal(file_limit, ignore)
   end subroutine settle_signals


   !> Run a program with arguments and with files for its input, output and errors, and wait for it.
   !> If this program is ended, by whatever signal, so is that one, with all that it has started: it is
   !> in a process group apart, with a process of ours that watches.
   subroutine run_filter(program, arguments, files, code)
      character(len=*), intent(in) :: program
      !> With a blank between
      character(len=*), intent(in) :: arguments
      !> Descriptors, each greater than the one before
      integer(c_int), intent(in) :: files(3)
      !> Its exit code; 127 where there is no such program, -1 where none can be started
      integer, intent(out) :: code
      integer(c_int) :: child, ends(2), guard, ignored, status

      code = -1
      if (c_pipe(ends) /= 0) return
      call defer_signals()
      guard = c_fork()
      if (guard == 0) call watch(ends)
      child = -1
      if (guard > 0) then
         ignored = c_setpgid(guard, guard)
         child = c_fork()
      end if
      if (child == 0) call become(program, arguments, files, guard, ends)
      call deliver_signals()

      ignored = c_close(ends(1))
      status = 0
      if (child > 0) ignored = c_waitpid(child, status, 0_c_int)
      ignored = c_close(ends(2))
      if (guard > 0) ignored = c_waitpid(guard, ignored, 0_c_int)
      if (child <= 0) return
      ! The signal that ended it, or its own code
      code = int(iand(status, 127_c_int))
      if (code == 0) code = int(iand(ishft(status, -8), 255_c_int))
   end subroutine run_filter


   !> In the second child: be the other program, in the first one's group; does not return.
   subroutine become(program, arguments, files, group, ends)
      character(len=*), intent(in) :: program
      character(len=*), intent(in) :: arguments
      integer(c_int), intent(in) :: files(3)
      integer(c_int), intent(in) :: group
      integer(c_int), intent(in) :: ends(2)
      character(kind=c_char), target :: first(len(program) + 1), rest(len(arguments) + 1)
      type(c_ptr) :: starts(len(arguments) + 2)
      integer(c_int) :: i, ignored
      integer :: count

      ignored = c_setpgid(0_c_int, group)
      ! Only now may the first child find the pipe closed.
      do i = 1, 2
         ignored = c_close(ends(i))
      end do
      do i = 1, 3
         ignored = c_dup2(files(i), i - 1)
      end do
      call deliver_signals()
      first = transfer(program // c_null_char, first)
      rest = transfer(arguments // c_null_char, rest)
      starts(1) = c_loc(first)
      count = 1
      do i = 1, len(arguments)
         if (arguments(i:i) == ' ') rest(i) = c_null_char
         if (index(' ' // arguments(:i - 1), ' ', back=.true.) < i) cycle
         count = count + 1
         starts(count) = c_loc(rest(i))
      end do
      starts(count + 1) = c_null_ptr
      ignored = c_execvp(first, starts)
      call c_exit_at_once(127_c_int)
   end subroutine become


   !> In the first child, for which the signals never come: wait until nobody can write to the pipe any
   !> more, as this program has ended or waits no longer; then end the group. Does not return.
   subroutine watch(ends)
      integer(c_int), intent(in) :: ends(2)
      integer(c_int), parameter :: own_group = 0
      character(kind=c_char) :: nothing(1)
      integer(c_size_t) :: at_end
      integer(c_int) :: ignored, stat

      stat = c_setpgid(0_c_int, 0_c_int)
      ignored = c_close(ends(2))
      at_end = c_read(ends(1), nothing, 1_c_size_t)
      if (stat == 0) ignored = c_kill(own_group, kill_signal)
      call c_exit_at_once(0_c_int)
   end subroutine watch

end module furiko_cli_process
