! SPDX-License-Identifier: MIT

!> Legendre's complete elliptic integrals, in each kind of real; the text is in
!> furiko_complete.inc.
module furiko_complete_sp
   use, intrinsic :: iso_fortran_env, only : wp => real32
   use, intrinsic :: ieee_arithmetic, only : ieee_is_nan, ieee_value, &
      ieee_positive_inf, ieee_quiet_nan
   use furiko_agm_sp, only : agm
   implicit none
   private
   include 'furiko_complete.inc'
end module furiko_complete_sp


module furiko_complete_dp
   use, intrinsic :: iso_fortran_env, only : wp => real64
   use, intrinsic :: ieee_arithmetic, only : ieee_is_nan, ieee_value, &
      ieee_positive_inf, ieee_quiet_nan
   use furiko_agm_dp, only : agm
   implicit none
   private
   include 'furiko_complete.inc'
end module furiko_complete_dp


#ifdef __GFC_REAL_16__
module furiko_complete_qp
   use, intrinsic :: iso_fortran_env, only : wp => real128
   use, intrinsic :: ieee_arithmetic, only : ieee_is_nan, ieee_value, &
      ieee_positive_inf, ieee_quiet_nan
   use furiko_agm_qp, only : agm
   implicit none
   private
   include 'furiko_complete.inc'
end module furiko_complete_qp
#endif


module furiko_complete
   use furiko_complete_sp, only : ellipk_k, ellipk_m, ellipk_mc, &
      ellipe_k, ellipe_m, ellipe_mc, ellipke_k, ellipke_m, ellipke_mc
   use furiko_complete_dp, only : ellipk_k, ellipk_m, ellipk_mc, &
      ellipe_k, ellipe_m, ellipe_mc, ellipke_k, ellipke_m, ellipke_mc
#ifdef __GFC_REAL_16__
   use furiko_complete_qp, only : ellipk_k, ellipk_m, ellipk_mc, &
      ellipe_k, ellipe_m, ellipe_mc, ellipke_k, ellipke_m, ellipke_mc
#endif
   implicit none
   private
   public :: ellipk_k, ellipk_m, ellipk_mc, &
      ellipe_k, ellipe_m, ellipe_mc, ellipke_k, ellipke_m, ellipke_mc
end module furiko_complete
