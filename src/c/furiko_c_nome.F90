! SPDX-License-Identifier: MIT
#include "../arithmetic/furiko_compiler.inc"

! Written by tools/make_c_interface.py.

!> The nome, for C, in float; the text is in furiko_c_nome.inc.
module furiko_c_nome_sp
   use, intrinsic :: iso_c_binding, only : c_size_t, wp => c_float
   ! allow(C121)
   use furiko_nome ! all there is
   implicit none
   private
   ! What C's names end in
   character(len=*), parameter :: suffix = 'f'
   include 'furiko_c_nome.inc'
end module furiko_c_nome_sp


!> The nome, for C, in double; the text is in furiko_c_nome.inc.
module furiko_c_nome_dp
   use, intrinsic :: iso_c_binding, only : c_size_t, wp => c_double
   ! allow(C121)
   use furiko_nome ! all there is
   implicit none
   private
   ! What C's names end in
   character(len=*), parameter :: suffix = ''
   include 'furiko_c_nome.inc'
end module furiko_c_nome_dp
! rooms: 224828390
