! SPDX-License-Identifier: MIT

!> How far a sweep has come, in words.
module furiko_ensemble_progress
   use, intrinsic :: iso_fortran_env, only : error_unit, int64, wp => real64
   use furiko_ensemble_system, only : is_terminal, seconds
   implicit none
   private
   public :: progress, progress_line


   !> Seconds from one line to the next: on a terminal, where it is written over; and in a log
   real(wp), parameter :: pause = 0.5_wp, long_pause = 60.0_wp


   !> Begun when a run begins, told of each step
   type :: progress
      logical :: wanted = .false.
      logical :: on_terminal = .false.
      real(wp) :: started = 0.0_wp
      real(wp) :: shown = 0.0_wp
   contains
      procedure :: begin
      procedure :: show
   end type progress


contains


   subroutine begin(self, wanted)
      class(progress), intent(out) :: self
      logical, intent(in) :: wanted

      self%wanted = wanted
      self%on_terminal = is_terminal()
      self%started = seconds()
      self%shown = self%started
   end subroutine begin


   !> A line, if it is time, or the last one
   subroutine show(self, line, last)
      class(progress), intent(inout) :: self
      character(len=*), intent(in) :: line
      logical, intent(in) :: last
      real(wp) :: now

      if (.not. self%wanted) return
      now = seconds()
      if (.not. last .and. now - self%shown < merge(pause, long_pause, self%on_terminal)) return
      self%shown = now
      if (self%on_terminal) write(error_unit, '(a)', advance='no') char(13) // char(27) // '[K'
      if (self%on_terminal .and. .not. last) then
         write(error_unit, '(a)', advance='no') line
      else
         write(error_unit, '(a)') line
      end if
      flush(error_unit)
   end subroutine show


   !> As '12 of 245 chunks (4 %), 40200 members/s, 23 s left'
   function progress_line(done, all, since, members, time) result(line)
      !> Chunks that are there, of how many
      integer(int64), intent(in) :: done
      integer(int64), intent(in) :: all
      !> How many of them this run has found
      integer(int64), intent(in) :: since
      !> Members of a chunk
      integer, intent(in) :: members
      !> Seconds this run has taken; 0 if nobody knows
      real(wp), intent(in) :: time
      character(len=:), allocatable :: line
      real(wp) :: rate

      line = whole_text(done) // ' of ' // whole_text(all) // ' chunks (' // &
         whole_text(int(100*real(done, wp)/real(max(all, 1_int64), wp), int64)) // ' %)'
      if (done <= since .or. .not. time > 0.0_wp) return
      rate = real(done - since, wp)/time
      line = line // ', ' // whole_text(nint(rate*members, int64)) // ' members/s'
      if (done < all) line = line // ', ' // duration(real(all - done, wp)/rate) // ' left'
   end function progress_line


   !> Seconds in the largest unit of which there are two
   pure function duration(time) result(text)
      real(wp), intent(in) :: time
      character(len=:), allocatable :: text
      character(len=*), parameter :: units(*) = [character(len=4) :: 'd', 'h', 'min', 's']
      real(wp), parameter :: sizes(*) = [86400.0_wp, 3600.0_wp, 60.0_wp, 1.0_wp]
      integer :: i

      do i = 1, size(units) - 1
         if (time >= 2*sizes(i)) exit
      end do
      text = whole_text(nint(time/sizes(i), int64)) // ' ' // trim(units(i))
   end function duration


   pure function whole_text(number) result(text)
      integer(int64), intent(in) :: number
      character(len=:), allocatable :: text
      character(len=20) :: buffer

      write(buffer, '(i0)') number
      text = trim(buffer)
   end function whole_text
end module furiko_ensemble_progress
