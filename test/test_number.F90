! SPDX-License-Identifier: MIT
#include "../src/arithmetic/furiko_compiler.inc"

!> The program's reading and writing of numbers, from the rooms of furiko_cli_number: fpm does not
!> let a test use a module of the program.
module test_number_rooms
   use, intrinsic :: iso_fortran_env, only : dp => real64, int64, qp => real128, sp => real32
   use furiko_bits_dp, only : infinity, is_finite, is_nan, nan
   use furiko_word_arithmetic_dp, only : words, operator(*)
   implicit none
   private
#ifdef FURIKO_REAL128
   include '../app/furiko_cli_number_qp_names.inc'
#endif
   include '../app/furiko_cli_number.inc'
#ifdef FURIKO_REAL128
   include '../app/furiko_cli_number_qp.inc'
#endif
end module test_number_rooms


!> Numbers from text and text from numbers, beside Fortran's own
module test_number
   use, intrinsic :: iso_fortran_env, only : dp => real64, int32, int64, sp => real32
   use furiko_bits_dp, only : infinity, is_nan, nan
   use furiko_word_arithmetic_dp, only : words
   use test_number_rooms, only : is_no_number, is_out_of_range, is_right, read_number, scientific, &
      shortest, significant
   use testdrive, only : check, error_type, new_unittest, unittest_type
   implicit none
   private
   public :: collect_number


contains


   subroutine collect_number(testsuite)
      type(unittest_type), allocatable, intent(out) :: testsuite(:)

      testsuite = [ &
         new_unittest('random-bits-there-and-back', test_random), &
         new_unittest('random-figures', test_figures), &
         new_unittest('powers-of-two-and-ten', test_powers), &
         new_unittest('ties', test_ties), &
         new_unittest('real32-rounds-once', test_once), &
         new_unittest('what-is-a-number', test_syntax), &
         new_unittest('layout', test_layout), &
         new_unittest('significant-figures', test_significant)]
   end subroutine collect_number


   !> A number from random bits, finite
   subroutine draw(x)
      real(dp), intent(out) :: x
      real(dp) :: r(2)

      do
         call random_number(r)
         x = transfer(ior(shiftl(int(r(1)*2.0_dp**32, int64), 32), int(r(2)*2.0_dp**32, int64)), x)
         if (abs(x) <= huge(x)) return
      end do
   end subroutine draw


   !> Written and read, x is x again, by Fortran's read too; a figure less and it is another.
   subroutine check_back(error, x)
      type(error_type), allocatable, intent(out) :: error
      real(dp), intent(in) :: x
      character(len=:), allocatable :: text
      character(len=32) :: buffer
      real(dp) :: back, fortran
      integer :: verdict

      text = shortest(x)
      call read_number(text, back, verdict)
      read(text, *) fortran
      call check(error, verdict == is_right .and. same(back, x) .and. same(fortran, x), text)
      if (allocated(error)) return
      write(buffer, '(es24.16e3)') x
      call read_number(trim(adjustl(buffer)), back, verdict)
      call check(error, verdict == is_right .and. same(back, x), buffer)
      if (allocated(error) .or. figure_count(text) < 2) return
      call read_number(significant(words(x), figure_count(text) - 1), back, verdict)
      call check(error, .not. same(back, x), text // ' has a figure too many')
   end subroutine check_back


   !> The same in real32
   subroutine check_single(error, x)
      type(error_type), allocatable, intent(out) :: error
      real(sp), intent(in) :: x
      character(len=:), allocatable :: text
      real(sp) :: back, fortran
      integer :: verdict

      text = shortest(x)
      call read_number(text, back, verdict)
      read(text, *) fortran
      call check(error, verdict == is_right .and. same(real(back, dp), real(x, dp)) .and. &
         same(real(fortran, dp), real(x, dp)), text)
      if (allocated(error) .or. figure_count(text) < 2) return
      call read_number(significant(words(real(x, dp)), figure_count(text) - 1), back, verdict)
      call check(error, .not. same(real(back, dp), real(x, dp)), text // ' has a figure too many')
   end subroutine check_single


   pure function same(x, y)
      real(dp), intent(in) :: x
      real(dp), intent(in) :: y
      logical :: same

      same = transfer(x, 1_int64) == transfer(y, 1_int64)
   end function same


   !> Figures between the first and the last that are not zero
   pure function figure_count(text) result(count)
      character(len=*), intent(in) :: text
      integer :: count
      character(len=len(text)) :: figures
      integer :: i

      figures = ''
      do i = 1, scan(text // 'e', 'e') - 1
         if (scan(text(i:i), '0123456789') == 1) figures = trim(figures) // text(i:i)
      end do
      count = verify(figures, '0 ', back=.true.) - verify(figures, '0') + 1
   end function figure_count


   subroutine test_random(error)
      type(error_type), allocatable, intent(out) :: error
      real(dp) :: x
      integer :: i

      do i = 1, 10000
         call draw(x)
         call check_back(error, x)
         if (allocated(error)) return
         call check_back(error, scale(fraction(x), mod(i, 60) - 30))
         if (allocated(error)) return
         call check_single(error, real(scale(fraction(x), mod(i, 277) - 149), sp))
         if (allocated(error)) return
         call check_back(error, scale(fraction(x), minexponent(x) - mod(i, 50)))
         if (allocated(error)) return
      end do
   end subroutine test_random


   !> Up to 25 random figures with random exponents, beside Fortran's read
   subroutine test_figures(error)
      type(error_type), allocatable, intent(out) :: error
      character(len=40) :: text
      real(dp) :: fortran, r(3), x
      real(sp) :: fortran_single, single
      integer :: i, verdict
      logical :: vanishes

      do i = 1, 20000
         call random_number(r)
         write(text, '(i0, ".", i0.9, i0)') int(10*r(1)), int(1.0e9_dp*r(2)), &
            int(10.0_dp**modulo(i, 16)*r(3), int64)
         write(text(len_trim(text) + 1:), '("e", sp, i0)') int(600*r(2)) - 300
         call read_number(trim(text), x, verdict)
         read(text, *) fortran
         call check(error, verdict == is_right .and. same(x, fortran), text)
         if (allocated(error)) return
         write(text(scan(text, 'e'):), '("e", sp, i0)') int(80*r(3)) - 42
         call read_number(trim(text), single, verdict)
         read(text, *) fortran_single
         ! What is nearer to 0 than to the smallest number is refused.
         vanishes = .not. abs(fortran_single) > 0.0_sp .and. verify(text(:scan(text, 'e') - 1), '0.') > 0
         call check(error, verdict == merge(is_out_of_range, is_right, vanishes) .and. &
            (vanishes .or. same(real(single, dp), real(fortran_single, dp))), text)
         if (allocated(error)) return
      end do
   end subroutine test_figures


   !> And their neighbours; ten to every power is written in one figure
   subroutine test_powers(error)
      type(error_type), allocatable, intent(out) :: error
      character(len=8) :: text
      real(dp) :: x
      integer :: i, verdict

      do i = minexponent(x) - digits(x), maxexponent(x) - 1
         ! Next above a power of two, where figures of both sides are as fine
         call check_back(error, nearest(scale(1.0_dp, i), 1.0_dp))
         if (allocated(error)) return
         call check_back(error, nearest(scale(1.0_dp, i), -1.0_dp))
         if (allocated(error)) return
         call read_number(shortest(scale(1.0_dp, i)), x, verdict)
         call check(error, same(x, scale(1.0_dp, i)), shortest(x))
         if (allocated(error)) return
      end do
      do i = -323, 308
         write(text, '("1e", i0)') i
         call read_number(trim(text), x, verdict)
         call check(error, figure_count(shortest(x)) == 1, text)
         if (allocated(error)) return
         call check_back(error, nearest(x, 1.0_dp))
         if (allocated(error)) return
         call check_back(error, nearest(x, -1.0_dp))
         if (allocated(error)) return
      end do
   end subroutine test_powers


   !> Halfway between two numbers of real64, the even one; a little more or less, and it decides.
   subroutine test_ties(error)
      type(error_type), allocatable, intent(out) :: error
      character(len=40), parameter :: texts(*) = [character(len=40) :: &
         '9007199254740993', '9007199254740993.00000000000000000001', '9007199254740992.9999999999999999', &
         '9007199254740995', '1.7976931348623158e308', '99999999999999999', '0.99999999999999999', &
         '2.4703282292062328e-324', '4.9406564584124654e-324', '1.00000000000000011102230246251565404']
      real(dp), parameter :: two53 = 2.0_dp**53
      real(dp) :: expected(size(texts)), x
      integer :: i, verdict

      expected = [two53, two53 + 2, two53, two53 + 4, huge(x), 1.0e17_dp, 1.0_dp, &
         transfer(1_int64, x), transfer(1_int64, x), 1.0_dp]
      do i = 1, size(texts)
         call read_number(trim(texts(i)), x, verdict)
         call check(error, verdict == is_right .and. same(x, expected(i)), texts(i))
         if (allocated(error)) return
      end do
   end subroutine test_ties


   !> 1 + 2**-24, halfway, and so little more that real64 does not tell
   subroutine test_once(error)
      type(error_type), allocatable, intent(out) :: error
      character(len=*), parameter :: halfway = '1.000000059604644775390625'
      real(sp) :: x
      integer :: verdict

      call read_number(halfway, x, verdict)
      call check(error, verdict == is_right .and. same(real(x, dp), 1.0_dp))
      if (allocated(error)) return
      call read_number(halfway // '0000000001', x, verdict)
      call check(error, verdict == is_right .and. same(real(x, dp), 1.0_dp + 2.0_dp**(-23)))
   end subroutine test_once


   subroutine test_syntax(error)
      type(error_type), allocatable, intent(out) :: error
      character(len=*), parameter :: right(*) = [character(len=12) :: '1e5', '1d5', '1E+5', '1D05', '+1.e5', &
         '0.1+006', '100000', '.1e6']
      character(len=*), parameter :: wrong(*) = [character(len=12) :: '', '+', '.', 'e5', '1e', '1e+', &
         '--1', '2*3', '1,5', '1-5', '1.5-30', '1.5+-300', '1.5-3000', '1 2', '0x10', '1f5', '1.2.3', &
         'infi', 'infinityx', 'nanx', '+-inf', '1_8', achar(0)]
      character(len=*), parameter :: outside(*) = [character(len=12) :: '1e309', '-1d999999999', '1e-324', &
         '0.1-999', '1.5+999']
      real(dp) :: x
      integer :: i, verdict

      do i = 1, size(right)
         call read_number(trim(right(i)), x, verdict)
         call check(error, verdict == is_right .and. same(x, 1.0e5_dp), right(i))
         if (allocated(error)) return
      end do
      do i = 1, size(wrong)
         call read_number(trim(wrong(i)), x, verdict)
         call check(error, verdict, is_no_number, wrong(i))
         if (allocated(error)) return
      end do
      do i = 1, size(outside)
         call read_number(trim(outside(i)), x, verdict)
         call check(error, verdict, is_out_of_range, outside(i))
         if (allocated(error)) return
      end do
      call check_words(error)
   end subroutine test_syntax


   !> What is not finite, as Fortran, C, Excel and Python write it; zeros with any exponent
   subroutine check_words(error)
      type(error_type), allocatable, intent(out) :: error
      character(len=*), parameter :: words(*) = [character(len=12) :: 'inf', '+Infinity', '-INF', '-inf', &
         '0e999999', '-0']
      real(dp) :: expected(size(words)), x
      integer :: i, verdict

      expected = [infinity, infinity, -infinity, -infinity, 0.0_dp, -0.0_dp]
      do i = 1, size(words)
         call read_number(trim(words(i)), x, verdict)
         call check(error, verdict == is_right .and. same(x, expected(i)), words(i))
         if (allocated(error)) return
      end do
      call read_number('-NaN', x, verdict)
      call check(error, verdict == is_right .and. is_nan(x))
   end subroutine check_words


   !> Plain from 1e-5 on, as long as all figures before the point are told
   subroutine test_layout(error)
      type(error_type), allocatable, intent(out) :: error
      character(len=*), parameter :: texts(*) = [character(len=24) :: '0', '-0', '1', '-0.1', &
         '0.00001', '9.5e-6', '123456', '9007199254740992', '1e16', '1.5e22', '5e-324', &
         '1.7976931348623157e308', '0.3333333333333333', '100.25', 'inf', '-inf', 'nan']
      real(dp) :: x
      integer :: i, verdict

      do i = 1, size(texts)
         call read_number(trim(texts(i)), x, verdict)
         call check(error, shortest(x), trim(texts(i)))
         if (allocated(error)) return
      end do
      call check(error, shortest(1.0_sp/3), '0.33333334')
      if (allocated(error)) return
      call check(error, shortest(16777216.0_sp), '16777216')
      if (allocated(error)) return
      call check(error, shortest(transfer(1_int32, 1.0_sp)), '1e-45')
   end subroutine test_layout


   !> One word and two, ties, carries, both ends of the range
   subroutine test_significant(error)
      type(error_type), allocatable, intent(out) :: error
      type(words) :: third
      integer :: i

      third = words(1.0_dp/3, 1.0_dp/3*2.0_dp**(-54))
      do i = 1, 30
         call check(error, significant(third, i), '0.' // repeat('3', i))
         if (allocated(error)) return
      end do
      call expect(words(0.125_dp), 2, '0.12')
      call expect(words(0.375_dp), 2, '0.38')
      call expect(words(0.125_dp, 1.0e-30_dp), 2, '0.13')
      call expect(words(-0.375_dp, 1.0e-30_dp), 2, '-0.37')
      call expect(words(99.96_dp), 3, '100')
      call expect(words(999.6_dp), 3, '1.00e3')
      call expect(words(1.0_dp, -1.0e-20_dp), 20, '0.99999999999999999999')
      call expect(words(1.0_dp, -1.0e-40_dp), 30, '1.' // repeat('0', 29))
      call expect(words(0.0_dp), 3, '0.00')
      call expect(words(-0.0_dp), 1, '0')
      call expect(words(-1.7e-157_dp), 2, '-1.7e-157')
      call expect(words(huge(1.0_dp)), 30, '1.79769313486231570814527423732e308')
      call expect(words(transfer(1_int64, 1.0_dp)), 25, '4.940656458412465441765688e-324')
      call expect(words(-infinity), 5, '-inf')
      call expect(words(nan), 5, 'nan')
      if (allocated(error)) return
      call check(error, scientific(words(-0.068_dp), 1) // scientific(words(12.5_dp), 3) // &
         scientific(words(0.0_dp), 3), '-7e-21.25e10.00')


   contains


      subroutine expect(x, count, text)
         type(words), intent(in) :: x
         integer, intent(in) :: count
         character(len=*), intent(in) :: text

         if (.not. allocated(error)) call check(error, significant(x, count), text)
      end subroutine expect

   end subroutine test_significant

end module test_number
! rooms: 2513583206
