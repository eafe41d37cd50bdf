! SPDX-License-Identifier: MIT

!> Many threads share one modulus, and each gets bit by bit what one thread gets alone. Say
!> --flag -fopenmp.
program main
   use, intrinsic :: iso_fortran_env, only : int64, wp => real64
   use furiko, only : jacobi_m, modulus, modulus_from_mc, theta3
   use omp_lib, only : omp_get_num_threads
   implicit none
   integer, parameter :: n = 2000, rounds = 16, part = 100
   real(wp), parameter :: mcs(*) = [1.0e-300_wp, 1.0e-6_wp, 0.5_wp, 3.0_wp]
   real(wp) :: u(n), alone(n, 5), shared(n, 5)
   type(modulus) :: p
   integer :: i, j, different, threads

   call random_number(u)
   u = 1.0e3_wp*(u - 0.5_wp)
   threads = 0
   different = 0
   do j = 1, size(mcs)
      p = modulus_from_mc(mcs(j))
      call work(p, u, alone)
      !$omp parallel default(none) shared(p, u, alone) private(shared) reduction(max : threads) &
      !$omp reduction(+ : different)
      threads = max(threads, omp_get_num_threads())
      !$omp do schedule(dynamic)
      do i = 1, rounds
         call work(p, u, shared)
         different = different + count(bits(shared) /= bits(alone))
      end do
      !$omp end do
      !$omp end parallel

      ! One array, its parts one after another and side by side
      do i = 1, n, part
         call work(p, u(i:i + part - 1), alone(i:i + part - 1, :))
      end do
      !$omp parallel do default(none) shared(p, u, shared) schedule(dynamic)
      do i = 1, n, part
         call work(p, u(i:i + part - 1), shared(i:i + part - 1, :))
      end do
      !$omp end parallel do
      different = different + count(bits(shared) /= bits(alone))
   end do
   print '(i0, a)', different, ' values differ'
   if (threads < 2) error stop 'one thread only'
   if (different > 0) error stop 'threads disturb one another'


contains


   !> What the modulus tells of each u, the scalars among it, and one value of a function without
   subroutine work(p, u, f)
      type(modulus), intent(in) :: p
      real(wp), intent(in) :: u(:)
      real(wp), intent(out) :: f(:, :)
      integer :: i

      call p%jacobi(u, f(:, 1), f(:, 2), f(:, 3))
      do i = 1, size(u)
         f(i, 4) = p%am(u(i)) + p%epsilon(u(i))
      end do
      call jacobi_m(u(1), 0.3_wp, f(1, 5), f(2, 5), f(3, 5))
      f(4:, 5) = theta3(u(4:), 0.6_wp)
   end subroutine work


   elemental function bits(x) result(i)
      real(wp), intent(in) :: x
      integer(int64) :: i

      i = transfer(x, i)
   end function bits

end program main
