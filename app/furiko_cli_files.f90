! SPDX-License-Identifier: MIT

!> Files that are written whole or not at all, and files without a name for what passes by.
!>
!> What a file shall hold is gathered in memory and put where it goes in one go, in place: so links,
!> hard links, owner, mode and whatever else the user has given a file stay, and nothing lies about
!> if the program is ended at work.
module furiko_cli_files
   use, intrinsic :: iso_c_binding, only : c_associated, c_char, c_int, c_long, c_null_char, c_null_ptr, &
      c_ptr, c_size_t
   use furiko_cli_io, only : c_fflush, fail, finish, put, quit, say_why
   use furiko_cli_process, only : defer_signals, deliver_signals
   use furiko_cli_text, only : append_to
   implicit none
   private
   public :: output, open_output, is_taken, folder_of, name_of
   public :: nameless_file, append_text, text_of, to_start, descriptor_of
   public :: c_fclose, c_fopen


   character(len=*), parameter :: nul = c_null_char
   !> What POSIX calls F_OK, W_OK, W_OK with X_OK (a folder open to new files), R_OK
   integer(c_int), parameter :: existing = 0
   integer(c_int), parameter :: writable = 2
   integer(c_int), parameter :: open_to_new = 3
   integer(c_int), parameter :: readable = 4
   !> SEEK_SET, SEEK_END
   integer(c_int), parameter :: at_start = 0
   integer(c_int), parameter :: at_end = 2
   !> LOCK_EX with LOCK_NB: do not wait
   integer(c_int), parameter :: for_us_alone = 6


   type :: output
      private
      !> As the user has named it
      character(len=:), allocatable :: file
      !> Where that leads
      character(len=:), allocatable :: place
      !> Whether it is standard output
      logical :: standard = .false.
      !> Whether there must be no file yet
      logical :: fresh = .false.
      character(len=:), allocatable :: text
      integer :: length = 0
   contains
      procedure :: put => put_line
      procedure :: add
      procedure :: close => close_output
   end type output


   interface
      function c_fopen(file, mode) result(stream) bind(c, name='fopen')
         import :: c_char, c_ptr
         implicit none
         character(kind=c_char), intent(in) :: file(*)
         character(kind=c_char), intent(in) :: mode(*)
         type(c_ptr) :: stream
      end function c_fopen

      function c_fdopen(descriptor, mode) result(stream) bind(c, name='fdopen')
         import :: c_char, c_int, c_ptr
         implicit none
         integer(c_int), value :: descriptor
         character(kind=c_char), intent(in) :: mode(*)
         type(c_ptr) :: stream
      end function c_fdopen

      function c_fileno(stream) result(descriptor) bind(c, name='fileno')
         import :: c_int, c_ptr
         implicit none
         type(c_ptr), value :: stream
         integer(c_int) :: descriptor
      end function c_fileno

      function c_fwrite(text, width, count, stream) result(written) bind(c, name='fwrite')
         import :: c_char, c_ptr, c_size_t
         implicit none
         character(kind=c_char), intent(in) :: text(*)
         integer(c_size_t), value :: width
         integer(c_size_t), value :: count
         type(c_ptr), value :: stream
         integer(c_size_t) :: written
      end function c_fwrite

      function c_fread(text, width, count, stream) result(read) bind(c, name='fread')
         import :: c_char, c_ptr, c_size_t
         implicit none
         character(kind=c_char), intent(inout) :: text(*)
         integer(c_size_t), value :: width
         integer(c_size_t), value :: count
         type(c_ptr), value :: stream
         integer(c_size_t) :: read
      end function c_fread

      function c_fseek(stream, offset, whence) result(stat) bind(c, name='fseek')
         import :: c_int, c_long, c_ptr
         implicit none
         type(c_ptr), value :: stream
         integer(c_long), value :: offset
         integer(c_int), value :: whence
         integer(c_int) :: stat
      end function c_fseek

      function c_ftell(stream) result(offset) bind(c, name='ftell')
         import :: c_long, c_ptr
         implicit none
         type(c_ptr), value :: stream
         integer(c_long) :: offset
      end function c_ftell

      function c_fclose(stream) result(stat) bind(c, name='fclose')
         import :: c_int, c_ptr
         implicit none
         type(c_ptr), value :: stream
         integer(c_int) :: stat
      end function c_fclose

      function c_flock(descriptor, operation) result(stat) bind(c, name='flock')
         import :: c_int
         implicit none
         integer(c_int), value :: descriptor
         integer(c_int), value :: operation
         integer(c_int) :: stat
      end function c_flock

      function c_usleep(microseconds) result(stat) bind(c, name='usleep')
         import :: c_int
         implicit none
         integer(c_int), value :: microseconds
         integer(c_int) :: stat
      end function c_usleep

      function c_truncate(path, length) result(stat) bind(c, name='truncate')
         import :: c_char, c_int, c_long
         implicit none
         character(kind=c_char), intent(in) :: path(*)
         integer(c_long), value :: length
         integer(c_int) :: stat
      end function c_truncate

      function c_remove(file) result(stat) bind(c, name='remove')
         import :: c_char, c_int
         implicit none
         character(kind=c_char), intent(in) :: file(*)
         integer(c_int) :: stat
      end function c_remove

      function c_mkstemp(name) result(descriptor) bind(c, name='mkstemp')
         import :: c_char, c_int
         implicit none
         character(kind=c_char), intent(inout) :: name(*)
         integer(c_int) :: descriptor
      end function c_mkstemp

      function c_access(path, mode) result(stat) bind(c, name='access')
         import :: c_char, c_int
         implicit none
         character(kind=c_char), intent(in) :: path(*)
         integer(c_int), value :: mode
         integer(c_int) :: stat
      end function c_access

      function c_readlink(path, text, size) result(length) bind(c, name='readlink')
         import :: c_char, c_size_t
         implicit none
         character(kind=c_char), intent(in) :: path(*)
         character(kind=c_char), intent(inout) :: text(*)
         integer(c_size_t), value :: size
         integer(c_size_t) :: length
      end function c_readlink
   end interface


contains


   !> Make sure that a file can be written, before any work is done for it; does not return if not.
   function open_output(file, fresh) result(self)
      !> - is standard output
      character(len=*), intent(in) :: file
      !> A file that the user did not name: none that is there is replaced (.false.)
      logical, intent(in), optional :: fresh
      type(output) :: self
      type(c_ptr) :: refused
      integer(c_int) :: stat

      self%file = file
      self%place = file
      self%text = ''
      if (present(fresh)) self%fresh = fresh
      ! Opened by name it would be written over from its start, under what else goes there.
      self%standard = any(file == [character(len=11) :: '-', '/dev/stdout', '/dev/fd/1']) .and. &
         len_trim(file) == len(file)
      if (self%standard) return
      if (is_there(file)) then
         stat = c_access(file // nul, writable)
         if (stat == 0) then
            ! A folder: that it cannot be opened gives the reason.
            if (is_there(file // '/.')) stat = -1
            if (stat /= 0) refused = c_fopen(file // nul, 'r+' // nul)
         end if
      else
         self%place = target_of(file)
         stat = c_access(folder_of(self%place) // nul, open_to_new)
      end if
      if (stat /= 0) call fail(file)
   end function open_output


   !> Add a line.
   subroutine put_line(self, line)
      class(output), intent(inout) :: self
      character(len=*), intent(in) :: line

      if (self%standard) then
         call put(line)
      else
         call self%add(line // new_line('a'))
      end if
   end subroutine put_line


   !> Add text, bytes of any kind, to what will be a file.
   subroutine add(self, text)
      class(output), intent(inout) :: self
      character(len=*), intent(in) :: text

      call append_to(self%text, self%length, text)
   end subroutine add


   !> Put all in its place, or leave that as it was and end the program. Signals wait so long, but not
   !> while a pipe has no reader.
   subroutine close_output(self)
      class(output), intent(in) :: self
      type(c_ptr) :: stream
      integer(c_long) :: length
      integer(c_int) :: ignored
      logical :: done, new

      if (self%standard) then
         call finish()
         return
      end if
      new = .not. is_there(self%place)
      stream = c_fopen(self%place // nul, trim(merge('wx', 'a ', self%fresh)) // nul)
      if (.not. c_associated(stream)) call fail(self%file)
      call wait_for_turn(stream)
      length = length_of(stream)
      new = new .and. length <= 0
      if (length >= 0) call defer_signals()
      call write_over(self, stream, length, done)
      if (c_fclose(stream) /= 0) done = .false.
      if (.not. done) then
         call say_why(self%file)
         if (new) ignored = c_remove(self%place // nul)
         if (.not. new) ignored = c_truncate(self%place // nul, length)
         call quit()
      end if
      call deliver_signals()
   end subroutine close_output


   !> Two at once on one file: one after the other. Each needs milliseconds; who keeps a file locked for a
   !> second is not one of us.
   subroutine wait_for_turn(stream)
      type(c_ptr), intent(in) :: stream
      integer(c_int) :: i, ignored

      do i = 1, 100
         if (c_flock(c_fileno(stream), for_us_alone) == 0) return
         ignored = c_usleep(10000_c_int)
      end do
   end subroutine wait_for_turn


   !> Write over what a file holds: first what makes it longer, for which the disk may have no room,
   !> then the rest, which has its room.
   subroutine write_over(self, stream, length, done)
      type(output), intent(in) :: self
      !> The file, open to be appended to
      type(c_ptr), intent(in) :: stream
      !> Its length; negative if it has none
      integer(c_long), intent(in) :: length
      logical, intent(out) :: done
      type(c_ptr) :: start
      integer(c_long) :: shared

      shared = max(0_c_long, min(length, int(self%length, c_long)))
      ! A file that is open already, as /dev/fd/3, goes on where it ends.
      if (index(self%place, '/dev/') == 1) shared = 0
      if (shared > 0) then
         if (c_access(self%place // nul, readable) /= 0) then
            ! May not be opened to be written over
            done = c_truncate(self%place // nul, 0_c_long) == 0
            if (.not. done) return
            shared = 0
         end if
      end if
      done = append_text(stream, self%text(shared + 1:self%length))
      if (.not. done .or. shared == 0) return
      start = c_fopen(self%place // nul, 'r+' // nul)
      done = c_associated(start)
      if (done) done = append_text(start, self%text(:shared))
      if (done) done = c_fclose(start) == 0
      if (done .and. shared < length) done = c_truncate(self%place // nul, shared) == 0
   end subroutine write_over


   !> A file of its own for what passes by: it has lost its name, so it ends with the program, however
   !> that ends. It lies in $TMPDIR, in /tmp or in a folder given, the first that can be written; a null
   !> pointer where none can.
   function nameless_file(folder) result(stream)
      character(len=*), intent(in) :: folder
      type(c_ptr) :: stream
      character(len=:), allocatable :: chosen
      integer :: length

      call get_environment_variable('TMPDIR', length=length)
      allocate(character(len=length) :: chosen)
      call get_environment_variable('TMPDIR', chosen)
      stream = c_null_ptr
      if (length > 0) stream = nameless_in(chosen)
      if (.not. c_associated(stream)) stream = nameless_in('/tmp')
      if (.not. c_associated(stream)) stream = nameless_in(folder)
   end function nameless_file


   function nameless_in(folder) result(stream)
      character(len=*), intent(in) :: folder
      type(c_ptr) :: stream
      character(kind=c_char, len=:), allocatable :: name
      integer(c_int) :: descriptor, ignored

      stream = c_null_ptr
      name = folder // '/furiko-XXXXXX' // nul
      call defer_signals()
      descriptor = c_mkstemp(name)
      if (descriptor >= 0) ignored = c_remove(name)
      call deliver_signals()
      if (descriptor >= 0) stream = c_fdopen(descriptor, 'w+' // nul)
   end function nameless_in


   !> Write text where a file stands, all of it.
   function append_text(stream, text) result(done)
      type(c_ptr), intent(in) :: stream
      character(len=*), intent(in) :: text
      logical :: done

      done = c_fwrite(text, 1_c_size_t, len(text, c_size_t), stream) == len(text, c_size_t)
      if (done) done = c_fflush(stream) == 0
   end function append_text


   !> All that a nameless file holds, whoever has written it.
   function text_of(stream) result(text)
      type(c_ptr), intent(in) :: stream
      character(len=:), allocatable :: text
      integer(c_size_t) :: length

      length = max(0_c_long, length_of(stream))
      call to_start(stream)
      text = repeat(' ', length)
      length = c_fread(text, 1_c_size_t, length, stream)
      text = text(:length)
   end function text_of


   !> Where a file ends, and go there; negative for a pipe, which has no such place.
   function length_of(stream) result(length)
      type(c_ptr), intent(in) :: stream
      integer(c_long) :: length

      length = -1
      if (c_fseek(stream, 0_c_long, at_end) == 0) length = c_ftell(stream)
   end function length_of


   !> Have whoever reads a file next, another program too, begin at its start.
   subroutine to_start(stream)
      type(c_ptr), intent(in) :: stream
      integer(c_int) :: ignored

      ignored = c_fseek(stream, 0_c_long, at_start)
   end subroutine to_start


   function descriptor_of(stream)
      type(c_ptr), intent(in) :: stream
      integer(c_int) :: descriptor_of

      descriptor_of = c_fileno(stream)
   end function descriptor_of


   !> Whether a name is in use, be it by a link that leads nowhere.
   function is_taken(path)
      character(len=*), intent(in) :: path
      logical :: is_taken

      is_taken = is_there(path)
      if (.not. is_taken) is_taken = len(link_of(path)) > 0
   end function is_taken


   function is_there(path)
      character(len=*), intent(in) :: path
      logical :: is_there

      is_there = c_access(path // nul, existing) == 0
   end function is_there


   !> Where a link that leads to no file would have it: through links to links, from folder to folder.
   function target_of(path) result(place)
      character(len=*), intent(in) :: path
      character(len=:), allocatable :: place
      character(len=:), allocatable :: next
      integer :: i
      !> Linux takes as many for a circle
      integer, parameter :: most = 40

      place = path
      do i = 1, most
         next = link_of(place)
         if (len(next) == 0) return
         if (index(next, '/') /= 1) next = folder_of(place) // next
         place = next
      end do
   end function target_of


   !> What a link says; empty where there is no link.
   function link_of(path) result(text)
      character(len=*), intent(in) :: path
      character(len=:), allocatable :: text
      !> POSIX: PATH_MAX
      character(kind=c_char, len=4096) :: buffer

      text = buffer(:max(0_c_size_t, c_readlink(path // nul, buffer, len(buffer, c_size_t))))
   end function link_of


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
