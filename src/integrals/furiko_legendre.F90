! SPDX-License-Identifier: MIT

!> Legendre integrals in words from words, for blocks of lanes. Internal.
module furiko_legendre_sp
   use, intrinsic :: iso_fortran_env, only : wp => real32, int32
   use, intrinsic :: ieee_arithmetic, only : ieee_is_nan, ieee_value, ieee_quiet_nan, &
      ieee_positive_inf
   use furiko_fold_sp, only : fold
   use furiko_duplication_sp, only : lanes, rf_of_roots, rd_of_roots, rj_of_roots
   implicit none
   private
   include 'furiko_legendre.inc'
   include '../arithmetic/furiko_head_sp.inc'
end module furiko_legendre_sp


module furiko_legendre_dp
   use, intrinsic :: iso_fortran_env, only : wp => real64, int64
   use, intrinsic :: ieee_arithmetic, only : ieee_is_nan, ieee_value, ieee_quiet_nan, &
      ieee_positive_inf
   use furiko_fold_dp, only : fold
   use furiko_duplication_dp, only : lanes, rf_of_roots, rd_of_roots, rj_of_roots
   implicit none
   private
   include 'furiko_legendre.inc'
   include '../arithmetic/furiko_head_dp.inc'
end module furiko_legendre_dp


#ifdef __GFC_REAL_16__
module furiko_legendre_qp
   use, intrinsic :: iso_fortran_env, only : wp => real128, int32, int64
   use, intrinsic :: ieee_arithmetic, only : ieee_is_nan, ieee_value, ieee_quiet_nan, &
      ieee_positive_inf
   use furiko_fold_qp, only : fold
   use furiko_duplication_qp, only : lanes, rf_of_roots, rd_of_roots, rj_of_roots
   implicit none
   private
   include 'furiko_legendre.inc'
   include '../arithmetic/furiko_head_qp.inc'
end module furiko_legendre_qp
#endif
