! SPDX-License-Identifier: MIT

!> Rows of words on standard input: blank lines and # comments skipped, lines counted.
module furiko_cli_words
   use, intrinsic :: iso_fortran_env, only : input_unit
   implicit none
   private
   public :: next_row, first_word


   !> What stands between words
   character(len=*), parameter :: separators = ' ,' // achar(9) // achar(13)


contains


   !> The next line with words in it. `stat` is 0, or negative behind the last line, or positive
   !> where the line is longer than 1000 characters or cannot be read; `line` is its number.
   subroutine next_row(row, line, stat)
      character(len=:), allocatable, intent(out) :: row
      integer, intent(inout) :: line
      integer, intent(out) :: stat
      character(len=1000) :: buffer
      integer :: length

      do
         read(input_unit, '(a)', advance='no', iostat=stat, size=length) buffer
         if (is_iostat_end(stat)) return
         line = line + 1
         if (.not. is_iostat_eor(stat)) then
            stat = 1
            return
         end if
         stat = 0
         row = buffer(:length)
         if (verify(row, separators) > 0 .and. index(row, '#') /= 1) return
      end do
   end subroutine next_row


   !> Cut the first word off a row; empty where there is none left.
   pure subroutine first_word(row, word)
      character(len=:), allocatable, intent(inout) :: row
      character(len=:), allocatable, intent(out) :: word
      integer :: first, last

      first = verify(row, separators)
      if (first == 0) then
         word = ''
         return
      end if
      last = scan(row(first:) // ' ', separators) + first - 2
      word = row(first:last)
      row = row(last + 1:)
   end subroutine first_word

end module furiko_cli_words
