! SPDX-License-Identifier: MIT

!> `furiko animate`: the pendulum in motion, as one page for any browser, or as a film that goes round.
module furiko_cli_animate
   use, intrinsic :: iso_fortran_env, only : wp => real64
   use furiko, only : furiko_version, motion, pendulum
   use furiko_cli_files, only : open_output, output
   use furiko_cli_movie, only : film
   use furiko_cli_number, only : shortest
   use furiko_cli_options, only : command, command_line, demand, option, word
   use furiko_cli_pendulum, only : amplitude_of, gravity_of, gravity_option, length_of, length_option, &
      motion_of, pendulum_of, start_options
   use furiko_cli_quantity, only : angle_of, in_degrees, no_unit, number_of, seconds
   use furiko_word_arithmetic_dp, only : words
   implicit none
   private
   public :: animate_usage


   !> What the command can write, by the options that name it
   character(len=8), parameter :: kinds(*) = [character(len=8) :: '--output', '--gif', '--mp4']


contains


   function animate_usage() result(usage)
      type(command) :: usage

      usage = command('animate', 'the pendulum in motion, as a page for the browser', '-o FILE', 0, &
         'The pendulum in motion: one page that any browser opens from disk, without a network. The bob ' // &
         'is dragged and thrown; beside the exact motion stands the small-angle one, another swing, or ' // &
         'one with damping and drive; with trace, phase portrait, energy, and the period against the ' // &
         'amplitude. The options say how it begins; without a start it is let go at 90 degrees.', &
         'With --gif or --mp4 it writes a film of whole periods instead, which goes round without a ' // &
         'jump: drawn by gnuplot, put together by ffmpeg. A motion beside it is shown for as many ' // &
         'periods as bring it back, nearly. Without one of the two programs the code is 3. The page ' // &
         'keeps its state in its address, under the names of these options.', &
         'furiko animate -o pendulum.html --release 30 --compare 90', options=[ &
         option('--output', 'FILE', '', 'the page to write, - for standard output; a file of that name ' // &
            'is replaced once the new one is whole', 'o'), &
         option('--gif', 'FILE', '', 'a film as GIF, in place of the page'), &
         option('--mp4', 'FILE', '', 'a film as MP4, in place of the page'), &
         start_options, &
         option('--compare', 'WITH', '', 'beside it: small (the small-angle motion), driven (by ' // &
            'Runge-Kutta), or the amplitude of another swing'), &
         option('--linear', 'C', '0.2', 'with --compare driven: friction C times the rate, 1/s'), &
         option('--drive', 'F', '0', 'with --compare driven: drive F cos(W t), rad/s^2'), &
         option('--drive-frequency', 'W', '2', 'of the drive, rad/s'), &
         option('--at', 'T', '', 'the page stands still at this time'), &
         option('--language', 'en|ja', '', 'of the page (default: the browser''s)'), &
         length_option, gravity_option], run=animate_command)
   end function animate_usage


   subroutine animate_command(line)
      type(command_line), intent(in) :: line
      type(word) :: file
      character(len=:), allocatable :: begin
      integer :: i, kind

      kind = 0
      do i = 1, size(kinds)
         if (.not. line%given(trim(kinds(i)))) cycle
         if (kind > 0) call line%reject('one of -o, --gif and --mp4 at a time')
         kind = i
      end do
      if (kind > 0) file = line%value(trim(kinds(kind)))
      if (kind == 0) then
         call line%reject('name the page to write, as in -o pendulum.html')
      else if (file%text == '') then
         call line%reject('name the page to write, as in -o pendulum.html')
      end if
      begin = state_of(line)
      if (kind == 1) then
         call write_page(file%text, begin)
      else
         call write_film(line, file%text, kinds(kind)(3:5))
      end if
   end subroutine animate_command


   subroutine write_page(file, state)
      character(len=*), intent(in) :: file
      !> As the page has it in its address
      character(len=*), intent(in) :: state
      type(output) :: page

      page = open_output(file)
      call put_page(page, '{"version": "' // furiko_version // '", "state": "' // state // '"}')
      call page%close()
   end subroutine write_page


   subroutine write_film(line, file, form)
      type(command_line), intent(in) :: line
      character(len=*), intent(in) :: file
      !> gif or mp4
      character(len=*), intent(in) :: form
      type(motion) :: beside
      type(pendulum) :: body
      type(word) :: compare
      type(words) :: other

      if (line%given('--at') .or. line%given('--language')) then
         call line%reject('--at and --language are the page''s')
      end if
      body = pendulum_of(line)
      compare = line%value('--compare')
      select case (compare%text)
      case ('driven')
         call line%reject('a driven motion does not come back, so there is no film of it')
      case ('', 'small')
         call film(line, file, form, start_of(line, body), &
            merge(body%small_period(), 0.0_wp, compare%text /= ''))
      case default
         other = amplitude_of(compare)
         if (line%given('--amplitude')) then
            beside = body%swinging(other%hi, other%lo)
         else
            beside = body%released(other%hi, other%lo)
         end if
         call film(line, file, form, start_of(line, body), beside%period(), beside)
      end select
   end subroutine write_film


   !> The motion of the options, let go at 90 degrees without any
   function start_of(line, body) result(path)
      type(command_line), intent(in) :: line
      type(pendulum), intent(in) :: body
      type(motion) :: path

      if (has_start(line)) then
         path = motion_of(line, body)
      else
         path = body%released(0.5_wp*acos(-1.0_wp))
      end if
   end function start_of


   function has_start(line) result(given)
      type(command_line), intent(in) :: line
      logical :: given
      integer :: i

      given = any([(line%given(trim(start_options(i)%name)), i=1, size(start_options))])
   end function has_start


   !> The options as the page has them in its address: #release=30&compare=90. All are looked at here.
   function state_of(line) result(text)
      type(command_line), intent(in) :: line
      character(len=:), allocatable :: text
      type(motion) :: path
      type(word) :: language

      if (has_start(line)) path = motion_of(line, pendulum_of(line))
      text = '#'
      if (line%given('--release')) call add(text, 'release', degrees_of(line%value('--release')))
      if (line%given('--amplitude')) call add(text, 'amplitude', degrees_of(line%value('--amplitude')))
      if (line%given('--angle')) then
         call add(text, 'angle', degrees_of(line%value('--angle')))
         call add(text, 'rate', number_within(line, '--rate', -100.0_wp, 100.0_wp, '-100 to 100 rad/s'))
      end if
      call add_company(line, text)
      if (line%given('--length')) call add(text, 'length', in_range(length_of(line), line%value('--length'), &
         0.1_wp, 100.0_wp, '0.1 to 100 m'))
      if (line%given('--gravity')) call add(text, 'gravity', in_range(gravity_of(line), &
         line%value('--gravity'), 0.1_wp, 30.0_wp, '0.1 to 30 m/s^2'))
      if (line%given('--at')) call add(text, 'time', in_range(number_of(line%value('--at'), seconds), &
         line%value('--at'), 0.0_wp, 3600.0_wp, '0 to 3600 s'))
      language = line%value('--language')
      if (line%given('--language')) call add(text, 'language', language%text)
   end function state_of


   !> What stands beside the exact pendulum
   subroutine add_company(line, text)
      type(command_line), intent(in) :: line
      character(len=:), allocatable, intent(inout) :: text
      character(len=17), parameter :: forces(3) = [character(len=17) :: '--linear', '--drive', &
         '--drive-frequency']
      real(wp), parameter :: most(3) = [10.0_wp, 50.0_wp, 20.0_wp]
      type(word) :: compare
      type(words) :: other
      integer :: i

      compare = line%value('--compare')
      select case (compare%text)
      case ('')
         if (line%given('--compare')) call line%reject('--compare is empty')
      case ('small', 'driven')
         call add(text, 'compare', compare%text)
      case default
         other = in_degrees(amplitude_of(compare))
         call add(text, 'compare', shortest(other%hi))
      end select
      do i = 1, size(forces)
         if (.not. line%given(trim(forces(i)))) cycle
         if (compare%text /= 'driven') call line%reject(trim(forces(i)) // ' goes with --compare driven')
         call add(text, trim(forces(i)(3:)), number_within(line, trim(forces(i)), 0.0_wp, most(i), &
            '0 to ' // shortest(most(i))))
      end do
   end subroutine add_company


   !> Add a word to a state.
   pure subroutine add(text, key, value)
      character(len=:), allocatable, intent(inout) :: text
      character(len=*), intent(in) :: key
      character(len=*), intent(in) :: value

      if (text /= '#') text = text // '&'
      text = text // key // '=' // value
   end subroutine add


   !> An angle in degrees, within the page's range
   function degrees_of(given) result(text)
      type(word), intent(in) :: given
      character(len=:), allocatable :: text

      text = in_range(in_degrees(angle_of(given)), given, -180.0_wp, 180.0_wp, '-180 to 180 degrees')
   end function degrees_of


   function number_within(line, name, least, most, range) result(text)
      type(command_line), intent(in) :: line
      character(len=*), intent(in) :: name
      real(wp), intent(in) :: least
      real(wp), intent(in) :: most
      character(len=*), intent(in) :: range
      character(len=:), allocatable :: text

      text = in_range(number_of(line%value(name), no_unit), line%value(name), least, most, range)
   end function number_within


   !> A number as text, refused outside what the page offers
   function in_range(number, given, least, most, range) result(text)
      type(words), intent(in) :: number
      type(word), intent(in) :: given
      real(wp), intent(in) :: least
      real(wp), intent(in) :: most
      character(len=*), intent(in) :: range
      character(len=:), allocatable :: text

      call demand(number%hi >= least .and. number%hi <= most, given, range)
      text = shortest(number%hi)
   end function in_range


   include 'furiko_cli_page.inc'

end module furiko_cli_animate
! rooms: 4069414773
