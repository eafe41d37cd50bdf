! SPDX-License-Identifier: MIT

!> `furiko plot`: the figures of the notes, and a few they asked for.
module furiko_cli_plot
   use, intrinsic :: iso_fortran_env, only : int64, wp => real64
   use furiko_cli_quantity, only : angle_of, is_below_half_turn
   use furiko_cli_io, only : finish, put, refuse
   use furiko_cli_number, only : read_whole
   use furiko_cli_options, only : command, command_line, option, word
   use furiko_cli_text, only : cut, suggestion
   use furiko_figure, only : amplitude, figure
   use furiko_figure_accuracy, only : accuracy_figure
   use furiko_figure_converge, only : converge_figure
   use furiko_figure_drift, only : drift_figure
   use furiko_figure_energy, only : energy_figure
   use furiko_figure_motion, only : motion_figure
   use furiko_figure_period, only : period_figure
   use furiko_figure_phase, only : phase_figure
   use furiko_gnuplot, only : begin_picture, draw, is_picture_name, picture
   use furiko_word_arithmetic_dp, only : words
   implicit none
   private
   public :: plot_usage


   !> What a figure is called, what it shows, its amplitudes where it takes any
   type :: entry
      character(len=8) :: name
      character(len=64) :: about
      character(len=24) :: amplitudes
      integer :: most
   end type entry

   type(entry), parameter :: figures(*) = [ &
      entry('phase', 'phase portrait: librations, separatrix, rotations, by energy', &
         '30,60,90,120,150', 12), &
      entry('motion', 'angle against time, exact and harmonic', '0.1rad,0.3rad,1rad', 5), &
      entry('period', 'period against amplitude, its series, where it is 3 % longer', '', 0), &
      entry('drift', 'ten swings beside a small-angle clock, which is 3 % faster', '', 1), &
      entry('converge', 'error of K against work: series, trapezoidal rule, AGM', '60,170', 2), &
      entry('energy', 'drift of the energy: Runge-Kutta and symplectic methods', '1rad', 1), &
      entry('accuracy', 'error of K next to 180 degrees by k, m and mc', '', 0)]

contains


   function plot_usage() result(usage)
      type(command) :: usage

      usage = command('plot', 'figures, as SVG, PNG or PDF', 'FIGURE -o FILE', 1, &
         'Draws a figure with gnuplot, as SVG, PNG or PDF by the ending of FILE.', &
         'Without gnuplot the data and the script are written, and the code is 3.', &
         'furiko plot motion -o motion.svg --amplitude 0.1rad,0.3rad,1rad', options=[ &
         option('--list', about='the figures and their amplitudes'), &
         option('--output', 'FILE', '', 'the picture: .svg, .png or .pdf; an old one is replaced', 'o'), &
         option('--size', 'WxH', '800x500', 'width and height in pixels, 300 to 8000, 96 to the inch'), &
         option('--title', 'TEXT', '', 'a line above the picture'), &
         option('--amplitude', 'LIST', '', 'amplitudes between 0 and 180 degrees, as 30,60 or 0.1rad,1rad'), &
         option('--data', about='leave the data (.csv) and the script (.gp) beside FILE')], run=plot_command)
   end function plot_usage


   subroutine plot_command(line)
      type(command_line), intent(in) :: line
      type(entry) :: chosen
      ! no picture shows more
      integer, parameter :: most_bytes = 1000
      type(word) :: amplitudes, file, title
      integer :: extent(2)

      if (line%given('--list')) then
         call print_list()
         return
      end if
      if (size(line%operands) == 0) call reject('name a figure; furiko plot --list names all')
      chosen = find(line%operands(1)%text)
      file = line%value('--output')
      title = line%value('--title')
      amplitudes = line%value('--amplitude')
      if (file%text == '') call reject('where to? -o FILE, a name that ends in .svg, .png or .pdf')
      if (line%given('--amplitude') .and. amplitudes%text == '') call reject('--amplitude is empty')
      call check_text('-o', file%text)
      call check_text('--title', title%text)
      if (len(title%text) > most_bytes) call reject('--title is longer than 1000 bytes')
      if (.not. is_utf8(title%text)) call reject('--title is not UTF-8')
      if (index(title%text, ']]>') > 0) call reject('--title has ]]> in it, which no SVG may hold')
      if (has_noncharacter(title%text)) then
         call reject('--title has U+FFFE or U+FFFF in it, which no SVG may hold')
      end if
      if (.not. is_picture_name(file%text)) then
         call reject("-o '" // file%text // "' does not end in .svg, .png or .pdf")
      end if
      call read_size(line%value('--size'), extent)
      call make(chosen, amplitudes%text, file%text, extent, title%text, line%given('--data'))
   end subroutine plot_command


   !> Compute and draw; the amplitudes and the place are looked at before any work.
   subroutine make(chosen, list, file, extent, title, keep)
      type(entry), intent(in) :: chosen
      !> The amplitudes as they were typed; empty for the figure's own
      character(len=*), intent(in) :: list
      character(len=*), intent(in) :: file
      integer, intent(in) :: extent(2)
      character(len=*), intent(in) :: title
      logical, intent(in) :: keep
      type(amplitude), allocatable :: amplitudes(:)
      type(figure) :: content
      type(picture) :: place

      if (list /= '' .and. chosen%most == 0) call reject(trim(chosen%name) // ' takes no --amplitude')
      if (list /= '') then
         amplitudes = amplitudes_of(chosen, list)
      else if (chosen%amplitudes /= '') then
         amplitudes = amplitudes_of(chosen, trim(chosen%amplitudes))
      else
         allocate(amplitudes(0))
      end if
      call begin_picture(file, extent(1), extent(2), keep, place)

      select case (chosen%name)
      case ('phase')
         call phase_figure(amplitudes, content)
      case ('motion')
         call motion_figure(amplitudes, content)
      case ('drift')
         call drift_figure(amplitudes, content)
      case ('converge')
         call converge_figure(amplitudes, content)
      case ('energy')
         call energy_figure(amplitudes(1), content)
      case ('period')
         call period_figure(content)
      case default
         call accuracy_figure(content)
      end select
      call draw(place, content, title)
   end subroutine make


   function find(name) result(chosen)
      character(len=*), intent(in) :: name
      type(entry) :: chosen
      integer :: i

      chosen = entry('', '', '', 0)
      do i = 1, size(figures)
         if (figures(i)%name == name) then
            chosen = figures(i)
            return
         end if
      end do
      call reject("no figure '" // name // "'; " // &
         suggestion(name, [(figures(i)%name, i=1, size(figures))], 'furiko plot --list names all'))
   end function find


   subroutine print_list()
      integer :: i

      do i = 1, size(figures)
         call put(figures(i)%name // '  ' // trim(figures(i)%about // figures(i)%amplitudes))
      end do
      call finish()
   end subroutine print_list


   !> The size from WxH.
   subroutine read_size(given, extent)
      type(word), intent(in) :: given
      integer, intent(out) :: extent(2)
      integer(int64) :: side(2)
      integer :: cross
      logical :: valid(2)

      cross = index(given%text, 'x')
      call read_whole(given%text(:max(0, cross - 1)), side(1), valid(1))
      call read_whole(given%text(cross + 1:), side(2), valid(2))
      if (.not. all(valid .and. side >= 300 .and. side <= 8000)) call reject("--size '" // given%text // &
         "' is not as 800x500, each from 300 to 8000 pixels")
      extent = int(side)
   end subroutine read_size


   !> The amplitudes of a list with commas between.
   function amplitudes_of(chosen, list) result(amplitudes)
      type(entry), intent(in) :: chosen
      character(len=*), intent(in) :: list
      type(amplitude), allocatable :: amplitudes(:)
      character(len=:), allocatable :: first, rest
      integer :: i

      allocate(amplitudes(count([(list(i:i) == ',', i=1, len(list))]) + 1))
      if (size(amplitudes) > chosen%most) then
         call reject(trim(chosen%name) // ' has no room for so many amplitudes')
      end if
      rest = list
      do i = 1, size(amplitudes)
         call cut(rest, ',', first)
         amplitudes(i) = amplitude_of(first)
      end do
   end function amplitudes_of


   function amplitude_of(text) result(self)
      character(len=*), intent(in) :: text
      type(amplitude) :: self
      type(words) :: angle
      integer :: last

      angle = angle_of(word('furiko plot: --amplitude', text))
      if (angle%hi <= 0.0_wp .or. .not. is_below_half_turn(angle)) then
         call reject('--amplitude ' // text // ' is outside 0 < amplitude < 180 degrees')
      end if
      last = verify(text, 'adegr', back=.true.)
      self%radians = angle%hi
      self%in_degrees = text(last + 1:) /= 'rad'
      if (self%in_degrees) then
         self%label = text(:last) // '°'
      else
         self%label = text(:last) // ' rad'
      end if
   end function amplitude_of


   !> A name or title goes into a gnuplot script, a line of its own.
   subroutine check_text(option, text)
      character(len=*), intent(in) :: option
      character(len=*), intent(in) :: text
      integer :: i

      if (any([(iachar(text(i:i)) < 32 .or. iachar(text(i:i)) == 127, i=1, len(text))])) then
         call reject(option // ' has a control character in it')
      end if
   end subroutine check_text


   !> Whether every lead byte has its continuation bytes, and the shortest form of a character that
   !> there is (Unicode, table 3-7): an SVG file may hold nothing else.
   pure function is_utf8(text)
      character(len=*), intent(in) :: text
      logical :: is_utf8
      integer :: byte, expected, i, least, most

      is_utf8 = .false.
      expected = 0
      least = 128
      most = 191
      do i = 1, len(text)
         byte = iachar(text(i:i))
         if (expected > 0) then
            if (byte < least .or. byte > most) return
            expected = expected - 1
            least = 128
            most = 191
         else
            if (byte == 224) least = 160
            if (byte == 240) least = 144
            if (byte == 237) most = 159
            if (byte == 244) most = 143
            select case (byte)
            case (0:127)
               expected = 0
            case (194:223)
               expected = 1
            case (224:239)
               expected = 2
            case (240:244)
               expected = 3
            case default
               return
            end select
         end if
      end do
      is_utf8 = expected == 0
   end function is_utf8


   !> Whether well-formed text has one of the two characters of three bytes that XML excludes
   pure function has_noncharacter(text)
      character(len=*), intent(in) :: text
      logical :: has_noncharacter
      character(len=*), parameter :: before_last = char(239) // char(191)

      has_noncharacter = index(text, before_last // char(190)) + index(text, before_last // char(191)) > 0
   end function has_noncharacter


   subroutine reject(message)
      character(len=*), intent(in) :: message

      call refuse('furiko plot: ' // message)
   end subroutine reject

end module furiko_cli_plot
