! SPDX-License-Identifier: MIT

!> What goes into the tables: medians of times, and numbers or dashes.
module bench_table
   use, intrinsic :: iso_fortran_env, only : wp => real64
   implicit none
   private
   public :: cell, median


contains


   !> A number of a table; a dash for a peer that is not there, whose time means nothing
   pure function cell(number, there)
      real(wp), intent(in) :: number
      logical, intent(in) :: there
      character(len=8) :: cell

      write(cell, '(f8.1)') number
      if (.not. there) cell = '       -'
   end function cell


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
