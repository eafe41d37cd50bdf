! SPDX-License-Identifier: MIT
#include "../arithmetic/furiko_compiler.inc"

! Written by tools/make_c_interface.py.

!> The ellipse, for C, in float; the text is in furiko_c_ellipse.inc.
module furiko_c_ellipse_sp
   use, intrinsic :: iso_c_binding, only : c_size_t, wp => c_float
   ! allow(C121)
   use furiko_ellipse ! all there is
   implicit none
   private
   ! What C's names end in
   character(len=*), parameter :: suffix = 'f'
   include 'furiko_c_ellipse.inc'
end module furiko_c_ellipse_sp


!> The ellipse, for C, in double; the text is in furiko_c_ellipse.inc.
module furiko_c_ellipse_dp
   use, intrinsic :: iso_c_binding, only : c_size_t, wp => c_double
   ! allow(C121)
   use furiko_ellipse ! all there is
   implicit none
   private
   ! What C's names end in
   character(len=*), parameter :: suffix = ''
   include 'furiko_c_ellipse.inc'
end module furiko_c_ellipse_dp
! rooms: 486486108
