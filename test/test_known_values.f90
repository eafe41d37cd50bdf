! SPDX-License-Identifier: MIT

!> The self-test: 0 in this build. That it counts what is wrong is seen where it matters, in builds
!> whose flags break IEEE arithmetic (.ci/run).
module test_known_values
   use furiko, only : furiko_selftest
   use testdrive, only : check, error_type, new_unittest, unittest_type
   implicit none
   private
   public :: collect_known_values


contains


   subroutine collect_known_values(testsuite)
      type(unittest_type), allocatable, intent(out) :: testsuite(:)

      testsuite = [new_unittest('nothing-comes-out-wrong', test_nothing_wrong)]
   end subroutine collect_known_values


   subroutine test_nothing_wrong(error)
      type(error_type), allocatable, intent(out) :: error

      call check(error, furiko_selftest(), 0)
   end subroutine test_nothing_wrong

end module test_known_values
