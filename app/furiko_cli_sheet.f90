! SPDX-License-Identifier: MIT

!> Rows of numbers under named columns, as text for the eye, csv or json; a row at a time.
module furiko_cli_sheet
   use, intrinsic :: iso_fortran_env, only : int64, wp => real64
   use furiko_cli_answers, only : answers, begin_answers, phrase
   use furiko_cli_decimal, only : fixed
   use furiko_cli_number, only : scientific, significant
   use furiko_cli_options, only : command_line, option, word
   use furiko_word_arithmetic_dp, only : words
   implicit none
   private
   public :: column, whole, places, places_of_words, digits, powers, sheet, begin_sheet, format_option


   type(option), parameter :: format_option = option('--format', 'text|csv|json', 'text', 'of the output')


   !> How to write the numbers of a column
   type :: column
      !> With its unit
      character(len=20) :: name = ''
      integer :: style = 1
      !> Decimal places or digits, in text
      integer :: count = 0
      !> In csv and json, where that is more
      integer :: in_csv = 0
      !> Of the text, with the blanks in front; as name and numbers ask where it is below 0
      integer :: width = -1
      !> A shorter name for the head of the text; '-' where the text has no such column
      character(len=16) :: head = ''
   end type column

   !> Whole numbers; decimal places of what is right to 15 digits, or in two words to 18; digits; digits
   !> and a power of ten, for errors
   integer, parameter :: whole = 1
   integer, parameter :: places = 2
   integer, parameter :: places_of_words = 3
   integer, parameter :: digits = 4
   integer, parameter :: powers = 5


   type :: sheet
      private
      type(column), allocatable :: columns(:)
      type(answers) :: page
      logical :: in_text = .true.
   contains
      generic :: row => row_of_words, row_of_reals
      procedure :: end
      procedure, private :: row_of_words, row_of_reals
   end type sheet


contains


   !> A sheet in the format that a command line asks for; text that is `bare` has no head.
   function begin_sheet(line, columns, bare, rows) result(self)
      type(command_line), intent(in) :: line
      type(column), intent(in) :: columns(:)
      logical, intent(in), optional :: bare
      !> How many there will be, if many
      integer(int64), intent(in), optional :: rows
      type(sheet) :: self
      character(len=:), allocatable :: head
      type(word) :: form
      integer :: i

      form = line%value('--format')
      self%in_text = form%text == 'text'
      allocate(self%columns(size(columns)))
      self%columns(:) = columns
      where (columns%width < 0) self%columns%width = 2 + max(len_trim(head_of(columns)), least_width(columns))
      self%page = begin_answers(form%text, [(phrase(trim(columns(i)%name)), i=1, size(columns))], rows)
      if (.not. self%in_text) return
      if (present(bare)) then
         if (bare) return
      end if
      head = ''
      do i = 1, size(columns)
         if (columns(i)%head /= '-') call append(head, trim(head_of(columns(i))), self%columns(i)%width)
      end do
      call self%page%append(head // new_line('a'))
   end function begin_sheet


   !> Write a row, as many numbers as there are columns.
   subroutine row_of_words(self, numbers)
      class(sheet), intent(inout) :: self
      type(words), intent(in) :: numbers(:)
      character(len=:), allocatable :: line
      integer :: i

      line = ''
      call self%page%begin_row()
      do i = 1, size(numbers)
         associate (format => self%columns(i))
            if (.not. self%in_text) then
               call self%page%before_number(i)
               call self%page%append(data_of(self, numbers(i), format))
            else if (format%head /= '-') then
               call append(line, written(numbers(i), format, 0), format%width)
            end if
         end associate
      end do
      call self%page%append(line)
      call self%page%end_row()
   end subroutine row_of_words


   subroutine row_of_reals(self, numbers)
      class(sheet), intent(inout) :: self
      real(wp), intent(in) :: numbers(:)

      call self%row(words(numbers))
   end subroutine row_of_reals


   subroutine end(self)
      class(sheet), intent(inout) :: self

      call self%page%end()
   end subroutine end


   !> A number in csv or json, which has no infinity and no NaN
   pure function data_of(self, x, format) result(text)
      class(sheet), intent(in) :: self
      type(words), intent(in) :: x
      type(column), intent(in) :: format
      character(len=:), allocatable :: text

      text = 'null'
      if (abs(x%hi) <= huge(x%hi) .or. .not. self%page%in_json) text = written(x, format, format%in_csv)
   end function data_of


   pure function written(x, format, least) result(text)
      type(words), intent(in) :: x
      type(column), intent(in) :: format
      integer, intent(in) :: least
      character(len=:), allocatable :: text
      integer :: count, most_digits

      count = max(format%count, least)
      most_digits = merge(18, 15, format%style == places_of_words)
      if (format%style == powers) then
         text = scientific(x, count)
      else if (format%style == digits .or. .not. abs(x%hi) < 10.0_wp**(most_digits - count)) then
         text = significant(x, merge(count, most_digits, format%style == digits))
      else
         text = fixed(x, count)
      end if
   end function written


   elemental function head_of(format) result(head)
      type(column), intent(in) :: format
      character(len=20) :: head

      head = format%head
      if (head == '') head = format%name
   end function head_of


   !> What the numbers of a column need at most, most of the time
   elemental function least_width(format) result(width)
      type(column), intent(in) :: format
      integer :: width

      select case (format%style)
      case (whole)
         width = 4
      case (digits, powers)
         ! a point, and a sign or e-10
         width = format%count + merge(1, 5, format%count > 4)
      case default
         width = format%count + 4
      end select
   end function least_width


   !> Text behind as many blanks as make it that wide, at least one but at the beginning of a line
   pure subroutine append(line, text, width)
      character(len=:), allocatable, intent(inout) :: line
      character(len=*), intent(in) :: text
      integer, intent(in) :: width

      line = line // repeat(' ', max(min(1, len(line)), width - len(text))) // text
   end subroutine append

end module furiko_cli_sheet
