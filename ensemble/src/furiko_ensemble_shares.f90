! SPDX-License-Identifier: MIT

!> Which chunks a process has to do: a pure function of their numbers and of the marks, so that no process
!> asks another. The marks are read on the way, so that memory does not depend on how many there are.
module furiko_ensemble_shares
   use, intrinsic :: iso_fortran_env, only : int64
   use furiko_ensemble_file, only : ensemble_file, is_done
   implicit none
   private
   public :: count_chunks, count_done, source_of, take_next


contains


   !> How many chunks are there, in all and of this part, and how many of this part each process has to do.
   !> Process r of R of part p of P has the chunks of part p + P r of P R.
   subroutine count_chunks(file, sources, part, parts, found, of_part, of_each, trouble)
      type(ensemble_file), intent(inout) :: file
      !> Files to copy from; none: what is not there is computed
      type(ensemble_file), intent(inout) :: sources(:)
      integer, intent(in) :: part
      integer, intent(in) :: parts
      integer(int64), intent(out) :: found
      integer(int64), intent(out) :: of_part
      integer(int64), intent(out) :: of_each(:)
      character(len=:), allocatable, intent(out) :: trouble
      integer(int64) :: chunk
      integer :: i, owner

      found = 0
      of_part = 0
      of_each = 0
      do chunk = 0, file%chunks - 1
         if (is_done(file, chunk)) then
            found = found + 1
            if (modulo(chunk, int(parts, int64)) == part - 1) of_part = of_part + 1
         else if (modulo(chunk, int(parts, int64)) == part - 1 .and. can_be_done(sources, chunk)) then
            owner = int(modulo(chunk/parts, size(of_each, kind=int64))) + 1
            of_each(owner) = of_each(owner) + 1
         end if
      end do
      trouble = ''
      if (file%unreadable) trouble = file%path // ': cannot be read'
      do i = 1, size(sources)
         if (sources(i)%unreadable) trouble = sources(i)%path // ': cannot be read'
      end do
   end subroutine count_chunks


   !> The next chunk to do from `next` on, -1 if there is none, and where to look for the one after it
   subroutine take_next(file, sources, stride, next, chunk)
      type(ensemble_file), intent(inout) :: file
      type(ensemble_file), intent(inout) :: sources(:)
      integer(int64), intent(in) :: stride
      integer(int64), intent(inout) :: next
      integer(int64), intent(out) :: chunk

      do while (next < file%chunks)
         chunk = next
         next = next + stride
         if (.not. is_done(file, chunk) .and. can_be_done(sources, chunk)) return
      end do
      chunk = -1
   end subroutine take_next


   !> Without files to copy from, every chunk can be computed.
   function can_be_done(sources, chunk)
      type(ensemble_file), intent(inout) :: sources(:)
      integer(int64), intent(in) :: chunk
      logical :: can_be_done

      can_be_done = size(sources) == 0
      if (.not. can_be_done) can_be_done = source_of(sources, chunk) > 0
   end function can_be_done


   !> The first of the files that has a chunk; 0 for none
   function source_of(sources, chunk) result(i)
      type(ensemble_file), intent(inout) :: sources(:)
      integer(int64), intent(in) :: chunk
      integer :: i

      do i = 1, size(sources)
         if (is_done(sources(i), chunk)) return
      end do
      i = 0
   end function source_of


   !> How many chunks a file has
   subroutine count_done(file, found, trouble)
      type(ensemble_file), intent(inout) :: file
      integer(int64), intent(out) :: found
      character(len=:), allocatable, intent(out) :: trouble
      type(ensemble_file) :: none(0)
      integer(int64) :: of_part, of_each(1)

      call count_chunks(file, none, 1, 1, found, of_part, of_each, trouble)
   end subroutine count_done
end module furiko_ensemble_shares
