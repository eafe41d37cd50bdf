! SPDX-License-Identifier: MIT
#include "../arithmetic/furiko_compiler.inc"

!> The library's functions called by name, in each kind of real; the text is in furiko_by_name.inc.
module furiko_by_name_sp
   use, intrinsic :: iso_fortran_env, only : wp => real32
   use furiko_bits_sp, only : nan
   ! allow(C121)
   use furiko ! all there is, by name
   implicit none
   private
   include 'furiko_by_name.inc'
end module furiko_by_name_sp


module furiko_by_name_dp
   use, intrinsic :: iso_fortran_env, only : wp => real64
   use furiko_bits_dp, only : nan
   ! allow(C121)
   use furiko ! all there is, by name
   implicit none
   private
   include 'furiko_by_name.inc'
end module furiko_by_name_dp


#ifdef FURIKO_REAL128
module furiko_by_name_qp
   use, intrinsic :: iso_fortran_env, only : wp => real128
   use furiko_bits_qp, only : nan
   ! allow(C121)
   use furiko ! all there is, by name
   implicit none
   private
   include 'furiko_by_name.inc'
end module furiko_by_name_qp
#endif


! allow(C121)
module furiko_by_name
   use furiko_by_name_sp
   use furiko_by_name_dp
#ifdef FURIKO_REAL128
   use furiko_by_name_qp
#endif
   implicit none
   public
end module furiko_by_name
! rooms: 1258907489
