! SPDX-License-Identifier: MIT

!> A table with named columns, row by row: a CSV file, standard input, or a sweep's HDF5 file, which the
!> program `ensemble` writes as CSV into a pipe.
module furiko_cli_source
   use, intrinsic :: iso_c_binding, only : c_associated, c_char, c_int, c_null_char, c_null_ptr, c_ptr
   use, intrinsic :: iso_fortran_env, only : wp => real64
   use furiko_cli_fields, only : field, is_skipped, split
   use furiko_cli_files, only : c_fclose, c_fopen, descriptor_of
   use furiko_cli_input, only : line_input, longest_line
   use furiko_cli_io, only : cannot, quit, refuse
   use furiko_cli_number, only : is_right, read_number
   use furiko_cli_text, only : replaced, whole_text
   implicit none
   private
   public :: source, open_source, longest_name


   !> What an HDF5 file begins with
   character(len=*), parameter :: signature = char(137) // 'HDF' // achar(13) // achar(10) // achar(26) // &
      achar(10)
   integer, parameter :: most_columns = 64
   !> Letters of the first column's name
   integer, parameter :: longest_name = 24
   character(len=*), parameter :: letters = 'abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_'


   type :: source
      private
      !> As messages call it, and as the user typed it
      character(len=:), allocatable, public :: name
      character(len=:), allocatable :: file
      type(line_input) :: input
      type(c_ptr) :: stream = c_null_ptr
      !> Whether another program writes it
      logical :: piped = .false.
      !> The columns that are wanted; 0 for one that is not there
      integer, allocatable :: columns(:)
      integer :: width = 0
      !> The name of the first column
      character(len=:), allocatable, public :: first_name
   contains
      procedure :: next_row
      procedure, private :: next_line
      procedure, private :: read_header
      procedure, private :: complain_of
   end type source


   interface
      function c_popen(command, mode) result(stream) bind(c, name='popen')
         import :: c_char, c_ptr
         implicit none
         character(kind=c_char), intent(in) :: command(*)
         character(kind=c_char), intent(in) :: mode(*)
         type(c_ptr) :: stream
      end function c_popen

      function c_pclose(stream) result(stat) bind(c, name='pclose')
         import :: c_int, c_ptr
         implicit none
         type(c_ptr), value :: stream
         integer(c_int) :: stat
      end function c_pclose
   end interface


contains


   !> Open a table and read its header. The columns `wanted` are found by name, wherever they stand; a blank
   !> name is the first column, whatever it is called. Of these the first `needed` must be there. Does not
   !> return if something is amiss.
   subroutine open_source(file, wanted, needed, self)
      !> - is standard input
      character(len=*), intent(in) :: file
      character(len=*), intent(in) :: wanted(:)
      integer, intent(in) :: needed
      type(source), intent(out) :: self

      self%file = file
      self%name = '--from ' // file
      if (file == '-') self%name = 'standard input'
      if (file /= '-') then
         self%input%name = file
         self%stream = c_fopen(file // c_null_char, 'r' // c_null_char)
         if (.not. c_associated(self%stream)) then
            call cannot('read ' // file)
            call quit(2)
         end if
         self%input%file = descriptor_of(self%stream)
      end if
      call self%input%refill()
      if (self%input%begins_with(signature)) call read_through_ensemble(self)
      call self%read_header(wanted, needed)
   end subroutine open_source


   !> The next row's wanted columns, 0 for one that is not there. `found` is false behind the last row.
   subroutine next_row(self, x, found)
      class(source), intent(inout) :: self
      real(wp), intent(out) :: x(:)
      logical, intent(out) :: found
      type(field) :: fields(most_columns)
      integer :: count, i, verdict

      call self%next_line(found)
      if (.not. found) return
      x = 0.0_wp
      associate (line => self%input%text(self%input%first:self%input%last))
         call split(line, fields(:self%width), count)
         if (count /= self%width) call self%complain_of('has ' // whole_text(count) // &
            ' fields, the header ' // whole_text(self%width))
         do i = 1, size(x)
            if (self%columns(i) == 0) cycle
            associate (place => fields(self%columns(i)))
               call read_number(line(place%first:place%last), x(i), verdict)
               if (verdict /= is_right) call self%complain_of("'" // line(place%first:min(place%last, &
                  place%first + 39)) // "' is not a number")
            end associate
         end do
      end associate
   end subroutine next_row


   !> Go to the next line that is not blank and no comment. Behind the last one all is closed.
   subroutine next_line(self, found)
      class(source), intent(inout) :: self
      logical, intent(out) :: found

      do
         call self%input%next_line(found)
         if (found) then
            associate (line => self%input%text(self%input%first:self%input%last))
               if (len(line) > longest_line) call self%complain_of('is longer than ' // &
                  whole_text(longest_line) // ' characters')
               if (.not. is_skipped(line)) return
            end associate
         else if (self%input%at_end) then
            call close_stream(self)
            return
         else
            call self%input%refill()
         end if
      end do
   end subroutine next_line


   subroutine read_header(self, wanted, needed)
      class(source), intent(inout) :: self
      character(len=*), intent(in) :: wanted(:)
      integer, intent(in) :: needed
      type(field) :: fields(most_columns)
      integer :: i, j
      logical :: found

      call self%next_line(found)
      if (.not. found) call refuse('furiko plot: ' // self%name // ' is empty')
      allocate(self%columns(size(wanted)), source=0)
      associate (line => self%input%text(self%input%first:self%input%last))
         call split(line, fields, self%width)
         if (self%width > most_columns) call self%complain_of('has more than ' // &
            whole_text(most_columns) // ' columns')
         self%first_name = line(fields(1)%first:fields(1)%last)
         do i = 1, size(wanted)
            if (wanted(i) == '') self%columns(i) = 1
            do j = 1, self%width
               if (line(fields(j)%first:fields(j)%last) == wanted(i)) self%columns(i) = j
            end do
            if (self%columns(i) == 0 .and. i <= needed) call self%complain_of('names no column ' // &
               trim(wanted(i)) // ', which this figure is drawn from')
         end do
      end associate
      ! The name becomes an axis's label
      if (.not. is_name(self%first_name)) call self%complain_of('does not begin with the name of a column')
      if (any(wanted == '') .and. any(wanted == self%first_name)) call self%complain_of( &
         'has no first column of what was varied')
   end subroutine read_header


   !> A letter, then letters, figures and _
   pure function is_name(text)
      character(len=*), intent(in) :: text
      logical :: is_name

      is_name = len(text) > 0 .and. len(text) <= longest_name .and. verify(text, letters) == 0
      if (is_name) is_name = verify(text(1:1), letters(:52)) == 0
   end function is_name


   subroutine complain_of(self, what)
      class(source), intent(in) :: self
      character(len=*), intent(in) :: what

      call refuse('furiko plot: ' // self%name // ': line ' // whole_text(self%input%number) // ' ' // what)
   end subroutine complain_of


   !> In place of an HDF5 file, what `ensemble table` writes of it. The program is looked for in the PATH,
   !> then where its Makefile builds it in a checkout.
   subroutine read_through_ensemble(self)
      type(source), intent(inout) :: self
      character(len=*), parameter :: start = 'p=$(command -v ensemble) || ' // &
         'p=build/ensemble/serial/ensemble; [ -x "$p" ] || exit 127; exec "$p" table '
      character(len=:), allocatable :: path
      integer(c_int) :: ignored

      if (self%file == '-') call refuse('furiko plot: standard input is an HDF5 file; name it: --from FILE')
      ignored = c_fclose(self%stream)
      path = self%file
      if (path(1:1) == '-') path = './' // path
      self%input = line_input()
      self%input%name = self%file
      self%stream = c_popen(start // "'" // replaced(path, "'", "'\''") // "'" // c_null_char, &
         'r' // c_null_char)
      if (.not. c_associated(self%stream)) then
         call cannot('start ensemble')
         call quit(2)
      end if
      self%piped = .true.
      self%input%file = descriptor_of(self%stream)
   end subroutine read_through_ensemble


   !> Behind the last row. What `ensemble` could not do it has said.
   subroutine close_stream(self)
      type(source), intent(inout) :: self
      integer(c_int), parameter :: not_found = 127*256
      integer(c_int) :: stat

      if (.not. c_associated(self%stream)) return
      if (self%piped) then
         stat = c_pclose(self%stream)
         if (stat == not_found) call refuse('furiko plot: ' // self%name // ' is an HDF5 file, and ' // &
            'there is no ensemble here to read it; make -C ensemble builds it (doc/ensemble.md)')
         if (stat /= 0) call quit(2)
      else
         stat = c_fclose(self%stream)
      end if
      self%stream = c_null_ptr
   end subroutine close_stream

end module furiko_cli_source
