! SPDX-License-Identifier: MIT

module furiko_carlson_sp
   use, intrinsic :: iso_fortran_env, only : wp => real32, int32
   use, intrinsic :: ieee_arithmetic, only : ieee_is_nan, ieee_value, ieee_quiet_nan, &
      ieee_positive_inf
   use furiko_duplication_sp, only : lanes, rf_of_roots, rd_of_roots, rj_of_roots
   implicit none
   private
   include 'furiko_carlson.inc'
   include 'furiko_head_sp.inc'
end module furiko_carlson_sp


module furiko_carlson_dp
   use, intrinsic :: iso_fortran_env, only : wp => real64, int64
   use, intrinsic :: ieee_arithmetic, only : ieee_is_nan, ieee_value, ieee_quiet_nan, &
      ieee_positive_inf
   use furiko_duplication_dp, only : lanes, rf_of_roots, rd_of_roots, rj_of_roots
   implicit none
   private
   include 'furiko_carlson.inc'
   include 'furiko_head_dp.inc'
end module furiko_carlson_dp


#ifdef __GFC_REAL_16__
module furiko_carlson_qp
   use, intrinsic :: iso_fortran_env, only : wp => real128, int32, int64
   use, intrinsic :: ieee_arithmetic, only : ieee_is_nan, ieee_value, ieee_quiet_nan, &
      ieee_positive_inf
   use furiko_duplication_qp, only : lanes, rf_of_roots, rd_of_roots, rj_of_roots
   implicit none
   private
   include 'furiko_carlson.inc'
   include 'furiko_head_qp.inc'
end module furiko_carlson_qp
#endif


!> Carlson's symmetric elliptic integrals R_F, R_C, R_D, R_J, R_G for real arguments, in real32,
!> real64 and real128.
!> A rank-1 argument goes to a batch that the compiler vectorises; scalars and other ranks are
!> elemental.
module furiko_carlson
   use furiko_carlson_sp, only : carlson_rf, carlson_rc, carlson_rd, carlson_rj, carlson_rg
   use furiko_carlson_dp, only : carlson_rf, carlson_rc, carlson_rd, carlson_rj, carlson_rg
#ifdef __GFC_REAL_16__
   use furiko_carlson_qp, only : carlson_rf, carlson_rc, carlson_rd, carlson_rj, carlson_rg
#endif
   implicit none
   private

   public :: carlson_rf, carlson_rc, carlson_rd, carlson_rj, carlson_rg
end module furiko_carlson
