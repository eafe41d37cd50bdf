! SPDX-License-Identifier: MIT
#include "../arithmetic/furiko_compiler.inc"

!> The arithmetic-geometric mean, in each kind of real; the text is in furiko_agm.inc.
module furiko_agm_sp
   use, intrinsic :: iso_fortran_env, only : wp => real32, ip => int32
   use furiko_bits_sp, only : is_nan, nan
   implicit none
   private
   include 'furiko_agm.inc'
#include "../arithmetic/furiko_bits.inc"
   include '../arithmetic/furiko_head.inc'
end module furiko_agm_sp


module furiko_agm_dp
   use, intrinsic :: iso_fortran_env, only : wp => real64, ip => int64
   use furiko_bits_dp, only : is_nan, nan
   implicit none
   private
   include 'furiko_agm.inc'
#include "../arithmetic/furiko_bits.inc"
   include '../arithmetic/furiko_head.inc'
end module furiko_agm_dp


#ifdef FURIKO_REAL128
module furiko_agm_qp
   use, intrinsic :: iso_fortran_env, only : wp => real128
   use furiko_bits_qp, only : head, is_nan, nan
   implicit none
   private
   include 'furiko_agm.inc'
end module furiko_agm_qp
#endif


! allow(C121)
module furiko_agm
   use furiko_agm_sp
   use furiko_agm_dp
#ifdef FURIKO_REAL128
   use furiko_agm_qp
#endif
   implicit none
   public
end module furiko_agm
! rooms: 345378204
