! SPDX-License-Identifier: MIT

!> The row of names that may stand above the numbers.
module furiko_cli_header
   use, intrinsic :: iso_fortran_env, only : real64
   use furiko_cli_answers, only : answers, phrase
   use furiko_cli_fields, only : field
   use furiko_cli_number, only : is_no_number, read_number
   use furiko_cli_request, only : get_names, request
   implicit none
   private
   public :: read_header


contains


   !> Take the first row for a header if it is one: as many names as arguments, none of them a number.
   !> Then columns that pass through bear its names.
   subroutine read_header(line, fields, count, wanted, output, found, complaint)
      character(len=*), intent(in) :: line
      type(field), intent(in) :: fields(:)
      !> The line's fields
      integer, intent(in) :: count
      type(request), intent(in) :: wanted
      type(answers), intent(inout) :: output
      logical, intent(out) :: found
      !> Left alone where there is none
      character(len=:), allocatable, intent(inout) :: complaint
      integer :: i

      found = count == size(fields)
      do i = 1, size(fields)
         if (found) found = is_name(line(fields(i)%first:fields(i)%last))
      end do
      if (.not. found) return
      if (is_swapped(line, fields, wanted)) then
         complaint = "has the names of " // trim(wanted%entry%name) // &
            "'s arguments in another order than " // trim(wanted%entry%arguments)
      end if
      do i = 1, size(wanted%columns)
         if (wanted%columns(i) > size(fields)) cycle
         call output%rename(i, line(fields(wanted%columns(i))%first:fields(wanted%columns(i))%last))
      end do
   end subroutine read_header


   !> A letter (or what is not ASCII) and then letters, figures, and signs that are in no number
   pure function is_name(text) result(yes)
      character(len=*), intent(in) :: text
      logical :: yes
      character(len=*), parameter :: letters = 'abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ'
      real(real64) :: x
      integer :: i, verdict

      yes = len(text) > 0
      if (yes) yes = is_letter(text(1:1))
      do i = 2, len(text)
         yes = yes .and. (is_letter(text(i:i)) .or. scan(text(i:i), "0123456789_ ()[]/^%'") == 1)
      end do
      if (.not. yes) return
      call read_number(text, x, verdict)
      yes = verdict == is_no_number


   contains


      pure function is_letter(character)
         character(len=1), intent(in) :: character
         logical :: is_letter

         is_letter = index(letters, character) > 0 .or. iachar(character) > 127
      end function is_letter

   end function is_name


   !> Whether the names are those of the arguments, one of them at another's place
   pure function is_swapped(line, fields, wanted) result(swapped)
      character(len=*), intent(in) :: line
      type(field), intent(in) :: fields(:)
      type(request), intent(in) :: wanted
      logical :: swapped
      type(phrase) :: names(wanted%arguments + wanted%results)
      integer :: i, j

      call get_names(wanted%entry, names)
      swapped = .false.
      do i = 1, size(fields)
         do j = 1, size(fields)
            if (i /= j .and. line(fields(i)%first:fields(i)%last) == names(j)%text) swapped = .true.
         end do
      end do
   end function is_swapped

end module furiko_cli_header
