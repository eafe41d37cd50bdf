! SPDX-License-Identifier: MIT

!> The command line: `ensemble SUBJECT FILE --option value ...`
module furiko_ensemble_options
   use, intrinsic :: iso_fortran_env, only : int64, wp => real64
   use furiko_ensemble_sweep, only : constants, subjects, sweep
   implicit none
   private
   public :: request, read_request, usage


   !> What is asked for
   type :: request
      !> A subject, status, table, join or help
      character(len=:), allocatable :: command
      !> FILE, and what else has no name
      character(len=:), allocatable :: path
      type(sweep) :: asked
      integer :: part = 1
      integer :: parts = 1
      logical :: quiet = .false.
      !> Why it cannot be understood; empty if it can
      character(len=:), allocatable :: trouble
   end type request


   !> An option with its default value; an empty one has to be given.
   type :: option
      character(len=12) :: name
      character(len=12) :: value
      character(len=72) :: about
      !> The subjects that have it; all of them if empty
      character(len=37) :: only = ''
   end type option

   character(len=*), parameter :: varied = 'bifurcation lyapunov winding', started = 'section ' // varied
   type(option), parameter :: options(*) = [ &
      option('--damping', '0.5', 'linear damping; 1/q'), &
      option('--quadratic', '0', 'quadratic damping'), &
      option('--torque', '0', 'a constant torque'), &
      option('--drive', '1.2', 'amplitude of the drive'), &
      option('--frequency', '2/3', 'of the drive'), &
      option('--phase', '0', 'of the drive at the time 0, degrees'), &
      option('--transient', '500', 'periods of the drive that are left out first'), &
      option('--periods', '100', 'periods that are stored (sections), counted, or waited (basins)'), &
      option('--method', 'order8', 'order8, or rk4'), &
      option('--steps', '96', 'steps a period; 96 for 12 digits by order8, 24 for a picture'), &
      option('--chunk', '4096', 'members that are computed, written and marked together'), &
      option('--part', '1/1', 'p/P: only the p-th of P parts of the chunks, without MPI'), &
      option('--points', '', 'members: how many values, or starts of a section', started), &
      option('--angle', '0', 'at the time 0, degrees; the first one of a section''s starts', started), &
      option('--rate', '0', 'at the time 0', started), &
      option('--vary', 'drive', 'damping, quadratic, torque, drive, frequency or phase (rad)', varied), &
      option('--from', '', 'its first value', varied), &
      option('--to', '', 'its last value', varied), &
      option('--grid', '64', 'N starts of each angle and rate, or NxM of N angles and M rates', 'basins'), &
      option('--angles', '-180,180', 'LOW,HIGH: edges of the angles of the starts, degrees', 'basins'), &
      option('--rates', '-3,3', 'LOW,HIGH: edges of the rates', 'basins'), &
      option('--cycle', '8', 'the longest cycle that is looked for', 'winding basins')]
   integer, parameter :: longest_word = 4096


contains


   !> The words of the command line
   subroutine read_request(asked)
      type(request), intent(out) :: asked
      character(len=longest_word) :: value, word
      character(len=longest_word) :: values(size(options))
      integer :: i, which

      asked%trouble = ''
      asked%command = 'help'
      asked%path = ''
      values = options%value
      call get_command_argument(1, word)
      if (command_argument_count() > 0) asked%command = trim(word)
      if (any(asked%command == [character(len=6) :: '--help', '-h'])) asked%command = 'help'
      if (any(asked%command == [character(len=6) :: 'help', 'join'])) return
      i = 1
      do while (i < command_argument_count())
         i = i + 1
         call get_command_argument(i, word)
         if (word == '--quiet') then
            asked%quiet = .true.
         else if (word(1:2) == '--') then
            which = findloc(options%name == word, .true., 1)
            i = i + 1
            value = ''
            call get_command_argument(i, value)
            if (which == 0) asked%trouble = trim(word) // ': no such option; see ensemble help'
            if (value == '') asked%trouble = trim(word) // ': it wants a value'
            if (which > 0) then
               values(which) = value
               if (.not. has(asked%command, options(which))) asked%trouble = trim(word) // ': ' // &
                  asked%command // ' has no such option'
            end if
         else if (asked%path == '') then
            asked%path = trim(word)
         else
            asked%trouble = trim(word) // ': one file is enough'
         end if
      end do
      if (asked%path == '' .and. asked%trouble == '') asked%trouble = 'which file?'
      if (asked%trouble /= '' .or. any(asked%command == [character(len=6) :: 'status', &
         'table'])) return
      if (any(subjects == asked%command)) then
         call understand(values, asked)
      else
         asked%trouble = asked%command // ': no such command; see ensemble help'
      end if
   end subroutine read_request


   !> The values of options as a sweep
   subroutine understand(values, asked)
      character(len=*), intent(in) :: values(:)
      type(request), intent(inout) :: asked
      real(wp) :: parts(2)
      integer :: i

      associate (s => asked%asked)
         s%subject = asked%command
         do i = 1, size(constants)
            s%constant(i) = number_of('--' // trim(constants(i)))
         end do
         s%method = trim(text_of('--method'))
         if (s%method /= 'order8' .and. s%method /= 'rk4') call reject('--method', 'order8 or rk4')
         s%steps = int(whole_of('--steps', 1_int64, 10_int64**6))
         s%transient = int(whole_of('--transient', 0_int64, 10_int64**9))
         s%periods = int(whole_of('--periods', 1_int64, 10_int64**9))
         s%cycle = int(whole_of('--cycle', 1_int64, 1024_int64))
         s%chunk = int(whole_of('--chunk', 1_int64, 10_int64**7))
         if (s%subject == 'basins') then
            call take_plane()
         else
            s%angle = number_of('--angle')
            s%rate = number_of('--rate')
            s%points = whole_of('--points', 1_int64, 10_int64**12)
         end if
         if (index(varied, s%subject) > 0) then
            s%vary = findloc(constants == text_of('--vary'), .true., 1)
            if (s%vary == 0) call reject('--vary', 'damping, quadratic, torque, drive, frequency or phase')
            s%from = number_of('--from')
            s%to = number_of('--to')
         end if
         select case (s%subject)
         case ('lyapunov')
            if (s%periods < 16) call reject('--periods', '16 or more, for the error')
         case ('section', 'bifurcation')
            if (int(s%periods, int64)*s%chunk > 10_int64**8) call reject('--chunk', &
               'periods times chunk up to 100000000, which is 2.4 GB')
         case default
            continue
         end select
      end associate
      parts = fraction_of(text_of('--part'))
      asked%part = int(parts(1))
      asked%parts = int(parts(2))
      if (.not. (parts(1) >= 1 .and. parts(1) <= parts(2) .and. parts(2) <= 1.0e6_wp) .or. &
         any(abs(parts - aint(parts)) > 0)) call reject('--part', 'p/P, 1 <= p <= P <= 1000000')


   contains


      subroutine take_plane()
         character(len=len(values)) :: text
         real(wp) :: both(2)

         associate (s => asked%asked)
            text = text_of('--grid')
            both = pair_of(trim(text) // repeat('x' // trim(text), merge(0, 1, scan(text, 'x') > 0)), 'x')
            if (any(both < 1 .or. both > 1.0e6_wp .or. abs(both - aint(both)) > 0)) then
               call reject('--grid', 'N or NxM, whole numbers from 1 to 1000000')
               return
            end if
            s%grid = int(both, int64)
            s%points = product(s%grid)
            s%angles = pair_of(text_of('--angles'), ',')
            if (.not. (s%angles(1) < s%angles(2) .and. maxval(abs(s%angles)) <= 360)) then
               call reject('--angles', 'LOW,HIGH, LOW < HIGH, -360 to 360 degrees')
            end if
            s%rates = pair_of(text_of('--rates'), ',')
            if (.not. (s%rates(1) < s%rates(2) .and. maxval(abs(s%rates)) <= 2.0_wp**20)) then
               call reject('--rates', 'LOW,HIGH, LOW < HIGH, up to 2^20')
            end if
         end associate
      end subroutine take_plane


      pure function text_of(name) result(text)
         character(len=*), intent(in) :: name
         character(len=len(values)) :: text

         text = values(findloc(options%name == name, .true., 1))
      end function text_of


      subroutine reject(name, wanted)
         character(len=*), intent(in) :: name
         character(len=*), intent(in) :: wanted

         if (asked%trouble /= '') return
         asked%trouble = name // ' ' // trim(text_of(name)) // ': it wants ' // wanted
      end subroutine reject


      function number_of(name) result(number)
         character(len=*), intent(in) :: name
         real(wp) :: number
         real(wp) :: both(2)

         both = fraction_of(text_of(name))
         number = both(1)/both(2)
         if (.not. abs(number) <= 2.0_wp**20) call reject(name, 'a number up to 2^20, as 0.5 or 2/3')
      end function number_of


      function whole_of(name, least, most) result(whole)
         character(len=*), intent(in) :: name
         integer(int64), intent(in) :: least
         integer(int64), intent(in) :: most
         integer(int64) :: whole
         character(len=32) :: limits
         character(len=len(values)) :: text
         integer :: failed

         text = text_of(name)
         whole = least - 1
         failed = verify(trim(text), '0123456789')
         if (failed == 0) read(text, '(i20)', iostat=failed) whole
         if (failed /= 0) whole = least - 1
         write(limits, '(i0, a, i0)') least, ' to ', most
         if (whole < least .or. whole > most) call reject(name, 'a whole number, ' // trim(limits))
         whole = max(min(whole, most), least)
      end function whole_of
   end subroutine understand


   !> Whether a command has an option
   pure function has(command, one)
      character(len=*), intent(in) :: command
      type(option), intent(in) :: one
      logical :: has

      has = one%only == '' .or. all(subjects /= command) .or. index(one%only, command) > 0
   end function has


   !> Two numbers with a mark between them; zeros where they are none
   function pair_of(text, mark) result(both)
      character(len=*), intent(in) :: text
      character(len=1), intent(in) :: mark
      real(wp) :: both(2)
      real(wp) :: first(2), second(2)
      integer :: at

      at = index(text // mark, mark)
      first = fraction_of(text(:min(at - 1, len(text))))
      second = fraction_of(text(min(at + 1, len(text) + 1):))
      both = [first(1)/first(2), second(1)/second(2)]
      if (.not. all(abs(both) <= huge(both))) both = 0.0_wp
   end function pair_of


   !> Both numbers of a fraction, as 2/3; the second is 1 where there is no bar, and 0 where they are none
   function fraction_of(text) result(both)
      character(len=*), intent(in) :: text
      real(wp) :: both(2)
      integer :: bar, failed

      both = [0.0_wp, 1.0_wp]
      bar = index(text // '/', '/')
      associate (first => text(:min(bar - 1, len_trim(text))), second => text(bar + 1:len_trim(text)))
         read(first, *, iostat=failed) both(1)
         if (failed == 0 .and. bar <= len_trim(text)) read(second, *, iostat=failed) both(2)
      end associate
      if (failed /= 0 .or. verify(trim(text), '0123456789.+-eE/') > 0) both = 0.0_wp
   end function fraction_of


   !> Help
   subroutine usage(unit)
      integer, intent(in) :: unit
      type(option) :: one
      character(len=:), allocatable :: line
      integer :: i

      write(unit, '(a)') 'ensemble SUBJECT FILE [OPTION VALUE ...] [--quiet]', &
         'ensemble status FILE', 'ensemble table FILE', 'ensemble join FILE PART ...', '', &
         'Many driven, damped pendulums into one HDF5 file. SUBJECT is section (of starts all around),', &
         'bifurcation (sections while a constant goes from one value to another), lyapunov (both', &
         'exponents), winding (turns a period) or basins (which attractor each start of a plane comes', &
         'to, and when). The same command again goes on where it was stopped. status tells how far a', &
         'file has come, also while it is written; table writes what it has as CSV, with the columns of', &
         'furiko driven; join puts files of parts together. doc/ensemble.md says more.', ''
      do i = 1, size(options)
         one = options(i)
         if (one%only /= options(max(i - 1, 1))%only) write(unit, '(a)') 'Of ' // trim(one%only) // ':'
         line = '   ' // one%name // ' ' // trim(one%about)
         if (one%value /= '') line = line // ' [' // trim(one%value) // ']'
         write(unit, '(a)') line
      end do
   end subroutine usage
end module furiko_ensemble_options
