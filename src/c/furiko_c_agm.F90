! SPDX-License-Identifier: MIT
#include "../arithmetic/furiko_compiler.inc"

! Written by tools/make_c_interface.py.
! The kinds' modules are used, since a compiler objects that sees C's name and the module's in one file.

!> Arithmetic-geometric mean, for C, in float; the text is in furiko_c_agm.inc.
module furiko_c_agm_sp
   use, intrinsic :: iso_c_binding, only : c_size_t, wp => c_float
   ! allow(C121)
   use furiko_agm_sp ! all there is
   implicit none
   private
   ! What C's names end in
   character(len=*), parameter :: suffix = 'f'
   include 'furiko_c_agm.inc'
end module furiko_c_agm_sp


!> Arithmetic-geometric mean, for C, in double; the text is in furiko_c_agm.inc.
module furiko_c_agm_dp
   use, intrinsic :: iso_c_binding, only : c_size_t, wp => c_double
   ! allow(C121)
   use furiko_agm_dp ! all there is
   implicit none
   private
   ! What C's names end in
   character(len=*), parameter :: suffix = ''
   include 'furiko_c_agm.inc'
end module furiko_c_agm_dp
! rooms: 1406635848
