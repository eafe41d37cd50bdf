! SPDX-License-Identifier: MIT

!> `furiko plot`: the figures of the notes, and a few they asked for.
module furiko_cli_plot
   use, intrinsic :: iso_fortran_env, only : int64, wp => real64
   use furiko_cli_quantity, only : angle_of, is_below_half_turn, no_unit, number_of
   use furiko_cli_io, only : finish, put, refuse
   use furiko_cli_number, only : read_whole
   use furiko_cli_options, only : argument, command, command_line, demand, option, word
   use furiko_cli_text, only : cut, replaced, suggestion
   use furiko_figure, only : amplitude, figure, paper
   use furiko_figure_accuracy, only : accuracy_figure
   use furiko_figure_basins, only : basins_figure
   use furiko_figure_converge, only : converge_figure
   use furiko_figure_density, only : bifurcation_figure
   use furiko_figure_drift, only : drift_figure
   use furiko_figure_driven, only : driven_figure, poincare_figure
   use furiko_figure_energy, only : energy_figure
   use furiko_figure_flow, only : flow_figure
   use furiko_figure_functions, only : functions_figure, integrals_figure, surface_figure
   use furiko_figure_motion, only : motion_figure
   use furiko_figure_period, only : period_figure
   use furiko_figure_phase, only : phase_figure
   use furiko_figure_spectrum, only : spectrum_figure
   use furiko_figure_sweep, only : exponents_figure, staircase_figure
   use furiko_figure_tension, only : tension_figure
   use furiko_gnuplot, only : begin_picture, draw, is_picture_name, picture
   use furiko_word_arithmetic_dp, only : words
   implicit none
   private
   public :: plot_usage


   !> What a figure is called, what it shows, its amplitudes where it takes any, and who makes it
   type :: entry
      character(len=11) :: name = ''
      character(len=64) :: about = ''
      character(len=24) :: amplitudes = ''
      integer :: most = 0
      procedure(maker), pointer, nopass :: make => null()
      !> The command of furiko driven whose CSV it draws with --from, where there is one
      character(len=11) :: subject = ''
   end type entry


   integer, parameter :: how_many = 19


   abstract interface
      !> Curves and commands of a figure, on the paper that it brings
      subroutine maker(amplitudes, self)
         import :: amplitude, figure
         implicit none
         !> Some; one or none where it takes none
         type(amplitude), intent(in) :: amplitudes(:)
         type(figure), intent(inout) :: self
      end subroutine maker
   end interface


contains


   function all_figures() result(list)
      type(entry) :: list(how_many)

      list = [ &
         entry('phase', 'phase portrait: librations, the separatrix, rotations', '30,60,90,120,150', 12, &
            phase_figure), &
         entry('motion', 'angle against time, exact and harmonic', '0.1rad,0.3rad,1rad', 5, motion_figure), &
         entry('period', 'period against amplitude up to 179.9 degrees, and its series', '', 0, &
         period_figure), &
         entry('drift', 'ten swings beside a small-angle clock, which is 3 % faster', '', 1, drift_figure), &
         entry('converge', 'error of K against work: series, trapezoidal rule, AGM', '60,170', 2, &
            converge_figure), &
         entry('energy', 'error of the energy: Runge-Kutta and symplectic methods', '1rad', 1, &
         energy_figure), &
         entry('accuracy', 'error of K next to 180 degrees by k, m and mc', '', 0, accuracy_figure), &
         entry('functions', 'sn, cn, dn and am for four parameters m', '', 0, functions_figure), &
         entry('integrals', 'K, E and their complements; F and E over the angle', '', 0, integrals_figure), &
         entry('surface', 'sn(u, m) as a surface over u and m', '', 0, surface_figure), &
         entry('spectrum', 'Fourier coefficients of the swing against amplitude', '', 0, spectrum_figure), &
         entry('flow', 'where every angle and rate of the pendulum go next', '', 0, flow_figure), &
         entry('tension', 'pull on the string, and where it goes slack', '60,90,120,150', 6, &
         tension_figure), &
         entry('driven', 'orbits of a driven pendulum with friction, periodic and not', '', 0, &
         driven_figure), &
         entry('poincare', 'section of a chaotic driven pendulum, once a period of the drive', '', 0, &
            poincare_figure, 'section'), &
         entry('bifurcation', 'angles of driven pendulums against a constant: cycles, chaos', '', 0, &
            bifurcation_figure, 'bifurcation'), &
         entry('basins', 'which attractor each start of a driven pendulum comes to', '', 0, &
            basins_figure, 'basins'), &
         entry('staircase', 'winding number of driven pendulums: steps locked to the drive', '', 0, &
            staircase_figure, 'winding'), &
         entry('exponents', 'Lyapunov exponent of driven pendulums against a constant', '', 0, &
            exponents_figure, 'lyapunov')]
   end function all_figures


   function plot_usage() result(usage)
      type(command) :: usage

      usage = command('plot', 'figures, as SVG, PNG or PDF', 'FIGURE -o FILE', 1, &
         'Draws a figure with gnuplot, as SVG, PNG or PDF by the ending of FILE.', &
         'Without gnuplot the data and the script are written, and the code is 3.', &
         'furiko plot motion -o motion.svg --amplitude 0.1rad,0.3rad,1rad', options=[ &
         option('--list', about='the figures and their amplitudes'), &
         option('--output', 'FILE', '', 'the picture: .svg, .png or .pdf; an old one is replaced', 'o'), &
         option('--size', 'WxH', '800x500', 'width and height in pixels, 600x400 to 8000x8000, 96 to ' // &
         'the inch'), &
         option('--scale', 'S', '1', 'paper, text and lines so many times as large, 0.75 to 8: with 2 a ' // &
            'PNG looks the same and has twice the pixels'), &
         option('--title', 'TEXT', '', 'a line above the picture'), &
         option('--amplitude', 'LIST', '', 'amplitudes between 0 and 180 degrees, as 30,60 or 0.1rad,1rad'), &
         option('--from', 'FILE', '', 'poincare, bifurcation, basins, staircase or exponents: draw what ' // &
            'furiko driven section, bifurcation, basins, winding or lyapunov has written with ' // &
            '--format csv (- is standard input), or the HDF5 file of a sweep by ensemble'), &
         option('--data', about='leave the data (.csv, with units and this command) and the script ' // &
            '(.gp) beside FILE')], run=plot_command)
   end function plot_usage


   subroutine plot_command(line)
      type(command_line), intent(in) :: line
      type(entry) :: chosen
      type(word) :: amplitudes, file, from, title
      type(amplitude), allocatable :: wanted(:)
      type(figure) :: content
      type(picture) :: place
      integer :: extent(2)
      real(wp) :: scale

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
      from = line%value('--from')
      if (line%given('--from')) call check_from(chosen, from%text)
      if (line%given('--amplitude') .and. amplitudes%text == '') call reject('--amplitude is empty')
      call check_text('-o', file%text)
      call check_title(title%text)
      if (.not. is_picture_name(file%text)) then
         call reject("-o '" // file%text // "' does not end in .svg, .png or .pdf")
      end if
      call read_size(line%value('--size'), line%value('--scale'), extent, scale)
      wanted = amplitudes_of(chosen, amplitudes%text)

      ! All that can be refused has been, before any work.
      call begin_picture(file%text, extent, scale, name_of(chosen, title%text), typed(), &
         line%given('--data'), place)
      content%from = from%text
      content%sheet = paper(extent(1), extent(2), title%text /= '')
      call chosen%make(wanted, content)
      call draw(place, content, title%text)
   end subroutine plot_command


   subroutine check_from(chosen, file)
      type(entry), intent(in) :: chosen
      character(len=*), intent(in) :: file

      if (chosen%subject == '') call reject(trim(chosen%name) // ' takes no --from')
      if (file == '') call reject('--from is empty')
      call check_text('--from', file)
   end subroutine check_from


   !> A title is text of an SVG file.
   subroutine check_title(title)
      character(len=*), intent(in) :: title
      ! no picture shows more
      integer, parameter :: most_bytes = 1000

      call check_text('--title', title)
      if (len(title) > most_bytes) call reject('--title is longer than 1000 bytes')
      if (.not. is_utf8(title)) call reject('--title is not UTF-8')
      if (index(title, ']]>') > 0) call reject('--title has ]]> in it, which no SVG may hold')
      if (has_noncharacter(title)) call reject('--title has U+FFFE or U+FFFF in it, which no SVG may hold')
   end subroutine check_title


   !> What the picture calls itself: its title, or what the list says of the figure
   pure function name_of(chosen, title) result(name)
      type(entry), intent(in) :: chosen
      character(len=*), intent(in) :: title
      character(len=:), allocatable :: name

      name = title
      if (title == '') name = trim(chosen%name) // ': ' // trim(chosen%about)
   end function name_of


   !> The command line, quoted for the shell where that is needed
   function typed() result(text)
      character(len=:), allocatable :: text
      character(len=:), allocatable :: next
      integer :: i

      text = 'furiko'
      do i = 1, command_argument_count()
         next = argument(i)
         if (verify(next, 'abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789.,/_=-') > 0 .or. &
            next == '') next = "'" // replaced(next, "'", "'\''") // "'"
         text = text // ' ' // next
      end do
   end function typed


   function find(name) result(chosen)
      character(len=*), intent(in) :: name
      type(entry) :: chosen
      type(entry) :: figures(how_many)
      integer :: i

      figures = all_figures()
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
      type(entry) :: figures(how_many)
      integer :: i

      figures = all_figures()
      do i = 1, size(figures)
         call put(figures(i)%name // '  ' // trim(figures(i)%about // figures(i)%amplitudes))
      end do
      call finish()
   end subroutine print_list


   !> The size from WxH, and by how much it grows.
   subroutine read_size(given, given_scale, extent, scale)
      type(word), intent(in) :: given
      type(word), intent(in) :: given_scale
      integer, intent(out) :: extent(2)
      real(wp), intent(out) :: scale
      !> Below these, labels have no room.
      integer, parameter :: least(2) = [600, 400]
      integer, parameter :: most = 8000
      type(words) :: number
      integer(int64) :: side(2)
      integer :: cross
      logical :: valid(2)

      cross = index(given%text, 'x')
      call read_whole(given%text(:max(0, cross - 1)), side(1), valid(1))
      call read_whole(given%text(cross + 1:), side(2), valid(2))
      if (.not. all(valid .and. side >= least .and. side <= most)) call reject("--size '" // &
         given%text // "' is not as 800x500, from 600x400 to 8000x8000 pixels")
      extent = int(side)
      number = number_of(given_scale, no_unit)
      scale = number%hi
      call demand(scale >= 0.75_wp .and. scale <= 8.0_wp, given_scale, '0.75 to 8')
      call demand(maxval(extent)*scale < most + 0.5_wp, given_scale, 'what keeps ' // given%text // &
         ' within 8000 pixels')
   end subroutine read_size


   !> The amplitudes of a list with commas between, or the figure's own if it is empty.
   function amplitudes_of(chosen, typed) result(amplitudes)
      type(entry), intent(in) :: chosen
      character(len=*), intent(in) :: typed
      type(amplitude), allocatable :: amplitudes(:)
      character(len=:), allocatable :: first, list, rest
      integer :: i

      list = typed
      if (typed /= '' .and. chosen%most == 0) call reject(trim(chosen%name) // ' takes no --amplitude')
      if (typed == '') list = trim(chosen%amplitudes)
      allocate(amplitudes(0))
      if (list == '') return
      deallocate(amplitudes)
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
