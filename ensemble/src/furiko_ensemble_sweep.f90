! SPDX-License-Identifier: MIT

!> What is asked for: a family of driven pendulums in chunks of members, and what each member yields. What
!> comes out of a chunk depends on nothing but the sweep and the chunk's number.
module furiko_ensemble_sweep
   use, intrinsic :: iso_fortran_env, only : int64, wp => real64
   use furiko, only : driven_amplitude, driven_damping, driven_frequency, driven_order8, driven_pendulum, &
      driven_phase, driven_quadratic, driven_rk4, driven_scheme, driven_set, driven_state, driven_torque
   implicit none
   private
   public :: sweep, quantity, chunks, chunks_of, constants, first_member, in_range, member_extents, &
      members_of, quantities, scales, scheme_of, subjects, take_members, tolerance


   character(len=*), parameter :: subjects(5) = [character(len=11) :: 'section', 'bifurcation', 'lyapunov', &
      'winding', 'basins']
   !> Constants by name, in the order of their numbers in the library, with their units
   character(len=*), parameter :: constants(6) = [character(len=9) :: 'damping', 'quadratic', 'torque', &
      'drive', 'frequency', 'phase']
   integer, parameter :: numbers(6) = [driven_damping, driven_quadratic, driven_torque, driven_amplitude, &
      driven_frequency, driven_phase]
   character(len=*), parameter :: frequency = 'sqrt(gravity/length)'
   character(len=*), parameter :: units(6) = [character(len=20) :: frequency, '1', '1', '1', frequency, 'rad']
   real(wp), parameter :: pi = acos(-1.0_wp), degree = pi/180
   !> How near a start of a basin has to come to a point of an attractor, in angle and rate together
   real(wp), parameter :: tolerance = 1.0e-3_wp


   !> All that decides which numbers come out
   type :: sweep
      !> One of the subjects
      character(len=:), allocatable :: subject
      !> order8 or rk4
      character(len=:), allocatable :: method
      !> Steps to a period of the drive
      integer :: steps = 0
      !> Constants of all members, by number; the phase in degrees
      real(wp) :: constant(6) = 0.0_wp
      !> The start, degrees and rate; of sections the first of them
      real(wp) :: angle = 0.0_wp
      real(wp) :: rate = 0.0_wp
      !> The constant that is varied, from its first to its last value; a phase in radians
      integer :: vary = 1
      real(wp) :: from = 0.0_wp
      real(wp) :: to = 0.0_wp
      !> Members
      integer(int64) :: points = 0
      !> Of basins: how many angles and rates the starts have, and the edges of their plane, in degrees
      integer(int64) :: grid(2) = 1
      real(wp) :: angles(2) = 0.0_wp
      real(wp) :: rates(2) = 0.0_wp
      !> Periods that are left out, and that are stored, counted or waited
      integer :: transient = 0
      integer :: periods = 1
      !> The longest cycle that is looked for
      integer :: cycle = 1
      !> Members that are computed and written together
      integer :: chunk = 1
      !> Points of the attractors and to which attractor each belongs, once they are known
      type(driven_state), allocatable :: attractor(:)
      integer, allocatable :: label(:)
   end type sweep


   !> One kind of result: a column of `rows` numbers for each member; whole numbers in 32 bits, since Paraview
   !> reads no others
   type :: quantity
      character(len=:), allocatable :: name
      character(len=:), allocatable :: units
      character(len=:), allocatable :: about
      integer :: rows = 1
      !> Whether there is a number for each period, and not only one for each member
      logical :: each_period = .false.
      !> The numbers of a chunk, (rows, members); the other one is not allocated
      real(wp), allocatable :: reals(:, :)
      integer, allocatable :: wholes(:, :)
   end type quantity


contains


   !> How many chunks there are
   pure function chunks(asked) result(number)
      type(sweep), intent(in) :: asked
      integer(int64) :: number

      number = (asked%points + asked%chunk - 1)/asked%chunk
   end function chunks


   !> How many of the chunks part 1, 2, ... of so many parts has: those that are part - 1 modulo parts. No
   !> part asks another which chunk is next.
   pure function chunks_of(asked, part, parts) result(number)
      type(sweep), intent(in) :: asked
      integer, intent(in) :: part
      integer, intent(in) :: parts
      integer(int64) :: number

      number = (chunks(asked) - part + parts)/parts
   end function chunks_of


   !> The first member of a chunk, both counted from 0
   pure function first_member(asked, chunk) result(first)
      type(sweep), intent(in) :: asked
      integer(int64), intent(in) :: chunk
      integer(int64) :: first

      first = chunk*asked%chunk
   end function first_member


   !> How many members a chunk has: the last one may have fewer
   pure function members_of(asked, chunk) result(number)
      type(sweep), intent(in) :: asked
      integer(int64), intent(in) :: chunk
      integer :: number

      number = int(min(int(asked%chunk, int64), asked%points - first_member(asked, chunk)))
   end function members_of


   !> The directions in which members lie, the quick one first: one, or angles and rates of a plane
   pure function member_extents(asked) result(extents)
      type(sweep), intent(in) :: asked
      integer(int64), allocatable :: extents(:)

      extents = [asked%points]
      if (asked%subject == 'basins') extents = asked%grid
   end function member_extents


   pure function scheme_of(asked) result(scheme)
      type(sweep), intent(in) :: asked
      type(driven_scheme) :: scheme

      if (asked%method == 'rk4') then
         scheme = driven_rk4(asked%steps)
      else
         scheme = driven_order8(asked%steps)
      end if
   end function scheme_of


   !> What each member yields, with room for the largest chunk. Where members lie in one direction, what
   !> tells them apart comes first.
   function quantities(asked) result(all)
      type(sweep), intent(in) :: asked
      type(quantity), allocatable :: all(:)
      type(quantity) :: value

      value = reals(asked, trim(constants(asked%vary)), trim(units(asked%vary)), &
         'the constant that is varied')
      select case (asked%subject)
      case ('section')
         all = [reals(asked, 'start_angle', 'rad', 'where the member starts'), sections(asked), &
            wholes(asked, 'turns', 'whole turns since the start, at the end of a period; up to 2^31', .true.)]
      case ('bifurcation')
         all = [value, sections(asked), &
            wholes(asked, 'turns', 'whole turns since the start, after the last period; up to 2^31')]
      case ('lyapunov')
         all = [value, reals(asked, 'exponent_1', frequency, 'larger Lyapunov exponent'), &
            reals(asked, 'exponent_2', frequency, 'smaller Lyapunov exponent'), &
            reals(asked, 'error_1', frequency, 'standard error of exponent_1')]
      case ('winding')
         all = [value, reals(asked, 'winding', '1', 'turns to a period of the drive'), &
            wholes(asked, 'turns', 'where it is locked: turns of a cycle'), &
            wholes(asked, 'cycle', 'where it is locked: periods of a cycle; 0 where it is not')]
      case default
         all = [wholes(asked, 'attractor', 'label of the attractor to which the start comes; 0: to none'), &
            wholes(asked, 'arrival', 'period at whose end it has come, 0: it starts there; -1: never')]
      end select
      all = [all, wholes(asked, 'status', '0: ran, 1: left the range of 2^20')]
   end function quantities


   function sections(asked) result(both)
      type(sweep), intent(in) :: asked
      type(quantity) :: both(2)

      both = [reals(asked, 'angle', 'rad', 'from the bottom, at the end of a period', .true.), &
         reals(asked, 'rate', frequency, 'of the angle, at the end of a period', .true.)]
   end function sections


   !> What is known before anything is computed: numbers of the periods; angles and rates of a plane's cells
   function scales(asked) result(all)
      type(sweep), intent(in) :: asked
      type(quantity), allocatable :: all(:)
      type(quantity) :: one
      integer(int64) :: i
      integer :: j

      allocate(all(0))
      if (asked%subject == 'basins') then
         one = quantity('rate', frequency, 'at the start, middles of cells', int(asked%grid(2)))
         one%reals = reshape([(cell_rate(asked, i), i=0, asked%grid(2) - 1)], [one%rows, 1])
         all = [one, quantity('angle', 'rad', 'at the start, middles of cells', int(asked%grid(1)))]
         all(2)%reals = reshape([(cell_angle(asked, i), i=0, asked%grid(1) - 1)], [all(2)%rows, 1])
      else if (any(asked%subject == [character(len=11) :: 'section', 'bifurcation'])) then
         one = quantity('period', '1', 'periods of the drive since the start', asked%periods)
         one%wholes = reshape([(asked%transient + j, j=1, asked%periods)], [one%rows, 1])
         all = [one]
      end if
   end function scales


   pure function reals(asked, name, units, about, each_period) result(one)
      type(sweep), intent(in) :: asked
      character(len=*), intent(in) :: name
      character(len=*), intent(in) :: units
      character(len=*), intent(in) :: about
      logical, intent(in), optional :: each_period
      type(quantity) :: one

      one = quantity(name, units, about)
      if (present(each_period)) one%each_period = each_period
      if (one%each_period) one%rows = asked%periods
      allocate(one%reals(one%rows, asked%chunk), source=0.0_wp)
   end function reals


   pure function wholes(asked, name, about, each_period) result(one)
      type(sweep), intent(in) :: asked
      character(len=*), intent(in) :: name
      character(len=*), intent(in) :: about
      logical, intent(in), optional :: each_period
      type(quantity) :: one

      one = quantity(name, '1', about)
      if (present(each_period)) one%each_period = each_period
      if (one%each_period) one%rows = asked%periods
      allocate(one%wholes(one%rows, asked%chunk), source=0)
   end function wholes


   !> Turns as the file holds them, in 32 bits, since Paraview reads no more: 2^31 stands for more than that.
   elemental function in_range(turns) result(number)
      integer(int64), intent(in) :: turns
      integer :: number

      number = int(max(min(turns, int(huge(number), int64)), -int(huge(number), int64)))
   end function in_range


   !> Members of a chunk at their starts, and what tells them apart in one direction
   pure subroutine take_members(asked, chunk, values, pendulum, state)
      type(sweep), intent(in) :: asked
      integer(int64), intent(in) :: chunk
      real(wp), allocatable, intent(out) :: values(:)
      type(driven_pendulum), allocatable, intent(out) :: pendulum(:)
      type(driven_state), allocatable, intent(out) :: state(:)
      integer(int64) :: first
      integer :: i, n

      n = members_of(asked, chunk)
      first = first_member(asked, chunk)
      allocate(pendulum(n), state(n))
      do i = 1, size(constants)
         call driven_set(pendulum, numbers(i), asked%constant(i)*merge(degree, 1.0_wp, &
            numbers(i) == driven_phase))
      end do
      state%angle = asked%angle*degree
      state%rate = asked%rate
      select case (asked%subject)
      case ('section')
         state%angle = state%angle + 2*pi*([(real(first + i, wp), i=0, n - 1)]/real(asked%points, wp))
         where (state%angle > pi) state%angle = state%angle - 2*pi
         values = state%angle
      case ('basins')
         state%angle = [(cell_angle(asked, modulo(first + i, asked%grid(1))), i=0, n - 1)]
         state%rate = [(cell_rate(asked, (first + i)/asked%grid(1)), i=0, n - 1)]
         values = state%angle
      case default
         values = [(asked%from + (asked%to - asked%from)* &
            (real(first + i, wp)/real(max(asked%points - 1, 1_int64), wp)), i=0, n - 1)]
         call driven_set(pendulum, numbers(asked%vary), values)
      end select
   end subroutine take_members


   !> The middle of a plane's column 0, 1, ...; written so that the whole circle has no rounding of its edges
   pure function cell_angle(asked, column) result(angle)
      type(sweep), intent(in) :: asked
      integer(int64), intent(in) :: column
      real(wp) :: angle

      associate (low => asked%angles(1), high => asked%angles(2))
         angle = (low + high)/360*pi + (high - low)/360*pi*((2*column + 1)/real(asked%grid(1), wp) - 1)
      end associate
   end function cell_angle


   !> The middle of a plane's row 0, 1, ...
   pure function cell_rate(asked, row) result(rate)
      type(sweep), intent(in) :: asked
      integer(int64), intent(in) :: row
      real(wp) :: rate

      associate (low => asked%rates(1), high => asked%rates(2))
         rate = low + (high - low)*((row + 0.5_wp)/asked%grid(2))
      end associate
   end function cell_rate
end module furiko_ensemble_sweep
