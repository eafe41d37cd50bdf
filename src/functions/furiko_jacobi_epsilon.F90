! SPDX-License-Identifier: MIT
#include "../arithmetic/furiko_compiler.inc"

!> Jacobi's epsilon, in each kind of real; the text is in furiko_jacobi_epsilon.inc.
module furiko_jacobi_epsilon_sp
   use, intrinsic :: iso_fortran_env, only : wp => real32
   use furiko_modulus_sp, only : modulus, modulus_from_k, modulus_from_m, modulus_from_mc
   implicit none
   private
   include 'furiko_jacobi_epsilon.inc'
end module furiko_jacobi_epsilon_sp


module furiko_jacobi_epsilon_dp
   use, intrinsic :: iso_fortran_env, only : wp => real64
   use furiko_modulus_dp, only : modulus, modulus_from_k, modulus_from_m, modulus_from_mc
   implicit none
   private
   include 'furiko_jacobi_epsilon.inc'
end module furiko_jacobi_epsilon_dp


#ifdef FURIKO_REAL128
module furiko_jacobi_epsilon_qp
   use, intrinsic :: iso_fortran_env, only : wp => real128
   use furiko_modulus_qp, only : modulus, modulus_from_k, modulus_from_m, modulus_from_mc
   implicit none
   private
   include 'furiko_jacobi_epsilon.inc'
end module furiko_jacobi_epsilon_qp
#endif


module furiko_jacobi_epsilon
   use furiko_jacobi_epsilon_sp, only : jacobi_epsilon_k, jacobi_epsilon_m, jacobi_epsilon_mc
   use furiko_jacobi_epsilon_dp, only : jacobi_epsilon_k, jacobi_epsilon_m, jacobi_epsilon_mc
#ifdef FURIKO_REAL128
   use furiko_jacobi_epsilon_qp, only : jacobi_epsilon_k, jacobi_epsilon_m, jacobi_epsilon_mc
#endif
   implicit none
   private
   public :: jacobi_epsilon_k, jacobi_epsilon_m, jacobi_epsilon_mc
end module furiko_jacobi_epsilon
! rooms: 2400436689
