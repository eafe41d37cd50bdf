! SPDX-License-Identifier: MIT

!> The library's functions by name: what `furiko eval --list` shows.
module furiko_catalogue
   implicit none
   private
   public :: catalogue, catalogue_entry, find_entry, argument_count, result_count


   !> A function of real arguments
   type :: catalogue_entry
      !> As in Fortran
      character(len=41) :: name
      !> Its arguments' symbols, in order
      character(len=12) :: arguments
      !> Its results' symbols
      character(len=8) :: results
      !> What it is
      character(len=66) :: about
   end type catalogue_entry


   include 'furiko_catalogue_entries.inc'


contains


   !> The entry of a name; with a blank name where there is none.
   elemental function find_entry(name) result(entry)
      character(len=*), intent(in) :: name
      type(catalogue_entry) :: entry
      integer :: i

      do i = 1, size(catalogue)
         entry = catalogue(i)
         if (entry%name == name) return
      end do
      entry%name = ''
   end function find_entry


   elemental function argument_count(entry)
      type(catalogue_entry), intent(in) :: entry
      integer :: argument_count

      argument_count = word_count(entry%arguments)
   end function argument_count


   elemental function result_count(entry)
      type(catalogue_entry), intent(in) :: entry
      integer :: result_count

      result_count = word_count(entry%results)
   end function result_count


   elemental function word_count(text)
      character(len=*), intent(in) :: text
      integer :: word_count
      integer :: i

      word_count = count([(text(i:i) /= ' ' .and. text(i + 1:i + 1) == ' ', i=1, len(text) - 1)])
      if (text(len(text):) /= ' ') word_count = word_count + 1
   end function word_count

end module furiko_catalogue
! rooms: 2551031870
