! SPDX-License-Identifier: MIT
#include "../src/arithmetic/furiko_compiler.inc"

!> `furiko digits`: K to 33 digits by real128 in two words; digits/ takes over beyond.
module furiko_cli_digits
#ifdef FURIKO_REAL128
   use, intrinsic :: iso_fortran_env, only : int64, wp => real128
   use furiko_word_arithmetic_qp, only : words, pi_words, sqrt, value, operator(+), operator(-), &
      operator(*), operator(/)
#endif
   use furiko_cli_arguments, only : argument_reader, value_of
   use furiko_cli_number, only : exponent_mark, is_number
   use furiko_cli_quantity, only : integer_of
   use furiko_cli_terminal, only : finish, put, refuse
   implicit none
   private
   public :: digits_command


   character(len=*), parameter :: command = 'furiko digits'
   character(len=*), parameter :: nl = new_line('a')
   character(len=*), parameter :: help = &
      'furiko digits --k K [--digits N]' // nl // nl // &
      'The complete elliptic integral K(K) to N significant digits, correctly rounded.' // nl // nl // &
      '  --k K         modulus, -1 < K < 1, a decimal or a fraction, taken exactly (1/2)' // nl // &
      '  --digits N    2 to 33 (33); for any number of digits: sh digits/run --k K --digits N' // &
      nl // nl // 'Example:' // nl // nl // &
      '  furiko digits --k 1/2 --digits 33'


contains


   subroutine digits_command(arguments)
      type(argument_reader), intent(inout) :: arguments
      character(len=:), allocatable :: k, option
      integer :: count

      k = '1/2'
      count = 33
      do while (.not. arguments%done())
         option = arguments%word()
         call arguments%advance()
         select case (option)
         case ('-h', '--help')
            call put(help)
            call finish()
            return
         case ('--k')
            k = value_of(command, option, arguments)
         case ('--digits')
            count = count_of(value_of(command, option, arguments), k)
         case default
            call refuse(command // ": unknown word '" // option // "'; see furiko digits --help")
         end select
      end do
      call put(quarter_period(k, count))
      call finish()
   end subroutine digits_command


   function count_of(word, k) result(count)
      character(len=*), intent(in) :: word
      character(len=*), intent(in) :: k
      integer :: count

      count = integer_of(command // ': --digits', word, 2, huge(count))
      if (count > 33) then
         call refuse(command // ': --digits ' // word // ' is outside 2 to 33; for more: sh digits/run --k ' &
            // k // ' --digits ' // word)
      end if
   end function count_of


#ifdef FURIKO_REAL128
   !> K(k) = pi/(2 M(1, k')) of a modulus in words, as text
   function quarter_period(word, count) result(text)
      character(len=*), intent(in) :: word
      integer, intent(in) :: count
      character(len=:), allocatable :: text
      type(words) :: a, b, geometric, k, mc
      logical :: valid

      call read_exactly(word, k, valid)
      if (.not. valid) call refuse(command // ": --k '" // word // "' is not a number")
      mc = (1.0_wp - k)*(1.0_wp + k)
      if (.not. value(mc) > 0.0_wp) call refuse(command // ': --k ' // word // ' is outside -1 < k < 1')
      a = words(1.0_wp)
      b = sqrt(mc)
      do while (value(a - b) > epsilon(1.0_wp)*a%hi)
         geometric = sqrt(a*b)
         a = 0.5_wp*(a + b)
         b = geometric
      end do
      text = decimals(pi_words/(a + b), count)
   end function quarter_period


   !> A decimal number or a fraction of two, in words
   subroutine read_exactly(text, x, valid)
      character(len=*), intent(in) :: text
      type(words), intent(out) :: x
      logical, intent(out) :: valid
      type(words) :: y
      integer :: slash

      slash = index(text // '/', '/')
      call read_one(text(:slash - 1), x, valid)
      if (.not. valid .or. slash > len(text)) return
      call read_one(text(slash + 1:), y, valid)
      valid = valid .and. abs(y%hi) > 0.0_wp
      if (valid) x = x/y
   end subroutine read_exactly


   !> A decimal number in words: its figures as a whole number, over a power of ten
   subroutine read_one(text, x, valid)
      character(len=*), intent(in) :: text
      type(words), intent(out) :: x
      logical, intent(out) :: valid
      integer :: i, mark, places, stat
      logical :: behind_point

      valid = is_number(text)
      if (.not. valid) return
      mark = exponent_mark(text)
      places = 0
      stat = 0
      if (mark < len(text)) read(text(mark + 1:), '(i20)', iostat=stat) places
      valid = stat == 0 .and. abs(places) < 4000
      places = -places
      behind_point = .false.
      do i = 1, mark - 1
         if (text(i:i) == '.') behind_point = .true.
         if (scan(text(i:i), '0123456789') == 0) cycle
         x = 10.0_wp*x + real(index('123456789', text(i:i)), wp)
         if (behind_point) places = places + 1
      end do
      do i = 1, abs(places)
         if (places > 0) x = x/10.0_wp
         if (places < 0) x = x*10.0_wp
      end do
      if (text(1:1) == '-') x = -x
   end subroutine read_one


   !> x >= 1, to `count` significant digits
   function decimals(x, count) result(text)
      type(words), intent(in) :: x
      integer, intent(in) :: count
      character(len=:), allocatable :: text
      integer, parameter :: group = 8
      integer(int64), parameter :: unit = 10_int64**group
      type(words) :: rest
      character(len=12) :: buffer
      integer(int64) :: part
      integer :: whole

      write(buffer, '(i0)') int(value(x), int64)
      whole = len_trim(buffer)
      ! half a unit of the last digit, and cut
      rest = x + words(5.0_wp)/10.0_wp**(count - whole + 1)
      part = floor(value(rest), int64)
      write(buffer, '(i0)') part
      text = trim(buffer) // '.'
      do while (len(text) < count + 1 + group)
         rest = (rest - real(part, wp))*real(unit, wp)
         part = floor(value(rest), int64)
         write(buffer, '(i8.8)') part
         text = text // buffer(:group)
      end do
      text = text(:count + 1)
   end function decimals
#else
   !> Without real128 there are only 16 digits to give.
   function quarter_period(word, count) result(text)
      character(len=*), intent(in) :: word
      integer, intent(in) :: count
      character(len=:), allocatable :: text
      character(len=12) :: number

      write(number, '(i0)') count
      text = ''
      call refuse(command // ': this compiler has no real128; instead: sh digits/run --k ' // word // &
         ' --digits ' // trim(number))
   end function quarter_period
#endif

end module furiko_cli_digits
! rooms: 3759241635
