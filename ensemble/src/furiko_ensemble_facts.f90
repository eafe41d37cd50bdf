! SPDX-License-Identifier: MIT

!> What a file says of its run: attributes, in which two runs that may share a file do not differ.
module furiko_ensemble_facts
   use, intrinsic :: iso_fortran_env, only : compiler_options, compiler_version, int64, wp => real64
   use furiko, only : furiko_version
   use furiko_ensemble_sweep, only : constants, sweep, tolerance
   implicit none
   private
   public :: fact, facts_of, fact_text, take_fact, text_fact


   !> One attribute: a text, a number or a whole number
   type :: fact
      character(len=:), allocatable :: name
      character(len=:), allocatable :: text
      real(wp), allocatable :: number
      integer(int64), allocatable :: whole
   end type fact


contains


   !> The subject comes first, since it decides what else there is.
   function facts_of(asked) result(facts)
      type(sweep), intent(in) :: asked
      type(fact), allocatable :: facts(:)
      integer :: i

      facts = [text_fact('subject', asked%subject), &
         text_fact('title', 'Driven, damped pendulums: ' // asked%subject), &
         text_fact('equation', "angle'' = -damping angle' - quadratic |angle'| angle' - sin(angle) + torque" &
            // " + drive cos(frequency t + phase), t in units of sqrt(length/gravity)"), &
         text_fact('furiko_version', furiko_version), text_fact('compiler', compiler_version()), &
         text_fact('flags', telling_flags(compiler_options())), &
         text_fact('method', asked%method), whole_fact('steps', int(asked%steps, int64)), &
         [(number_fact(trim(constants(i)) // merge('_degrees', '        ', constants(i) == 'phase'), &
            asked%constant(i)), i=1, size(constants))], members_facts(asked), &
         whole_fact('transient', int(asked%transient, int64)), &
         whole_fact('periods', int(asked%periods, int64)), whole_fact('chunk', int(asked%chunk, int64))]
   end function facts_of


   !> Which members there are, and what is asked of this subject only
   function members_facts(asked) result(facts)
      type(sweep), intent(in) :: asked
      type(fact), allocatable :: facts(:)

      if (asked%subject == 'basins') then
         facts = [whole_fact('grid_angles', asked%grid(1)), whole_fact('grid_rates', asked%grid(2)), &
            number_fact('lowest_angle_degrees', asked%angles(1)), &
            number_fact('highest_angle_degrees', asked%angles(2)), &
            number_fact('lowest_rate', asked%rates(1)), number_fact('highest_rate', asked%rates(2)), &
            whole_fact('cycle', int(asked%cycle, int64)), number_fact('tolerance', tolerance)]
         return
      end if
      facts = [number_fact('start_angle_degrees', asked%angle), number_fact('start_rate', asked%rate), &
         whole_fact('points', asked%points)]
      if (asked%subject /= 'section') facts = [facts, text_fact('vary', trim(constants(asked%vary))), &
         number_fact('from', asked%from), number_fact('to', asked%to)]
      if (asked%subject == 'winding') facts = [facts, whole_fact('cycle', int(asked%cycle, int64))]
   end function members_facts


   !> What a fact says of a sweep; compiler, version and the like say nothing
   subroutine take_fact(given, asked)
      type(fact), intent(in) :: given
      type(sweep), intent(inout) :: asked

      select case (given%name)
      case ('subject')
         asked%subject = given%text
      case ('method')
         asked%method = given%text
      case ('vary')
         asked%vary = findloc(constants == given%text, .true., 1)
      case ('steps')
         asked%steps = int(given%whole)
      case ('points')
         asked%points = given%whole
      case ('grid_angles')
         asked%grid(1) = given%whole
      case ('grid_rates')
         asked%grid(2) = given%whole
         asked%points = product(asked%grid)
      case ('transient')
         asked%transient = int(given%whole)
      case ('periods')
         asked%periods = int(given%whole)
      case ('cycle')
         asked%cycle = int(given%whole)
      case ('chunk')
         asked%chunk = int(given%whole)
      case default
         if (allocated(given%number)) call take_number(given%name, given%number, asked)
      end select
   end subroutine take_fact


   subroutine take_number(name, number, asked)
      character(len=*), intent(in) :: name
      real(wp), intent(in) :: number
      type(sweep), intent(inout) :: asked

      select case (name)
      case ('start_angle_degrees')
         asked%angle = number
      case ('start_rate')
         asked%rate = number
      case ('from')
         asked%from = number
      case ('to')
         asked%to = number
      case ('lowest_angle_degrees')
         asked%angles(1) = number
      case ('highest_angle_degrees')
         asked%angles(2) = number
      case ('lowest_rate')
         asked%rates(1) = number
      case ('highest_rate')
         asked%rates(2) = number
      case default
         where (constants == name(:index(name // '_', '_') - 1)) asked%constant = number
      end select
   end subroutine take_number


   function text_fact(name, text) result(one)
      character(len=*), intent(in) :: name
      character(len=*), intent(in) :: text
      type(fact) :: one

      one%name = name
      one%text = text
   end function text_fact


   function number_fact(name, number) result(one)
      character(len=*), intent(in) :: name
      real(wp), intent(in) :: number
      type(fact) :: one

      one%name = trim(name)
      one%number = number
   end function number_fact


   function whole_fact(name, whole) result(one)
      character(len=*), intent(in) :: name
      integer(int64), intent(in) :: whole
      type(fact) :: one

      one%name = name
      one%whole = whole
   end function whole_fact


   !> A fact's value as a person reads it
   function fact_text(one) result(text)
      type(fact), intent(in) :: one
      character(len=:), allocatable :: text
      character(len=32) :: buffer

      if (allocated(one%text)) then
         text = one%text
         return
      else if (allocated(one%whole)) then
         write(buffer, '(i0)') one%whole
      else
         write(buffer, '(g0)') one%number
      end if
      text = trim(buffer)
   end function fact_text


   !> Of a compiler's options those that may change a bit: -O, -m and -f, but for where files lie
   pure function telling_flags(options) result(flags)
      character(len=*), intent(in) :: options
      character(len=:), allocatable :: flags
      integer :: first, last

      flags = ''
      first = 1
      do while (first <= len(options))
         last = index(options(first:) // ' ', ' ') + first - 2
         if (last - first >= 1) then
            associate (option => options(first:last))
               if (scan(option(2:2), 'Omf') > 0 .and. option(1:1) == '-' .and. scan(option, '/') == 0) then
                  flags = flags // ' ' // option
               end if
            end associate
         end if
         first = last + 2
      end do
      flags = flags(2:)
   end function telling_flags
end module furiko_ensemble_facts
