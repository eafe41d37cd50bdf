! SPDX-License-Identifier: MIT

!> Comparison with published numbers, for the programs beside this one: `near` to so many units of the
!> last digit that was printed, `finish` ends with status 1 if anything was wrong.
module checks
   implicit none
   private
   public :: equal, finish, near
   integer :: wrong = 0, all = 0

   interface near
      procedure near_sp, near_dp
   end interface near


contains


   subroutine near_dp(what, x, published, error)
      character(len=*), intent(in) :: what
      double precision, intent(in) :: x, published, error

      call equal(what, merge(0, 1, abs(x - published) <= error), 0)
   end subroutine near_dp


   subroutine near_sp(what, x, published, error)
      character(len=*), intent(in) :: what
      real, intent(in) :: x
      double precision, intent(in) :: published, error

      call near_dp(what, dble(x), published, error)
   end subroutine near_sp


   subroutine equal(what, i, j)
      character(len=*), intent(in) :: what
      integer, intent(in) :: i, j

      all = all + 1
      if (i == j) return
      wrong = wrong + 1
      print '(2a)', 'wrong: ', what
   end subroutine equal


   subroutine finish(name)
      character(len=*), intent(in) :: name

      print '(2a, i0, a, i0, a)', name, ': ', all, ' values, ', wrong, ' wrong'
      if (wrong > 0 .or. all == 0) stop 1
   end subroutine finish

end module checks
