! SPDX-License-Identifier: MIT

!> What figures draw that `furiko driven` or `ensemble` has computed: tables of rows, and the constants that
!> vary in them.
module furiko_figure_table
   use, intrinsic :: iso_fortran_env, only : int64, wp => real64
   use furiko_bits_dp, only : is_finite
   use furiko_cli_io, only : complain, refuse
   use furiko_cli_source, only : longest_name, open_source, source
   use furiko_cli_store, only : begin_store, store
   use furiko_cli_text, only : replaced, whole_text
   implicit none
   private
   public :: axis_of, extent_of, padded, read_table, longest_name


   !> Constants as `furiko driven` calls them, and their symbols of doc/driven.md
   character(len=*), parameter :: constants(*) = [character(len=9) :: 'damping', 'quadratic', 'torque', &
      'drive', 'frequency', 'phase']
   character(len=*), parameter :: labels(*) = [character(len=40) :: 'damping  <b>', &
      'quadratic damping  <c>', 'torque  <I>', 'amplitude of the drive  <g>', 'frequency of the drive  <Ω>', &
      'phase of the drive  <φ>  (rad)']


   !> No axis shows more
   real(wp), parameter :: far = 1.0e100_wp


contains


   !> The rows of a file, of the columns asked for as in [[open_source]]. Those with a NaN, of members that
   !> ran away, or beyond 1e100 are left out, and how many is said.
   subroutine read_table(file, wanted, needed, rows, first_name)
      character(len=*), intent(in) :: file
      character(len=*), intent(in) :: wanted(:)
      integer, intent(in) :: needed
      type(store), intent(out) :: rows
      !> Of the first column
      character(len=*), intent(out) :: first_name
      type(source) :: table
      real(wp) :: row(size(wanted))
      integer :: left_out
      logical :: found, usable

      call open_source(file, wanted, needed, table)
      first_name = table%first_name
      rows = begin_store(size(wanted))
      left_out = 0
      do
         call table%next_row(row, found)
         if (.not. found) exit
         usable = all(is_finite(row))
         if (usable) usable = maxval(abs(row)) < far
         if (usable) then
            call rows%add(row)
         else
            left_out = left_out + 1
         end if
      end do
      if (rows%rows == 0) call refuse('furiko plot: ' // table%name // ' has no row of numbers')
      if (left_out > 0) call complain('furiko plot: ' // table%name // ': rows of NaN, of ' // &
         'members that ran away, are left out: ' // whole_text(left_out))
   end subroutine read_table


   !> Least and largest value of each column: (2, columns); how often the first changes from row to row, and 1
   subroutine extent_of(rows, extent, values)
      type(store), intent(inout) :: rows
      real(wp), intent(out) :: extent(:, :)
      integer(int64), intent(out) :: values
      real(wp) :: before, row(size(extent, 2))
      logical :: found

      extent(1, :) = huge(extent)
      extent(2, :) = -huge(extent)
      values = 0
      before = huge(before)
      call rows%rewind()
      do
         call rows%take(row, found)
         if (.not. found) return
         extent(1, :) = min(extent(1, :), row)
         extent(2, :) = max(extent(2, :), row)
         if (abs(row(1) - before) > 0.0_wp) values = values + 1
         before = row(1)
      end do
   end subroutine extent_of


   !> A range with a little room on both sides, at least so much, and enough for ten digits to tell
   pure function padded(range, least) result(wider)
      real(wp), intent(in) :: range(2)
      real(wp), intent(in) :: least
      real(wp) :: wider(2)

      wider = range + max(0.04_wp*(range(2) - range(1)), least, 1.0e-6_wp*maxval(abs(range)))*[-1, 1]
   end function padded


   !> The label of the axis of what varies
   pure function axis_of(name) result(label)
      character(len=*), intent(in) :: name
      character(len=:), allocatable :: label
      integer :: i

      label = replaced(name, '_', ' ')
      do i = 1, size(constants)
         if (constants(i) == name) label = trim(labels(i))
      end do
   end function axis_of

end module furiko_figure_table
