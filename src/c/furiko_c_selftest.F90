! SPDX-License-Identifier: MIT
#include "../arithmetic/furiko_compiler.inc"

!> Whether this build computes right, for C
module furiko_c_selftest
   use, intrinsic :: iso_c_binding, only : c_int
   use furiko_known_values, only : furiko_selftest
   implicit none
   private


contains


   !> How many known values come out wrong
   pure function c_selftest() result(wrong) bind(c, name='furiko_selftest')
      integer(c_int) :: wrong

      wrong = furiko_selftest()
   end function c_selftest

end module furiko_c_selftest
! rooms: 3759241635
