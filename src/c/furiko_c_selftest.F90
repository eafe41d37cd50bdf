! SPDX-License-Identifier: MIT
#include "../arithmetic/furiko_compiler.inc"

!> Whether this build computes right, for C; the text is in furiko_c_selftest.inc.
module furiko_c_selftest
   use, intrinsic :: iso_c_binding, only : c_int
   use furiko_known_values, only : furiko_selftest
   implicit none
   private
   include 'furiko_c_selftest.inc'
end module furiko_c_selftest
! rooms: 2088769943
