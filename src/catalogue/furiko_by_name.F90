! SPDX-License-Identifier: MIT

!> The library's functions called by name, in each kind of real; the text is in furiko_by_name.inc.
module furiko_by_name_sp
   use, intrinsic :: iso_fortran_env, only : wp => real32
   use, intrinsic :: ieee_arithmetic, only : ieee_quiet_nan, ieee_value
   use furiko_agm_sp, only : agm
   use furiko_complete_sp, only : ellipk_k, ellipk_m, ellipk_mc, ellipk_alpha, ellipe_k, &
      ellipe_m, ellipe_mc, ellipe_alpha, ellipke_k, ellipke_m, ellipke_mc, ellipke_alpha, &
      ellipb_k, ellipb_m, ellipb_mc, ellipb_alpha, ellipd_k, ellipd_m, ellipd_mc, ellipd_alpha
   use furiko_third_kind_sp, only : ellippi_k, ellippi_m, ellippi_mc, ellippiinc_k, &
      ellippiinc_m, ellippiinc_mc
   use furiko_incomplete_sp, only : ellipf_k, ellipf_m, ellipf_mc, ellipeinc_k, ellipeinc_m, &
      ellipeinc_mc, ellipdinc_k, ellipdinc_m, ellipdinc_mc
   use furiko_carlson_sp, only : carlson_rf, carlson_rc, carlson_rd, carlson_rj, carlson_rg
   use furiko_period_sp, only : period_ratio
   implicit none
   private
   include 'furiko_by_name.inc'
end module furiko_by_name_sp


module furiko_by_name_dp
   use, intrinsic :: iso_fortran_env, only : wp => real64
   use, intrinsic :: ieee_arithmetic, only : ieee_quiet_nan, ieee_value
   use furiko_agm_dp, only : agm
   use furiko_complete_dp, only : ellipk_k, ellipk_m, ellipk_mc, ellipk_alpha, ellipe_k, &
      ellipe_m, ellipe_mc, ellipe_alpha, ellipke_k, ellipke_m, ellipke_mc, ellipke_alpha, &
      ellipb_k, ellipb_m, ellipb_mc, ellipb_alpha, ellipd_k, ellipd_m, ellipd_mc, ellipd_alpha
   use furiko_third_kind_dp, only : ellippi_k, ellippi_m, ellippi_mc, ellippiinc_k, &
      ellippiinc_m, ellippiinc_mc
   use furiko_incomplete_dp, only : ellipf_k, ellipf_m, ellipf_mc, ellipeinc_k, ellipeinc_m, &
      ellipeinc_mc, ellipdinc_k, ellipdinc_m, ellipdinc_mc
   use furiko_carlson_dp, only : carlson_rf, carlson_rc, carlson_rd, carlson_rj, carlson_rg
   use furiko_period_dp, only : period_ratio
   implicit none
   private
   include 'furiko_by_name.inc'
end module furiko_by_name_dp


#ifdef __GFC_REAL_16__
module furiko_by_name_qp
   use, intrinsic :: iso_fortran_env, only : wp => real128
   use, intrinsic :: ieee_arithmetic, only : ieee_quiet_nan, ieee_value
   use furiko_agm_qp, only : agm
   use furiko_complete_qp, only : ellipk_k, ellipk_m, ellipk_mc, ellipk_alpha, ellipe_k, &
      ellipe_m, ellipe_mc, ellipe_alpha, ellipke_k, ellipke_m, ellipke_mc, ellipke_alpha, &
      ellipb_k, ellipb_m, ellipb_mc, ellipb_alpha, ellipd_k, ellipd_m, ellipd_mc, ellipd_alpha
   use furiko_third_kind_qp, only : ellippi_k, ellippi_m, ellippi_mc, ellippiinc_k, &
      ellippiinc_m, ellippiinc_mc
   use furiko_incomplete_qp, only : ellipf_k, ellipf_m, ellipf_mc, ellipeinc_k, ellipeinc_m, &
      ellipeinc_mc, ellipdinc_k, ellipdinc_m, ellipdinc_mc
   use furiko_carlson_qp, only : carlson_rf, carlson_rc, carlson_rd, carlson_rj, carlson_rg
   use furiko_period_qp, only : period_ratio
   implicit none
   private
   include 'furiko_by_name.inc'
end module furiko_by_name_qp
#endif


module furiko_by_name
   use furiko_by_name_sp, only : evaluate
   use furiko_by_name_dp, only : evaluate
#ifdef __GFC_REAL_16__
   use furiko_by_name_qp, only : evaluate
#endif
   implicit none
   private
   public :: evaluate
end module furiko_by_name
