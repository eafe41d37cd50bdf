! SPDX-License-Identifier: MIT
#include "../arithmetic/furiko_compiler.inc"

!> Values that every build must compute, in each kind of real; the text is in furiko_known_values.inc.
module furiko_known_values_sp
   use, intrinsic :: iso_fortran_env, only : wp => real32
   use furiko_carlson, only : carlson_rd, carlson_rf, carlson_rj
   use furiko_complete, only : ellipe_m, ellipk_m
   use furiko_incomplete, only : ellipeinc_m, ellipf_m
   use furiko_jacobi, only : jacobi_m
   use furiko_jacobi_inverse, only : jacobi_arcsn_m
   use furiko_modulus_sp, only : modulus, modulus_from_m
   use furiko_motion_sp, only : motion, pendulum
   use furiko_nome, only : nome_m
   use furiko_pendulum_steps, only : pendulum_rk4
   use furiko_period, only : period_ratio
   use furiko_theta, only : theta1, theta3
   use furiko_third_kind, only : ellippi_m, ellippiinc_m
   implicit none
   private
   include 'furiko_known_values.inc'
end module furiko_known_values_sp


module furiko_known_values_dp
   use, intrinsic :: iso_fortran_env, only : wp => real64
   use furiko_carlson, only : carlson_rd, carlson_rf, carlson_rj
   use furiko_complete, only : ellipe_m, ellipk_m
   use furiko_incomplete, only : ellipeinc_m, ellipf_m
   use furiko_jacobi, only : jacobi_m
   use furiko_jacobi_inverse, only : jacobi_arcsn_m
   use furiko_modulus_dp, only : modulus, modulus_from_m
   use furiko_motion_dp, only : motion, pendulum
   use furiko_nome, only : nome_m
   use furiko_pendulum_steps, only : pendulum_rk4
   use furiko_period, only : period_ratio
   use furiko_theta, only : theta1, theta3
   use furiko_third_kind, only : ellippi_m, ellippiinc_m
   implicit none
   private
   include 'furiko_known_values.inc'
end module furiko_known_values_dp


#ifdef FURIKO_REAL128
module furiko_known_values_qp
   use, intrinsic :: iso_fortran_env, only : wp => real128
   use furiko_carlson, only : carlson_rd, carlson_rf, carlson_rj
   use furiko_complete, only : ellipe_m, ellipk_m
   use furiko_incomplete, only : ellipeinc_m, ellipf_m
   use furiko_jacobi, only : jacobi_m
   use furiko_jacobi_inverse, only : jacobi_arcsn_m
   use furiko_modulus_qp, only : modulus, modulus_from_m
   use furiko_motion_qp, only : motion, pendulum
   use furiko_nome, only : nome_m
   use furiko_pendulum_steps, only : pendulum_rk4
   use furiko_period, only : period_ratio
   use furiko_theta, only : theta1, theta3
   use furiko_third_kind, only : ellippi_m, ellippiinc_m
   implicit none
   private
   include 'furiko_known_values.inc'
end module furiko_known_values_qp
#endif


!> Whether this build computes right
module furiko_known_values
   use furiko_known_values_sp, only : wrong_sp => wrong_values
   use furiko_known_values_dp, only : wrong_dp => wrong_values
#ifdef FURIKO_REAL128
   use furiko_known_values_qp, only : wrong_qp => wrong_basics
#endif
   implicit none
   private
   public :: furiko_selftest


contains


   !> How many of a hundred known values come out wrong in this build: 0, or something is amiss with
   !> the compiler, its flags or the processor's rounding. Call it once, before you rely on anything:
   !>
   !>     if (furiko_selftest() /= 0) error stop 'furiko computes wrong numbers in this build'
   !>
   !> The library needs IEEE arithmetic. gfortran's -ffast-math and its kin are refused when it is
   !> compiled, but not every compiler tells what it was asked for: x87 arithmetic (-mfpmath=387),
   !> flang's -ffast-math and others' default models are found here. Takes a few tenths of a
   !> millisecond, most of it for real128.
   pure function furiko_selftest() result(wrong)
      !> Values off by more than 16 epsilon, over scalars and arrays, in all kinds of real
      integer :: wrong

      wrong = wrong_sp() + wrong_dp()
#ifdef FURIKO_REAL128
      wrong = wrong + wrong_qp()
#endif
   end function furiko_selftest

end module furiko_known_values
! rooms: 937306087
