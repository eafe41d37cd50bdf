! SPDX-License-Identifier: MIT

!> furiko-rounding FUNCTION PART PARTS: compares ellipk_m and its like in real32, of arrays and one at a
!> time, with the nearest real32 to the exact value, for each of the 2^32 arguments or one of so many
!> equal parts of them. Writes one line: arguments that are numbers and in the domain, those that
!> real64 does not decide, the wrong ones, then the least distance from a middle between two real32
!> numbers, in units of the last place. `rounding/run` adds up.
!>
!> The real64 function is right to 0.6 ulp; where its value is 2 ulp from such a middle or nearer, the
!> real128 function, right to 4 ulp of its own, decides.
program main
   use, intrinsic :: iso_fortran_env, only : error_unit, int32, int64, sp => real32, dp => real64, &
      qp => real128
   use furiko, only : ellipk_k, ellipk_m, ellipk_mc, ellipe_k, ellipe_m, ellipe_mc, &
      ellipb_k, ellipb_m, ellipb_mc, ellipd_k, ellipd_m, ellipd_mc
   implicit none
   integer, parameter :: block = 2**12
   integer, parameter :: dropped = digits(1.0_dp) - digits(1.0_sp)
   character(len=*), parameter :: names(*) = [character(len=9) :: 'ellipk_k', 'ellipk_m', 'ellipk_mc', &
      'ellipe_k', 'ellipe_m', 'ellipe_mc', 'ellipb_k', 'ellipb_m', 'ellipb_mc', &
      'ellipd_k', 'ellipd_m', 'ellipd_mc']
   character(len=32) :: name, word
   integer(int64) :: part, parts, start, counted, undecided, wrong
   real(dp) :: least
   real(sp) :: x(block)
   integer :: which, i

   call get_command_argument(1, name)
   which = findloc(names, name, 1)
   if (which == 0) error stop 'furiko-rounding: no such function'
   call get_command_argument(2, word)
   read(word, *) part
   call get_command_argument(3, word)
   read(word, *) parts
   counted = 0
   undecided = 0
   wrong = 0
   least = 1.0_dp
   do start = part*block, 2_int64**32 - 1, parts*block
      do i = 1, block
         x(i) = transfer(bits32(start + i - 1), 1.0_sp)
      end do
      call check_block(x)
   end do
   print '(a, 3(1x, i0), es10.2)', trim(name), counted, undecided, wrong, least


contains


   subroutine check_block(x)
      real(sp), intent(in) :: x(block)
      real(sp) :: f(block), f_one, right
      real(dp) :: g(block)
      integer :: j

      call values_sp(x, f)
      call values_dp(real(x, dp), g)
      do j = 1, block
         f_one = one_sp(x(j))
         if (g(j) /= g(j)) then
            if (f(j) == f(j) .or. f_one == f_one) call report(x(j), f(j), f_one, real(g(j), sp))
            cycle
         end if
         counted = counted + 1
         right = real(g(j), sp)
         if (from_middle(g(j)) <= 2) right = by_real128(x(j))
         if (.not. (f(j) == right .and. f_one == right)) call report(x(j), f(j), f_one, right)
      end do
   end subroutine check_block


   !> How many units of real64's last place a number is from the next middle between two real32
   elemental function from_middle(g) result(distance)
      real(dp), intent(in) :: g
      integer(int64) :: distance

      distance = abs(iand(transfer(g, distance), 2_int64**dropped - 1) - 2_int64**(dropped - 1))
   end function from_middle


   !> The nearest real32 by real128; no value may be as near to a middle as real128 is wrong
   function by_real128(x) result(right)
      real(sp), intent(in) :: x
      real(sp) :: right
      real(qp) :: exact, middle, error

      exact = one_qp(real(x, qp))
      right = real(exact, sp)
      error = exact - right
      middle = 0.5_qp*(real(right, qp) + neighbour(right, error))
      undecided = undecided + 1
      least = min(least, real(abs(exact - middle)/spacing(right), dp))
      if (abs(exact - middle) <= 8*spacing(exact)) then
         write(error_unit, *) trim(name), x, ' is not decided by real128'
         wrong = wrong + 1
      end if
   end function by_real128


   !> The real32 on that side of another where `error` says
   function neighbour(f, error) result(other)
      real(sp), intent(in) :: f
      real(qp), intent(in) :: error
      real(qp) :: other

      other = nearest(f, merge(1.0_sp, -1.0_sp, error > 0.0_qp))
   end function neighbour


   subroutine report(x, f, f_one, expected)
      real(sp), intent(in) :: x, f, f_one, expected

      wrong = wrong + 1
      if (wrong <= 10) write(error_unit, '(a, 4es16.8)') &
         trim(name) // ': argument, array, scalar, nearest:', x, f, f_one, expected
   end subroutine report


   !> The lowest 32 bits
   elemental function bits32(i) result(bits)
      integer(int64), intent(in) :: i
      integer(int32) :: bits

      bits = int(merge(i - 2_int64**32, i, i >= 2_int64**31), int32)
   end function bits32


   subroutine values_sp(x, f)
      real(sp), intent(in) :: x(:)
      real(sp), intent(out) :: f(:)

      include 'cases.inc'
   end subroutine values_sp


   subroutine values_dp(x, f)
      real(dp), intent(in) :: x(:)
      real(dp), intent(out) :: f(:)

      include 'cases.inc'
   end subroutine values_dp


   function one_sp(x) result(f)
      real(sp), intent(in) :: x
      real(sp) :: f

      include 'cases.inc'
   end function one_sp


   function one_qp(x) result(f)
      real(qp), intent(in) :: x
      real(qp) :: f

      include 'cases.inc'
   end function one_qp
end program main
! rooms: 1115038769
