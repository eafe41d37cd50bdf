! SPDX-License-Identifier: MIT
#include "../arithmetic/furiko_compiler.inc"

!> Lyapunov exponents of driven pendulums
module furiko_driven_lyapunov
   use, intrinsic :: iso_fortran_env, only : wp => real64
   use furiko_bits_dp, only : nan
   use furiko_driven_scheme, only : driven_scheme
   use furiko_driven_steps, only : driven_block, driven_pendulum, driven_ran, driven_state, driven_steps
   implicit none
   private
   public :: driven_exponents

   ! Parts of a run from which its error is estimated
   integer, parameter :: batches = 16


contains


   !> Both Lyapunov exponents of each member, natural logarithms for each unit of time, and the standard
   !> error of the first one.
   !>
   !> Two tangent vectors go along and are made orthogonal again once a period (Gram-Schmidt). Their sum is
   !> -b where there is no quadratic damping. On a cycle of n periods they are ln|multiplier|/(n T). The error
   !> is estimated from 16 equal parts of the run, as if these were independent, so they should be much longer
   !> than the attractor remembers; on a cycle it is no more than rounding. What it cannot see is an attractor
   !> other than the one that the start led to. Threads share the members; the results do not depend on them.
   !>
   !> NaN for a member that stops on its way. The second exponent is lost in rounding where the two vectors
   !> become parallel within a period: where exp(-b T) is below 1e-16.
   !> Source: Benettin, Galgani, Giorgilli, Strelcyn, Meccanica 15 (1980) 9 and 21.
   subroutine driven_exponents(scheme, pendulum, state, transient, periods, exponents, error)
      !> Method and steps to a period
      type(driven_scheme), intent(in) :: scheme
      !> Constants of each member
      type(driven_pendulum), intent(in) :: pendulum(:)
      !> Their starts, and their ends
      type(driven_state), intent(inout) :: state(:)
      !> Periods before anything is counted; the vectors turn to their directions meanwhile
      integer, intent(in) :: transient
      !> Periods to be counted; at least 16, and a multiple of it is used
      integer, intent(in) :: periods
      !> The exponents, the larger one first: (2, members)
      real(wp), intent(out) :: exponents(:, :)
      !> The standard error of the first one
      real(wp), intent(out) :: error(:)
      integer :: i, last

      !$omp parallel do private(last) schedule(dynamic)
      do i = 1, size(state), driven_block
         last = min(i + driven_block - 1, size(state))
         call measure(scheme, pendulum(i:last), state(i:last), transient, max(periods/batches, 1), &
            exponents(:, i:last), error(i:last))
      end do
      !$omp end parallel do
   end subroutine driven_exponents


   !> A block of members
   pure subroutine measure(scheme, pendulum, state, transient, length, exponents, error)
      type(driven_scheme), intent(in) :: scheme
      type(driven_pendulum), intent(in) :: pendulum(:)
      type(driven_state), intent(inout) :: state(:)
      integer, intent(in) :: transient
      !> Periods of a batch
      integer, intent(in) :: length
      real(wp), intent(out) :: exponents(:, :)
      real(wp), intent(out) :: error(:)
      real(wp), parameter :: turn = 2*acos(-1.0_wp)
      real(wp) :: columns(2, 2, driven_block), logs(2, driven_block, batches), before(2, driven_block)
      integer :: i, n

      n = size(state)
      columns = spread(reshape([1.0_wp, 0.0_wp, 0.0_wp, 1.0_wp], [2, 2]), 3, driven_block)
      call grow(scheme, pendulum, state, transient, columns(:, :, :n), before(:, :n))
      do i = 1, batches
         call grow(scheme, pendulum, state, length, columns(:, :, :n), logs(:, :n, i))
      end do
      do i = 1, n
         exponents(:, i) = nan
         error(i) = nan
         if (state(i)%status /= driven_ran) cycle
         logs(:, i, :) = logs(:, i, :)*(pendulum(i)%frequency/(turn*real(length, wp)))
         exponents(:, i) = sum(logs(:, i, :), 2)/real(batches, wp)
         error(i) = sqrt(sum((logs(1, i, :) - exponents(1, i))**2)/real(batches*(batches - 1), wp))
      end do
   end subroutine measure


   !> Some periods, and the logarithms of what the columns have grown by, one along itself, the other across
   pure subroutine grow(scheme, pendulum, state, periods, columns, logs)
      type(driven_scheme), intent(in) :: scheme
      type(driven_pendulum), intent(in) :: pendulum(:)
      type(driven_state), intent(inout) :: state(:)
      integer, intent(in) :: periods
      real(wp), intent(inout) :: columns(:, :, :)
      real(wp), intent(out) :: logs(:, :)
      real(wp) :: area, length
      integer :: i, j

      logs = 0.0_wp
      do j = 1, periods
         call driven_steps(scheme, pendulum, state, 0, scheme%steps, columns)
         do i = 1, size(state)
            associate (a => columns(:, 1, i), b => columns(:, 2, i))
               length = sqrt(a(1)**2 + a(2)**2)
               area = abs(a(1)*b(2) - a(2)*b(1))
               if (.not. (length > 0.0_wp .and. area > 0.0_wp)) cycle
               logs(:, i) = logs(:, i) + log([length, area/length])
               a = a/length
               b = [-a(2), a(1)]
            end associate
         end do
      end do
   end subroutine grow
end module furiko_driven_lyapunov
! rooms: 3759241635
