! SPDX-License-Identifier: MIT
#include "../arithmetic/furiko_compiler.inc"

!> Jacobi's epsilon, in each kind of real; the text is in furiko_jacobi_epsilon.inc.
module furiko_jacobi_epsilon_dp
   use, intrinsic :: iso_fortran_env, only : wp => real64
   use furiko_bits_dp, only : is_nan
   use furiko_complete_dp, only : ellipe_k, ellipe_m, ellipe_mc
   use furiko_forms, only : by_k, by_m, by_mc
   use furiko_incomplete_dp, only : ellipeinc_k, ellipeinc_m, ellipeinc_mc
   use furiko_jacobi_dp, only : split_amplitude
   use furiko_modulus_dp, only : modulus, modulus_from_k, modulus_from_m, modulus_from_mc
   use furiko_parameters_dp, only : outside
   implicit none
   private
   ! For real32
   public :: epsilon_of
   include 'furiko_jacobi_epsilon.inc'
   include 'furiko_jacobi_epsilon_one.inc'
end module furiko_jacobi_epsilon_dp


module furiko_jacobi_epsilon_sp
   use, intrinsic :: iso_fortran_env, only : real64, wp => real32
   use furiko_forms, only : by_k, by_m, by_mc
   use furiko_jacobi_epsilon_dp, only : double_epsilon => epsilon_of
   implicit none
   private
   include 'furiko_jacobi_epsilon.inc'
   include 'furiko_jacobi_epsilon_by_real64.inc'
end module furiko_jacobi_epsilon_sp


#ifdef FURIKO_REAL128
module furiko_jacobi_epsilon_qp
   use, intrinsic :: iso_fortran_env, only : wp => real128
   use furiko_forms, only : by_k, by_m, by_mc
   use furiko_modulus_qp, only : modulus, modulus_from_k, modulus_from_m, modulus_from_mc
   implicit none
   private
   include 'furiko_jacobi_epsilon.inc'
   include 'furiko_jacobi_epsilon_modulus.inc'
end module furiko_jacobi_epsilon_qp
#endif


! allow(C121)
module furiko_jacobi_epsilon
   use furiko_jacobi_epsilon_sp
   use furiko_jacobi_epsilon_dp
#ifdef FURIKO_REAL128
   use furiko_jacobi_epsilon_qp
#endif
   implicit none
   public
   private :: epsilon_of
end module furiko_jacobi_epsilon
! rooms: 1000368413
