! SPDX-License-Identifier: MIT

!> `furiko plot`: the figures of the notes, and a few they asked for.
module furiko_cli_plot
   use, intrinsic :: iso_fortran_env, only : wp => real64
   use furiko_cli_arguments, only : argument_reader, value_of
   use furiko_cli_quantity, only : angle_of, is_below_half_turn
   use furiko_cli_terminal, only : finish, put, refuse
   use furiko_double_word, only : double_word
   use furiko_figure, only : amplitude, figure
   use furiko_figure_accuracy, only : accuracy_figure
   use furiko_figure_converge, only : converge_figure
   use furiko_figure_drift, only : drift_figure
   use furiko_figure_energy, only : energy_figure
   use furiko_figure_motion, only : motion_figure
   use furiko_figure_period, only : period_figure
   use furiko_figure_phase, only : phase_figure
   use furiko_gnuplot, only : begin_picture, draw, is_picture_name, picture
   implicit none
   private
   public :: plot_command


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

   character(len=*), parameter :: nl = new_line('a')
   character(len=*), parameter :: help = &
      'furiko plot FIGURE -o FILE [--size WxH] [--title TEXT] [--amplitude LIST] [--data]' // nl // &
      'furiko plot --list' // nl // nl // &
      'Draws a figure with gnuplot, as SVG, PNG or PDF by the ending of FILE.' // nl // nl // &
      '  -o, --output FILE    the picture: .svg, .png or .pdf; an old one is replaced' // nl // &
      '  --size WxH           width and height in pixels, 300 to 8000, 96 to the inch (800x500)' // nl // &
      '  --title TEXT         a line above the picture (none)' // nl // &
      '  --amplitude LIST     amplitudes between 0 and 180 degrees, as 30,60 or 0.1rad,1rad' // nl // &
      '  --data               leave the data (.csv) and the script (.gp) beside FILE' // nl // nl // &
      '--list names the figures and their amplitudes. Without gnuplot the data and the script are' // nl // &
      'written, and the code is 3. Example:' // nl // nl // &
      '  furiko plot motion -o motion.svg --amplitude 0.1rad,0.3rad,1rad'


contains


   !> Parse the words that follow `plot`, then draw.
   subroutine plot_command(arguments)
      type(argument_reader), intent(inout) :: arguments
      type(entry) :: chosen
      character(len=:), allocatable :: amplitudes, file, title, word
      integer :: extent(2)
      logical :: keep

      chosen = entry('', '', '', 0)
      amplitudes = ''
      file = ''
      title = ''
      extent = [800, 500]
      keep = .false.
      do while (.not. arguments%done())
         word = arguments%word()
         call arguments%advance()
         select case (word)
         case ('-h', '--help')
            call put(help)
            call finish()
            return
         case ('--list')
            call print_list()
            return
         case ('-o', '--output')
            file = value_of('furiko plot', word, arguments)
         case ('--size')
            call read_size(value_of('furiko plot', word, arguments), extent)
         case ('--title')
            title = value_of('furiko plot', word, arguments)
         case ('--amplitude')
            amplitudes = value_of('furiko plot', word, arguments)
            if (amplitudes == '') call reject('--amplitude is empty')
         case ('--data')
            keep = .true.
         case default
            if (chosen%name /= '') call reject("unknown word '" // word // "'; see furiko plot --help")
            chosen = find(word)
         end select
      end do
      if (chosen%name == '') call reject('name a figure; furiko plot --list names all')
      if (file == '') call reject('where to? -o FILE, a name that ends in .svg, .png or .pdf')
      call check_text('-o', file)
      call check_text('--title', title)
      if (.not. is_utf8(title)) call reject('--title is not UTF-8')
      if (has_noncharacter(title)) call reject('--title has U+FFFE or U+FFFF in it, which no SVG may hold')
      if (.not. is_picture_name(file)) then
         call reject("-o '" // file // "' does not end in .svg, .png or .pdf")
      end if
      call make(chosen, amplitudes, file, extent, title, keep)
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
      call begin_picture(file, extent(1), extent(2), place)

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
      call draw(place, content, title, keep)
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
      call reject("no figure '" // name // "'; furiko plot --list names all")
   end function find


   subroutine print_list()
      integer :: i

      do i = 1, size(figures)
         call put(figures(i)%name // '  ' // trim(figures(i)%about // figures(i)%amplitudes))
      end do
      call finish()
   end subroutine print_list


   !> The size from WxH.
   subroutine read_size(word, extent)
      character(len=*), intent(in) :: word
      integer, intent(out) :: extent(2)
      integer :: cross, stat

      extent = 0
      stat = 1
      cross = index(word, 'x')
      if (verify(word, '0123456789x') == 0 .and. cross > 1 .and. cross < len(word) .and. &
         index(word, 'x', back=.true.) == cross .and. len(word) <= 9) then
         read(word(:cross - 1), '(i9)', iostat=stat) extent(1)
         if (stat == 0) read(word(cross + 1:), '(i9)', iostat=stat) extent(2)
      end if
      if (stat == 0 .and. all(extent >= 300 .and. extent <= 8000)) return
      call reject("--size '" // word // "' is not as 800x500, each from 300 to 8000 pixels")
   end subroutine read_size


   !> The amplitudes of a list with commas between.
   function amplitudes_of(chosen, list) result(amplitudes)
      type(entry), intent(in) :: chosen
      character(len=*), intent(in) :: list
      type(amplitude), allocatable :: amplitudes(:)
      integer :: comma, from, i

      allocate(amplitudes(count([(list(i:i) == ',', i=1, len(list))]) + 1))
      if (size(amplitudes) > chosen%most) then
         call reject(trim(chosen%name) // ' has no room for so many amplitudes')
      end if
      from = 1
      do i = 1, size(amplitudes)
         comma = index(list(from:), ',')
         if (comma == 0) comma = len(list) - from + 2
         amplitudes(i) = amplitude_of(list(from:from + comma - 2))
         from = from + comma
      end do
   end function amplitudes_of


   function amplitude_of(word) result(self)
      character(len=*), intent(in) :: word
      type(amplitude) :: self
      type(double_word) :: angle
      integer :: last

      angle = angle_of('furiko plot: --amplitude', word)
      if (angle%hi <= 0.0_wp .or. .not. is_below_half_turn(angle)) then
         call reject('--amplitude ' // word // ' is outside 0 < amplitude < 180 degrees')
      end if
      last = verify(word, 'adegr', back=.true.)
      self%radians = angle%hi
      self%in_degrees = word(last + 1:) /= 'rad'
      if (self%in_degrees) then
         self%label = word(:last) // '°'
      else
         self%label = word(:last) // ' rad'
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
