! SPDX-License-Identifier: MIT

!> Suites whose outcome is known
module runner_suites
   use testdrive, only : error_type, unittest_type, new_unittest, check, skip_test, test_failed
   implicit none
   private

   public :: collect_good, collect_bad, collect_lost, collect_none

contains

   subroutine collect_good(testsuite)
      type(unittest_type), allocatable, intent(out) :: testsuite(:)
      testsuite = [ &
         new_unittest("passes", test_passes), &
         new_unittest("fails-as-it-should", test_fails, should_fail=.true.), &
         new_unittest("skips", test_skips), &
         new_unittest("skips-too", test_skips, should_fail=.true.) &
         ]
   end subroutine collect_good

   subroutine collect_bad(testsuite)
      type(unittest_type), allocatable, intent(out) :: testsuite(:)
      testsuite = [ &
         new_unittest("passes", test_passes), &
         new_unittest("fails", test_fails), &
         new_unittest("passes-as-it-should-not", test_passes, should_fail=.true.), &
         new_unittest("fails-first-only", test_fails_first_only), &
         new_unittest("skips", test_skips) &
         ]
   end subroutine collect_bad

   subroutine collect_lost(testsuite)
      type(unittest_type), allocatable, intent(out) :: testsuite(:)
      testsuite = [new_unittest("loses-a-failure", test_loses_a_failure)]
   end subroutine collect_lost

   subroutine collect_none(testsuite)
      type(unittest_type), allocatable, intent(out) :: testsuite(:)
      allocate(testsuite(0))
   end subroutine collect_none

   subroutine test_passes(error)
      type(error_type), allocatable, intent(out) :: error
      call check(error, 1, 1)
   end subroutine test_passes

   subroutine test_fails(error)
      type(error_type), allocatable, intent(out) :: error
      call check(error, 1, 2, "one is not two")
   end subroutine test_fails

   subroutine test_fails_first_only(error)
      type(error_type), allocatable, intent(out) :: error
      call test_failed(error, "the first")
      call check(error, .false., "the second")
      call check(error, .true.)
   end subroutine test_fails_first_only

   subroutine test_skips(error)
      type(error_type), allocatable, intent(out) :: error
      call skip_test(error, "nothing to run on")
   end subroutine test_skips

   !> The helper's intent(out) forgets the failure of its first call
   subroutine test_loses_a_failure(error)
      type(error_type), allocatable, intent(out) :: error
      call helper(error, 2)
      call helper(error, 1)
   end subroutine test_loses_a_failure

   subroutine helper(error, i)
      type(error_type), allocatable, intent(out) :: error
      integer, intent(in) :: i
      call check(error, i, 1)
   end subroutine helper

end module runner_suites

!> The usual test driver: `runner [suite [test]]`
program runner
   use, intrinsic :: iso_fortran_env, only : error_unit
   use runner_suites, only : collect_good, collect_bad, collect_lost, collect_none
   use testdrive, only : testsuite_type, unittest_type, new_testsuite, select_suite, select_test, &
      run_testsuite, run_selected, get_argument
   implicit none
   type(testsuite_type), allocatable :: suites(:)
   type(unittest_type), allocatable :: tests(:)
   character(len=:), allocatable :: suite, test
   integer :: stat, is

   suites = [new_testsuite("good", collect_good), new_testsuite(name="none", collect=collect_none), &
      new_testsuite("bad", collect_bad), new_testsuite("lost", collect_lost)]
   stat = 0
   call get_argument(1, suite)
   call get_argument(2, test)
   if (.not. allocated(suite)) suite = "good"
   is = select_suite(suites, suite)
   write(error_unit, '(a, i0)') "suite ", is
   if (is == 0) error stop 3

   if (allocated(test)) then
      call suites(is)%collect(tests)
      write(error_unit, '(a, i0)') "test ", select_test(tests, test)
      call run_selected(suites(is)%collect, test, error_unit, stat)
   else
      call run_testsuite(suites(is)%collect, unit=error_unit, stat=stat, parallel=.false.)
      call run_testsuite(collect_none, error_unit, stat)
   end if
   write(error_unit, '(a, i0)') "stat ", stat
   if (stat /= 0) error stop 1
end program runner
