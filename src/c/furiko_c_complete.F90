! SPDX-License-Identifier: MIT
#include "../arithmetic/furiko_compiler.inc"

! Written by tools/make_c_interface.py.

!> Complete integrals K, E, B, D, for C, in float; the text is in furiko_c_complete.inc.
module furiko_c_complete_sp
   use, intrinsic :: iso_c_binding, only : c_size_t, wp => c_float
   ! allow(C121)
   use furiko_complete ! all there is
   implicit none
   private
   ! What C's names end in
   character(len=*), parameter :: suffix = 'f'
   include 'furiko_c_complete.inc'
end module furiko_c_complete_sp


!> Complete integrals K, E, B, D, for C, in double; the text is in furiko_c_complete.inc.
module furiko_c_complete_dp
   use, intrinsic :: iso_c_binding, only : c_size_t, wp => c_double
   ! allow(C121)
   use furiko_complete ! all there is
   implicit none
   private
   ! What C's names end in
   character(len=*), parameter :: suffix = ''
   include 'furiko_c_complete.inc'
end module furiko_c_complete_dp
! rooms: 1747902010
