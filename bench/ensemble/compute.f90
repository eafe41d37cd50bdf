! SPDX-License-Identifier: MIT

!> What computing a chunk costs, without any file: ns a member, of each subject, with few periods and steps,
!> with more steps, and with more periods, by one thread and by two. For measure.py, which takes it apart.
program compute_chunks
   use, intrinsic :: iso_fortran_env, only : int64, wp => real64
   use furiko_ensemble_compute, only : compute
   use furiko_ensemble_sweep, only : quantities, quantity, scheme_of, sweep
   use omp_lib, only : omp_set_num_threads
   implicit none
   integer, parameter :: repeats = 9, members = 16384, periods(3) = [16, 16, 64], steps(3) = [1, 9, 1]
   character(len=*), parameter :: subjects(3) = [character(len=11) :: 'bifurcation', 'lyapunov', 'winding']
   real(wp) :: times(repeats, size(subjects), 3, 2)
   integer :: i, j, k, n

   ! One after the other, again and again, so that a disturbance meets all of them
   do n = 1, repeats
      do k = 1, 2
         do j = 1, size(steps)
            do i = 1, size(subjects)
               times(n, i, j, k) = cost_of(trim(subjects(i)), periods(j), steps(j), k)
            end do
         end do
      end do
   end do
   do i = 1, size(subjects)
      do j = 1, size(steps)
         do k = 1, 2
            print '(a, 3(1x, i0), *(1x, f0.1))', trim(subjects(i)), periods(j), steps(j), k, times(:, i, j, k)
         end do
      end do
   end do


contains


   !> Nanoseconds a member
   function cost_of(subject, periods, steps, threads) result(cost)
      character(len=*), intent(in) :: subject
      integer, intent(in) :: periods
      integer, intent(in) :: steps
      integer, intent(in) :: threads
      real(wp) :: cost
      type(sweep) :: asked
      type(quantity), allocatable :: results(:)
      integer(int64) :: first, last, rate

      asked = sweep(subject, 'order8', steps, [0.5_wp, 0.0_wp, 0.0_wp, 1.2_wp, 2.0_wp/3, 0.0_wp], vary=4, &
         from=1.0_wp, to=1.1_wp, points=members, periods=periods, chunk=members)
      results = quantities(asked)
      call omp_set_num_threads(threads)
      call system_clock(first, rate)
      call compute(asked, scheme_of(asked), 0_int64, results)
      call system_clock(last)
      cost = real(last - first, wp)/real(rate, wp)*1e9_wp/members
   end function cost_of
end program compute_chunks
