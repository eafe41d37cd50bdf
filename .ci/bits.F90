! SPDX-License-Identifier: MIT

!> The bits of every function by name on pseudo-random numbers, one at a time and in an array, to compare
!> builds; compiled with -DKIND=real64, say.
program bits
   use, intrinsic :: iso_fortran_env, only : int32, int64, wp => KIND
   use furiko_by_name, only : evaluate
   use furiko_catalogue, only : argument_count, catalogue, result_count
   implicit none
   integer, parameter :: rows = 64
   integer(int64) :: state
   real(wp), allocatable :: x(:, :), y(:, :), z(:)
   integer :: i, j, k

   state = 7
   do i = 1, size(catalogue)
      allocate(x(rows, argument_count(catalogue(i))), z(result_count(catalogue(i))))
      allocate(y(rows, size(z)))
      do k = 1, size(x, 2)
         do j = 1, rows
            x(j, k) = next()*merge(1, 12, mod(j, 4) < 2)
            if (mod(j, 2) == 0) x(j, k) = abs(x(j, k))
         end do
      end do
      call evaluate(catalogue(i)%name, x, y)
      print '(a, *(1x, z8.8))', trim(catalogue(i)%name), transfer(y, [0_int32])
      do j = 1, rows
         call evaluate(catalogue(i)%name, x(j, :), z)
         print '(*(z8.8, 1x))', transfer(z, [0_int32])
      end do
      deallocate(x, y, z)
   end do


contains


   !> Between -1 and 1, of 24 bits, the same in each kind of real
   function next() result(x)
      real(wp) :: x

      state = mod(state*16807_int64, 2147483647_int64)
      x = real(state/128, wp)/real(2147483647/256, wp) - 1
   end function next

end program bits
