! SPDX-License-Identifier: MIT
#include "../arithmetic/furiko_compiler.inc"

module furiko_trapezoid_sp
   use furiko_bits_sp, only : infinity, is_nan, nan
   use furiko_forms, only : by_k, by_m, by_mc
   use, intrinsic :: iso_fortran_env, only : wp => real32
   implicit none
   private
   include 'furiko_trapezoid.inc'
end module furiko_trapezoid_sp


module furiko_trapezoid_dp
   use furiko_bits_dp, only : infinity, is_nan, nan
   use furiko_forms, only : by_k, by_m, by_mc
   use, intrinsic :: iso_fortran_env, only : wp => real64
   implicit none
   private
   include 'furiko_trapezoid.inc'
end module furiko_trapezoid_dp


#ifdef FURIKO_REAL128
module furiko_trapezoid_qp
   use furiko_bits_qp, only : infinity, is_nan, nan
   use furiko_forms, only : by_k, by_m, by_mc
   use, intrinsic :: iso_fortran_env, only : wp => real128
   implicit none
   private
   include 'furiko_trapezoid.inc'
end module furiko_trapezoid_qp
#endif


!> K and E by the trapezoidal rule, whose error falls geometrically for a periodic integrand.
! allow(C121)
module furiko_trapezoid
   use furiko_trapezoid_sp
   use furiko_trapezoid_dp
#ifdef FURIKO_REAL128
   use furiko_trapezoid_qp
#endif
   implicit none
   public
end module furiko_trapezoid
! rooms: 332344304
