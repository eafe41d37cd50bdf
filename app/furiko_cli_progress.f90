! SPDX-License-Identifier: MIT

!> How far a long command has come: a line on the terminal while its rows go to a file or a pipe.
module furiko_cli_progress
   use, intrinsic :: iso_c_binding, only : c_int
   use, intrinsic :: iso_fortran_env, only : int64, wp => real64
   use furiko_cli_io, only : put_error
   use furiko_cli_text, only : whole_text
   implicit none
   private
   public :: progress


   !> Seconds until the first line, from one line to the next, and between looks at the clock
   real(wp), parameter :: patience = 2.0_wp
   real(wp), parameter :: pause = 0.5_wp
   real(wp), parameter :: glance = 0.1_wp
   !> Columns
   integer, parameter :: widest = 79
   character(len=*), parameter :: to_margin = char(13)


   !> Between `begin` and `end`, `step` is told what is done and costs next to nothing. Whoever writes to
   !> standard error in between calls `end` first.
   type :: progress
      private
      logical :: wanted = .false.
      character(len=:), allocatable :: unit
      !> 0 if nobody knows
      integer(int64) :: total = 0
      !> Calls until the next look at the clock, and how many that is from one look to the next
      integer(int64) :: left = 0
      integer(int64) :: stride = 1
      !> Seconds, as [[now]] has them
      real(wp) :: started = 0.0_wp
      real(wp) :: looked = 0.0_wp
      real(wp) :: shown = 0.0_wp
      !> How long the line on show is
      integer :: width = 0
   contains
      procedure :: begin
      procedure :: step
      procedure :: end => wipe
   end type progress


   interface
      function c_isatty(descriptor) result(is_terminal) bind(c, name='isatty')
         import :: c_int
         implicit none
         integer(c_int), value :: descriptor
         integer(c_int) :: is_terminal
      end function c_isatty
   end interface


contains


   !> Start the clock. Nothing is ever shown where standard output is a terminal, or standard error none.
   subroutine begin(self, total, unit)
      class(progress), intent(out) :: self
      !> How many there will be; 0 if nobody knows
      integer(int64), intent(in) :: total
      !> What they are: rows
      character(len=*), intent(in) :: unit

      self%wanted = c_isatty(1_c_int) == 0
      if (self%wanted) self%wanted = c_isatty(2_c_int) /= 0
      self%total = total
      self%unit = unit
      self%started = now()
      self%looked = self%started
      self%shown = self%started + patience - pause
   end subroutine begin


   !> So many are done.
   subroutine step(self, done)
      class(progress), intent(inout) :: self
      integer(int64), intent(in) :: done

      if (.not. self%wanted) return
      self%left = self%left - 1
      if (self%left <= 0) call look(self, done)
   end subroutine step


   !> Look at the clock, find out when to do so again, and show a line if it is time.
   subroutine look(self, done)
      class(progress), intent(inout) :: self
      integer(int64), intent(in) :: done
      character(len=:), allocatable :: line
      real(wp) :: time

      time = now()
      if (time - self%looked < glance) then
         self%stride = 2*self%stride
      else
         self%stride = max(1_int64, self%stride/2)
      end if
      self%left = self%stride
      self%looked = time
      if (time - self%shown < pause) return
      self%shown = time
      line = line_of(self, done, time - self%started)
      call put_error(to_margin // line // repeat(' ', max(0, self%width - len(line))))
      self%width = len(line)
   end subroutine look


   !> Leave no trace of the line.
   subroutine wipe(self)
      class(progress), intent(inout) :: self

      if (self%width > 0) call put_error(to_margin // repeat(' ', self%width) // to_margin)
      self%wanted = .false.
      self%width = 0
   end subroutine wipe


   !> As '2500000 of 10000000 rows (25 %), 1000000/s, 8 s left'
   pure function line_of(self, done, seconds) result(line)
      type(progress), intent(in) :: self
      integer(int64), intent(in) :: done
      real(wp), intent(in) :: seconds
      character(len=:), allocatable :: line
      real(wp) :: rate

      rate = done/seconds
      line = whole_text(done)
      if (self%total > 0) line = line // ' of ' // whole_text(self%total)
      line = line // ' ' // self%unit
      if (self%total > 0) line = line // ' (' // whole_text(int(100*real(done, wp)/self%total, &
         int64)) // ' %)'
      line = line // ', ' // rounded(rate) // '/s'
      if (self%total > 0 .and. done > 0) line = line // ', ' // duration((self%total - done)/rate) // ' left'
      line = line(:min(len(line), widest))
   end function line_of


   !> Seconds in the largest unit of which there are two
   pure function duration(seconds) result(text)
      real(wp), intent(in) :: seconds
      character(len=:), allocatable :: text
      character(len=*), parameter :: units(*) = [character(len=4) :: 'd', 'h', 'min', 's']
      real(wp), parameter :: sizes(*) = [86400.0_wp, 3600.0_wp, 60.0_wp, 1.0_wp]
      integer :: i

      do i = 1, size(units) - 1
         if (seconds >= 2*sizes(i)) exit
      end do
      text = rounded(seconds/sizes(i)) // ' ' // trim(units(i))
   end function duration


   !> A number with one decimal below 10, as 0.3, and none above
   pure function rounded(number) result(text)
      real(wp), intent(in) :: number
      character(len=:), allocatable :: text
      character(len=24) :: buffer

      if (number < 9.95_wp) then
         write(buffer, '(f24.1)') number
         text = trim(adjustl(buffer))
         if (index(text, '.') == 1) text = '0' // text
      else
         text = whole_text(nint(min(number, 1e18_wp), int64))
      end if
   end function rounded


   !> Seconds by a clock that runs on
   function now() result(seconds)
      real(wp) :: seconds
      integer(int64) :: rate, ticks

      call system_clock(ticks, rate)
      seconds = real(ticks, wp)/real(rate, wp)
   end function now

end module furiko_cli_progress
