! SPDX-License-Identifier: MIT
#include "../arithmetic/furiko_compiler.inc"

!> Symplectic steps of any system for C, in float; the text is in furiko_c_symplectic.inc. A file of its own
!> since gfortran takes the interfaces of two kinds in one file for one.
module furiko_c_symplectic_sp
   use, intrinsic :: iso_c_binding, only : c_f_procpointer, c_funptr, c_int, c_ptr, c_size_t, wp => c_float
   use furiko_symplectic_sp, only : forest_ruth, verlet
   implicit none
   private
   ! What C's names end in
   character(len=*), parameter :: suffix = 'f'
   include 'furiko_c_symplectic.inc'
end module furiko_c_symplectic_sp
! rooms: 1559095282
