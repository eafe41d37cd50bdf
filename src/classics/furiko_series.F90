! SPDX-License-Identifier: MIT

module furiko_series_sp
   use, intrinsic :: ieee_arithmetic, only : ieee_is_nan, ieee_positive_inf, ieee_quiet_nan, &
      ieee_value
   use, intrinsic :: iso_fortran_env, only : wp => real32
   implicit none
   private
   include 'furiko_series.inc'
end module furiko_series_sp


module furiko_series_dp
   use, intrinsic :: ieee_arithmetic, only : ieee_is_nan, ieee_positive_inf, ieee_quiet_nan, &
      ieee_value
   use, intrinsic :: iso_fortran_env, only : wp => real64
   implicit none
   private
   include 'furiko_series.inc'
end module furiko_series_dp


#ifdef __GFC_REAL_16__
module furiko_series_qp
   use, intrinsic :: ieee_arithmetic, only : ieee_is_nan, ieee_positive_inf, ieee_quiet_nan, &
      ieee_value
   use, intrinsic :: iso_fortran_env, only : wp => real128
   implicit none
   private
   include 'furiko_series.inc'
end module furiko_series_qp
#endif


!> The power series of K and E, to any number of terms, and the bound on what is left.
module furiko_series
   use furiko_series_sp, only : ellipk_series_k, ellipk_series_m, ellipk_remainder_k, &
      ellipk_remainder_m, ellipe_series_k, ellipe_series_m, ellipe_remainder_k, &
      ellipe_remainder_m, period_ratio_series, amplitude_three_terms
   use furiko_series_dp, only : ellipk_series_k, ellipk_series_m, ellipk_remainder_k, &
      ellipk_remainder_m, ellipe_series_k, ellipe_series_m, ellipe_remainder_k, &
      ellipe_remainder_m, period_ratio_series, amplitude_three_terms
#ifdef __GFC_REAL_16__
   use furiko_series_qp, only : ellipk_series_k, ellipk_series_m, ellipk_remainder_k, &
      ellipk_remainder_m, ellipe_series_k, ellipe_series_m, ellipe_remainder_k, &
      ellipe_remainder_m, period_ratio_series, amplitude_three_terms
#endif
   implicit none
   private
   public :: ellipk_series_k, ellipk_series_m, ellipk_remainder_k, ellipk_remainder_m, &
      ellipe_series_k, ellipe_series_m, ellipe_remainder_k, ellipe_remainder_m, &
      period_ratio_series, amplitude_three_terms
end module furiko_series
