! SPDX-License-Identifier: MIT

#ifdef __GFC_REAL_16__
!> Appendix C of the first note asks which is faster, AGM or trapezoid. K at k = 1/2 to 1e-15 and to
!> 1e-30: interleaved repeats, the least of each, in ns a value. Prints rows of a Markdown table.
program classics
   use, intrinsic :: iso_fortran_env, only : dp => real64, int64, qp => real128
   use furiko, only : agm_steps_k, ellipk_k, ellipk_series_k, ellipk_trapezoid_k
   implicit none
   integer, parameter :: points = 1000
   integer, parameter :: repeats = 15
   character(len=*), parameter :: names(8) = [character(len=36) :: &
      'series, 24 terms', 'trapezoid, 7 subintervals', 'AGM, 4 steps (K and E)', 'ellipk_k', &
      'series, 48 terms', 'trapezoid, 13 subintervals', 'AGM, 5 steps (K and E)', 'ellipk_k']
   real(qp), parameter :: exact = 1.6857503548125960428712036577990769895008_qp
   real(dp) :: times(size(names))
   real(qp) :: errors(size(names))
   integer :: i, repeat

   times = huge(times)
   do repeat = 1, repeats
      do i = 1, 4
         call try(i)
         call try_quad(i + 4)
      end do
   end do
   do i = 1, size(names)
      print '(4a, es8.1, a, f9.1, a)', '| ', merge('1e-15 | ', '1e-30 | ', i <= 4), names(i), ' | ', &
         errors(i), ' | ', times(i), ' |'
   end do


contains


   subroutine try(case)
      integer, intent(in) :: case
      integer(int64) :: start, finish, rate
      real(dp) :: k(points), value(points)
      real(dp), dimension(5) :: a, b, c, k_n, e_n
      integer :: j

      k = 0.5_dp
      call system_clock(start, rate)
      select case (case)
      case (1)
         value = ellipk_series_k(k, 24)
      case (2)
         value = ellipk_trapezoid_k(k, 7)
      case (3)
         do j = 1, points
            call agm_steps_k(k(j), a, b, c, k_n, e_n)
            value(j) = k_n(5)
         end do
      case default
         do j = 1, points
            value(j) = ellipk_k(k(j))
         end do
      end select
      call system_clock(finish)
      times(case) = min(times(case), real(finish - start, dp)/real(rate, dp)*1.0e9_dp/points)
      errors(case) = maxval(abs(value - exact))
   end subroutine try


   subroutine try_quad(case)
      integer, intent(in) :: case
      integer(int64) :: start, finish, rate
      real(qp) :: k(points/10), value(points/10)
      real(qp), dimension(6) :: a, b, c, k_n, e_n
      integer :: j

      k = 0.5_qp
      call system_clock(start, rate)
      select case (case)
      case (5)
         value = ellipk_series_k(k, 48)
      case (6)
         value = ellipk_trapezoid_k(k, 13)
      case (7)
         do j = 1, size(k)
            call agm_steps_k(k(j), a, b, c, k_n, e_n)
            value(j) = k_n(6)
         end do
      case default
         do j = 1, size(k)
            value(j) = ellipk_k(k(j))
         end do
      end select
      call system_clock(finish)
      times(case) = min(times(case), real(finish - start, dp)/real(rate, dp)*1.0e9_dp/size(k))
      errors(case) = maxval(abs(value - exact))
   end subroutine try_quad

end program classics
#else
!> The question is one of real128, which this compiler does not have.
program classics
   implicit none
end program classics
#endif
