! SPDX-License-Identifier: MIT
#include "../arithmetic/furiko_compiler.inc"

! Written by tools/make_c_interface.py.

!> The third kind, for C, in float; the text is in furiko_c_third_kind.inc.
module furiko_c_third_kind_sp
   use, intrinsic :: iso_c_binding, only : c_size_t, wp => c_float
   ! allow(C121)
   use furiko_third_kind ! all there is
   implicit none
   private
   ! What C's names end in
   character(len=*), parameter :: suffix = 'f'
   include 'furiko_c_third_kind.inc'
end module furiko_c_third_kind_sp


!> The third kind, for C, in double; the text is in furiko_c_third_kind.inc.
module furiko_c_third_kind_dp
   use, intrinsic :: iso_c_binding, only : c_size_t, wp => c_double
   ! allow(C121)
   use furiko_third_kind ! all there is
   implicit none
   private
   ! What C's names end in
   character(len=*), parameter :: suffix = ''
   include 'furiko_c_third_kind.inc'
end module furiko_c_third_kind_dp
! rooms: 2762755340
