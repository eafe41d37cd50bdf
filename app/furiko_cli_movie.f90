! SPDX-License-Identifier: MIT

!> A film of whole periods, which goes round without a jump: frames by gnuplot, put together by ffmpeg.
module furiko_cli_movie
   use, intrinsic :: iso_c_binding, only : c_associated, c_int, c_ptr
   use, intrinsic :: iso_fortran_env, only : wp => real64
   use furiko, only : motion
   use furiko_cli_files, only : append_text, descriptor_of, folder_of, nameless_file, open_output, output, &
      text_of, to_start
   use furiko_cli_io, only : complain, fail, quit
   use furiko_cli_number, only : shortest
   use furiko_cli_options, only : command_line
   use furiko_cli_process, only : run_filter
   use furiko_cli_text, only : whole_text
   use furiko_figure, only : fixed
   implicit none
   private
   public :: film


   character(len=*), parameter :: nl = new_line('a')
   real(wp), parameter :: pi = acos(-1.0_wp)
   real(wp), parameter :: frames_a_second = 25.0_wp
   !> Of the longest film
   integer, parameter :: most_frames = 1500
   !> The code for a program that is not there
   integer, parameter :: not_found = 127


contains


   !> Write a film of a motion, and of one beside it where that has a period.
   subroutine film(line, file, form, path, beside, other)
      type(command_line), intent(in) :: line
      character(len=*), intent(in) :: file
      !> gif or mp4
      character(len=*), intent(in) :: form
      type(motion), intent(in) :: path
      !> The period of what stands beside it, 0 for nothing
      real(wp), intent(in) :: beside
      !> That motion, if it is not the small-angle one
      type(motion), intent(in), optional :: other
      type(output) :: place
      real(wp) :: angles(most_frames, 2), length, time
      integer :: count, i

      if (.not. path%period()*frames_a_second <= most_frames) call line%reject('a period of ' // &
         shortest(path%period()) // ' s makes more than ' // whole_text(most_frames) // ' frames')
      length = path%period()*whole_periods(path%period(), beside)
      count = max(2, nint(frames_a_second*length))
      do i = 1, count
         time = length*(i - 1)/count
         angles(i, 1) = path%angle(time)
         angles(i, 2) = path%harmonic_angle(time)
         if (present(other)) angles(i, 2) = other%angle(time)
      end do
      place = open_output(file)
      call place%add(made(script_of(angles(:count, :), min(pi, path%amplitude()), beside > 0.0_wp), &
         arguments_of(form, count/length), folder_of(file)))
      call place%close()
   end subroutine film


   !> What ffmpeg makes of the frames that gnuplot draws by a script
   function made(script, arguments, folder) result(bytes)
      character(len=*), intent(in) :: script
      !> What ffmpeg is told
      character(len=*), intent(in) :: arguments
      !> Where temporaries lie if nowhere else
      character(len=*), intent(in) :: folder
      character(len=:), allocatable :: bytes
      type(c_ptr) :: streams(7)
      integer :: i

      do i = 1, size(streams)
         streams(i) = nameless_file(folder)
         if (.not. c_associated(streams(i))) call fail('a temporary file')
      end do
      if (.not. append_text(streams(1), script)) call fail('a temporary file')
      ! Asked first, so that no frames are drawn for nothing
      call run('ffmpeg', '-version', 'apt-get install ffmpeg', [streams(1), streams(6), streams(7)])
      call run('gnuplot', '-d', 'apt-get install gnuplot-nox', streams(:3))
      call run('ffmpeg', arguments, '', [streams(2), streams(4), streams(5)])
      bytes = text_of(streams(4))
      if (len(bytes) == 0) call give_up('ffmpeg', text_of(streams(5)))
   end function made


   !> How many periods bring the motion beside it back to a hundredth of a swing, or as nearly as fits
   pure function whole_periods(period, beside) result(best)
      real(wp), intent(in) :: period
      real(wp), intent(in) :: beside
      integer :: best
      real(wp) :: least, miss
      integer :: n

      best = 1
      if (.not. beside > 0.0_wp) return
      least = 1.0_wp
      do n = 1, int(most_frames/(frames_a_second*period))
         miss = abs(n*period/beside - anint(n*period/beside))
         if (miss < least) best = n
         least = min(least, miss)
         if (least < 0.01_wp) exit
      end do
   end function whole_periods


   !> One frame a row of angles; gnuplot writes them one behind the other.
   function script_of(angles, reach, two) result(text)
      real(wp), intent(in) :: angles(:,:)
      real(wp), intent(in) :: reach
      !> Whether both columns are drawn
      logical, intent(in) :: two
      character(len=:), allocatable :: text
      character(len=:), allocatable :: arc, bobs
      integer :: i, row

      arc = fixed(-90 - reach*180/pi, 3) // ':' // fixed(-90 + reach*180/pi, 3)
      bobs = "'' using 1:2 every ::i::i with points pt 7 ps 4 lc rgb '#0072b2'"
      if (two) bobs = "'' using (0):(0):3:4 every ::i::i with vectors nohead lw 1.5 dt 2 " // &
         "lc rgb '#b84a00', '' using 3:4 every ::i::i with points pt 5 ps 3 lc rgb '#b84a00', " // bobs
      text = "set terminal pngcairo size 400,400 background '#ffffff'" // nl // &
         'unset border' // nl // 'unset tics' // nl // 'unset key' // nl // &
         'set margins 0,0,0,0' // nl // 'set xrange [-1.2:1.2]' // nl // 'set yrange [-1.2:1.2]' // nl // &
         'set object 1 circle at 0,0 size 1 arc [' // arc // "] nowedge fs empty " // &
         "border lc rgb '#c4cad2'" // nl // &
         '$data << END' // nl
      do i = 1, size(angles, 1)
         do row = 1, 2
            text = text // fixed(sin(angles(i, row)), 6) // ' ' // fixed(-cos(angles(i, row)), 6) // ' '
         end do
         text = text // nl
      end do
      text = text // 'END' // nl // 'do for [i=0:' // whole_text(size(angles, 1) - 1) // '] {' // nl // &
         "plot $data using (0):(0):1:2 every ::i::i with vectors nohead lw 2 lc rgb '#1b1f24', " // &
         bobs // nl // &
         '}' // nl
   end function script_of


   !> What ffmpeg is told: PNG pictures come in, a film goes out. A GIF has a palette of its own; an MP4 is
   !> one that can be written without going back.
   pure function arguments_of(form, rate) result(text)
      character(len=*), intent(in) :: form
      !> Frames a second
      real(wp), intent(in) :: rate
      character(len=:), allocatable :: text

      text = '-nostdin -v error -f image2pipe -c:v png -framerate ' // fixed(rate, 6) // ' -i pipe:0 '
      if (form == 'gif') then
         text = text // '-vf split[a][b];[a]palettegen[p];[b][p]paletteuse -loop 0 -f gif pipe:1'
      else
         text = text // '-pix_fmt yuv420p -movflags frag_keyframe+empty_moov -f mp4 pipe:1'
      end if
   end function arguments_of


   !> Run a program to its end; does not return where it is not there or fails. What it has written is not
   !> read here: C's library would not go back to the start of it for the next program.
   subroutine run(program, arguments, remedy, streams)
      character(len=*), intent(in) :: program
      character(len=*), intent(in) :: arguments
      !> How to get it
      character(len=*), intent(in) :: remedy
      !> Its input, output and errors
      type(c_ptr), intent(in) :: streams(3)
      integer :: code, i

      call to_start(streams(1))
      call run_filter(program, arguments, [(descriptor_of(streams(i)), i=1, 3)], code)
      if (code == not_found) then
         call complain('furiko animate: no ' // program // ' here (' // remedy // '), so no film is written')
         call quit(3)
      else if (code /= 0) then
         call give_up(program, text_of(streams(3)))
      end if
   end subroutine run


   !> Say what a program has said, its first line; does not return.
   subroutine give_up(program, said)
      character(len=*), intent(in) :: program
      character(len=*), intent(in) :: said
      character(len=:), allocatable :: line

      line = said(:index(said // nl, nl) - 1)
      if (line == '') line = 'it has said nothing; is there room in $TMPDIR or /tmp?'
      call complain('furiko animate: ' // program // ' made no film: ' // line)
      call quit()
   end subroutine give_up

end module furiko_cli_movie
