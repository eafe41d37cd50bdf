! SPDX-License-Identifier: MIT
#include "../src/arithmetic/furiko_compiler.inc"

!> `furiko digits`: K to 33 digits by real128 in two words; digits/ takes over beyond.
module furiko_cli_digits
   use, intrinsic :: iso_fortran_env, only : int64
#ifdef FURIKO_REAL128
   use, intrinsic :: iso_fortran_env, only : wp => real128
   use furiko_word_arithmetic_qp, only : words, pi_words, mean_with_one, sqrt, value, operator(+), &
      operator(-), operator(*), operator(/)
#endif
   use furiko_cli_number, only : exponent_mark, is_number, read_whole
   use furiko_cli_io, only : finish, put, refuse
   use furiko_cli_options, only : command, command_line, demand, option, word
   use furiko_cli_quantity, only : whole_of
   use furiko_cli_text, only : whole_text
   implicit none
   private
   public :: digits_usage


   character(len=*), parameter :: name = 'furiko digits'


contains


   function digits_usage() result(usage)
      type(command) :: usage

      usage = command('digits', 'K to 33 digits', '', 0, &
         'The complete elliptic integral K(k) to N significant digits, correctly rounded. For any ' // &
         'number of digits: sh digits/run --k K --digits N', &
         example='furiko digits --k 1/2 --digits 33', options=[ &
         option('--k', 'K', '1/2', 'modulus, -1 < K < 1, a decimal or a fraction, taken exactly'), &
         option('--digits', 'N', '33', '2 to 33')], run=digits_command)
   end function digits_usage


   subroutine digits_command(line)
      type(command_line), intent(in) :: line
      type(word) :: k

      k = line%value('--k')
      call put(quarter_period(k%text, count_of(line%value('--digits'), k%text)))
      call finish()
   end subroutine digits_command


   function count_of(given, k) result(count)
      type(word), intent(in) :: given
      character(len=*), intent(in) :: k
      integer :: count
      integer, parameter :: most = 33
      integer(int64) :: asked
      logical :: valid

      call read_whole(given%text, asked, valid)
      call demand(.not. valid .or. asked <= most, given, '2 to 33; for more: sh digits/run --k ' // k // &
         ' --digits ' // given%text)
      count = whole_of(given, 2, most)
   end function count_of


#ifdef FURIKO_REAL128
   !> K(k) = pi/(2 M(1, k')) as text. k'^2 = (y - x) (y + x)/y^2 for |k| = x/y, and what is in brackets
   !> is formed of the figures as typed, so that no digit of 1 - k is lost.
   function quarter_period(word, count) result(text)
      character(len=*), intent(in) :: word
      integer, intent(in) :: count
      character(len=:), allocatable :: text
      ! of real128, not to leave its range
      integer, parameter :: most_figures = 4800
      character(len=:), allocatable :: x, y
      type(words) :: k, mean, per_y, margin
      logical :: valid

      y = '' ! for gfortran, which sees a length that was never set
      call read_fraction(word, x, y, valid)
      if (.not. valid) call refuse(name // ": --k '" // word // "' is not a number")
      if (len(y) > most_figures) call refuse(name // ': --k ' // word // ' has too many figures; ' // &
         elsewhere(word, count))
      if (.not. llt(x, y)) call refuse(name // ': --k ' // word // ' is outside -1 < k < 1')
      per_y = 1.0_wp/words_of(y)
      call mean_with_one(sqrt((words_of(sum_of(y, x, -1))*per_y)*(words_of(sum_of(y, x, 1))*per_y)), mean)
      k = pi_words/(2.0_wp*mean)
      ! a sum or product in words errs by less than 16 epsilon^2; two for each figure, and 150 more
      margin = (32.0_wp*len(y) + 2400.0_wp)*epsilon(1.0_wp)**2*k
      text = decimals(k - margin, count)
      if (text /= decimals(k + margin, count)) call refuse(name // ': K is too near to the middle of ' // &
         'two numbers to be rounded here; ' // elsewhere(word, count))
   end function quarter_period


   !> What to do instead
   function elsewhere(word, count) result(text)
      character(len=*), intent(in) :: word
      integer, intent(in) :: count
      character(len=:), allocatable :: text

      text = 'instead: sh digits/run --k ' // word // ' --digits ' // whole_text(count)
   end function elsewhere


   !> The magnitude of a decimal number or of a fraction of two, as x/y: whole numbers of one length
   subroutine read_fraction(text, x, y, valid)
      character(len=*), intent(in) :: text
      character(len=:), allocatable, intent(out) :: x
      character(len=:), allocatable, intent(out) :: y
      logical, intent(out) :: valid
      integer :: slash, places, below

      slash = index(text // '/', '/')
      call read_one(text(:slash - 1), x, places, valid)
      if (.not. valid) return
      y = '1'
      below = 0
      if (slash <= len(text)) call read_one(text(slash + 1:), y, below, valid)
      if (valid) valid = verify(y, '0') > 0
      if (.not. valid) return
      x = x // repeat('0', max(0, below - places))
      y = y // repeat('0', max(0, places - below))
      x = repeat('0', max(0, len(y) - len(x))) // x
      y = repeat('0', max(0, len(x) - len(y))) // y
   end subroutine read_fraction


   !> The magnitude of a decimal number: a whole number over a power of ten
   subroutine read_one(text, figures, places, valid)
      character(len=*), intent(in) :: text
      character(len=:), allocatable, intent(out) :: figures
      integer, intent(out) :: places
      logical, intent(out) :: valid
      integer(int64) :: power
      integer :: mark, point, start

      figures = ''
      places = 0
      valid = is_number(text)
      if (.not. valid) return
      mark = exponent_mark(text)
      power = 0
      if (mark < len(text)) call read_whole(text(mark + 1:), power, valid)
      valid = abs(power) < 4000
      if (.not. valid) return
      start = 1
      if (scan(text, '+-') == 1) start = 2
      point = scan(text(:mark - 1) // '.', '.')
      figures = text(start:point - 1) // text(point + 1:mark - 1)
      places = max(0, mark - 1 - point) - int(power)
   end subroutine read_one


   !> y + x, or with a factor of -1 y - x >= 0; whole numbers of one length
   pure function sum_of(y, x, factor) result(z)
      character(len=*), intent(in) :: y
      character(len=*), intent(in) :: x
      integer, intent(in) :: factor
      character(len=:), allocatable :: z
      integer :: i, figure, carry

      z = '0' // y
      carry = 0
      do i = len(y), 1, -1
         figure = index('123456789', y(i:i)) + factor*index('123456789', x(i:i)) + carry
         carry = (figure - modulo(figure, 10))/10
         z(i + 1:i + 1) = achar(iachar('0') + modulo(figure, 10))
      end do
      if (carry > 0) z(1:1) = '1'
   end function sum_of


   !> A whole number in words
   pure function words_of(figures) result(x)
      character(len=*), intent(in) :: figures
      type(words) :: x
      integer :: i

      x = words(0.0_wp)
      do i = 1, len(figures)
         x = 10.0_wp*x + real(index('123456789', figures(i:i)), wp)
      end do
   end function words_of


   !> x >= 1, to `count` significant digits; with an exponent where x has more before its point
   function decimals(x, count) result(text)
      type(words), intent(in) :: x
      integer, intent(in) :: count
      character(len=:), allocatable :: text
      type(words) :: rest
      integer :: i, figure, point

      point = len(whole_text(whole_part(x)))
      ! half a unit of the last digit, and cut
      rest = x/10.0_wp**(point - 1) + words(5.0_wp)/10.0_wp**count
      if (whole_part(rest) > 9) then
         point = point + 1
         rest = rest/10.0_wp
      end if
      text = ''
      do i = 1, count
         figure = int(whole_part(rest))
         rest = 10.0_wp*(rest - real(figure, wp))
         text = text // achar(iachar('0') + figure)
      end do
      if (point < count) then
         text = text(:point) // '.' // text(point + 1:)
      else if (point > count) then
         text = text(1:1) // '.' // text(2:) // 'e' // whole_text(point - 1)
      end if
   end function decimals


   !> The largest whole number that is not above x
   pure function whole_part(x) result(n)
      type(words), intent(in) :: x
      integer(int64) :: n

      n = floor(value(x), int64)
      if (value(x - real(n, wp)) < 0.0_wp) n = n - 1
   end function whole_part
#else
   !> Without real128 there are only 16 digits to give.
   function quarter_period(word, count) result(text)
      character(len=*), intent(in) :: word
      integer, intent(in) :: count
      character(len=:), allocatable :: text

      text = ''
      call refuse(name // ': this compiler has no real128; instead: sh digits/run --k ' // word // &
         ' --digits ' // whole_text(count))
   end function quarter_period
#endif

end module furiko_cli_digits
! rooms: 3759241635
