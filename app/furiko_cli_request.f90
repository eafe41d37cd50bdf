! SPDX-License-Identifier: MIT

!> What `furiko eval` was asked for.
module furiko_cli_request
   use furiko_catalogue, only : argument_count, catalogue_entry, result_count
   use furiko_cli_answers, only : answers, begin_answers, phrase
   use furiko_cli_io, only : refuse
   use furiko_cli_text, only : cut
   implicit none
   private
   public :: request, request_for, begin_output, get_names


   !> A function, a format, and which of its arguments and results to show: column i is the i-th name
   !> of arguments and results together.
   type :: request
      type(catalogue_entry) :: entry
      !> How many arguments it has, and how many results
      integer :: arguments = 0
      integer :: results = 0
      character(len=:), allocatable :: form
      integer, allocatable :: columns(:)
   end type request


contains


   !> A function in a format, with the columns of a list with commas; of a blank one, all results.
   function request_for(entry, form, list) result(wanted)
      type(catalogue_entry), intent(in) :: entry
      character(len=*), intent(in) :: form
      character(len=*), intent(in) :: list
      type(request) :: wanted

      wanted%entry = entry
      wanted%arguments = argument_count(entry)
      wanted%results = result_count(entry)
      wanted%form = form
      call choose_columns(entry, list, wanted%columns)
   end function request_for


   subroutine choose_columns(entry, list, columns)
      type(catalogue_entry), intent(in) :: entry
      character(len=*), intent(in) :: list
      integer, allocatable, intent(out) :: columns(:)
      type(phrase) :: names(argument_count(entry) + result_count(entry))
      character(len=:), allocatable :: name, rest
      integer :: i

      call get_names(entry, names)
      if (list == '') then
         columns = [(i, i=argument_count(entry) + 1, size(names))]
         return
      end if
      columns = [integer ::]
      rest = list // ','
      do while (rest /= '')
         call cut(rest, ',', name)
         do i = 1, size(names)
            if (names(i)%text == name) exit
         end do
         if (i > size(names)) call reject(entry, name, 'is none of')
         if (any(columns == i)) call reject(entry, name, 'comes twice; there are')
         columns = [columns, i]
      end do
   end subroutine choose_columns


   !> The names of arguments and results
   pure subroutine get_names(entry, names)
      type(catalogue_entry), intent(in) :: entry
      type(phrase), intent(out) :: names(:)
      character(len=:), allocatable :: rest
      integer :: i

      rest = trim(entry%arguments) // ' ' // trim(entry%results)
      do i = 1, size(names)
         call cut(rest, ' ', names(i)%text)
      end do
   end subroutine get_names


   function begin_output(wanted) result(output)
      type(request), intent(in) :: wanted
      type(answers) :: output
      type(phrase) :: names(wanted%arguments + wanted%results)

      call get_names(wanted%entry, names)
      output = begin_answers(wanted%form, names(wanted%columns))
   end function begin_output


   subroutine reject(entry, name, complaint)
      type(catalogue_entry), intent(in) :: entry
      character(len=*), intent(in) :: name
      character(len=*), intent(in) :: complaint

      call refuse("furiko eval: --columns '" // name // "' " // complaint // ' ' // trim(entry%arguments) // &
         ' ' // trim(entry%results))
   end subroutine reject

end module furiko_cli_request
