! SPDX-License-Identifier: MIT

!> What the operating system does for a file, by furiko_ensemble_posix.c
module furiko_ensemble_system
   use, intrinsic :: iso_c_binding, only : c_char, c_int, c_long_long, c_null_char
   use, intrinsic :: iso_fortran_env, only : error_unit, int64, output_unit, wp => real64
   implicit none
   private
   public :: begin_system, end_system, exists, file_lock, file_open, file_remove, file_rename, file_reserve, &
      file_sync, is_locked, is_terminal, output_write, reason, seconds, to_read, to_write, to_make


   !> What a file is opened for
   integer, parameter :: to_read = 0, to_write = 1, to_make = 2


   interface
      subroutine begin_system() bind(c, name='ensemble_begin')
         implicit none
      end subroutine begin_system

      function c_open(path, writing, descriptor) result(failed) bind(c, name='ensemble_open')
         import :: c_char, c_int
         implicit none
         character(kind=c_char), intent(in) :: path(*)
         integer(c_int), value :: writing
         integer(c_int), intent(out) :: descriptor
         integer(c_int) :: failed
      end function c_open

      function file_lock(descriptor) result(failed) bind(c, name='ensemble_lock')
         import :: c_int
         implicit none
         integer(c_int), value :: descriptor
         integer(c_int) :: failed
      end function file_lock

      function c_is_locked(descriptor) result(locked) bind(c, name='ensemble_is_locked')
         import :: c_int
         implicit none
         integer(c_int), value :: descriptor
         integer(c_int) :: locked
      end function c_is_locked

      function c_is_terminal(descriptor) result(terminal) bind(c, name='ensemble_is_terminal')
         import :: c_int
         implicit none
         integer(c_int), value :: descriptor
         integer(c_int) :: terminal
      end function c_is_terminal

      function c_reserve(descriptor, offset, bytes) result(failed) bind(c, name='ensemble_reserve')
         import :: c_int, c_long_long
         implicit none
         integer(c_int), value :: descriptor
         integer(c_long_long), value :: offset
         integer(c_long_long), value :: bytes
         integer(c_int) :: failed
      end function c_reserve

      function file_sync(descriptor) result(failed) bind(c, name='ensemble_sync')
         import :: c_int
         implicit none
         integer(c_int), value :: descriptor
         integer(c_int) :: failed
      end function file_sync

      function c_rename(from, to) result(failed) bind(c, name='ensemble_rename')
         import :: c_char, c_int
         implicit none
         character(kind=c_char), intent(in) :: from(*)
         character(kind=c_char), intent(in) :: to(*)
         integer(c_int) :: failed
      end function c_rename

      function c_remove(path) result(failed) bind(c, name='ensemble_remove')
         import :: c_char, c_int
         implicit none
         character(kind=c_char), intent(in) :: path(*)
         integer(c_int) :: failed
      end function c_remove

      function c_exists(path) result(failed) bind(c, name='ensemble_exists')
         import :: c_char, c_int
         implicit none
         character(kind=c_char), intent(in) :: path(*)
         integer(c_int) :: failed
      end function c_exists

      function c_write(text, bytes) result(failed) bind(c, name='ensemble_write')
         import :: c_char, c_int, c_long_long
         implicit none
         character(kind=c_char), intent(in) :: text(*)
         integer(c_long_long), value :: bytes
         integer(c_int) :: failed
      end function c_write

      subroutine c_why(number, text, size) bind(c, name='ensemble_why')
         import :: c_char, c_int
         implicit none
         integer(c_int), value :: number
         character(kind=c_char), intent(out) :: text(*)
         integer(c_int), value :: size
      end subroutine c_why

      subroutine c_end(code) bind(c, name='ensemble_end')
         import :: c_int
         implicit none
         integer(c_int), value :: code
      end subroutine c_end
   end interface


contains


   function file_open(path, writing, descriptor) result(failed)
      character(len=*), intent(in) :: path
      !> to_read, to_write or to_make
      integer, intent(in) :: writing
      integer(c_int), intent(out) :: descriptor
      integer(c_int) :: failed

      failed = c_open(path // c_null_char, int(writing, c_int), descriptor)
   end function file_open


   function is_locked(descriptor) result(locked)
      integer(c_int), intent(in) :: descriptor
      logical :: locked

      locked = c_is_locked(descriptor) /= 0
   end function is_locked


   !> Whether messages go to a terminal
   function is_terminal() result(terminal)
      logical :: terminal

      terminal = c_is_terminal(2_c_int) /= 0
   end function is_terminal


   !> Room on the disk for bytes of a file, so that writing them later cannot fail for lack of it
   function file_reserve(descriptor, offset, bytes) result(failed)
      integer(c_int), intent(in) :: descriptor
      integer(int64), intent(in) :: offset
      integer(int64), intent(in) :: bytes
      integer(c_int) :: failed

      failed = c_reserve(descriptor, int(offset, c_long_long), int(bytes, c_long_long))
   end function file_reserve


   function file_rename(from, to) result(failed)
      character(len=*), intent(in) :: from
      character(len=*), intent(in) :: to
      integer(c_int) :: failed

      failed = c_rename(from // c_null_char, to // c_null_char)
   end function file_rename


   subroutine file_remove(path)
      character(len=*), intent(in) :: path
      integer(c_int) :: ignored

      ignored = c_remove(path // c_null_char)
   end subroutine file_remove


   function exists(path) result(there)
      character(len=*), intent(in) :: path
      logical :: there

      there = c_exists(path // c_null_char) == 0
   end function exists


   !> Text to standard output, all of it
   function output_write(text) result(failed)
      character(len=*), intent(in) :: text
      integer(c_int) :: failed

      failed = c_write(text, len(text, c_long_long))
   end function output_write


   !> What an errno means
   function reason(number) result(text)
      integer(c_int), intent(in) :: number
      character(len=:), allocatable :: text
      character(kind=c_char) :: buffer(200)
      integer :: i

      call c_why(number, buffer, size(buffer, kind=c_int))
      text = ''
      do i = 1, size(buffer)
         if (buffer(i) == c_null_char) exit
         text = text // buffer(i)
      end do
   end function reason


   !> Ends the process at once, without a further word
   subroutine end_system(code)
      integer, intent(in) :: code

      flush(error_unit)
      flush(output_unit)
      call c_end(int(code, c_int))
   end subroutine end_system


   !> By a clock that runs on
   function seconds() result(now)
      real(wp) :: now
      integer(int64) :: rate, ticks

      call system_clock(ticks, rate)
      now = real(ticks, wp)/real(rate, wp)
   end function seconds
end module furiko_ensemble_system
