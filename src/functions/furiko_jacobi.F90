! SPDX-License-Identifier: MIT
#include "../arithmetic/furiko_compiler.inc"

!> The Jacobi elliptic functions, in each kind of real; the text is in furiko_jacobi.inc.
module furiko_jacobi_dp
   use, intrinsic :: iso_fortran_env, only : int64, wp => real64
   use furiko_bits_dp, only : infinity, is_nan
   use furiko_half_pi_dp, only : half_pi
   use furiko_modulus_dp, only : modulus, modulus_from_k, modulus_from_m, modulus_from_mc, steep, unscaled
   use furiko_quotients_dp, only : by_k, by_m, by_mc
   use furiko_quotients_many_dp, only : lanes, quotients_many
   use furiko_quotients_one_dp, only : quotients_one
   implicit none
   private
   ! For real32, and Jacobi's epsilon
   public :: amplitude, evaluate, split_amplitude
   real(wp), parameter :: pi(2) = 2*[half_pi(1), half_pi(2) + half_pi(3)]
   include 'furiko_jacobi.inc'
   include 'furiko_jacobi_blocks.inc'
   include 'furiko_jacobi_one.inc'
end module furiko_jacobi_dp


module furiko_jacobi_sp
   use, intrinsic :: iso_fortran_env, only : real64, wp => real32
   use furiko_bits_sp, only : infinity, is_nan
   use furiko_jacobi_dp, only : double_amplitude => amplitude, double_evaluate => evaluate
   use furiko_modulus_sp, only : modulus, modulus_from_k, modulus_from_m, modulus_from_mc, steep, unscaled
   use furiko_quotients_sp, only : by_k, by_m, by_mc
   use furiko_quotients_many_sp, only : lanes, quotients_many
   implicit none
   private
   include 'furiko_jacobi.inc'
   include 'furiko_jacobi_blocks.inc'
   include 'furiko_jacobi_by_real64.inc'
end module furiko_jacobi_sp


#ifdef FURIKO_REAL128
module furiko_jacobi_qp
   use, intrinsic :: iso_fortran_env, only : int64, wp => real128
   use furiko_bits_qp, only : infinity, is_nan
   use furiko_half_pi_qp, only : half_pi
   use furiko_modulus_qp, only : modulus, modulus_from_k, modulus_from_m, modulus_from_mc, steep, unscaled
   use furiko_quotients_qp, only : by_k, by_m, by_mc
   use furiko_quotients_one_qp, only : quotients_one
   implicit none
   private
   real(wp), parameter :: pi(2) = 2*[half_pi(1), half_pi(2) + half_pi(3)]
   include 'furiko_jacobi.inc'
   include 'furiko_jacobi_loop.inc'
   include 'furiko_jacobi_one.inc'
end module furiko_jacobi_qp
#endif


!> The Jacobi elliptic functions of any real u and m, in real32, real64 and real128
!>
!> The form of the argument is in the name: modulus `_k`, parameter `_m` = k^2, complementary
!> parameter `_mc` = 1 - m.
module furiko_jacobi
   use furiko_jacobi_sp, only : &
      jacobi_k, jacobi_m, jacobi_mc, jacobi_am_k, jacobi_am_m, jacobi_am_mc, jacobi_sn_k, &
      jacobi_sn_m, jacobi_sn_mc, jacobi_cn_k, jacobi_cn_m, jacobi_cn_mc, jacobi_dn_k, &
      jacobi_dn_m, jacobi_dn_mc, jacobi_ns_k, jacobi_ns_m, jacobi_ns_mc, jacobi_nc_k, &
      jacobi_nc_m, jacobi_nc_mc, jacobi_nd_k, jacobi_nd_m, jacobi_nd_mc, jacobi_sc_k, &
      jacobi_sc_m, jacobi_sc_mc, jacobi_cs_k, jacobi_cs_m, jacobi_cs_mc, jacobi_sd_k, &
      jacobi_sd_m, jacobi_sd_mc, jacobi_ds_k, jacobi_ds_m, jacobi_ds_mc, jacobi_cd_k, &
      jacobi_cd_m, jacobi_cd_mc, jacobi_dc_k, jacobi_dc_m, jacobi_dc_mc
   use furiko_jacobi_dp, only : &
      jacobi_k, jacobi_m, jacobi_mc, jacobi_am_k, jacobi_am_m, jacobi_am_mc, jacobi_sn_k, &
      jacobi_sn_m, jacobi_sn_mc, jacobi_cn_k, jacobi_cn_m, jacobi_cn_mc, jacobi_dn_k, &
      jacobi_dn_m, jacobi_dn_mc, jacobi_ns_k, jacobi_ns_m, jacobi_ns_mc, jacobi_nc_k, &
      jacobi_nc_m, jacobi_nc_mc, jacobi_nd_k, jacobi_nd_m, jacobi_nd_mc, jacobi_sc_k, &
      jacobi_sc_m, jacobi_sc_mc, jacobi_cs_k, jacobi_cs_m, jacobi_cs_mc, jacobi_sd_k, &
      jacobi_sd_m, jacobi_sd_mc, jacobi_ds_k, jacobi_ds_m, jacobi_ds_mc, jacobi_cd_k, &
      jacobi_cd_m, jacobi_cd_mc, jacobi_dc_k, jacobi_dc_m, jacobi_dc_mc
#ifdef FURIKO_REAL128
   use furiko_jacobi_qp, only : &
      jacobi_k, jacobi_m, jacobi_mc, jacobi_am_k, jacobi_am_m, jacobi_am_mc, jacobi_sn_k, &
      jacobi_sn_m, jacobi_sn_mc, jacobi_cn_k, jacobi_cn_m, jacobi_cn_mc, jacobi_dn_k, &
      jacobi_dn_m, jacobi_dn_mc, jacobi_ns_k, jacobi_ns_m, jacobi_ns_mc, jacobi_nc_k, &
      jacobi_nc_m, jacobi_nc_mc, jacobi_nd_k, jacobi_nd_m, jacobi_nd_mc, jacobi_sc_k, &
      jacobi_sc_m, jacobi_sc_mc, jacobi_cs_k, jacobi_cs_m, jacobi_cs_mc, jacobi_sd_k, &
      jacobi_sd_m, jacobi_sd_mc, jacobi_ds_k, jacobi_ds_m, jacobi_ds_mc, jacobi_cd_k, &
      jacobi_cd_m, jacobi_cd_mc, jacobi_dc_k, jacobi_dc_m, jacobi_dc_mc
#endif
   implicit none
   private
   public :: &
      jacobi_k, jacobi_m, jacobi_mc, jacobi_am_k, jacobi_am_m, jacobi_am_mc, jacobi_sn_k, &
      jacobi_sn_m, jacobi_sn_mc, jacobi_cn_k, jacobi_cn_m, jacobi_cn_mc, jacobi_dn_k, &
      jacobi_dn_m, jacobi_dn_mc, jacobi_ns_k, jacobi_ns_m, jacobi_ns_mc, jacobi_nc_k, &
      jacobi_nc_m, jacobi_nc_mc, jacobi_nd_k, jacobi_nd_m, jacobi_nd_mc, jacobi_sc_k, &
      jacobi_sc_m, jacobi_sc_mc, jacobi_cs_k, jacobi_cs_m, jacobi_cs_mc, jacobi_sd_k, &
      jacobi_sd_m, jacobi_sd_mc, jacobi_ds_k, jacobi_ds_m, jacobi_ds_mc, jacobi_cd_k, &
      jacobi_cd_m, jacobi_cd_mc, jacobi_dc_k, jacobi_dc_m, jacobi_dc_mc
end module furiko_jacobi
! rooms: 2394018433
