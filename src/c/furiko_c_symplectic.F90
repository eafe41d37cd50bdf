! SPDX-License-Identifier: MIT
#include "../arithmetic/furiko_compiler.inc"

!> Symplectic steps of any system for C, in double; the text is in furiko_c_symplectic.inc.
module furiko_c_symplectic_dp
   use, intrinsic :: iso_c_binding, only : c_f_procpointer, c_funptr, c_int, c_ptr, c_size_t, wp => c_double
   use furiko_symplectic_dp, only : forest_ruth, verlet
   implicit none
   private
   ! What C's names end in
   character(len=*), parameter :: suffix = ''
   include 'furiko_c_symplectic.inc'
end module furiko_c_symplectic_dp
! rooms: 1559095282
