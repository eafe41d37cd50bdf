! SPDX-License-Identifier: MIT

!> Rows of numbers under named columns, as text for the eye, csv or json; a row at a time.
module furiko_cli_sheet
   use, intrinsic :: iso_fortran_env, only : wp => real64
   use furiko_cli_terminal, only : put, refuse
   implicit none
   private
   public :: sheet, begin_sheet


   !> Csv and json have the columns' names and all 17 digits; text has the numbers alone, with
   !> decimals of one's choice.
   type :: sheet
      private
      character(len=16), allocatable :: columns(:)
      character(len=:), allocatable :: form
      !> The format of a number in text
      character(len=:), allocatable :: style
      logical :: first = .true.
   contains
      procedure :: row
      procedure :: end
   end type sheet


contains


   !> A sheet in the format of a word behind --format; `style` is Fortran's for a number in text.
   function begin_sheet(command, form, columns, style) result(self)
      character(len=*), intent(in) :: command
      character(len=*), intent(in) :: form
      character(len=*), intent(in) :: columns(:)
      character(len=*), intent(in) :: style
      type(sheet) :: self
      character(len=:), allocatable :: line
      integer :: i

      self%form = form
      self%columns = columns
      self%style = style
      select case (form)
      case ('text')
      case ('csv')
         line = trim(columns(1))
         do i = 2, size(columns)
            line = line // ',' // trim(columns(i))
         end do
         call put(line)
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
            line = line // trim(merge(',', ' ', i > 1)) // all_digits(numbers(i))
         case ('json')
            line = line // trim(merge(', ', '  ', i > 1)) // merge(' ', '{', i > 1) // '"' // &
               trim(self%columns(i)) // '": ' // json_number(numbers(i))
         case default
            line = line // fixed(numbers(i), self%style) // ' '
         end select
      end do
      if (self%form == 'text') line = line(:len(line) - 1)
      if (self%form == 'json') line = trim(merge(' ', ',', self%first)) // line // '}'
      call put(line)
      self%first = .false.
   end subroutine row


   subroutine end(self)
      class(sheet), intent(in) :: self

      if (self%form == 'json') call put(']')
   end subroutine end


   !> A number in Fortran's format `style`, without blanks; f0.6 would leave the zero before the point.
   pure function fixed(x, style) result(text)
      real(wp), intent(in) :: x
      character(len=*), intent(in) :: style
      character(len=:), allocatable :: text
      character(len=400) :: buffer

      write(buffer, '(' // style // ')') x
      text = trim(adjustl(buffer))
   end function fixed


   !> Seventeen digits, which read back as the number
   pure function all_digits(x) result(text)
      real(wp), intent(in) :: x
      character(len=:), allocatable :: text

      text = fixed(x, 'es25.16e3')
   end function all_digits


   !> JSON has no infinity and no NaN.
   pure function json_number(x) result(text)
      real(wp), intent(in) :: x
      character(len=:), allocatable :: text

      text = 'null'
      if (abs(x) <= huge(x)) text = all_digits(x)
   end function json_number

end module furiko_cli_sheet
