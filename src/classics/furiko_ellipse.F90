! SPDX-License-Identifier: MIT

module furiko_ellipse_sp
   use, intrinsic :: ieee_arithmetic, only : ieee_is_nan, ieee_quiet_nan, ieee_value
   use, intrinsic :: iso_fortran_env, only : int32, wp => real32
   use furiko_half_pi_sp, only : half_pi
   use furiko_series_sp, only : ellipe_series_m
   implicit none
   private
   include 'furiko_ellipse.inc'
   include '../arithmetic/furiko_head_sp.inc'
end module furiko_ellipse_sp


module furiko_ellipse_dp
   use, intrinsic :: ieee_arithmetic, only : ieee_is_nan, ieee_quiet_nan, ieee_value
   use, intrinsic :: iso_fortran_env, only : int64, wp => real64
   use furiko_half_pi_dp, only : half_pi
   use furiko_series_dp, only : ellipe_series_m
   implicit none
   private
   include 'furiko_ellipse.inc'
   include '../arithmetic/furiko_head_dp.inc'
end module furiko_ellipse_dp


#ifdef __GFC_REAL_16__
module furiko_ellipse_qp
   use, intrinsic :: ieee_arithmetic, only : ieee_is_nan, ieee_quiet_nan, ieee_value
   use, intrinsic :: iso_fortran_env, only : int32, int64, wp => real128
   use furiko_half_pi_qp, only : half_pi
   use furiko_series_qp, only : ellipe_series_m
   implicit none
   private
   include 'furiko_ellipse.inc'
   include '../arithmetic/furiko_head_qp.inc'
end module furiko_ellipse_qp
#endif


!> The perimeter of an ellipse, in each kind of real.
module furiko_ellipse
   use furiko_ellipse_sp, only : ellipse_perimeter, ellipse_perimeter_series
   use furiko_ellipse_dp, only : ellipse_perimeter, ellipse_perimeter_series
#ifdef __GFC_REAL_16__
   use furiko_ellipse_qp, only : ellipse_perimeter, ellipse_perimeter_series
#endif
   implicit none
   private
   public :: ellipse_perimeter, ellipse_perimeter_series
end module furiko_ellipse
