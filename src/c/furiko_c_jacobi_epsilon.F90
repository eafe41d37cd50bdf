! SPDX-License-Identifier: MIT
#include "../arithmetic/furiko_compiler.inc"

! Written by tools/make_c_interface.py.

!> Jacobi's epsilon, for C, in float; the text is in furiko_c_jacobi_epsilon.inc.
module furiko_c_jacobi_epsilon_sp
   use, intrinsic :: iso_c_binding, only : c_size_t, wp => c_float
   ! allow(C121)
   use furiko_jacobi_epsilon ! all there is
   implicit none
   private
   ! What C's names end in
   character(len=*), parameter :: suffix = 'f'
   include 'furiko_c_jacobi_epsilon.inc'
end module furiko_c_jacobi_epsilon_sp


!> Jacobi's epsilon, for C, in double; the text is in furiko_c_jacobi_epsilon.inc.
module furiko_c_jacobi_epsilon_dp
   use, intrinsic :: iso_c_binding, only : c_size_t, wp => c_double
   ! allow(C121)
   use furiko_jacobi_epsilon ! all there is
   implicit none
   private
   ! What C's names end in
   character(len=*), parameter :: suffix = ''
   include 'furiko_c_jacobi_epsilon.inc'
end module furiko_c_jacobi_epsilon_dp
! rooms: 1610970030
