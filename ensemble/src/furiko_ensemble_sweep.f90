! SPDX-License-Identifier: MIT

!> What is computed: a family of driven pendulums, one constant of which goes from one value to another, in
!> chunks of members. What comes out of a chunk depends on nothing but the sweep and the chunk's number.
module furiko_ensemble_sweep
   use, intrinsic :: iso_fortran_env, only : int64, wp => real64
   use furiko, only : driven_amplitude, driven_damping, driven_exponents, driven_frequency, driven_order8, &
      driven_pendulum, driven_periods, driven_phase, driven_quadratic, driven_rk4, driven_scheme, &
      driven_section, driven_set, driven_state, driven_torque, driven_winding
   implicit none
   private
   public :: sweep, quantity, chunks, compute, constants, first_member, is_mine, members_of, quantities, &
      scheme_of, subjects


   character(len=*), parameter :: subjects(3) = [character(len=11) :: 'bifurcation', 'lyapunov', 'winding']
   !> Constants by name, in the order of their numbers in the library, with their units
   character(len=*), parameter :: constants(6) = [character(len=9) :: 'damping', 'quadratic', 'torque', &
      'drive', 'frequency', 'phase']
   integer, parameter :: numbers(6) = [driven_damping, driven_quadratic, driven_torque, driven_amplitude, &
      driven_frequency, driven_phase]
   real(wp), parameter :: degree = acos(-1.0_wp)/180


   !> All that decides which numbers come out
   type :: sweep
      !> One of the subjects
      character(len=:), allocatable :: subject
      !> order8 or rk4
      character(len=:), allocatable :: method
      !> Steps to a period of the drive
      integer :: steps
      !> Constants of all members, by number; the phase in degrees
      real(wp) :: constant(6)
      !> The start, degrees and rate
      real(wp) :: angle
      real(wp) :: rate
      !> The constant that is varied, from its first to its last value; a phase in radians
      integer :: vary
      real(wp) :: from
      real(wp) :: to
      !> Members
      integer(int64) :: points
      !> Periods that are left out, and that are stored or counted
      integer :: transient
      integer :: periods
      !> Members that are computed and written together
      integer :: chunk
   end type sweep


   !> One kind of result: a column of `rows` numbers for each member
   type :: quantity
      character(len=:), allocatable :: name
      character(len=:), allocatable :: units
      character(len=:), allocatable :: about
      integer :: rows = 1
      !> Whether there is a number for each period, and not only one for each member
      logical :: each_period = .false.
      !> The numbers of a chunk, (rows, members); the other one is not allocated
      real(wp), allocatable :: reals(:, :)
      integer(int64), allocatable :: wholes(:, :)
   end type quantity


contains


   !> How many chunks there are
   pure function chunks(asked) result(number)
      type(sweep), intent(in) :: asked
      integer(int64) :: number

      number = (asked%points + asked%chunk - 1)/asked%chunk
   end function chunks


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


   !> Whose a chunk is: part 1, 2, ... of so many parts. No part asks another.
   elemental function is_mine(chunk, part, parts) result(mine)
      integer(int64), intent(in) :: chunk
      integer, intent(in) :: part
      integer, intent(in) :: parts
      logical :: mine

      mine = modulo(chunk, int(parts, int64)) == part - 1
   end function is_mine


   pure function scheme_of(asked) result(scheme)
      type(sweep), intent(in) :: asked
      type(driven_scheme) :: scheme

      if (asked%method == 'rk4') then
         scheme = driven_rk4(asked%steps)
      else
         scheme = driven_order8(asked%steps)
      end if
   end function scheme_of


   !> What a sweep yields, with room for the largest chunk; the constant that is varied comes first.
   function quantities(asked) result(all)
      type(sweep), intent(in) :: asked
      type(quantity), allocatable :: all(:)
      character(len=*), parameter :: frequency = 'sqrt(gravity/length)'
      character(len=*), parameter :: units(6) = [character(len=20) :: frequency, '1', '1', '1', frequency, &
         'rad']
      type(quantity) :: value, status

      value = real_quantity(asked, trim(constants(asked%vary)), trim(units(asked%vary)), &
         'the constant that is varied')
      status = whole_quantity(asked, 'status', '1', '0: ran, 1: left the range of 2^20')
      select case (asked%subject)
      case ('bifurcation')
         all = [value, &
            real_quantity(asked, 'angle', 'rad', 'from the bottom, at the end of a period', .true.), &
            real_quantity(asked, 'rate', frequency, 'of the angle', .true.), &
            whole_quantity(asked, 'turns', '1', 'whole turns since the start, after the last period'), status]
      case ('lyapunov')
         all = [value, real_quantity(asked, 'exponent_1', frequency, 'larger Lyapunov exponent'), &
            real_quantity(asked, 'exponent_2', frequency, 'smaller Lyapunov exponent'), &
            real_quantity(asked, 'error_1', frequency, 'standard error of exponent_1'), status]
      case default
         all = [value, real_quantity(asked, 'winding', '1', 'turns to a period of the drive'), status]
      end select
   end function quantities


   function real_quantity(asked, name, units, about, each_period) result(one)
      type(sweep), intent(in) :: asked
      character(len=*), intent(in) :: name
      character(len=*), intent(in) :: units
      character(len=*), intent(in) :: about
      logical, intent(in), optional :: each_period
      type(quantity) :: one

      one%name = name
      one%units = units
      one%about = about
      if (present(each_period)) one%each_period = each_period
      if (one%each_period) one%rows = asked%periods
      allocate(one%reals(one%rows, asked%chunk), source=0.0_wp)
   end function real_quantity


   function whole_quantity(asked, name, units, about) result(one)
      type(sweep), intent(in) :: asked
      character(len=*), intent(in) :: name
      character(len=*), intent(in) :: units
      character(len=*), intent(in) :: about
      type(quantity) :: one

      one%name = name
      one%units = units
      one%about = about
      allocate(one%wholes(1, asked%chunk), source=0_int64)
   end function whole_quantity


   !> The results of a chunk
   subroutine compute(asked, scheme, chunk, results)
      type(sweep), intent(in) :: asked
      type(driven_scheme), intent(in) :: scheme
      integer(int64), intent(in) :: chunk
      type(quantity), intent(inout) :: results(:)
      type(driven_pendulum), allocatable :: pendulum(:)
      type(driven_state), allocatable :: state(:)
      real(wp), allocatable :: exponents(:, :)
      integer :: n

      call take_members(asked, chunk, results(1)%reals(1, :), pendulum, state)
      n = size(state)
      select case (asked%subject)
      case ('bifurcation')
         call compute_sections(asked, scheme, pendulum, state, results(2)%reals, results(3)%reals)
         results(4)%wholes(1, :n) = state%turns
      case ('lyapunov')
         allocate(exponents(2, n))
         call driven_exponents(scheme, pendulum, state, asked%transient, asked%periods, exponents, &
            results(4)%reals(1, :n))
         results(2)%reals(1, :n) = exponents(1, :)
         results(3)%reals(1, :n) = exponents(2, :)
      case default
         call driven_winding(scheme, pendulum, state, asked%transient, asked%periods, results(2)%reals(1, :n))
      end select
      results(size(results))%wholes(1, :n) = state%status
   end subroutine compute


   !> Members of a chunk at their starts, and their values of what is varied
   pure subroutine take_members(asked, chunk, values, pendulum, state)
      type(sweep), intent(in) :: asked
      integer(int64), intent(in) :: chunk
      real(wp), intent(inout) :: values(:)
      type(driven_pendulum), allocatable, intent(out) :: pendulum(:)
      type(driven_state), allocatable, intent(out) :: state(:)
      integer(int64) :: first
      integer :: i, n

      n = members_of(asked, chunk)
      first = first_member(asked, chunk)
      allocate(pendulum(n), state(n))
      do i = 1, n
         values(i) = asked%from + (asked%to - asked%from)* &
            (real(first + i - 1, wp)/real(max(asked%points - 1, 1_int64), wp))
      end do
      do i = 1, size(constants)
         call driven_set(pendulum, numbers(i), asked%constant(i)*merge(degree, 1.0_wp, &
            numbers(i) == driven_phase))
      end do
      call driven_set(pendulum, numbers(asked%vary), values(:n))
      state%angle = asked%angle*degree
      state%rate = asked%rate
   end subroutine take_members


   subroutine compute_sections(asked, scheme, pendulum, state, angle, rate)
      type(sweep), intent(in) :: asked
      type(driven_scheme), intent(in) :: scheme
      type(driven_pendulum), intent(in) :: pendulum(:)
      type(driven_state), intent(inout) :: state(:)
      real(wp), intent(inout) :: angle(:, :)
      real(wp), intent(inout) :: rate(:, :)
      type(driven_state) :: points(1, size(state))
      integer :: i

      call driven_periods(scheme, pendulum, state, asked%transient)
      do i = 1, asked%periods
         call driven_section(scheme, pendulum, state, 0, points)
         angle(i, :size(state)) = points(1, :)%angle
         rate(i, :size(state)) = points(1, :)%rate
      end do
   end subroutine compute_sections
end module furiko_ensemble_sweep
