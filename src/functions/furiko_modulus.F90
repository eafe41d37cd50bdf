! SPDX-License-Identifier: MIT

!> The modulus of elliptic functions as an object, in each kind of real: made once, asked for many
!> arguments; the text is in furiko_modulus.inc.
module furiko_modulus_sp
   use, intrinsic :: iso_fortran_env, only : wp => real32, int32
   use, intrinsic :: ieee_arithmetic, only : ieee_is_finite, ieee_is_nan, ieee_positive_inf, &
      ieee_quiet_nan, ieee_value
   use furiko_arctangent_sp, only : arctangents
   use furiko_half_pi_sp, only : half_pi
   use furiko_complete_sp, only : ellipb_mc, ellipe_mc, ellipk_mc
   use furiko_incomplete_sp, only : ellipdinc_mc, ellipeinc_mc, ellipf_mc
   use furiko_quotients_sp, only : lanes, mean, quotients, thetas, thetas_of, triangle, &
      whole
   implicit none
   private
   include 'furiko_modulus.inc'
   include '../arithmetic/furiko_head_sp.inc'
end module furiko_modulus_sp


module furiko_modulus_dp
   use, intrinsic :: iso_fortran_env, only : wp => real64, int64
   use, intrinsic :: ieee_arithmetic, only : ieee_is_finite, ieee_is_nan, ieee_positive_inf, &
      ieee_quiet_nan, ieee_value
   use furiko_arctangent_dp, only : arctangents
   use furiko_half_pi_dp, only : half_pi
   use furiko_complete_dp, only : ellipb_mc, ellipe_mc, ellipk_mc
   use furiko_incomplete_dp, only : ellipdinc_mc, ellipeinc_mc, ellipf_mc
   use furiko_quotients_dp, only : lanes, mean, quotients, thetas, thetas_of, triangle, &
      whole
   implicit none
   private
   include 'furiko_modulus.inc'
   include '../arithmetic/furiko_head_dp.inc'
end module furiko_modulus_dp


#ifdef __GFC_REAL_16__
module furiko_modulus_qp
   use, intrinsic :: iso_fortran_env, only : wp => real128, int32, int64
   use, intrinsic :: ieee_arithmetic, only : ieee_is_finite, ieee_is_nan, ieee_positive_inf, &
      ieee_quiet_nan, ieee_value
   use furiko_arctangent_qp, only : arctangents
   use furiko_half_pi_qp, only : half_pi
   use furiko_complete_qp, only : ellipb_mc, ellipe_mc, ellipk_mc
   use furiko_incomplete_qp, only : ellipdinc_mc, ellipeinc_mc, ellipf_mc
   use furiko_quotients_qp, only : lanes, mean, quotients, thetas, thetas_of, triangle, &
      whole
   implicit none
   private
   include 'furiko_modulus.inc'
   include '../arithmetic/furiko_head_qp.inc'
end module furiko_modulus_qp
#endif


!> `modulus` is of real64; `modulus_real32` and `modulus_real128` are its sisters
module furiko_modulus
   use furiko_modulus_sp, only : modulus_real32 => modulus, modulus_from_k, modulus_from_m, &
      modulus_from_mc, modulus_from_alpha, modulus_from_amplitude
   use furiko_modulus_dp, only : modulus, modulus_from_k, modulus_from_m, &
      modulus_from_mc, modulus_from_alpha, modulus_from_amplitude
#ifdef __GFC_REAL_16__
   use furiko_modulus_qp, only : modulus_real128 => modulus, modulus_from_k, modulus_from_m, &
      modulus_from_mc, modulus_from_alpha, modulus_from_amplitude
#endif
   implicit none
   private
   public :: modulus, modulus_real32
#ifdef __GFC_REAL_16__
   public :: modulus_real128
#endif
   public :: modulus_from_k, modulus_from_m, modulus_from_mc, modulus_from_alpha, &
      modulus_from_amplitude
end module furiko_modulus
