! SPDX-License-Identifier: MIT
#include "../arithmetic/furiko_compiler.inc"

module furiko_ellipse_sp
   use, intrinsic :: iso_fortran_env, only : ip => int32, wp => real32
   use furiko_bits_sp, only : is_nan, nan
   use furiko_half_pi_sp, only : half_pi
   use furiko_series_sp, only : ellipe_series_m
   implicit none
   private
   include 'furiko_ellipse.inc'
#include "../arithmetic/furiko_bits.inc"
   include '../arithmetic/furiko_head.inc'
end module furiko_ellipse_sp


module furiko_ellipse_dp
   use, intrinsic :: iso_fortran_env, only : ip => int64, wp => real64
   use furiko_bits_dp, only : is_nan, nan
   use furiko_half_pi_dp, only : half_pi
   use furiko_series_dp, only : ellipe_series_m
   implicit none
   private
   include 'furiko_ellipse.inc'
#include "../arithmetic/furiko_bits.inc"
   include '../arithmetic/furiko_head.inc'
end module furiko_ellipse_dp


#ifdef FURIKO_REAL128
module furiko_ellipse_qp
   use, intrinsic :: iso_fortran_env, only : wp => real128
   use furiko_bits_qp, only : head, is_nan, nan
   use furiko_half_pi_qp, only : half_pi
   use furiko_series_qp, only : ellipe_series_m
   implicit none
   private
   include 'furiko_ellipse.inc'
end module furiko_ellipse_qp
#endif


!> The perimeter of an ellipse, in each kind of real.
! allow(C121)
module furiko_ellipse
   use furiko_ellipse_sp
   use furiko_ellipse_dp
#ifdef FURIKO_REAL128
   use furiko_ellipse_qp
#endif
   implicit none
   public
end module furiko_ellipse
! rooms: 3277990022
