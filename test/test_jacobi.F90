! SPDX-License-Identifier: MIT
#include "../src/arithmetic/furiko_compiler.inc"

module test_jacobi_sp
   use, intrinsic :: iso_fortran_env, only : compiler_version, wp => real32
   use, intrinsic :: ieee_arithmetic, only : ieee_is_nan, ieee_positive_inf, ieee_quiet_nan, &
      ieee_value
   use, intrinsic :: ieee_exceptions, only : ieee_get_flag, ieee_get_halting_mode, ieee_set_flag, &
      ieee_set_halting_mode, ieee_usual
   use furiko, only : modulus => modulus_real32, modulus_from_k, modulus_from_m, &
      modulus_from_mc, modulus_from_alpha, modulus_from_amplitude, ellipe_m, ellipeinc_m, &
      ellipf_m, &
      ellipk_m, nome_m, theta1, theta2, theta3, theta4, jacobi_zeta_m, &
      jacobi_am_m, jacobi_am_mc, jacobi_k, jacobi_m, jacobi_mc, &
      jacobi_ns_k, jacobi_cs_k, jacobi_sd_k, jacobi_ds_k, &
      jacobi_arcsn_k, jacobi_arccn_k, jacobi_arcdn_k, jacobi_arcns_k, jacobi_arcnc_k, jacobi_arcnd_k, &
      jacobi_arcsc_k, jacobi_arccs_k, jacobi_arcsd_k, jacobi_arcds_k, jacobi_arccd_k, jacobi_arcdc_k, &
      jacobi_sn_m, jacobi_cn_m, jacobi_dn_m, jacobi_ns_m, jacobi_nc_m, jacobi_nd_m, &
      jacobi_sc_m, jacobi_cs_m, jacobi_sd_m, jacobi_ds_m, jacobi_cd_m, jacobi_dc_m, &
      jacobi_arcsn_m, jacobi_arcsn_mc, jacobi_arccn_m, jacobi_arcdn_m, jacobi_arcns_m, jacobi_arcns_mc, &
      jacobi_arcnc_m, &
      jacobi_arcnd_m, &
      jacobi_arcsc_m, jacobi_arccs_m, jacobi_arcsd_m, jacobi_arcds_m, jacobi_arccd_m, jacobi_arcdc_m
   use test_measurement, only : unpack
   use test_program, only : test_folder
   use testdrive, only : check, error_type, new_unittest, skip_test, unittest_type
   implicit none
   private
   include 'test_jacobi.inc'
end module test_jacobi_sp


module test_jacobi_dp
   use, intrinsic :: iso_fortran_env, only : compiler_version, wp => real64
   use, intrinsic :: ieee_arithmetic, only : ieee_is_nan, ieee_positive_inf, ieee_quiet_nan, &
      ieee_value
   use, intrinsic :: ieee_exceptions, only : ieee_get_flag, ieee_get_halting_mode, ieee_set_flag, &
      ieee_set_halting_mode, ieee_usual
   use furiko, only : modulus, modulus_from_k, modulus_from_m, &
      modulus_from_mc, modulus_from_alpha, modulus_from_amplitude, ellipe_m, ellipeinc_m, &
      ellipf_m, &
      ellipk_m, nome_m, theta1, theta2, theta3, theta4, jacobi_zeta_m, &
      jacobi_am_m, jacobi_am_mc, jacobi_k, jacobi_m, jacobi_mc, &
      jacobi_ns_k, jacobi_cs_k, jacobi_sd_k, jacobi_ds_k, &
      jacobi_arcsn_k, jacobi_arccn_k, jacobi_arcdn_k, jacobi_arcns_k, jacobi_arcnc_k, jacobi_arcnd_k, &
      jacobi_arcsc_k, jacobi_arccs_k, jacobi_arcsd_k, jacobi_arcds_k, jacobi_arccd_k, jacobi_arcdc_k, &
      jacobi_sn_m, jacobi_cn_m, jacobi_dn_m, jacobi_ns_m, jacobi_nc_m, jacobi_nd_m, &
      jacobi_sc_m, jacobi_cs_m, jacobi_sd_m, jacobi_ds_m, jacobi_cd_m, jacobi_dc_m, &
      jacobi_arcsn_m, jacobi_arcsn_mc, jacobi_arccn_m, jacobi_arcdn_m, jacobi_arcns_m, jacobi_arcns_mc, &
      jacobi_arcnc_m, &
      jacobi_arcnd_m, &
      jacobi_arcsc_m, jacobi_arccs_m, jacobi_arcsd_m, jacobi_arcds_m, jacobi_arccd_m, jacobi_arcdc_m
   use test_measurement, only : unpack
   use test_program, only : test_folder
   use testdrive, only : check, error_type, new_unittest, skip_test, unittest_type
   implicit none
   private
   include 'test_jacobi.inc'
end module test_jacobi_dp


#ifdef FURIKO_REAL128
module test_jacobi_qp
   use, intrinsic :: iso_fortran_env, only : compiler_version, wp => real128
   use, intrinsic :: ieee_arithmetic, only : ieee_is_nan, ieee_positive_inf, ieee_quiet_nan, &
      ieee_value
   use, intrinsic :: ieee_exceptions, only : ieee_get_flag, ieee_get_halting_mode, ieee_set_flag, &
      ieee_set_halting_mode, ieee_usual
   use furiko, only : modulus => modulus_real128, modulus_from_k, modulus_from_m, &
      modulus_from_mc, modulus_from_alpha, modulus_from_amplitude, ellipe_m, ellipeinc_m, &
      ellipf_m, &
      ellipk_m, nome_m, theta1, theta2, theta3, theta4, jacobi_zeta_m, &
      jacobi_am_m, jacobi_am_mc, jacobi_k, jacobi_m, jacobi_mc, &
      jacobi_ns_k, jacobi_cs_k, jacobi_sd_k, jacobi_ds_k, &
      jacobi_arcsn_k, jacobi_arccn_k, jacobi_arcdn_k, jacobi_arcns_k, jacobi_arcnc_k, jacobi_arcnd_k, &
      jacobi_arcsc_k, jacobi_arccs_k, jacobi_arcsd_k, jacobi_arcds_k, jacobi_arccd_k, jacobi_arcdc_k, &
      jacobi_sn_m, jacobi_cn_m, jacobi_dn_m, jacobi_ns_m, jacobi_nc_m, jacobi_nd_m, &
      jacobi_sc_m, jacobi_cs_m, jacobi_sd_m, jacobi_ds_m, jacobi_cd_m, jacobi_dc_m, &
      jacobi_arcsn_m, jacobi_arcsn_mc, jacobi_arccn_m, jacobi_arcdn_m, jacobi_arcns_m, jacobi_arcns_mc, &
      jacobi_arcnc_m, &
      jacobi_arcnd_m, &
      jacobi_arcsc_m, jacobi_arccs_m, jacobi_arcsd_m, jacobi_arcds_m, jacobi_arccd_m, jacobi_arcdc_m
   use test_measurement, only : unpack
   use test_program, only : test_folder
   use testdrive, only : check, error_type, new_unittest, skip_test, unittest_type
   implicit none
   private
   include 'test_jacobi.inc'
end module test_jacobi_qp
#endif
! rooms: 3142977415
