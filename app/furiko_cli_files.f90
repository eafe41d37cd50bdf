! SPDX-License-Identifier: MIT

!> Files and folders through C's library: Fortran has no folders, and gfortran's units say nothing
!> where a disk is full.
module furiko_cli_files
   use, intrinsic :: iso_c_binding, only : c_associated, c_char, c_int, c_null_char, c_ptr, c_size_t
   implicit none
   private
   public :: write_file, tail_of, move_file, remove_file, make_folder, enter_folder, can_replace, &
      is_there, process_id, folder_of, name_of


   !> What POSIX calls W_OK and F_OK
   integer(c_int), parameter :: writable = 2
   integer(c_int), parameter :: present = 0


   interface
      function c_mkdir(path, mode) result(stat) bind(c, name='mkdir')
         import :: c_char, c_int
         implicit none
         character(kind=c_char), intent(in) :: path(*)
         integer(c_int), value :: mode
         integer(c_int) :: stat
      end function c_mkdir

      function c_chdir(path) result(stat) bind(c, name='chdir')
         import :: c_char, c_int
         implicit none
         character(kind=c_char), intent(in) :: path(*)
         integer(c_int) :: stat
      end function c_chdir

      function c_access(path, mode) result(stat) bind(c, name='access')
         import :: c_char, c_int
         implicit none
         character(kind=c_char), intent(in) :: path(*)
         integer(c_int), value :: mode
         integer(c_int) :: stat
      end function c_access

      function c_rename(from, to) result(stat) bind(c, name='rename')
         import :: c_char, c_int
         implicit none
         character(kind=c_char), intent(in) :: from(*)
         character(kind=c_char), intent(in) :: to(*)
         integer(c_int) :: stat
      end function c_rename

      function c_remove(path) result(stat) bind(c, name='remove')
         import :: c_char, c_int
         implicit none
         character(kind=c_char), intent(in) :: path(*)
         integer(c_int) :: stat
      end function c_remove

      function c_getpid() result(id) bind(c, name='getpid')
         import :: c_int
         implicit none
         integer(c_int) :: id
      end function c_getpid

      function c_fopen(path, mode) result(stream) bind(c, name='fopen')
         import :: c_char, c_ptr
         implicit none
         character(kind=c_char), intent(in) :: path(*)
         character(kind=c_char), intent(in) :: mode(*)
         type(c_ptr) :: stream
      end function c_fopen

      function c_fwrite(text, width, count, stream) result(written) bind(c, name='fwrite')
         import :: c_char, c_ptr, c_size_t
         implicit none
         character(kind=c_char), intent(in) :: text(*)
         integer(c_size_t), value :: width
         integer(c_size_t), value :: count
         type(c_ptr), value :: stream
         integer(c_size_t) :: written
      end function c_fwrite

      function c_fclose(stream) result(stat) bind(c, name='fclose')
         import :: c_int, c_ptr
         implicit none
         type(c_ptr), value :: stream
         integer(c_int) :: stat
      end function c_fclose
   end interface


contains


   !> Write text to a file; `done` says whether all of it got there.
   subroutine write_file(path, text, done)
      character(len=*), intent(in) :: path
      character(len=*), intent(in) :: text
      logical, intent(out) :: done
      type(c_ptr) :: stream
      integer(c_size_t) :: length

      done = .false.
      stream = c_fopen(path // c_null_char, 'wb' // c_null_char)
      if (.not. c_associated(stream)) return
      length = len(text, c_size_t)
      done = c_fwrite(text, 1_c_size_t, length, stream) == length
      ! Closed in any case, and what a full disk refuses may show only now
      if (c_fclose(stream) /= 0) done = .false.
   end subroutine write_file


   !> The last bytes of a file, at most `length`; none where it cannot be read.
   function tail_of(path, length) result(tail)
      character(len=*), intent(in) :: path
      integer, intent(in) :: length
      character(len=:), allocatable :: tail
      integer :: bytes, stat, unit

      tail = ''
      open(newunit=unit, file=path, access='stream', form='unformatted', status='old', &
         action='read', iostat=stat)
      if (stat /= 0) return
      inquire(unit, size=bytes)
      tail = repeat(' ', max(0, min(bytes, length)))
      read(unit, pos=bytes - len(tail) + 1, iostat=stat) tail
      close(unit)
      if (stat /= 0) tail = ''
   end function tail_of


   subroutine move_file(from, to, done)
      character(len=*), intent(in) :: from
      character(len=*), intent(in) :: to
      logical, intent(out) :: done

      done = c_rename(from // c_null_char, to // c_null_char) == 0
   end subroutine move_file


   !> Remove a file, or an empty folder, where there is one.
   subroutine remove_file(path)
      character(len=*), intent(in) :: path
      integer(c_int) :: ignored

      ignored = c_remove(path // c_null_char)
   end subroutine remove_file


   subroutine make_folder(path, done)
      character(len=*), intent(in) :: path
      logical, intent(out) :: done

      done = c_mkdir(path // c_null_char, int(o'777', c_int)) == 0
   end subroutine make_folder


   subroutine enter_folder(path, done)
      character(len=*), intent(in) :: path
      logical, intent(out) :: done

      done = c_chdir(path // c_null_char) == 0
   end subroutine enter_folder


   !> Whether there is nothing at a path, or a file that may be written.
   function can_replace(path)
      character(len=*), intent(in) :: path
      logical :: can_replace

      can_replace = .not. is_there(path)
      if (can_replace) return
      can_replace = c_access(path // '/.' // c_null_char, present) /= 0
      if (can_replace) can_replace = c_access(path // c_null_char, writable) == 0
   end function can_replace


   function is_there(path)
      character(len=*), intent(in) :: path
      logical :: is_there

      is_there = c_access(path // c_null_char, present) == 0
   end function is_there


   function process_id()
      integer :: process_id

      process_id = int(c_getpid())
   end function process_id


   !> The folder of a path with its slash: 'a/b.svg' lies in 'a/', 'b.svg' in './'.
   pure function folder_of(path) result(folder)
      character(len=*), intent(in) :: path
      character(len=:), allocatable :: folder

      folder = path(:index(path, '/', back=.true.))
      if (folder == '') folder = './'
   end function folder_of


   !> A path without its folder.
   pure function name_of(path) result(name)
      character(len=*), intent(in) :: path
      character(len=:), allocatable :: name

      name = path(index(path, '/', back=.true.) + 1:)
   end function name_of

end module furiko_cli_files
