! SPDX-License-Identifier: MIT

!> Every name of the catalogue against its function: test/data/names.dat, written by make_names.py
module test_catalogue
   use, intrinsic :: iso_fortran_env, only : dp => real64, sp => real32
   use furiko_by_name_dp, only : evaluate_dp => evaluate
   use furiko_by_name_sp, only : evaluate_sp => evaluate
   use furiko_catalogue, only : argument_count, catalogue, catalogue_entry, find_entry, result_count
   use testdrive, only : check, error_type, new_unittest, unittest_type
   implicit none
   private
   public :: collect_catalogue


contains


   subroutine collect_catalogue(testsuite)
      type(unittest_type), allocatable, intent(out) :: testsuite(:)

      testsuite = [ &
         new_unittest('names-and-functions', test_names), &
         new_unittest('unknown-names', test_unknown)]
   end subroutine collect_catalogue


   !> Arguments in their order, alone and in an array; two rows for each name
   subroutine test_names(error)
      type(error_type), allocatable, intent(out) :: error
      character(len=400) :: line
      character(len=41) :: name
      type(catalogue_entry) :: entry
      integer :: arguments, results, stat, unit
      integer :: rows(size(catalogue))

      rows = 0
      open(newunit=unit, file='test/data/names.dat', status='old', action='read')
      read(unit, '(a)') line
      do
         read(unit, '(a)', iostat=stat) line
         if (stat /= 0) exit
         read(line, *) name, arguments, results
         entry = find_entry(name)
         where (catalogue%name == name) rows = rows + 1
         call check(error, argument_count(entry) == arguments .and. result_count(entry) == results, name)
         if (allocated(error)) return
         call check_row(error, line, trim(name), arguments, results)
         if (allocated(error)) return
      end do
      close(unit)
      call check(error, all(rows == 2))
   end subroutine test_names


   subroutine check_row(error, line, name, arguments, results)
      type(error_type), allocatable, intent(out) :: error
      character(len=*), intent(in) :: line
      character(len=*), intent(in) :: name
      integer, intent(in) :: arguments
      integer, intent(in) :: results
      character(len=41) :: word
      real(dp) :: x(arguments), right(results), y(results), many(3, results)
      integer :: counts(2), i

      read(line, *) word, counts, x, right
      call evaluate_dp(name, x, y)
      call evaluate_dp(name, spread(x, 1, 3), many)
      call check(error, all(abs(y - right) <= 16*epsilon(y)*abs(right)), line)
      if (allocated(error)) return
      do i = 1, 3
         call check(error, all(abs(many(i, :) - right) <= 16*epsilon(y)*abs(right)), 'array: ' // line)
         if (allocated(error)) return
      end do
      call check_single(error, line, name, real(x, sp), real(right, sp))
   end subroutine check_row


   !> In real32 the arguments are rounded, which counts for more than the functions' own errors.
   subroutine check_single(error, line, name, x, right)
      type(error_type), allocatable, intent(out) :: error
      character(len=*), intent(in) :: line
      character(len=*), intent(in) :: name
      real(sp), intent(in) :: x(:)
      real(sp), intent(in) :: right(:)
      real(sp) :: y(size(right)), many(2, size(right))

      call evaluate_sp(name, x, y)
      call evaluate_sp(name, spread(x, 1, 2), many)
      call check(error, all(abs([y, many(1, :), many(2, :)] - [right, right, right]) <= &
         64*epsilon(y)*abs([right, right, right])), 'real32: ' // line)
   end subroutine check_single


   !> A blank entry, and NaN
   subroutine test_unknown(error)
      type(error_type), allocatable, intent(out) :: error
      type(catalogue_entry) :: entry
      real(dp) :: y(1)

      entry = find_entry('ellipk')
      call check(error, entry%name, '')
      if (allocated(error)) return
      call evaluate_dp('ellipk', [0.5_dp], y)
      call check(error, .not. abs(y(1)) <= huge(y))
   end subroutine test_unknown

end module test_catalogue
