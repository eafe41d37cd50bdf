! SPDX-License-Identifier: MIT

!> What goes into the tables: medians of times, and numbers or dashes.
module bench_table
   use, intrinsic :: iso_fortran_env, only : wp => real64
   implicit none
   private
   public :: cell, median, ratio_cell


contains


   !> A number of a table; a dash for a peer that is not there, whose time means nothing
   pure function cell(number, there)
      real(wp), intent(in) :: number
      logical, intent(in) :: there
      character(len=8) :: cell

      write(cell, '(f8.1)') number
      if (.not. there) cell = '       -'
   end function cell


   !> How many times as fast; in bold where it is slower
   pure function ratio_cell(ratio, there) result(text)
      real(wp), intent(in) :: ratio
      logical, intent(in) :: there
      character(len=10) :: text

      write(text, '(f9.2)') ratio
      if (ratio < 1) write(text, '(a, f4.2, a)') '**', ratio, '**'
      if (.not. there) text = '-'
      text = adjustr(text)
   end function ratio_cell


   pure function median(times)
      real(wp), intent(in) :: times(:)
      real(wp) :: median
      integer :: i

      do i = 1, size(times)
         median = times(i)
         if (count(times < median) <= size(times)/2 .and. count(times <= median) > size(times)/2) return
      end do
   end function median

end module bench_table
