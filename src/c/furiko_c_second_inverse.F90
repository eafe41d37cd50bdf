! SPDX-License-Identifier: MIT
#include "../arithmetic/furiko_compiler.inc"

! Written by tools/make_c_interface.py.

!> The inverse of E(phi), for C, in float; the text is in furiko_c_second_inverse.inc.
module furiko_c_second_inverse_sp
   use, intrinsic :: iso_c_binding, only : c_size_t, wp => c_float
   ! allow(C121)
   use furiko_second_inverse ! all there is
   implicit none
   private
   ! What C's names end in
   character(len=*), parameter :: suffix = 'f'
   include 'furiko_c_second_inverse.inc'
end module furiko_c_second_inverse_sp


!> The inverse of E(phi), for C, in double; the text is in furiko_c_second_inverse.inc.
module furiko_c_second_inverse_dp
   use, intrinsic :: iso_c_binding, only : c_size_t, wp => c_double
   ! allow(C121)
   use furiko_second_inverse ! all there is
   implicit none
   private
   ! What C's names end in
   character(len=*), parameter :: suffix = ''
   include 'furiko_c_second_inverse.inc'
end module furiko_c_second_inverse_dp
! rooms: 173596341
