! SPDX-License-Identifier: MIT

!> Rows of numbers under named columns, as text for the eye, csv or json; a row at a time.
module furiko_cli_sheet
   use, intrinsic :: iso_fortran_env, only : int64, wp => real64
   use furiko_cli_terminal, only : put, refuse
   implicit none
   private
   public :: sheet, begin_sheet


   !> Csv and json have the columns' names and all 17 digits. Text has a format for each column, and
   !> the names above where the formats have a width.
   type :: sheet
      private
      character(len=16), allocatable :: columns(:)
      character(len=8), allocatable :: styles(:)
      character(len=:), allocatable :: form
      logical :: first = .true.
   contains
      procedure :: row
      procedure :: end
   end type sheet


contains


   !> A sheet in the format of a word behind --format; `styles` are Fortran's formats for the numbers
   !> of each column in text, i for whole ones; f0.6 and the like stand side by side with one blank.
   function begin_sheet(command, form, columns, styles) result(self)
      character(len=*), intent(in) :: command
      character(len=*), intent(in) :: form
      character(len=*), intent(in) :: columns(:)
      character(len=*), intent(in) :: styles(:)
      type(sheet) :: self
      character(len=:), allocatable :: line
      integer :: i, width

      self%form = form
      allocate(self%columns(size(columns)), self%styles(size(columns)))
      self%columns(:) = columns
      self%styles(:) = styles
      line = ''
      width = 0
      do i = 1, size(columns)
         if (form == 'csv') line = line // ',' // trim(columns(i))
         width = width_of(styles(i))
         if (form == 'text') line = line // ' ' // repeat(' ', max(0, width - len_trim(columns(i)))) // &
            trim(columns(i))
      end do
      select case (form)
      case ('text')
         if (width > 0) call put(line(2:))
      case ('csv')
         call put(line(2:))
      case ('json')
         call put('[')
      case default
         call refuse(command // ": --format '" // form // "' is none of text, csv, json")
      end select
   end function begin_sheet


   !> Write a row, as many numbers as there are columns.
   subroutine row(self, numbers)
      class(sheet), intent(inout) :: self
      real(wp), intent(in) :: numbers(:)
      character(len=:), allocatable :: line
      integer :: i

      line = ''
      do i = 1, size(numbers)
         select case (self%form)
         case ('csv')
            line = line // ',' // exact(numbers(i), self%styles(i))
         case ('json')
            line = line // ', "' // trim(self%columns(i)) // '": ' // &
               json_number(numbers(i), self%styles(i))
         case default
            line = line // ' ' // fixed(numbers(i), trim(self%styles(i)))
         end select
      end do
      if (self%form == 'json') then
         call put(trim(merge(' ', ',', self%first)) // '{' // line(3:) // '}')
      else
         call put(line(2:))
      end if
      self%first = .false.
   end subroutine row


   subroutine end(self)
      class(sheet), intent(in) :: self

      if (self%form == 'json') call put(']')
   end subroutine end


   !> A number in Fortran's format `style`; f0.6 gets its zero before the point.
   pure function fixed(x, style) result(text)
      real(wp), intent(in) :: x
      character(len=*), intent(in) :: style
      character(len=:), allocatable :: text
      character(len=40) :: buffer
      character(len=400) :: long
      integer :: width

      width = width_of(style)
      if (style(1:1) == 'i') then
         write(buffer, '(' // style // ')') nint(x, int64)
      else if (width > 0) then
         write(buffer, '(' // style // ')') x
      else if (abs(x) < 1.0e20_wp) then
         write(buffer, '(f40.' // style(4:) // ')') x
         width = 0
      else
         write(long, '(f400.' // style(4:) // ')') x
         text = trim(adjustl(long))
         return
      end if
      text = buffer(verify(buffer, ' '):)
      if (width > 0) text = buffer(:width)
   end function fixed


   !> The width in a format, as 20 in f20.15; 0 in f0.6
   pure function width_of(style) result(width)
      character(len=*), intent(in) :: style
      integer :: width
      integer :: first, last

      first = scan(style, '0123456789')
      last = scan(trim(style) // '.', '.') - 1
      read(style(first:last), '(i8)') width
   end function width_of


   !> A number that reads back as itself: seventeen digits, or a whole one
   pure function exact(x, style) result(text)
      real(wp), intent(in) :: x
      character(len=*), intent(in) :: style
      character(len=:), allocatable :: text

      text = trim(adjustl(fixed(x, merge('i24      ', 'es24.16e3', style(1:1) == 'i'))))
   end function exact


   !> JSON has no infinity and no NaN.
   pure function json_number(x, style) result(text)
      real(wp), intent(in) :: x
      character(len=*), intent(in) :: style
      character(len=:), allocatable :: text

      text = 'null'
      if (abs(x) <= huge(x)) text = exact(x, style)
   end function json_number

end module furiko_cli_sheet
