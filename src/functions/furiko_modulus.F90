! SPDX-License-Identifier: MIT
#include "../arithmetic/furiko_compiler.inc"

!> The modulus of elliptic functions as an object, in each kind of real: made once, asked for many
!> arguments; the text is in furiko_modulus.inc.
module furiko_modulus_sp
   use, intrinsic :: iso_fortran_env, only : wp => real32, ip => int32
   use furiko_bits_sp, only : infinity, nan
   use furiko_arctangent_sp, only : arctangents
   use furiko_arctangent_one_sp, only : arctangents_of_one => arctangents
   use furiko_duplication_sp, only : rd_of_roots
   use furiko_forms, only : by_k, by_m, by_mc, by_k_of_complement
   use furiko_half_pi_sp, only : half_pi
   use furiko_nome_sp, only : nome_k, nome_m, nome_mc, nome_of_pairs
   use furiko_complete_sp, only : ellipb_mc, ellipe_mc, ellipk_mc
   use furiko_incomplete_sp, only : ellipdinc_mc, ellipeinc_mc, ellipf_mc
   use furiko_quotients_sp, only : is_hyperbolic, lanes, least_bent, mean, thetas, thetas_of, triangle, &
      two_words_do
   use furiko_quotients_lane_sp, only : quotients_of_one => quotients, quotients_of_rest
   use furiko_quotients_lanes_sp, only : quotients_of_many => quotients
   use furiko_far_sp, only : far_quarters
   use furiko_word_arithmetic_sp, only : word_pair => words
   implicit none
   private
   include 'furiko_modulus.inc'
#include "../arithmetic/furiko_bits.inc"
   include '../arithmetic/furiko_head.inc'
   include '../arithmetic/furiko_nearest_whole.inc'
   include '../arithmetic/furiko_is_finite.inc'
   include '../arithmetic/furiko_is_nan.inc'
end module furiko_modulus_sp


module furiko_modulus_dp
   use, intrinsic :: iso_fortran_env, only : wp => real64, ip => int64
   use furiko_bits_dp, only : infinity, nan
   use furiko_arctangent_dp, only : arctangents
   use furiko_arctangent_one_dp, only : arctangents_of_one => arctangents
   use furiko_duplication_dp, only : rd_of_roots
   use furiko_forms, only : by_k, by_m, by_mc, by_k_of_complement
   use furiko_half_pi_dp, only : half_pi
   use furiko_nome_dp, only : nome_k, nome_m, nome_mc, nome_of_pairs
   use furiko_complete_dp, only : ellipb_mc, ellipe_mc, ellipk_mc
   use furiko_incomplete_dp, only : ellipdinc_mc, ellipeinc_mc, ellipf_mc
   use furiko_quotients_dp, only : is_hyperbolic, lanes, least_bent, mean, thetas, thetas_of, triangle, &
      two_words_do
   use furiko_quotients_lane_dp, only : quotients_of_one => quotients, quotients_of_rest
   use furiko_quotients_lanes_dp, only : quotients_of_many => quotients
   use furiko_far_dp, only : far_quarters
   use furiko_word_arithmetic_dp, only : word_pair => words
   implicit none
   private
   include 'furiko_modulus.inc'
#include "../arithmetic/furiko_bits.inc"
   include '../arithmetic/furiko_head.inc'
   include '../arithmetic/furiko_nearest_whole.inc'
   include '../arithmetic/furiko_is_finite.inc'
   include '../arithmetic/furiko_is_nan.inc'
end module furiko_modulus_dp


#ifdef FURIKO_REAL128
module furiko_modulus_qp
   use, intrinsic :: iso_fortran_env, only : wp => real128
   use furiko_bits_qp, only : head, infinity, is_finite, is_nan, nan, nearest_whole
   use furiko_arctangent_qp, only : arctangents, arctangents_of_one => arctangents
   use furiko_duplication_qp, only : rd_of_roots
   use furiko_forms, only : by_k, by_m, by_mc, by_k_of_complement
   use furiko_half_pi_qp, only : half_pi
   use furiko_nome_qp, only : nome_k, nome_m, nome_mc, nome_of_pairs
   use furiko_complete_qp, only : ellipb_mc, ellipe_mc, ellipk_mc
   use furiko_incomplete_qp, only : ellipdinc_mc, ellipeinc_mc, ellipf_mc
   use furiko_quotients_qp, only : is_hyperbolic, lanes, least_bent, mean, thetas, thetas_of, triangle, &
      two_words_do
   use furiko_quotients_lane_qp, only : quotients_of_many => quotients, quotients_of_one => quotients, &
      quotients_of_rest
   use furiko_far_qp, only : far_quarters
   use furiko_word_arithmetic_qp, only : word_pair => words
   implicit none
   private
   include 'furiko_modulus.inc'
end module furiko_modulus_qp
#endif


!> `modulus` is of real64; `modulus_real32` and `modulus_real128` are its sisters. By lists: the kinds'
!> modules have procedures for other rooms, too, of the same names.
module furiko_modulus
   use furiko_modulus_sp, only : modulus_real32 => modulus, modulus_from_k, modulus_from_m, &
      modulus_from_mc, modulus_from_alpha, modulus_from_amplitude
   use furiko_modulus_dp, only : modulus, modulus_from_k, modulus_from_m, &
      modulus_from_mc, modulus_from_alpha, modulus_from_amplitude
#ifdef FURIKO_REAL128
   use furiko_modulus_qp, only : modulus_real128 => modulus, modulus_from_k, modulus_from_m, &
      modulus_from_mc, modulus_from_alpha, modulus_from_amplitude
#endif
   implicit none
   private
   public :: modulus, modulus_real32
#ifdef FURIKO_REAL128
   public :: modulus_real128
#endif
   public :: modulus_from_k, modulus_from_m, modulus_from_mc, modulus_from_alpha, &
      modulus_from_amplitude
end module furiko_modulus
! rooms: 2594881749
