! SPDX-License-Identifier: MIT

!> Rows of numbers under named columns, as text for the eye, csv or json; a row at a time.
module furiko_cli_sheet
   use, intrinsic :: iso_fortran_env, only : int64, wp => real64
   use furiko_cli_decimal, only : decimal, fixed_words => fixed, to_text
   use furiko_cli_terminal, only : put, refuse
   use furiko_double_word, only : double_word
   implicit none
   private
   public :: sheet, begin_sheet


   !> Csv and json have the columns' names and all 17 digits. Text has a format for each column, and
   !> the names above where the formats have a width.
   type :: sheet
      private
      character(len=16), allocatable :: columns(:)
      character(len=8), allocatable :: styles(:)
      !> Decimals of numbers without a width
      integer, allocatable :: places(:)
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
      allocate(self%columns(size(columns)), self%styles(size(columns)), self%places(size(columns)))
      self%columns(:) = columns
      self%styles(:) = styles
      self%places(:) = [(places_of(styles(i)), i=1, size(styles))]
      line = ''
      do i = 1, size(columns)
         if (form == 'csv') line = line // ',' // trim(columns(i))
         width = width_of(styles(i))
         if (form == 'text') line = line // ' ' // repeat(' ', max(0, width - len_trim(columns(i)))) // &
            trim(columns(i))
      end do
      select case (form)
      case ('text')
         if (all(self%places < 0)) call put(line(2:))
      case ('csv')
         call put(line(2:))
      case ('json')
         call put('[')
      case default
         call refuse(command // ": --format '" // form // "' is none of text, csv, json")
      end select
   end function begin_sheet


   !> Write a row, as many numbers as there are columns.
   subroutine row(self, numbers, low)
      class(sheet), intent(inout) :: self
      real(wp), intent(in) :: numbers(:)
      !> What the rounding of the numbers left, for text with 15 decimals; 0 where it is not known
      real(wp), intent(in), optional :: low(:)
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
            if (self%places(i) < 0) then
               line = line // ' ' // fixed(numbers(i), trim(self%styles(i)), low, i)
            else
               line = line // ' ' // rounded(numbers(i), self%places(i))
            end if
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


   !> A number in a format with a width, i for whole ones; with the i-th of `low`, where there is one
   pure function fixed(x, style, low, i) result(text)
      real(wp), intent(in) :: x
      character(len=*), intent(in) :: style
      real(wp), intent(in), optional :: low(:)
      integer, intent(in), optional :: i
      character(len=:), allocatable :: text
      character(len=40) :: buffer

      if (style(1:1) == 'i') then
         write(buffer, '(' // style // ')') nint(x, int64)
      else
         write(buffer, '(' // style // ')') x
      end if
      text = buffer(:width_of(style))
      if (.not. present(low)) return
      if (abs(low(i)) > 0.0_wp) then
         buffer = fixed_words(double_word(x, low(i)))
         text(:) = adjustr(buffer(:len(text)))
      end if
   end function fixed


   !> A number with `places` decimals, rounded to nearest. By whole numbers, many times as fast as a
   !> `write`, where x times the power of ten is no tie or so large that it might be one.
   pure function rounded(x, places) result(text)
      real(wp), intent(in) :: x
      integer, intent(in) :: places
      character(len=:), allocatable :: text
      character(len=400) :: buffer
      character(len=12) :: style
      real(wp) :: scaled

      scaled = min(abs(x), 1.0e16_wp)*10.0_wp**places
      if (scaled < 1.0e15_wp .and. abs(scaled - aint(scaled) - 0.5_wp) > 0.01_wp) then
         text = to_text(decimal(nint(scaled, int64), places))
         if (sign(1.0_wp, x) < 0.0_wp) text = '-' // text
      else
         write(style, '("(f400.", i0, ")")') places
         write(buffer, style) x
         text = trim(adjustl(buffer))
      end if
   end function rounded


   !> The decimals in f0.6 and the like; -1 in a format with a width
   pure function places_of(style) result(places)
      character(len=*), intent(in) :: style
      integer :: places

      places = -1
      if (width_of(style) == 0) read(style(index(style, '.') + 1:), '(i8)') places
   end function places_of


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
