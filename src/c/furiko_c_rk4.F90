! SPDX-License-Identifier: MIT
#include "../arithmetic/furiko_compiler.inc"

! Its C name is that of a module, of which no C program knows: so the kind's module is used, lest a compiler
! that sees both in one file object.

!> Runge-Kutta steps of any system for C, in double; the text is in furiko_c_rk4.inc.
module furiko_c_rk4_dp
   use, intrinsic :: iso_c_binding, only : c_f_procpointer, c_funptr, c_int, c_ptr, c_size_t, wp => c_double
   use furiko_rk4_dp, only : rk4
   implicit none
   private
   ! What C's names end in
   character(len=*), parameter :: suffix = ''
   include 'furiko_c_rk4.inc'
end module furiko_c_rk4_dp
! rooms: 3434904353
