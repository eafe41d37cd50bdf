! SPDX-License-Identifier: MIT

!> Double-word arithmetic: exact identities, and 30 digits of known numbers.
module test_double_word
   use, intrinsic :: iso_fortran_env, only : wp => real64
   use furiko_double_word, only : double_word, double_word_pi, sqrt, sin, &
      operator(+), operator(-), operator(*), operator(/)
   use testdrive, only : check, error_type, new_unittest, unittest_type
   implicit none
   private
   public :: collect_double_word


   !> 2^-99, the module's promise
   real(wp), parameter :: tolerance = 1.6e-30_wp


contains


   subroutine collect_double_word(testsuite)
      type(unittest_type), allocatable, intent(out) :: testsuite(:)

      testsuite = [ &
         new_unittest('sum-keeps-small-terms', test_sum), &
         new_unittest('product-is-exact', test_product), &
         new_unittest('quotient', test_quotient), &
         new_unittest('square-root', test_square_root), &
         new_unittest('sine', test_sine)]
   end subroutine collect_double_word


   subroutine test_sum(error)
      type(error_type), allocatable, intent(out) :: error
      type(double_word) :: x

      x = double_word(1.0_wp) + double_word(1.0e-25_wp) - double_word(1.0_wp)
      call check(error, abs(x%hi - 1.0e-25_wp) <= 1.0e-32_wp)
      if (allocated(error)) return
      x = double_word(3.0_wp, 1.0e-20_wp) - double_word(3.0_wp, 1.0e-20_wp)
      call check(error, abs(x%hi) <= 0.0_wp .and. abs(x%lo) <= 0.0_wp)
      if (allocated(error)) return
      x = double_word(1.0_wp, 2.0_wp**(-54)) + double_word(-1.0_wp, 2.0_wp**(-110))
      call check(error, abs(x%hi - 2.0_wp**(-54)) <= 0.0_wp .and. abs(x%lo - 2.0_wp**(-110)) <= 0.0_wp)
   end subroutine test_sum


   !> (2^52 + 1)^2 = 2^104 + 2^53 + 1: a plain product loses the last term, a contracted
   !> error term both
   subroutine test_product(error)
      type(error_type), allocatable, intent(out) :: error
      type(double_word) :: x, y

      x = double_word(2.0_wp**52 + 1)
      y = x*x
      call check(error, abs(y%hi - (2.0_wp**104 + 2.0_wp**53)) <= 0.0_wp .and. &
         abs(y%lo - 1) <= 0.0_wp)
   end subroutine test_product


   subroutine test_quotient(error)
      type(error_type), allocatable, intent(out) :: error
      type(double_word) :: x(1000), y(1000), z(1000)

      call random_words(x)
      call random_words(y)
      z = x/y*y - x
      call check(error, all(abs(z%hi) <= tolerance*x%hi))
   end subroutine test_quotient


   subroutine test_square_root(error)
      type(error_type), allocatable, intent(out) :: error
      type(double_word) :: x(1000), z(1000)

      call random_words(x)
      z = sqrt(x)*sqrt(x) - x
      call check(error, all(abs(z%hi) <= 2*tolerance*x%hi))
      if (allocated(error)) return
      z(1) = sqrt(double_word(0.0_wp))
      call check(error, abs(z(1)%hi) <= 0.0_wp)
   end subroutine test_square_root


   !> sin(pi/6) = 1/2, sin(pi/3) = sqrt(3)/2, sin(pi/2) = 1
   subroutine test_sine(error)
      type(error_type), allocatable, intent(out) :: error
      type(double_word) :: z(3)

      z = sin(double_word_pi/[double_word(6.0_wp), double_word(3.0_wp), double_word(2.0_wp)])
      z = z - [double_word(0.5_wp), sqrt(double_word(0.75_wp)), double_word(1.0_wp)]
      call check(error, all(abs(z%hi) <= 4*tolerance))
   end subroutine test_sine


   !> Both words random, in (1, 2)
   subroutine random_words(x)
      type(double_word), intent(out) :: x(:)
      real(wp) :: r(size(x), 2)

      call random_number(r)
      x%hi = 1 + r(:, 1)
      x%lo = epsilon(r)*(r(:, 2) - 0.5_wp)
   end subroutine random_words

end module test_double_word
