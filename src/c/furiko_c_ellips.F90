! SPDX-License-Identifier: MIT
#include "../arithmetic/furiko_compiler.inc"

! Written by tools/make_c_interface.py.

!> The complete integral S, for C, in float; the text is in furiko_c_ellips.inc.
module furiko_c_ellips_sp
   use, intrinsic :: iso_c_binding, only : c_size_t, wp => c_float
   ! allow(C121)
   use furiko_ellips ! all there is
   implicit none
   private
   ! What C's names end in
   character(len=*), parameter :: suffix = 'f'
   include 'furiko_c_ellips.inc'
end module furiko_c_ellips_sp


!> The complete integral S, for C, in double; the text is in furiko_c_ellips.inc.
module furiko_c_ellips_dp
   use, intrinsic :: iso_c_binding, only : c_size_t, wp => c_double
   ! allow(C121)
   use furiko_ellips ! all there is
   implicit none
   private
   ! What C's names end in
   character(len=*), parameter :: suffix = ''
   include 'furiko_c_ellips.inc'
end module furiko_c_ellips_dp
! rooms: 3028245656
