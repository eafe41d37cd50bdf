! SPDX-License-Identifier: MIT

!> Figures drawn by gnuplot: the script, the call, and a picture that is there whole or not at all.
!>
!> All work is done in a folder of its own beside the picture, which is entered: the shell and gnuplot
!> see only names that are written here, for gnuplot runs a file's name that begins with < or | as a
!> command. The last step is a rename on one disk.
module furiko_gnuplot
   use, intrinsic :: iso_fortran_env, only : int64, wp => real64
   use furiko_cli_files, only : can_replace, enter_folder, folder_of, is_there, make_folder, move_file, &
      name_of, process_id, remove_file, tail_of, write_file
   use furiko_cli_terminal, only : complain, fail, quit, say_why
   use furiko_figure, only : figure, to_text
   implicit none
   private
   public :: picture, is_picture_name, begin_picture, draw


   character(len=*), parameter :: nl = new_line('a')
   character(len=*), parameter :: endings(*) = [character(len=4) :: '.svg', '.png', '.pdf']
   !> What stands within the last bytes of a whole picture of each kind
   character(len=*), parameter :: closings(*) = [character(len=6) :: '</svg>', 'IEND', '%%EOF']
   character(len=*), parameter :: data_name = 'furiko.csv'
   character(len=*), parameter :: picture_name = 'furiko'
   character(len=*), parameter :: script_name = 'furiko.gp'
   character(len=*), parameter :: log_name = 'furiko.log'
   !> The shell's code for a command that is not there
   integer, parameter :: not_found = 127
   real(wp), parameter :: pixels_per_inch = 96.0_wp


   !> A picture to be made, its work folder open.
   type :: picture
      private
      character(len=:), allocatable :: path
      character(len=:), allocatable :: work
      !> The name without its folder; without its ending, too
      character(len=:), allocatable :: name
      character(len=:), allocatable :: stem
      integer :: form = 0
      integer :: width = 0
      integer :: height = 0
   end type picture


contains


   !> Whether a file's ending is that of a picture.
   pure function is_picture_name(path)
      character(len=*), intent(in) :: path
      logical :: is_picture_name

      is_picture_name = form_of(path) > 0
   end function is_picture_name


   !> Find out whether the picture can be written, and open its work folder; does not return if not.
   subroutine begin_picture(path, width, height, self)
      !> Where it goes: a name that [[is_picture_name]] knows
      character(len=*), intent(in) :: path
      !> Its size in pixels
      integer, intent(in) :: width
      integer, intent(in) :: height
      type(picture), intent(out) :: self
      character(len=40) :: tag
      integer(int64) :: ticks
      logical :: done

      call system_clock(ticks)
      write(tag, '(a, i0, a, i0)') '.furiko-', process_id(), '-', ticks
      self%path = path
      self%work = trim(tag)
      self%name = name_of(path)
      self%stem = self%name(:len(self%name) - len(endings))
      self%form = form_of(path)
      self%width = width
      self%height = height
      if (.not. can_replace(path)) then
         call complain('furiko: cannot write ' // path // ': it is a folder, or write-protected')
         call quit()
      end if
      call make_folder(folder_of(path) // self%work, done)
      if (done) call enter_folder(folder_of(path) // self%work, done)
      if (.not. done) call fail(path)
   end subroutine begin_picture


   !> Draw a figure. Without gnuplot its data and script are left beside the picture's place, as
   !> with `keep`, and the program ends with code 3.
   subroutine draw(self, content, title, keep)
      type(picture), intent(in) :: self
      type(figure), intent(in) :: content
      character(len=*), intent(in) :: title
      !> Leave the data and the script beside the picture
      logical, intent(in) :: keep
      character(len=:), allocatable :: drawn
      integer :: code, ignored
      logical :: done

      drawn = picture_name // endings(self%form)
      call write_file(data_name, content%csv(), done)
      if (done) call write_file(script_name, script_of(self, content, title, data_name, drawn), done)
      if (.not. done) call give_up(self)
      ! A terminal of the user's that it does not have can crash gnuplot; cmdstat is asked for since
      ! flang stops at a command's own exit code otherwise
      ! allow(C181)
      call execute_command_line('GNUTERM=unknown gnuplot -d ' // script_name // ' >' // log_name // ' 2>&1', &
         exitstat=code, cmdstat=ignored)
      if (code == not_found) call leave_for_later(self, content, title, keep)
      if (keep) call keep_data(self, content, title)

      done = code == 0
      if (done) done = index(tail_of(drawn, 16), trim(closings(self%form))) > 0
      if (.not. done) then
         call complain('furiko plot: gnuplot drew no whole ' // self%path // ': ' // &
            last_line(tail_of(log_name, 1000)))
         call clear(self)
         call quit()
      end if
      call move_file(drawn, '../' // self%name, done)
      if (.not. done) call give_up(self)
      call clear(self)
   end subroutine draw


   !> Without gnuplot: data and script for whoever has it. Does not return.
   subroutine leave_for_later(self, content, title, replace)
      type(picture), intent(in) :: self
      type(figure), intent(in) :: content
      character(len=*), intent(in) :: title
      !> Whether files of these names may be replaced
      logical, intent(in) :: replace
      logical :: taken

      taken = is_there('../' // self%stem // '.csv')
      if (.not. taken) taken = is_there('../' // self%stem // '.gp')
      if (taken .and. .not. replace) then
         call complain('furiko plot: no gnuplot here (apt-get install gnuplot-nox), and no data and ' // &
            'script for it: there is a ' // self%stem // '.csv or .gp already; --data replaces them')
      else
         call keep_data(self, content, title)
         call complain('furiko plot: no gnuplot here, so data and script are written; apt-get ' // &
            'install gnuplot-nox, then, in ' // folder_of(self%path) // ': gnuplot ' // &
            quoted('./' // self%stem // '.gp', "'\''"))
      end if
      call clear(self)
      call quit(3)
   end subroutine leave_for_later


   !> Leave the data and a script for them, which go by the picture's name. None of the names that the
   !> script says begins with a character that gnuplot takes for a command's.
   subroutine keep_data(self, content, title)
      type(picture), intent(in) :: self
      type(figure), intent(in) :: content
      character(len=*), intent(in) :: title
      logical :: done

      call write_file(script_name, script_of(self, content, title, './' // self%stem // '.csv', &
         './' // self%name), done)
      if (done) call move_file(data_name, '../' // self%stem // '.csv', done)
      if (done) call move_file(script_name, '../' // self%stem // '.gp', done)
      if (.not. done) call give_up(self)
   end subroutine keep_data


   !> The whole script: it needs the data beside it, and makes the picture there.
   function script_of(self, content, title, data, drawn) result(text)
      type(picture), intent(in) :: self
      type(figure), intent(in) :: content
      character(len=*), intent(in) :: title
      !> The data's and the picture's name
      character(len=*), intent(in) :: data
      character(len=*), intent(in) :: drawn
      character(len=:), allocatable :: text

      text = '# SVG, PNG or PDF by its first lines; made by furiko plot' // nl // &
         'set encoding utf8' // nl // &
         'set minussign' // nl // &
         'set terminal ' // terminal_of(self) // nl // &
         'set output ' // quoted(drawn) // nl // &
         'data = ' // quoted(data) // nl // &
         "set datafile separator ','" // nl // &
         'set border 3 lw 1' // nl // &
         'set tics nomirror out' // nl // &
         'unset key' // nl
      if (content%layout /= '') then
         text = text // margins_of(self, title) // 'set multiplot layout ' // content%layout
         if (title /= '') text = text // ' title ' // quoted(title) // ' noenhanced'
         text = text // nl
      else if (title /= '') then
         text = text // 'set title ' // quoted(title) // ' noenhanced' // nl
      end if
      text = text // content%script // 'unset output' // nl
   end function script_of


   !> The room for tics and labels around panels, in parts of the picture: gnuplot leaves none.
   pure function margins_of(self, title) result(text)
      type(picture), intent(in) :: self
      character(len=*), intent(in) :: title
      character(len=:), allocatable :: text

      text = 'left = 100.0/' // to_text(self%width) // nl // &
         'right = 1 - 25.0/' // to_text(self%width) // nl // &
         'line = 20.0/' // to_text(self%height) // nl // &
         'bottom = 76.0/' // to_text(self%height) // nl // &
         'top = 1 - ' // merge('40.0/', '65.0/', title == '') // to_text(self%height) // nl
   end function margins_of


   !> The terminal, with one and the same face: whatever the machine has for sans-serif.
   pure function terminal_of(self) result(text)
      type(picture), intent(in) :: self
      character(len=:), allocatable :: text
      character(len=40) :: inches

      select case (endings(self%form))
      case ('.svg')
         text = 'svg size ' // to_text(self%width) // ',' // to_text(self%height) // &
            " font 'sans-serif,14'"
      case ('.png')
         text = 'pngcairo size ' // to_text(self%width) // ',' // to_text(self%height) // &
            " font 'sans-serif,10.5' dashlength 1.6"
      case default
         ! A little more than the size, since pdfcairo cuts off to whole points
         write(inches, '(f0.4, a, f0.4, a)') (self%width + 0.1_wp)/pixels_per_inch, 'in,', &
            (self%height + 0.1_wp)/pixels_per_inch, 'in'
         text = 'pdfcairo size ' // trim(inches) // " font 'sans-serif,8' fontscale 1" // &
            ' linewidth 1.5 dashlength 1.8'
      end select
      text = text // " background '#ffffff'"
   end function terminal_of


   !> A string in which nothing is special: of gnuplot's, in parts (it reads no doubled quote in front), or,
   !> with what stands there for a quote, the shell's
   pure function quoted(text, quote) result(string)
      character(len=*), intent(in) :: text
      character(len=*), intent(in), optional :: quote
      character(len=:), allocatable :: string
      character(len=:), allocatable :: inner
      integer :: i

      inner = "'.""'"".'"
      if (present(quote)) inner = quote
      string = "'"
      do i = 1, len(text)
         if (text(i:i) == "'") then
            string = string // inner
         else
            string = string // text(i:i)
         end if
      end do
      string = string // "'"
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


   pure function last_line(text) result(line)
      character(len=*), intent(in) :: text
      character(len=:), allocatable :: line

      line = text(:verify(text, nl // ' ', back=.true.))
      line = adjustl(line(index(line, nl, back=.true.) + 1:))
   end function last_line


   !> Say that the picture cannot be written and why; does not return.
   subroutine give_up(self)
      type(picture), intent(in) :: self

      call say_why(self%path)
      call clear(self)
      call quit()
   end subroutine give_up


   !> Leave the work folder, in which we are, and remove it.
   subroutine clear(self)
      type(picture), intent(in) :: self
      logical :: ignored

      call remove_file(data_name)
      call remove_file(script_name)
      call remove_file(log_name)
      call remove_file(picture_name // endings(self%form))
      call enter_folder('..', ignored)
      call remove_file(self%work)
   end subroutine clear

end module furiko_gnuplot
