! SPDX-License-Identifier: MIT
#include "../arithmetic/furiko_compiler.inc"

! Written by tools/make_c_interface.py.

!> Incomplete integrals F, E, D, for C, in float; the text is in furiko_c_incomplete.inc.
module furiko_c_incomplete_sp
   use, intrinsic :: iso_c_binding, only : c_size_t, wp => c_float
   ! allow(C121)
   use furiko_incomplete ! all there is
   implicit none
   private
   ! What C's names end in
   character(len=*), parameter :: suffix = 'f'
   include 'furiko_c_incomplete.inc'
end module furiko_c_incomplete_sp


!> Incomplete integrals F, E, D, for C, in double; the text is in furiko_c_incomplete.inc.
module furiko_c_incomplete_dp
   use, intrinsic :: iso_c_binding, only : c_size_t, wp => c_double
   ! allow(C121)
   use furiko_incomplete ! all there is
   implicit none
   private
   ! What C's names end in
   character(len=*), parameter :: suffix = ''
   include 'furiko_c_incomplete.inc'
end module furiko_c_incomplete_dp
! rooms: 2689302511
