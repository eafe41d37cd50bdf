! SPDX-License-Identifier: MIT
#include "../arithmetic/furiko_compiler.inc"

! Written by tools/make_c_interface.py.

!> Inverses of Jacobi's functions, for C, in float; the text is in furiko_c_jacobi_inverse.inc.
module furiko_c_jacobi_inverse_sp
   use, intrinsic :: iso_c_binding, only : c_size_t, wp => c_float
   ! allow(C121)
   use furiko_jacobi_inverse ! all there is
   implicit none
   private
   ! What C's names end in
   character(len=*), parameter :: suffix = 'f'
   include 'furiko_c_jacobi_inverse.inc'
end module furiko_c_jacobi_inverse_sp


!> Inverses of Jacobi's functions, for C, in double; the text is in furiko_c_jacobi_inverse.inc.
module furiko_c_jacobi_inverse_dp
   use, intrinsic :: iso_c_binding, only : c_size_t, wp => c_double
   ! allow(C121)
   use furiko_jacobi_inverse ! all there is
   implicit none
   private
   ! What C's names end in
   character(len=*), parameter :: suffix = ''
   include 'furiko_c_jacobi_inverse.inc'
end module furiko_c_jacobi_inverse_dp
! rooms: 3775782951
