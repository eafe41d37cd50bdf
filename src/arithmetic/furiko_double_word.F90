! SPDX-License-Identifier: MIT
#include "furiko_compiler.inc"

!> Double-word arithmetic ("double-double"): a number is the unevaluated sum of two real64,
!> the second at most half an ulp of the first: about 106 bits or 32 digits, everywhere,
!> also where a compiler has no real128.
!>
!> Relative errors stay below 2^-100 (sum, product, quotient, square root; sine below 2^-98),
!> with and without FMA contraction. Numbers near the ends of real64's range are not for here.
!>
!> Source: Joldes, Muller, Popescu, Tight and rigorous error bounds for basic building blocks
!> of double-word arithmetic, ACM TOMS 44 (2017) 15.
module furiko_double_word
   use, intrinsic :: iso_fortran_env, only : ip => int64, wp => real64
   implicit none
   private
   public :: double_word, double_word_pi
   public :: operator(+), operator(-), operator(*), operator(/), sqrt, sin


   !> The number hi + lo; `double_word(x)` is x itself.
   type :: double_word
      !> The number rounded to working precision
      real(wp) :: hi = 0.0_wp
      !> What the rounding left
      real(wp) :: lo = 0.0_wp
   end type double_word


   !> pi to 32 digits
   type(double_word), parameter :: double_word_pi = &
      double_word(acos(-1.0_wp), 1.2246467991473531772260659322749980e-16_wp)


   interface operator(+)
      module procedure :: add
   end interface operator(+)

   interface operator(-)
      module procedure :: subtract
   end interface operator(-)

   interface operator(*)
      module procedure :: multiply
   end interface operator(*)

   interface operator(/)
      module procedure :: divide
   end interface operator(/)

   interface sqrt
      module procedure :: square_root
   end interface sqrt

   !> Sine of an angle between -pi/2 and pi/2
   interface sin
      module procedure :: sine
   end interface sin


contains


   elemental function add(x, y) result(z)
      type(double_word), intent(in) :: x
      type(double_word), intent(in) :: y
      type(double_word) :: z
      type(double_word) :: s, t

      s = two_sum(x%hi, y%hi)
      t = two_sum(x%lo, y%lo)
      z = fast_two_sum(s%hi, s%lo + t%hi)
      z = fast_two_sum(z%hi, z%lo + t%lo)
   end function add


   elemental function subtract(x, y) result(z)
      type(double_word), intent(in) :: x
      type(double_word), intent(in) :: y
      type(double_word) :: z

      z = add(x, double_word(-y%hi, -y%lo))
   end function subtract


   elemental function multiply(x, y) result(z)
      type(double_word), intent(in) :: x
      type(double_word), intent(in) :: y
      type(double_word) :: z

      z = two_product(x%hi, y%hi)
      z = fast_two_sum(z%hi, z%lo + (x%hi*y%lo + x%lo*y%hi))
   end function multiply


   !> Long division: two digits of base 2^53, each the quotient of what is left.
   elemental function divide(x, y) result(z)
      type(double_word), intent(in) :: x
      type(double_word), intent(in) :: y
      type(double_word) :: z
      type(double_word) :: rest
      real(wp) :: first

      first = x%hi/y%hi
      rest = x - y*double_word(first)
      z = fast_two_sum(first, rest%hi/y%hi)
   end function divide


   !> One Newton step from the square root of the first word; sqrt(0) = 0.
   elemental function square_root(x) result(z)
      type(double_word), intent(in) :: x
      type(double_word) :: z
      type(double_word) :: rest
      real(wp) :: first

      first = sqrt(x%hi)
      z = double_word(first)
      if (.not. first > 0.0_wp) return
      rest = x - two_product(first, first)
      z = fast_two_sum(first, rest%hi/(2.0_wp*first))
   end function square_root


   !> Taylor's series; 15 terms leave (pi/2)^31/31! = 1e-28 of the last one's place, 17 nothing.
   elemental function sine(x) result(z)
      type(double_word), intent(in) :: x
      type(double_word) :: z
      integer, parameter :: terms = 17
      type(double_word) :: minus_x2
      integer :: n

      minus_x2 = double_word(0.0_wp) - x*x
      z = double_word(1.0_wp)
      do n = terms, 1, -1
         z = double_word(1.0_wp) + minus_x2*z/double_word(real(2*n*(2*n + 1), wp))
      end do
      z = x*z
   end function sine


   !> a + b exactly (Knuth).
   elemental function two_sum(a, b) result(s)
      real(wp), intent(in) :: a
      real(wp), intent(in) :: b
      type(double_word) :: s
      real(wp) :: from_b

      s%hi = a + b
      from_b = s%hi - a
      s%lo = (a - (s%hi - from_b)) + (b - from_b)
   end function two_sum


   !> a + b exactly, if |a| >= |b| or a = 0 (Dekker).
   elemental function fast_two_sum(a, b) result(s)
      real(wp), intent(in) :: a
      real(wp), intent(in) :: b
      type(double_word) :: s

      s%hi = a + b
      s%lo = b - (s%hi - a)
   end function fast_two_sum


   !> a*b to 2^-106. Its parts are exact products, so that a compiler that contracts a product and
   !> a sum to one FMA changes nothing; the usual a*b - hi is not safe from that.
   elemental function two_product(a, b) result(p)
      real(wp), intent(in) :: a
      real(wp), intent(in) :: b
      type(double_word) :: p
      type(double_word) :: s, t
      real(wp) :: a_hi, a_lo, b_hi, b_lo

      a_hi = head(a)
      a_lo = a - a_hi
      b_hi = head(b)
      b_lo = b - b_hi
      s = two_sum(a_hi*b_hi, a_hi*b_lo)
      t = two_sum(s%hi, a_lo*b_hi)
      p = fast_two_sum(t%hi, s%lo + t%lo + a_lo*b_lo)
   end function two_product


#include "furiko_bits.inc"
   include 'furiko_head.inc'
end module furiko_double_word
! rooms: 1959053824
