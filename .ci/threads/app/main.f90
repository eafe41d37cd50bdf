! SPDX-License-Identifier: MIT

!> Many threads share one modulus, and each gets bit by bit what one thread gets alone. Say
!> --flag -fopenmp.
program main
   use, intrinsic :: iso_fortran_env, only : int64, wp => real64
   use furiko, only : driven_block, driven_exponents, driven_order8, driven_pendulum, driven_periods, &
      driven_state, jacobi_m, modulus, modulus_from_mc, theta3
   use omp_lib, only : omp_get_max_threads, omp_get_num_threads, omp_set_num_threads
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
   different = different + driven_differences()
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


   !> Driven pendulums, which share their members among threads themselves: by one thread and by all
   function driven_differences() result(different)
      integer, parameter :: members = 5*driven_block + 7
      integer :: different
      type(driven_pendulum) :: pendulum(members)
      type(driven_state) :: state(members)
      real(wp) :: f(members, 5, 2), exponents(2, members)
      integer :: i, all_threads

      all_threads = omp_get_max_threads()
      pendulum = driven_pendulum(damping=0.5_wp, amplitude=1.15_wp, frequency=2/3.0_wp)
      pendulum%torque = [(0.001_wp*i, i=1, members)]
      do i = 1, 2
         call omp_set_num_threads(merge(1, all_threads, i == 1))
         state = driven_state(0.1_wp, 0.2_wp)
         call driven_periods(driven_order8(24), pendulum, state, 40)
         call driven_exponents(driven_order8(24), pendulum, state, 4, 32, exponents, f(:, 5, i))
         f(:, 1, i) = state%angle
         f(:, 2, i) = state%rate
         f(:, 3:4, i) = transpose(exponents)
      end do
      different = count(bits(f(:, :, 1)) /= bits(f(:, :, 2)))
   end function driven_differences


   elemental function bits(x) result(i)
      real(wp), intent(in) :: x
      integer(int64) :: i

      i = transfer(x, i)
   end function bits

end program main
