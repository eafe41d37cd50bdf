! SPDX-License-Identifier: MIT

!> K, E, B, D in real32 are the numbers next to the exact values, of arrays and one at a time: a sample
!> of what `rounding/run` tells of all 2^32 arguments, and the hardest of a larger one
module test_rounding
   use, intrinsic :: iso_fortran_env, only : int32, int64, sp => real32, real64
   use, intrinsic :: ieee_arithmetic, only : ieee_is_nan
   use furiko, only : ellipk_k, ellipk_m, ellipk_mc, ellipe_k, ellipe_m, ellipe_mc, &
      ellipb_k, ellipb_m, ellipb_mc, ellipd_k, ellipd_m, ellipd_mc
   use testdrive, only : check, error_type, new_unittest, unittest_type
   implicit none
   private
   public :: collect_rounding


contains


   subroutine collect_rounding(testsuite)
      type(unittest_type), allocatable, intent(out) :: testsuite(:)

      testsuite = [ &
         new_unittest('sample', test_sample), &
         new_unittest('next-to-a-middle', test_middle)]
   end subroutine collect_rounding


   !> Every 16381st number, among them negative ones, infinity and NaN
   subroutine test_sample(error)
      type(error_type), allocatable, intent(out) :: error
      integer, parameter :: n = 4096
      integer(int64), parameter :: stride = 16381_int64
      real(sp) :: x(n)
      integer(int64) :: first
      integer :: i

      do first = -2_int64**31, 2_int64**31 - n*stride, n*stride
         x = [(transfer(int(first + i*stride, int32), 1.0_sp), i=0, n - 1)]
         call compare(error, 'k', x, ellipk_k(x), [(ellipk_k(x(i)), i=1, n)], ellipk_k(real(x, real64)))
         call compare(error, 'm', x, ellipk_m(x), [(ellipk_m(x(i)), i=1, n)], ellipk_m(real(x, real64)))
         call compare(error, 'mc', x, ellipk_mc(x), [(ellipk_mc(x(i)), i=1, n)], ellipk_mc(real(x, real64)))
         call compare(error, 'k', x, ellipe_k(x), [(ellipe_k(x(i)), i=1, n)], ellipe_k(real(x, real64)))
         call compare(error, 'm', x, ellipe_m(x), [(ellipe_m(x(i)), i=1, n)], ellipe_m(real(x, real64)))
         call compare(error, 'mc', x, ellipe_mc(x), [(ellipe_mc(x(i)), i=1, n)], ellipe_mc(real(x, real64)))
         call compare(error, 'k', x, ellipb_k(x), [(ellipb_k(x(i)), i=1, n)], ellipb_k(real(x, real64)))
         call compare(error, 'm', x, ellipb_m(x), [(ellipb_m(x(i)), i=1, n)], ellipb_m(real(x, real64)))
         call compare(error, 'mc', x, ellipb_mc(x), [(ellipb_mc(x(i)), i=1, n)], ellipb_mc(real(x, real64)))
         call compare(error, 'k', x, ellipd_k(x), [(ellipd_k(x(i)), i=1, n)], ellipd_k(real(x, real64)))
         call compare(error, 'm', x, ellipd_m(x), [(ellipd_m(x(i)), i=1, n)], ellipd_m(real(x, real64)))
         call compare(error, 'mc', x, ellipd_mc(x), [(ellipd_mc(x(i)), i=1, n)], ellipd_mc(real(x, real64)))
         if (allocated(error)) return
      end do
   end subroutine test_sample


   !> real64, right to 0.6 ulp, decides where it is not within 2 ulp of the middle between two real32
   subroutine compare(error, form, x, many, single, exact)
      type(error_type), allocatable, intent(inout) :: error
      character(len=*), intent(in) :: form
      real(sp), intent(in) :: x(:), many(:), single(:)
      real(real64), intent(in) :: exact(:)
      character(len=60) :: message
      integer(int64) :: dropped
      integer :: i
      logical :: right

      do i = 1, size(x)
         if (allocated(error)) return
         dropped = iand(transfer(exact(i), dropped), 2_int64**29 - 1)
         if (abs(dropped - 2_int64**28) <= 2) cycle
         if (ieee_is_nan(exact(i))) then
            right = ieee_is_nan(many(i)) .and. ieee_is_nan(single(i))
         else
            right = same(many(i), real(exact(i), sp)) .and. same(single(i), real(exact(i), sp))
         end if
         write(message, '(2a, es16.8, a, 2es16.8)') form, ' =', x(i), ' gives', many(i), single(i)
         call check(error, right, trim(message))
      end do
   end subroutine compare


   elemental function same(a, b)
      real(sp), intent(in) :: a, b
      logical :: same

      same = transfer(a, 1_int32) == transfer(b, 1_int32)
   end function same


   !> Values next to the middle between two real32, 2^-22.8 to 2^-30.2 ulp from it. Of the third, fifth
   !> and tenth the kernel's polynomials are on the wrong side; expected values by mpmath with 300 bits
   subroutine test_middle(error)
      type(error_type), allocatable, intent(out) :: error
      real(sp), parameter :: x(12) = [0.745175779_sp, -62895684.0_sp, 0.707443714_sp, &
         2.01176124e-4_sp, -15.5973902_sp, 4.61168574e18_sp, 0.959581196_sp, -2.10868935e21_sp, &
         32306.8359_sp, 0.445957184_sp, -2.69812279e-8_sp, 3.35242937e18_sp]
      real(sp), parameter :: exact(12) = [1.90398276_sp, 1.30692299e-3_sp, 1.70956147_sp, &
         1.57079637_sp, 4.36006165_sp, 2.14748352e9_sp, 0.949528873_sp, 5.43036116e-10_sp, &
         0.0310331658_sp, 0.852507114_sp, 0.785398126_sp, 5.46160339e-10_sp]

      call check(error, all(same(exact, [ &
         ellipk_k(x(1)), ellipk_m(x(2)), ellipk_mc(x(3)), ellipe_k(x(4)), ellipe_m(x(5)), ellipe_mc(x(6)), &
         ellipb_k(x(7)), ellipb_m(x(8)), ellipb_mc(x(9)), ellipd_k(x(10)), ellipd_m(x(11)), &
         ellipd_mc(x(12))])))
      if (allocated(error)) return
      call check(error, all(same(exact, [ &
         ellipk_k(x(1:1)), ellipk_m(x(2:2)), ellipk_mc(x(3:3)), ellipe_k(x(4:4)), ellipe_m(x(5:5)), &
         ellipe_mc(x(6:6)), ellipb_k(x(7:7)), ellipb_m(x(8:8)), ellipb_mc(x(9:9)), ellipd_k(x(10:10)), &
         ellipd_m(x(11:11)), ellipd_mc(x(12:12))])))
   end subroutine test_middle
end module test_rounding
