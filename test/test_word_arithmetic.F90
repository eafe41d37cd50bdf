! SPDX-License-Identifier: MIT
#include "../src/arithmetic/furiko_compiler.inc"

!> Arithmetic on words of real64: exact identities, 30 digits of known numbers, real128 where there is one.
module test_word_arithmetic
   use, intrinsic :: iso_fortran_env, only : wp => real64
#ifdef FURIKO_REAL128
   use, intrinsic :: iso_fortran_env, only : qp => real128
#endif
   use furiko_word_arithmetic_dp, only : words, pi_words, mean_with_one, sqrt, sin, &
      operator(+), operator(-), operator(*), operator(/)
   use testdrive, only : check, error_type, new_unittest, unittest_type
   implicit none
   private
   public :: collect_word_arithmetic


   !> 2^-99
   real(wp), parameter :: tolerance = 1.6e-30_wp


contains


   subroutine collect_word_arithmetic(testsuite)
      type(unittest_type), allocatable, intent(out) :: testsuite(:)

      testsuite = [ &
         new_unittest('sum-keeps-small-terms', test_sum), &
         new_unittest('product-is-exact', test_product), &
         new_unittest('quotient', test_quotient), &
         new_unittest('square-root', test_square_root), &
         new_unittest('sine', test_sine), &
         new_unittest('arithmetic-geometric-mean', test_mean)]
#ifdef FURIKO_REAL128
      testsuite = [testsuite, new_unittest('beside-real128', test_beside_real128)]
#endif
   end subroutine collect_word_arithmetic


   subroutine test_sum(error)
      type(error_type), allocatable, intent(out) :: error
      type(words) :: x

      x = words(1.0_wp) + words(1.0e-25_wp) - words(1.0_wp)
      call check(error, abs(x%hi - 1.0e-25_wp) <= 1.0e-32_wp)
      if (allocated(error)) return
      x = words(3.0_wp, 1.0e-20_wp) - words(3.0_wp, 1.0e-20_wp)
      call check(error, abs(x%hi) <= 0.0_wp .and. abs(x%lo) <= 0.0_wp)
      if (allocated(error)) return
      ! where the first words cancel, what is below epsilon^2 of them may go
      x = words(1.0_wp, 2.0_wp**(-54)) + words(-1.0_wp, 2.0_wp**(-104))
      call check(error, abs(x%hi - 2.0_wp**(-54)) <= 2.0_wp**(-104) .and. &
         abs((x%hi - 2.0_wp**(-54)) + x%lo - 2.0_wp**(-104)) <= 0.0_wp)
      if (allocated(error)) return
      ! less one word nothing goes
      x = words(1.25_wp, 2.0_wp**(-54) + 2.0_wp**(-106)) - 1.0_wp
      call check(error, abs(x%hi - 0.25_wp - 2.0_wp**(-54)) <= 0.0_wp .and. &
         abs(x%lo - 2.0_wp**(-106)) <= 0.0_wp)
   end subroutine test_sum


   !> (2^52 + 1)^2 = 2^104 + 2^53 + 1: a plain product loses the last term, a contracted
   !> error term both
   subroutine test_product(error)
      type(error_type), allocatable, intent(out) :: error
      type(words) :: x, y

      x = words(2.0_wp**52 + 1)
      y = x*x
      call check(error, abs(y%hi - (2.0_wp**104 + 2.0_wp**53)) <= 0.0_wp .and. &
         abs(y%lo - 1) <= 0.0_wp)
   end subroutine test_product


   subroutine test_quotient(error)
      type(error_type), allocatable, intent(out) :: error
      type(words) :: x(1000), y(1000), z(1000)

      call random_words(x)
      call random_words(y)
      z = x/y*y - x
      call check(error, all(abs(z%hi) <= tolerance*x%hi))
   end subroutine test_quotient


   subroutine test_square_root(error)
      type(error_type), allocatable, intent(out) :: error
      type(words) :: x(1000), z(1000)

      call random_words(x)
      z = sqrt(x)*sqrt(x) - x
      call check(error, all(abs(z%hi) <= 2*tolerance*x%hi))
      if (allocated(error)) return
      z(1) = sqrt(words(0.0_wp))
      call check(error, abs(z(1)%hi) <= 0.0_wp .and. abs(z(1)%lo) <= 0.0_wp)
   end subroutine test_square_root


   !> sin(pi/6) = 1/2, sin(pi/3) = sqrt(3)/2, sin(pi/2) = 1
   subroutine test_sine(error)
      type(error_type), allocatable, intent(out) :: error
      type(words) :: z(3)

      z = sin(pi_words/[6.0_wp, 3.0_wp, 2.0_wp])
      z = z - [words(0.5_wp), sqrt(words(0.75_wp)), words(1.0_wp)]
      call check(error, all(abs(z%hi) <= 4*tolerance))
   end subroutine test_sine


   !> M(1, b), after two steps and in the end, and the sum of 2^(n - 1) c_n^2, by mpmath 1.4.1
   subroutine test_mean(error)
      type(error_type), allocatable, intent(out) :: error
      type(words) :: a(3), d(3), s(3)

      call mean_with_one(words([0.5_wp, 2.0_wp**(-1000), 3.0_wp]), a, s)
      d = a - [words(0.7283955155234534_wp, 4.945050030370928e-17_wp), &
         words(0.0022616567573987994_wp, -9.725089995658916e-20_wp), &
         words(1.8636167832448964_wp, 1.0692153207498955e-16_wp)]
      call check(error, all(abs(d%hi) <= 4*tolerance*a%hi))
      if (allocated(error)) return
      d = s - [words(0.06342001379743763_wp, -6.926721026129995e-18_wp), &
         words(0.4985601845899312_wp, -2.568730768841109e-18_wp), &
         words(1.0359215756946922_wp, 5.985421083329513e-17_wp)]
      call check(error, all(abs(d%hi) <= 4*tolerance*s%hi))
      if (allocated(error)) return
      call mean_with_one(words(0.5_wp), a(1), steps=2)
      d(1) = a(1) - (words(0.375_wp) + 0.5_wp*sqrt(words(0.5_wp)))
      call check(error, abs(d(1)%hi) <= tolerance)
   end subroutine test_mean


#ifdef FURIKO_REAL128
   !> Every operation on random numbers, far from the ends of the range, to 8 epsilon^2; of a sum the error is
   !> measured by the larger operand
   subroutine test_beside_real128(error)
      type(error_type), allocatable, intent(out) :: error
      integer, parameter :: n = 10000
      type(words) :: x(n), y(n)
      real(wp) :: r(n)
      real(qp) :: a(n), b(n)

      call random_words(x)
      call random_words(y)
      call random_number(r)
      r = scale(sign(1.0_wp, r - 0.25_wp), nint(20*r) - 10)
      y%hi = r*y%hi
      y%lo = r*y%lo
      a = wide(x)
      b = wide(y)
      call expect(x + y, a + b, max(abs(a), abs(b)))
      call expect(x - y, a - b, max(abs(a), abs(b)))
      call expect(x + abs(r), a + abs(r), max(a, real(abs(r), qp)))
      call expect(x*y, a*b, abs(a*b))
      call expect(x/y, a/b, abs(a/b))
      call expect(abs(r)/x, abs(r)/a, abs(r)/a)
      call expect(sqrt(x), sqrt(a), sqrt(a))
      call expect(sin(x - 1.0_wp), sin(a - 1), sin(a - 1))


   contains


      subroutine expect(z, exact, measure)
         type(words), intent(in) :: z(:)
         real(qp), intent(in) :: exact(:), measure(:)

         if (allocated(error)) return
         call check(error, all(abs(wide(z) - exact) <= 2.0_qp**(-101)*measure) .and. &
            all(abs(z%lo) <= spacing(z%hi)))
      end subroutine expect

   end subroutine test_beside_real128


   elemental function wide(x) result(z)
      type(words), intent(in) :: x
      real(qp) :: z

      z = real(x%hi, qp) + real(x%lo, qp)
   end function wide
#endif


   !> Both words random, in (1, 2)
   subroutine random_words(x)
      type(words), intent(out) :: x(:)
      real(wp) :: r(size(x), 2)

      call random_number(r)
      x%hi = 1 + r(:, 1)
      x%lo = epsilon(r)*(r(:, 2) - 0.5_wp)
   end subroutine random_words

end module test_word_arithmetic
! rooms: 3759241635
