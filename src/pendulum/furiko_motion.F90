! SPDX-License-Identifier: MIT
#include "../arithmetic/furiko_compiler.inc"

!> The exact motion of a pendulum, in each kind of real; the text is in furiko_motion.inc.
module furiko_motion_sp
   use, intrinsic :: iso_fortran_env, only : wp => real32, ip => int32
   use furiko_bits_sp, only : infinity, is_finite, is_nan, nan
   use furiko_arctangent_sp, only : arctangents
   use furiko_duplication_sp, only : rf_of_roots
   use furiko_fold_sp, only : fold
   use furiko_half_pi_sp, only : half_pi
   use furiko_modulus_sp, only : amplitudes, modulus, modulus_from_sides, sine_cosine
   use furiko_word_arithmetic_sp, only : word_pair => words
   implicit none
   private
   include 'furiko_motion.inc'
#include "../arithmetic/furiko_bits.inc"
   include '../arithmetic/furiko_head.inc'
   include '../arithmetic/furiko_is_within.inc'
end module furiko_motion_sp


module furiko_motion_dp
   use, intrinsic :: iso_fortran_env, only : wp => real64, ip => int64
   use furiko_bits_dp, only : infinity, is_finite, is_nan, nan
   use furiko_arctangent_dp, only : arctangents
   use furiko_duplication_dp, only : rf_of_roots
   use furiko_fold_dp, only : fold
   use furiko_half_pi_dp, only : half_pi
   use furiko_modulus_dp, only : amplitudes, modulus, modulus_from_sides, sine_cosine
   use furiko_word_arithmetic_dp, only : word_pair => words
   implicit none
   private
   include 'furiko_motion.inc'
#include "../arithmetic/furiko_bits.inc"
   include '../arithmetic/furiko_head.inc'
   include '../arithmetic/furiko_is_within.inc'
end module furiko_motion_dp


#ifdef FURIKO_REAL128
module furiko_motion_qp
   use, intrinsic :: iso_fortran_env, only : wp => real128
   use furiko_bits_qp, only : head, infinity, is_finite, is_nan, is_within, nan
   use furiko_arctangent_qp, only : arctangents
   use furiko_duplication_qp, only : rf_of_roots
   use furiko_fold_qp, only : fold
   use furiko_half_pi_qp, only : half_pi
   use furiko_modulus_qp, only : amplitudes, modulus, modulus_from_sides, sine_cosine
   use furiko_word_arithmetic_qp, only : word_pair => words
   implicit none
   private
   include 'furiko_motion.inc'
end module furiko_motion_qp
#endif


!> A type has no kind in Fortran 2008: `pendulum` and `motion` are real64's.
! allow(C121)
module furiko_motion
   use furiko_motion_sp, pendulum_real32 => pendulum, motion_real32 => motion
   use furiko_motion_dp
#ifdef FURIKO_REAL128
   use furiko_motion_qp, pendulum_real128 => pendulum, motion_real128 => motion
#endif
   implicit none
   public
end module furiko_motion
! rooms: 2309583173
