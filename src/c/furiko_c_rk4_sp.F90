! SPDX-License-Identifier: MIT
#include "../arithmetic/furiko_compiler.inc"

!> Runge-Kutta steps of any system for C, in float; the text is in furiko_c_rk4.inc. A file of its own since
!> gfortran takes the interfaces of two kinds in one file for one.
module furiko_c_rk4_sp
   use, intrinsic :: iso_c_binding, only : c_f_procpointer, c_funptr, c_int, c_ptr, c_size_t, wp => c_float
   use furiko_rk4_sp, only : rk4
   implicit none
   private
   ! What C's names end in
   character(len=*), parameter :: suffix = 'f'
   include 'furiko_c_rk4.inc'
end module furiko_c_rk4_sp
! rooms: 3434904353
