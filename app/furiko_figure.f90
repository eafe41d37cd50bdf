! SPDX-License-Identifier: MIT

!> A figure: its curves, which the library computed, and the gnuplot commands that draw them.
module furiko_figure
   use, intrinsic :: iso_fortran_env, only : wp => real64
   use furiko_cli_text, only : whole_text
   implicit none
   private
   public :: figure, curve, amplitude, fixed, to_text, ramp


   character(len=*), parameter :: nl = new_line('a')


   !> An amplitude of the command line
   type :: amplitude
      real(wp) :: radians = 0.0_wp
      !> As it was typed, with its unit: 30°, 0.3 rad
      character(len=:), allocatable :: label
      logical :: in_degrees = .true.
   end type amplitude


   !> A number as gnuplot reads it
   interface to_text
      module procedure :: integer_to_text
      module procedure :: real_to_text
   end interface to_text


   type :: curve
      character(len=:), allocatable :: name
      real(wp), allocatable :: x(:)
      real(wp), allocatable :: y(:)
   end type curve


   type :: figure
      !> What x and y are, with their units, as a CSV file's header says it: angle_deg
      character(len=:), allocatable :: x_name
      character(len=:), allocatable :: y_name
      type(curve), allocatable :: curves(:)
      !> gnuplot's layout of a figure of several panels, as '3,1'; empty for one panel
      character(len=:), allocatable :: layout
      !> The commands, one a line
      character(len=:), allocatable :: script
      !> Curves of the panel at hand, as `plot` takes them
      character(len=:), allocatable, private :: drawn
   contains
      procedure :: begin
      procedure :: add
      procedure :: say
      procedure :: draw
      procedure :: plot
      procedure :: csv
   end type figure


contains


   subroutine begin(self, x_name, y_name, layout)
      class(figure), intent(inout) :: self
      character(len=*), intent(in) :: x_name
      character(len=*), intent(in) :: y_name
      character(len=*), intent(in), optional :: layout

      self%x_name = x_name
      self%y_name = y_name
      self%script = ''
      self%drawn = ''
      self%layout = ''
      if (present(layout)) self%layout = layout
      allocate(self%curves(0))
   end subroutine begin


   !> Add a curve; its points must be finite.
   subroutine add(self, name, x, y)
      class(figure), intent(inout) :: self
      character(len=*), intent(in) :: name
      real(wp), intent(in) :: x(:)
      real(wp), intent(in) :: y(:)
      type(curve), allocatable :: longer(:)
      integer :: n

      n = size(self%curves)
      allocate(longer(n + 1))
      longer(:n) = self%curves
      longer(n + 1)%name = name
      longer(n + 1)%x = x
      longer(n + 1)%y = y
      call move_alloc(longer, self%curves)
   end subroutine add


   !> Add a line to the script, where <K> stands for a slanted K.
   subroutine say(self, line)
      class(figure), intent(inout) :: self
      character(len=*), intent(in) :: line
      integer :: i

      do i = 1, len(line)
         select case (line(i:i))
         case ('<')
            self%script = self%script // '{/:Italic '
         case ('>')
            self%script = self%script // '}'
         case default
            self%script = self%script // line(i:i)
         end select
      end do
      self%script = self%script // nl
   end subroutine say


   !> Draw the last curve with a look: gnuplot's words behind `with`. Or a copy of it, shifted.
   subroutine draw(self, look, x)
      class(figure), intent(inout) :: self
      character(len=*), intent(in) :: look
      !> What gnuplot takes for x in place of the data's ($2)
      character(len=*), intent(in), optional :: x
      character(len=:), allocatable :: column

      column = '2'
      if (present(x)) column = x
      if (self%drawn /= '') self%drawn = self%drawn // ', \' // nl // '   '
      self%drawn = self%drawn // 'data skip 1 index ' // to_text(size(self%curves) - 1) // &
         ' using ' // column // ':3 with ' // look
   end subroutine draw


   !> Plot what has been drawn in this panel, and begin the next.
   subroutine plot(self, again)
      class(figure), intent(inout) :: self
      !> Whether the next panel has the same curves
      logical, intent(in), optional :: again

      call self%say('plot ' // self%drawn)
      if (present(again)) then
         if (again) return
      end if
      self%drawn = ''
   end subroutine plot


   !> All curves as rows `curve,x,y`, two blank lines between them, where gnuplot sees the next.
   pure function csv(self) result(text)
      class(figure), intent(in) :: self
      character(len=:), allocatable :: text
      integer :: i

      text = 'curve,' // self%x_name // ',' // self%y_name // nl
      do i = 1, size(self%curves)
         if (i > 1) text = text // nl // nl
         text = text // rows(self%curves(i))
      end do
   end function csv


   pure function rows(self) result(text)
      type(curve), intent(in) :: self
      character(len=:), allocatable :: text
      integer :: i

      text = ''
      do i = 1, size(self%x)
         text = text // self%name // ',' // to_text(self%x(i)) // ',' // to_text(self%y(i)) // nl
      end do
   end function rows


   !> x with so many decimals: 0.300
   pure function fixed(x, decimals) result(text)
      real(wp), intent(in) :: x
      integer, intent(in) :: decimals
      character(len=:), allocatable :: text
      character(len=40) :: buffer, form

      write(form, '(a, i0, a)') '(f40.', decimals, ')'
      write(buffer, form) x
      text = trim(adjustl(buffer))
   end function fixed


   pure function integer_to_text(number) result(text)
      integer, intent(in) :: number
      character(len=:), allocatable :: text

      text = whole_text(number)
   end function integer_to_text


   !> Ten digits, of any magnitude
   pure function real_to_text(x) result(text)
      real(wp), intent(in) :: x
      character(len=:), allocatable :: text
      character(len=17) :: buffer

      write(buffer, '(es17.9e3)') x
      text = trim(adjustl(buffer))
   end function real_to_text


   !> n + 1 points from a to b.
   pure function ramp(a, b, n) result(x)
      real(wp), intent(in) :: a
      real(wp), intent(in) :: b
      integer, intent(in) :: n
      real(wp) :: x(n + 1)
      integer :: i

      x = [(a + (b - a)*i/n, i=0, n)]
   end function ramp

end module furiko_figure
