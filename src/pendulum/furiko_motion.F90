! SPDX-License-Identifier: MIT

!> The exact motion of a pendulum, in each kind of real; the text is in furiko_motion.inc.
module furiko_motion_sp
   use, intrinsic :: iso_fortran_env, only : wp => real32, int32
   use, intrinsic :: ieee_arithmetic, only : ieee_is_finite, ieee_is_nan, ieee_positive_inf, &
      ieee_quiet_nan, ieee_value
   use furiko_arctangent_sp, only : arctangents
   use furiko_duplication_sp, only : lanes, rf_of_roots
   use furiko_fold_sp, only : fold
   use furiko_half_pi_sp, only : half_pi
   use furiko_modulus_sp, only : modulus, modulus_from_m, modulus_from_sides, sine_cosine
   implicit none
   private
   include 'furiko_motion.inc'
   include '../arithmetic/furiko_head_sp.inc'
end module furiko_motion_sp


module furiko_motion_dp
   use, intrinsic :: iso_fortran_env, only : wp => real64, int64
   use, intrinsic :: ieee_arithmetic, only : ieee_is_finite, ieee_is_nan, ieee_positive_inf, &
      ieee_quiet_nan, ieee_value
   use furiko_arctangent_dp, only : arctangents
   use furiko_duplication_dp, only : lanes, rf_of_roots
   use furiko_fold_dp, only : fold
   use furiko_half_pi_dp, only : half_pi
   use furiko_modulus_dp, only : modulus, modulus_from_m, modulus_from_sides, sine_cosine
   implicit none
   private
   include 'furiko_motion.inc'
   include '../arithmetic/furiko_head_dp.inc'
end module furiko_motion_dp


#ifdef __GFC_REAL_16__
module furiko_motion_qp
   use, intrinsic :: iso_fortran_env, only : wp => real128, int32, int64
   use, intrinsic :: ieee_arithmetic, only : ieee_is_finite, ieee_is_nan, ieee_positive_inf, &
      ieee_quiet_nan, ieee_value
   use furiko_arctangent_qp, only : arctangents
   use furiko_duplication_qp, only : lanes, rf_of_roots
   use furiko_fold_qp, only : fold
   use furiko_half_pi_qp, only : half_pi
   use furiko_modulus_qp, only : modulus, modulus_from_m, modulus_from_sides, sine_cosine
   implicit none
   private
   include 'furiko_motion.inc'
   include '../arithmetic/furiko_head_qp.inc'
end module furiko_motion_qp
#endif


!> A type has no kind in Fortran 2008: `pendulum` and `motion` are real64's.
module furiko_motion
   use furiko_motion_sp, only : pendulum_real32 => pendulum, motion_real32 => motion
   use furiko_motion_dp, only : pendulum, motion
#ifdef __GFC_REAL_16__
   use furiko_motion_qp, only : pendulum_real128 => pendulum, motion_real128 => motion
#endif
   implicit none
   private
   public :: pendulum, motion, pendulum_real32, motion_real32
#ifdef __GFC_REAL_16__
   public :: pendulum_real128, motion_real128
#endif
end module furiko_motion
