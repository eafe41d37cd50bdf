! SPDX-License-Identifier: MIT
#include "../arithmetic/furiko_compiler.inc"

! Written by tools/make_c_interface.py.

!> Jacobi's zeta, Heuman's lambda, for C, in float; the text is in furiko_c_jacobi_zeta.inc.
module furiko_c_jacobi_zeta_sp
   use, intrinsic :: iso_c_binding, only : c_size_t, wp => c_float
   ! allow(C121)
   use furiko_jacobi_zeta ! all there is
   implicit none
   private
   ! What C's names end in
   character(len=*), parameter :: suffix = 'f'
   include 'furiko_c_jacobi_zeta.inc'
end module furiko_c_jacobi_zeta_sp


!> Jacobi's zeta, Heuman's lambda, for C, in double; the text is in furiko_c_jacobi_zeta.inc.
module furiko_c_jacobi_zeta_dp
   use, intrinsic :: iso_c_binding, only : c_size_t, wp => c_double
   ! allow(C121)
   use furiko_jacobi_zeta ! all there is
   implicit none
   private
   ! What C's names end in
   character(len=*), parameter :: suffix = ''
   include 'furiko_c_jacobi_zeta.inc'
end module furiko_c_jacobi_zeta_dp
! rooms: 1375359870
