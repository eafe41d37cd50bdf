! SPDX-License-Identifier: MIT

!> Figures drawn by gnuplot: the script, the call, and a picture that is there whole or not at all.
!>
!> gnuplot is told script and data as its input and answers with the picture: it sees no file of the
!> user's, and none lies about if anything is ended.
module furiko_gnuplot
   use, intrinsic :: iso_c_binding, only : c_associated, c_char, c_int, c_null_char, c_ptr
   use, intrinsic :: iso_fortran_env, only : wp => real64
   use furiko_cli_files, only : append_text, descriptor_of, folder_of, is_taken, name_of, nameless_file, &
      open_output, output, text_of, to_start
   use furiko_cli_io, only : complain, fail, quit
   use furiko_cli_process, only : run_filter
   use furiko_cli_text, only : replaced
   use furiko_figure, only : figure, fixed, to_text
   use furiko_marks, only : with_resolution, with_words
   implicit none
   private
   public :: picture, is_picture_name, begin_picture, draw


   character(len=*), parameter :: nl = new_line('a')
   character(len=*), parameter :: endings(*) = [character(len=4) :: '.svg', '.png', '.pdf']
   !> What stands within the last bytes of a whole picture of each kind
   character(len=*), parameter :: closings(*) = [character(len=6) :: '</svg>', 'IEND', '%%EOF']
   !> The code for a program that is not there
   integer, parameter :: not_found = 127
   !> As in CSS
   real(wp), parameter :: pixels_per_inch = 96.0_wp


   !> A picture to be made, and the data and the script that go beside it.
   type :: picture
      private
      character(len=:), allocatable :: path
      type(output) :: file
      type(output) :: data
      type(output) :: script
      !> Leave data and script
      logical :: keep = .false.
      integer :: form = 0
      !> Pixels, as many times as `scale` says
      integer :: width = 0
      integer :: height = 0
      real(wp) :: scale = 1.0_wp
      !> What the picture and its data say of themselves: a title, and the command line
      character(len=:), allocatable :: name
      character(len=:), allocatable :: command
   end type picture


   interface
      function c_setenv(name, value, replace) result(stat) bind(c, name='setenv')
         import :: c_char, c_int
         implicit none
         character(kind=c_char), intent(in) :: name(*)
         character(kind=c_char), intent(in) :: value(*)
         integer(c_int), value :: replace
         integer(c_int) :: stat
      end function c_setenv
   end interface


contains


   !> Whether a file's ending is that of a picture.
   pure function is_picture_name(path)
      character(len=*), intent(in) :: path
      logical :: is_picture_name

      is_picture_name = form_of(path) > 0
   end function is_picture_name


   !> Find out whether the picture can be written, and what goes beside it; does not return if not.
   subroutine begin_picture(path, extent, scale, name, command, keep, self)
      !> Where it goes: a name that [[is_picture_name]] knows
      character(len=*), intent(in) :: path
      !> Its width and height in pixels, before it is scaled
      integer, intent(in) :: extent(2)
      !> By how much paper, text and lines are larger
      real(wp), intent(in) :: scale
      !> What the picture is called, and the command line that asks for it
      character(len=*), intent(in) :: name
      character(len=*), intent(in) :: command
      !> Leave the data and the script beside it
      logical, intent(in) :: keep
      type(picture), intent(out) :: self

      self%path = path
      self%form = form_of(path)
      self%width = extent(1)
      self%height = extent(2)
      self%scale = scale
      self%name = name
      self%command = command
      self%keep = keep
      self%file = open_output(path)
      if (keep) call open_beside(self)
   end subroutine begin_picture


   !> Draw a figure. Without gnuplot its data and script are left beside the picture's place, as they
   !> are if they are to be kept, and the program ends with code 3.
   subroutine draw(self, content, title)
      type(picture), intent(inout) :: self
      type(figure), intent(in) :: content
      character(len=*), intent(in) :: title
      character(len=:), allocatable :: drawn, said
      integer :: code

      ! A name that begins with $ is one of data in the script
      call ask_gnuplot(self, content, script_of(self, content, title, "data = '$data'"), drawn, said, code)
      if (code == not_found) call leave_for_later(self, content, title)
      if (self%keep) call keep_data(self, content, title)
      if (code /= 0 .or. index(tail(drawn, 16), trim(closings(self%form))) == 0) then
         if (verify(said, nl // ' ') == 0) said = 'it has said nothing, and ended with ' // &
            to_text(code) // '; is there room in $TMPDIR or /tmp?'
         call complain('furiko plot: gnuplot drew no whole ' // self%path // ': ' // &
            last_line(tail(said, 1000)))
         call quit()
      end if
      if (endings(self%form) == '.svg') drawn = with_words(drawn, self%name, content%about)
      if (endings(self%form) == '.png') drawn = with_resolution(drawn, self%scale*pixels_per_inch)
      call self%file%add(drawn)
      call self%file%close()
   end subroutine draw


   !> Run gnuplot on data, which it calls $data, and a script; `code` is its own or [[not_found]].
   subroutine ask_gnuplot(self, content, script, drawn, said, code)
      type(picture), intent(in) :: self
      type(figure), intent(in) :: content
      character(len=*), intent(in) :: script
      !> The picture
      character(len=:), allocatable, intent(out) :: drawn
      !> What it says of errors
      character(len=:), allocatable, intent(out) :: said
      integer, intent(out) :: code
      type(c_ptr) :: streams(3)
      integer(c_int) :: ignored
      integer :: i

      do i = 1, size(streams)
         streams(i) = nameless_file(folder_of(self%path))
         if (.not. c_associated(streams(i))) call fail('a temporary file')
      end do
      ! One after the other, since flang joins texts on the stack, and data of an image would fill it
      call put('$data << END' // nl // head_of(self, content))
      call put(content%csv())
      call put('END' // nl // script)
      call to_start(streams(1))
      ! A terminal of the user's that it does not have can crash gnuplot
      ignored = c_setenv('GNUTERM' // c_null_char, 'unknown' // c_null_char, 1_c_int)
      ! By name, since gnuplot reads its standard input byte by byte: sixteen seconds for an image, not one
      call run_filter('gnuplot', '-d /dev/stdin', [(descriptor_of(streams(i)), i=1, size(streams))], code)
      if (code < 0) call fail(self%path)
      drawn = text_of(streams(2))
      said = text_of(streams(3))

   contains

      subroutine put(text)
         character(len=*), intent(in) :: text

         if (.not. append_text(streams(1), text)) call fail('a temporary file')
      end subroutine put

   end subroutine ask_gnuplot


   !> Without gnuplot: data and script for whoever has it. Does not return.
   subroutine leave_for_later(self, content, title)
      type(picture), intent(inout) :: self
      type(figure), intent(in) :: content
      character(len=*), intent(in) :: title
      character(len=:), allocatable :: stem
      logical :: taken

      stem = stem_of(self%path)
      taken = is_taken(stem // '.csv')
      if (.not. taken) taken = is_taken(stem // '.gp')
      if (taken .and. .not. self%keep) then
         call complain('furiko plot: no gnuplot here (apt-get install gnuplot-nox), and no data and ' // &
            'script for it: there is a ' // name_of(stem) // '.csv or .gp already; --data replaces them')
      else
         if (.not. self%keep) call open_beside(self)
         call keep_data(self, content, title)
         call complain('furiko plot: no gnuplot here, so data and script are written; apt-get ' // &
            'install gnuplot-nox, then, in ' // folder_of(self%path) // ': gnuplot ' // &
            quoted('./' // name_of(stem) // '.gp', "'\''"))
      end if
      call quit(3)
   end subroutine leave_for_later


   !> Open data and script. Where the user has not asked for them they replace nothing.
   subroutine open_beside(self)
      type(picture), intent(inout) :: self

      self%data = open_output(stem_of(self%path) // '.csv', fresh=.not. self%keep)
      self%script = open_output(stem_of(self%path) // '.gp', fresh=.not. self%keep)
   end subroutine open_beside


   !> Leave the data and a script for them, which go by the picture's name. None of the names that the
   !> script says begins with a character that gnuplot takes for a command's.
   subroutine keep_data(self, content, title)
      type(picture), intent(inout) :: self
      type(figure), intent(in) :: content
      character(len=*), intent(in) :: title

      call self%data%add(head_of(self, content))
      call self%data%add(content%csv())
      call self%script%add(script_of(self, content, title, 'set output ' // &
         quoted('./' // name_of(self%path)) // nl // 'data = ' // &
         quoted('./' // name_of(stem_of(self%path)) // '.csv')))
      call self%data%close()
      call self%script%close()
   end subroutine keep_data


   !> What stands above the data: what they are and which command makes them
   pure function head_of(self, content) result(text)
      type(picture), intent(in) :: self
      type(figure), intent(in) :: content
      character(len=:), allocatable :: text
      integer :: i

      text = '# ' // self%name // nl // '# command: ' // self%command // nl // '# curve: its name' // nl
      do i = 1, size(content%columns)
         text = text // '# ' // trim(content%columns(i)%name) // ': ' // trim(content%columns(i)%about) // nl
      end do
   end function head_of


   !> The whole script.
   function script_of(self, content, title, places) result(text)
      type(picture), intent(in) :: self
      type(figure), intent(in) :: content
      character(len=*), intent(in) :: title
      !> The lines that say where the data are and where the picture goes
      character(len=*), intent(in) :: places
      character(len=:), allocatable :: text

      text = '# SVG, PNG or PDF by its first lines; made by furiko plot' // nl // &
         'set encoding utf8' // nl // &
         'set minussign' // nl // &
         'set terminal ' // terminal_of(self) // nl // &
         'scale = ' // fixed(self%scale, 4) // nl // &
         places // nl // &
         '# The lines in front of the data' // nl // &
         'head = ' // to_text(4 + size(content%columns)) // nl // &
         "set datafile separator ','" // nl // &
         'set border 3 lw 1' // nl // &
         'set tics nomirror out' // nl // &
         'unset key' // nl // &
         'set multiplot'
      if (title /= '') text = text // ' title ' // quoted(title) // ' noenhanced'
      text = text // nl // content%script // 'unset multiplot' // nl // 'unset output' // nl
   end function script_of


   !> The terminal, with one and the same face: whatever the machine has for sans-serif. Paper, letters and
   !> lines grow together.
   pure function terminal_of(self) result(text)
      type(picture), intent(in) :: self
      character(len=:), allocatable :: text
      character(len=40) :: inches

      select case (endings(self%form))
      case ('.svg')
         text = 'svg size ' // pixels() // " font 'sans-serif,14'" // scaled(1.0_wp)
      case ('.png')
         text = 'pngcairo size ' // pixels() // " font 'sans-serif,10.5' dashlength 1.6" // scaled(1.0_wp)
      case default
         ! A little more than the size, since pdfcairo cuts off to whole points
         write(inches, '(f0.4, a, f0.4, a)') (self%scale*self%width + 0.1_wp)/pixels_per_inch, 'in,', &
            (self%scale*self%height + 0.1_wp)/pixels_per_inch, 'in'
         text = 'pdfcairo size ' // trim(inches) // " font 'sans-serif,8' dashlength 1.8" // scaled(1.5_wp)
      end select
      text = text // " background '#ffffff'"

   contains

      pure function pixels()
         character(len=:), allocatable :: pixels

         pixels = to_text(nint(self%scale*self%width)) // ',' // to_text(nint(self%scale*self%height))
      end function pixels

      pure function scaled(line) result(text)
         !> The terminal's own width of a line
         real(wp), intent(in) :: line
         character(len=:), allocatable :: text

         text = ' fontscale ' // fixed(self%scale, 4) // ' linewidth ' // fixed(line*self%scale, 4)
      end function scaled

   end function terminal_of


   !> A string in which nothing is special: of gnuplot's, in parts (it reads no doubled quote in front), or,
   !> with what stands there for a quote, the shell's
   pure function quoted(text, quote) result(string)
      character(len=*), intent(in) :: text
      character(len=*), intent(in), optional :: quote
      character(len=:), allocatable :: string
      character(len=:), allocatable :: inner

      inner = "'.""'"".'"
      if (present(quote)) inner = quote
      string = "'" // replaced(text, "'", inner) // "'"
   end function quoted


   !> Which of the endings a path has, its name being more than that; 0 for none.
   pure function form_of(path) result(form)
      character(len=*), intent(in) :: path
      integer :: form
      character(len=:), allocatable :: name

      name = name_of(path)
      do form = size(endings), 1, -1
         if (len(name) <= len(endings)) cycle
         if (name(len(name) - len(endings) + 1:) == endings(form)) return
      end do
   end function form_of


   !> A picture's path without its ending
   pure function stem_of(path) result(stem)
      character(len=*), intent(in) :: path
      character(len=:), allocatable :: stem

      stem = path(:len(path) - len(endings))
   end function stem_of


   !> The last bytes, at most so many
   pure function tail(text, length)
      character(len=*), intent(in) :: text
      integer, intent(in) :: length
      character(len=:), allocatable :: tail

      tail = text(max(1, len(text) - length + 1):)
   end function tail


   pure function last_line(text) result(line)
      character(len=*), intent(in) :: text
      character(len=:), allocatable :: line

      line = text(:verify(text, nl // ' ', back=.true.))
      line = adjustl(line(index(line, nl, back=.true.) + 1:))
   end function last_line

end module furiko_gnuplot
