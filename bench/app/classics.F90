! SPDX-License-Identifier: MIT

#ifdef __GFC_REAL_16__
!> Appendix C of the first note asks which is faster, AGM or trapezoid. K at k = 1/2 to 1e-15 and to
!> 1e-30: interleaved repeats, the least of each, in ns a value. Prints rows of a Markdown table.
program classics
   use, intrinsic :: iso_fortran_env, only : dp => real64, int64, qp => real128
   use bench_note_dp, only : agm_of_note, series_of_note
   use bench_note_qp, only : agm_of_note_quad => agm_of_note, series_of_note_quad => series_of_note
   use furiko, only : agm_steps_k, ellipk_k, ellipk_series_k, ellipk_trapezoid_k
   implicit none
   integer, parameter :: points = 1000
   integer, parameter :: repeats = 15
   character(len=*), parameter :: names(12) = [character(len=37) :: &
      'series as in the note, 24 terms', 'trapezoid, 7 subintervals', &
      'AGM as in the note (K and E), 4 steps', 'ellipk_series_k, 24 terms', &
      'agm_steps_k, 4 steps', 'ellipk_k', &
      'series as in the note, 48 terms', 'trapezoid, 13 subintervals', &
      'AGM as in the note (K and E), 5 steps', 'ellipk_series_k, 48 terms', &
      'agm_steps_k, 5 steps', 'ellipk_k']
   real(qp), parameter :: exact = 1.6857503548125960428712036577990769895008_qp
   real(dp) :: times(size(names))
   real(qp) :: errors(size(names))
   integer :: i, repeat

   times = huge(times)
   do repeat = 1, repeats
      do i = 1, 6
         call try(i)
         call try_quad(i + 6)
      end do
   end do
   do i = 1, size(names)
      print '(4a, es8.1, a, f9.1, a)', '| ', merge('1e-15 | ', '1e-30 | ', i <= 6), names(i), ' | ', &
         errors(i), ' | ', times(i), ' |'
   end do


contains


   subroutine try(case)
      integer, intent(in) :: case
      integer(int64) :: start, finish, rate
      real(dp) :: k(points), value(points), second(points)
      real(dp), dimension(5) :: a, b, c, k_n, e_n
      integer :: j

      k = 0.5_dp
      call system_clock(start, rate)
      select case (case)
      case (1)
         value = series_of_note(k, 24)
      case (2)
         value = ellipk_trapezoid_k(k, 7)
      case (3)
         call agm_of_note(k, 4, value, second)
      case (4)
         value = ellipk_series_k(k, 24)
      case (5)
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
      real(qp), dimension(points/10) :: k, value, second
      real(qp), dimension(6) :: a, b, c, k_n, e_n
      integer :: j

      k = 0.5_qp
      call system_clock(start, rate)
      select case (case)
      case (7)
         value = series_of_note_quad(k, 48)
      case (8)
         value = ellipk_trapezoid_k(k, 13)
      case (9)
         call agm_of_note_quad(k, 5, value, second)
      case (10)
         value = ellipk_series_k(k, 48)
      case (11)
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
