! SPDX-License-Identifier: MIT

#ifdef __GFC_REAL_16__
!> Appendix C of the first note asks which is faster, AGM or trapezoid. K at k = 1/2 to 1e-15 and to
!> 1e-30: interleaved repeats, the least of each, in ns a value. Prints a Markdown table.
program classics
   use, intrinsic :: iso_fortran_env, only : dp => real64, qp => real128
   use bench_classics_dp, only : try_classics
   use bench_classics_qp, only : try_classics_quad => try_classics
   implicit none
   integer, parameter :: ways = 6
   integer, parameter :: points = 1000
   integer, parameter :: repeats = 15
   character(len=*), parameter :: names(ways, 2) = reshape([character(len=37) :: &
      'series as in the note, 24 terms', 'trapezoid, 7 subintervals', &
      'AGM as in the note (K and E), 4 steps', 'ellipk_series_k, 24 terms', &
      'agm_steps_k, 4 steps', 'ellipk_k', &
      'series as in the note, 48 terms', 'trapezoid, 13 subintervals', &
      'AGM as in the note (K and E), 5 steps', 'ellipk_series_k, 48 terms', &
      'agm_steps_k, 5 steps', 'ellipk_k'], [ways, 2])
   character(len=*), parameter :: goals(2) = ['1e-15', '1e-30']
   real(dp) :: least(ways, 2), time
   real(qp) :: errors(ways, 2)
   integer :: i, j, repeat

   least = huge(least)
   do repeat = 1, repeats
      do i = 1, ways
         call try_classics(i, points, 24, 7, 4, time, errors(i, 1))
         least(i, 1) = min(least(i, 1), time)
         call try_classics_quad(i, points/10, 48, 13, 5, time, errors(i, 2))
         least(i, 2) = min(least(i, 2), time)
      end do
   end do
   print '(a)', '| to | by | error | ns |', '|---|---|---|---|'
   do j = 1, 2
      do i = 1, ways
         print '(5a, es8.1, a, f9.1, a)', '| ', goals(j), ' | ', names(i, j), ' | ', errors(i, j), ' | ', &
            least(i, j), ' |'
      end do
   end do
end program classics
#else
!> The question is one of real128, which this compiler does not have.
program classics
   implicit none
end program classics
#endif
