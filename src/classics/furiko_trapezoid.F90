! SPDX-License-Identifier: MIT

module furiko_trapezoid_sp
   use, intrinsic :: ieee_arithmetic, only : ieee_is_nan, ieee_positive_inf, ieee_quiet_nan, &
      ieee_value
   use, intrinsic :: iso_fortran_env, only : wp => real32
   implicit none
   private
   include 'furiko_trapezoid.inc'
end module furiko_trapezoid_sp


module furiko_trapezoid_dp
   use, intrinsic :: ieee_arithmetic, only : ieee_is_nan, ieee_positive_inf, ieee_quiet_nan, &
      ieee_value
   use, intrinsic :: iso_fortran_env, only : wp => real64
   implicit none
   private
   include 'furiko_trapezoid.inc'
end module furiko_trapezoid_dp


#ifdef __GFC_REAL_16__
module furiko_trapezoid_qp
   use, intrinsic :: ieee_arithmetic, only : ieee_is_nan, ieee_positive_inf, ieee_quiet_nan, &
      ieee_value
   use, intrinsic :: iso_fortran_env, only : wp => real128
   implicit none
   private
   include 'furiko_trapezoid.inc'
end module furiko_trapezoid_qp
#endif


!> K and E by the trapezoidal rule, whose error falls geometrically for a periodic integrand.
module furiko_trapezoid
   use furiko_trapezoid_sp, only : ellipk_trapezoid_k, ellipk_trapezoid_m, ellipk_trapezoid_mc, &
      ellipe_trapezoid_k, ellipe_trapezoid_m, ellipe_trapezoid_mc
   use furiko_trapezoid_dp, only : ellipk_trapezoid_k, ellipk_trapezoid_m, ellipk_trapezoid_mc, &
      ellipe_trapezoid_k, ellipe_trapezoid_m, ellipe_trapezoid_mc
#ifdef __GFC_REAL_16__
   use furiko_trapezoid_qp, only : ellipk_trapezoid_k, ellipk_trapezoid_m, ellipk_trapezoid_mc, &
      ellipe_trapezoid_k, ellipe_trapezoid_m, ellipe_trapezoid_mc
#endif
   implicit none
   private
   public :: ellipk_trapezoid_k, ellipk_trapezoid_m, ellipk_trapezoid_mc, ellipe_trapezoid_k, &
      ellipe_trapezoid_m, ellipe_trapezoid_mc
end module furiko_trapezoid
