! SPDX-License-Identifier: MIT

!> furiko-digits: K(k), or the table of the period, to any number of digits.
program main
   use, intrinsic :: iso_fortran_env, only : error_unit, output_unit
   use, intrinsic :: iso_c_binding, only : c_int
   use digits_period, only : outside, period_digits
   implicit none
   character(len=*), parameter :: nl = new_line('a')
   character(len=*), parameter :: help = &
      'furiko-digits [--k K | --m M | --mc MC | --amplitude A] [--digits N]' // nl // &
      'furiko-digits --table [--digits N]' // nl // nl // &
      'K(k) to N digits, correctly rounded; the period ratio T/T_h for an amplitude A in degrees;' // &
      nl // 'or T/T_h for 0, 1, ... 179 degrees. Numbers are decimals or fractions and taken' // &
      nl // 'exactly. N from 2 to 10000000 (50). Example:' // nl // nl // &
      '  sh digits/run --k 1/2 --digits 50'

   interface
      subroutine c_exit(code) bind(c, name='exit')
         import :: c_int
         implicit none
         integer(c_int), value :: code
      end subroutine c_exit
   end interface

   character(len=:), allocatable :: form, value
   character(len=3) :: degrees
   integer :: a, digits

   call read_command_line(form, value, digits)
   if (form == 'table') then
      do a = 0, 179
         write(degrees, '(i3)') a
         write(output_unit, '(a)') degrees // ' ' // &
            period_digits('amplitude', trim(adjustl(degrees)), digits)
      end do
   else
      value = period_digits(form, value, digits)
      write(output_unit, '(a)') value
   end if


contains


   subroutine read_command_line(form, value, digits)
      character(len=:), allocatable, intent(out) :: form
      character(len=:), allocatable, intent(out) :: value
      integer, intent(out) :: digits
      character(len=:), allocatable :: word
      integer :: i

      form = ''
      value = ''
      digits = 50
      i = 1
      do while (i <= command_argument_count())
         word = argument(i)
         select case (word)
         case ('-h', '--help')
            write(output_unit, '(a)') help
            stop
         case ('--table')
            form = word(3:)
         case ('--digits')
            i = i + 1
            digits = read_count(argument(i))
         case ('--k', '--m', '--mc', '--amplitude')
            form = word(3:)
            i = i + 1
            value = argument(i)
            if (period_digits(form, value, 2) == outside) then
               call refuse(word // " '" // value // "' is not a number, or outside " // domain(form))
            end if
         case default
            call refuse("unknown word '" // word // "'; see --help")
         end select
         i = i + 1
      end do
      if (form == '') call refuse('name a modulus, as --k 1/2, or --table; see --help')
   end subroutine read_command_line


   function read_count(word) result(count)
      character(len=*), intent(in) :: word
      integer :: count

      count = 0
      if (len(word) > 0 .and. len(word) < 9 .and. verify(word, '0123456789') == 0) then
         read(word, '(i8)') count
      end if
      if (count < 2 .or. count > 10000000) then
         call refuse("--digits '" // word // "' is not a whole number from 2 to 10000000")
      end if
   end function read_count


   pure function domain(form)
      character(len=*), intent(in) :: form
      character(len=:), allocatable :: domain

      select case (form)
      case ('k')
         domain = '-1 < k < 1'
      case ('m')
         domain = 'm < 1'
      case ('mc')
         domain = 'mc > 0'
      case default
         domain = '0 <= A < 180 degrees'
      end select
   end function domain


   !> The i-th word of the command line; empty behind the last
   function argument(i)
      integer, intent(in) :: i
      character(len=:), allocatable :: argument
      integer :: length

      call get_command_argument(i, length=length)
      allocate(character(len=length) :: argument)
      call get_command_argument(i, argument)
   end function argument


   subroutine refuse(message)
      character(len=*), intent(in) :: message

      write(error_unit, '(a)') 'furiko-digits: ' // message
      ! `stop 2` would print STOP 2
      call c_exit(2_c_int)
   end subroutine refuse

end program main
