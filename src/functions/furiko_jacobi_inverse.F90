! SPDX-License-Identifier: MIT
#include "../arithmetic/furiko_compiler.inc"

module furiko_jacobi_inverse_sp
   use, intrinsic :: iso_fortran_env, only : wp => real32
   use furiko_bits_sp, only : infinity, is_nan, nan
   use furiko_duplication_sp, only : lanes, rf_of_roots
   use furiko_parameters_sp, only : parameters, by_k, by_m, by_mc
   use furiko_word_arithmetic_sp, only : words, value, operator(+), operator(-), operator(*), &
      operator(/), sqrt, scale
   implicit none
   private
   include 'furiko_jacobi_inverse.inc'
end module furiko_jacobi_inverse_sp


module furiko_jacobi_inverse_dp
   use, intrinsic :: iso_fortran_env, only : wp => real64
   use furiko_bits_dp, only : infinity, is_nan, nan
   use furiko_duplication_dp, only : lanes, rf_of_roots
   use furiko_parameters_dp, only : parameters, by_k, by_m, by_mc
   use furiko_word_arithmetic_dp, only : words, value, operator(+), operator(-), operator(*), &
      operator(/), sqrt, scale
   implicit none
   private
   include 'furiko_jacobi_inverse.inc'
end module furiko_jacobi_inverse_dp


#ifdef FURIKO_REAL128
module furiko_jacobi_inverse_qp
   use, intrinsic :: iso_fortran_env, only : wp => real128
   use furiko_bits_qp, only : infinity, is_nan, nan
   use furiko_duplication_qp, only : lanes, rf_of_roots
   use furiko_parameters_qp, only : parameters, by_k, by_m, by_mc
   use furiko_word_arithmetic_qp, only : words, value, operator(+), operator(-), operator(*), &
      operator(/), sqrt, scale
   implicit none
   private
   include 'furiko_jacobi_inverse.inc'
end module furiko_jacobi_inverse_qp
#endif


!> The inverses of the twelve Jacobi elliptic functions, in real32, real64 and real128
module furiko_jacobi_inverse
   use furiko_jacobi_inverse_sp, only : &
      jacobi_arcsn_k, jacobi_arcsn_m, jacobi_arcsn_mc, &
      jacobi_arccn_k, jacobi_arccn_m, jacobi_arccn_mc, &
      jacobi_arcdn_k, jacobi_arcdn_m, jacobi_arcdn_mc, &
      jacobi_arcns_k, jacobi_arcns_m, jacobi_arcns_mc, &
      jacobi_arcnc_k, jacobi_arcnc_m, jacobi_arcnc_mc, &
      jacobi_arcnd_k, jacobi_arcnd_m, jacobi_arcnd_mc, &
      jacobi_arcsc_k, jacobi_arcsc_m, jacobi_arcsc_mc, &
      jacobi_arccs_k, jacobi_arccs_m, jacobi_arccs_mc, &
      jacobi_arcsd_k, jacobi_arcsd_m, jacobi_arcsd_mc, &
      jacobi_arcds_k, jacobi_arcds_m, jacobi_arcds_mc, &
      jacobi_arccd_k, jacobi_arccd_m, jacobi_arccd_mc, &
      jacobi_arcdc_k, jacobi_arcdc_m, jacobi_arcdc_mc
   use furiko_jacobi_inverse_dp, only : &
      jacobi_arcsn_k, jacobi_arcsn_m, jacobi_arcsn_mc, &
      jacobi_arccn_k, jacobi_arccn_m, jacobi_arccn_mc, &
      jacobi_arcdn_k, jacobi_arcdn_m, jacobi_arcdn_mc, &
      jacobi_arcns_k, jacobi_arcns_m, jacobi_arcns_mc, &
      jacobi_arcnc_k, jacobi_arcnc_m, jacobi_arcnc_mc, &
      jacobi_arcnd_k, jacobi_arcnd_m, jacobi_arcnd_mc, &
      jacobi_arcsc_k, jacobi_arcsc_m, jacobi_arcsc_mc, &
      jacobi_arccs_k, jacobi_arccs_m, jacobi_arccs_mc, &
      jacobi_arcsd_k, jacobi_arcsd_m, jacobi_arcsd_mc, &
      jacobi_arcds_k, jacobi_arcds_m, jacobi_arcds_mc, &
      jacobi_arccd_k, jacobi_arccd_m, jacobi_arccd_mc, &
      jacobi_arcdc_k, jacobi_arcdc_m, jacobi_arcdc_mc
#ifdef FURIKO_REAL128
   use furiko_jacobi_inverse_qp, only : &
      jacobi_arcsn_k, jacobi_arcsn_m, jacobi_arcsn_mc, &
      jacobi_arccn_k, jacobi_arccn_m, jacobi_arccn_mc, &
      jacobi_arcdn_k, jacobi_arcdn_m, jacobi_arcdn_mc, &
      jacobi_arcns_k, jacobi_arcns_m, jacobi_arcns_mc, &
      jacobi_arcnc_k, jacobi_arcnc_m, jacobi_arcnc_mc, &
      jacobi_arcnd_k, jacobi_arcnd_m, jacobi_arcnd_mc, &
      jacobi_arcsc_k, jacobi_arcsc_m, jacobi_arcsc_mc, &
      jacobi_arccs_k, jacobi_arccs_m, jacobi_arccs_mc, &
      jacobi_arcsd_k, jacobi_arcsd_m, jacobi_arcsd_mc, &
      jacobi_arcds_k, jacobi_arcds_m, jacobi_arcds_mc, &
      jacobi_arccd_k, jacobi_arccd_m, jacobi_arccd_mc, &
      jacobi_arcdc_k, jacobi_arcdc_m, jacobi_arcdc_mc
#endif
   implicit none
   private
   public :: &
      jacobi_arcsn_k, jacobi_arcsn_m, jacobi_arcsn_mc, &
      jacobi_arccn_k, jacobi_arccn_m, jacobi_arccn_mc, &
      jacobi_arcdn_k, jacobi_arcdn_m, jacobi_arcdn_mc, &
      jacobi_arcns_k, jacobi_arcns_m, jacobi_arcns_mc, &
      jacobi_arcnc_k, jacobi_arcnc_m, jacobi_arcnc_mc, &
      jacobi_arcnd_k, jacobi_arcnd_m, jacobi_arcnd_mc, &
      jacobi_arcsc_k, jacobi_arcsc_m, jacobi_arcsc_mc, &
      jacobi_arccs_k, jacobi_arccs_m, jacobi_arccs_mc, &
      jacobi_arcsd_k, jacobi_arcsd_m, jacobi_arcsd_mc, &
      jacobi_arcds_k, jacobi_arcds_m, jacobi_arcds_mc, &
      jacobi_arccd_k, jacobi_arccd_m, jacobi_arccd_mc, &
      jacobi_arcdc_k, jacobi_arcdc_m, jacobi_arcdc_mc
end module furiko_jacobi_inverse
! rooms: 2042347099
