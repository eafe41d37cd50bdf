! SPDX-License-Identifier: MIT

!> Positive numbers of as many digits as are asked for: what is left of a huge argument when all
!> periods are taken from it. Internal, for rare paths.
!>
!> A number is the sum of limb(i) base^(e - i), i = 1, 2, ..., the limbs whole numbers below the base,
!> the first one not 0 (but that of 0). Every procedure is told how many limbs count, n; what it
!> returns is cut there, so that it errs by less than a unit of limb n - 1. Products of limbs are added
!> up in int64: n of 2^48 each, and n <= most_limbs.
module furiko_long_numbers
   use, intrinsic :: iso_fortran_env, only : int64, real64
   implicit none
   private
   public :: long_number, most_limbs, limb_bits
   public :: long_half, long_sum, long_difference, long_product, long_root, long_mean, two_over_pi_long

   include 'furiko_two_over_pi.inc'

   integer, parameter :: limb_bits = 24
   integer(int64), parameter :: base = 2_int64**limb_bits
   real(real64), parameter :: real_base = real(base, real64)

   !> As many limbs as are known of 2/pi
   integer, parameter :: most_limbs = size(two_over_pi)

   type :: long_number
      integer :: e = 0
      integer(int64) :: limb(most_limbs)
   end type long_number


contains


   !> 2/pi
   pure function two_over_pi_long(n) result(x)
      integer, intent(in) :: n
      type(long_number) :: x
      x%e = 0
      x%limb(:n) = two_over_pi(:n)
   end function two_over_pi_long


   !> The sum of column(j) base^(e - j), j = 0, 1, ..., n + 1, which is not negative
   pure function from_columns(n, e, column) result(x)
      integer, intent(in) :: n, e
      integer(int64), intent(in) :: column(0:most_limbs + 1)
      type(long_number) :: x
      integer(int64) :: c(0:most_limbs + 1)
      integer :: j, zeros
      c(:n + 1) = column(:n + 1)
      do j = n + 1, 1, -1
         c(j - 1) = c(j - 1) + shifta(c(j), limb_bits)
         c(j) = iand(c(j), base - 1)
      end do
      do zeros = 0, n
         if (c(zeros) /= 0) exit
      end do
      x%e = e + 1 - zeros
      do j = 1, n
         x%limb(j) = 0
         if (j + zeros <= n + 2) x%limb(j) = c(j + zeros - 1)
      end do
   end function from_columns


   pure function long_half(n, x) result(z)
      integer, intent(in) :: n
      type(long_number), intent(in) :: x
      type(long_number) :: z
      integer(int64) :: c(0:most_limbs + 1)
      c(0) = 0
      c(1:n) = x%limb(:n)*(base/2)
      c(n + 1) = 0
      z = from_columns(n, x%e - 1, c)
   end function long_half


   !> x + y
   pure function long_sum(n, x, y) result(z)
      integer, intent(in) :: n
      type(long_number), intent(in) :: x, y
      type(long_number) :: z
      if (x%e >= y%e) then
         z = added(n, x, y, 1)
      else
         z = added(n, y, x, 1)
      end if
   end function long_sum


   !> x - y for x >= y
   pure function long_difference(n, x, y) result(z)
      integer, intent(in) :: n
      type(long_number), intent(in) :: x, y
      type(long_number) :: z
      z = added(n, x, y, -1)
   end function long_difference


   !> x + y or x - y for x >= y, or nearly: e of x is not below that of y
   pure function added(n, x, y, sign_y) result(z)
      integer, intent(in) :: n
      type(long_number), intent(in) :: x, y
      integer, intent(in) :: sign_y
      type(long_number) :: z
      integer(int64) :: c(0:most_limbs + 1)
      integer :: j, behind
      behind = x%e - y%e
      c(0) = 0
      c(1:n) = x%limb(:n)
      c(n + 1) = 0
      do j = 1 + behind, n + 1
         if (j - behind <= n) c(j) = c(j) + sign_y*y%limb(j - behind)
      end do
      z = from_columns(n, x%e, c)
   end function added


   !> x y
   pure function long_product(n, x, y) result(z)
      integer, intent(in) :: n
      type(long_number), intent(in) :: x, y
      type(long_number) :: z
      integer(int64) :: c(0:most_limbs + 1)
      integer :: i, j
      c(:n + 1) = 0
      do i = 1, n
         do j = 1, min(n, n + 2 - i)
            c(i + j - 1) = c(i + j - 1) + x%limb(i)*y%limb(j)
         end do
      end do
      z = from_columns(n, x%e + y%e - 1, c)
   end function long_product


   !> The square root of x > 0, limb by limb as by hand: what is left over twice the root so far is the
   !> next one. Limbs of both signs on the way, so that none needs to be taken back.
   pure function long_root(n, x) result(z)
      integer, intent(in) :: n
      type(long_number), intent(in) :: x
      type(long_number) :: z
      integer(int64) :: rest(most_limbs + 2), s(0:most_limbs + 1)
      real(real64) :: root
      integer :: i, j, odd
      odd = iand(x%e, 1)
      rest(:n + 2) = 0
      rest(1 + odd:n + odd) = x%limb(:n)
      s(:n + 1) = 0
      root = sqrt(leading(rest(1:4)))
      s(1) = nint(root, int64)
      s(2) = nint((root - real(s(1), real64))*real_base, int64)
      rest(2:4) = rest(2:4) - [s(1)*s(1), 2*s(1)*s(2), s(2)*s(2)]
      do i = 3, n + 1
         call carry(n + 2, rest)
         s(i) = nint(leading(rest(i - 1:min(i + 2, n + 2)))*(0.5_real64*real_base/root), int64)
         do j = 1, min(i - 1, n + 2 - i)
            rest(i + j) = rest(i + j) - 2*s(i)*s(j)
         end do
         if (2*i <= n + 2) rest(2*i) = rest(2*i) - s(i)*s(i)
      end do
      z = from_columns(n, (x%e + odd)/2, s)
   end function long_root


   !> c(1) base + c(2) + c(3)/base + ...
   pure function leading(c) result(x)
      integer(int64), intent(in) :: c(:)
      real(real64) :: x
      integer :: i
      x = 0
      do i = size(c), 1, -1
         x = x/real_base + real(c(i), real64)
      end do
      x = x*real_base
   end function leading


   !> All but the first between -base/2 and base/2
   pure subroutine carry(n, c)
      integer, intent(in) :: n
      integer(int64), intent(inout) :: c(n)
      integer(int64) :: t
      integer :: j
      do j = n, 2, -1
         t = shifta(c(j) + base/2, limb_bits)
         c(j) = c(j) - t*base
         c(j - 1) = c(j - 1) + t
      end do
   end subroutine carry


   !> Arithmetic-geometric mean of a >= b > 0. The digits that agree double in each step, before
   !> which the ratio's exponent is halved: 64 steps are more than any pair takes.
   pure function long_mean(n, a, b) result(g)
      integer, intent(in) :: n
      type(long_number), intent(in) :: a, b
      type(long_number) :: g
      type(long_number) :: x, y, gap
      integer :: i
      integer, parameter :: most_steps = 64
      x = a
      y = b
      do i = 1, most_steps
         g = long_half(n, long_sum(n, x, y))
         gap = long_difference(n, g, y)
         if (gap%limb(1) == 0 .or. gap%e < g%e - n/2 - 1) exit
         y = long_root(n, long_product(n, x, y))
         x = g
      end do
   end function long_mean

end module furiko_long_numbers
! rooms: 3428860256
